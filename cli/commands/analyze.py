"""`rosarch analyze`: sources or facts to component models."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Annotated

import typer

from rosarch.cli.options import ModelFormat, path_argument
from rosarch.cli.outputs import check_output, output_folder
from rosarch.cli.questions import Question, asks
from rosarch.cli.terminal import emit, is_terminal, show_diagnostics

Out = Annotated[
    Path | None,
    typer.Option(
        "--out",
        "-o",
        parser=path_argument,
        metavar="OUT",
        help="Also write each model to OUT/<package>/<component>.json, and rules other than rosarch's to OUT/rules.json.",
        show_default=False,
    ),
]


@asks("component", "launches")
def analyze(
    question: Question,
    out: Out = None,
    output_format: Annotated[
        ModelFormat | None, typer.Option("--format", help="Report on stdout; a table by default, only its last line with --out.")
    ] = None,
) -> None:
    """List the ports and parameters of each node and nodelet below DIR, with types and source lines."""
    start = time.perf_counter()
    if out:
        check_output(out)
    rules = question.rules()
    analysis = question.analysis(rules, question.folder, question.packages, whole=True)
    if out:
        from rosarch.base.whole import write_whole
        from rosarch.reports.json_models import write_models
        from rosarch.reports.printable import json_text
        from rosarch.rule_programs.sets import described

        with output_folder(out) as written:
            write_models(analysis.models, written)
            if told := described(rules):
                write_whole(written / "rules.json", json_text(told).encode())
    show_diagnostics(analysis.diagnostics, question.verbose)
    if output_format is ModelFormat.json:
        from rosarch.reports.json_models import models_text

        emit(models_text(analysis.models))
        return
    from rosarch.models.component import UNUSED

    running = [model for model in analysis.models if model.kind != UNUSED]
    if output_format or not out:
        from rosarch.reports.table import models_text as table_text

        emit(table_text(running, parameters=True, terminal=is_terminal()))
    from rosarch.reports.summary import summary_line

    emit(summary_line(running, time.perf_counter() - start, question.underlay) + "\n")
