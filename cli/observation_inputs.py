"""What of a running system sub-commands look at, and the one system that it is compared with."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.errors import InputError
from rosarch.cli.options import path_argument
from rosarch.cli.questions import SystemQuestion

if TYPE_CHECKING:
    from rosarch.models.system.rows import Rows
    from rosarch.observation.compare import Comparison
    from rosarch.observation.observed import Recorded, Watched
    from rosarch.rule_programs.sets import SystemRules

Bag = Annotated[
    Path | None,
    typer.Option("--bag", parser=path_argument, metavar="FILE", help="A recording of ROS 1, or of ROS 2 (its folder).", show_default=False),
]
MasterUri = Annotated[
    str | None,
    typer.Option("--master", metavar="URI", help="The master of a live graph, such as http://localhost:11311.", show_default=False),
]
Domain = Annotated[
    int | None,
    typer.Option("--domain", metavar="ID", min=0, max=232, help="The domain of a live graph of ROS 2, such as 0.", show_default=False),
]
Seconds = Annotated[float, typer.Option("--seconds", metavar="N", min=0, help="How long to watch the live graph.")]
Every = Annotated[float, typer.Option("--every", metavar="S", min=0.1, help="Look at it every S seconds.")]


@dataclass(frozen=True)
class Source:
    """A recording, or a live graph of ROS 1 or ROS 2 and how long it is looked at."""

    bag: Path | None
    master: str | None
    domain: int | None
    seconds: float
    every: float


@dataclass(frozen=True)
class _System:
    name: str
    rows: Rows
    rules: SystemRules


def observe_and_compare(question: SystemQuestion, source: Source) -> tuple[Recorded | Watched, Comparison]:
    """Look at the running system, and compare it with the only one that the options or the configuration name."""
    from rosarch.observation.compare import compare
    from rosarch.observation.observed import Recorded, recorded_rows, watched_rows

    if [source.bag, source.master, source.domain].count(None) != 2:
        raise InputError("give one of --bag, --master and --domain")
    system = _load(question)
    engine = question.engine.value
    seen = _recorded(source.bag, system, engine) if source.bag is not None else _watched(source)
    rows = recorded_rows(seen) if isinstance(seen, Recorded) else watched_rows(seen)
    return seen, compare(system.rules, system.name, system.rows, rows, engine)


def _load(question: SystemQuestion) -> _System:
    program, shared, launches = question.program_and_facts(question.rules())
    if len(launches) != 1:
        known = ", ".join(launch.name for launch in launches) or "none"
        raise InputError(f"{question.folder}: {len(launches)} systems; choose the one that ran with --launch: {known}")
    return _System(launches[0].name, shared.rows(launches[0]), program)


def _recorded(bag: Path, system: _System, engine: str) -> Recorded:
    from rosarch.observation.compare import expected_pairs
    from rosarch.observation.observed import Recorded
    from rosarch.observation.recording import RecordingError, open_recording
    from rosarch.observation.summary import summarise

    try:
        recording = open_recording(bag)
        return Recorded(str(bag), summarise(recording, expected_pairs(system.rules, system.rows, engine)))
    except RecordingError as error:
        raise InputError(str(error)) from None


def _watched(source: Source) -> Watched:
    from rosarch.observation.domain import watch_domain
    from rosarch.observation.graph import Graph, watch
    from rosarch.observation.observed import Watched
    from rosarch.observation.rpc import CallError

    uri = source.master or ""
    try:
        if source.domain is not None:
            snapshots = tuple(watch_domain(source.domain, source.seconds, source.every))
            return Watched(f"domain {source.domain}", snapshots, source.domain)
        return Watched(uri, tuple(watch(Graph(uri), source.seconds, source.every)))
    except CallError as error:
        raise InputError(str(error)) from None
