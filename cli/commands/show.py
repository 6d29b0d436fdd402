"""`rosarch show`: one aspect of a system."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.commands.graph import graph
from rosarch.cli.commands.includes import includes
from rosarch.cli.errors import InputError
from rosarch.cli.options import Format, MachineFormat
from rosarch.cli.questions import Question, asks
from rosarch.cli.terminal import emit, emit_lines, is_terminal, show_diagnostics

if TYPE_CHECKING:
    from rosarch.analysis.components import Analysis
    from rosarch.models.component import ComponentModel
    from rosarch.rule_programs.choice import RuleSet

Node = Annotated[str | None, typer.Argument(metavar="NODE", help="Only this one: NAME, PACKAGE/NAME or its node name.", show_default=False)]

app = typer.Typer(help="Show one aspect of a system.", no_args_is_help=False)


@app.command("ports")
@asks("component", "launches")
def ports(
    question: Question,
    node: Node = None,
    output_format: Annotated[Format, typer.Option("--format", help="The form of the report on stdout.")] = Format.table,
) -> None:
    """List the topics, services, actions and transforms of each node and nodelet below DIR."""
    start = time.perf_counter()
    models = asked_models(question, node)
    if output_format is Format.json:
        from rosarch.reports.json_models import ports_text

        emit(ports_text(models))
    elif output_format is Format.markdown:
        from rosarch.reports.markdown import ports_text as markdown_text

        emit(markdown_text(models))
    else:
        from rosarch.reports.summary import summary_line
        from rosarch.reports.table import models_text

        emit(models_text(models, parameters=False, terminal=is_terminal()))
        emit(summary_line(models, time.perf_counter() - start, question.underlay) + "\n")


@app.command("behavior")
@asks("component", "launches")
def behavior(
    question: Question,
    node: Node = None,
    output_format: Annotated[Format, typer.Option("--format", help="The form of the report on stdout.")] = Format.table,
) -> None:
    """List what each node and nodelet below DIR does: its reactions, timed loops, state variables and their transitions."""
    models = asked_models(question, node)
    if output_format is Format.json:
        from rosarch.reports.json_models import behaviors_text

        emit(behaviors_text(models))
        return
    from rosarch.models.component import document_json

    documents = list(map(document_json, models))
    if output_format is Format.markdown:
        from rosarch.reports.behavior_markdown import behaviors_text as markdown_text

        emit_lines(markdown_text(documents))
    else:
        from rosarch.reports.behavior_text import behaviors_text as table_text

        emit_lines(table_text(documents))


@app.command("machine")
@asks("component", "launches")
def machine(
    question: Question,
    node: Node = None,
    output_format: Annotated[
        MachineFormat, typer.Option("--format", help="The form of the report on stdout; for diagrams and SCXML name a NODE.")
    ] = MachineFormat.text,
    max_states: Annotated[
        int,
        typer.Option("--max-states", metavar="N", min=1, help="Show variables that depend on each other as one machine of up to N states."),
    ] = 16,
    joint: Annotated[bool, typer.Option("--joint", help="Do so even where every combination of their values can occur.")] = False,
) -> None:
    """Show the state machines of each node and nodelet below DIR: states are the values of its state variables."""
    models = asked_models(question, node)
    if len(models) != 1 and output_format not in (MachineFormat.text, MachineFormat.json):
        names = ", ".join(f"{model.package}/{model.component}" for model in models)
        raise InputError(f"{question.folder}: {len(models)} components; choose one for {output_format.value}: {names}")
    from rosarch.models.component import document_json
    from rosarch.models.machine.build import build_machine
    from rosarch.reports.machines import machines_text

    machines = [build_machine(document_json(model), max_states=max_states, joint=joint) for model in models]
    write = emit if output_format is MachineFormat.json else emit_lines
    write(machines_text(machines, output_format.value))


app.command("graph")(graph)
app.command("includes")(includes)


def asked_models(question: Question, node: str | None) -> tuple[ComponentModel, ...]:
    """The components to show; what was not understood goes to stderr."""
    rules = question.rules()
    analysis = _only(question, rules, node) if node and not question.packages else None
    analysis = analysis or question.analysis(rules, question.folder, question.packages)
    models = analysis.models if node is None else _named(analysis.models, node)
    show_diagnostics(analysis.diagnostics, question.verbose)
    return models


def _only(question: Question, rules: RuleSet, node: str) -> Analysis | None:
    """The analysis of PACKAGE/NAME alone; None when there is no such component in a folder of packages."""
    package, _, component = node.partition("/")
    if not (component and os.path.isdir(question.folder)):
        return None
    try:
        found = question.analysis(rules, question.folder, [package], component)
    except InputError:
        return None
    return found if found.models else None


def _named(models: Sequence[ComponentModel], node: str) -> tuple[ComponentModel, ...]:
    """The components a user may mean by `node`."""
    found = tuple(model for model in models if node in (model.component, f"{model.package}/{model.component}", model.node_name))
    if not found:
        from rosarch.base.hints import hint_or_all

        known = {name for model in models for name in (model.component, f"{model.package}/{model.component}")}
        raise InputError(f"no node or nodelet {node}{hint_or_all(node, known)}")
    return found
