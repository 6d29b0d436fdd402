"""Finding the headers that a source includes, and standing in for those that are not there."""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from rosarch.extractor import observation
from rosarch.extractor.cache import hash_of
from rosarch.extractor.files import read_file

SHIPPED = Path(__file__).parent / "headers"
SHIPPED_DIRS = (SHIPPED / "ros", SHIPPED / "third_party", SHIPPED / "std")
_SHIPPED_PREFIX = f"{SHIPPED}{os.sep}"
PRELUDE = SHIPPED / "prelude.h"
CUDA_PRELUDE = SHIPPED / "prelude_cuda.h"

_INCLUDE = re.compile(rb"^[ \t]*#[ \t]*include[ \t]*(?:<([^>\n]+)>|\"([^\"\n]+)\")", re.MULTILINE)
_UNPREDICTABLE = re.compile(  # a macro's include; a directive that is not written as `_INCLUDE` expects; what another run may see otherwise
    rb"^[ \t]*#[ \t]*include(?:_next)?[ \t]*[A-Za-z_\\/]|^[ \t]*#[ \t]*[a-z]*(?:\\\r?\n|/\*)|^[ \t]*(?:%:|\?\?=)"
    rb"|\*/[ \t]*#[ \t]*[i\\]|__has_include|__DATE__|__TIME",
    re.MULTILINE,
)
_MESSAGE_HEADER = re.compile(r"([a-z][a-z0-9_]*)/([A-Z]\w*)\.h")
_HEADER_SUFFIXES = (".h", ".hpp", ".hh", ".hxx", ".ipp", ".inl", ".tcc", ".cuh")


@dataclass(frozen=True)
class Missing:
    """An include that nothing provides."""

    file: Path
    line: int
    header: str


@dataclass(frozen=True)
class _Found:
    """What an include leads to: a file to go on with, the folder to search for it beyond the usual ones, or what nothing provides."""

    file: Path | None = None
    folder: Path | None = None
    missing: Missing | None = None


_Folders = tuple[tuple[Path, ...], tuple[Path, ...]]
"""Those that a source is compiled with, and those of installed headers."""


@dataclass
class Includes:
    """What one source includes, directly and through others; `made` are the folders of generated and absent headers.

    A source is not `predictable` when macros decide what it includes: what it depends on is then not known in full.
    """

    made: list[Path] = field(default_factory=list)
    files: Collection[Path] = ()
    missing: list[Missing] = field(default_factory=list)
    predictable: bool = True


