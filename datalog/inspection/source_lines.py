"""The source lines that rows are about, for programs that say where their entities are.

A program does so by the relations `location(node, file, line, column)` and, where `file` is not a path itself,
`source_file(file, path)`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any

from rosarch.datalog.inspection.rows import Row, RowStore

if TYPE_CHECKING:
    from rosarch.datalog.program import Program

LOCATION, SOURCE_FILE = "location", "source_file"


class SourceLines:
    """Looks up the places of nodes; `read` gives the text of a file, or None."""

    def __init__(self, program: Program, store: RowStore, read: Callable[[str], str | None]) -> None:
        self.places: dict[Any, tuple[Any, int, int]] = {}
        self.paths: dict[Any, str] = {}
        self.read = read
        self.texts: dict[str, list[str]] = {}
        relations = program.relations
        if LOCATION in relations and [a.base for a in relations[LOCATION].attributes[2:]] == ["number", "number"]:
            self.places = {row[0]: row[1:] for row in store.rows(LOCATION)}
        if SOURCE_FILE in relations and len(relations[SOURCE_FILE].attributes) == 2:
            self.paths = {file: str(path) for file, path in store.rows(SOURCE_FILE)}

    def of(self, rows: Iterable[Row]) -> list[str]:
        """`path:line: text` of the first value of each row that has a place, sorted by place."""
        places = {place for row in rows if (place := self.place(row))}
        return [self.line(*place) for place in sorted(places)]

    def place(self, row: Row) -> tuple[str, int] | None:
        """The path and line of the first value of a row that has a place."""
        found = next((self.places[value] for value in _plain(row) if value in self.places), None)
        return (self.paths.get(found[0], str(found[0])), found[1]) if found else None

    def line(self, path: str, line: int) -> str:
        """One line of a source; only its place when the file cannot be read."""
        if path not in self.texts:
            text = self.read(path)
            self.texts[path] = [] if text is None else text.splitlines()
        lines = self.texts[path]
        return f"{path}:{line}: {lines[line - 1].strip()}" if 0 < line <= len(lines) else f"{path}:{line}"


def _plain(values: Row) -> Iterator[Any]:
    """The symbols of a row, those in records too."""
    for value in values:
        if isinstance(value, tuple):
            yield from _plain(value)
        elif isinstance(value, str):
            yield value
