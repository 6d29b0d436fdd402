"""What comes of simulated systems lies within the intervals that the rules derive: those of temporal properties, and those of rates themselves."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from hand_made import load, system_of
from intervals import derived, facts, inputs, outside
from rule_cases import Case, cases_in, facts_and_program

from rosarch.base.places import Place
from rosarch.behavior.composition.inputs import Entry, Inputs
from rosarch.behavior.composition.scenario import Scenario
from rosarch.behavior.composition.system import ENVIRONMENT, System, composed
from rosarch.behavior.simulation.engine import simulate
from rosarch.models.system.build import evaluate, system_model
from rosarch.rule_programs.sets import SHIPPED, system_rules

TESTS = Path(__file__).parents[2]
PROPERTIES = sorted((TESTS / "behavior" / "verification" / "systems").glob("*.yml"))
RATES = cases_in(TESTS / "rules" / "systems" / "topic_rates.dl")
DURATION = 10.0
TIMED = ("least_gap", "sleeps_for_each", "round_always")


@pytest.mark.parametrize("path", PROPERTIES, ids=lambda path: path.stem)
def test_systems_of_properties(path: Path) -> None:
    data = load(path)
    system = system_of(data["nodes"], data.get("unknown"))
    free = [topic.name for topic in system.topics.values() if topic.kind == "topic" and not topic.senders]
    entries = tuple(Entry(topic, 0.0, 0.1) for topic in free)
    record = simulate(system, Scenario(inputs=Inputs(entries, anything=False)), seed=1, duration=DURATION)
    called = {topic.name for topic in system.topics.values() if topic.kind != "topic"}  # these are not counted
    rates = [] if called else derived({**facts(data["nodes"]), **inputs(entries, DURATION)})
    assert called or rates
    assert outside(rates, record) == []


@pytest.mark.slow
@pytest.mark.parametrize("case", RATES, ids=lambda case: case.name)
def test_systems_of_rates(case: Case) -> None:
    rows = facts_and_program(case)[0]
    places = {row[0]: Place(*row[1:]) for row in rows["place"]}
    places |= {place: Place("demo.launch", 2, 1) for _, _, place in rows["started_at"] if place not in places}
    model = system_model("by hand", (), rows, evaluate(system_rules(SHIPPED), rows), places)
    sources = [row[0] for row in rows["interface"] if row[4] == "source"]
    system = composed(model, {component: document(component, rows, places) for component in sources})
    given = {topic: high for topic, _, high in rows["rate_given"] if topic in system.topics and high}
    entries = tuple(Entry(topic, 0.0, 1 / high) for topic, high in given.items() if not system.topics[topic].senders)
    record = simulate(system, Scenario(Inputs(entries, anything=False)), seed=1, duration=DURATION)
    other = unlike(system, rows, given)
    assert outside([rate for rate in derived(rows) if rate.topic not in other], record) == []
    assert record.times.keys() - other or case.name in ("given", "of_tools")


def document(component: str, rows: Mapping[str, Any], places: Mapping[str, Place]) -> dict[str, Any]:
    """A component that does what the facts say; what it does only sometimes hangs on a condition that is drawn by lot."""
    sent: dict[str, list[str]] = defaultdict(list)
    for own, place, port, _ in rows["interface_round_sends"]:
        if own == component:
            sent[place].append(port)
    always = {(place, port) for _, place, port in rows["interface_round_always"]}
    queues = dict(rows["interface_port_queue"])
    ports = [(port, kind, name) for own, port, kind, name in rows["interface_port"] if own == component]
    inputs_ = {port for port, _, _ in ports}
    return {
        "ports": [{"id": port, "kind": kind, "name": name, "queue": queues.get(port)} for port, kind, name in ports],
        "periodic": [
            {
                "mechanism": "timer", "hz": hz or None, "publishes": [port], "at": str(places[place]),
                "conditional": None if (place, port) in always else "isFar()",
            }
            for own, place, hz, _ in rows["interface_loop"] if own == component for port in sent[place]
        ],
        "reactive": [
            {"input": source, "output": sink, "must": how == "always", "when": None if how == "always" else "isFar()", "at": ["node.cpp:9"]}
            for source, sink, how in rows["interface_reacts"] if source in inputs_
        ],
        "traits": {
            name: [[str(places.get(value, value)) for value in values] for own, *values in rows[f"interface_{name}"] if own == component]
            for name in TIMED
        },
    }  # fmt: skip


def unlike(system: System, rows: Mapping[str, Any], given: Mapping[str, float]) -> set[str]:
    """Topics on which other messages are sent than the rules count, and what comes of these.

    Users say otherwise than the senders do; a program without behaviour sends; a filter hands on each message by itself.
    """
    synchronised = {port for _, port, _ in rows["interface_synchronised"]}
    found = {topic.name for topic in system.topics.values() if topic.name in given and topic.senders}
    found |= {topic.name for topic in system.topics.values() if topic.name not in given and topic.outside not in ((), (ENVIRONMENT,))}
    reactions = [
        (inlet.name, outlet.name, source in synchronised)
        for node, component in system.nodes.items()
        for source, sink, _ in rows["interface_reacts"]
        if source in component.queues and (inlet := system.inlet((node, source)))
        for outlet in system.outlet((node, sink))
    ]
    while more := {after for before, after, by_itself in reactions if by_itself or before in found} - found:
        found |= more
    return found
