"""Translation units: each is extracted into a file, in worker processes, or its rows are taken from the cache."""

from __future__ import annotations

import errno
import os
import re
import shutil
import sys
import time
from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Generic, Protocol, TypeVar

from rosarch.extractor.boundary import OUTSIDE, is_inside
from rosarch.extractor.cache import Cache, extractor_version, hash_of, write_whole
from rosarch.extractor.cxx.includes import HeaderFinder, Includes
from rosarch.extractor.cxx.recover import Names
from rosarch.extractor.cxx.shared import SharedHeaders
from rosarch.extractor.cxx.translation_unit import CompileUnit, Problem, Rows, build_prelude, extract_unit, unit_key
from rosarch.extractor.diagnostics import Diagnostic
from rosarch.extractor.files import read_file
from rosarch.extractor.pool import Failure, run_tasks
from rosarch.extractor.unit_store import UnitStore
from rosarch.extractor.workspace.model import ROS1

Progress = Callable[[str, int, int], None]
PRELUDE_BYTES = 64 << 20
"""More than the precompiled declarations take."""
PRELUDE_SECONDS = 60.0
"""A limit for what is done once and takes a second."""


@dataclass(frozen=True)
class UnitFile:
    """A unit that was extracted: the file with its rows, those of the headers it shares, how long it took, the errors that lost code.

    `key` is a hash of all that the rows depend on; None when that is not known.
    """

    path: Path
    headers: tuple[Path, ...]
    key: str | None
    seconds: float
    problems: list[Problem]


class AnyUnit(Hashable, Protocol):
    """Sources that are read together."""

    @property
    def source(self) -> Path:
        """The file that the others are read for."""

    @property
    def own_sources(self) -> tuple[Path, ...]:
        """The files that are read for no other reason."""


Unit = TypeVar("Unit", bound=AnyUnit)
Read = TypeVar("Read", bound=AnyUnit, contravariant=True)
Outcome = tuple[tuple[Path, ...], UnitFile | Failure]


class Reader(Protocol[Read]):
    """Extracts units of a kind into files below `scratch`, or takes them from the cache."""

    @property
    def scratch(self) -> Path:
        """A folder for files of this run."""

    @property
    def cache(self) -> Cache | None:
        """What earlier runs left."""

    def anything_known(self) -> bool:
        """Whether it is worth a look into the cache."""

    def prepare(self) -> None:
        """Make what all units share."""

    def known(self, unit: Read) -> UnitFile | None:
        """The unit as it is in the cache."""

    def read(self, unit: Read) -> UnitFile:
        """Extract one unit."""


@dataclass
class Reading(Generic[Unit]):
    """What became of all units: their files or why there is none, what was not understood, and the time that each source took."""

    files: dict[Unit, UnitFile | Failure] = field(default_factory=dict)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    seconds: dict[Path, float] = field(default_factory=dict)

    def of(self, units: Iterable[Unit]) -> list[Outcome]:
        """The sources of some units and what became of them."""
        return [(unit.own_sources, self.files[unit]) for unit in units]


@dataclass(frozen=True)
class UnitReader:
    """Extracts units into files below `scratch`, or takes them from the cache."""

    root: Path
    finder: HeaderFinder
    scratch: Path
    cache: Cache | None
    _names: dict[str, Names] = field(default_factory=dict)

    @property
    def files(self) -> UnitStore:
        """The files of units and headers."""
        return UnitStore(self.scratch, self.cache)

    def prepare(self) -> None:
        """What all units share: the precompiled declarations."""
        self._precompiled(())

    def _precompiled(self, headers: tuple[str, ...], middleware: str = ROS1) -> Path:
        """The precompiled declarations, with those of some further headers."""
        key = hash_of([extractor_version(), middleware, *headers]) if headers or middleware != ROS1 else extractor_version()
        path = self.scratch / f"{key}.pch"
        if not path.is_file():
            data = self.cache.load(key) if self.cache else None
            if data is not None:
                write_whole(path, data)
                return path
            made = path.with_name(f"{path.name}.{os.getpid()}")
            build_prelude(made, headers, middleware)
            made.replace(path)
            if self.cache:
                self.cache.store(key, path.read_bytes())
        return path

    def precompiled_for(self, unit: CompileUnit, includes: Includes) -> Path | None:
        """The precompiled declarations that a unit begins with; it includes all of them."""
        return self._precompiled(self.finder.large_headers(includes, unit.middleware), unit.middleware) if unit.language == "c++" else None

    def anything_known(self) -> bool:
        """Whether an earlier run left anything in the cache: the first that it left are the declarations."""
        return self.cache is not None and self.cache.load(extractor_version()) is not None

    def known(self, unit: CompileUnit) -> UnitFile | None:
        """The unit as it is in the cache."""
        start = time.perf_counter()
        includes = self.finder.closure(unit.source, unit.folders)
        if not (self.cache and includes.predictable):
            return None
        key = unit_key(unit, self.root, includes, self.finder)
        head = self.files.head(key)
        if head is None or any(self.files.head(header) is None for header in head[1] if header not in self._names):
            return None
        return self._file(key, head, start)

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
        sys.setrecursionlimit(20_000)
        includes = self.finder.closure(unit.source, unit.folders)
        key = unit_key(unit, self.root, includes, self.finder)
        problems: list[Problem] = []
        headers = SharedHeaders(unit.source, unit.folders, (unit.language, unit.middleware, *unit.definitions), self.finder, self)
        prelude = self.precompiled_for(unit, includes)
        rows = extract_unit(unit, self.root, self.finder, prelude, includes=includes, heal=True, problems=problems, headers=headers)
        head = problems, sorted(headers.keys.values())
        self.files.keep(key, head, rows, lasting=includes.predictable)
        return self._file(key, head, start, certain=includes.predictable)

    def _file(self, key: str, head: tuple[list[Problem], list[str]], start: float, *, certain: bool = True) -> UnitFile:
        problems, headers = head
        paths = tuple(map(self.files.path, headers))
        return UnitFile(self.files.path(key), paths, key if certain else None, time.perf_counter() - start, problems)


