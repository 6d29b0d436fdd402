"""Translation units: each is extracted into a file, in worker processes, or its rows are taken from the cache."""

from __future__ import annotations

import errno
import marshal
import os
import re
import shutil
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from rosarch.extractor.cache import Cache, extractor_version
from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.translation_unit import CompileUnit, Problem, build_prelude, extract_unit, unit_key
from rosarch.extractor.diagnostics import Diagnostic
from rosarch.extractor.files import read_file
from rosarch.extractor.pool import Failure, run_tasks

Progress = Callable[[str, int, int], None]
PRELUDE_BYTES = 64 << 20
"""More than the precompiled declarations take."""
PRELUDE_SECONDS = 60.0
"""A limit for what is done once and takes a second."""


@dataclass(frozen=True)
class UnitFile:
    """A unit that was extracted: the file with its rows, how long it took, the errors that lost code.

    `key` is a hash of all that the rows depend on; None when that is not known.
    """

    path: Path
    key: str | None
    seconds: float
    problems: list[Problem]


@dataclass
class Reading:
    """What became of all units: their files or why there is none, what was not understood, and the time that each source took."""

    files: dict[CompileUnit, UnitFile | Failure] = field(default_factory=dict)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    seconds: dict[Path, float] = field(default_factory=dict)


@dataclass(frozen=True)
class UnitReader:
    """Extracts units into files below `scratch`, or takes them from the cache."""

    root: Path
    finder: HeaderFinder
    scratch: Path
    cache: Cache | None

    def prepare(self) -> None:
        """What all units share: the precompiled declarations."""
        data = self.cache.load(extractor_version()) if self.cache else None
        if data is not None:
            self._prelude.write_bytes(data)
            return
        build_prelude(self._prelude)
        if self.cache:
            self.cache.store(extractor_version(), self._prelude.read_bytes())

    @property
    def _prelude(self) -> Path:
        return self.scratch / "prelude.pch"

    def known(self, unit: CompileUnit) -> UnitFile | None:
        """The unit as it is in the cache."""
        start = time.perf_counter()
        includes = self.finder.closure(unit.source, unit.include_dirs, unit.installed)
        if not (self.cache and includes.predictable):
            return None
        key = unit_key(unit, self.root, includes, self.finder)
        data = self.cache.load(key)
        return self._file(key, data, key, start) if data is not None else None

    def read(self, unit: CompileUnit) -> UnitFile:
        """Extract one unit.

        Its file holds the errors that lost code and, apart from them, the rows.
        """
        start = time.perf_counter()
        sys.setrecursionlimit(20_000)
        includes = self.finder.closure(unit.source, unit.include_dirs, unit.installed)
        key = unit_key(unit, self.root, includes, self.finder)
        problems: list[Problem] = []
        rows = extract_unit(unit, self.root, self.finder, self._prelude, includes=includes, heal=True, problems=problems)
        data = marshal.dumps((problems, marshal.dumps({name: list(found) for name, found in rows.items()})))  # sets would be sorted
        if self.cache and includes.predictable:
            self.cache.store(key, data)
        return self._file(key, data, key if includes.predictable else None, start)

    def _file(self, name: str, data: bytes, key: str | None, start: float) -> UnitFile:
        path = self.scratch / f"{name}.unit"
        path.write_bytes(data)
        return UnitFile(path, key, time.perf_counter() - start, marshal.loads(data)[0])


def unit_rows(path: Path) -> Mapping[str, list[tuple[str | int, ...]]]:
    """The rows in the file of a unit."""
    rows: Mapping[str, list[tuple[str | int, ...]]] = marshal.loads(marshal.loads(path.read_bytes())[1])
    return rows


def read_units(units: Sequence[CompileUnit], reader: UnitReader, jobs: int, timeout: float, progress: Progress | None) -> Reading:
    """Extract every unit into a file, unless it is in the cache."""
    reading = Reading(diagnostics=[problem for source in sorted({unit.source for unit in units}) for problem in _odd_source(source)])
    extractor_version()  # once here, and not in each worker
    largest = sorted(units, key=lambda unit: -_size(unit.source))  # long ones first: even ends
    lost: set[Diagnostic] = set()  # a header's are found by every source that includes it

    def run(work: Callable[[CompileUnit], UnitFile | None], waiting: Sequence[CompileUnit]) -> list[CompileUnit]:
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

    unknown = run(reader.known, largest) if reader.cache else largest
    if unknown:
        _prepare(reader, timeout)
        run(reader.read, unknown)
        if reader.cache:
            reader.cache.trim()
    reading.diagnostics += lost
    reading.diagnostics.sort(key=str)
    return reading


def _settle(reading: Reading, unit: CompileUnit, outcome: UnitFile | Failure, lost: set[Diagnostic]) -> None:
    """Take down what became of a unit."""
    reading.files[unit] = outcome
    if isinstance(outcome, Failure):
        _refuse_full_disk(outcome)
        reading.diagnostics.append(Diagnostic("source", unit.source, 1, 1, f"not analysed: {outcome.reason} ({outcome.detail})"))
    else:
        reading.seconds[unit.source] = max(outcome.seconds, reading.seconds.get(unit.source, 0.0))
        lost.update(Diagnostic("source", Path(path), line, column, message) for path, line, column, message in outcome.problems)


def _prepare(reader: UnitReader, timeout: float) -> None:
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


def _odd_source(path: Path) -> list[Diagnostic]:
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
