"""`rosarch new`: files to begin your own rules with."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rosarch.cli.derivations import datalog_errors
from rosarch.cli.inputs import check_folder
from rosarch.cli.options import path_argument
from rosarch.cli.outputs import unwritable
from rosarch.cli.terminal import emit

app = typer.Typer(help="Create a check, a relation or the API of a library: rules, docs and a test that passes.", no_args_is_help=False)

Into = Annotated[
    Path,
    typer.Option("--into", parser=path_argument, metavar="DIR", help="The folder of your rules; created if missing.", show_default=True),
]
FOLDER = Path("my_rules")


@app.command("check")
def check(
    name: Annotated[str, typer.Argument(metavar="ID", help="Its id: `queue-too-short`.", show_default=False)], into: Into = FOLDER
) -> None:
    """Begin a check of systems, for `rosarch check --rules`."""
    _begin("check", name, into, f"rosarch check DIR --rules {into}")


@app.command("relation")
def relation(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Its name: `answers_late`.", show_default=False)], into: Into = FOLDER
) -> None:
    """Begin a relation about components, for `rosarch query --rules`."""
    _begin("relation", name, into, f"rosarch rules run DIR {into / name}.dl")


@app.command("api")
def api(
    library: Annotated[str, typer.Argument(metavar="LIBRARY", help="Its C++ namespace: `my_library`.", show_default=False)],
    into: Into = FOLDER,
) -> None:
    """Begin the facts about a library that makes ports for its users, for `rosarch analyze --rules`."""
    _begin("api", library, into, f"rosarch analyze DIR --rules {into}")


def _begin(kind: str, name: str, folder: Path, used: str) -> None:
    from rosarch.reports.checks import sections_markdown
    from rosarch.rule_programs.scaffold import write_scaffold

    if folder.exists():
        check_folder(folder)
    with datalog_errors():
        try:
            written = write_scaffold(kind, name, folder, lambda check: sections_markdown([check]))
        except OSError as error:
            raise unwritable(folder, error) from None
    emit("".join(f"{path}\n" for path in written))
    emit(f"test it: rosarch rules test {folder} --rules {folder}\nuse it:  {used}\n")
