"""`rosarch ask`: what causes what in the systems that launch files start."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

import typer

from rosarch.cli.derivations import datalog_errors
from rosarch.cli.errors import InputError
from rosarch.cli.options import Cached, Defines, Engine, EngineChoice, Folder, Jobs, ModelFormat, Timeout, Verbose, parse_defines
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
from rosarch.cli.systems import Launches, SystemInputs, load_surrounding
from rosarch.cli.terminal import emit, show_diagnostics

Asked = Annotated[
    str,
    typer.Argument(metavar="QUESTION", help="'can NAME of NODE cause NAME of NODE', or `must` instead of `can`.", show_default=False),
]


def ask(
    folder: Folder,
    question: Asked,
    launches: Launches = None,
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
    """Answer a QUESTION about the systems that launch files below DIR start: what can, or must, cause what, and by which chain of messages."""
    from rosarch.models.rule_sets import system_rules
    from rosarch.models.system.asking import QuestionError, parse_question
    from rosarch.models.system.chains import ask_chain
    from rosarch.reports.answers import chain_json, chain_text

    try:
        asked = parse_question(question)
        rules = replace(parse_rules(own, variants, settings), flows=True)
        inputs = SystemInputs(
            folder, launches, engine=engine, jobs=jobs, timeout=timeout, defines=parse_defines(defines), cached=cached, rules=rules
        )
        shared, found = load_surrounding(inputs)
        show_diagnostics(shared.diagnostics, verbose)
        if not found:
            raise InputError(f"{folder}: no launch file below this folder")
        with datalog_errors():
            program = system_rules(rules)
        answers = [ask_chain(program, shared.rows(launch), asked, launch.name, shared.models, engine.value) for launch in found]
    except QuestionError as error:
        raise InputError(str(error)) from None
    emit(chain_json(answers) if output_format is ModelFormat.json else "\n".join(map(chain_text, answers)))
