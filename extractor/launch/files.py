"""The files that a launch file may read, and no others.

Launch files name files freely (`textfile="/etc/shadow"`). What is read ends up in a report, so only regular files below the package path,
in a package that was found there, or beside the launch file itself are read; links are followed before that is decided.
"""

from __future__ import annotations

import glob
import itertools
import os
import re
import stat
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar, cast

from rosarch.base import tracing
from rosarch.base.boundary import is_inside
from rosarch.base.files import LARGEST, read_file
from rosarch.extractor.launch.model import LaunchError, Reference
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.launch.references import references
from rosarch.extractor.launch.unknowns import cleaned
from rosarch.extractor.launch.xml_reader import read_launch
from rosarch.extractor.launch.yaml_values import KeyLines, Loader, RosparamLoader, load_yaml_lines

MAX_MATCHES = 1000
DESCRIBED = ".json"
"""What the name of a launch file ends with where its description takes its place."""
_Parsed = TypeVar("_Parsed")


class Files:
    """Reads files, each once. Relative names are below `folder`, as they are below roslaunch's working folder."""

    def __init__(self, packages: PackagePath, folder: str | None = None) -> None:
        self.packages = packages
        self.folder = folder or os.getcwd()
        self._suited: dict[tuple[int, tuple[str, ...]], Files] = {}
        self._roots: set[str] | None = None
        self._beside: set[str] = set()
        self._packages_of: dict[str, str] = {}
        self._real: dict[str, str] = {}
        self._contents: dict[str, bytes] = {}
        self._texts: dict[str, str] = {}
        self._documents: dict[tuple[str, object], Any] = {}
        self._references: dict[str, tuple[Reference, ...]] = {}
        self._values: dict[tuple[str, type[Loader]], tuple[Any, KeyLines]] = {}

    def of_ros(self, version: int, launch_file: Path | str) -> Files:
        """Reads files for a launch file of a version of ROS."""
        packages = self.packages.of_ros(version).near(os.path.join(self.folder, launch_file))
        if packages is self.packages:
            return self
        return self._suited.setdefault((version, tuple(packages.own.values())), Files(packages, self.folder))

    def allow_named(self, arguments: Mapping[str, str]) -> None:
        """Let the files be read that the user names by the values of launch arguments."""
        for value in arguments.values():
            full = os.path.join(self.folder, value)
            tracing.probe(full)
            if os.path.isfile(full):
                self._beside.add(self.real(full))

    def allow_beside(self, launch_file: str) -> None:
        """Allow the package that `launch_file` is in, or its folder when it is in none."""
        folder = os.path.dirname(self.real(launch_file))
        if folder not in self._packages_of:
            self._packages_of[folder] = _package_of(folder)
        self._beside.add(self._packages_of[folder])

    def real(self, path: str) -> str:
        """The path without links."""
        full = os.path.join(self.folder, path)
        if full not in self._real:
            self._real[full] = os.path.realpath(full)
        return self._real[full]

    def is_file(self, path: str) -> bool:
        """Whether there is such a file, be it readable here or not."""
        tracing.probe(full := os.path.join(self.folder, path))
        return os.path.isfile(full)

    def located(self, path: str) -> str:
        """Where a file is in the sources that is installed at `path`: packages may install it from elsewhere in their folder.

        Of a launch file of Python there may be the description alone that it makes.
        """
        folder = None if self.is_file(path) else self.packages.of_file(path)
        if folder is None or self.packages.fills(path):
            return path
        if self.is_file(described := f"{path}{DESCRIBED}"):
            return described
        words = os.path.relpath(path, folder).split(os.sep)[-2:]
        found = list(self.packages.paths_in(folder).get(words[-1], ()))
        if len(found) > 1:
            found = [other for other in found if other.split(os.sep)[-2:] == words]
        return found[0] if len(found) == 1 else path

    def read(self, path: str) -> bytes:
        """The content of a file.

        Raises:
            LaunchError: there is no such file, it must not be read, or it is too large.
        """
        full = os.path.join(self.folder, path)
        if full not in self._contents:
            self._contents[full] = self._read(full, path)
        return self._contents[full]

    def read_text(self, path: str) -> str:
        """The content of a UTF-8 file, with line ends as Python's text files have them."""
        try:
            text = self.read(path).decode()
        except UnicodeDecodeError as error:
            raise LaunchError("encoding", path, f"{path} is not UTF-8 (byte {error.start})") from None
        self._texts[path] = cleaned(text.replace("\r\n", "\n").replace("\r", "\n"))
        return self._texts[path]

    def with_text(self, text: str) -> str | None:
        """The file that has a text, if one alone has it of those that were read as texts."""
        found = [path for path, read in self._texts.items() if read == text]
        return found[0] if len(found) == 1 else None

    def parsed(self, path: str, parse: Callable[[bytes, str], _Parsed]) -> _Parsed:
        """What `parse` makes of the content of a file and its path, made once. It must not be changed.

        Raises:
            LaunchError: the file cannot be read.
        """
        key = (os.path.join(self.folder, path), parse)
        if key not in self._documents:
            self._documents[key] = parse(self.read(path), path)
        return cast(_Parsed, self._documents[key])

    def matching(self, pattern: str) -> list[str]:
        """The files that a shell pattern names, sorted, at most `MAX_MATCHES`.

        Raises:
            LaunchError: it looks outside the folders that may be read.
        """
        full = os.path.join(self.folder, pattern)
        base, *rest = re.split(r"[^/]*[*?\[]", full, maxsplit=1)
        if not self._is_allowed(os.path.realpath(base)) or any(".." in part.split("/") for part in rest):
            raise LaunchError("outside", pattern, f"{pattern} is outside the package path and not read")
        tracing.listed(base)
        return sorted(itertools.islice(glob.iglob(full), MAX_MATCHES))

    def references(self, path: str) -> tuple[Reference, ...]:
        """What a launch file that was read names."""
        full = os.path.join(self.folder, path)
        if full not in self._references:
            self._references[full] = tuple(dict.fromkeys(references(self.parsed(path, read_launch), path, self.packages)))
        return self._references[full]

    def yaml(self, text: str, loader: type[Loader] = RosparamLoader) -> tuple[Any, KeyLines]:
        """The value of a YAML text and the lines of its keys, parsed once: the same file is often loaded for many nodes. Not to be changed.

        Raises:
            YamlError: it is no YAML for parameters.
        """
        key = (text, loader)
        if key not in self._values:
            self._values[key] = load_yaml_lines(text, loader)
        return self._values[key]

    def _read(self, full: str, path: str) -> bytes:
        tracing.probe(full)
        try:
            status = os.stat(full)
        except (FileNotFoundError, NotADirectoryError):
            if self.packages.underlay.is_of_library(full):
                raise LaunchError("made", path, f"{path} is not among the files that the library has of its package") from None
            if self.packages.makes(full):
                raise LaunchError("made", path, f"{path} is made when its package is built") from None
            raise LaunchError("file", path, f"no such file: {path}") from None
        except (OSError, ValueError) as error:
            raise LaunchError("unreadable", path, f"{path} cannot be read: {getattr(error, 'strerror', None) or error}") from None
        if not stat.S_ISREG(status.st_mode):
            raise LaunchError("unreadable", path, f"{path} is not a regular file")
        if not self._is_allowed(self.real(full)):
            raise LaunchError("outside", path, f"{path} is outside the package path and not read")
        if status.st_size > LARGEST:
            tracing.read(full, status, None)
            raise LaunchError("size", path, f"{path} has more than {LARGEST >> 20} MiB and is not read")
        try:
            return read_file(full)
        except OSError as error:
            kind = "unreadable" if is_inside(full) else "outside"
            raise LaunchError(kind, path, f"{path} cannot be read: {error.strerror or error}") from None

    def _is_allowed(self, real: str) -> bool:
        if self._roots is None:
            folders = (*self.packages.folders, *self.packages.packages.values())
            self._roots = {os.path.realpath(folder) for folder in folders}
        return any(real == root or real.startswith(root.rstrip("/") + "/") for root in (*self._beside, *self._roots))


def _package_of(folder: str) -> str:
    """The folder of the package that a folder is in; itself when it is in none."""
    manifests = [above / "package.xml" for above in (Path(folder), *Path(folder).parents)]
    for manifest in manifests:
        tracing.probe(manifest)
    return next((str(manifest.parent) for manifest in manifests if os.path.isfile(manifest)), folder)
