"""`rosarch verify`: temporal logic over composed systems."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.composition_inputs import ScenarioFile, load_composed, load_scenario
from rosarch.cli.errors import FINDINGS, InputError
from rosarch.cli.inputs import read_input
from rosarch.cli.options import path_argument
from rosarch.cli.outputs import check_output, write_files
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.terminal import emit, emit_lines

if TYPE_CHECKING:
    from rosarch.behavior.composition.inputs import Inputs
    from rosarch.behavior.composition.system import System
    from rosarch.behavior.verification.properties import Property


class Checker(str, Enum):
    """The model checkers."""

    spin = "spin"
    storm = "storm"


class VerdictFormat(str, Enum):
    """The formats of verdicts."""

    text = "text"
    json = "json"
    mermaid = "mermaid"


class Language(str, Enum):
    """The languages of model checkers."""

    promela = "promela"
    prism = "prism"
    jani = "jani"


PropertyFile = Annotated[
    Path, typer.Option("--properties", parser=path_argument, metavar="FILE", help="The properties.", show_default=False)
]


@asks()
def verify(
    question: SystemQuestion,
    properties: PropertyFile,
    names: Annotated[
        list[str] | None, typer.Option("--property", metavar="NAME", help="Only this property; may be repeated.", show_default=False)
    ] = None,
    checker: Annotated[
        Checker | None, typer.Option("--checker", help="The model checker; by default the one that is installed.", show_default=False)
    ] = None,
    scenario: ScenarioFile = None,
    bound: Annotated[int, typer.Option("--bound", metavar="N", min=1, max=250, help="Count messages in a queue up to N.")] = 2,
    seconds: Annotated[float, typer.Option("--time-limit", metavar="SECONDS", min=0.001, help="The time limit of one property.")] = 60.0,
    memory: Annotated[int, typer.Option("--memory-limit", metavar="MIB", min=64, help="The memory that a checker may use.")] = 3072,
    output_format: Annotated[VerdictFormat, typer.Option("--format", help="The form of the report on stdout.")] = VerdictFormat.text,
    export: Annotated[
        Language | None,
        typer.Option("--export", help="Check nothing; write each property with its model for another tool.", show_default=False),
    ] = None,
    out: Annotated[Path | None, typer.Option("--output", "-o", metavar="DIR", help="Where --export writes.", show_default=False)] = None,
) -> None:
    """Check temporal properties of the system that launch files start, whatever comes from outside.

    Exits with 1 when a property is violated, or may be. How properties are written, what is assumed of time, queues and fairness, and
    what a verdict means is in docs/behavior.md.
    """
    text = read_input(properties)
    system = load_composed(question)
    wanted = _properties(text, str(properties), system, names)
    given = load_scenario(scenario, system).inputs
    if export is not None:
        _export(system, wanted, given, export, bound, out)
    else:
        _check(system, wanted, given, checker, bound, (seconds, memory), output_format)


def _properties(text: str, path: str, system: System, names: Sequence[str] | None) -> list[Property]:
    from rosarch.base.hints import hint
    from rosarch.behavior.verification.properties import PropertyError, read_properties

    try:
        found = read_properties(text, path, system)
    except PropertyError as error:
        raise InputError(str(error)) from None
    known = {item.name for item in found}
    for name in names or ():
        if name not in known:
            raise InputError(f"{path}: no property {name}{hint(name, known)}")
    return [item for item in found if not names or item.name in names]


def _check(
    system: System,
    wanted: list[Property],
    given: Inputs,
    checker: Checker | None,
    bound: int,
    limits: tuple[float, int],
    output_format: VerdictFormat,
) -> None:
    from rosarch.behavior.verification.check import HOLDS, Limits, chosen_checker, verify
    from rosarch.behavior.verification.checkers import CheckerError

    try:
        used = chosen_checker(checker.value if checker else None)
        verdicts = verify(system, wanted, given, used, bound, Limits(seconds=limits[0], memory=limits[1]))
    except CheckerError as error:
        raise InputError(str(error)) from None
    if output_format is VerdictFormat.json:
        from rosarch.reports.verdicts_json import verdicts_text as json_text

        emit(json_text(system.name, verdicts, used))
    elif output_format is VerdictFormat.mermaid:
        from rosarch.reports.verdicts_mermaid import verdicts_text as mermaid_text

        emit_lines(mermaid_text(system, verdicts))
    else:
        from rosarch.reports.verdicts_text import verdicts_text

        emit_lines(verdicts_text(system.name, verdicts, used))
    if any(found.verdict != HOLDS for found in verdicts):
        raise typer.Exit(FINDINGS)


def _export(system: System, wanted: list[Property], given: Inputs, language: Language, bound: int, out: Path | None) -> None:
    from rosarch.behavior.composition.reactions import TooManyCases
    from rosarch.behavior.verification.check import model_for
    from rosarch.behavior.verification.jani import UnsupportedError
    from rosarch.behavior.verification.languages import files

    try:
        written = [file for item in wanted for file in files(language.value, model_for(system, item.formula, given, bound), item)]
    except (UnsupportedError, TooManyCases) as error:
        raise InputError(str(error)) from None
    if out is not None:
        check_output(out)
        write_files(out, written)
    elif len(wanted) == 1:
        emit(written[0][1])
    else:
        raise InputError(f"{len(wanted)} properties; choose one with --property, or write all with --output DIR")
