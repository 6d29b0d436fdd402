"""`rosarch why-silent`: why nothing arrives on a topic of the systems that launch files start."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

import typer

from rosarch.cli.check_options import ConfigFile
from rosarch.cli.options import ModelFormat
from rosarch.cli.questions import SystemQuestion, answered, asks
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
    from rosarch.findings.silence import ask_silence
    from rosarch.reports.silence import silence_json, silence_text

    program, shared, launches = question.program_and_facts(replace(question.rules(), flows=True), config, required=True)
    answers = answered(launches, lambda one: ask_silence(program, shared.rows(one), topic, one.name, question.engine.value))
    emit(silence_json(answers) if output_format is ModelFormat.json else "\n".join(silence_text(*each) for each in answers))
