"""Translation units as units of work, with the files of the headers that they share and their precompiled declarations."""

from __future__ import annotations

import errno
import os
import re
import shutil
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from rosarch.base.cache import Cache, hash_of
from rosarch.base.diagnostics import SourceProblem
from rosarch.base.files import read_file
from rosarch.base.pool import Failure, run_tasks
from rosarch.base.whole import write_whole
from rosarch.extractor.cxx.includes import HeaderFinder, Includes
from rosarch.extractor.cxx.recover import Names
from rosarch.extractor.cxx.shared import SharedHeaders
from rosarch.extractor.cxx.translation_unit import CompileUnit, Rows, build_prelude, extract_unit, unit_key
from rosarch.extractor.cxx.unit import SourceFiles
from rosarch.extractor.unit_store import UnitStore
from rosarch.extractor.units import UnitFile, refuse_full_disk
from rosarch.extractor.version import extractor_version
from rosarch.extractor.workspace.model import ROS1

PRELUDE_BYTES = 64 << 20
"""More than the precompiled declarations take."""
PRELUDE_SECONDS = 60.0
"""A limit for what is done once and takes a second."""
_SELF_INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"\n]+)[>"]', re.MULTILINE)


@dataclass(frozen=True)
class UnitReader:
    """Extracts translation units into files below `scratch`, or takes them from the cache."""

    root: Path
    finder: HeaderFinder
    scratch: Path
    cache: Cache | None
    _names: dict[str, Names] = field(default_factory=dict)

    @cached_property
    def _sources(self) -> SourceFiles:
        return SourceFiles(self.root, self.finder.underlay)

    @property
    def files(self) -> UnitStore:
        """The files of units and headers."""
        return UnitStore(self.scratch, self.cache)

    def prepare(self, units: Sequence[CompileUnit], timeout: float) -> None:
        """Make the precompiled declarations that units share, in a worker: without room on the disk, clang ends its process."""
        used = sorted({ROS1, *(unit.middleware for unit in units)})  # those of ROS 1 also show that the cache holds something

        def make(middleware: str) -> Path:
            return self.precompiled(middleware=middleware)

        for _, outcome in run_tasks(make, used, jobs=len(used), timeout=max(timeout, PRELUDE_SECONDS)):
            if isinstance(outcome, Failure):
                refuse_full_disk(outcome)
                full = shutil.disk_usage(self.scratch).free < PRELUDE_BYTES
                raise OSError(errno.ENOSPC if full else errno.EIO, os.strerror(errno.ENOSPC) if full else outcome.detail, str(self.scratch))

    def precompiled(self, headers: tuple[str, ...] = (), middleware: str = ROS1) -> Path:
        """The precompiled declarations, with those of some further headers.

        What is precompiled of these rests on where the declarations lie in this run, so that it is not kept.
        """
        key = hash_of([extractor_version(), middleware, *headers]) if headers or middleware != ROS1 else extractor_version()
        path = self.scratch / f"{key}.pch"
        if not path.is_file():
            cache = None if headers else self.cache
            data = cache.load(key) if cache else None
            if data is not None:
                write_whole(path, data)
                return path
            made = path.with_name(f"{path.name}.{os.getpid()}")
            build_prelude(made, headers, middleware, self.precompiled(middleware=middleware) if headers else None)
            made.replace(path)
            if cache:
                cache.store(key, path.read_bytes())
        return path

    def precompiled_for(self, unit: CompileUnit, includes: Includes) -> Path | None:
        """The precompiled declarations that a unit begins with; it includes all of them."""
        return self.precompiled(self.finder.large_headers(includes, unit.middleware), unit.middleware) if unit.language == "c++" else None

    def may_have_cached(self) -> bool:
        """Whether an earlier run left anything in the cache: the first that it left are the declarations."""
        return self.cache is not None and self.cache.load(extractor_version()) is not None

    def cached(self, unit: CompileUnit) -> UnitFile | None:
        """The unit as it is in the cache."""
        start = time.perf_counter()
        includes = self.finder.closure(unit.source, unit.folders)
        if not (self.cache and includes.predictable):
            return None
        key = unit_key(unit, self.root, includes, self.finder)
        head = self.files.head(key)
        if head is None or not all(map(self.files.has, head[1])):
            return None
        return self._file(unit, key, head, start, includes)

    def load(self, key: str) -> Names | None:
        """The names that a header declares; None when no unit has read it yet (see `HeaderStore`)."""
        if key not in self._names:
            head = self.files.head(key)
            if head is None:
                return None
            self._names[key] = Names(*head)
        return self._names[key]

    def store(self, key: str, names: Names, rows: Rows) -> None:
        """Keep the facts of a header."""
        self.files.keep(key, tuple(names), rows)
        self._names[key] = names

    def read(self, unit: CompileUnit) -> UnitFile:
        """Extract one unit."""
        start = time.perf_counter()
        includes = self.finder.closure(unit.source, unit.folders)
        key = unit_key(unit, self.root, includes, self.finder)
        problems: list[SourceProblem] = []
        headers = SharedHeaders(unit.source, unit.folders, (unit.language, unit.middleware, *unit.definitions), self.finder, self)
        prelude = self.precompiled_for(unit, includes)
        rows = extract_unit(
            unit,
            self.root,
            self.finder,
            prelude,
            includes=includes,
            heal=True,
            problems=problems,
            headers=headers,
            sources=self._sources,
        )
        head = problems, sorted(headers.keys.values())
        self.files.keep(key, head, rows, lasting=includes.predictable)
        return self._file(unit, key, head, start, includes)

    def _file(self, unit: CompileUnit, key: str, head: tuple[list[SourceProblem], list[str]], start: float, includes: Includes) -> UnitFile:
        lost, headers = head
        problems = (*lost, *odd_source(unit.source))
        return UnitFile(
            key, tuple(headers), time.perf_counter() - start, problems, self.finder.files_outside(includes), includes.predictable
        )


def odd_source(path: Path) -> list[SourceProblem]:
    """What a reader would want to know of a source before wondering why little was found in it: one problem."""
    try:
        data = read_file(path)
    except OSError:
        return []  # reported where it is read
    if not data.strip():
        return [(str(path), 1, 1, "empty source")]
    if b"\0" in data:
        return [_at(path, data, data.index(b"\0"), "not a text file")]
    for match in _SELF_INCLUDE.finditer(data):
        if match.group(1).decode("utf-8", "replace") == path.name and (path.parent / path.name).samefile(path):
            return [_at(path, data, match.start(), "the source includes itself")]
    try:
        data.decode("utf-8")
    except UnicodeDecodeError as error:
        return [_at(path, data, error.start, f"not UTF-8 (byte 0x{data[error.start]:02x}); read as it is")]
    return []


def _at(path: Path, data: bytes, offset: int, message: str) -> SourceProblem:
    start = data.rfind(b"\n", 0, offset) + 1
    return str(path), data.count(b"\n", 0, offset) + 1, offset - start + 1, message