def read_units(units: Sequence[Unit], reader: Reader[Unit], jobs: int, timeout: float, progress: Progress | None) -> Reading[Unit]:
    """Extract every unit into a file, unless it is in the cache."""
    reading = Reading[Unit]()
    extractor_version()  # once here, and not in each worker
    outside = {source for source in {unit.source for unit in units} if not is_inside(source)}
    reading.files.update((unit, Failure("outside", OUTSIDE)) for unit in units if unit.source in outside)
    reading.diagnostics += [Diagnostic("source", source, 1, 1, f"not analysed: {OUTSIDE}") for source in outside]
    largest = sorted(
        (unit for unit in units if unit.source not in outside), key=lambda unit: -_size(unit.source)
    )  # long ones first: even ends
    lost: set[Diagnostic] = set()  # a header's are found by every source that includes it

    def run(work: Callable[[Unit], UnitFile | None], waiting: Sequence[Unit]) -> list[Unit]:
        """Do `work` for all that are `waiting`; the units that it has nothing for."""
        left = []
        for index, outcome in run_tasks(work, waiting, jobs=jobs, timeout=timeout):
            if outcome is None:
                left.append(index)
                continue
            _settle(reading, waiting[index], outcome, lost)
            if progress:
                progress("sources", len(reading.files), len(units))
        return [waiting[index] for index in sorted(left)]

    unknown = run(reader.known, largest) if reader.anything_known() else largest
    if unknown:
        _prepare(reader, timeout)
        run(reader.read, unknown)
        if reader.cache:
            reader.cache.trim()
    reading.diagnostics += lost
    reading.diagnostics.sort(key=str)
    return reading


def _settle(reading: Reading[Unit], unit: Unit, outcome: UnitFile | Failure, lost: set[Diagnostic]) -> None:
    """Take down what became of a unit."""
    reading.files[unit] = outcome
    if isinstance(outcome, Failure):
        _refuse_full_disk(outcome)
        reading.diagnostics.append(Diagnostic("source", unit.source, 1, 1, f"not analysed: {outcome.reason} ({outcome.detail})"))
    else:
        reading.seconds[unit.source] = max(outcome.seconds, reading.seconds.get(unit.source, 0.0))
        lost.update(Diagnostic("source", Path(path), line, column, message) for path, line, column, message in outcome.problems)


def _prepare(reader: Reader[Unit], timeout: float) -> None:
    """Precompile the declarations, in a worker: without room on the disk, clang ends its process."""
    for _, outcome in run_tasks(lambda _task: reader.prepare(), [None], jobs=1, timeout=max(timeout, PRELUDE_SECONDS)):
        if isinstance(outcome, Failure):
            _refuse_full_disk(outcome)
            full = shutil.disk_usage(reader.scratch).free < PRELUDE_BYTES
            raise OSError(errno.ENOSPC if full else errno.EIO, os.strerror(errno.ENOSPC) if full else outcome.detail, str(reader.scratch))


def _refuse_full_disk(failure: Failure) -> None:
    """Facts that cannot be kept are no bad input: going on would lose most of them without a word."""
    if failure.reason == "disk full":
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), failure.detail)


_SELF_INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"\n]+)[>"]', re.MULTILINE)


def odd_source(path: Path) -> list[Diagnostic]:
    """What a reader would want to know of a source before wondering why little was found in it: one diagnostic."""
    try:
        data = read_file(path)
    except OSError:
        return []  # reported where it is read
    if not data.strip():
        return [Diagnostic("source", path, 1, 1, "empty source")]
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


def _at(path: Path, data: bytes, offset: int, message: str) -> Diagnostic:
    start = data.rfind(b"\n", 0, offset) + 1
    return Diagnostic("source", path, data.count(b"\n", 0, offset) + 1, offset - start + 1, message)


def _size(path: Path) -> int:
    try:
        return os.path.getsize(path)
    except OSError:
        return 0
