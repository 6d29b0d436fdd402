"""What `rosarch launch` works on: files, arguments, the package path, the environment."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_folder

if TYPE_CHECKING:
    from rosarch.extractor.launch import Composition

_WORKSPACE_MARKS = (".catkin_workspace", ".catkin_tools", ".git", ".rosinstall")


def compose_files(words: Sequence[str], package_path: Sequence[Path] | None, environment: Sequence[str] | None) -> Composition:
    """Compose the launch files among `words`; the others are arguments, `name:=value`."""
    from rosarch.extractor.launch import Files, PackagePath, compose

    names = [word for word in words if ":=" not in word]
    arguments, namespace = _arguments([word for word in words if ":=" in word])
    if not names:
        raise InputError("no launch file given")
    for name in names:
        check_file(Path(name))
    variables = {**os.environ, **dict(map(_variable, environment or ()))}
    folders = [check_folder(folder) for folder in package_path] if package_path else _default_path(Path(names[0]), variables)
    launch_files = [os.path.abspath(name) for name in names]
    composition = compose(launch_files, arguments, files=Files(PackagePath(folders)), environment=variables, namespace=namespace)
    for problem in composition.problems:
        if problem.kind == "xml" and problem.subject in launch_files:
            raise InputError(str(problem).removeprefix(f"{Path.cwd()}/"))
    return composition


def check_file(file: Path) -> Path:
    """`file`, when it is one that can be read."""
    if not file.exists():
        raise InputError(f"{file}: no such file")
    if not file.is_file():
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


def _variable(text: str) -> tuple[str, str]:
    name, equals, value = text.partition("=")
    if not (name and equals):
        raise InputError(f"--env {text}: not of the form NAME=VALUE")
    return name, value


def _default_path(file: Path, variables: dict[str, str]) -> list[Path]:
    """The folders of ROS_PACKAGE_PATH; without it, the workspace that `file` lies in."""
    if variables.get("ROS_PACKAGE_PATH"):
        return [Path(folder) for folder in variables["ROS_PACKAGE_PATH"].split(":") if folder]
    above = file.resolve().parents
    package = next((folder for folder in above if (folder / "package.xml").is_file()), above[0])
    for folder in package.parents:
        if folder.name == "src" or any((folder / mark).exists() for mark in _WORKSPACE_MARKS):
            return [folder]
    return [package.parent if (package / "package.xml").is_file() else package]
