"""A participant of a graph of ROS 2. It is run as a program by a Python that has rclpy, and imports nothing of rosarch.

It answers requests, a line of JSON each, on its standard input; each answer is a line on its standard output. It ends with its input.
"""

from __future__ import annotations

import importlib
import json
import os
import sys
import threading
import time
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from typing import Any

NAME = "_rosarch"
_MOST = 10_000
"""Of one topic, so many times of messages are kept between two questions."""
_SECONDS = 3.0
"""So long a node may take for the answer to a question."""


def interface(name: str) -> Any:
    """The class of an interface: `std_msgs/msg/String`."""
    package, kind, leaf = name.split("/")
    return getattr(importlib.import_module(f"{package}.{kind}"), leaf)


def filled(message: Any, values: Mapping[str, Any]) -> Any:
    """A message whose fields, by their paths, have these values."""
    for path, value in values.items():
        *outer, last = path.split(".")
        part = message
        for name in outer:
            part = getattr(part, name)
        setattr(part, last, type(getattr(part, last))(value))
    return message


def qualities(profile: Any) -> dict[str, Any]:
    """A profile as names of its policies."""
    named = {policy: getattr(profile, policy).name.lower() for policy in ("reliability", "durability", "history", "liveliness")}
    return {**named, "depth": profile.depth}


