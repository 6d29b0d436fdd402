"""Folders for what lasts no longer than a run; those of runs that were killed are removed by later ones."""

from __future__ import annotations

import fcntl
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

PREFIX = "rosarch.run-"


@contextmanager
def scratch_folder() -> Iterator[Path]:
    """A folder of this process and those that it starts; a lock that ends with the last of them tells that it is in use."""
    remove_abandoned()
    folder = made = Path(tempfile.mkdtemp(prefix=f".{PREFIX}"))
    lock = None
    try:
        lock = _locked(made)
        found = made.with_name(made.name[1:])
        if lock is not None and not found.exists():
            folder = made.rename(found)  # under a name that others look for, now that it is locked
        yield folder
    finally:
        try:
            shutil.rmtree(folder, ignore_errors=True)
        finally:  # again: a signal whose handler raises may have ended the first
            shutil.rmtree(folder, ignore_errors=True)
            if lock is not None:
                os.close(lock)


def remove_abandoned() -> None:
    """Remove this user's folders that no process uses any more."""
    for folder in Path(tempfile.gettempdir()).glob(f"{PREFIX}*"):
        with suppress(OSError):
            if folder.is_dir() and not folder.is_symlink() and folder.stat().st_uid == os.getuid():
                lock = _locked(folder)
                if lock is not None:
                    shutil.rmtree(folder, ignore_errors=True)
                    os.close(lock)


def _locked(folder: Path) -> int | None:
    """A lock of a folder; None when another process has it."""
    handle = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(handle)
        return None
    return handle
