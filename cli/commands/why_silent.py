"""`rosarch why-silent`: why nothing arrives on a topic of the systems that launch files start."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

import typer

from rosarch.cli.check_options import ConfigFile, load_configuration
from rosarch.cli.derivations import datalog_errors
from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_folder
from rosarch.cli.options import ModelFormat
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.systems import load_shared_facts
from rosarch.cli.terminal import emit, show_diagnostics

Topic = Annotated[str, typer.Argument(metavar="TOPIC", help="The name of the topic in the ROS graph.", show_default=False)]


@asks("package_path", "environment")
def why_silent(
    question: SystemQuestion,
    topic: Topic,
    config: ConfigFile = None,
    output_format: Annotated[ModelFormat, typer.Option("--format", help="The form of the answer on stdout.")] = ModelFormat.table,
) -> None:
    """Say why nothing arrives on TOPIC in the systems that launch files below DIR start: the chain back to the first broken link."""
    from rosarch.findings.silence import Silence, ask_silence
    from rosarch.models.system.asking import QuestionError
    from rosarch.reports.silence import silence_json, silence_text
    from rosarch.rule_programs.checks import shipped_checks
    from rosarch.rule_programs.sets import system_rules

    folder = question.folder
    check_folder(folder)
    rules = replace(question.rules(), flows=True)
    shared, launches = load_shared_facts(question.inputs(rules), load_configuration(folder, config, shipped_checks()))
    show_diagnostics(shared.diagnostics, question.verbose)
    if not launches:
        raise InputError(f"{folder}: no launch file below this folder")
    with datalog_errors():
        program = system_rules(rules)
    answers: list[tuple[str, Silence]] = []
    problem: QuestionError | None = None
    for launch in launches:
        try:
            answers.append((launch.name, ask_silence(program, shared.rows(launch), topic, launch.name, question.engine.value)))
        except QuestionError as error:
            problem = problem or error
    if not answers:
        raise InputError(str(problem)) from None
    emit(silence_json(answers) if output_format is ModelFormat.json else "\n".join(silence_text(*each) for each in answers))
