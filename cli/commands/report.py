"""`rosarch report`: all that is known about a workspace, as one page for a browser."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Annotated

import typer

from rosarch.cli.errors import InputError
from rosarch.cli.options import path_argument
from rosarch.cli.outputs import write_output
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.report_content import load_subject
from rosarch.cli.terminal import emit

Page = Annotated[
    Path, typer.Option("--output", "-o", parser=path_argument, metavar="FILE", help="The page to write.", show_default="report.html")
]
SourceUrl = Annotated[
    str | None,
    typer.Option(
        "--source-url",
        metavar="URL",
        help="Where sources can be read: 'https://github.com/o/r/blob/REV/{path}#L{line}'. Without it, excerpts only.",
        show_default=False,
    ),
]
Chains = Annotated[bool, typer.Option("--chains", help="Follow data through components, for chains of cause and effect. Takes longer.")]
Proofs = Annotated[
    bool, typer.Option("--proofs/--no-proofs", help="Include proofs: the rules and facts behind each result. Faster without.")
]
_LINK = re.compile(r"(?!(?:javascript|data|vbscript):)[a-z][a-z0-9+.-]*://\S+", re.IGNORECASE)


@asks()
def report(
    question: SystemQuestion, out: Page = Path("report.html"), source_url: SourceUrl = None, chains: Chains = False, proofs: Proofs = True
) -> None:
    """Write a report on the packages below DIR as one HTML page: components, graphs, state machines, findings."""
    from rosarch.reports.html.document import report_document
    from rosarch.reports.html.page import page_text
    from rosarch.reports.labels import counted
    from rosarch.reports.printable import printable

    link = check_link(source_url)
    if os.path.isdir(out):
        raise InputError(f"{out}: a folder, where a file is to be written")
    subject = load_subject(question, link, chains=chains, proofs=proofs)
    page = page_text(report_document(subject))
    write_output(out, page)
    numbers = {"component": len(subject.models), "system": len(subject.systems), "finding": len(subject.reported.shown)}
    emit(f"{printable(str(out))}: {', '.join(counted(number, noun) for noun, number in numbers.items())}\n")


def check_link(pattern: str | None) -> str | None:
    """A pattern of links to sources that browsers follow to a page."""
    if pattern is not None and not (_LINK.fullmatch(pattern) and "{path}" in pattern):
        raise InputError(f"--source-url {pattern}: not an address with {{path}} in it, such as https://example.org/{{path}}#L{{line}}")
    return pattern
