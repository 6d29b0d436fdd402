"""Results of earlier runs, kept on disk: entries found by a hash of all that they depend on.

An entry is written whole or not at all and carries a checksum, so that runs at the same time, a kill at any moment or a damaged disk cost
time and nothing else. A cache that cannot be written is none.
"""

from __future__ import annotations

import hashlib
import marshal
import os
import pickle
import sys
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any, TypeVar

from rosarch.base.seal import sealed, unsealed
from rosarch.base.whole import write_whole

Value = TypeVar("Value")
LIMIT = 1 << 30
"""Bytes beyond which the entries that were not used for longest are removed."""


def version_of_packages(*names: str) -> str:
    """A hash of packages of rosarch, which are not imported for that, and of Python."""
    specs = (find_spec(f"rosarch.{name}") for name in names)
    return version_of(Path(folder) for spec in specs if spec for folder in spec.submodule_search_locations or ())


def version_of(folders: Iterable[Path]) -> str:
    """A hash of programs: of the files below folders, and of Python.

    Of files it is names, sizes and times: reading them all would take longer than reading a small workspace.
    """
    parts = [sys.version]
    for folder in folders:
        for above, inner, names in os.walk(folder):
            inner[:] = sorted(name for name in inner if name != "__pycache__")
            for name in sorted(names):
                path = os.path.join(above, name)
                stat = os.stat(path)
                parts.append(f"{path} {stat.st_size} {stat.st_mtime_ns}")
    return hash_of(parts)


@dataclass(frozen=True)
class Cache:
    """Entries below a folder, each a file of bytes."""

    folder: Path

    def load(self, key: str) -> bytes | None:
        """The entry, or None when there is none or it is damaged."""
        path = self._path(key)
        try:
            data = unsealed(path.read_bytes())
            if data is not None:
                os.utime(path)  # the time of its last use
        except OSError:
            return None
        return data

    def load_to(self, path: Path, key: str) -> bytes | None:
        """The entry, see `load`, which then lies sealed at `path`, too: the same file, if that can be."""
        data = self.load(key)
        if data is not None and not path.is_file():
            try:
                os.link(self._path(key), path)
            except OSError:  # another file system, or another run has just removed it
                write_whole(path, sealed(data))
        return data

    def store(self, key: str, data: bytes) -> None:
        """Keep an entry; without room, there is none."""
        with suppress(OSError):
            write_whole(self._path(key), sealed(data))

    def load_value(self, key: str, kind: type[Value]) -> Value | None:
        """The value that was kept by `store_value`; None when there is none of this kind."""
        data = self.load(key)
        try:
            found = None if data is None else pickle.loads(data)
        except Exception:  # the checksum was right, so that it is another version's; whatever pickle then says
            return None
        return found if isinstance(found, kind) else None

    def store_value(self, key: str, value: object) -> None:
        """Keep a value."""
        self.store(key, pickle.dumps(value, protocol=pickle.HIGHEST_PROTOCOL))

    def trim(self, limit: int = LIMIT) -> None:
        """Remove what was not used for longest until three quarters of `limit` bytes remain, when there are more than `limit`."""
        entries = []
        for folder in _below(self.folder):
            for entry in _below(folder):
                with suppress(OSError):  # another run may remove it first
                    stat = entry.stat()
                    entries.append((stat.st_mtime, stat.st_size, entry.path))
        total = sum(size for _, size, _ in entries)
        if total <= limit:
            return
        for _, size, path in sorted(entries):
            with suppress(OSError):
                os.unlink(path)
            total -= size
            if total <= limit * 3 // 4:
                return

    def _path(self, key: str) -> Path:
        return self.folder / key[:2] / key[2:]


def _below(folder: str | os.PathLike[str]) -> list[os.DirEntry[str]]:
    """What is in a folder, as far as it can be read."""
    with suppress(OSError), os.scandir(folder) as scan:
        return [*scan]
    return []


def hash_of(parts: Iterable[str | bytes]) -> str:
    """A hash of a sequence of texts, which depends on where one ends and the next begins."""
    found = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else part.encode("utf-8", "surrogateescape")
        found.update(len(data).to_bytes(8, "little") + data)
    return found.hexdigest()


def rows_digest(rows: Mapping[str, Iterable[tuple[Any, ...]]]) -> str:
    """A hash of the rows of relations."""
    return hash_of([marshal.dumps([(name, sorted(found)) for name, found in sorted(rows.items())], 2)])
