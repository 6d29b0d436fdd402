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
def scratch_folder(within: Path | None = None) -> Iterator[Path]:
    """A folder of this process and those that it starts; a lock that ends with the last of them shows that it is in use.

    It is among the temporary files of the machine, or hidden in a folder.
    """
    remove_abandoned(within)
    folder, lock = _new_folder(within)
    try:
        yield folder
    finally:
        try:
            shutil.rmtree(folder, ignore_errors=True)
        finally:  # again: a signal whose handler raises may have ended the first
            shutil.rmtree(folder, ignore_errors=True)
            if lock is not None:
                os.close(lock)


def _new_folder(within: Path | None) -> tuple[Path, int | None]:
    """A folder and its lock, if the file system has locks."""
    top, prefix = _place(within)
    while True:
        folder = Path(tempfile.mkdtemp(prefix=prefix, dir=top))
        with suppress(FileNotFoundError, BlockingIOError):  # another run took it for abandoned before it was locked
            lock = _locked(folder)
            if folder.exists():
                return folder, lock
            if lock is not None:
                os.close(lock)


def remove_abandoned(within: Path | None = None) -> None:
    """Remove this user's folders that no process uses any more."""
    top, prefix = _place(within)
    for folder in top.glob(f"{prefix}*"):
        with suppress(OSError):
            if folder.is_dir() and not folder.is_symlink() and folder.stat().st_uid == os.getuid():
                lock = _locked(folder)
                if lock is not None:
                    shutil.rmtree(folder, ignore_errors=True)
                    os.close(lock)


def _place(within: Path | None) -> tuple[Path, str]:
    """Where the folders are, and how their names begin."""
    return (within, f".{PREFIX}") if within else (Path(tempfile.gettempdir()), PREFIX)


def _locked(folder: Path) -> int | None:
    """A lock of a folder; None when the file system has no locks.

    Raises:
        BlockingIOError: another process has it.
    """
    handle = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        os.close(handle)
        if isinstance(error, BlockingIOError):
            raise
        return None
    return handle
