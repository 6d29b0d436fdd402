"""`rosarch analyze`: sources or facts to component models."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Annotated

import typer

from rosarch.cli.inputs import check_output, load_analysis, unwritable
from rosarch.cli.options import (
    Cached,
    Defines,
    Engine,
    EngineChoice,
    Input,
    Jobs,
    ModelFormat,
    Packages,
    Timeout,
    Verbose,
    parse_defines,
    path_argument,
)
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
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


def analyze(
    folder: Input,
    out: Out = None,
    engine: EngineChoice = Engine.embedded,
    packages: Packages = None,
    output_format: Annotated[
        ModelFormat | None, typer.Option("--format", help="Report on stdout; a table by default, only its last line with --out.")
    ] = None,
    own: Rules = None,
    variants: Variants = None,
    settings: Settings = None,
    jobs: Jobs = None,
    defines: Defines = None,
    timeout: Timeout = 60.0,
    cached: Cached = True,
    verbose: Verbose = False,
) -> None:
    """Say what each node and nodelet below DIR is connected to: its ports, with types and source lines, and its parameters."""
    start = time.perf_counter()
    variables = parse_defines(defines)
    if out:
        check_output(out)
    rules = parse_rules(own, variants, settings)
    analysis = load_analysis(folder, packages, rules=rules, engine=engine, jobs=jobs, timeout=timeout, defines=variables, cached=cached)
    if out:
        from rosarch.extractor.cache import write_whole
        from rosarch.models.rule_sets import described
        from rosarch.reports.json_models import dump, write_models

        try:
            write_models(analysis.models, out)
            if told := described(rules):
                write_whole(out / "rules.json", dump(told).encode())
        except OSError as error:
            raise unwritable(out, error) from None
    show_diagnostics(analysis.diagnostics, verbose)
    if output_format is ModelFormat.json:
        from rosarch.reports.json_models import models_text

        emit(models_text(analysis.models))
        return
    if output_format or not out:
        from rosarch.reports.table import models_text as table_text

        emit(table_text(analysis.models, parameters=True, terminal=is_terminal()))
    from rosarch.reports.summary import summary_line

    emit(summary_line(analysis.models, time.perf_counter() - start) + "\n")
