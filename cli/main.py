"""The entry point of the `rosarch` command."""

from __future__ import annotations

import io
import os
import sys
from typing import Annotated

import typer

from rosarch.cli.command_table import Commands
from rosarch.cli.errors import run

app = typer.Typer(
    name="rosarch",
    help="Reads the source of a ROS system and reports its architecture, its behaviour and its faults, without building or running it.",
    epilog="Exit codes: 0 clean, 1 findings, 2 usage or input error. Reports go to stdout, everything else to stderr.",
    cls=Commands,
    invoke_without_command=True,
    rich_markup_mode=None,  # to import rich takes longer than all else that help needs
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        print(f"rosarch {version('rosarch')}")
        raise typer.Exit


@app.callback()
def root(
    context: typer.Context,
    _version: Annotated[
        bool, typer.Option("--version", help="Print the version and exit.", is_eager=True, callback=_print_version)
    ] = False,
    memory: Annotated[
        int | None, typer.Option("--memory", metavar="MIB", min=16, help="The memory limit of a worker process; 4096 by default.")
    ] = None,
    _traceback: Annotated[bool, typer.Option("--traceback", help="Show where in rosarch an unexpected error occurred.")] = False,
) -> None:
    """Print the help when no sub-command is named."""
    if memory:
        from rosarch.base.limits import LIMITS

        LIMITS.memory = memory << 20
    if context.invoked_subcommand is None:
        print(context.get_help())


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; return its exit code."""
    if not sys.stderr:
        sys.stderr = open(os.devnull, "w")  # noqa: SIM115 - it lives as long as the process
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # what a terminal or a locale cannot show is no reason to fail
    arguments = list(sys.argv[1:] if arguments is None else arguments)
    traceback = "--traceback" in arguments
    command = typer.main.get_command(app)
    return run(lambda: command.main([a for a in arguments if a != "--traceback"], prog_name="rosarch", standalone_mode=False), traceback)


if __name__ == "__main__":
    from rosarch.cli.__main__ import script

    sys.exit(script())
