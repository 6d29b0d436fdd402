"""`rosarch simulate`: composed systems in simulated time."""

from __future__ import annotations

from enum import Enum
from typing import Annotated

import typer

from rosarch.cli.composition_inputs import ScenarioFile, load_composed, load_scenario
from rosarch.cli.errors import InputError
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.terminal import emit, emit_lines


class RunFormat(str, Enum):
    """The formats of a simulated run."""

    text = "text"
    json = "json"
    csv = "csv"
    sequence = "sequence"
    timeline = "timeline"


@asks()
def simulate(
    question: SystemQuestion,
    scenario: ScenarioFile = None,
    seed: Annotated[int, typer.Option("--seed", metavar="N", min=0, help="The seed of random choices; the same N gives the same run.")] = 0,
    duration: Annotated[float, typer.Option("--duration", metavar="SECONDS", min=0.001, max=1e6, help="The simulated time.")] = 10.0,
    output_format: Annotated[
        RunFormat, typer.Option("--format", help="Figures, figures with all events, events, or Mermaid diagrams of the beginning.")
    ] = RunFormat.text,
) -> None:
    """Simulate the system that launch files start: rates, queues, lost messages, latencies.

    The nodes are state machines that are made from their source; nothing is executed. A scenario says what comes from outside and how
    long things take, see docs/behavior.md.
    """
    from rosarch.behavior.simulation.engine import TooManyEventsError
    from rosarch.behavior.simulation.engine import simulate as run

    system = load_composed(question)
    try:
        record = run(system, load_scenario(scenario, system), seed=seed, duration=duration)
    except TooManyEventsError as error:
        raise InputError(str(error)) from None
    if output_format is RunFormat.text:
        from rosarch.reports.simulation_tables import simulation_text

        emit_lines(simulation_text(record))
    elif output_format in (RunFormat.json, RunFormat.csv):
        from rosarch.reports.simulation_trace import simulation_json, trace_csv

        emit(simulation_json(record) if output_format is RunFormat.json else trace_csv(record))
    else:
        from rosarch.reports.simulation_mermaid import sequence_diagram, timeline

        emit_lines(sequence_diagram(record, system) if output_format is RunFormat.sequence else timeline(record))
