"""Text of one file to syntax tree; syntax errors with their place and what was expected."""

from __future__ import annotations

import io
import pickle
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import lark
from lark import Lark, Token
from lark.exceptions import UnexpectedCharacters, UnexpectedEOF, UnexpectedInput, UnexpectedToken

from rosarch.datalog import cache as entries
from rosarch.datalog.language.errors import Location, Report
from rosarch.datalog.language.preprocess import LINE_MARK, Origins
from rosarch.datalog.language.tree import Item, TreeBuilder

MAX_SYNTAX_ERRORS = 10


@cache
def _parser() -> tuple[Lark, TreeBuilder, list[Token]]:
    """The LALR parser of the process, its transformer, and the list its doc comments are appended to."""
    docs: list[Token] = []

    def keep(token: Token) -> Token:
        docs.append(token)
        return token

    builder = TreeBuilder()
    return _lark({"transformer": builder, "lexer_callbacks": {"DOC": keep}}), builder, docs


def _lark(actions: dict[str, Any]) -> Lark:
    """The parser; its tables are made once. Lark's own cache would take damaged tables for those of another language."""
    path = Path(__file__).with_name("grammar.lark")
    version = f"tables of lark {lark.__version__}"
    kept = entries.load([path], version)
    if kept is not None:
        loaded: Lark = Lark._load_from_dict(**pickle.loads(kept), **actions)  # type: ignore[no-untyped-call]
        return loaded
    made = Lark(path.read_text(encoding="utf-8"), parser="lalr", lexer="basic", maybe_placeholders=True, **actions)
    tables = io.BytesIO()
    made.save(tables, exclude_options=actions)
    entries.store([path], version, {str(path): entries.digest(str(path))}, tables.getvalue())
    return made


class _DocLookup(dict[int, str]):
    """Line number to the text of the `///` block that ends there; filled while the lexer runs ahead."""

    def __init__(self, tokens: list[Token]) -> None:
        super().__init__()
        self._tokens = tokens

    def get(self, line: int, default: str = "") -> str:  # type: ignore[override]
        text: list[str] = []
        for token in reversed(self._tokens):
            if token.line == line - len(text):
                text.append(token.value.lstrip("/").strip())
            elif (token.line or 0) < line - len(text):
                break
        return "\n".join(reversed(text)).strip() if text else default


def parse_text(text: str, path: str, report: Report, texts: dict[str, str] | None = None) -> list[Item]:
    """The items of one file. Syntax errors are recorded and the item they are in is skipped.

    A text with `#line` marks is one that the preprocessor has expanded; `texts` are the files as written.
    """
    parser, builder, docs = _parser()
    builder.origins = Origins(text, path, texts or {}) if "#line " in text and LINE_MARK.search(text) else None
    for _ in range(MAX_SYNTAX_ERRORS):
        docs.clear()
        builder.path, builder.report, builder.docs = path, report, _DocLookup(docs)
        try:
            items: Any = parser.parse(text)
            return list(items)
        except UnexpectedInput as error:
            position = _record(error, text, builder.at, report)
            text = _without_item(text, position)
    return []


def is_word(name: str) -> bool:
    """Whether a name is one of the language's own words, which no relation can have."""
    report = Report({})
    parse_text(f".decl {name}()\n{name}() :- {name}().\n", "", report)
    return bool(report.errors)


def tokens(text: str) -> tuple[list[Token], list[Token]]:
    """The tokens of a text, and its `///` lines; characters that begin no token are left out."""
    parser, _, docs = _parser()
    while True:
        docs.clear()
        try:
            return list(parser.lex(text)), list(docs)
        except UnexpectedCharacters as error:
            at = error.pos_in_stream or 0
            text = f"{text[:at]} {text[at + 1 :]}"


# A line on which, by the usual layout, a new item starts.
_ITEM_START = re.compile(r"^(?=\.[a-z_]+\s|[A-Za-z_?]|///)", re.MULTILINE)


def _without_item(text: str, position: int) -> str:
    """The text with the item around `position` blanked out, line breaks kept."""
    starts = [m.start() for m in _ITEM_START.finditer(text)]
    begin = max((s for s in starts if s <= position), default=0)
    end = min((s for s in starts if s > position), default=len(text))
    return text[:begin] + re.sub(r"[^\n]", " ", text[begin:end]) + text[end:]


_TOKEN_NAMES = {
    "IDENT": "an identifier", "STRING": "a string", "NUMBER": "a number", "FLOAT": "a float", "UNSIGNED": "an unsigned",
    "DOT": "`.`", "COMMA": "`,`", "RPAR": "`)`", "LPAR": "`(`", "COLON": "`:`", "SEMICOLON": "`;`", "RSQB": "`]`",
    "RBRACE": "`}`", "LBRACE": "`{`", "EQ": "`=`", "LT": "`<`", "GT": "`>`", "LSQB": "`[`", "VBAR": "`|`", "__ANON_0": "`<:`",
}  # fmt: skip
_SHOWN = ["DOT", "COMMA", "RPAR", "LPAR", "COLON", "RSQB", "RBRACE", "LBRACE", "EQ", "IDENT"]


def _expected(names: set[str]) -> str:
    """What could have come instead, when that is short enough to help."""
    if ":-" in names or any(n.startswith("__ANON") for n in names):
        names = {n for n in names if not n.startswith("__ANON")} | {"IF"}
    shown = [_TOKEN_NAMES[n] for n in _SHOWN if n in names]
    return f"expected {' or '.join(shown[:3])}" if shown and len(shown) <= 3 else ""


def _record(error: UnexpectedInput, text: str, at_line: Callable[[int, int], Location], report: Report) -> int:
    """Report a syntax error; returns its offset in the text."""
    if isinstance(error, UnexpectedToken) and error.token.type != "$END":
        token = error.token
        value = token.value if len(token.value) <= 40 else token.value[:37] + "..."
        at = at_line(token.line or 1, token.column or 1)
        report.error(f"syntax error, unexpected `{value}`", at, _expected(set(error.accepts or error.expected)))
        return token.start_pos or 0
    if isinstance(error, UnexpectedCharacters):
        at = at_line(error.line, error.column)
        offset = error.pos_in_stream or 0
        rest = text[offset : offset + 2]
        unterminated = {'"': "unterminated string", "/*": "unterminated comment, missing `*/`"}
        message = unterminated.get(rest, unterminated.get(rest[:1], f"syntax error, unexpected `{rest[:1]}`"))
        report.error(message, at)
        return offset
    assert isinstance(error, (UnexpectedToken, UnexpectedEOF))
    stripped = text.rstrip()
    line = stripped.count("\n") + 1
    at = at_line(line, len(stripped) - (stripped.rfind("\n") + 1) + 1)
    report.error("syntax error, unexpected end of file", at, _expected(set(getattr(error, "expected", ()))))
    return max(len(stripped) - 1, 0)