class HeaderFinder:
    """Resolves includes against a workspace; what has to be made is written below `scratch`.

    `message_header` gives the text of a generated header by the name that code includes it by, else None. Headers that no folder of a
    source has are looked for in all of the workspace when it is `searched`.
    """

    def __init__(self, root: Path, scratch: Path, message_header: Callable[[str], str | None], *, searched: bool = True) -> None:
        self.root = root
        self.scratch = scratch
        self.message_header = message_header
        self._by_name: dict[str, list[Path]] | None = None if searched else {}
        self._included: dict[Path, list[tuple[int, str, bool]]] = {}
        self._digests: dict[Path, bytes] = {}
        self._unpredictable: set[Path] = set()
        self._exists: dict[str, bool] = {}
        self._made: dict[str, Path | None] = {}
        self._found: dict[tuple[_Folders, Path], list[_Found]] = {}
        self._stamps: dict[Path, str] = {}

    def closure(self, source: Path, include_dirs: Sequence[Path], installed: Sequence[Path] = ()) -> Includes:
        """Find all that `source` includes, making what is generated or absent.

        Headers of `installed` folders are taken only when the workspace, rosarch and message definitions have none: what the rules know
        is declared the same way everywhere.
        """
        result = Includes()
        extra: dict[Path, None] = {}
        seen = {source}
        queue = [source]
        folders = (tuple(include_dirs), tuple(installed))
        while queue:
            file = queue.pop()
            for found in self._found_in(file, folders):
                if found.folder is not None:
                    extra[found.folder] = None
                if found.missing is not None:
                    result.missing.append(found.missing)
                if found.file is not None and found.file not in seen:
                    seen.add(found.file)
                    queue.append(found.file)
        result.files = seen
        result.made = sorted(extra)
        result.predictable = self._unpredictable.isdisjoint(seen)
        if not result.predictable:
            observation.uncertain()
        return result

    def fingerprint(self, includes: Includes) -> str:
        """A hash of what `closure` found: which files, with what content, and what is missing; the same wherever the workspace lies."""
        parts = ["".join(sorted(map(self._stamp, includes.files)))]
        parts += [f"{self._name(missing.file)}:{missing.line} {missing.header}" for missing in includes.missing]
        parts += [self._name(folder) for folder in includes.made]
        return hash_of(parts)

    def _stamp(self, path: Path) -> str:
        """A hash of the name and the content of a file."""
        if path not in self._stamps:
            self._stamps[path] = hash_of([self._name(path), self._digests.get(path, b"")])
        return self._stamps[path]

    def _name(self, path: Path) -> str:
        """A path relative to the workspace, to what is made for it, or to what rosarch brings."""
        for mark, folder in (("", self.root), ("made:", self.scratch), ("shipped:", SHIPPED)):
            if path.is_relative_to(folder):
                return mark + path.relative_to(folder).as_posix()
        return str(path)

    def _includes_of(self, file: Path) -> list[tuple[int, str, bool]]:
        if file not in self._included:
            try:
                data = read_file(file)
            except OSError:
                data = b""
            self._digests[file] = hashlib.sha256(data).digest()
            if _UNPREDICTABLE.search(data) and not file.is_relative_to(SHIPPED):
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
            if not path.startswith(_SHIPPED_PREFIX):
                observation.probe(path)
            known = self._exists[path] = os.path.isfile(path)
        return known

    def _found_in(self, file: Path, folders: _Folders) -> list[_Found]:
        """What the includes of a file lead to; the same for all sources that look in the same folders."""
        key = (folders, file)
        if key not in self._found:
            self._found[key] = [self._resolve(file, name, quoted, folders, line) for line, name, quoted in self._includes_of(file)]
        return self._found[key]

    def _resolve(self, file: Path, name: str, quoted: bool, folders: _Folders, line: int) -> _Found:
        if name.startswith("/"):
            return _Found(Path(name)) if self._is_file(name) else _Found()
        if quoted and self._is_file(beside := os.path.join(file.parent, name)):
            return _Found(Path(os.path.normpath(beside)))
        for folder in folders[0]:
            if self._is_file(path := os.path.join(folder, name)):
                return _Found(Path(os.path.normpath(path)))
        for folder in SHIPPED_DIRS:
            if self._is_file(path := os.path.join(folder, name)):
                return _Found(Path(path))  # it may include messages in turn
        made = self._generated(name)
        if made is not None:
            return _Found(made, self.scratch / "messages")
        for folder in folders[1]:
            if self._is_file(path := os.path.join(folder, name)):
                return _Found(Path(path), self._forward(name, Path(path)))
        elsewhere = self._elsewhere(file, name)
        if elsewhere is not None:
            return _Found(elsewhere, self._forward(name, elsewhere))
        return _Found(None, self._absent(name), Missing(file, line, name))

    def _generated(self, name: str) -> Path | None:
        if name not in self._made:
            text = self.message_header(name)
            self._made[name] = self._write("messages", name, text) if text is not None else None
        return self._made[name]

    def _elsewhere(self, file: Path, name: str) -> Path | None:
        """The header of the tree whose path ends in `name`; of several, the one nearest to the including file."""
        if self._by_name is None:
            self._by_name = _headers_below(self.root)
        suffix = "/" + os.path.normpath(name).lstrip("./")
        candidates = [path for path in self._by_name.get(os.path.basename(name), ()) if str(path).endswith(suffix)]
        if not candidates:
            return None
        return max(candidates, key=lambda path: (len(os.path.commonpath([path, file])), -len(str(path)), str(path)))

    def _forward(self, name: str, target: Path) -> Path:
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
            match = _MESSAGE_HEADER.fullmatch(name)
            self._made[key] = self._write(folder, name, _assumed_message(*match.groups()) if match else "")
        return self.scratch / folder

    def _write(self, folder: str, name: str, text: str) -> Path:
        path = self.scratch / folder / name
        if not path.resolve().is_relative_to(self.scratch.resolve()):  # a name with ../ in it
            path = self.scratch / folder / path.name
        if not path.is_file():
            path.parent.mkdir(parents=True, exist_ok=True)
            temporary = path.with_name(f"{path.name}.{os.getpid()}")
            temporary.write_text(text, encoding="utf-8", errors="surrogateescape")
            temporary.replace(path)
        return path


def assumed_message_class(header: str) -> tuple[str, str] | None:
    """The (C++ class, `pkg/Name`) that a missing header named like a message's is taken to declare."""
    match = _MESSAGE_HEADER.fullmatch(header)
    return (f"{match.group(1)}::{match.group(2)}_", f"{match.group(1)}/{match.group(2)}") if match else None


def _assumed_message(package: str, name: str) -> str:
    """A message, service or configuration of which only the name is known."""
    return (
        "#pragma once\n#include <ros/message_prelude.h>\n"
        f"namespace {package} {{\nstruct {name}_ {{\n"
        f"  typedef boost::shared_ptr<{name}_> Ptr;\n  typedef boost::shared_ptr<{name}_ const> ConstPtr;\n"
        f"  typedef {name}_ Request;\n  typedef {name}_ Response;\n  int request;\n  int response;\n}};\n"
        f"typedef {name}_ {name};\ntypedef boost::shared_ptr<{name}_> {name}Ptr;\n"
        f"typedef boost::shared_ptr<{name}_ const> {name}ConstPtr;\n}}\n"
    )


def _headers_below(root: Path) -> dict[str, list[Path]]:
    """All headers below a folder by base name; hidden folders and symbolic links to folders are left out."""
    found: dict[str, list[Path]] = {}
    stack = [str(root)]
    while stack:
        try:
            entries = sorted(os.scandir(stack.pop()), key=lambda entry: entry.name)
        except OSError:
            continue
        for entry in entries:
            if entry.is_dir(follow_symlinks=False):
                if not entry.name.startswith("."):
                    stack.append(entry.path)
            elif entry.name.endswith(_HEADER_SUFFIXES):
                found.setdefault(entry.name, []).append(Path(entry.path))
    return found
