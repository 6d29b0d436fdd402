"""What is known about the translation unit in work: its files, its rows and the identifiers given out so far."""

from __future__ import annotations

import hashlib
import os
import re
from bisect import bisect_right
from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from rosarch.base.files import path_text, read_file, shown_path
from rosarch.extractor.cxx import libclang
from rosarch.extractor.cxx.includes import STAND_INS
from rosarch.extractor.cxx.libclang import MACRO_BIT, Tree
from rosarch.extractor.cxx.libclang_library import Cursor, Location, Range, Type
from rosarch.extractor.messages.parameter_library import made_from
from rosarch.extractor.underlay import NOTHING_INSTALLED, Underlay

TEXT_LIMIT = 2000


@lru_cache(maxsize=4096)
def file_key(relative: str) -> str:
    """Return the identifier of the file at path `relative` below the workspace: base name and a short hash of the path."""
    return f"{Path(relative).name}#{hashlib.sha1(relative.encode(), usedforsecurity=False).hexdigest()[:4]}"


class SourceFile:
    """One file that clang read; `relative` and `key` are None when it is outside the workspace, `label` is then its name."""

    __slots__ = ("_starts", "data", "key", "label", "path", "relative")

    def __init__(self, path: Path, relative: str | None, data: bytes) -> None:
        self.path, self.relative, self.data = path, relative, data
        self.key = file_key(relative) if relative else None
        self.label = self.key or path_text(path.name)
        self._starts: list[int] | None = None

    @property
    def stands_in(self) -> bool:
        """Whether rosarch made up what this header declares: the headers of it are absent."""
        return self.key is None and self.path.name in STAND_INS

    def line_column(self, offset: int) -> tuple[int, int]:
        """Return line and column (bytes), both from 1, of a byte offset."""
        if self._starts is None:
            self._starts = [0, *(match.end() for match in re.finditer(b"\n", self.data))]
        line = bisect_right(self._starts, offset)
        return line, offset - self._starts[line - 1] + 1

    def text(self, begin: int, end: int) -> str:
        """The source text between two offsets, white space folded."""
        return " ".join(self.data[begin:end].decode("utf-8", "replace").split())


class SourceFiles:
    """The files that clang read for units of the workspace at `root`, each looked at once: most are headers that many units include.

    Headers of the `underlay` are read like those of the workspace.
    """

    def __init__(self, root: Path, underlay: Underlay = NOTHING_INSTALLED) -> None:
        self.root = root
        self._underlay = underlay
        self._by_name: dict[str, SourceFile] = {}

    def named(self, name: str) -> SourceFile:
        """The file that clang knows as `name`."""
        known = self._by_name.get(name)
        if known is None and not name:  # what no file says: not the current folder, which may be the workspace
            known = self._by_name[name] = SourceFile(Path(), None, b"")
        if known is None:
            path = Path(os.path.abspath(name))  # links are kept: a linked package belongs to the workspace it is linked into
            try:
                data = read_file(path)
            except OSError:
                data = b""
            is_read = path.is_relative_to(self.root) or self._underlay.holds(str(path))
            relative = path_text(shown_path(self.root, path)) if is_read else made_from(data)
            known = self._by_name[name] = SourceFile(self.root / relative if relative else path, relative, data)
        return known


class Span(NamedTuple):
    """Where a cursor lies: `begin` and `end` are byte offsets into `file`."""

    file: SourceFile
    begin: int
    end: int


@dataclass(frozen=True)
class FunctionSpan:
    """Where a function with a body lies; `owner` is its class, or empty."""

    function: str
    owner: str
    file: SourceFile
    begin: int
    end: int


@dataclass(frozen=True)
class StructuredBinding:
    """A name in `auto [a, b] = value`: the data member `field` of `variable`, which has no name, or else its part at `index`."""

    variable: str
    index: int
    field: Cursor | None


DEEPEST = 2500
"""Statements and expressions within each other: each takes several calls, of which there is room for `deep_recursion`."""


