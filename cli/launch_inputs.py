"""What `rosarch launch` works on: files, arguments, the package path, the environment."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_folder
from rosarch.cli.options import parse_environment

if TYPE_CHECKING:
    from rosarch.extractor.launch import Composition
    from rosarch.extractor.underlay import Underlay

_WORKSPACE_MARKS = (".catkin_workspace", ".catkin_tools", ".git", ".rosinstall")


def is_folder(words: Sequence[str]) -> bool:
    """Whether a folder was given, and no file."""
    return len(words) == 1 and os.path.isdir(words[0])


@dataclass(frozen=True)
class Surroundings:
    """Where packages are looked for, the environment variables that are given, what is installed."""

    package_path: Sequence[Path] | None
    environment: Sequence[str] | None
    underlay: Underlay


def compose_folder(words: Sequence[str], around: Surroundings) -> dict[str, Composition]:
    """Compose each launch file below a folder that no other includes."""
    from rosarch.extractor.launch import Files, PackagePath, launch_files, top_level

    folder = check_folder(Path(words[0]))
    variables = _variables(around.environment)
    files = Files(PackagePath(_package_path(around, [folder], variables), around.underlay))
    found = top_level(launch_files(os.path.abspath(folder)), files, variables)
    if not found:
        raise InputError(f"{folder}: no launch file below this folder")
    return found


def compose_words(words: Sequence[str], around: Surroundings) -> Composition:
    """Compose the launch files among `words`; the others are arguments, `name:=value`.

    With ROS_VERSION of 2 among the variables that are given, `ros2 launch` starts them, whatever they are written for.
    """
    from rosarch.extractor.launch import Files, PackagePath, compose

    names = [word for word in words if ":=" not in word]
    arguments, namespace = _arguments([word for word in words if ":=" in word])
    if not names:
        raise InputError("no launch file given")
    launch_files = [os.path.abspath(check_file(Path(name))) for name in names]
    variables = _variables(around.environment)
    files = Files(PackagePath(_package_path(around, _default_path(Path(names[0]), variables), variables), around.underlay))
    version = 2 if parse_environment(around.environment).get("ROS_VERSION") == "2" else None
    composition = compose(launch_files, arguments, files=files, environment=variables, namespace=namespace, version=version)
    for problem in composition.problems:
        if problem.kind == "xml" and problem.subject in launch_files:
            raise InputError(str(problem).removeprefix(f"{Path.cwd()}/"))
    return composition


def check_file(file: Path) -> Path:
    """`file`, when it is one that can be read."""
    if not os.path.exists(file):
        raise InputError(f"{file}: no such file")
    if not os.path.isfile(file):
        raise InputError(f"{file}: not a file")
    if not os.access(file, os.R_OK):
        raise InputError(f"{file}: no permission to read this file")
    return file


def _arguments(words: Sequence[str]) -> tuple[dict[str, str], str | None]:
    """The values of launch arguments, and the namespace of `__ns:=`."""
    from rosarch.extractor.launch.names import mapping

    pairs: dict[str, str] = {}
    for word in words:
        pair = mapping(word)
        if pair is None:
            raise InputError(f"{word}: not of the form NAME:=VALUE")
        pairs[pair[0]] = pair[1]
    namespace = pairs.pop("__ns", None)
    if namespace is not None and namespace.startswith("~"):
        raise InputError(f"__ns:={namespace}: a namespace cannot be a private name")
    return pairs, namespace


def _variables(given: Sequence[str] | None) -> dict[str, str]:
    """The environment of this process, with the variables given. roslaunch does not run without ROS_MASTER_URI."""
    return {"ROS_MASTER_URI": "http://localhost:11311", **os.environ, **parse_environment(given)}


def _package_path(around: Surroundings, default: list[Path], variables: dict[str, str]) -> list[Path]:
    """Where packages are looked for; launch files see the same in ROS_PACKAGE_PATH."""
    folders = [check_folder(folder) for folder in around.package_path or default]
    variables["ROS_PACKAGE_PATH"] = ":".join([*map(os.path.abspath, folders), *around.underlay.share_folders])
    return folders


def _default_path(file: Path, variables: dict[str, str]) -> list[Path]:
    """The folders of ROS_PACKAGE_PATH that hold sources; without any, the workspace that `file` is in."""
    from rosarch.extractor.underlay import source_folders

    sources = source_folders(variables)
    if sources:
        return sources
    above = Path(os.path.abspath(file)).parents
    package = next((folder for folder in above if os.path.isfile(folder / "package.xml")), above[0])
    for folder in package.parents:
        if folder.name == "src" or any(os.path.exists(folder / mark) for mark in _WORKSPACE_MARKS):
            return [folder]
    return [package.parent if os.path.isfile(package / "package.xml") else package]
