"""`rosarch launch`: what launch files start and set."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from rosarch.cli.errors import FINDINGS
from rosarch.cli.launch_inputs import Surroundings, compose_folder, compose_words, is_folder
from rosarch.cli.options import NoUnderlay, Underlays, Verbose, installed
from rosarch.cli.terminal import emit, emit_lines, show_diagnostics


def launch(
    words: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE... [NAME:=VALUE ...]",
            help="Launch files that are started together, and values for their arguments; or a folder, for an overview.",
            show_default=False,
        ),
    ],
    package_path: Annotated[
        list[Path] | None,
        typer.Option(
            metavar="DIR",
            help="Where to look for packages; may be repeated. By default ROS_PACKAGE_PATH, or the workspace of the first FILE.",
            show_default=False,
        ),
    ] = None,
    environment: Annotated[
        list[str] | None,
        typer.Option("--env", metavar="NAME=VALUE", help="An environment variable of the robot; may be repeated.", show_default=False),
    ] = None,
    underlays: Underlays = None,
    no_underlay: NoUnderlay = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print nodes and parameters as JSON, as roslaunch holds them in memory.")] = False,
    verbose: Verbose = False,
) -> None:
    """List the nodes that launch files start, with names, remappings and parameters, without running anything."""
    from rosarch.library import prefixes
    from rosarch.reports import launch_table

    around = Surroundings(package_path, environment, replace(installed(underlays, none=no_underlay), libraries=prefixes()))
    if is_folder(words):
        compositions = compose_folder(words, around)
        refused = any(composition.refusal for composition in compositions.values())
        emit(launch_table.overview_json(compositions)) if as_json else emit_lines(launch_table.overview_text(compositions, Path.cwd()))
    else:
        composition = compose_words(words, around)
        refused = composition.refusal is not None
        show_diagnostics(composition.diagnostics(), verbose)
        emit(launch_table.composition_json(composition)) if as_json else emit_lines(launch_table.composition_text(composition, Path.cwd()))
    if refused:
        raise typer.Exit(FINDINGS)
