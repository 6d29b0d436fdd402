"""`rosarch launch`: what a launch file starts and sets."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rosarch.cli.errors import FINDINGS
from rosarch.cli.launch_inputs import compose_files
from rosarch.cli.options import Verbose
from rosarch.cli.terminal import emit, show_diagnostics


def launch(
    words: Annotated[
        list[str],
        typer.Argument(metavar="FILE... [NAME:=VALUE ...]", help="Launch files, and values for their arguments.", show_default=False),
    ],
    package_path: Annotated[
        list[Path] | None,
        typer.Option(
            metavar="DIR",
            help="Where packages are looked for; may be repeated. By default ROS_PACKAGE_PATH, or the workspace of the first FILE.",
            show_default=False,
        ),
    ] = None,
    environment: Annotated[
        list[str] | None,
        typer.Option("--env", metavar="NAME=VALUE", help="An environment variable of the robot; may be repeated.", show_default=False),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print what roslaunch would have in its memory, as JSON.")] = False,
    verbose: Verbose = False,
) -> None:
    """Say which nodes roslaunch would start, with which names, remappings and parameters, without running anything."""
    composition = compose_files(words, package_path, environment)
    show_diagnostics(composition.diagnostics(), verbose)
    from rosarch.reports.launch_table import composition_json, composition_text

    emit(composition_json(composition) if as_json else composition_text(composition, Path.cwd()))
    if composition.refusal:
        raise typer.Exit(FINDINGS)
