"""What a package installs where: the paths, below the prefix, that its files and programs have once it is built.

What a `CMakeLists.txt` or `setup.py` says in a way that is not understood is a reason why more may be installed (`Unsure`); a claim that
something is not installed holds only where there is none. Source: cmake-commands(7) on `install`.
"""

from __future__ import annotations

import fnmatch
import os
import posixpath
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.files import text_or_nothing


@dataclass(frozen=True)
class Install:
    """`source` becomes `path` below the prefix; of a `folder`, all that is in it.

    With patterns in `only`, just the files in it that one of them matches; what matches one of `but` is left out, with all below it.
    `plain`: at this line of this file the files are copied without permission to execute them. `at` is the command of CMake that does it.
    """

    path: str
    source: Path
    folder: bool = False
    only: tuple[str, ...] = ()
    but: tuple[str, ...] = ()
    plain: tuple[Path, int] | None = None
    at: tuple[Path, int] | None = None

    def brings(self, path: str) -> bool:
        """Whether there is `path` below the prefix by this. A folder that is not there is made by the build: it may hold anything."""
        if not self.folder:
            return path == self.path
        inside = path if self.path == "." else path[len(self.path) + 1 :] if path.startswith(f"{self.path}/") else None
        if not inside:
            return path == self.path
        if os.path.isdir(self.source) and not os.path.exists(self.source / inside):
            return False
        if any(_matches(above, self.but) for above in _above(inside)):
            return False
        return not self.only or os.path.isdir(self.source / inside) or _matches(inside, self.only)

    def files_called(self, name: str) -> Iterator[str]:
        """The paths, below the prefix, of the files called `name` that this brings."""
        if not self.folder:
            if posixpath.basename(self.path) == name:
                yield self.path
            return
        for here, _folders, names in os.walk(self.source):
            path = posixpath.normpath(posixpath.join(self.path, os.path.relpath(here, self.source), name))
            if name in names and self.brings(path):
                yield path


@dataclass(frozen=True)
class Unsure:
    """Why more may be installed than is known, because of what is at `line` of `path`."""

    reason: str
    path: Path
    line: int


@dataclass(frozen=True)
class Obstacle:
    """What keeps a package from being built, or its plug-ins from being loaded, at `line` of `path`.

    Its `kind`, and what it is `about`: target source, install source (the build needs a file or folder that does not exist and that nothing
    in it makes); description absent, description broken (a description of plug-ins that the package exports does not exist, or is no XML).
    """

    kind: str
    about: str
    path: Path
    line: int


def _above(path: str) -> Iterator[str]:
    while path:
        yield path
        path = posixpath.dirname(path)


def _matches(path: str, patterns: Sequence[str]) -> bool:
    """Whether one of the patterns fits the last parts of a path."""
    parts = path.split("/")
    ends = ["/".join(parts[start:]) for start in range(len(parts))]
    return any(fnmatch.fnmatchcase(end, pattern) for end in ends for pattern in patterns)


_ARTIFACTS = {"ARCHIVE", "LIBRARY", "RUNTIME", "OBJECTS", "FRAMEWORK", "BUNDLE", "PRIVATE_HEADER", "PUBLIC_HEADER", "RESOURCE", "INCLUDES"}
_LISTS = """
TARGETS FILES PROGRAMS DIRECTORY SCRIPT CODE EXPORT PERMISSIONS FILE_PERMISSIONS DIRECTORY_PERMISSIONS CONFIGURATIONS
IMPORTED_RUNTIME_ARTIFACTS RUNTIME_DEPENDENCY_SET
"""
_SINGLES = {"DESTINATION", "RENAME", "COMPONENT", "TYPE", "PATTERN", "REGEX", "NAMESPACE", "FILE"}
_FLAGS = {"OPTIONAL", "EXCLUDE_FROM_ALL", "FILES_MATCHING", "EXCLUDE", "USE_SOURCE_PERMISSIONS", "MESSAGE_NEVER", "NAMELINK_ONLY",
          "NAMELINK_SKIP"}  # fmt: skip