@dataclass
class UnitFacts:
    """Rows and identifiers of one translation unit.

    `call_sites` holds, per file, the offsets at which the names of the calls met so far end; `remnants`
    are names of methods whose calls clang dropped, with the offset at which the name ends; `marks`, per function, say which
    block and index in it what stands after an offset belongs to; `skipped`, per path, the
    ranges that conditional compilation leaves out; `bindings`, by clang's address of its declaration, what a structured binding
    names. `sees` says which definitions of declared classes count. `depth` statements and expressions are being read, each within
    the one before; `deep` are those left out because these would be more than `DEEPEST`.
    """

    sources: SourceFiles
    rows: dict[str, set[tuple[str | int, ...]]] = field(default_factory=lambda: defaultdict(set))
    declared: dict[int, str] = field(default_factory=dict)
    scopes: dict[int, str] = field(default_factory=dict)
    types: dict[int, str] = field(default_factory=dict)
    type_names: set[str] = field(default_factory=set)
    functions: list[FunctionSpan] = field(default_factory=list)
    walked: set[tuple[str, int, int, str]] = field(default_factory=set)
    call_sites: dict[int, set[int]] = field(default_factory=lambda: defaultdict(set))
    recovered: dict[tuple[int, int], str] = field(default_factory=dict)
    remnants: list[tuple[str, SourceFile, int]] = field(default_factory=list)
    marks: dict[str, list[tuple[int, str, int]]] = field(default_factory=dict)
    skipped: dict[str, list[tuple[int, int]]] = field(default_factory=dict)
    bindings: dict[int, StructuredBinding] = field(default_factory=dict)
    sees: Callable[[Cursor], bool] = lambda _definition: True
    depth: int = 0
    deep: list[Span] = field(default_factory=list)
    _ids: dict[str, int] = field(default_factory=dict)
    _files: dict[str, SourceFile] = field(default_factory=dict)
    _bases: list[int] = field(default_factory=list)
    _intervals: list[tuple[int, int, SourceFile]] = field(default_factory=list)
    _source_rows: set[tuple[str | int, ...]] = field(default_factory=set)
    _latest: tuple[int, int, SourceFile | None] = (0, 0, None)
    _spellings: dict[int, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._source_rows = self._source_rows or self.rows["source_file"]

    @property
    def root(self) -> Path:
        """The workspace."""
        return self.sources.root

    def part(self, sees: Callable[[Cursor], bool]) -> UnitFacts:
        """Facts of a part of the unit, kept apart and complete in themselves: only where files lie is known already.

        Of classes that are declared and defined, it `sees` those definitions of which this is true.
        """
        return UnitFacts(
            self.sources,
            skipped=self.skipped,
            sees=sees,
            _files=self._files,
            _bases=self._bases,
            _intervals=self._intervals,
            _spellings=self._spellings,
            _source_rows=self.rows["source_file"],
        )

    def add(self, relation: str, *row: str | int) -> None:
        """Add one row to `relation`."""
        self.rows[relation].add(row)

    def file(self, name: str) -> SourceFile:
        """The file that clang knows as `name`."""
        known = self._files.get(name)
        if known is None:
            known = self._files[name] = self.sources.named(name)
            if known.key and known.relative:
                self._source_rows.add((known.key, known.relative))
        return known

    def locate(self, place: Location) -> tuple[SourceFile, int]:
        """Return (file, byte offset) of a location.

        Clang numbers the bytes of all files in one row; once one location of a file is known, all others
        follow without asking clang again.
        """
        raw = place.raw
        if not raw & MACRO_BIT:
            index = bisect_right(self._bases, raw) - 1
            if index >= 0:
                base, end, file = self._latest = self._intervals[index]
                if raw <= end:
                    return file, raw - base
        name, offset = libclang.file_location(place)
        file = self.file(name)
        if not raw & MACRO_BIT and name:
            base = raw - offset
            index = bisect_right(self._bases, base)
            self._bases.insert(index, base)
            self._intervals.insert(index, (base, base + len(file.data), file))
        return file, offset

    def span(self, cursor: Cursor) -> Span:
        """Return where `cursor` lies; an implicit cursor has an empty span in a file without name."""
        extent: Range = libclang.extent(cursor)
        first, last = extent.begin, extent.end
        base, stop, known = self._latest
        if base <= first <= last <= stop and known is not None:
            return Span(known, first - base, last - base)
        file, begin = self.locate(Location(extent.p0, extent.p1, extent.begin))
        if extent.end == extent.begin:
            return Span(file, begin, begin)
        end_file, end = self.locate(Location(extent.p0, extent.p1, extent.end))
        return Span(file, begin, end if end_file is file and end >= begin else begin)

    def span_of(self, tree: Tree) -> Span:
        """Return where the cursor of `tree` lies."""
        if tree.span is None:
            tree.span = self.span(tree.cursor)
        span: Span = tree.span
        return span

    def place(self, cursor: Cursor) -> tuple[SourceFile, int, int]:
        """Return file, line and column of the name that `cursor` declares."""
        file, offset = self.locate(libclang.location(cursor))
        return (file, *file.line_column(offset))

    def text(self, span: Span) -> str:
        """The source text of `span`, folded and cut."""
        text = span.file.text(span.begin, span.end)
        return text if len(text) <= TEXT_LIMIT else text[: TEXT_LIMIT - 3] + "..."

    def type_name(self, type_: Type) -> str:
        """How clang spells a type; asked once for each."""
        pointer = type_.d0 or 0
        name = self._spellings.get(pointer)
        if name is None:
            name = self._spellings[pointer] = libclang.type_spelling(type_)
        return name

    def node(self, span: Span, form: str) -> str:
        """Give out the identifier of an AST node and record its location."""
        file = span.file
        line, column = file.line_column(span.begin)
        identifier = f"{file.label}:{line}:{column}:{form}"
        count = self._ids.get(identifier, 0) + 1
        self._ids[identifier] = count
        if count > 1:
            identifier = f"{identifier}'{count}"
        self.rows["location"].add((identifier, file.label, line, column))
        return identifier
