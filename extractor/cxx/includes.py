"""Finding the headers that a source includes, and standing in for those that are not there."""

from __future__ import annotations

import errno
import hashlib
import json
import os
import re
from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from rosarch.base import tracing
from rosarch.base.boundary import folders as inside
from rosarch.base.boundary import is_inside
from rosarch.base.cache import hash_of
from rosarch.base.files import read_file
from rosarch.base.whole import write_whole
from rosarch.extractor.cxx.assumed import assumed_text
from rosarch.extractor.underlay import NOTHING_INSTALLED, Underlay
from rosarch.extractor.workspace.model import ROS1, ROS2

SHIPPED = Path(__file__).parent / "headers"
SHIPPED_DIRS = (SHIPPED / "ros", SHIPPED / "third_party", SHIPPED / "std")
HEALED = "healed.h"  # the header that healing writes, with declarations of what is absent
STAND_INS = frozenset({HEALED, "healing.h"})
_SHIPPED_PREFIX = f"{SHIPPED}{os.sep}"
PRELUDE = SHIPPED / "prelude.h"
ROS2_PRELUDE = SHIPPED / "prelude_ros2.h"
CUDA_PRELUDE = SHIPPED / "prelude_cuda.h"
LARGE = 15_000
"""Bytes beyond which a header counts as large: more than nearly all have."""
_INCLUDE = re.compile(rb"^[ \t]*#[ \t]*include[ \t]*(?:<([^>\n]+)>|\"([^\"\n]+)\")", re.MULTILINE)
_UNPREDICTABLE = re.compile(  # a macro's include; a directive that is not written as `_INCLUDE` expects; what another run may see otherwise
    rb"^[ \t]*#[ \t]*include(?:_next)?[ \t]*[A-Za-z_\\/]|^[ \t]*#[ \t]*[a-z]*(?:\\\r?\n|/\*)|^[ \t]*(?:%:|\?\?=)"
    rb"|\*/[ \t]*#[ \t]*[i\\]|\b__(?:DATE|TIME|TIMESTAMP)__(?!\w)",
    re.MULTILINE,
)
_ASKED = re.compile(rb"__has_include(?:_next)?[ \t]*\([ \t]*(?:<([^>\n]+)>|\"([^\"\n]+)\")?")
"""Whether there is a header: no name when it is a macro that says which."""
_NO_NAME = (errno.EISDIR, errno.ENOTDIR, errno.EEXIST, errno.ENAMETOOLONG, errno.EINVAL)
"""What the system says of a name that no file can have here."""
_DEEPEST = 100
"""Folders within each other that a header may lie in."""
_HEADER_SUFFIXES = (".h", ".hpp", ".hh", ".hxx", ".ipp", ".inl", ".tcc", ".cuh")


@dataclass(frozen=True)
class Missing:
    """An include that nothing provides."""

    file: Path
    line: int
    header: str


class _Target(NamedTuple):
    """What an include leads to: a file to continue with, the folder to search for it beyond the usual ones, or what nothing provides."""

    file: str | None = None
    folder: Path | None = None
    missing: Missing | None = None


class Folders(NamedTuple):
    """The folders that a source is compiled with, those of installed headers, and the middleware whose declarations it gets."""

    own: tuple[Path, ...] = ()
    installed: tuple[Path, ...] = ()
    middleware: str = ROS1


def shipped_dirs(middleware: str) -> tuple[Path, ...]:
    """The folders of the headers that rosarch brings."""
    return (SHIPPED / "ros2", *SHIPPED_DIRS) if middleware == ROS2 else SHIPPED_DIRS


def prelude_of(middleware: str) -> Path:
    """The most used of them in one header."""
    return ROS2_PRELUDE if middleware == ROS2 else PRELUDE


@dataclass
class Includes:
    """What one source includes, directly and through others, as paths; `made` are the folders of generated and absent headers.

    `overlay` is the file that shows clang what it may see.
    A source is not `predictable` when macros decide what it includes: what it depends on is then not known in full.
    """

    made: list[Path] = field(default_factory=list)
    overlay: Path | None = None
    files: Collection[str] = ()
    missing: list[Missing] = field(default_factory=list)
    predictable: bool = True


NO_FOLDERS = Folders()


