"""Where packages lie: the crawl of rospkg, which answers `$(find package)`.

This differs from the crawl of `extractor.workspace`, which follows the build tools: here only CATKIN_IGNORE hides, metapackages are no
packages, and a `manifest.xml` makes its folder a package of the folder's name. Packages below packages, which rospkg does not see and which
may be built all the same, come last. Sources: rospkg.rospack; roslaunch finds what rospkg finds.
Where rospkg depends on the order in which the file system lists folders, the alphabetical one counts.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from fnmatch import fnmatchcase
from functools import cached_property
from pathlib import Path

from rosarch.base import tracing
from rosarch.base.files import is_folder, read_file, text_or_nothing
from rosarch.extractor.launch.ignored import kept_out
from rosarch.extractor.package_names import IGNORE_MARKERS, NO_PACKAGES, quick_name, quick_text
from rosarch.extractor.underlay import NOTHING_INSTALLED, Underlay

_METAPACKAGE = re.compile(r"<metapackage\s*/?>")
_COLCON_MARKERS = ("COLCON_IGNORE", "AMENT_IGNORE")
_WORD = re.compile(r"[\w.+-]+")
_DEPENDENCY = re.compile(r"depend[^<>]*>\s*([^<\s]+)\s*<")
_PROJECT = re.compile(r"\bproject\s*\(\s*([\w.+-]+)", re.IGNORECASE)
_LINE_COMMENT = re.compile(r"#.*")
_BUILD_FILES = ("CMakeLists.txt", "setup.py")
_MAKING = re.compile(
    r"\b(?:(?:configure_file|add_custom_command|add_custom_target|execute_process|(xacro_add_files))\s*\("
    r"|file\s*\(\s*(?:WRITE|APPEND|GENERATE|CONFIGURE|DOWNLOAD|RENAME|COPY_FILE|CREATE_LINK)\b)((?:[^()]|\([^()]*\))*)",
    re.IGNORECASE,
)
"""The commands of CMake that make files, with their words."""
_SET = re.compile(r"\bset\s*\(\s*(\w+)\s+([^()]*)\)", re.IGNORECASE)
_VARIABLE = re.compile(r"\$\{(\w+)\}")
_PROGRAMS = (".py", ".sh")
_MAKES_FOLDERS = re.compile(r"\bmakedirs\b|\bmkdir\b")
_QUOTED = re.compile(r"""["']([^"'\n]+)["']""")
_CLASS = re.compile(r"""<class\b[^>]*?\bname\s*=\s*["']([^"'\n]+)["']""")
"""The name of a plug-in in its description."""
_MADE_WORD = re.compile(r"[\w.+*-]+")


class PackagePath:
    """The packages below some folders, then those of an underlay; the first that has a package wins."""

    def __init__(self, folders: Sequence[Path | str], underlay: Underlay = NOTHING_INSTALLED) -> None:
        self.folders = tuple(os.path.abspath(folder) for folder in folders)
        self._underlay = underlay
        self._left_out: dict[str, bool] = {}
        self._names: dict[str, frozenset[str]] = {}
        self._paths: dict[str, dict[str, list[str]]] = {}
        self._made: dict[str, frozenset[str]] = {}
        self._folders_made: dict[str, frozenset[str]] = {}
        self._described: dict[str, frozenset[str]] = {}

    @cached_property
    def packages(self) -> dict[str, str]:
        """The folder of each package: of one that is installed, its share folder."""
        return {**{name: package.share for name, package in self.underlay.packages.items()}, **self.own}

    @cached_property
    def underlay(self) -> Underlay:
        """What is installed of packages that none of the folders has."""
        return self._underlay.without(self.own)

    def of_ros(self, version: int) -> PackagePath:
        """The same packages, without those of libraries for another version of ROS."""
        underlay = self._underlay.of_ros(version)
        return self if underlay == self._underlay else self._with(underlay, self.own)

    def near(self, path: str) -> PackagePath:
        """The same packages, of several of one name the one that is nearest to a file: they are of different workspaces."""
        chosen = {name: max(folders, key=lambda one: len(os.path.commonpath([one, path]))) for name, folders in self._several.items()}
        own = {**self.own, **chosen}
        return self if own == self.own else self._with(self._underlay, own)

    def _with(self, underlay: Underlay, own: dict[str, str]) -> PackagePath:
        found = PackagePath(self.folders, underlay)
        found.own, found._found = own, self._found
        found._names, found._paths, found._made = self._names, self._paths, self._made
        found._folders_made, found._described = self._folders_made, self._described
        return found

    @cached_property
    def own(self) -> dict[str, str]:
        """The packages of the folders."""
        return dict(reversed(self._found))

    @cached_property
    def _found(self) -> list[tuple[str, str]]:
        """All of them with their folders, those first that count."""
        roots = tuple(os.path.realpath(folder).rstrip("/") + "/" for folder in self.folders)
        everything = [package for folder in self.folders for package in _packages_below(folder, roots)]
        return sorted(everything, key=lambda package: self.is_left_out(package[1]))

    @cached_property
    def _several(self) -> dict[str, list[str]]:
        """The folders of the packages whose name others have, too, but for those that are not built."""
        folders: dict[str, list[str]] = {}
        for name, folder in self._found:
            if not self.is_left_out(folder):
                folders.setdefault(name, []).append(folder)
        return {name: found for name, found in folders.items() if len(found) > 1}

    def is_left_out(self, folder: str) -> bool:
        """Whether a package is in a folder that colcon does not build."""
        if folder not in self._left_out:
            marked = any(os.path.exists(f"{folder}/{marker}") for marker in _COLCON_MARKERS)
            top = folder in self.folders or folder == "/"
            self._left_out[folder] = marked or (not top and self.is_left_out(os.path.dirname(folder)))
        return self._left_out[folder]

    def find(self, name: str) -> str | None:
        """The folder of package `name`."""
        return self.packages.get(name)

    def of_file(self, path: str) -> str | None:
        """The folder of the package that a file is in, the innermost."""
        return max((folder for folder in self.packages.values() if path.startswith(folder + os.sep)), key=len, default=None)

    def is_named(self, name: str) -> bool:
        """Whether the manifest of a package of the folders names another package as one that it needs."""
        return name in self._needed

    @cached_property
    def _needed(self) -> frozenset[str]:
        """The packages that the manifests of the folders name."""
        texts = (quick_text(f"{folder}/package.xml") or "" for folder in self.own.values())
        return frozenset(name for text in texts for name in _DEPENDENCY.findall(text))

    def names_in(self, folder: str) -> frozenset[str]:
        """The names of the files below a package's folder, and all words of its build files: what its programs may be called.

        Of one that is installed, the names of its programs, and all words of the index about it.
        """
        if folder not in self._names:
            found = set(_names_and_words(self.paths_in(folder)))
            installed = self.underlay.of_share(folder)
            if installed is not None:
                found.update(installed.programs(), *(_WORD.findall(text) for _, text in installed.resources()))
            self._names[folder] = frozenset(found)
        return self._names[folder]

    def installing_module(self, name: str) -> Iterator[str]:
        """The folders in which packages have the Python package called so, and install it: their build files name it."""
        for folder in self.own.values():
            for root in (folder, f"{folder}/src"):
                if os.path.isfile(f"{root}/{name}/__init__.py") and name in self.names_in(folder):
                    yield root

    def describing(self, plugin: str) -> str | None:
        """The package of the folders that has a description of the plug-in called so."""
        return next((package for package, folder in self.own.items() if plugin in self._described_in(folder)), None)

    def _described_in(self, folder: str) -> frozenset[str]:
        """The names of the plug-ins that files of a package describe."""
        if folder not in self._described:
            files = (path for name, paths in self.paths_in(folder).items() if name.endswith(".xml") for path in paths)
            self._described[folder] = frozenset(name for path in files for name in _CLASS.findall(text_or_nothing(path)))
        return self._described[folder]

    def makes(self, path: str) -> bool:
        """Whether the file is made: by its package, from a template beside it or by a command that names it, or on each machine.

        Of packages of a library there may be more than it has.
        """
        if self.underlay.is_of_library(path):
            return True
        tracing.probe(f"{path}.in")
        if os.path.isfile(f"{path}.in"):
            return True
        folder = self.of_file(path)
        if folder is not None and any(fnmatchcase(os.path.basename(path), name) for name in self._made_in(folder)):
            return True
        if self.fills(path):
            return True
        return any(kept_out(path, top) for top in self.folders if path.startswith(top + os.sep))

    def fills(self, path: str) -> bool:
        """Whether a program of the package makes the folder that the file is to be in, which is not there yet."""
        folder, absent = self.of_file(path), os.path.dirname(path)
        if folder is None or os.path.isdir(absent):
            return False
        while not os.path.isdir(above := os.path.dirname(absent)):
            absent = above
        return os.path.basename(absent) in self._folders_made_in(folder)

    def _folders_made_in(self, folder: str) -> frozenset[str]:
        """The words of the programs of a package that make folders."""
        if folder not in self._folders_made:
            paths = self.paths_in(folder)
            programs = (text_or_nothing(path) for name in paths if name.endswith(_PROGRAMS) for path in paths[name])
            texts = (text for program in programs if _MAKES_FOLDERS.search(program) for text in _QUOTED.findall(program))
            self._folders_made[folder] = frozenset(name for text in texts for name in text.split("/"))
        return self._folders_made[folder]

    def _made_in(self, folder: str) -> frozenset[str]:
        if folder not in self._made:
            paths = self.paths_in(folder)
            build_files = (path for name in paths if name == "CMakeLists.txt" or name.endswith(".cmake") for path in paths[name])
            self._made[folder] = frozenset(name for path in build_files for name in _made_by(path))
        return self._made[folder]

    def paths_in(self, folder: str) -> Mapping[str, Sequence[str]]:
        """The paths of the files below a package's folder, by their names; ignore markers hide copies that are built or installed there."""
        if folder not in self._paths:
            found: dict[str, list[str]] = {}
            for here, folders, names in os.walk(folder):
                tracing.names(here)
                if here != folder and not IGNORE_MARKERS.isdisjoint(names):
                    folders.clear()
                    continue
                folders[:] = sorted(name for name in folders if not name.startswith("."))
                for name in names:
                    found.setdefault(name, []).append(os.path.join(here, name))
            self._paths[folder] = found
        return self._paths[folder]


