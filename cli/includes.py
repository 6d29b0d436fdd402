"""`rosarch show includes`: which launch file includes which."""

from __future__ import annotations

from enum import Enum
from typing import Annotated

import typer

from rosarch.cli.delivery import Out, deliver, systems_of
from rosarch.cli.options import Cached, Defines, Engine, EngineChoice, Folder, Jobs, Libraries, Timeout, Verbose, parse_defines
from rosarch.cli.systems import Environment, Launches, PackagePath, SystemInputs
from rosarch.cli.terminal import emit


class TreeFormat(str, Enum):
    """The formats of a tree of launch files."""

    text = "text"
    json = "json"
    dot = "dot"


def includes(
    folder: Folder,
    launches: Launches = None,
    output_format: Annotated[TreeFormat, typer.Option("--format", help="The form of the tree.")] = TreeFormat.text,
    out: Out = None,
    package_path: PackagePath = None,
    environment: Environment = None,
    libraries: Libraries = None,
    engine: EngineChoice = Engine.embedded,
    jobs: Jobs = None,
    defines: Defines = None,
    timeout: Timeout = 60.0,
    cached: Cached = True,
    verbose: Verbose = False,
) -> None:
    """Show which launch file includes which, and the nodes that each of them starts."""
    from rosarch.reports.include_tree import tree_dot, trees_json, trees_text

    inputs = SystemInputs(folder, launches, package_path, environment, libraries, engine, jobs, timeout, parse_defines(defines), cached)
    systems = systems_of(inputs, verbose)
    write = trees_json if output_format is TreeFormat.json else trees_text
    if output_format is TreeFormat.dot:
        deliver(folder, systems, tree_dot, "dot", out)
    elif out is not None:
        deliver(folder, systems, lambda system: write([system]), output_format.value, out)
    else:
        emit(write(systems))
