"""What a sub-command writes: folders that are rejected before an analysis, or that get all of their files or none."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from rosarch.cli.errors import InputError


def check_output(out: Path) -> None:
    """Reject an output folder that cannot be written to or made: better before a long analysis than after it."""
    there = next((folder for folder in (out, *out.parents) if os.path.lexists(folder)), out)
    if not os.path.isdir(there):
        raise InputError(f"{there}: not a folder")
    if not os.access(there, os.W_OK | os.X_OK):
        raise InputError(f"{there}: cannot write to this folder")


@contextmanager
def output_folder(out: Path) -> Iterator[Path]:
    """A folder whose files move to `out` in the end; when something fails, nothing there is new."""
    from rosarch.base.whole import whole_folder

    try:
        with whole_folder(out) as folder:
            yield folder
    except OSError as error:
        raise unwritable(out, error) from None


def write_files(out: Path, files: Iterable[tuple[str, str]]) -> None:
    """Write texts to files of a folder, by their names: all or none."""
    from rosarch.base.whole import write_whole

    with output_folder(out) as folder:
        for name, text in files:
            write_whole(folder / name, _encoded(text))


def write_output(path: Path, text: str) -> None:
    """Write a file that was named; a device or a pipe, too."""
    from rosarch.base.whole import write_whole

    try:
        write_whole(path, _encoded(text))
    except OSError as error:
        raise unwritable(path, error) from None


def _encoded(text: str) -> bytes:
    return text.encode("utf-8", "backslashreplace")


def unwritable(out: Path, error: OSError) -> InputError:
    """The error for an output that rejects what is written to it."""
    return InputError(f"{error.filename or out}: cannot write ({(error.strerror or str(error)).lower()})")
