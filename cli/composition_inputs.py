"""The composed system that a sub-command runs or checks, and what is said of its surroundings."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.check_options import load_configuration
from rosarch.cli.errors import InputError
from rosarch.cli.inputs import read_input
from rosarch.cli.options import path_argument
from rosarch.cli.questions import SystemQuestion
from rosarch.cli.systems import load_systems
from rosarch.cli.terminal import show_remaining

if TYPE_CHECKING:
    from rosarch.behavior.composition.scenario import Scenario
    from rosarch.behavior.composition.system import System

ScenarioFile = Annotated[
    Path | None,
    typer.Option(
        "--scenario", parser=path_argument, metavar="FILE", help="The inputs from outside, see docs/behavior.md.", show_default=False
    ),
]


def load_composed(question: SystemQuestion) -> System:
    """The only system that the options or the configuration name, with the behaviour of its nodes."""
    from rosarch.behavior.composition.system import composed
    from rosarch.models.component import document_json, switches_json
    from rosarch.rule_programs.sets import system_rules

    rules, folder = question.rules(), question.folder
    analysis = load_systems(question.inputs(rules), load_configuration(folder, None, system_rules(rules).checks), required=True)
    show_remaining(analysis, folder, question.verbose)
    if len(analysis.systems) != 1:
        known = ", ".join(system.name for system in analysis.systems) or "none"
        raise InputError(f"{folder}: {len(analysis.systems)} systems; choose one with --launch: {known}")
    documents = {model.title: {**document_json(model), **switches_json(model)} for model in analysis.models}
    return composed(analysis.systems[0], documents)


def load_scenario(file: Path | None, system: System) -> Scenario:
    """The scenario in a file, or one in which anything may come from outside."""
    from rosarch.behavior.composition.scenario import Scenario, ScenarioError, read_scenario

    if file is None:
        return Scenario()
    try:
        return read_scenario(read_input(file), str(file), system)
    except ScenarioError as error:
        raise InputError(str(error)) from None
