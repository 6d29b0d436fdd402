"""The intervals that the rules derive for a system that is written by hand, and whether a simulated run keeps to them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from typing import Any

from rosarch.base.places import Place
from rosarch.behavior.composition.inputs import Entry
from rosarch.behavior.simulation.records import Record, busy
from rosarch.models.system.asking import Rate
from rosarch.models.system.rates import EVERY, TopicRate, ask_rates
from rosarch.rule_programs.sets import SHIPPED, system_rules

Rows = dict[str, set[tuple[Any, ...]]]
_ROUNDING = 3  # messages that are on their way, or before the first period, at the ends of a run


def facts(nodes: Mapping[str, Any], serving: Mapping[str, tuple[Place, float]] | None = None) -> Rows:
    """What models of these documents and a launch file that starts each would tell the rules."""
    rows: Rows = defaultdict(set)
    for name, document in nodes.items():
        rows["started"].add((f"/{name}", "p", name))
        rows["started_name"].add((f"/{name}", f"/{name}", "/"))
        rows["interface"].add((name, "p", name, "node", "source"))
        for port in document["ports"]:
            rows["interface_port"].add((name, f"{name}#{port['id']}", port["kind"], port["name"]))
            if port.get("queue") is not None:
                rows["interface_port_queue"].add((f"{name}#{port['id']}", port["queue"]))
        for loop in document.get("periodic") or ():
            place = f"{name} {loop['at']}"
            rows["interface_loop"].add((name, place, float(loop["hz"] or 0), ""))
            for port in loop["publishes"]:
                rows["interface_round_sends"].add((name, place, f"{name}#{port}", "1"))
                if not loop.get("conditional"):
                    rows["interface_round_always"].add((name, place, f"{name}#{port}"))
        at_times = [switched["at"] for switched in document.get("switched") or ()]  # a model says of each of these that it is unsteady
        for at in [*at_times, *(place for place, _ in (document.get("traits") or {}).get("unsteady") or ())]:
            rows["interface_unsteady"].add((name, f"{name} {at}", "it runs at times"))
        for reaction in document.get("reactive") or ():
            ends = (f"{name}#{reaction['input']}", f"{name}#{reaction['output']}")
            rows["interface_reacts"].add((*ends, "always" if reaction["must"] else "sometimes"))
            rows["interface_answers_most"].add((name, *ends, "1"))
        for place, hz in [serving[name]] if name in (serving or {}) else []:
            rows["interface_loop"].add((name, str(place), hz, ""))
            rows["interface_serves_callbacks"].add((name, str(place)))
    return rows


def inputs(entries: tuple[Entry, ...], duration: float) -> Rows:
    """What users would say of the messages that a scenario sends in so many seconds."""
    least: dict[str, float] = defaultdict(float)
    most: dict[str, float] = defaultdict(float)
    for entry in entries:
        steady = entry.every is not None and entry.start == 0 and entry.end is None
        most[entry.topic] += 1 / entry.every if entry.every else 1 / duration
        least[entry.topic] += 1 / entry.every if entry.every and steady else 0.0
    return {"rate_given": {(topic, least[topic], most[topic]) for topic in most}}


def derived(rows: Mapping[str, Any]) -> list[TopicRate]:
    """The intervals of all topics."""
    return ask_rates(system_rules(SHIPPED), rows, Rate(EVERY), "embedded")


def outside(rates: list[TopicRate], record: Record) -> list[str]:
    """The topics on which more or fewer messages were sent than the rules allow; fewer do not count where a node had no time for all."""
    in_time = all(part < 0.99 for part in busy(record).values())
    found = []
    for rate in rates:
        number = len(record.times.get(rate.topic, ()))
        if rate.high is not None and number > rate.high * record.duration + _ROUNDING:
            found.append(f"{rate.topic}: {number} in {record.duration:g} s, at most {rate.high:g} Hz")
        if in_time and number < rate.low * record.duration - _ROUNDING:
            found.append(f"{rate.topic}: {number} in {record.duration:g} s, at least {rate.low:g} Hz")
    return found
