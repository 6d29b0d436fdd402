"""Files and names of the input, which are never trusted."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Callable
from pathlib import Path

from rosarch.base import tracing
from rosarch.base.boundary import OUTSIDE, confined, is_inside, ros_package_path

LARGEST = 32 << 20
"""Bytes of a file; of one that has more, nothing is read."""
LARGEST_PARSED = 4 << 20
"""Bytes of a file that is parsed outside of worker processes, where no other limit holds: syntax trees are many times as large."""
_LONGEST = 200
"""Bytes of a file's name, with room for a suffix."""


def file_name(text: str) -> str:
    """A name of the input as the name of one file or folder: its part after the last `/`, what cannot be printed as `_`."""
    name = "".join(c if c.isprintable() else "_" for c in text.rpartition("/")[2])
    name = name.encode()[:_LONGEST].decode(errors="ignore")
    return name if name.strip(". ") else "_"


def path_below(folder: Path, *names: str) -> Path:
    """The path of `names` below `folder`; ValueError when they lead out of it."""
    path = folder.joinpath(*names)
    if ".." in path.relative_to(folder).parts:
        raise ValueError(f"{path} is not below {folder}")
    return path


def read_file(path: str | Path, most: int = LARGEST) -> bytes:
    """The content of a regular file inside the boundary, of at most so many bytes.

    OSError for anything else: a pipe would block, a device might never end.
    """
    status = content = None
    try:
        status = os.stat(path)
        if not stat.S_ISREG(status.st_mode):
            raise OSError(errno.EINVAL, "not a regular file", str(path))
        if not is_inside(path):
            raise OSError(errno.EACCES, OUTSIDE, str(path))
        if status.st_size > most:
            raise OSError(errno.EFBIG, f"larger than {most >> 20} MiB", str(path))
        with open(path, "rb") as file:
            content = file.read()
        return content
    finally:
        tracing.read(path, status, content)


def text_or_nothing(path: str | Path) -> str:
    """The text of a file; nothing where it cannot be read, which is reported where the file is analysed."""
    try:
        return read_file(path).decode(errors="replace")
    except OSError:
        return ""


def shown_path(root: Path, path: Path) -> Path:
    """How reports name a file: by its path below the root of the workspace, where it lies there."""
    return path.relative_to(root) if path.is_relative_to(root) else path


def folder_reader(root: Path, *others: Path) -> Callable[[str], str | None]:
    r"""Reads texts below a folder, lines ending in `\n`; None for what is no regular file or cannot be read.

    A path or link that leads out of the folder is followed to `others` and to `ROS_PACKAGE_PATH` only.
    """
    readable = [root, *others, *ros_package_path()]

    def read(path: str) -> str | None:
        try:
            with confined(readable):
                data = read_file(root / path)
        except (OSError, ValueError):  # a name with a zero byte is a ValueError
            return None
        return data.decode("utf-8", "replace").replace("\r\n", "\n").replace("\r", "\n")

    return read


def is_folder(entry: os.DirEntry[str]) -> bool:
    """Whether an entry is a folder or a link to one; a link that leads nowhere or to itself is none."""
    try:
        return entry.is_dir()
    except OSError:
        return False


def path_text(path: str | Path) -> str:
    r"""A path as text that can be written anywhere: a byte that is not UTF-8 is shown as `\xff`."""
    return os.fsencode(path.as_posix() if isinstance(path, Path) else path).decode("utf-8", "backslashreplace")
