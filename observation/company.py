"""What a node meets in an experiment: the other end of all of its ports, in a private graph of ROS 1 or a domain of ROS 2 of its own."""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Protocol

from rosarch.observation.content import Values
from rosarch.observation.domain import Participant, environment, free_domain, python_with_ros
from rosarch.observation.graph import Graph
from rosarch.observation.observed import Watched
from rosarch.observation.peer import ANY, Heard, MessageType, Peer
from rosarch.observation.private import PrivateGraph, Start, StartError, last_line, private_graph
from rosarch.observation.processes import Process, wait_until
from rosarch.observation.subject import Place, Subject

NAME = "/rosarch_probe"
ROS2 = "ROS 2"
_REST = 0.3
"""Seconds in which nothing was added to the graph: then the node is taken to be complete."""
_LOOKS = 30
_MEETING = 0.3
"""Seconds after which both ends of a topic know each other in ROS 2, once one of them does."""


class Company(Protocol):
    """The other end of the ports of a node."""

    patience: float
    """Seconds until all connections are there, at most."""

    def start(self, command: Sequence[str]) -> Process:
        """Start the node.

        Raises:
            StartError: it does not come up.
        """

    def subscribe(self, place: Place) -> None:
        """Note when something is sent."""

    def advertise(self, place: Place) -> None:
        """Be ready to send."""

    def readers(self, place: Place) -> int:
        """How many read it."""

    def publish(self, place: Place, values: Values) -> float:
        """Send a message; when."""

    def call(self, place: Place, values: Values) -> None:
        """Call a service."""

    def heard(self) -> Mapping[str, list[float]]:
        """When something was sent, by ports."""

    def watched(self) -> Watched:
        """The graph, once the node is complete."""


@contextmanager
def company(subject: Subject) -> Iterator[Company]:
    """The company of a node, of which nothing is left afterwards."""
    with ExitStack() as stack:
        if subject.document.get("middleware") == ROS2:
            folder = Path(stack.enter_context(TemporaryDirectory(prefix="rosarch-", ignore_cleanup_errors=True)))
            domain = stack.enter_context(free_domain())
            participant = stack.enter_context(Participant(python_with_ros(), domain, private=True))
            yield _Company2(subject, participant, domain, folder, stack)
        else:
            graph = stack.enter_context(private_graph())
            yield _Company1(subject, graph, stack.enter_context(Peer(graph.master.uri, NAME)))


class _Company1:
    patience = 5.0

    def __init__(self, subject: Subject, graph: PrivateGraph, peer: Peer) -> None:
        self._subject = subject
        self._graph = graph
        self._peer = peer
        self._heard: dict[str, list[float]] = defaultdict(list)

    def start(self, command: Sequence[str]) -> Process:
        return self._graph.start(Start(tuple(command), self._subject.name))

    def subscribe(self, place: Place) -> None:
        self._peer.subscribe(place.name, _listener(self._heard[place.port]))

    def advertise(self, place: Place) -> None:
        self._peer.advertise(place.name, MessageType(place.type, ANY))

    def readers(self, place: Place) -> int:
        return self._peer.readers(place.name)

    def publish(self, place: Place, values: Values) -> float:
        return self._peer.publish(place.name, self._subject.encoded(place, values))

    def call(self, place: Place, values: Values) -> None:
        self._peer.call(place.name, self._subject.encoded(place, values))

    def heard(self) -> Mapping[str, list[float]]:
        return {port: list(times) for port, times in self._heard.items()}

    def watched(self) -> Watched:
        graph = Graph(self._graph.master.uri)
        state = graph.state()
        for _ in range(_LOOKS):
            time.sleep(_REST)
            before, state = state, graph.state()
            if before == state:
                break
        return Watched(self._graph.master.uri, (graph.snapshot(),))


def _listener(times: list[float]) -> Heard:
    return lambda _sender, at, _message: times.append(at)


class _Company2:
    patience = 10.0

    def __init__(self, subject: Subject, participant: Participant, domain: int, folder: Path, stack: ExitStack) -> None:
        self._subject = subject
        self._participant = participant
        self._domain = domain
        self._folder = folder
        self._stack = stack
        self._ports: dict[str, list[str]] = defaultdict(list)
        self._heard: dict[str, list[float]] = defaultdict(list)

    def start(self, command: Sequence[str]) -> Process:
        own, log = self._subject.name.strip("/"), self._folder / "node.log"
        renamed = [] if self._subject.document.get("node_name") == own else ["--ros-args", "-r", f"__node:={own}"]
        try:
            process = Process([*command, *renamed], self._folder, log, environment(self._domain))
        except OSError as error:
            raise StartError(f"{command[0]}: {error.strerror}") from None
        self._stack.enter_context(process)
        if not wait_until(lambda: process.ended is not None or self._is_there(), self.patience, step=0.1):
            raise StartError(f"{self._subject.name} did not come up within {self.patience:g} s{last_line(log)}")
        if process.ended is not None:
            raise StartError(f"{self._subject.name} {process.ended}{last_line(log)}")
        time.sleep(_MEETING)
        return process

    def _is_there(self) -> bool:
        return self._subject.name in self._participant.ask("graph", parameters=False)["nodes"]

    def subscribe(self, place: Place) -> None:
        if not self._ports[place.name]:
            self._participant.ask("subscribe", topic=place.name, type=_full(place.type, "msg"))
        self._ports[place.name].append(place.port)

    def advertise(self, place: Place) -> None:
        self._participant.ask("advertise", topic=place.name, type=_full(place.type, "msg"))

    def readers(self, place: Place) -> int:
        return int(self._participant.ask("readers", topic=place.name))

    def publish(self, place: Place, values: Values) -> float:
        return float(self._participant.ask("publish", topic=place.name, values=values))

    def call(self, place: Place, values: Values) -> None:
        self._participant.ask("call", service=place.name, type=_full(place.type, "srv"), values=values)

    def heard(self) -> Mapping[str, list[float]]:
        for topic, times in self._participant.ask("heard").items():
            for port in self._ports[topic]:
                self._heard[port] += times
        return {port: list(times) for port, times in self._heard.items()}

    def watched(self) -> Watched:
        self._participant.settle()
        return Watched(f"domain {self._domain}", (self._participant.snapshot(),), self._domain)


def _full(type_: str, kind: str) -> str:
    """A type as ROS 2 writes it: `std_msgs/msg/Bool`."""
    package, _, name = type_.partition("/")
    return f"{package}/{kind}/{name}"
