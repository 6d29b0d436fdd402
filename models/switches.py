"""What goes on at times only, and what switches it on and off: timers, loops that callbacks run, publishers of managed nodes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rosarch.base.logic import FALSE, TRUE
from rosarch.base.places import Place
from rosarch.models import formula
from rosarch.models.formula import Formula
from rosarch.models.guards import Guards, Way, meant_json, trail_json

Row = tuple[Any, ...]
Relations = Mapping[str, Iterable[Row]]


@dataclass(frozen=True)
class Switch:
    """What turns something to `to`, `on` or `off`, or only `perhaps`; `trigger` and `timed_by` are as those of transitions."""

    to: str
    perhaps: bool
    trigger: tuple[str, ...]
    timed_by: tuple[Place, ...]
    guard: Formula
    at: Place
    trail: tuple[Place, ...] | None = None  # as that of `Way`


@dataclass(frozen=True)
class Switched:
    """A timer, a timed loop or (`ports`) a publisher that is on at times only; it `begins` on, off or `?`.

    `reasons` are those by which the rules call it unsteady for that.
    """

    at: Place
    ports: tuple[str, ...]
    begins: str
    switches: tuple[Switch, ...]
    reasons: tuple[str, ...]


def switched_things(
    relations: Relations, places: Mapping[str, Place], guards: Guards, ports: Mapping[Any, str],
    triggers: Mapping[str, tuple[str, ...]], timers: Mapping[str, Iterable[Place]],
) -> tuple[Switched, ...]:  # fmt: skip
    """All of a component."""
    reasons: dict[str, list[str]] = defaultdict(list)
    for site, reason in sorted(relations.get("at_times", ())):
        reasons[site].append(reason)
    switches: dict[str, list[Switch]] = defaultdict(list)
    for call, root, site, to, how in sorted(relations.get("switches", ())):
        if call == site and how == "perhaps":
            ways = [Way(TRUE, "")]
        elif guards.is_ordered_by_calls(root):
            ways = guards.ways(root, call, "")
        else:
            ways = [Way(guards.guard(root, call), "")]
        timed = tuple(sorted(timers.get(root, ())))
        for way in ways if call in places else ():
            if way.guard != FALSE:
                causes = tuple(sorted(triggers.get(root, ())))
                switches[site].append(Switch(to, how == "perhaps", causes, timed, way.guard, places[call], way.trail))
    sending: dict[str, list[str]] = defaultdict(list)
    for port, name in sorted(ports.items(), key=lambda item: item[1]):
        if isinstance(port, tuple):
            sending[port[0]].append(name)
    found = [
        Switched(places[site], () if site in reasons else tuple(sending[site]), begins, tuple(switches[site]), tuple(reasons[site]))
        for site, begins in sorted(relations.get("switched", ()))
        if site in places
    ]
    return tuple(sorted(found, key=lambda each: (each.at, each.ports)))


def sent_while_starting(relations: Relations, places: Mapping[str, Place], ports: Mapping[Any, str]) -> tuple[tuple[str, Place, str], ...]:
    """What is sent before callbacks run: ports with the places of calls, each `certainly` or `perhaps`."""
    rows = relations.get("sent_while_starting", ())
    return tuple(sorted((ports[port], places[call], how) for port, call, how in rows if port in ports and call in places))


def switched_json(each: Switched) -> dict[str, Any]:
    """What compositions need of it."""
    return {
        "at": str(each.at),
        "ports": list(each.ports),
        "begins": each.begins,
        "reasons": list(each.reasons),
        "switches": [
            {"to": way.to, "perhaps": way.perhaps, "trigger": list(way.trigger), "timed_by": [str(place) for place in way.timed_by],
             "guard": formula.text(way.guard), "guard_tree": formula.tree(way.guard), "at": str(way.at), **meant_json(way.guard),
             **trail_json(way.trail)}
            for way in each.switches
        ],
    }  # fmt: skip
