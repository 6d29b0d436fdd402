"""What `<param command="...">` prints, for the commands that can be answered without running anything.

Sources: the manual pages of cat(1), echo(1), mkdir(1); rosversion of rospkg.
"""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Mapping
from pathlib import Path

from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.model import LaunchError
from rosarch.extractor.launch.unknowns import is_known

_ECHO_OPTION = re.compile(r"-[neE]+|--help|--version")
_SILENT = frozenset({"mkdir", "touch", "true", "sleep"})


def words_of(command: str) -> list[str]:
    """The words of a command, as roslaunch splits them.

    Raises:
        LaunchError: a quote is not closed, or there is no word.
    """
    try:
        words = shlex.split(command)
    except ValueError as error:
        raise LaunchError("command", command, f"command `{command}`: {str(error).lower()}") from None
    if not words:
        raise LaunchError("command", command, "the command is empty")
    return words


def output(words: list[str], files: Files, environment: Mapping[str, str]) -> str | None:
    """What the command prints, or None when only running it could show.

    Raises:
        LaunchError: the command certainly fails, because a file or package that it needs is not there.
    """
    program, *arguments = words
    if not all(map(is_known, words)):
        return None
    if program == "echo" and not any(map(_ECHO_OPTION.fullmatch, arguments)):
        return " ".join(arguments) + "\n"
    if program == "cat" and arguments and not any(word.startswith("-") for word in arguments):
        return "".join(files.read_text(word) for word in arguments)
    if program in _SILENT and not {"-v", "--verbose", "--help", "--version"} & set(arguments):
        return ""
    if program == "rosversion" and len(arguments) == 1:
        return _version(arguments[0], files, environment)
    return None


def _version(name: str, files: Files, environment: Mapping[str, str]) -> str | None:
    """What `rosversion` prints: the version of a package, or the distribution."""
    if name in ("-d", "--distro"):
        return environment["ROS_DISTRO"] + "\n" if "ROS_DISTRO" in environment else None
    folder = files.packages.find(name)
    if folder is None:
        return None
    from rosarch.extractor.workspace.manifests import read_manifest

    manifest, _problems = read_manifest(Path(os.path.join(folder, "package.xml")))
    return manifest.version + "\n" if manifest and manifest.version else None
