"""What of a workspace is started together: the launch files that were named, or those that no other includes."""

from __future__ import annotations

import itertools
import os
import re
import shlex
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from rosarch.extractor.launch import Files, PackagePath, compose, launch_files, top_level
from rosarch.extractor.launch.names import mapping
from rosarch.models.system.analysis import Launch

_COMMA = re.compile(r"(?<!\\),")
MAX_MATRIX = 256  # systems of one launch with several values for its arguments


class LaunchWordError(ValueError):
    """A word that is no launch file and no argument; the text says why."""


@dataclass(frozen=True)
class Surroundings:
    """Where launch files are composed: the workspace, where packages are looked for, the robot's environment variables."""

    root: Path
    package_path: tuple[Path, ...]
    environment: Mapping[str, str]

    def files(self) -> Files:
        """What reads launch files here."""
        return Files(PackagePath(self.package_path))

    def variables(self) -> dict[str, str]:
        """The environment of launch files. roslaunch does not run without ROS_MASTER_URI."""
        path = os.pathsep.join(map(os.path.abspath, self.package_path))
        return {"ROS_MASTER_URI": "http://localhost:11311", "ROS_PACKAGE_PATH": path, **self.environment}


@dataclass(frozen=True)
class Request:
    """Launch files that are started together; every combination of the values of `arguments` is a launch."""

    files: tuple[str, ...]
    arguments: tuple[tuple[str, tuple[str, ...]], ...] = ()


def parse_request(text: str) -> Request:
    r"""Launch files and arguments in one text, as on a command line. `name:=a,b` are two values of an argument (`\,` is a comma).

    Raises:
        LaunchWordError: there is no file, or a word is not of the form NAME:=VALUE.
    """
    words = _words(text)
    files = tuple(word for word in words if ":=" not in word)
    if not files:
        raise LaunchWordError(f"`{text}` names no launch file")
    arguments = {}
    for word in words:
        if ":=" in word:
            pair = mapping(word)
            if pair is None:
                raise LaunchWordError(f"{word}: not of the form NAME:=VALUE")
            arguments[pair[0]] = tuple(value.replace("\\,", ",") for value in _COMMA.split(pair[1]))
    return Request(files, tuple(arguments.items()))


def given(requests: Iterable[Request], where: Surroundings) -> list[Launch]:
    """The launches of requests. Files are absolute, or below the current folder or the workspace.

    Raises:
        LaunchWordError: a file is not there, or there are too many launches.
    """
    found = []
    for request in requests:
        paths = [_path(word, where.root) for word in request.files]
        names = [name for name, _ in request.arguments]
        combinations = list(itertools.islice(itertools.product(*(values for _, values in request.arguments)), MAX_MATRIX + 1))
        if len(combinations) > MAX_MATRIX:
            raise LaunchWordError(f"more than {MAX_MATRIX} combinations of arguments")
        found += [_launch(paths, dict(zip(names, values, strict=True)), where) for values in combinations]
    return found


def _words(text: str) -> list[str]:
    try:
        return shlex.split(text)
    except ValueError as error:
        raise LaunchWordError(f"`{text}`: {str(error).lower()}") from None


def unincluded(where: Surroundings) -> list[Launch]:
    """A launch for each launch file of the workspace that no other includes."""
    files = where.files()
    found = top_level(launch_files(os.path.abspath(where.root)), files, where.variables())
    return [Launch(_shown(path, where.root), (_shown(path, where.root),), composed, files.packages) for path, composed in found.items()]


def _path(word: str, root: Path) -> str:
    for path in (Path(word), root / word):
        if path.is_file():
            return os.path.abspath(path)
    raise LaunchWordError(f"{word}: no such launch file, neither here nor below {root}")


def _launch(paths: Sequence[str], arguments: Mapping[str, str], where: Surroundings) -> Launch:
    files = where.files()
    composition = compose(paths, arguments, files=files, environment=where.variables())
    words = (*(_shown(path, where.root) for path in paths), *(f"{name}:={value}" for name, value in arguments.items()))
    return Launch(" ".join(words), words, composition, files.packages)


def _shown(path: str, root: Path) -> str:
    inside = os.path.relpath(path, os.path.abspath(root))
    return path if inside.startswith("..") else inside
