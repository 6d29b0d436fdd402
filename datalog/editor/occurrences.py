"""The names in a rule file, by its tokens: where each stands, what kind of thing it names, whether it is declared there.

A file that is being edited is seldom well-formed, so no syntax tree is asked for. The shapes are those of grammar.lark.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from lark import Token

from rosarch.datalog.language.parser import tokens

Kind: TypeAlias = Literal["relation", "type", "functor", "branch", "component", "instance", "attribute", "variable", "file"]


@dataclass(frozen=True, slots=True)
class Occurrence:
    """A name at a place; `line` and `column` count from 1.

    `item` numbers the declarations and clauses of the file: variables and attributes belong to one. `qualifier` is what stands before the
    last dot. `argument` is the relation and the position, from 0, that a variable is an argument of.
    """

    name: str
    kind: Kind
    line: int
    column: int
    item: int
    is_declaration: bool = False
    qualifier: str = ""
    argument: tuple[str, int] | None = None

    @property
    def end(self) -> int:
        """The column after the name."""
        return self.column + len(self.name)


@dataclass(frozen=True, slots=True)
class Declared:
    """A relation, record or branch with its attributes, as `name: type` in the text."""

    name: str
    attributes: tuple[tuple[str, str], ...]
    line: int


@dataclass(slots=True)
class Names:
    """What a text holds: occurrences in order, relations by name, and the doc comments by the line after each."""

    occurrences: list[Occurrence] = field(default_factory=list)
    relations: dict[str, Declared] = field(default_factory=dict)
    docs: dict[int, str] = field(default_factory=dict)


def names_of(text: str) -> Names:
    """Everything named in a text."""
    found, docs = tokens(text)
    reader = _Reader(found)
    reader.read()
    reader.names.docs = _blocks(docs)
    return reader.names


def _blocks(docs: Sequence[Token]) -> dict[int, str]:
    """Runs of `///` lines, by the line that follows each."""
    blocks: dict[int, str] = {}
    for token in docs:
        line = token.line or 0
        text = token.value.lstrip("/").strip()
        before = blocks.pop(line, None)
        blocks[line + 1] = text if before is None else f"{before}\n{text}"
    return blocks


_STARTS = frozenset(
    ("DECL", "TYPE", "NUMBER_TYPE", "SYMBOL_TYPE", "DIRECTIVE", "FUNCTOR", "PRAGMA", "INCLUDE", "ONCE", "COMP", "INIT", "OVERRIDE")
)
_CONTINUES = frozenset([":-", ",", ";", "!", "=", "("])
_CAST = "as"
_OPEN, _CLOSE = frozenset("([{"), frozenset(")]}")


class _Reader:
    def __init__(self, found: Sequence[Token]) -> None:
        self.tokens = found
        self.at = 0
        self.item = 0
        self.names = Names()

    # -- tokens -------------------------------------------------------------------------------

    def value(self, ahead: int = 0) -> str:
        place = self.at + ahead
        return str(self.tokens[place]) if 0 <= place < len(self.tokens) else ""

    def type(self, ahead: int = 0) -> str:
        place = self.at + ahead
        return self.tokens[place].type if 0 <= place < len(self.tokens) else ""

    def adjacent(self, place: int) -> bool:
        """Whether nothing stands between a token and the one before it."""
        return 0 < place < len(self.tokens) and self.tokens[place - 1].end_pos == self.tokens[place].start_pos

    def starts_item(self) -> bool:
        """Whether a new item starts here, by its keyword or, after an unfinished one, by the usual layout."""
        token = self.tokens[self.at]
        return token.type in _STARTS or (token.type == "IDENT" and token.column == 1 and self.value(-1) not in _CONTINUES)

    def add(
        self, token: Token, kind: Kind, *, declared: bool = False, qualifier: str = "", argument: tuple[str, int] | None = None
    ) -> None:
        occurrence = Occurrence(str(token), kind, token.line or 1, token.column or 1, self.item, declared, qualifier, argument)
        self.names.occurrences.append(occurrence)

    def name(self, kind: Kind, *, declared: bool = False, argument: tuple[str, int] | None = None) -> str:
        """Read a name with its qualifiers, if one stands here."""
        if self.type() != "IDENT":
            return ""
        parts = [self.tokens[self.at]]
        while self.value(1) == "." and self.type(2) == "IDENT" and self.adjacent(self.at + 1) and self.adjacent(self.at + 2):
            self.at += 2
            parts.append(self.tokens[self.at])
        for part in parts[:-1]:
            self.add(part, "instance")
        qualifier = ".".join(str(p) for p in parts[:-1])
        self.add(parts[-1], kind, declared=declared, qualifier=qualifier, argument=argument)
        self.at += 1
        return ".".join(str(p) for p in parts)

    def listed(self, kind: Kind, *, declared: bool = False) -> list[tuple[str, int]]:
        """Read names between commas; each with its line."""
        found = []
        while self.type() == "IDENT":
            line = self.tokens[self.at].line or 1
            found.append((self.name(kind, declared=declared), line))
            if self.value() != ",":
                break
            self.at += 1
        return found

    # -- items --------------------------------------------------------------------------------

    def read(self) -> None:
        """Read the whole text."""
        while self.at < len(self.tokens):
            self.item += 1
            start = self.at
            match self.type():
                case "DECL":
                    self._relation()
                case "TYPE" | "NUMBER_TYPE" | "SYMBOL_TYPE":
                    self._type()
                case "DIRECTIVE" | "OVERRIDE":
                    self.at += 1
                    self.listed("relation")
                    self._skip_parameters()
                case "FUNCTOR":
                    self._functor()
                case "INCLUDE":
                    self.at += 1
                    if self.type() == "STRING":
                        self.add(self.tokens[self.at], "file")
                        self.at += 1
                case "COMP":
                    self._component()
                case "INIT":
                    self.at += 1
                    self.name("instance", declared=True)
                    if self.value() == "=":
                        self.at += 1
                        self._component_type()
                case "IDENT":
                    self._clause()
                case _:
                    self.at += 1
            if self.at == start:
                self.at += 1

    def _fields(self, closing: str) -> tuple[tuple[str, str], ...]:
        """Read `name: type, ...` up to a bracket."""
        self.at += 1
        found = []
        while self.at < len(self.tokens) and self.value() != closing and not self.starts_item():
            if self.type() == "IDENT" and self.value(1) == ":":
                name = self.value()
                self.name("attribute", declared=True)
                self.at += 1
                found.append((name, self.name("type")))
            else:
                self.at += 1
        self.at += self.value() == closing
        return tuple(found)

    def _relation(self) -> None:
        self.at += 1
        declared = self.listed("relation", declared=True)
        attributes = self._fields(")") if self.value() == "(" else ()
        for name, line in declared:
            self.names.relations.setdefault(name, Declared(name, attributes, line))
        while self.at < len(self.tokens) and self.type() == "QUALIFIER":
            self.at += 1
        if self.value() == "choice-domain":  # its keys are attributes
            self.at += 1
            while self.at < len(self.tokens) and not self.starts_item():
                if self.type() == "IDENT":
                    self.name("attribute")
                else:
                    self.at += 1

    def _type(self) -> None:
        self.at += 1
        self.name("type", declared=True)
        while self.at < len(self.tokens) and not self.starts_item() and self.value() != "}":
            if self.type() == "IDENT" and self.value(1) == "{":
                self.name("branch", declared=True)
                self._fields("}")
            elif self.value() == "[":
                self._fields("]")
            elif self.type() == "IDENT":
                self.name("type")
            else:
                self.at += 1

    def _functor(self) -> None:
        self.at += 1
        self.name("functor", declared=True)
        while self.at < len(self.tokens) and not self.starts_item():
            if self.type() == "IDENT" and self.value(1) == ":":
                self.at += 1
            elif self.type() == "IDENT":
                self.name("type")
            else:
                self.at += 1

    def _component_type(self) -> None:
        self.name("component")
        if self.value() == "<":
            self.at += 1
            self.listed("type")
            self.at += self.value() == ">"

    def _component(self) -> None:
        self.at += 1
        self.name("component", declared=True)
        while self.at < len(self.tokens) and self.value() != "{" and not self.starts_item():
            if self.type() == "IDENT" and self.value(-1) in (":", ","):
                self._component_type()
            else:
                self.at += 1
        self.at += self.value() == "{"  # what is inside are items like others

    def _skip_parameters(self) -> None:
        if self.value() == "(":
            while self.at < len(self.tokens) and self.value() != ")" and not self.starts_item():
                self.at += 1
            self.at += self.value() == ")"

    def _clause(self) -> None:
        """Read a clause: names before a bracket are relations, others variables."""
        stack: list[tuple[str, str, int]] = []  # brackets around: what stands before, the bracket, how many arguments there were
        first = self.at
        while self.at < len(self.tokens):
            value = self.value()
            if self.at > first and self.starts_item():
                return
            if value == "." and not stack:
                self.at += 1
                return
            if self.type() == "IDENT":
                self._name_in_clause(stack)
                continue
            if value in _OPEN:
                stack.append((self._callee() if value == "(" else "", value, 0))
            elif value in _CLOSE:
                if not stack and value == "}":
                    return  # the end of a component
                del stack[-1:]
            elif value == "," and stack:
                stack[-1] = (*stack[-1][:2], stack[-1][2] + 1)
            self.at += 1

    def _callee(self) -> str:
        """`as`, where that stands before an opening bracket: a type comes last in it."""
        return _CAST if self.type(-1) == "AS" else ""

    def _name_in_clause(self, stack: list[tuple[str, str, int]]) -> None:
        before = self.value(-1)
        if before == "@":
            self.name("functor")
        elif before == "$":
            self.name("branch")
        elif before == "," and self.value(1) == ")" and stack and stack[-1][0] == _CAST:
            self.name("type")
        elif self._before_bracket():
            name = self.name("relation")
            stack.append((name, "(", 0))
            self.at += 1
        else:
            top = stack[-1] if stack else ("", "", 0)
            whole = before in ("(", ",") and self.value(1) in (",", ")")
            self.name("variable", argument=(top[0], top[2]) if top[0] not in ("", _CAST) and whole else None)

    def _before_bracket(self) -> bool:
        place = self.at + 1
        while (
            place + 1 < len(self.tokens) and self.tokens[place] == "." and self.tokens[place + 1].type == "IDENT" and self.adjacent(place)
        ):
            place += 2
        return place < len(self.tokens) and self.tokens[place] == "("


@dataclass(frozen=True, slots=True)
class Call:
    """The relation whose arguments stand around a place, and which argument it is, from 0."""

    relation: str
    argument: int


def call_around(text: str, line: int, column: int) -> Call | None:
    """The atom around a place in a clause."""
    found, _ = tokens(text)
    stack: list[Call | None] = []
    before: Token | None = None
    for place, token in enumerate(found):
        if (token.line or 0, token.column or 0) >= (line, column):
            break
        value = str(token)
        if token.type in _STARTS or (value == "." and not stack):
            stack.clear()
        elif value in _OPEN:
            atom = value == "(" and before is not None and before.type == "IDENT" and (place < 2 or found[place - 2] not in ("@", "$"))
            stack.append(Call(str(before), 0) if atom else None)
        elif value in _CLOSE:
            del stack[-1:]
        elif value == "," and stack and stack[-1]:
            stack[-1] = Call(stack[-1].relation, stack[-1].argument + 1)
        before = token
    return next((c for c in reversed(stack) if c), None)