class Participant:
    """A node of its own, on whose behalf requests are answered."""

    def __init__(self) -> None:
        import rclpy
        from rclpy.executors import SingleThreadedExecutor

        rclpy.init(args=[])
        self.node = rclpy.create_node(NAME, enable_rosout=False, start_parameter_services=False)
        self._executor = SingleThreadedExecutor()
        self._executor.add_node(self.node)
        self._publishers: dict[str, Any] = {}
        self._subscriptions: dict[str, Any] = {}
        self._clients: dict[tuple[str, str], Any] = {}
        self._heard: dict[str, list[float]] = defaultdict(list)
        threading.Thread(target=self._executor.spin, daemon=True).start()

    # -- the graph

    def graph(self, parameters: bool = True) -> dict[str, Any]:
        """Nodes with their ports and parameters; the types of what passes; those that did not answer."""
        from rclpy.action import graph as actions

        ports, types, silent, held = [], {}, {}, []
        nodes = sorted({(name, space) for name, space in self.node.get_node_names_and_namespaces() if name != NAME})
        asked = {
            "publisher": self.node.get_publisher_names_and_types_by_node, "subscriber": self.node.get_subscriber_names_and_types_by_node,
            "service_server": self.node.get_service_names_and_types_by_node, "service_client": self.node.get_client_names_and_types_by_node,
            "action_server": lambda *node: actions.get_action_server_names_and_types_by_node(self.node, *node),
            "action_client": lambda *node: actions.get_action_client_names_and_types_by_node(self.node, *node),
        }  # fmt: skip
        for name, space in nodes:
            full = f"{space.rstrip('/')}/{name}"
            for kind, ask in asked.items():
                try:
                    found = ask(name, space)
                except Exception as error:  # rclpy has many for a node that is gone
                    silent[full] = " ".join(str(error).split())
                    continue
                for port, port_types in found:
                    ports.append((kind, full, port))
                    types[kind.split("_")[0], port] = port_types[0]
            try:
                held += [f"{full}/{parameter}" for parameter in self._parameters(full)] if parameters else []
            except TimeoutError as error:
                silent[full] = str(error)
        return {
            "nodes": [f"{space.rstrip('/')}/{name}" for name, space in nodes], "ports": ports, "parameters": held, "silent": silent,
            "types": [[*key, type_] for key, type_ in types.items()], "qualities": list(self._qualities(ports)),
        }  # fmt: skip

    def _qualities(self, ports: list[tuple[str, str, str]]) -> Iterator[tuple[str, str, str, dict[str, Any]]]:
        """The qualities of service of publishers and subscribers: kind, node, topic, policies."""
        for kind, ask in (
            ("publisher", self.node.get_publishers_info_by_topic),
            ("subscriber", self.node.get_subscriptions_info_by_topic),
        ):
            for topic in sorted({name for port_kind, _, name in ports if port_kind == kind}):
                for info in ask(topic):
                    if info.node_name != NAME:
                        yield kind, f"{info.node_namespace.rstrip('/')}/{info.node_name}", topic, qualities(info.qos_profile)

    def _parameters(self, node: str) -> list[str]:
        """The names of the parameters of a node."""
        from rcl_interfaces.srv import ListParameters

        service = f"{node}/list_parameters"
        if not any(name == service for name, _ in self.node.get_service_names_and_types()):
            return []
        return list(self._answer(service, ListParameters, ListParameters.Request()).result.names)

    def _answer(self, service: str, kind: Any, request: Any) -> Any:
        """What a service answers.

        Raises:
            TimeoutError: nothing, in time.
        """
        client = self._clients.setdefault((service, kind.__name__), None) or self.node.create_client(kind, service)
        self._clients[service, kind.__name__] = client
        if client.wait_for_service(_SECONDS):
            future, done = client.call_async(request), threading.Event()
            future.add_done_callback(lambda _: done.set())
            if done.wait(_SECONDS):
                return future.result()
        raise TimeoutError(f"{service} does not answer")

    # -- the other end of a node

    def advertise(self, topic: str, type: str) -> None:
        """Be ready to send on a topic, to any reader."""
        from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

        lasting = QoSProfile(depth=10, reliability=ReliabilityPolicy.RELIABLE, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._publishers[topic] = self.node.create_publisher(interface(type), topic, lasting)

    def readers(self, topic: str) -> int:
        """How many read a topic."""
        return sum(info.node_name != NAME for info in self.node.get_subscriptions_info_by_topic(topic))

    def publish(self, topic: str, values: Mapping[str, Any]) -> float:
        """Send a message; when."""
        publisher = self._publishers[topic]
        message = filled(publisher.msg_type(), values)
        begin = time.monotonic()
        publisher.publish(message)
        return begin

    def subscribe(self, topic: str, type: str) -> None:
        """Note when something is sent on a topic, by whatever sender."""
        from rclpy.qos import QoSProfile, ReliabilityPolicy

        times = self._heard[topic]
        profile = QoSProfile(depth=100, reliability=ReliabilityPolicy.BEST_EFFORT)
        self._subscriptions[topic] = self.node.create_subscription(interface(type), topic, lambda _: _note(times), profile, raw=True)

    def heard(self) -> dict[str, list[float]]:
        """The times of messages since the last question, by topic."""
        found = {}
        for topic, times in self._heard.items():
            found[topic] = times[:]
            del times[: len(found[topic])]
        return found

    def call(self, service: str, type: str, values: Mapping[str, Any]) -> float:
        """Call a service; the seconds until its answer.

        Raises:
            TimeoutError: there is none.
        """
        kind = interface(type)
        request = filled(kind.Request(), values)
        begin = time.monotonic()
        self._answer(service, kind, request)
        return time.monotonic() - begin


def _note(times: list[float]) -> None:
    if len(times) < _MOST:
        times.append(time.monotonic())


REQUESTS: tuple[Callable[..., Any], ...] = (
    Participant.graph, Participant.advertise, Participant.readers, Participant.publish, Participant.subscribe, Participant.heard,
    Participant.call,
)  # fmt: skip


def main() -> None:
    """Answer requests until there are no more."""
    answers = os.fdopen(os.dup(1), "w", buffering=1)  # what the libraries print does not mix with the answers
    os.dup2(2, 1)
    known = {request.__name__: request for request in REQUESTS}
    participant = Participant()
    print(json.dumps({"answer": "ready"}), file=answers)
    for line in sys.stdin:
        request = json.loads(line)
        try:
            answer = {"answer": known[request.pop("do")](participant, **request)}
        except TimeoutError as error:
            answer = {"error": str(error)}
        except Exception as error:  # of whatever kind: who asks gets it
            answer = {"error": " ".join(f"{type(error).__name__}: {error}".split())}
        print(json.dumps(answer), file=answers)
    with suppress(Exception):
        participant.node.destroy_node()
    os._exit(0)


if __name__ == "__main__":
    main()
