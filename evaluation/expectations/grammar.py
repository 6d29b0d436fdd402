"""What expectations say. `docs/expectations.md` has the grammar.

publisher /cmd_vel geometry_msgs/Twist queue=10 latched
reactive /scan -> /cmd_vel must
transition Docking::state_ = State::DOCKED on /contact if "bumper.pressed"
finding topic-type-mismatch
port_type([_, "publisher", Name], "std_msgs/String"), !match("/.*", Name)
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from rosarch.base.hints import hint
from rosarch.evaluation.expectations.comments import Marked
from rosarch.evaluation.expectations.elements import ANY, FINDING, Kind, kinds

_TOKEN = re.compile(r'(?:[^\s"]|"(?:\\.|[^"\\])*"?)+')
_FIELD = re.compile(r"([a-z_]+)=(?!=)(.*)", re.DOTALL)
_QUERY = re.compile(r"!?\s*[a-z_][\w.]*\s*\(|(?:[A-Z]\w*|\d+)\s*(?:!?=|[<>])")
_GUARDS = ("guard", "when", "conditional")
_TRUTH_VALUES = frozenset({"must", "latched", "implicit"})
_NUMBERS = frozenset({"queue", "hz", "after"})
_UNITS = {"hz": "Hz", "after": "s"}
_QUOTED = re.compile(r'"(?:\\.|[^"\\])*"')
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


class ExpectationError(Exception):
    """An expectation that is not understood: `path:line:col: message`."""


@dataclass(frozen=True)
class Expectation:
    """An element of `kind` with attributes as in `wanted`, or, without a kind, a row for a `query`.

    With `here`, the element is in one of the lines that the comment is about.
    """

    marked: Marked
    kind: Kind | None
    wanted: tuple[tuple[str, str], ...] = ()
    query: str = ""
    here: bool = False


def parse(marked: Marked) -> Expectation:
    """The meaning of an expectation.

    Raises:
        ExpectationError: it has none.
    """
    if _QUERY.match(marked.text):
        if marked.sense == "only" and not marked.beside:
            told = "of rows, expect how many there are, `N = count : { ... }, N = 2`, or behind code that they lie there"
            raise ExpectationError(f"{marked.path}:{marked.line}:{marked.text_column}: {told}")
        return Expectation(marked, None, query=marked.text, here=marked.sense == "only")
    return _Parser(marked).expectation()


@dataclass(frozen=True)
class _Word:
    text: str
    column: int


class _Parser:
    """Reads the words of an expectation one by one."""

    def __init__(self, marked: Marked) -> None:
        self.marked = marked
        self.words = [_Word(match[0], marked.text_column + match.start()) for match in _TOKEN.finditer(marked.text)]
        self.wanted: dict[str, str] = {}

    def expectation(self) -> Expectation:
        if not self.words:
            raise self._error(self.marked.column, "nothing is expected here")
        name = self.words.pop(0)
        kind = ANY if name.text == ANY.name and self.marked.sense == "only" else kinds().get(name.text)
        if kind is None:
            raise self._error(name.column, f"unknown kind of element `{name.text}`{_name_hint(name.text, kinds())}")
        self._subject(kind)
        while self.words:
            self._attribute(kind, self.words.pop(0))
        return Expectation(self.marked, kind, tuple(self.wanted.items()), here=self.marked.beside or kind.name == FINDING)

    def _subject(self, kind: Kind) -> None:
        """`NAME`, `INPUT -> OUTPUT`, `NAME = VALUE`, `NAME TYPE`; without a name, any will do."""
        for number, part in enumerate(kind.subject):
            if not self.words or (not number and self._is_attribute(kind, self.words[0])):
                if number:
                    raise self._error(self._end(), f"{kind.name} is written {_form(kind)}")
                return
            if number and self.words.pop(0).text != kind.between:
                raise self._error(self._end(), f"{kind.name} is written {_form(kind)}")
            if not self.words:
                raise self._error(self._end(), f"{kind.name} is written {_form(kind)}")
            self._give(part, self.words.pop(0))
        if kind.then is None or not self.words:
            return
        if kind.between and self.words[0].text == kind.between:
            self.words.pop(0)
            if not self.words:
                raise self._error(self._end(), f"{kind.name} is written {_form(kind)}")
            self._give(kind.then, self.words.pop(0))
        elif not kind.between and not _FIELD.fullmatch(self.words[0].text) and not self._is_attribute(kind, self.words[0]):
            self._give(kind.then, self.words.pop(0))
            if self.words and self.words[0].text == _UNITS.get(kind.then):
                self.words.pop(0)

    def _give(self, name: str, word: _Word, start: int = 0) -> None:
        """Set an attribute to the text of a word from `start` on; `10Hz` and `0.5s` are numbers."""
        column, text = word.column + start, self._value(word, start).removesuffix(_UNITS.get(name, ""))
        if name in self.wanted:
            raise self._error(column, f"`{name}` is given twice")
        if name in _NUMBERS and text and "*" not in text and not _NUMBER.fullmatch(text):
            raise self._error(column, f"`{name}` is a number, not `{text}`")
        if name in _TRUTH_VALUES and text not in ("true", "false"):
            raise self._error(column, f"`{name}` is true or false, not `{text}`")
        self.wanted[name] = text

    def _value(self, word: _Word, start: int) -> str:
        """A text without its quotes; any other has quotes only inside."""
        text = word.text[start:]
        open_ = _QUOTED.sub(lambda match: " " * len(match[0]), text).find('"')
        if open_ >= 0:
            raise self._error(word.column + start + open_, "a quote that is not closed")
        quoted = _QUOTED.match(text)
        if quoted is None:
            return text
        if quoted.end() < len(text):
            raise self._error(word.column + start + quoted.end(), f"`{text[quoted.end() :]}` right behind a quote")
        return re.sub(r"\\(.)", r"\1", text[1:-1])

    def _is_attribute(self, kind: Kind, word: _Word) -> bool:
        field = _FIELD.fullmatch(word.text)
        return (field is not None and field[1] in kind.attributes) or word.text in self._bare(kind)

    def _bare(self, kind: Kind) -> list[str]:
        """The words that are attributes by themselves, or the beginning of one."""
        found = [name for name in kind.attributes if name in _TRUTH_VALUES]
        found += ["may"] if "must" in kind.attributes else []
        found += ["on"] if "trigger" in kind.attributes else []
        return found + (["if"] if any(name in kind.attributes for name in _GUARDS) else [])

    def _attribute(self, kind: Kind, word: _Word) -> None:
        """`name=value`, a truth value by its name, `may`, `on TRIGGER`, `if CONDITION`."""
        field = _FIELD.fullmatch(word.text)
        if field is not None:
            if field[1] not in kind.attributes:
                raise self._error(word.column, f"{kind.name} has no `{field[1]}`{_name_hint(field[1], kind.attributes)}")
            self._give(field[1], word, field.start(2))
            return
        if word.text not in self._bare(kind):
            near = hint(word.text, (*self._bare(kind), *kind.attributes))
            raise self._error(word.column, f"`{word.text}` is not understood here{near}; {kind.name} is written {_form(kind)}")
        if word.text in _TRUTH_VALUES:
            self._give(word.text, _Word("true", word.column))
        elif word.text == "may":
            self._give("must", _Word("false", word.column))
        elif not self.words:
            raise self._error(word.column, f"nothing after `{word.text}`")
        else:
            name = "trigger" if word.text == "on" else next(name for name in _GUARDS if name in kind.attributes)
            self._give(name, self.words.pop(0))

    def _end(self) -> int:
        return self.marked.text_column + len(self.marked.text)

    def _error(self, column: int, message: str) -> ExpectationError:
        return ExpectationError(f"{self.marked.path}:{self.marked.line}:{column}: {message}")


def _form(kind: Kind) -> str:
    """How a kind is written: `reactive INPUT -> OUTPUT`."""
    between = f" {kind.between} " if kind.between else " "
    parts = [part.upper() for part in kind.subject]
    return f"`{kind.name} {between.join(parts)}{f'{between}{kind.then.upper()}' if kind.then else ''}`"


def _name_hint(name: str, known: Iterable[str]) -> str:
    known = list(known)
    return hint(name, known) or f", there are {', '.join(known)}"