def _names_and_words(paths: Mapping[str, Sequence[str]]) -> frozenset[str]:
    found = set(paths)
    for name in paths:
        if name in _BUILD_FILES or name.endswith(".cmake"):
            found.update(*map(_words_of, paths[name]))
    return frozenset(found)


def _text_of(build_file: str) -> str:
    try:
        text = read_file(build_file).decode(errors="replace")
    except OSError:
        return ""  # where it is evaluated, that is reported
    text = _LINE_COMMENT.sub("", text)
    project = _PROJECT.search(text)
    return text.replace("${PROJECT_NAME}", project[1]) if project else text


def _words_of(build_file: str) -> list[str]:
    return _WORD.findall(_text_of(build_file))


def _made_by(build_file: str) -> Iterator[str]:
    """The names of the files that commands make or use, with `*` for variables whose values are not known."""
    text = _text_of(build_file)
    values = dict(_SET.findall(text))
    for expands, words in _MAKING.findall(text):
        for word in _MADE_WORD.findall(_with_values(words, values)):
            name = word.removesuffix(".xacro") if expands else word
            if name.strip("*."):
                yield name


def _with_values(words: str, values: Mapping[str, str], depth: int = 4) -> str:
    def value(match: re.Match[str]) -> str:
        return _with_values(values[match[1]], values, depth - 1) if depth and match[1] in values else "*"

    return _VARIABLE.sub(value, words)


