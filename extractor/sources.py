"""The sources of components, C++ and Python: read in worker processes, unless they are known to be as they were."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from rosarch.base.diagnostics import Diagnostic, source_diagnostic
from rosarch.base.pool import Failure
from rosarch.extractor.cxx.translation_unit import CompileUnit
from rosarch.extractor.cxx.units import UnitReader, odd_source
from rosarch.extractor.python.units import PythonReader
from rosarch.extractor.settings import Settings
from rosarch.extractor.unit_store import UnitStore
from rosarch.extractor.units import Outcomes, UnitFile, read_units
from rosarch.extractor.workspace.model import PythonEntry

Unit = CompileUnit | PythonEntry
NONE: Mapping[Unit, UnitFile] = MappingProxyType({})


@dataclass(frozen=True)
class Sources:
    """How the sources of both languages are read."""

    cxx: UnitReader
    python: PythonReader
    settings: Settings

    def read(self, units: Iterable[Unit], known: Mapping[Unit, UnitFile] = NONE) -> Outcomes[Unit]:
        """Extract units into files, see `read_units`."""
        units = list(units)
        compiled = [unit for unit in units if isinstance(unit, CompileUnit)]
        scripts = [unit for unit in units if isinstance(unit, PythonEntry)]
        read = read_units(compiled, self.cxx, self.settings, known)
        return Outcomes({**read.files, **read_units(scripts, self.python, self.settings, known).files})

    def paths(self, file: UnitFile) -> tuple[Path, ...]:
        """Where the rows of a unit are, and those of the headers that it shares."""
        files = UnitStore(self.cxx.scratch, self.cxx.cache)
        return tuple(files.path(key) for key in (file.key, *file.headers))

    def lacks(self, outcome: UnitFile | Failure) -> bool:
        """Whether a unit has rows that are not available."""
        return isinstance(outcome, UnitFile) and not self.paths(outcome)[0].is_file()


def diagnostics(outcomes: Outcomes[Unit]) -> set[Diagnostic]:
    """What was not understood of sources; of those that failed, too, what is odd about them."""
    failed = {unit.source for unit in outcomes.failed if isinstance(unit, CompileUnit)}
    return outcomes.diagnostics | {source_diagnostic(problem) for source in failed for problem in odd_source(source)}
