"""`rosarch ask`: what causes what in the systems that launch files start, and how often."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.check_options import ConfigFile, load_configuration
from rosarch.cli.derivations import datalog_errors
from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_folder
from rosarch.cli.options import ModelFormat
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.systems import load_shared_facts
from rosarch.cli.terminal import emit, show_diagnostics

if TYPE_CHECKING:
    from rosarch.analysis.systems.shared import Launch, SharedFacts
    from rosarch.models.system.asking import Causes, Rate
    from rosarch.rule_programs.sets import SystemRules

Asked = Annotated[
    str,
    typer.Argument(
        metavar="QUESTION",
        help="'can NAME of NODE cause NAME of NODE', `must` instead of `can`, or 'rate of TOPIC' (`*` for every one).",
        show_default=False,
    ),
]


@asks("package_path", "environment")
def ask(
    question: SystemQuestion,
    asked: Asked,
    config: ConfigFile = None,
    output_format: Annotated[ModelFormat, typer.Option("--format", help="The form of the answer on stdout.")] = ModelFormat.table,
) -> None:
    """Answer a QUESTION about the systems that launch files below DIR start: which message can, or must, cause which, and how often."""
    from rosarch.models.system.asking import Causes, QuestionError, parse_question
    from rosarch.rule_programs.checks import shipped_checks
    from rosarch.rule_programs.sets import system_rules

    folder, engine = question.folder, question.engine.value
    try:
        parsed = parse_question(asked)
        check_folder(folder)
        chosen = question.rules()
        rules = replace(chosen, flows=True) if isinstance(parsed, Causes) else chosen
        shared, found = load_shared_facts(question.inputs(rules), load_configuration(folder, config, shipped_checks()))
        show_diagnostics(shared.diagnostics, question.verbose)
        if not found:
            raise InputError(f"{folder}: no launch file below this folder")
        with datalog_errors():
            program = system_rules(rules)
        emit(_answers(parsed, program, shared, found, engine, json=output_format is ModelFormat.json))
    except QuestionError as error:
        raise InputError(str(error)) from None


def _answers(asked: Causes | Rate, rules: SystemRules, shared: SharedFacts, launches: Sequence[Launch], engine: str, *, json: bool) -> str:
    from rosarch.models.system.asking import Rate
    from rosarch.models.system.chains import ask_chain
    from rosarch.models.system.rates import ask_rates
    from rosarch.reports.answers import chain_json, chain_text, rates_json, rates_text

    if isinstance(asked, Rate):
        rates = [(launch.name, ask_rates(rules, shared.rows(launch), asked, engine)) for launch in launches]
        return rates_json(rates) if json else "\n".join(rates_text(*each) for each in rates)
    chains = [ask_chain(rules, shared.rows(launch), asked, launch.name, shared.models, engine) for launch in launches]
    return chain_json(chains) if json else "\n".join(map(chain_text, chains))