class _Search:
    """Looks for headers in the folders of a compile command; remembers what the includes of each file, and each name, lead to."""

    def __init__(self, folders: Folders) -> None:
        self.own = [str(folder) for folder in folders.own]
        self.installed = [str(folder) for folder in folders.installed]
        self.shipped = [str(folder) for folder in shipped_dirs(folders.middleware)]
        self.of_file: dict[str, list[_Target]] = {}
        self.of_name: dict[str, _Target | None] = {}
        self.described: dict[str, tuple[Includes, str]] = {}


class HeaderFinder:
    """Resolves includes against a workspace; what has to be made is written below `scratch`.

    `message_header` gives the text of a generated header by the name that code includes it by, else None. Headers that no folder of a
    source has are looked for in all of the workspace when it is `searched`, then in the `underlay`. Within, paths are text: there are
    many, and they are compared all the time.
    """

    def __init__(
        self,
        root: Path,
        scratch: Path,
        message_header: Callable[[str], str | None],
        underlay: Underlay = NOTHING_INSTALLED,
        *,
        searched: bool = True,
    ) -> None:
        self.root = root
        self.scratch = scratch
        self.underlay = underlay
        self.message_header = message_header
        self._by_name: dict[str, list[str]] | None = None if searched else {}
        self._included: dict[str, list[tuple[int, str, bool]]] = {}
        self._digests: dict[str, bytes] = {}
        self._unpredictable: set[str] = set()
        self._exists: dict[str, bool] = {}
        self._barred: set[str] = set()
        self._outward: set[str] | None = None
        self._overlays: dict[frozenset[str], Path] = {}
        self._made: dict[str, Path | None] = {}
        self._searches: dict[Folders, _Search] = {}
        self._stamps: dict[str, str] = {}
        self._large: dict[str, dict[str, frozenset[str]]] = {}
        self._marks = [(mark, f"{folder}{os.sep}") for mark, folder in (("", root), ("made:", scratch), ("shipped:", SHIPPED))]

    def closure(self, source: Path, folders: Folders = NO_FOLDERS) -> Includes:
        """Find all that `source` includes, making what is generated or absent.

        Headers of installed folders are taken only when the workspace, rosarch and message definitions have none: what the rules know
        is declared the same way everywhere.
        """
        return self._closure(str(source), self._search(folders))

    def described(self, header: Path, folders: Folders = NO_FOLDERS) -> tuple[Includes, str]:
        """The closure of a header and its fingerprint; found once."""
        search = self._search(folders)
        key = str(header)
        if key not in search.described:
            includes = self._closure(key, search)
            search.described[key] = includes, self.fingerprint(includes)
        return search.described[key]

    def large_headers(self, includes: Includes, middleware: str = ROS1) -> tuple[str, ...]:
        """The largest of the shipped headers among `includes`, beyond the prelude: it pays to have them precompiled.

        A header counts only if all that it includes is among `includes` too: nothing of it comes from elsewhere then.
        """
        if middleware not in self._large:
            shipped, folders = shipped_dirs(middleware), Folders(middleware=middleware)
            known = self.described(prelude_of(middleware), folders)[0].files
            sizes = {path: os.path.getsize(path) for folder in shipped for path in map(str, folder.rglob("*")) if os.path.isfile(path)}
            large = sorted(path for path, size in sizes.items() if size > LARGE and path not in known)
            closures = {path: frozenset(self.described(Path(path), folders)[0].files) for path in large}
            self._large[middleware] = {path: files for path, files in closures.items() if all(map(is_shipped, files))}
        found = self._large[middleware].items()
        return tuple(path for path, files in found if path in includes.files and files.issubset(includes.files))

    def _search(self, folders: Folders) -> _Search:
        if folders not in self._searches:
            self._searches[folders] = _Search(folders)
        return self._searches[folders]

    def _closure(self, source: str, search: _Search) -> Includes:
        result = Includes()
        extra: dict[Path, None] = {}
        seen = {source}
        queue = [source]
        while queue:
            file = queue.pop()
            found_all = search.of_file.get(file)
            if found_all is None:
                found_all = search.of_file[file] = [self._resolve(file, search, *include) for include in self._includes_of(file)]
            for target, folder, missing in found_all:
                if folder is not None:
                    extra[folder] = None
                if missing is not None:
                    result.missing.append(missing)
                if target is not None and target not in seen:
                    seen.add(target)
                    queue.append(target)
        result.files = seen
        result.made = sorted(extra)
        result.overlay = self._overlay()
        result.predictable = self._unpredictable.isdisjoint(seen)
        return result

    def files_outside(self, includes: Includes) -> tuple[str, ...]:
        """The files of a closure that neither rosarch brings nor this makes."""
        own = f"{self.scratch}{os.sep}"
        return tuple(path for path in includes.files if not path.startswith((own, _SHIPPED_PREFIX)))

    def fingerprint(self, includes: Includes) -> str:
        """A hash of what `closure` found: which files, with what content, and what is missing; the same wherever the workspace lies."""
        parts = ["".join(sorted(map(self._stamp, includes.files)))]
        parts += [f"{self._name(str(missing.file))}:{missing.line} {missing.header}" for missing in includes.missing]
        parts += [self._name(str(folder)) for folder in includes.made]
        return hash_of(parts)

    def _stamp(self, path: str) -> str:
        """A hash of the name and the content of a file."""
        if path not in self._stamps:
            self._stamps[path] = hash_of([self._name(path), self._digests.get(path, b"")])
        return self._stamps[path]

    def _name(self, path: str) -> str:
        """A path relative to the workspace, to what is made for it, or to what rosarch brings."""
        for mark, folder in self._marks:
            if path.startswith(folder):
                return mark + path[len(folder) :]
        return path

    def _includes_of(self, file: str) -> list[tuple[int, str, bool]]:
        if file not in self._included:
            try:
                data = read_file(file)
            except OSError:
                data = b""
            self._digests[file] = hashlib.sha256(data).digest()
            if not is_shipped(file) and (_UNPREDICTABLE.search(data) or not _names(_ASKED, data) <= _names(_INCLUDE, data)):
                self._unpredictable.add(file)
            self._included[file] = [
                (
                    data.count(b"\n", 0, match.start()) + 1,
                    os.fsdecode(match.group(1) or match.group(2)).strip(),
                    bool(match.group(2)),
                )
                for match in _INCLUDE.finditer(data)
            ]
        return self._included[file]

    def _is_file(self, path: str) -> bool:
        known = self._exists.get(path)
        if known is None:
            if not is_shipped(path):
                tracing.probe(path)
            known = self._exists[path] = os.path.isfile(path) and is_inside(path)
            if not known and os.path.islink(path):
                self._barred.add(path)
        return known

    def _resolve(self, file: str, search: _Search, line: int, name: str, quoted: bool) -> _Target:
        if name.startswith("/"):
            return _Target(name) if self._is_file(name) else _Target()
        if quoted and self._is_file(beside := f"{os.path.dirname(file)}/{name}"):
            return _Target(os.path.normpath(beside))
        if name not in search.of_name:
            search.of_name[name] = self._by_folders(name, search)
        found = search.of_name[name]
        if found is not None:
            return found
        elsewhere = self._elsewhere(file, name) or next(filter(self._is_file, self.underlay.headers(name)), None)
        if elsewhere is not None:
            return _Target(elsewhere, self._forward(name, elsewhere))
        return _Target(None, self._absent(name), Missing(Path(file), line, name))

    def _by_folders(self, name: str, search: _Search) -> _Target | None:
        """What a name leads to, whichever file includes it."""
        for folder in search.own:
            if self._is_file(path := f"{folder}/{name}"):
                return _Target(os.path.normpath(path))
        for shipped in search.shipped:
            if self._is_file(path := f"{shipped}/{name}"):
                return _Target(os.path.normpath(path))  # it may include messages in turn
        made = self._generated(name)
        if made is not None:
            return _Target(str(made), self.scratch / "messages")
        for folder in search.installed:
            if self._is_file(path := f"{folder}/{name}"):
                return _Target(path, self._forward(name, path))
        return None

    def _generated(self, name: str) -> Path | None:
        if name not in self._made:
            text = self.message_header(name)
            self._made[name] = self._write("messages", name, text) if text is not None else None
        return self._made[name]

    def _elsewhere(self, file: str, name: str) -> str | None:
        """The header of the tree whose path ends in `name`; of several, the one nearest to the including file."""
        if self._by_name is None:
            self._by_name = _headers_below(self.root)
        suffix = "/" + os.path.normpath(name).lstrip("./")
        candidates = [path for path in self._by_name.get(os.path.basename(name), ()) if path.endswith(suffix)]
        if not candidates:
            return None
        return max(candidates, key=lambda path: (len(os.path.commonpath([path, file])), -len(path), path))

    def _forward(self, name: str, target: str) -> Path:
        """A folder in which `name` is a header that includes `target`."""
        key = "forward/" + hash_of([name, self._name(target)])[:10]
        if key not in self._made:
            self._made[key] = self._write(key, name, f'#include "{target}"\n')
        return self.scratch / key

    def _absent(self, name: str) -> Path:
        """A folder in which `name` is an empty header, or a message of which only the name is known."""
        folder = f"absent/{name.count('/')}"  # by depth: QtGui may be a header and QtGui/QWidget one below it
        key = f"{folder}/{name}"
        if key not in self._made:
            self._made[key] = self._write(folder, name, assumed_text(name))
        return self.scratch / folder

    def _overlay(self) -> Path | None:
        """A file system for clang in which there is nothing beyond the boundary; links that lead there are empty files and folders."""
        if not inside():
            return None
        if self._outward is None:  # includes that macros name are not looked for here
            self._outward = set().union(*(_links_out(top) for top in (str(self.root), *self.underlay.include_folders)))
        barred = frozenset(self._barred | self._outward)
        if barred not in self._overlays:
            seen = []
            for path in sorted(barred):
                empty = {"type": "directory-remap", "external-contents": str(self.scratch / "nothing")}
                seen.append({"name": path, **(empty if os.path.isdir(path) else {"type": "file", "external-contents": os.devnull})})
            for folder in dict.fromkeys([*inside(), str(self.scratch), str(SHIPPED)]):
                seen.append({"type": "directory-remap", "name": folder, "external-contents": folder})
            text = json.dumps({"version": 0, "case-sensitive": "true", "redirecting-with": "redirect-only", "roots": seen})
            self._overlays[barred] = self._write("overlays", f"{hash_of([text])[:10]}.yaml", text)
        return self._overlays[barred]

    def _write(self, folder: str, name: str, text: str) -> Path:
        path = self.scratch / folder / name
        try:
            if not path.resolve().is_relative_to(self.scratch.resolve()):  # a name with ../ in it, or an absolute one
                path = self.scratch / folder / path.name
            if not path.is_file() and path.name != ".." and name.count("/") < _DEEPEST:
                write_whole(path, text.encode("utf-8", "surrogateescape"))
        except (OSError, ValueError) as error:
            if isinstance(error, OSError) and error.errno not in _NO_NAME:
                raise
        return path  # perhaps of no file: clang goes on without it


