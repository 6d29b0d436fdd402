"""`rosarch why-silent`: why nothing arrives on a topic of the systems that launch files start."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

import typer

from rosarch.cli.check_options import ConfigFile
from rosarch.cli.errors import InputError
from rosarch.cli.options import ModelFormat
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.terminal import emit

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

    program, shared, launches = question.program_and_facts(replace(question.rules(), flows=True), config, required=True)
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
