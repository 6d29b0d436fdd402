"""The nodes of a composed system and the topics, services and actions that they meet at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from rosarch.base.places import Place
from rosarch.behavior.composition.components import Component, component
from rosarch.behavior.composition.contents import fields_read
from rosarch.models.machine.cells import Document
from rosarch.models.system.model import Connector, SystemModel

End = tuple[str, str]
"""A node and one of its ports, as its document calls it."""


@dataclass(frozen=True)
class Topic:
    """What messages pass through: a topic, or a service or action, whose requests count as messages.

    `outside` says who may send at any time: nodes without a known behaviour, ports of which no sending is known, those that were not seen
    where the system is open; when nobody in the system sends, it is the environment.
    """

    name: str
    kind: str
    senders: tuple[End, ...]
    receivers: tuple[End, ...]
    outside: tuple[str, ...]


@dataclass(frozen=True)
class System:
    """A composed system; `nodes` are those of which the behaviour is known, `unknown` the others.

    `conditions` say when nodes are started that launch files do not start in any case.
    """

    name: str
    nodes: Mapping[str, Component]
    topics: Mapping[str, Topic]
    unknown: tuple[str, ...] = ()
    conditions: Mapping[str, str] = field(default_factory=dict)

    def is_uncertain(self, sender: str) -> bool:
        """Whether somebody outside may send or not as long as the system runs."""
        return sender in self.nodes or sender == UNSEEN

    @cached_property
    def with_times(self) -> System:
        """The system where the times since moments that variables keep are variables themselves."""
        return replace(self, nodes={name: node.with_times for name, node in self.nodes.items()})

    def inlet(self, end: End) -> Topic | None:
        """What a node receives through a port."""
        return self._inlets.get(end)

    def outlet(self, end: End) -> tuple[Topic, ...]:
        """What a node sends to through a port."""
        return self._outlets.get(end, ())

    def servers(self, client: End) -> tuple[End, ...]:
        """Who alone may answer what a client asks: the servers, where no other client asks them."""
        asked = self.outlet(client)
        return tuple(end for topic in asked for end in topic.receivers) if all(topic.senders == (client,) for topic in asked) else ()

    def is_answered(self, client: End) -> bool:
        """Whether a client gets an answer whenever it asks."""
        servers = self.servers(client)
        return bool(servers) and all(port in self.nodes[node].answering for node, port in servers)

    @cached_property
    def _inlets(self) -> Mapping[End, Topic]:
        found: dict[End, Topic] = {}
        for topic in self.topics.values():
            for end in topic.receivers:
                found.setdefault(end, topic)
        return found

    @cached_property
    def _outlets(self) -> Mapping[End, tuple[Topic, ...]]:
        found: dict[End, tuple[Topic, ...]] = {}
        for topic in self.topics.values():
            for end in topic.senders:
                found[end] = (*found.get(end, ()), topic)
        return found


ENVIRONMENT = "environment"
UNSEEN = "a node that was not seen"


def composed(model: SystemModel, documents: Mapping[str, Document]) -> System:
    """A system with the behaviour of its nodes, from the documents of components by `package/name`."""
    known: dict[object, Component] = {}
    nodes: dict[str, Component] = {}
    asked = fields_read(documents.values())
    for node in model.nodes:
        if node.component in documents:
            own = node.component, node.settings
            document = documents[str(node.component)]
            known[own] = known.get(own) or component(document, {name: (kind, text) for name, kind, text in node.settings}, asked)
            nodes[node.id] = known[own].timed(
                {str(place): hz for place, hz in _certain(node.rates)}, [str(place) for place in node.serving]
            )
    topics: dict[str, Topic] = {}
    for connector in sorted(model.connectors, key=lambda connector: (connector.kind != "topic", connector.kind, connector.name)):
        name = connector.name if connector.name not in topics else f"{connector.kind} {connector.name}"
        topics[name] = _topic(name, connector, nodes)
    unknown = tuple(node.id for node in model.nodes if node.id not in nodes)
    conditions = {node.id: " and ".join(node.conditions) for node in model.nodes if node.conditions}
    return System(model.name, nodes, topics, unknown, conditions)


def _certain(rates: Sequence[tuple[Place, float]]) -> list[tuple[Place, float]]:
    """The rates of loops that have only one."""
    return [(place, hz) for place, hz in rates if sum(place == other for other, _ in rates) == 1]


def _topic(name: str, connector: Connector, nodes: Mapping[str, Component]) -> Topic:
    senders, outside, silent = [], [], False
    for node, port in connector.sources:
        end = (node, port.split(":")[0])
        if node in nodes and end[1] in nodes[node].outlets:
            senders.append(end)
            outside += [node] if end[1] in nodes[node].sending else []
        elif node in nodes and end[1] in nodes[node].silent:
            silent = True
        else:
            outside.append(node)
    receivers = ((node, port.split(":")[0]) for node, port in connector.sinks if node in nodes)
    ends = tuple(dict.fromkeys(receivers))
    if (senders or silent or connector.kind != "topic") and connector.open:
        outside.append(UNSEEN)
    nobody = () if senders or silent else (ENVIRONMENT,)
    return Topic(name, connector.kind, tuple(dict.fromkeys(senders)), ends, tuple(dict.fromkeys(outside)) or nobody)