def is_shipped(path: str) -> bool:
    """Whether a header is one of those that rosarch brings."""
    return path.startswith(_SHIPPED_PREFIX)


def _links_out(root: str) -> set[str]:
    """The links below a folder that lead beyond the boundary, and what is neither file nor folder: to open a pipe would block."""
    found = set()
    stack = [root]
    while stack:
        try:
            entries = list(os.scandir(stack.pop()))
        except OSError:
            continue
        for entry in entries:
            if entry.is_symlink():
                if not is_inside(entry.path):
                    found.add(entry.path)
            elif entry.is_dir():
                stack.append(entry.path)
            elif not entry.is_file():
                found.add(entry.path)
    return found


def _headers_below(root: Path) -> dict[str, list[str]]:
    """The paths of all headers below a folder by base name; hidden folders and symbolic links to folders are left out.

    So are those that rosserial has made for microcontrollers: they have the names of ROS's own, and are none of them.
    """
    found: dict[str, list[str]] = {}
    stack = [str(root)]
    while stack:
        try:
            entries = sorted(os.scandir(stack.pop()), key=lambda entry: entry.name)
        except OSError:
            continue
        if any(entry.name == "ros" and os.path.isfile(f"{entry.path}/msg.h") for entry in entries):
            continue  # https://wiki.ros.org/rosserial/Overview: roscpp has no ros/msg.h
        for entry in entries:
            if entry.is_dir(follow_symlinks=False):
                if not entry.name.startswith("."):
                    stack.append(entry.path)
            elif entry.name.endswith(_HEADER_SUFFIXES):
                found.setdefault(entry.name, []).append(entry.path)
    return found


def _names(pattern: re.Pattern[bytes], data: bytes) -> set[bytes]:
    """The headers of directives, "" where they do not say one."""
    return {(match.group(1) or match.group(2) or b"").strip() for match in pattern.finditer(data)}
