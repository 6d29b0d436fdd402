"""`rosarch score`: how right the models of components are, by models that were written by hand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.base.files import file_name
from rosarch.cli.derivations import datalog_errors
from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_engine, check_folder, check_input
from rosarch.cli.options import path_argument
from rosarch.cli.outputs import check_output, output_folder
from rosarch.cli.questions import ReadingOptions, asks
from rosarch.cli.terminal import emit, progress, show_diagnostics

if TYPE_CHECKING:
    from rosarch.evaluation.experiments.single import SingleRun
    from rosarch.evaluation.experiments.truth import Truth

TruthFolder = Annotated[
    Path, typer.Argument(parser=path_argument, metavar="TRUTH", help="A folder with a YAML file per component.", show_default=False)
]
SystemsFolder = Annotated[
    Path | None,
    typer.Argument(
        parser=path_argument,
        metavar="[SYSTEMS]",
        help="The folder that has each system of TRUTH, sources or facts, under its name; of one system, also that system's folder.",
        show_default=False,
    ),
]
Models = Annotated[
    Path | None,
    typer.Option("--models", parser=path_argument, metavar="DIR", help="Score the models in DIR; analyse nothing.", show_default=False),
]
Out = Annotated[
    Path | None,
    typer.Option(
        "--out",
        "-o",
        parser=path_argument,
        metavar="OUT",
        help="Write each model to OUT/<system>/<package>/<component>.json.",
        show_default=False,
    ),
]
Absent = Annotated[
    bool, typer.Option("--allow-absent", help="Count components that SYSTEMS does not have as missed, instead of rejecting their truth.")
]
Misses = Annotated[bool, typer.Option("--misses", help="List every element that is missed or extra.")]


class ScoreFormat(str, Enum):
    """The formats of a score on stdout."""

    text = "text"
    markdown = "markdown"
    latex = "latex"
    csv = "csv"
    json = "json"


@asks("defines")
def score(
    reading: ReadingOptions,
    truth: TruthFolder,
    systems: SystemsFolder = None,
    models: Models = None,
    out: Out = None,
    misses: Misses = False,
    absent: Absent = False,
    output_format: Annotated[ScoreFormat, typer.Option("--format", help="The report on stdout.")] = ScoreFormat.text,
) -> None:
    """Score the models of the components in TRUTH: recall, precision, F1, and how far attributes agree."""
    from rosarch.evaluation.experiments.single import score_models
    from rosarch.evaluation.experiments.truth import TruthError, read_truth
    from rosarch.reports.scores import WRITERS

    check_folder(truth)
    if (systems is None) == (models is None):
        raise InputError("name either the folder of the systems or, with --models, that of their models")
    check_engine(reading.engine.value)
    if out:
        check_output(out)
    try:
        truths = read_truth(truth)
        if models is not None:
            found = score_models(truths, check_folder(models))
        else:
            single = _analyzed(truths, check_input(systems or Path()), reading, absent)
            show_diagnostics(single.diagnostics, reading.verbose)
            if out:
                _write(single, out)
            found = single.score
    except TruthError as error:
        raise InputError(str(error)) from None
    emit(WRITERS[output_format.value](found, misses))


def _analyzed(truths: Sequence[Truth], folder: Path, reading: ReadingOptions, absent: bool) -> SingleRun:
    from rosarch.evaluation.experiments.run import Runner
    from rosarch.evaluation.experiments.single import run_single, subjects_of
    from rosarch.extractor.manifest import ManifestError
    from rosarch.rule_programs.sets import model_program

    with datalog_errors():
        program = model_program(reading.rules())
    with progress() as report:
        settings = replace(reading.sources(), progress=report)
        runner = Runner(reading.engine.value, reading.jobs, progress=report)
        try:
            return run_single(truths, subjects_of(truths, folder, absent=absent), program, settings, runner, absent=absent)
        except ManifestError as error:
            raise InputError(str(error)) from None


def _write(single: SingleRun, out: Path) -> None:
    from rosarch.reports.json_models import write_document

    with output_folder(out) as folder:
        for (system, _, _), model in single.models.items():
            write_document(model, folder / file_name(system))
