"""The files of translation units and headers: those of this run, and those of earlier ones in the cache.

A file holds a head and, apart from it, the rows: the head of a unit are the errors that lost code and the keys of the headers that it
shares, the head of a header the names that it declares.
"""

from __future__ import annotations

import marshal
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rosarch.extractor.cache import Cache, below_seal, sealed, write_whole

Row = tuple[str | int, ...]


@dataclass(frozen=True)
class UnitStore:
    """Keeps files by their keys below `scratch`, and in the cache."""

    scratch: Path
    cache: Cache | None

    def path(self, key: str) -> Path:
        """Where the file is."""
        return self.scratch / f"{key}.rows"

    def head(self, key: str) -> Any:
        """The head of a file of this run or of an earlier one; None when there is none."""
        path = self.path(key)
        if path.is_file():
            return _parts(path)[0]
        data = self.cache.load_to(path, key) if self.cache else None
        return None if data is None else marshal.loads(data)[0]

    def has(self, key: str) -> bool:
        """Whether there is such a file, of this run or of an earlier one, which then lies below `scratch`."""
        path = self.path(key)
        return path.is_file() or (self.cache is not None and self.cache.load_to(path, key) is not None)

    def keep(self, key: str, head: Any, rows: Mapping[str, Iterable[Row]], *, lasting: bool = True) -> None:
        """Write a file, also for later runs if it is `lasting`."""
        data = marshal.dumps((head, marshal.dumps({name: list(found) for name, found in rows.items()})))  # sets would be sorted first
        if self.cache and lasting:
            self.cache.store(key, data)
        write_whole(self.path(key), sealed(data))


def unit_rows(path: Path) -> Mapping[str, list[Row]]:
    """The rows in the file of a unit or header."""
    rows: Mapping[str, list[Row]] = marshal.loads(_parts(path)[1])
    return rows


def _parts(path: Path) -> Any:
    """Head and rows, these still packed; that the file is whole was seen when it came from the cache, or this run has written it."""
    return marshal.loads(below_seal(path.read_bytes()))
