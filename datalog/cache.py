"""Compiled programs and the parser's tables on disk, found by the paths of their root files and checked by the content of every file."""

from __future__ import annotations

import hashlib
import os
import pickle
import sys
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from rosarch.base.seal import sealed, unsealed
from rosarch.base.whole import write_whole

CACHE_VARIABLE = "ROSARCH_CACHE_DIR"


def cache_folder() -> Path:
    """`ROSARCH_CACHE_DIR`, or the user's cache folder."""
    chosen = os.environ.get(CACHE_VARIABLE)
    if chosen:
        return Path(chosen)
    import platformdirs

    return Path(platformdirs.user_cache_dir("rosarch"))


@cache
def engine_version() -> str:
    """A hash of the engine's own source and of the Python that runs it: either change makes caches stale."""
    return hashlib.sha256(f"{sys.version} {engine_source()}".encode()).hexdigest()[:16]


@cache
def engine_source() -> str:
    """A hash of the engine's own source."""
    found = hashlib.sha256()
    here = Path(__file__).parent
    for path in sorted(here.rglob("*")):
        if path.suffix in (".py", ".lark"):
            found.update(path.relative_to(here).as_posix().encode())
            found.update(path.read_bytes())
    return found.hexdigest()


def digest(path: str) -> str:
    """A hash of the content of a file."""
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def unchanged(digests: Mapping[str, str]) -> bool:
    """Whether all files have the content that they had."""
    return all(digest(path) == known for path, known in digests.items())


def _entry(paths: Sequence[Path], extra: str) -> Path:
    key = hashlib.sha256(engine_version().encode())
    for path in paths:
        key.update(f"{path}\0{path.resolve()}\0".encode("utf-8", "surrogateescape"))
    key.update(extra.encode("utf-8", "surrogateescape"))
    return cache_folder() / "datalog" / f"{key.hexdigest()[:32]}.pickle"


def is_stored(paths: Sequence[Path], extra: str) -> bool:
    """Whether a value is stored for a program, be it stale or not."""
    return os.path.isfile(_entry(paths, extra))


def load(paths: Sequence[Path], extra: str) -> Any | None:
    """The value stored for a program, or None when there is none or a file of it has changed."""
    try:
        content = unsealed(_entry(paths, extra).read_bytes())
        if content is None:  # what is damaged may still be a program, and another one
            return None
        digests, value = pickle.loads(content)
        return value if unchanged(digests) else None
    except Exception:
        return None


def store(paths: Sequence[Path], extra: str, digests: dict[str, str], value: Any) -> None:
    """Store a value; readers never see half of it."""
    entry = _entry(paths, extra)
    with suppress(OSError):  # a cache that cannot be written is only slower
        write_whole(entry, sealed(pickle.dumps((digests, value), protocol=pickle.HIGHEST_PROTOCOL)))
