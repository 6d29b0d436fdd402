"""A private master: the registry and the parameters of a ROS 1 graph, in this process, on loopback.

It follows http://wiki.ros.org/ROS/Master_API and http://wiki.ros.org/ROS/Parameter%20Server%20API. Since every node asks it, it knows more
than a master reports: which parameters each node reads, and which services it looks up.
"""

from __future__ import annotations

import os
import queue
import threading
from collections import defaultdict
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

from rosarch.observation.parameters import Parameters
from rosarch.observation.rpc import CallError, Remote, Server

NAME = "/master"
_SIDES = ("publisher", "subscriber")


class Master:
    """The master of a private graph; `with Master() as master` ends it in any case."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._nodes: dict[str, str] = {}
        self._ends: dict[str, dict[str, list[str]]] = {side: defaultdict(list) for side in _SIDES}
        self._services: dict[str, tuple[str, str]] = {}
        self._types: dict[str, str] = {}
        self._watching: dict[str, set[str]] = defaultdict(set)
        self.parameters = Parameters()
        self.asked: set[tuple[str, str, str]] = set()
        """Who asked what about which name: (caller, `parameter` or `service`, absolute name)."""
        self._notices: queue.SimpleQueue[tuple[str, str, tuple[Any, ...]] | None] = queue.SimpleQueue()
        self._server = Server({name: getattr(self, f"_{_snake(name)}") for name in _METHODS})
        self.uri = self._server.uri
        threading.Thread(target=self._notify_nodes, daemon=True).start()

    def __enter__(self) -> Master:
        return self

    def __exit__(self, *_: object) -> None:
        self._notices.put(None)
        self._server.close()

    def _notify_nodes(self) -> None:
        """Notify nodes of what has changed, one after the other, in the order of the changes."""
        while (job := self._notices.get()) is not None:
            api, method, arguments = job
            with suppress(CallError):
                Remote(api, NAME, 1.0).call(method, *arguments)

    # registration

    def _join(self, caller: str, api: str) -> None:
        known = self._nodes.get(caller)
        if known is not None and known != api:  # two nodes of one name: the older one has to go
            self._notices.put((known, "shutdown", (f"new node registered as {caller}",)))
            self._leave(caller)
        self._nodes[caller] = api

    def _leave(self, caller: str) -> None:
        for side, topics in self._ends.items():
            for topic in [topic for topic, callers in topics.items() if caller in callers]:
                self._drop(side, caller, topic)
        for service in [service for service, (owner, _) in self._services.items() if owner == caller]:
            del self._services[service]
        self._nodes.pop(caller, None)

    def _register(self, side: str, caller: str, topic: str, type_: str, api: str) -> None:
        self._join(caller, api)
        if caller not in self._ends[side][topic]:
            self._ends[side][topic].append(caller)
        if type_ != "*" or topic not in self._types:
            self._types[topic] = type_

    def _drop(self, side: str, caller: str, topic: str) -> int:
        callers = self._ends[side][topic]
        if caller not in callers:
            return 0
        callers.remove(caller)
        if side == "publisher":
            self._announce(topic)
        return 1

    def _apis(self, side: str, topic: str) -> list[str]:
        return [self._nodes[caller] for caller in self._ends[side][topic]]

    def _announce(self, topic: str) -> None:
        for api in self._apis("subscriber", topic):
            self._notices.put((api, "publisherUpdate", (topic, self._apis("publisher", topic))))

    def _register_publisher(self, caller: str, topic: str, type_: str, api: str) -> list[str]:
        with self._lock:
            self._register("publisher", caller, topic, type_, api)
            self._announce(topic)
            return self._apis("subscriber", topic)

    def _register_subscriber(self, caller: str, topic: str, type_: str, api: str) -> list[str]:
        with self._lock:
            self._register("subscriber", caller, topic, type_, api)
            return self._apis("publisher", topic)

    def _unregister_publisher(self, caller: str, topic: str, _api: str) -> int:
        with self._lock:
            return self._drop("publisher", caller, topic)

    def _unregister_subscriber(self, caller: str, topic: str, _api: str) -> int:
        with self._lock:
            return self._drop("subscriber", caller, topic)

    def _register_service(self, caller: str, service: str, service_api: str, api: str) -> int:
        with self._lock:
            self._join(caller, api)
            self._services[service] = (caller, service_api)
            return 1

    def _unregister_service(self, _caller: str, service: str, service_api: str) -> int:
        with self._lock:
            if self._services.get(service, ("", ""))[1] != service_api:
                return 0
            del self._services[service]
            return 1

    # questions about the graph

    def _lookup_node(self, _caller: str, node: str) -> str:
        return self._nodes[node]

    def _lookup_service(self, caller: str, service: str) -> str:
        self.asked.add((caller, "service", service))
        return self._services[service][1]

    def _get_system_state(self, _caller: str) -> list[list[list[Any]]]:
        with self._lock:
            ends = [[[topic, list(callers)] for topic, callers in self._ends[side].items() if callers] for side in _SIDES]
            return [*ends, [[service, [caller]] for service, (caller, _) in self._services.items()]]

    def _get_topic_types(self, _caller: str) -> list[list[str]]:
        with self._lock:
            return [list(item) for item in self._types.items()]

    def _get_published_topics(self, _caller: str, below: str) -> list[list[str]]:
        with self._lock:
            published = [topic for topic, callers in self._ends["publisher"].items() if callers]
            return [[topic, self._types[topic]] for topic in published if topic.startswith(f"{below.rstrip('/')}/")]

    def _get_uri(self, _caller: str) -> str:
        return self.uri

    def _get_pid(self, _caller: str) -> int:
        return os.getpid()

    # parameters

    def _get_param(self, caller: str, key: str) -> Any:
        return self.parameters.value(self._asked(caller, key))

    def _has_param(self, caller: str, key: str) -> bool:
        return self.parameters.has(self._asked(caller, key))

    def _set_param(self, caller: str, key: str, value: Any) -> int:
        name = self.parameters.absolute(caller, key)
        with self._lock:
            self.parameters.set(name, value)
            for watched in [watched for watched in self._watching if watched == name or watched.startswith(f"{name}/")]:
                for api in self._watching[watched]:
                    self._notices.put((api, "paramUpdate", (watched, self.parameters.value(watched))))
        return 0

    def _delete_param(self, caller: str, key: str) -> int:
        with self._lock:
            self.parameters.delete(self.parameters.absolute(caller, key))
        return 0

    def _search_param(self, caller: str, key: str) -> str:
        self._asked(caller, key)
        return self.parameters.search(caller, key)

    def _subscribe_param(self, caller: str, api: str, key: str) -> Any:
        name = self._asked(caller, key)
        with self._lock:
            self._watching[name].add(api)
            return self.parameters.value(name) if self.parameters.has(name) else {}

    def _unsubscribe_param(self, caller: str, api: str, key: str) -> int:
        with self._lock:
            self._watching[self.parameters.absolute(caller, key)].discard(api)
        return 1

    def _get_param_names(self, _caller: str) -> list[str]:
        with self._lock:
            return self.parameters.names()

    def _asked(self, caller: str, key: str) -> str:
        name = self.parameters.absolute(caller, key)
        self.asked.add((caller, "parameter", name))
        return name


_METHODS = (
    "registerPublisher", "registerSubscriber", "unregisterPublisher", "unregisterSubscriber", "registerService", "unregisterService",
    "lookupNode", "lookupService", "getSystemState", "getTopicTypes", "getPublishedTopics", "getUri", "getPid",
    "getParam", "hasParam", "setParam", "deleteParam", "searchParam", "subscribeParam", "unsubscribeParam", "getParamNames",
)  # fmt: skip


def _snake(name: str) -> str:
    return "".join(_snakes(name))


def _snakes(name: str) -> Iterator[str]:
    for letter in name:
        yield f"_{letter.lower()}" if letter.isupper() else letter
