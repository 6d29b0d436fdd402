"""Units of work, sources that are read together: each is extracted into a file, in a worker process, or taken from the cache."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Generic, Protocol, TypeVar

from rosarch.base.boundary import OUTSIDE, is_inside
from rosarch.base.cache import Cache
from rosarch.base.diagnostics import Diagnostic, SourceProblem, source_diagnostic
from rosarch.base.pool import Failure, default_jobs, run_tasks
from rosarch.extractor.settings import Settings
from rosarch.extractor.version import extractor_version


@dataclass(frozen=True)
class UnitFile:
    """A unit that was extracted: the keys of its rows and of those of headers that it shares, see `UnitStore`, and how long it took.

    `problems` are the errors that lost code, and what else a reader would want to know of the source. When it is `certain`, the key is a
    hash of all that the rows depend on, and `files` are those of the workspace, and others that are installed, among that.
    """

    key: str
    headers: tuple[str, ...]
    seconds: float
    problems: tuple[SourceProblem, ...]
    files: tuple[str, ...]
    certain: bool = True


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

    def may_have_cached(self) -> bool:
        """Whether it is worth a look into the cache."""

    def prepare(self, units: Sequence[Read], timeout: float) -> None:
        """Make what many units share."""

    def cached(self, unit: Read) -> UnitFile | None:
        """The unit as it is in the cache."""

    def read(self, unit: Read) -> UnitFile:
        """Extract one unit."""


@dataclass(frozen=True)
class Outcomes(Generic[Unit]):
    """What became of units: their files, or why there is none."""

    files: dict[Unit, UnitFile | Failure] = field(default_factory=dict)

    def of(self, units: Iterable[Unit]) -> list[Outcome]:
        """The sources of some units and what became of them."""
        return [(unit.own_sources, self.files[unit]) for unit in units]

    @property
    def failed(self) -> dict[Unit, Failure]:
        """The units without a file."""
        return {unit: outcome for unit, outcome in self.files.items() if isinstance(outcome, Failure)}

    @property
    def seconds(self) -> dict[Path, float]:
        """The time that each source took."""
        found: dict[Path, float] = {}
        for unit, outcome in self.files.items():
            if isinstance(outcome, UnitFile):
                found[unit.source] = max(outcome.seconds, found.get(unit.source, 0.0))
        return found

    @property
    def diagnostics(self) -> set[Diagnostic]:
        """What was not understood, each once: a header's problems are found by every source that includes it."""
        problems = {problem for outcome in self.files.values() if isinstance(outcome, UnitFile) for problem in outcome.problems}
        problems |= {(str(unit.source), 1, 1, f"not analysed: {_reason(failure)}") for unit, failure in self.failed.items()}
        return set(map(source_diagnostic, problems))


def _reason(failure: Failure) -> str:
    return failure.detail if failure.detail == OUTSIDE else f"{failure.reason} ({failure.detail})"


def read_units(units: Sequence[Unit], reader: Reader[Unit], settings: Settings, known: Mapping[Any, UnitFile]) -> Outcomes[Unit]:
    """Extract every unit into a file, unless it is in the cache. Of those that are `known`, there may be no file."""
    found = Outcomes[Unit]({unit: known[unit] for unit in units if unit in known})
    extractor_version()  # once here, and not in each worker
    found.files.update((unit, Failure("outside", OUTSIDE)) for unit in units if not is_inside(unit.source))
    largest = sorted((unit for unit in units if unit not in found.files), key=lambda unit: -_size(unit.source))  # for even ends

    def run(work: Callable[[Unit], UnitFile | None], waiting: Sequence[Unit]) -> list[Unit]:
        """Do `work` for all that are `waiting`; the units that it has nothing for."""
        left = []
        for index, outcome in run_tasks(work, waiting, jobs=settings.jobs or default_jobs(), timeout=settings.timeout):
            if outcome is None:
                left.append(index)
                continue
            if isinstance(outcome, Failure):
                refuse_full_disk(outcome)
            found.files[waiting[index]] = outcome
            if settings.progress:
                settings.progress("sources", len(found.files), len(units))
        return [waiting[index] for index in sorted(left)]

    unknown = run(reader.cached, largest) if largest and reader.may_have_cached() else largest
    if unknown:
        reader.prepare(unknown, settings.timeout)
        run(reader.read, unknown)
        if reader.cache:
            reader.cache.trim()
    return found


def refuse_full_disk(failure: Failure) -> None:
    """Facts that cannot be kept are no bad input: going on would lose most of them without a word."""
    if failure.reason == "disk full":
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), failure.detail)


def _size(path: Path) -> int:
    try:
        return os.path.getsize(path)
    except OSError:
        return 0
