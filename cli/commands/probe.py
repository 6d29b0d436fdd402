"""`rosarch probe`: experiments with a real node."""

from __future__ import annotations

import os
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.commands.show import asked_models
from rosarch.cli.errors import FINDINGS, InputError
from rosarch.cli.options import Format, path_argument
from rosarch.cli.outputs import write_output
from rosarch.cli.questions import Question, asks
from rosarch.cli.terminal import emit, emit_lines

if TYPE_CHECKING:
    from rosarch.models.component import ComponentModel
    from rosarch.observation.subject import Subject

Probed = Annotated[str, typer.Argument(metavar="NODE", help="The node: NAME, PACKAGE/NAME or its node name.", show_default=False)]


@asks("component", "launches")
def probe(
    question: Question,
    node: Probed,
    executable: Annotated[
        Path | None,
        typer.Option(
            "--executable", parser=path_argument, metavar="FILE", help="The executable of the node, built by you.", show_default=False
        ),
    ] = None,
    only_plan: Annotated[
        bool, typer.Option("--plan", help="Run nothing; print the messages it would send and the reactions it expects.")
    ] = False,
    seconds: Annotated[float, typer.Option("--time-limit", metavar="SECONDS", min=1, help="The time limit of all experiments.")] = 120.0,
    trials: Annotated[int, typer.Option("--trials", metavar="N", min=1, help="How many experiments run at a time.")] = 4,
    scenario: Annotated[
        Path | None,
        typer.Option(
            "--scenario", parser=path_argument, metavar="FILE", help="Write measured times for `rosarch simulate`.", show_default=False
        ),
    ] = None,
    output_format: Annotated[Format, typer.Option("--format", help="The form of the report on stdout.")] = Format.table,
) -> None:
    """Run one node, send it the messages of its model, and report which reactions and transitions it really has.

    Names of ports that the sources leave open are reported as the running node has them.

    The node that was built runs under a private master on loopback, once for each experiment; all that it starts ends with it. Messages
    are made so that conditions hold. Exits with 1 when something of the model is refuted.
    """
    from rosarch.observation.plan import plan
    from rosarch.observation.private import StartError
    from rosarch.observation.probe import REFUTED
    from rosarch.observation.probe import probe as experiment
    from rosarch.observation.rpc import CallError
    from rosarch.observation.settled import is_open, settle
    from rosarch.reports.probe import plan_text, results_json, results_markdown, results_text, scenario_text
    from rosarch.rule_programs.sets import system_rules

    model, subject = _subject(question, node)
    found = plan(subject.machine, subject.rows)
    if only_plan:
        emit_lines(plan_text(subject, found))
        return
    command = [str(_program(executable))]
    results = experiment(subject, found, command, seconds, trials)
    if is_open(model):
        with suppress(StartError, CallError):  # then verdicts report it
            names = settle(subject, model, command, system_rules(question.rules()), question.engine.value)
            results = replace(results, names=names)
    if scenario is not None:
        write_output(scenario, scenario_text(subject, results))
    if output_format is Format.json:
        emit(results_json(subject, results))
    else:
        emit_lines((results_markdown if output_format is Format.markdown else results_text)(subject, results))
    if any(each.verdict == REFUTED for each in results.verdicts):
        raise typer.Exit(FINDINGS)


def _subject(question: Question, node: str) -> tuple[ComponentModel, Subject]:
    from rosarch.extractor.messages import load_messages
    from rosarch.extractor.workspace import discover
    from rosarch.models.component import to_json
    from rosarch.observation.subject import Subject

    models = asked_models(question, node)
    if len(models) != 1:
        raise InputError(f"{node} is several nodes: {', '.join(f'{model.package}/{model.component}' for model in models)}")
    store = load_messages(discover(question.folder).packages)
    return models[0], Subject(to_json(models[0]), store, f"/{_name(models[0])}")


def _name(model: ComponentModel) -> str:
    """What a node is called in an experiment: in ROS 2, where a program may have several, as its code says if that is known."""
    from rosarch.observation.company import ROS2

    told = model.node_name if model.middleware == ROS2 else None
    return told if told and "?" not in told and "/" not in told else model.component


def _program(executable: Path | None) -> Path:
    """The node as it was built: nothing that is merely found beside the sources is ever run."""
    if executable is None:
        raise InputError("name the node that was built with --executable, or ask for the plan alone with --plan")
    if not (os.path.isfile(executable) and os.access(executable, os.X_OK)):
        raise InputError(f"{executable}: no executable")
    return executable.absolute()
