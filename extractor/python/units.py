"""Python components as units of work: read in worker processes, kept in the cache under all that their facts depend on."""

from __future__ import annotations

import marshal
import time
from dataclasses import dataclass
from pathlib import Path

from rosarch.extractor.cache import Cache, extractor_version, hash_of
from rosarch.extractor.files import path_text, read_file
from rosarch.extractor.units import UnitFile, dump_rows
from rosarch.extractor.workspace.model import PythonEntry

from .extract import extract_program


@dataclass(frozen=True)
class PythonReader:
    """Extracts Python components into files below `scratch`, or takes them from the cache."""

    root: Path
    scratch: Path
    cache: Cache | None

    def prepare(self) -> None:
        """Python components share nothing that has to be made first."""

    def anything_known(self) -> bool:
        """Whether it is worth a look into the cache."""
        return self.cache is not None

    def known(self, unit: PythonEntry) -> UnitFile | None:
        """The component as it is in the cache."""
        start = time.perf_counter()
        key = self._key(unit)
        data = self.cache.load(key) if self.cache else None
        return self._file(key, data, start) if data is not None else None

    def read(self, unit: PythonEntry) -> UnitFile:
        """Extract a component."""
        start = time.perf_counter()
        rows, problems = extract_program(self.root, unit)
        data = marshal.dumps((problems, dump_rows(rows)))
        key = self._key(unit)
        if self.cache:
            self.cache.store(key, data)
        return self._file(key, data, start)

    def _file(self, key: str, data: bytes, start: float) -> UnitFile:
        path = self.scratch / f"{key}.unit"
        path.write_bytes(data)
        return UnitFile(path, (), key, time.perf_counter() - start, marshal.loads(data)[0])

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
