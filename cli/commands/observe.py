"""`rosarch observe`: what was seen of a running system, beside its model."""

from __future__ import annotations

from typing import Annotated

import typer

from rosarch.cli.errors import FINDINGS
from rosarch.cli.observation_inputs import Bag, Domain, Every, MasterUri, Seconds, Source, observe_and_compare
from rosarch.cli.options import Format
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.terminal import emit, emit_lines


@asks("package_path", "environment")
def observe(
    question: SystemQuestion,
    bag: Bag = None,
    master: MasterUri = None,
    domain: Domain = None,
    seconds: Seconds = 0.0,
    every: Every = 1.0,
    output_format: Annotated[Format, typer.Option("--format", help="The form of the report on stdout.")] = Format.table,
) -> None:
    """Compare a recording or a live graph with the system that launch files start, and report what the sources do not show.

    Topics with rates, gaps and delays, nodes, services, parameters; what was predicted and seen, seen only, predicted only; names and
    rates that the sources leave open. Exits with 1 when what was seen contradicts what follows from the sources.
    """
    from rosarch.reports.observation import observation_json, observation_markdown, observation_text

    seen, comparison = observe_and_compare(question, Source(bag, master, domain, seconds, every))
    if output_format is Format.json:
        emit(observation_json(seen, comparison))
    else:
        emit_lines(observation_markdown(seen, comparison) if output_format is Format.markdown else observation_text(seen, comparison))
    if comparison.contradictions:
        raise typer.Exit(FINDINGS)
