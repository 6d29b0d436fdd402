"""`rosarch compare`: how well the model of a system agrees with what was seen of it."""

from __future__ import annotations

from typing import Annotated

import typer

from rosarch.cli.observation_inputs import Bag, Domain, Every, MasterUri, Seconds, Source, observe_and_compare
from rosarch.cli.options import Format
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.terminal import emit, emit_lines


@asks("package_path", "environment")
def compare(
    question: SystemQuestion,
    bag: Bag = None,
    master: MasterUri = None,
    domain: Domain = None,
    seconds: Seconds = 0.0,
    every: Every = 1.0,
    output_format: Annotated[Format, typer.Option("--format", help="The form of the report on stdout.")] = Format.table,
) -> None:
    """Count, for each kind of element, how many the model predicts and how many a recording or a live graph shows.

    Under-approximation is the share of what was seen that was not predicted, over-approximation the share of what was predicted that
    was not seen.
    """
    from rosarch.reports.observation import comparison_json, comparison_markdown, comparison_text

    _, comparison = observe_and_compare(question, Source(bag, master, domain, seconds, every))
    if output_format is Format.json:
        emit(comparison_json(comparison))
    else:
        emit_lines(comparison_markdown(comparison) if output_format is Format.markdown else comparison_text(comparison))
