"""Units of work, sources that are read together: each is extracted into a file, in a worker process, or taken from the cache."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Generic, Protocol, TypeVar

from rosarch.extractor.boundary import OUTSIDE, is_inside
from rosarch.extractor.cache import Cache, extractor_version
from rosarch.extractor.diagnostics import Diagnostic, SourceProblem
from rosarch.extractor.pool import Failure, run_tasks

Progress = Callable[[str, int, int], None]


@dataclass(frozen=True)
class UnitFile:
    """A unit that was extracted: the file with its rows, those of the headers it shares, how long it took, the errors that lost code.

    `key` is a hash of all that the rows depend on; None when that is not known.
    """

    path: Path
    headers: tuple[Path, ...]
    key: str | None
    seconds: float
    problems: list[SourceProblem]


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

    def prepare(self, timeout: float) -> None:
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
        reader.prepare(timeout)
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
        refuse_full_disk(outcome)
        reading.diagnostics.append(Diagnostic("source", unit.source, 1, 1, f"not analysed: {outcome.reason} ({outcome.detail})"))
    else:
        reading.seconds[unit.source] = max(outcome.seconds, reading.seconds.get(unit.source, 0.0))
        lost.update(Diagnostic("source", Path(path), line, column, message) for path, line, column, message in outcome.problems)


def refuse_full_disk(failure: Failure) -> None:
    """Facts that cannot be kept are no bad input: going on would lose most of them without a word."""
    if failure.reason == "disk full":
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), failure.detail)


def _size(path: Path) -> int:
    try:
        return os.path.getsize(path)
    except OSError:
        return 0
