"""Source lines as reports show them: printable, cut to size, with what is meant marked."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from rich.cells import cell_len

from rosarch.base.places import Place
from rosarch.reports.printable import printable

WIDEST = 160  # characters of a source line
_TAB = 4
_TOKEN = re.compile(r"\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])*'|</?[\w:.-]+|[\w$~/](?:->|[\w$~/.:-])*(?<![.:-])|\S")


@dataclass(frozen=True)
class Excerpt:
    """A source line; `before` and `marked` are columns of a terminal: how far the mark is indented, how wide it is."""

    text: str
    before: int
    marked: int

    @property
    def underline(self) -> str:
        """What stands below the line: `   ^~~~`."""
        return f"{' ' * self.before}^{'~' * (self.marked - 1)}"


class Excerpts:
    """Looks up source lines; `read` gives the text of a file, or None."""

    def __init__(self, read: Callable[[str], str | None]) -> None:
        self._read = read
        self._lines: dict[str, list[str]] = {}

    def at(self, place: Place) -> Excerpt | None:
        """The line of a place; None when it cannot be read or is empty."""
        if place.path not in self._lines:
            text = self._read(place.path)
            self._lines[place.path] = [] if text is None else text.split("\n")
        lines = self._lines[place.path]
        if not 0 < place.line <= len(lines) or not lines[place.line - 1].strip():
            return None
        return _excerpt(lines[place.line - 1].rstrip(), place.column)


def _excerpt(line: str, column: int) -> Excerpt:
    """The line with the token at `column` marked; all of it when no token is there."""
    start, end = token_span(line, column)
    first = max(0, min(start - WIDEST // 3, len(line) - WIDEST)) if len(line) > WIDEST else 0
    last = first + WIDEST
    end = min(end, last)
    head, mark, tail = (shown(part) for part in (line[first:start], line[start:end], line[end:last]))
    left, right = "…" if first else "", "…" if last < len(line) else ""
    return Excerpt(f"{left}{head}{mark}{tail}{right}", cell_len(left + head), max(1, cell_len(mark)))


def token_span(line: str, column: int) -> tuple[int, int]:
    """Where the token at `column` begins and ends; of the whole line when no token is there."""
    start = column - 1
    indent = len(line) - len(line.lstrip())
    token = _TOKEN.match(line, start) if indent <= start < len(line) else None
    return token.span() if token else (indent, len(line))


def shown(text: str) -> str:
    """A part of a source line as it is shown."""
    return printable(text.replace("\t", " " * _TAB))
