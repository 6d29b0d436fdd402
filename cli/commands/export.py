"""`rosarch export`: composed systems in the languages of other tools."""

from __future__ import annotations

import typer

from rosarch.cli.delivery import Out, deliver, systems_of
from rosarch.cli.questions import SystemQuestion, asks

app = typer.Typer(help="Write systems in the languages of other tools.", no_args_is_help=False)


@app.callback()
def export() -> None:
    """Write systems in the languages of other tools."""


@app.command("acme")
@asks()
def acme(
    question: SystemQuestion,
    out: Out = None,
) -> None:
    """Write the architecture of a system in Acme, in the family of ROSDiscover's architectures."""
    from rosarch.reports.acme import acme_text

    deliver(question.folder, systems_of(question), acme_text, "acme", out)
