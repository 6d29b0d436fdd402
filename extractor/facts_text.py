"""The facts of a workspace as one text: for people to read, edit and compare, and for rules to be tried on without a parse.

A line that begins with a tab is a row, its cells separated by tabs, of the relation that the last line without one names. Other lines are
`root`, `source` (a hash of its content, its path), `component` (package, name, kind, sources) and `diagnostic`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, Protocol

from rosarch.base.cache import rows_digest
from rosarch.base.diagnostics import Diagnostic, why
from rosarch.base.files import file_name, path_text
from rosarch.base.hints import hint
from rosarch.datalog import RelationDecl
from rosarch.datalog.files.cells import read_number, show_cell
from rosarch.datalog.language.domain import domain
from rosarch.extractor.facts import schema, validate
from rosarch.extractor.manifest import ManifestError, content_hash, require_unchanged
from rosarch.extractor.stored_facts import FIRST, Facts, StoredFacts

Row = tuple[Any, ...]

_NUMBERS = domain(32)
_PLACE = re.compile("[0-9]{1,9}")


class Written(Protocol):
    """The facts of a component to be written."""

    @property
    def package(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def sources(self) -> tuple[str, ...]: ...
    def rows(self) -> Mapping[str, Iterable[tuple[str | int, ...]]]: ...


def facts_text(root: Path, components: Iterable[Written], diagnostics: Iterable[Diagnostic], beside: Path) -> str:
    """A text, to lie in the folder `beside`, that is the same wherever both folders are, and whatever else is there."""
    found = [(component, component.rows()) for component in components]
    sources = sorted({str(path) for _, rows in found for _, path in rows.get("source_file", ())})
    lines = [FIRST, f"root\t{path_text(os.path.relpath(root, beside))}"]
    lines += [_line("source", content_hash(root / source), source) for source in sources]
    for each in diagnostics:
        path = each.path.relative_to(root) if each.path.is_relative_to(root) else each.path
        lines.append(_line("diagnostic", each.kind, path_text(path), each.line, each.column, each.message))
    for component, rows in found:
        lines += ["", _line("component", component.package, component.name, component.kind, *component.sources)]
        lines += _relations(rows)
    return "".join(f"{line}\n" for line in lines)


def _relations(rows: Mapping[str, Iterable[tuple[str | int, ...]]]) -> Iterator[str]:
    validate(rows)
    for name, relation in schema().items():
        if ordered := sorted(rows.get(name, ())):
            yield _heading(relation)
            yield from (_line("", *row) for row in ordered)


def _line(*cells: str | int) -> str:
    return "\t".join(map(show_cell, cells))


def _heading(relation: RelationDecl) -> str:
    return f"{relation.name}({', '.join(attribute.name for attribute in relation.attributes)})"


def read_facts_text(path: Path) -> StoredFacts:
    """Read and check a text of facts.

    Raises `ManifestError` with the place of a line that is none of a text of facts or not of this schema, and when a source that is still
    there has changed.
    """
    try:
        content = path.read_bytes().decode("utf-8", "surrogateescape")
    except OSError as error:
        raise ManifestError(f"{path}: cannot be read ({why(error)})") from None
    reader = _Reader(path)
    reader.read(content.split("\n"))
    require_unchanged(reader.root, reader.hashes)
    components = tuple(
        Facts(name, package, kind, tuple(sources), rows_digest(rows), partial(dict, rows))
        for (package, name, kind, *sources), rows in reader.components
    )
    return StoredFacts(reader.root, components, tuple(reader.diagnostics))


class _Reader:
    """Goes through the lines of a text."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.root = path.parent
        self.hashes: dict[str, str] = {}
        self.diagnostics: list[Diagnostic] = []
        self.components: list[tuple[list[str], dict[str, list[Row]]]] = []
        self._number = 0
        self._relation: RelationDecl | None = None
        self._rows: list[Row] = []
        self._symbols: dict[str, str] = {}  # equal symbols are one object, which makes joins faster
        self._heads: Mapping[str, tuple[range, Callable[[list[str]], None]]] = {
            "root": (range(1, 2), self._root),
            "source": (range(2, 3), self._source),
            "diagnostic": (range(5, 6), self._diagnostic),
            "component": (range(3, 1 << 30), self._component),
        }

    def read(self, lines: Iterable[str]) -> None:
        for self._number, text in enumerate(lines, 1):
            line = text.removesuffix("\r")
            if line.startswith("\t"):
                self._row(line.split("\t")[1:])
            elif line and self._number > 1:
                self._head(*line.split("\t"))

    def _refusal(self, message: str, column: int = 1) -> ManifestError:
        return ManifestError(f"{self.path}:{self._number}:{column}: {message}")

    def _row(self, cells: Sequence[str]) -> None:
        if self._relation is None:
            raise self._refusal("a row of no relation")
        attributes = self._relation.attributes
        if len(cells) != len(attributes):
            raise self._refusal(f"expected {len(attributes)} cell{'s' * (len(attributes) != 1)}, found {len(cells)}", 2)
        values: list[str | int] = []
        for cell, attribute in zip(cells, attributes, strict=True):
            try:
                values.append(read_number(cell, _NUMBERS) if attribute.base == "number" else self._symbols.setdefault(cell, cell))
            except ValueError:
                column = 2 + sum(len(before) + 1 for before in cells[: len(values)])
                raise self._refusal(f"`{attribute.name}` is a number, not `{cell[:40]}`", column) from None
        self._rows.append(tuple(values))

    def _head(self, word: str, *cells: str) -> None:
        if word in self._heads:
            allowed, read = self._heads[word]
            if len(cells) not in allowed:
                raise self._refusal(f"`{word}` needs {allowed.start} cell{'s' * (allowed.start != 1)}, found {len(cells)}")
            read(list(cells))
            return
        name = word.partition("(")[0]
        relation = schema().get(name)
        if relation is None:
            raise self._refusal(f"no relation `{name}` is extracted{hint(name, [*schema(), *self._heads])}")
        if cells or word != _heading(relation):
            raise self._refusal(f"the schema has `{_heading(relation)}`; extract the facts again")
        if not self.components:
            raise self._refusal("facts of no component")
        self._relation, self._rows = relation, self.components[-1][1].setdefault(name, [])

    def _root(self, cells: list[str]) -> None:
        self.root = Path(os.path.normpath(self.path.parent / cells[0]))

    def _source(self, cells: list[str]) -> None:
        if os.path.isabs(cells[1]) or ".." in Path(cells[1]).parts:
            raise self._refusal("a source that is not below the root", len("source") + len(cells[0]) + 3)
        self.hashes[cells[1]] = cells[0]

    def _diagnostic(self, cells: list[str]) -> None:
        kind, path, line, column, message = cells
        if not (_PLACE.fullmatch(line) and _PLACE.fullmatch(column)):
            raise self._refusal("the line and the column of a `diagnostic` are numbers")
        self.diagnostics.append(Diagnostic(kind, self.root / path, int(line), int(column), message))

    def _component(self, cells: list[str]) -> None:
        if wrong := next((name for name in cells[:2] if name != file_name(name)), None):
            raise self._refusal(f"`{wrong}` is no name of a package or component")
        self._relation = None
        self.components.append((cells, {}))
