"""Python components as units of work: read in worker processes, kept in the cache under all that their facts depend on."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.cache import Cache, hash_of
from rosarch.base.diagnostics import SourceProblem
from rosarch.base.files import path_text, read_file
from rosarch.extractor.python.extract import extract_program
from rosarch.extractor.unit_store import UnitStore
from rosarch.extractor.units import UnitFile
from rosarch.extractor.version import extractor_version
from rosarch.extractor.workspace.model import PythonEntry


@dataclass(frozen=True)
class PythonReader:
    """Extracts Python components into files below `scratch`, or takes them from the cache."""

    root: Path
    scratch: Path
    cache: Cache | None

    def prepare(self, units: Sequence[PythonEntry], timeout: float) -> None:
        """Python components share nothing that has to be made first."""

    def may_have_cached(self) -> bool:
        """Whether it is worth a look into the cache."""
        return self.cache is not None

    def cached(self, unit: PythonEntry) -> UnitFile | None:
        """The component as it is in the cache."""
        start = time.perf_counter()
        key = self._key(unit)
        problems = self._files.head(key)
        return None if problems is None else self._file(unit, key, problems, start)

    def read(self, unit: PythonEntry) -> UnitFile:
        """Extract a component."""
        start = time.perf_counter()
        rows, problems = extract_program(self.root, unit)
        key = self._key(unit)
        self._files.keep(key, problems, rows)
        return self._file(unit, key, problems, start)

    @property
    def _files(self) -> UnitStore:
        return UnitStore(self.scratch, self.cache)

    def _file(self, unit: PythonEntry, key: str, problems: list[SourceProblem], start: float) -> UnitFile:
        return UnitFile(key, (), time.perf_counter() - start, tuple(problems), tuple(map(str, unit.own_sources)))

    def _key(self, unit: PythonEntry) -> str:
        """A hash of the sources and of how they are started."""
        parts = [extractor_version(), "python", str(self.root), unit.module, unit.function or ""]
        for name, path in unit.modules:
            parts += [name, path_text(path), hash_of([_content(path)])]
        return hash_of(parts)


def _content(path: Path) -> str:
    try:
        return read_file(path).decode("latin-1")
    except OSError as error:
        return f"\0{error.errno}"
