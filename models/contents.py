"""What messages hold when they are sent: the steps that give their fields values, where all that is put into them is seen."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rosarch.base.logic import FALSE
from rosarch.base.places import Place
from rosarch.models import formula
from rosarch.models.formula import Formula
from rosarch.models.guards import Guards, meant_json, trail_json
from rosarch.models.normal import normal_text

Row = tuple[Any, ...]
Relations = Mapping[str, Iterable[Row]]

_BEGINS = {"bool": "false", "std::string": '""', "std::basic_string<char>": '""', "string": '""'}
_NUMBERS = ("int", "char", "short", "long", "float", "double", "byte")


@dataclass(frozen=True)
class Filling:
    """A step that gives the field `path` of `message` a value, None where that is not known; `trail` is as that of `Way`."""

    message: str
    path: str
    value: str | None
    trigger: tuple[str, ...]
    timed_by: tuple[Place, ...]
    guard: Formula
    at: Place
    trail: tuple[Place, ...] | None


@dataclass(frozen=True)
class Contents:
    """What is known about the contents of messages.

    `sent` are the calls, by port and place, that send messages of which all is seen that is put into them, with the message. `rounds` are
    all calls by which a timed loop or timer sends: the port, the place of the call and of the loop, and the condition. `kinds` are the
    types of fields. `constants` are the numbers and texts that names stand for.
    """

    sent: tuple[tuple[str, Place, str], ...]
    rounds: tuple[tuple[str, Place, Place, str | None], ...]
    fillings: tuple[Filling, ...]
    kinds: tuple[tuple[str, str, str], ...]
    constants: tuple[tuple[str, str], ...] = ()


NO_CONTENTS = Contents((), (), (), ())


def sent_contents(
    relations: Relations, places: Mapping[str, Place], guards: Guards, ports: Mapping[Any, str],
    triggers: Mapping[str, tuple[str, ...]], timers: Mapping[str, Iterable[Place]],
) -> Contents:  # fmt: skip
    """All of a component."""
    called = {(message, call) for call, message in relations.get("content_sent", ()) if call in places}
    calls = dict(sorted(called, reverse=True))
    numbers = {message: str(number) for number, message in enumerate(sorted(calls), 1)}
    sent = {
        (ports[port], places[call], numbers[message]) for port, call in _sending(relations, ports) for message, one in called if one == call
    }
    kinds = {(message, path): kind for message, path, kind in sorted(relations.get("content_kind", ()))}
    roots = defaultdict(list)
    for root, step in sorted(relations.get("content_step", ())):
        roots[step].append(root)
    steps: list[tuple[str, str, str, str | None]] = [*relations.get("content_given", ())]
    steps += [(message, path, step, None) for message, path, step in relations.get("content_begins", ())]
    found = []
    for message, path, step, value in sorted(steps, key=repr):
        at = places.get(calls[message] if step == message else step) if message in calls else None
        for root in roots[step] if at else ():
            timed = tuple(sorted(timers.get(root, ())))
            causes = tuple(sorted(triggers.get(root, ())))
            meant = _beginning(kinds.get((message, path), "")) if value is None else guards.meaning(value)
            for way in guards.ways(root, step, meant or ""):
                if way.guard != FALSE and at:
                    trail = (*way.trail[:-1], at) if way.trail else way.trail
                    found.append(Filling(numbers[message], path, way.value or None, causes, timed, way.guard, at, trail))
    own = {(numbers[message], path, kind) for (message, path), kind in kinds.items() if message in numbers}
    rounds = _rounds(relations, places, guards, ports)
    return Contents(tuple(sorted(sent)), rounds, tuple(dict.fromkeys(found)), tuple(sorted(own)), _constants(relations))


def _sending(relations: Relations, ports: Mapping[Any, str]) -> set[tuple[Any, str]]:
    """The ports that each call sends through."""
    rows = (row for name in ("reacts", "sends_once", "sends_periodically") for row in relations[name])
    return {(port, call) for _, port, call in rows if port in ports}


def _rounds(
    relations: Relations, places: Mapping[str, Place], guards: Guards, ports: Mapping[Any, str]
) -> tuple[tuple[str, Place, Place, str | None], ...]:
    """The calls by which timed loops and timers send."""
    roots = defaultdict(set)
    for site, root, _ in relations["periodic"]:
        roots[site].add(root)
    found = {
        (ports[port], places[call], places[site], formula.text(guards.guard(root, call)))
        for site, port, call in relations["sends_periodically"]
        if port in ports and call in places and site in places
        for root in roots[site]
    }
    return tuple(sorted(found, key=repr))


def _constants(relations: Relations) -> tuple[tuple[str, str], ...]:
    """The constants that names stand for: of each name only one."""
    found = defaultdict(set)
    for name, value in relations.get("constant_called", ()):
        found[name.rpartition("::")[2]].add(value)
    return tuple(sorted((name, *values) for name, values in found.items() if len(values) == 1))


def _beginning(kind: str) -> str | None:
    """What a field of a new message is."""
    plain = kind.removeprefix("const ")
    return _BEGINS.get(plain) or ("0" if any(word in plain for word in _NUMBERS) else None)


def contents_json(contents: Contents) -> dict[str, Any]:
    """What compositions need of it."""
    return {
        "sent": [[port, str(place), message] for port, place, message in contents.sent],
        "rounds": [[port, str(call), str(loop), text] for port, call, loop, text in contents.rounds],
        "kinds": [list(each) for each in contents.kinds],
        "constants": [list(each) for each in contents.constants],
        "fillings": [
            {"message": each.message, "path": each.path, "value": each.value, "trigger": list(each.trigger),
             "timed_by": [str(place) for place in each.timed_by], "guard": formula.text(each.guard),
             "guard_normal": normal_text(each.guard), "guard_tree": formula.tree(each.guard), "at": str(each.at),
             **meant_json(each.guard), **trail_json(each.trail)}
            for each in contents.fillings
        ],
    }  # fmt: skip