def _packages_below(top: str, roots: tuple[str, ...]) -> Iterator[tuple[str, str]]:
    """Name and folder of each package; links that lead out of all `roots` are not followed."""
    visited = {os.path.realpath(top)}
    inner: list[tuple[str, str]] = []
    stack = [(top, False)]
    while stack:
        folder, inside = stack.pop()
        try:
            with os.scandir(folder) as scan:
                entries = sorted(scan, key=lambda entry: entry.name, reverse=True)
        except OSError:
            continue
        names = {entry.name for entry in entries if _is_file(entry)}
        if "CATKIN_IGNORE" in names:
            continue
        if "package.xml" in names and not _is_metapackage(f"{folder}/package.xml"):
            name = quick_name(f"{folder}/package.xml")
            if name and inside:
                inner.append((name, folder))
            elif name:
                yield name, folder
        elif "manifest.xml" in names:
            yield os.path.basename(folder), folder
        if names & {"manifest.xml", "rospack_nosubdirs"} or folder.startswith("/usr/share/"):
            continue
        inside |= "package.xml" in names
        if inside and os.path.basename(os.path.dirname(folder)) == "share":
            continue  # installed
        for entry in entries:
            if entry.name.startswith(".") or (inside and entry.name in NO_PACKAGES) or not is_folder(entry):
                continue
            if entry.is_symlink():
                real = os.path.realpath(entry.path)
                if real in visited or f"{folder}/".startswith(real + "/") or not f"{real}/".startswith(roots):
                    continue
                visited.add(real)
            stack.append((entry.path, inside))
    yield from inner


def _is_file(entry: os.DirEntry[str]) -> bool:
    """Whether this is a regular file: reading another kind might never end."""
    try:
        return entry.is_file()
    except OSError:
        return False


def _is_metapackage(manifest: str) -> bool:
    return _METAPACKAGE.search(quick_text(manifest) or "") is not None
