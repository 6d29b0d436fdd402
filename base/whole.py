"""Files and folders that are written whole or not at all, so that no reader ever sees half of them."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from itertools import takewhile
from pathlib import Path

from rosarch.base.scratch import scratch_folder


def write_whole(path: Path, data: bytes) -> None:
    """Write a file and the folders above it; OSError, and no trace, when it cannot be written. A device or a pipe stays what it is."""
    if os.path.exists(path) and (path.is_relative_to("/dev") or not os.path.isfile(path)):
        path.write_bytes(data)
        return
    temporary = path.with_name(f"{path.name}.{os.getpid()}.tmp")
    made = _missing(path.parent)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        temporary.write_bytes(data)
        temporary.replace(path)
    except BaseException as error:
        _remove([*made, temporary])
        if isinstance(error, OSError):
            above = error.filename if error.filename != str(temporary) else None  # a folder that cannot be made
            raise OSError(error.errno, error.strerror, above or str(path)) from None
        raise


@contextmanager
def whole_folder(folder: Path) -> Iterator[Path]:
    """A folder to write to, whose files move to `folder` in the end, beside what is there or in its place.

    Raises:
        OSError: the files cannot be written; nothing in `folder` is new then, as after any other exception.
    """
    missing = _missing(folder)
    made: list[Path] = []
    with scratch_folder(missing[0].parent if missing else folder) as staged:
        try:
            yield staged
            targets = {path: folder / path.relative_to(staged) for path in sorted(staged.rglob("*")) if path.is_file()}
            for target in targets.values():
                if target.is_dir():
                    raise OSError(errno.EISDIR, os.strerror(errno.EISDIR), str(target))
            for below in dict.fromkeys((folder, *(target.parent for target in targets.values()))):
                made += _missing(below)
                below.mkdir(parents=True, exist_ok=True)
            for path, target in targets.items():
                made += [] if os.path.lexists(target) else [target]
                path.replace(target)
        except BaseException as error:
            _remove(made)
            if isinstance(error, OSError) and error.filename and Path(error.filename).is_relative_to(staged):
                raise OSError(error.errno, error.strerror, str(folder / Path(error.filename).relative_to(staged))) from None
            raise


def _missing(folder: Path) -> list[Path]:
    """A folder and those above it, as far as they do not exist; the outermost first."""
    return [*takewhile(lambda path: not os.path.lexists(path), (folder, *folder.parents))][::-1]


def _remove(made: list[Path]) -> None:
    """Remove files, and folders when they are empty, the last first."""
    for path in reversed(made):
        with suppress(OSError):
            path.rmdir() if path.is_dir() else path.unlink()
