"""A live graph, as its master and its nodes report it: one snapshot, or several over time."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from rosarch.observation.peer import Peer
from rosarch.observation.rpc import CallError, Remote

NAME = "/rosarch"
"""What the reader calls itself; it is never part of what it reports."""
_OUTBOUND = "o"

Pairs = frozenset[tuple[str, str]]


@dataclass(frozen=True)
class State:
    """Who sends and reads on which topic and serves which service: pairs of node and name.

    A graph of ROS 2 shows `others` as well, with their kind in front: clients of services, both sides of actions; and nodes `alone`.
    """

    publishers: Pairs
    subscribers: Pairs
    services: Pairs
    others: frozenset[tuple[str, str, str]] = frozenset()
    alone: frozenset[str] = frozenset()

    def nodes(self) -> frozenset[str]:
        """All nodes that are part of it."""
        return self.alone | frozenset(node for _, node, _ in self.ports())

    def ports(self) -> frozenset[tuple[str, str, str]]:
        """All ports: kind, node and name."""
        pairs = {"publisher": self.publishers, "subscriber": self.subscribers, "service_server": self.services}
        return self.others | {(kind, node, name) for kind, found in pairs.items() for node, name in found}


@dataclass(frozen=True)
class Snapshot:
    """A graph at `at` seconds after the first snapshot.

    `types` are those of topics and services by (`topic` or `service`, name), `parameters` the names of values, `connections` sender, reader
    and topic; `silent` are nodes that the master knows and that do not answer, each with the reason.
    """

    at: float
    state: State
    types: dict[tuple[str, str], str]
    parameters: frozenset[str]
    connections: frozenset[tuple[str, str, str]]
    silent: dict[str, str]


class Graph:
    """The graph of the master at `uri`, which is asked and never changed."""

    def __init__(self, uri: str, seconds: float = 3.0) -> None:
        self._uri = uri
        self._seconds = seconds
        self._master = Remote(uri, NAME, seconds)
        self._service_types: dict[str, str] = {}

    def state(self) -> State:
        """Who sends, reads and serves now.

        Raises:
            CallError: the master does not answer.
        """
        answer = self._master.call("getSystemState")
        try:
            sides = [frozenset((node, name) for name, nodes in side for node in nodes if node != NAME) for side in answer]
            publishers, subscribers, services = sides
        except (TypeError, ValueError):
            raise CallError(f"{self._uri}: what it answers is no state of a graph") from None
        return State(publishers, subscribers, services)

    def snapshot(self, at: float = 0.0) -> Snapshot:
        """All of the graph that can be asked for.

        Raises:
            CallError: the master does not answer.
        """
        state = self.state()
        types = {("topic", topic): type_ for topic, type_ in self._master.call("getTopicTypes") if type_ != "*"}
        silent: dict[str, str] = {}
        addresses = {}
        for node in sorted(state.nodes()):
            with suppress(CallError):
                addresses[node] = self._master.call("lookupNode", node)
        names = {address.rstrip("/"): node for node, address in addresses.items()}
        connections: set[tuple[str, str, str]] = set()
        for node, address in addresses.items():
            try:
                connections |= _connections(node, Remote(address, NAME, self._seconds).call("getBusInfo"), names)
            except CallError as error:
                silent[node] = str(error)
        types.update((("service", service), type_) for service, type_ in self._services(state, silent).items())
        return Snapshot(at, state, types, frozenset(self._master.call("getParamNames")), frozenset(connections), silent)

    def _services(self, state: State, silent: dict[str, str]) -> dict[str, str]:
        """The types of services, which only their servers report."""
        wanted = [service for node, service in state.services if service not in self._service_types and node not in silent]
        if wanted:
            with Peer(self._uri, NAME, self._seconds) as peer:
                for service in wanted:
                    with suppress(CallError):
                        self._service_types[service] = peer.service_type(service).name
        return {service: type_ for service, type_ in self._service_types.items() if type_ != "*"}


def _connections(node: str, rows: Any, names: dict[str, str]) -> set[tuple[str, str, str]]:
    """Those of a node; the other end is given by its name or its address."""
    found = set()
    for row in rows:
        with suppress(ValueError, TypeError, AttributeError):
            _, other, direction, _, topic, *_ = row
            name = names.get(other.rstrip("/"), other)
            if name.startswith("/"):
                found.add((node, name, topic) if direction == _OUTBOUND else (name, node, topic))
    return found


def watch(graph: Graph, seconds: float, every: float) -> Iterator[Snapshot]:
    """A snapshot now and then another one `every` so many seconds, until `seconds` have passed.

    Raises:
        CallError: the master does not answer.
    """
    return snapshots(graph.snapshot, seconds, every)


def snapshots(taken_at: Callable[[float], Snapshot], seconds: float, every: float) -> Iterator[Snapshot]:
    """Snapshots, each with how many seconds after the first one it is taken."""
    begin = time.monotonic()
    number = 0
    while True:
        yield taken_at(round(time.monotonic() - begin, 3))
        number += 1
        if number * every > seconds:
            return
        time.sleep(max(0.0, begin + number * every - time.monotonic()))
