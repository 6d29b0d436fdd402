"""`rosarch experiment`: variants of the analysis compared on many systems."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.base.limits import SOURCE_SECONDS
from rosarch.cli.derivations import datalog_errors
from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_engine, extraction_cache, read_input
from rosarch.cli.options import Engine, EngineChoice, Jobs, Timeout, Verbose, path_argument
from rosarch.cli.outputs import check_output, write_files
from rosarch.cli.terminal import emit, progress, show_diagnostics

if TYPE_CHECKING:
    from rosarch.evaluation.experiments.subjects import Subject
    from rosarch.findings.model import Finding
    from rosarch.reports.experiment import Report
    from rosarch.rule_programs.sets import RuleSet


class ExperimentFormat(str, Enum):
    """The formats of an experiment's report on stdout."""

    text = "text"
    markdown = "markdown"
    latex = "latex"
    csv = "csv"
    json = "json"


def experiment(
    file: Annotated[
        Path,
        typer.Argument(parser=path_argument, metavar="FILE.yml", help="The subjects, their truth, and the variants.", show_default=False),
    ],
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", parser=path_argument, metavar="OUT", help="Also write all tables to this folder.", show_default=False),
    ] = None,
    output_format: Annotated[ExperimentFormat, typer.Option("--format", help="The report on stdout.")] = ExperimentFormat.text,
    most: Annotated[
        int, typer.Option("--most", "-n", metavar="N", min=0, help="List no more elements that differ than this per pair.")
    ] = 20,
    engine: EngineChoice = Engine.embedded,
    jobs: Jobs = None,
    timeout: Timeout = SOURCE_SECONDS,
    cached: Annotated[bool, typer.Option("--cache/--no-cache", help="Cache facts and results, and continue where a run stopped.")] = True,
    verbose: Verbose = False,
) -> None:
    """Compare variants of the analysis on many subjects: precision, recall and F1 with intervals, tests, cost."""
    from rosarch.analysis.method import Method
    from rosarch.base.cache import Cache
    from rosarch.cli.check_options import load_configuration
    from rosarch.cli.systems import SystemInputs, load_systems
    from rosarch.datalog.cache import cache_folder
    from rosarch.evaluation.experiments.conduct import conduct
    from rosarch.evaluation.experiments.plan import PlanError, read_experiment
    from rosarch.evaluation.experiments.run import Runner
    from rosarch.evaluation.experiments.truth import TruthError
    from rosarch.extractor.manifest import ManifestError
    from rosarch.extractor.settings import Settings
    from rosarch.reports.experiment import Report, report_text
    from rosarch.rule_programs.sets import system_rules

    read_input(file)
    check_engine(engine.value)
    try:
        with datalog_errors():
            plan = read_experiment(file)
        if out:
            check_output(out)
        with progress() as report:
            settings = Settings(jobs, timeout, cache=extraction_cache(cached))
            kept = Cache(cache_folder() / "experiments") if cached else None
            runner = Runner(engine.value, jobs, kept, report)

            def check(subject: Subject, rules: RuleSet) -> Sequence[Finding]:
                inputs = SystemInputs(subject.folder, Method(rules, engine.value, replace(settings, defines=subject.defines)))
                configuration = load_configuration(subject.folder, None, system_rules(rules).checks)
                return load_systems(inputs, configuration).findings

            results, diagnostics = conduct(plan, replace(settings, progress=report), runner, check)
    except (PlanError, TruthError, ManifestError) as error:
        raise InputError(str(error)) from None
    show_diagnostics(diagnostics, verbose)
    found = Report(results)
    if out:
        _write(found, out)
    emit(report_text(found, output_format.value, most))


def _write(report: Report, out: Path) -> None:
    from rosarch.reports.experiment import report_files

    write_files(out, report_files(report).items())
