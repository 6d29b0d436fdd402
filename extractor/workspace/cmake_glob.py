"""File name patterns of `file(GLOB)` and `file(GLOB_RECURSE)`: `*`, `?`, `[...]`, results sorted."""

from __future__ import annotations

import os
import re
from collections.abc import Callable

from rosarch.base.files import is_folder
from rosarch.base.patterns import Pattern, compiled, encoded

_MAGIC = re.compile(r"[*?\[]")
MAX_FILES = 100_000


Report = Callable[[str, OSError], None]


def glob(pattern: str, recurse: bool, directories: bool, unreadable: Report) -> list[str]:
    """Existing paths that match an absolute pattern. Recursion does not follow symlinks (policy CMP0009).

    `unreadable` is called with each folder that is there but cannot be read.
    """
    folder, _, name = pattern.rpartition("/")
    starts = _folders(folder or "/", unreadable)
    matcher = _matcher(name)
    found: list[str] = []
    for start in starts:
        _collect(start, matcher, recurse, directories, found, unreadable)
    return sorted(found)


def _matcher(name: str) -> Pattern:
    parts: list[bytes] = []
    for piece in re.findall(rb"\[[!^]?\]?[^\]]*\]|.", encoded(name), re.DOTALL):
        if piece == b"*":
            parts.append(b"[^/]*")
        elif piece == b"?":
            parts.append(b"[^/]")
        elif len(piece) > 1:
            body = piece[1:-1].replace(b"\\", b"\\\\").replace(b"[", b"\\[")
            parts.append(b"[" + (b"^" + body[1:] if body[:1] in (b"!", b"^") else body) + b"]")
        else:
            parts.append(re.escape(piece))
    return compiled(b"".join(parts), name)


def _folders(path: str, unreadable: Report) -> list[str]:
    if not _MAGIC.search(path):
        return [path]
    parent, _, name = path.rpartition("/")
    result = []
    matcher = _matcher(name)
    for folder in _folders(parent or "/", unreadable):
        result += [entry.path for entry in _scan(folder, unreadable) if is_folder(entry) and matcher.fullmatch(entry.name)]
    return result


def _scan(folder: str, unreadable: Report) -> list[os.DirEntry[str]]:
    try:
        with os.scandir(folder) as entries:
            return sorted(entries, key=lambda entry: entry.name)
    except (FileNotFoundError, NotADirectoryError):
        return []
    except OSError as error:
        unreadable(folder, error)
        return []


def _collect(folder: str, matcher: Pattern, recurse: bool, directories: bool, found: list[str], unreadable: Report) -> None:
    if len(found) > MAX_FILES:
        return
    for entry in _scan(folder, unreadable):
        inner = is_folder(entry)
        if matcher.fullmatch(entry.name) and (directories or not inner):
            found.append(os.path.normpath(entry.path))
        if recurse and inner and not entry.is_symlink():
            _collect(entry.path, matcher, recurse, directories, found, unreadable)