@dataclass(frozen=True)
class Installing:
    """The words of one `install`: its lists, where they go (`runtime`: programs), and which files of a folder."""

    lists: dict[str, list[str]]
    destination: str | None
    runtime: str | None
    rename: str | None
    only: tuple[str, ...]
    but: tuple[str, ...]
    flags: frozenset[str]

    @property
    def is_executable(self) -> bool:
        """Whether files, and those in folders, get or keep permission to be executed: those of FILES and DIRECTORY have to ask for it."""
        asked = {word for name in ("PERMISSIONS", "FILE_PERMISSIONS") for word in self.lists.get(name, ())}
        return "USE_SOURCE_PERMISSIONS" in self.flags or any(word.endswith("_EXECUTE") or "$" in word for word in asked)

    @property
    def is_clear(self) -> bool:
        """Whether all that is copied, and where to, is known."""
        return not ({"SCRIPT", "CODE", "IMPORTED_RUNTIME_ARTIFACTS"} & set(self.lists)) and not any(
            "$<" in word or "$ENV{" in word for words in self.lists.values() for word in words
        )


def installing(words: Sequence[str]) -> Installing:
    """What the words of an `install` say."""
    lists: dict[str, list[str]] = {}
    places: dict[str, str] = {}
    rename: str | None = None
    only: list[str] = []
    but: list[str] = []
    current: list[str] | None = None
    artifact, filtered = "", False
    rest = list(words)
    while rest:
        word = rest.pop(0)
        if word in _LISTS.split():
            current = lists.setdefault(word, [])
        elif word in _ARTIFACTS:
            artifact, current = word, None
        elif word in _SINGLES and rest:
            value, current = rest.pop(0), None
            if word == "DESTINATION":
                places.setdefault(artifact, value)
            elif word == "RENAME":
                rename = value
            elif word in ("PATTERN", "REGEX"):
                left_out = rest[:1] == ["EXCLUDE"]
                if not left_out:
                    only.append(value if word == "PATTERN" else "*")
                elif word == "PATTERN":
                    but.append(value)
        elif word in _FLAGS:
            filtered |= word == "FILES_MATCHING"
            current = None
        elif current is not None:
            current.append(word)
    runtime = places.get("RUNTIME", places.get(""))
    return Installing(lists, places.get(""), runtime, rename, tuple(only) if filtered else (), tuple(but), frozenset(words) & _FLAGS)


def library_path(name: str) -> str:
    """The path below the prefix that stands for those of a library that is installed, wherever that is."""
    return f"lib/lib{name}.so"


_NO_TEXT = re.compile(
    r"(?:mesh|stl|dae|icon|image|img|media|model|map|world|bag|material|texture|sound|audio|font|weight|rosbag|doc|data|picture|asset)s?"
    r"|mesh(?:es)?|.*\.(?!xml$|ya?ml$|py$|launch$|urdf$|xacro$|srdf$|rviz$|cfg$|txt$|json$|sh$|h(?:pp)?$)\w+",
    re.IGNORECASE,
)


def may_be_no_text(path: Path) -> bool:
    """Whether a file, or what is in a folder, may be no text: a checkout may be without it."""
    return _NO_TEXT.fullmatch(path.name) is not None


def line_with(path: Path, word: str) -> int:
    """The first line of a file that has a word; the first one when there is none."""
    lines = text_or_nothing(path).splitlines()
    return next((line for line, written in enumerate(lines, 1) if word in written), 1)


def below(prefix: str, destination: str) -> str | None:
    """A destination as a path below the prefix; None when it is elsewhere."""
    path = posixpath.normpath(destination)
    if path.startswith(prefix + "/"):
        path = path[len(prefix) + 1 :]
    return None if path.startswith(("/", "..")) else path


def copied(words: Installing, prefix: str, folder: str, place: tuple[Path, int] | None = None) -> Iterator[Install]:
    """The files and folders that an `install` in `folder` copies; `place` is that of one of CMake's own, which takes permissions away."""
    destination = None if words.destination is None else below(prefix, words.destination)
    if destination is None:
        return
    plain = None if words.is_executable else place
    for kind, how in (("FILES", plain), ("PROGRAMS", None)):
        for name in words.lists.get(kind, ()):
            path = posixpath.normpath(f"{destination}/{words.rename or posixpath.basename(name)}")
            yield Install(path, Path(folder) / name, plain=how, at=place)
    for name in words.lists.get("DIRECTORY", ()):
        into = "" if name.endswith("/") or not name else posixpath.basename(posixpath.normpath(name))
        path = posixpath.normpath(f"{destination}/{'' if into in ('.', '..') else into}")
        yield Install(path, Path(os.path.normpath(f"{folder}/{name}")), True, words.only, words.but, plain, place)
