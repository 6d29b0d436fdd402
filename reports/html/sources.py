"""The source lines that a report leads to, with some around them: the report is read where the sources may not be."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import lru_cache
from typing import Any

from rosarch.base.places import Place
from rosarch.reports.excerpts import shown, token_span

AROUND = 3
WIDEST = 240
"""Characters of a line."""
_PLACE = re.compile(r"(.+):([1-9][0-9]*)", re.DOTALL)
_PLACES = frozenset({"at", "sent_at", "timed_by", "lines", "places"})
"""The fields of the document that hold places."""


def places_in(data: Any) -> Iterator[tuple[str, int]]:
    """Path and line of all places in a document."""
    if isinstance(data, Mapping):
        for field, value in data.items():
            if field in _PLACES:
                yield from _parsed(value)
            else:
                yield from places_in(value)
    elif isinstance(data, list):
        for value in data:
            yield from places_in(value)


def _parsed(value: Any) -> Iterator[tuple[str, int]]:
    for text in value if isinstance(value, list) else [value]:
        if isinstance(text, str) and (match := _PLACE.fullmatch(text)):
            yield match[1], int(match[2])


def excerpts(places: Iterable[tuple[str, int]], read: Callable[[str], str | None]) -> dict[str, list[Any]]:
    """By file: runs of lines as pairs of the first line's number and the texts; files that cannot be read are left out."""
    wanted: dict[str, set[int]] = defaultdict(set)
    for path, line in places:
        wanted[path].update(range(max(1, line - AROUND), line + AROUND + 1))
    found = {}
    for path, numbers in sorted(wanted.items()):
        text = read(path)
        if text is not None:
            lines = text.split("\n")
            found[path] = _runs(lines, sorted(number for number in numbers if number <= len(lines)))
    return found


def _runs(lines: list[str], numbers: list[int]) -> list[Any]:
    runs: list[Any] = []
    for number in numbers:
        if not runs or runs[-1][0] + len(runs[-1][1]) != number:
            runs.append([number, []])
        runs[-1][1].append(cut(lines[number - 1]))
    return runs


def cut(line: str) -> str:
    """A line as it is shown."""
    line = shown(line.rstrip())
    return line if len(line) <= WIDEST else line[: WIDEST - 1] + "…"


class Marks:
    """Says where in a line, as `cut` shows it, the token of a place is; `read` gives the text of a file, or None."""

    def __init__(self, read: Callable[[str], str | None]) -> None:
        self._read = lru_cache(maxsize=64)(lambda path: (read(path) or "").split("\n"))

    def at(self, place: Place) -> list[int] | None:
        """Begin and end; None when there is no such token to be seen."""
        lines = self._read(place.path)
        if not 0 < place.line <= len(lines) or place.column < 1:
            return None
        line = lines[place.line - 1].rstrip()
        start, end = token_span(line, place.column)
        first = len(shown(line[:start]))
        last = first + len(shown(line[start:end]))
        return [first, last] if first < last < WIDEST else None
