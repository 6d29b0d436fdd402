"""The entry point of the `rosarch` command."""

from __future__ import annotations

import signal
import sys
from typing import Annotated

import typer

from rosarch.cli import analyze, doctor, explain, extract, query, rules, show
from rosarch.cli.errors import INTERRUPTED, run

app = typer.Typer(
    name="rosarch",
    help="Reads the source of a ROS system and says what the system is and does, without building or running it.",
    epilog="Exit codes: 0 clean, 1 findings, 2 usage or input error. Reports go to stdout, everything else to stderr.",
    invoke_without_command=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.command("extract")(extract.extract)
app.command("analyze")(analyze.analyze)
app.add_typer(show.app, name="show")
app.command("doctor")(doctor.doctor)
app.command("query")(query.query)
app.command("explain")(explain.explain)
app.command("why-not")(explain.why_not)
app.add_typer(rules.app, name="rules")


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
    _traceback: Annotated[bool, typer.Option("--traceback", help="Show where in rosarch an unexpected error arose.")] = False,
) -> None:
    """Print the help when no sub-command is named."""
    if context.invoked_subcommand is None:
        print(context.get_help())


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; return its exit code."""
    arguments = list(sys.argv[1:] if arguments is None else arguments)
    traceback = "--traceback" in arguments
    command = typer.main.get_command(app)
    try:
        return run(
            lambda: command.main([a for a in arguments if a != "--traceback"], prog_name="rosarch", standalone_mode=False), traceback
        )
    except KeyboardInterrupt:
        return INTERRUPTED


def script() -> int:
    """The entry of the installed command: as `main`, and when it is terminated, worker processes and temporary files go, too."""
    signal.signal(signal.SIGTERM, lambda number, _frame: sys.exit(128 + number))
    return main()


if __name__ == "__main__":
    sys.exit(script())
