"""`rosarch ask`: what causes what in the systems that launch files start, and how often."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.check_options import ConfigFile
from rosarch.cli.errors import InputError
from rosarch.cli.options import ModelFormat
from rosarch.cli.questions import SystemQuestion, answered, asks
from rosarch.cli.terminal import emit

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

    try:
        parsed = parse_question(asked)
    except QuestionError as error:
        raise InputError(str(error)) from None
    chosen = question.rules()
    rules = replace(chosen, flows=True) if isinstance(parsed, Causes) else chosen
    found = question.program_and_facts(rules, config, required=True)
    emit(_answers(parsed, *found, question.engine.value, json=output_format is ModelFormat.json))


def _answers(asked: Causes | Rate, rules: SystemRules, shared: SharedFacts, launches: Sequence[Launch], engine: str, *, json: bool) -> str:
    from rosarch.models.system.asking import Rate
    from rosarch.models.system.chains import ask_chain
    from rosarch.models.system.rates import ask_rates
    from rosarch.reports.answers import chain_json, chain_text, rates_json, rates_text

    if isinstance(asked, Rate):
        rates = answered(launches, lambda launch: ask_rates(rules, shared.rows(launch), asked, engine))
        return rates_json(rates) if json else "\n".join(rates_text(*each) for each in rates)
    chains = [
        chain for _, chain in answered(launches, lambda one: ask_chain(rules, shared.rows(one), asked, one.name, shared.models, engine))
    ]
    return chain_json(chains) if json else "\n".join(map(chain_text, chains))
