"""What is asked to be started together, and where: words of a command line or of a configuration."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.base import tracing
from rosarch.extractor.underlay import NOTHING_INSTALLED, Underlay

if TYPE_CHECKING:
    from rosarch.extractor.launch import Files

_COMMA = re.compile(r"(?<!\\),")


class LaunchWordError(ValueError):
    """A word that is no launch file and no argument; the text says why."""


@dataclass(frozen=True)
class LaunchEnvironment:
    """Where launch files are composed: the workspace, where packages are looked for, the robot's environment variables.

    The `underlay` has what is installed.
    """

    root: Path
    package_path: tuple[Path, ...]
    environment: Mapping[str, str]
    underlay: Underlay = NOTHING_INSTALLED

    def files(self) -> Files:
        """What reads launch files here."""
        from rosarch.extractor.launch import Files, PackagePath

        return Files(PackagePath(self.package_path, self.underlay))

    def variables(self) -> Mapping[str, str]:
        """The environment of launch files. roslaunch does not run without ROS_MASTER_URI."""
        path = os.pathsep.join([*map(os.path.abspath, self.package_path), *self.underlay.share_folders])
        return tracing.Variables({"ROS_MASTER_URI": "http://localhost:11311", "ROS_PACKAGE_PATH": path, **self.environment})


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
    from rosarch.extractor.launch.names import mapping

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


def _words(text: str) -> list[str]:
    try:
        return shlex.split(text)
    except ValueError as error:
        raise LaunchWordError(f"`{text}`: {str(error).lower()}") from None
