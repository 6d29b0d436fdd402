"""The options that several sub-commands have."""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.errors import InputError

if TYPE_CHECKING:
    from rosarch.extractor.underlay import Underlay


class Engine(str, Enum):
    """The Datalog engines."""

    embedded = "embedded"
    souffle = "souffle"


class Format(str, Enum):
    """The formats of a report on stdout."""

    table = "table"
    json = "json"
    markdown = "markdown"


class MachineFormat(str, Enum):
    """The formats of a state machine on stdout."""

    text = "text"
    mermaid = "mermaid"
    dot = "dot"
    plantuml = "plantuml"
    scxml = "scxml"
    json = "json"


class ModelFormat(str, Enum):
    """The formats of whole component models on stdout."""

    table = "table"
    json = "json"


def path_argument(text: str) -> Path:
    """A path as it was given; an empty one is a variable that was not set, hardly the current folder."""
    if not text:
        raise typer.BadParameter("an empty path")
    return Path(text)


Folder = Annotated[
    Path, typer.Argument(parser=path_argument, metavar="DIR", help="A folder with ROS packages at any depth.", show_default=False)
]
Input = Annotated[
    Path,
    typer.Argument(
        parser=path_argument, metavar="DIR", help="A folder with ROS packages, or facts that `rosarch extract` wrote.", show_default=False
    ),
]
Packages = Annotated[
    list[str] | None,
    typer.Option("--package", "-p", metavar="NAME", help="Only this package and what it needs; may be repeated.", show_default=False),
]
Jobs = Annotated[int | None, typer.Option("--jobs", "-j", metavar="N", min=1, help="Worker processes; one per processor by default.")]
Defines = Annotated[
    list[str] | None,
    typer.Option("--define", "-D", metavar="K=V", help="A CMake cache variable, e.g. CUDA_FOUND=0; may be repeated.", show_default=False),
]


def _limited(seconds: float) -> float:
    from rosarch.base.limits import LIMITS

    LIMITS.set_source_seconds(seconds)
    return seconds


Timeout = Annotated[
    float,
    typer.Option(
        "--timeout",
        metavar="SECONDS",
        min=0.001,
        callback=_limited,
        help="The time limit of one source file; the rules of a component or system have five times as long.",
    ),
]
Cached = Annotated[bool, typer.Option("--cache/--no-cache", help="Cache what is read from the sources, and read only what has changed.")]
EngineChoice = Annotated[Engine, typer.Option("--engine", help="What evaluates the rules; souffle must be on PATH.")]
Libraries = Annotated[
    list[Path] | None,
    typer.Option(
        "--library",
        parser=path_argument,
        metavar="DIR",
        help="A folder of library files that come before rosarch's own; may be repeated.",
        show_default=False,
    ),
]
Underlays = Annotated[
    list[Path] | None,
    typer.Option(
        "--underlay",
        parser=path_argument,
        metavar="DIR",
        help="Where packages are installed that DIR does not have, such as /opt/ros/humble; may be repeated."
        " By default what the environment names.",
        show_default=False,
    ),
]
NoUnderlay = Annotated[bool, typer.Option("--no-underlay", help="Read nothing that is installed, whatever the environment names.")]
Verbose = Annotated[bool, typer.Option("--verbose", "-v", help="Show every diagnostic.")]


def installed(folders: Iterable[Path] | None, *, none: bool) -> Underlay:
    """The underlay that the options name, or else the environment."""
    import os

    from rosarch.extractor.underlay import Underlay, environment_underlay, prefixes_in

    given = list(folders or ())
    if given and none:
        raise InputError("--underlay and --no-underlay contradict each other")
    for folder in given:
        if not prefixes_in(folder):
            raise InputError(f"--underlay {folder}: no package is installed there: no share/NAME/package.xml")
    if given or none:
        return Underlay.of(given)
    return environment_underlay(os.environ)


def parse_defines(defines: Iterable[str] | None) -> dict[str, str]:
    """The variables of `--define`."""
    return parse_pairs("--define", defines)


def parse_environment(variables: Iterable[str] | None) -> dict[str, str]:
    """The variables of `--env`."""
    return parse_pairs("--env", variables)


def parse_pairs(option: str, texts: Iterable[str] | None) -> dict[str, str]:
    """`NAME=VALUE` texts as a mapping; the last of one name counts."""
    result = {}
    for text in texts or ():
        name, equals, value = text.partition("=")
        if not (name and equals):
            raise InputError(f"{option} {text}: not of the form NAME=VALUE")
        result[name] = value
    return result
