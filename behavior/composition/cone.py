"""The cone of influence: what of a system can make a difference to some variables and messages."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

from rosarch.behavior.composition.system import End, System
from rosarch.models.machine.steps import Step


@dataclass(frozen=True, order=True)
class Event:
    """A message is `sent` on a topic (by `node`, if one is named), or `received`, `dropped` from the queue or `ignored` by a node."""

    kind: str
    topic: str
    node: str = ""

    def __str__(self) -> str:
        return f"{self.kind}({self.node}, {self.topic})" if self.node else f"{self.kind}({self.topic})"


@dataclass(frozen=True)
class Watched:
    """What is observed of a system: variables, as node and key, and events."""

    variables: frozenset[tuple[str, str]] = frozenset()
    events: frozenset[Event] = frozenset()


@dataclass(frozen=True)
class Cone:
    """The part of a system that what is watched depends on: variables, the steps of triggers that matter, and fields of messages."""

    watched: Watched
    variables: frozenset[tuple[str, str]]
    steps: dict[End, tuple[Step, ...]]
    fields: frozenset[tuple[str, str]] = frozenset()


@dataclass
class _Search:
    system: System
    variables: set[tuple[str, str]] = field(default_factory=set)
    outlets: set[End] = field(default_factory=set)
    triggers: set[End] = field(default_factory=set)
    waiting: list[tuple[str, tuple[str, str]]] = field(default_factory=list)

    def need(self, kind: str, items: Iterable[tuple[str, str]]) -> None:
        known = {"variable": self.variables, "outlet": self.outlets, "trigger": self.triggers}[kind]
        for item in items:
            if item not in known:
                known.add(item)
                self.waiting.append((kind, item))


def cone_of_influence(system: System, watched: Watched) -> Cone:
    """What the variables and events that are watched depend on, directly or through others."""
    search = _Search(system)
    search.need("variable", watched.variables)
    whole = set()
    for event in watched.events:
        topic = system.topics[event.topic]
        if event.kind == "sent":
            search.need("outlet", [end for end in topic.senders if event.node in ("", end[0])])
        else:
            ends = [end for end in topic.receivers if end[0] == event.node]
            search.need("trigger", ends)
            whole |= set(ends) if event.kind == "ignored" else set()
    for node, trigger in whole:
        for step in system.nodes[node].steps.get(trigger, ()):
            search.need("variable", _tested(system, node, step))
            search.need("variable", _fields(system, (node, trigger), step))
    while search.waiting:
        kind, (node, name) = search.waiting.pop()
        if kind == "trigger":
            inlet = system.inlet((node, name))
            search.need("outlet", inlet.senders if inlet else ())
            search.need("trigger", ((node, other) for other in system.nodes[node].together.get(name, ())))
            if name in system.nodes[node].answered:
                search.need("outlet", [(node, name)])
                search.need("trigger", system.servers((node, name)))
            continue
        for trigger, steps in system.nodes[node].steps.items():
            for step in steps:
                if _matters(step, kind, name):
                    search.need("trigger", [(node, trigger)])
                    search.need("variable", _tested(system, node, step))
                    search.need("variable", _fields(system, (node, trigger), step))
    kept = {end: _own_steps(search, end, end in whole) for end in sorted(search.triggers)}
    fields = frozenset((node, key) for node, key in search.variables if key in system.nodes[node].fields)
    return Cone(watched, frozenset(search.variables) - fields, kept, fields)


def _matters(step: Step, kind: str, name: str) -> bool:
    return name in step.outputs if kind == "outlet" else any(a.cell.subject.key == name for a in step.assignments)


def _fields(system: System, end: End, step: Step) -> Iterator[tuple[str, str]]:
    """The fields of messages, where they are sent, that a step of a trigger depends on."""
    topic = system.inlet(end)
    for path in system.nodes[end[0]].paths_read(end[1], step).values() if topic else ():
        for node, port in topic.senders if topic else ():
            yield from ((node, key) for key in system.nodes[node].fields_sent(port, path))


def _tested(system: System, node: str, step: Step) -> list[tuple[str, str]]:
    """The variables that a step depends on."""
    return [(node, subject.key) for subject in step.tested() if subject.key in system.nodes[node].variables]


def _own_steps(search: _Search, end: End, whole: bool) -> tuple[Step, ...]:
    """The steps of a trigger without what does not matter; all of them where it counts whether there is one."""
    node, trigger = end
    found = []
    for step in search.system.nodes[node].steps.get(trigger, ()):
        own = replace(
            step,
            assignments=tuple(a for a in step.assignments if (node, a.cell.subject.key) in search.variables),
            outputs=tuple(port for port in step.outputs if (node, port) in search.outlets),
        )
        if own.assignments or own.outputs or whole:
            found.append(own)
    return tuple(found)
