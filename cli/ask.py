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
from rosarch.cli.options import Cached, Defines, Engine, EngineChoice, Folder, Jobs, Libraries, ModelFormat, Timeout, Verbose, parse_defines
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
from rosarch.cli.systems import Launches, SystemInputs, load_surrounding
from rosarch.cli.terminal import emit, show_diagnostics

if TYPE_CHECKING:
    from rosarch.models.rule_sets import SystemRules
    from rosarch.models.system.asking import Causes, Rate
    from rosarch.models.system.surrounding import Launch, Surrounding

Asked = Annotated[
    str,
    typer.Argument(
        metavar="QUESTION",
        help="'can NAME of NODE cause NAME of NODE', `must` instead of `can`, or 'rate of TOPIC' (`*` for every one).",
        show_default=False,
    ),
]


def ask(
    folder: Folder,
    question: Asked,
    launches: Launches = None,
    libraries: Libraries = None,
    config: ConfigFile = None,
    output_format: Annotated[ModelFormat, typer.Option("--format", help="The form of the answer on stdout.")] = ModelFormat.table,
    own: Rules = None,
    variants: Variants = None,
    settings: Settings = None,
    engine: EngineChoice = Engine.embedded,
    jobs: Jobs = None,
    defines: Defines = None,
    timeout: Timeout = 60.0,
    cached: Cached = True,
    verbose: Verbose = False,
) -> None:
    """Answer a QUESTION about the systems that launch files below DIR start: what can, or must, cause what; how often."""
    from rosarch.models.checks import shipped_checks
    from rosarch.models.rule_sets import system_rules
    from rosarch.models.system.asking import Causes, QuestionError, parse_question

    try:
        asked = parse_question(question)
        check_folder(folder)
        chosen = parse_rules(own, variants, settings)
        rules = replace(chosen, flows=True) if isinstance(asked, Causes) else chosen
        extraction = (engine, jobs, timeout, parse_defines(defines), cached)
        inputs = SystemInputs(folder, launches, None, None, libraries, *extraction, rules)
        shared, found = load_surrounding(inputs, load_configuration(folder, config, shipped_checks()))
        show_diagnostics(shared.diagnostics, verbose)
        if not found:
            raise InputError(f"{folder}: no launch file below this folder")
        with datalog_errors():
            program = system_rules(rules)
        emit(_answers(asked, program, shared, found, engine.value, json=output_format is ModelFormat.json))
    except QuestionError as error:
        raise InputError(str(error)) from None


def _answers(asked: Causes | Rate, rules: SystemRules, shared: Surrounding, launches: Sequence[Launch], engine: str, *, json: bool) -> str:
    from rosarch.models.system.asking import Rate
    from rosarch.models.system.chains import ask_chain
    from rosarch.models.system.rates import ask_rates
    from rosarch.reports.answers import chain_json, chain_text, rates_json, rates_text

    if isinstance(asked, Rate):
        rates = [(launch.name, ask_rates(rules, shared.rows(launch), asked, engine)) for launch in launches]
        return rates_json(rates) if json else "\n".join(rates_text(*each) for each in rates)
    chains = [ask_chain(rules, shared.rows(launch), asked, launch.name, shared.models, engine) for launch in launches]
    return chain_json(chains) if json else "\n".join(map(chain_text, chains))
