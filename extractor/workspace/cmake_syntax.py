"""The CMake language: text to commands, commands to blocks.

Source: cmake-language(7), https://cmake.org/cmake/help/latest/manual/cmake-language.7.html. The grammar is coarse on
purpose: an argument is one token, and references inside it are expanded by `cmake_expand` when the command runs.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from lark import Lark, Token, Transformer
from lark.exceptions import UnexpectedInput

from rosarch.base.diagnostics import Diagnostic

GRAMMAR = r"""
start: command* UNCLOSED?
command: IDENTIFIER "(" argument* ")"
?argument: BRACKET | QUOTED | UNQUOTED | UNCLOSED | group
!group: "(" argument* ")"

IDENTIFIER: /[A-Za-z_][A-Za-z0-9_]*/
BRACKET.3: /\[(?P<eq>=*)\[(?:.|\n)*?\](?P=eq)\]/
QUOTED.2: /"(?:[^"\\]|\\(?:.|\n))*"/
UNQUOTED: /(?:\$\([^\s()]*\)|[^\s()#"\\]|\\.)(?:\$\([^\s()]*\)|"(?:[^"\\]|\\(?:.|\n))*"|[^\s()#"\\]|\\.)*/

BRACKET_COMMENT.4: /#\[(?P<ceq>=*)\[(?:.|\n)*?\](?P=ceq)\]/
UNCLOSED.3: /#?\[=*\[(?:.|\n)*/
COMMENT.2: /#[^\n]*/
SPACE: /[ \t\r\n\f\ufeff]+/
%ignore BRACKET_COMMENT
%ignore COMMENT
%ignore SPACE
"""


@dataclass(frozen=True, slots=True)
class Argument:
    """One written argument; `quoted` arguments are never split into list elements, `raw` ones never expanded."""

    text: str
    line: int
    column: int
    quoted: bool = False
    raw: bool = False
    plain: bool = False


@dataclass(frozen=True, slots=True)
class Command:
    """One invocation. `name` is lower case: command names ignore case."""

    name: str
    written: str
    arguments: tuple[Argument, ...]
    line: int
    column: int


@dataclass(frozen=True, slots=True)
class Branch:
    """`if`, `elseif` (with their condition) or `else` (without), and the body."""

    condition: Command | None
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class If:
    """A whole `if` ... `endif`."""

    branches: tuple[Branch, ...]


@dataclass(frozen=True, slots=True)
class Block:
    """`foreach`, `while`, `function`, `macro` or `block` with its body."""

    opener: Command
    body: tuple[Statement, ...]


Statement = Command | If | Block


class _Build(Transformer[Token, None]):
    """Commands straight from the parser, without a tree in between: those that are whole, also when it fails behind them."""

    def __init__(self) -> None:
        super().__init__()
        self.commands: list[Command] = []
        self.unclosed: Token | None = None

    def start(self, children: list[object]) -> None:
        self.unclosed = next((child for child in children if isinstance(child, Token)), None)

    def command(self, children: list[object]) -> None:
        name, arguments = children[0], children[1:]
        assert isinstance(name, Token)
        self.commands.append(Command(name.lower(), str(name), tuple(_flatten(arguments)), name.line or 0, name.column or 0))

    def group(self, children: list[object]) -> list[object]:
        return children  # flat only as a part of its command: groups may nest deeply, and to copy each would be quadratic


def _flatten(children: list[object]) -> Iterator[Argument]:
    rest = [iter(children)]
    while rest:
        for child in rest[-1]:
            if isinstance(child, list):
                rest.append(iter(child))
                break
            assert isinstance(child, Token)
            yield _argument(child)
        else:
            rest.pop()


def _argument(token: Token) -> Argument:
    line, column = token.line or 0, token.column or 0
    if token.type in {"LPAR", "RPAR"}:
        return Argument(str(token), line, column, plain=True)
    if token.type == "UNQUOTED":
        plain = "$" not in token and "\\" not in token and ";" not in token
        return Argument(str(token), line, column, plain=plain)
    if token.type == "QUOTED":
        return Argument(token[1:-1], line, column, quoted=True)
    width = token.index("[", 1) + 1
    body = token[width:-width]
    return Argument(body.removeprefix("\n"), line, column, quoted=True, raw=True)


@lru_cache(maxsize=1)
def _parser() -> tuple[Lark, _Build]:
    build = _Build()
    return Lark(GRAMMAR, parser="lalr", lexer="contextual", transformer=build, maybe_placeholders=False), build


def parse(text: str, path: Path) -> tuple[list[Command], list[Diagnostic]]:
    """The commands of `text`. After a syntax error, those before it, and one diagnostic."""
    parser, build = _parser()
    build.commands = []
    try:
        parser.parse(text)
        return build.commands, [] if build.unclosed is None else [_unclosed(build.unclosed, path)]
    except UnexpectedInput as error:
        diagnostics, end = [_syntax_error(error, text, path)], _offset(error, text)
    if end < len(text):  # the last command before it may have waited for what follows
        build.commands = []
        with suppress(UnexpectedInput):
            parser.parse(text[:end])
    return build.commands, diagnostics


def _unclosed(token: Token, path: Path) -> Diagnostic:
    opener = token[: token.index("[", token.index("[") + 1) + 1]
    return Diagnostic("cmake-syntax", path, token.line or 0, token.column or 0, f"syntax error: `{opener}` is not closed")


def _offset(error: UnexpectedInput, text: str) -> int:
    position = getattr(error, "pos_in_stream", None)
    token = getattr(error, "token", None)
    if (token is not None and token.type == "$END") or position is None:
        return len(text)
    return int(position)


def _syntax_error(error: UnexpectedInput, text: str, path: Path) -> Diagnostic:
    token = getattr(error, "token", None)
    if token is not None and token.type == "$END":
        line, column = text.count("\n") + 1, len(text) - (text.rfind("\n") + 1) + 1
        return Diagnostic("cmake-syntax", path, line, column, "syntax error: unexpected end of file, is a `)` missing?")
    offset = _offset(error, text)
    found = str(token) if token is not None else text[offset : offset + 1]
    return Diagnostic("cmake-syntax", path, error.line, error.column, f"syntax error: unexpected `{found[:60]}`")


_OPENERS = {"foreach": "endforeach", "while": "endwhile", "function": "endfunction", "macro": "endmacro", "block": "endblock"}
_CLOSERS = {*_OPENERS.values(), "endif", "else", "elseif"}


def blocks(commands: list[Command], path: Path) -> tuple[tuple[Statement, ...], list[Diagnostic]]:
    """Nest flat commands into blocks. Blocks that are not closed end with the file; stray closers are skipped."""
    nesting = _Nesting(commands, path)
    result: list[Statement] = []
    while nesting.position < len(commands):
        result.extend(nesting.body(frozenset()))
        if nesting.position < len(commands):
            nesting.complain(commands[nesting.position], "`{}` closes nothing")
            nesting.position += 1
    return tuple(result), nesting.diagnostics


class _Nesting:
    def __init__(self, commands: list[Command], path: Path) -> None:
        self.commands = commands
        self.path = path
        self.position = 0
        self.diagnostics: list[Diagnostic] = []

    def complain(self, command: Command, message: str) -> None:
        text = message.format(command.written)
        self.diagnostics.append(Diagnostic("cmake-syntax", self.path, command.line, command.column, text))

    def body(self, closers: frozenset[str]) -> tuple[Statement, ...]:
        """Statements up to a closer, which is left for the caller."""
        result: list[Statement] = []
        while self.position < len(self.commands):
            command = self.commands[self.position]
            if command.name in closers or command.name in _CLOSERS:
                break
            self.position += 1
            if command.name == "if":
                result.append(self._if(command))
            elif command.name in _OPENERS:
                result.append(self._block(command))
            else:
                result.append(command)
        return tuple(result)

    def _block(self, opener: Command) -> Block:
        closer = _OPENERS[opener.name]
        body = self.body(frozenset({closer}))
        self._close(opener, closer)
        return Block(opener, body)

    def _if(self, opener: Command) -> If:
        branches: list[Branch] = []
        condition: Command | None = opener
        while True:
            branches.append(Branch(condition, self.body(frozenset({"elseif", "else", "endif"}))))
            if self.position < len(self.commands) and self.commands[self.position].name in ("elseif", "else"):
                command = self.commands[self.position]
                condition = command if command.name == "elseif" else None
                self.position += 1
                continue
            self._close(opener, "endif")
            return If(tuple(branches))

    def _close(self, opener: Command, closer: str) -> None:
        if self.position < len(self.commands) and self.commands[self.position].name == closer:
            self.position += 1
        else:
            self.complain(opener, "`{}` is not closed by `" + closer + "`")
