"""A node of a graph in this process: it reads and sends messages as bytes and calls services; what they mean is not its matter."""

from __future__ import annotations

import os
import socket
import threading
import time
from collections import defaultdict
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import urlsplit

from rosarch.observation.rpc import LOOPBACK, CallError, Remote, Server
from rosarch.observation.wire import WireError, packed_fields, receive, receive_block, receive_fields, send_block

ANY = "*"
Heard = Callable[[str, float, bytes], None]
"""What is done with a message: its sender, the time of `time.monotonic`, and its bytes."""


@dataclass(frozen=True)
class MessageType:
    """What two ends of a topic must agree on."""

    name: str
    checksum: str
    definition: str = ""


@dataclass
class _Sending:
    type: MessageType
    readers: dict[socket.socket, str] = field(default_factory=dict)


class Peer:
    """A node called `name`; `with Peer(...) as peer` takes it out of the graph again."""

    def __init__(self, master: str, name: str, seconds: float = 3.0) -> None:
        self.name = name
        self._seconds = seconds
        self._master = Remote(master, name, seconds)
        self._lock = threading.Lock()
        self._open: list[socket.socket] = []
        self._heard: dict[str, tuple[str, Heard]] = {}
        self._joined: dict[str, set[str]] = defaultdict(set)
        self._sending: dict[str, _Sending] = {}
        self._listener = socket.create_server((LOOPBACK, 0), backlog=64)
        self._server = Server({
            "publisherUpdate": self._publishers_changed, "requestTopic": self._request_topic, "getPid": lambda _caller: os.getpid(),
            "getBusInfo": self._connections, "getBusStats": lambda _caller: [[], [], []], "getMasterUri": lambda _caller: master,
            "getSubscriptions": lambda _caller: [[topic, type_] for topic, (type_, _) in self._heard.items()],
            "getPublications": lambda _caller: [[topic, sending.type.name] for topic, sending in self._sending.items()],
            "paramUpdate": lambda _caller, _key, _value: 0, "shutdown": lambda _caller, _reason: 0,
        })  # fmt: skip
        threading.Thread(target=self._accept, daemon=True).start()

    def __enter__(self) -> Peer:
        return self

    def __exit__(self, *_: object) -> None:
        for method, topics in (("unregisterSubscriber", list(self._heard)), ("unregisterPublisher", list(self._sending))):
            for topic in topics:
                with suppress(CallError):
                    self._master.call(method, topic, self._server.uri)
        self._server.close()
        for connection in (self._listener, *self._open):
            with suppress(OSError):
                connection.shutdown(socket.SHUT_RDWR)
            connection.close()

    # reading

    def subscribe(self, topic: str, heard: Heard, type_: str = ANY) -> None:
        """Read `topic`, whatever sends there."""
        self._heard[topic] = (type_, heard)
        self._join(topic, self._master.call("registerSubscriber", topic, type_, self._server.uri))

    def _publishers_changed(self, _caller: str, topic: str, apis: Sequence[str]) -> int:
        self._join(topic, apis)
        return 0

    def _join(self, topic: str, apis: Sequence[str]) -> None:
        with self._lock:
            new = [api for api in apis if api not in self._joined[topic] and api != self._server.uri]
            self._joined[topic] = {*self._joined[topic].intersection(apis), *new}
        for api in new:
            threading.Thread(target=self._read, args=(topic, api), daemon=True).start()

    def _read(self, topic: str, api: str) -> None:
        type_, heard = self._heard[topic]
        with suppress(CallError, WireError, OSError, LookupError, ValueError, TypeError):
            _, host, port = Remote(api, self.name, self._seconds).call("requestTopic", topic, [["TCPROS"]])
            connection = self._connect(host, port)
            told = {"callerid": self.name, "topic": topic, "type": type_, "md5sum": ANY, "tcp_nodelay": "1"}
            send_block(connection, packed_fields(told))
            sender = receive_fields(connection).get("callerid", api)
            connection.settimeout(None)
            while True:
                message = receive_block(connection)
                heard(sender, time.monotonic(), message)
        with self._lock:
            self._joined[topic].discard(api)

    def _connect(self, host: str, port: int) -> socket.socket:
        connection = socket.create_connection((host, port), self._seconds)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._open.append(connection)
        return connection

    # sending

    def advertise(self, topic: str, type_: MessageType) -> None:
        """Be one who sends on `topic`."""
        self._sending[topic] = _Sending(type_)
        self._master.call("registerPublisher", topic, type_.name, self._server.uri)

    def readers(self, topic: str) -> int:
        """How many read what is sent on `topic`."""
        return len(self._sending[topic].readers)

    def publish(self, topic: str, message: bytes) -> float:
        """Send a message to all who read `topic`; the time of `time.monotonic` just before."""
        sent = time.monotonic()
        readers = self._sending[topic].readers
        for connection in list(readers):
            try:
                send_block(connection, message)
            except OSError:
                readers.pop(connection, None)
        return sent

    def _request_topic(self, _caller: str, topic: str, _protocols: Any) -> list[Any]:
        if topic not in self._sending:
            raise LookupError(f"nothing is sent on {topic}")
        return ["TCPROS", LOOPBACK, self._listener.getsockname()[1]]

    def _connections(self, _caller: str) -> list[list[Any]]:
        found = [(reader, topic) for topic, sending in self._sending.items() for reader in list(sending.readers.values())]
        return [[number, reader, "o", "TCPROS", topic, True] for number, (reader, topic) in enumerate(found)]

    def _accept(self) -> None:
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            self._open.append(connection)
            threading.Thread(target=self._greet, args=(connection,), daemon=True).start()

    def _greet(self, connection: socket.socket) -> None:
        with suppress(WireError, OSError):
            connection.settimeout(self._seconds)
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            fields = receive_fields(connection)
            sending = self._sending.get(fields.get("topic", ""))
            if sending is None:
                connection.close()
                return
            told = {"callerid": self.name, "type": sending.type.name, "md5sum": sending.type.checksum, "latching": "0"}
            send_block(connection, packed_fields({**told, "message_definition": sending.type.definition}))
            sending.readers[connection] = fields.get("callerid", "?")

    # services

    def call(self, service: str, request: bytes) -> tuple[bool, bytes]:
        """Call a service: whether it succeeded, and its response, or else what went wrong.

        Raises:
            CallError: nobody serves it, or the connection broke.
        """
        try:
            connection, _ = self._call_service(service, {"persistent": "0"})
            with connection:
                send_block(connection, request)
                return receive(connection, 1) == b"\1", receive_block(connection)
        except (WireError, OSError) as error:
            raise CallError(f"{service}: {error}") from None

    def service_type(self, service: str) -> MessageType:
        """What is served.

        Raises:
            CallError: nobody answers.
        """
        try:
            connection, fields = self._call_service(service, {"probe": "1"})
        except (WireError, OSError) as error:
            raise CallError(f"{service}: {error}") from None
        connection.close()
        return MessageType(fields.get("type", ANY), fields.get("md5sum", ANY))

    def _call_service(self, service: str, more: dict[str, str]) -> tuple[socket.socket, dict[str, str]]:
        address = urlsplit(self._master.call("lookupService", service))
        connection = socket.create_connection((address.hostname, address.port), self._seconds)
        send_block(connection, packed_fields({"callerid": self.name, "service": service, "md5sum": ANY, **more}))
        return connection, receive_fields(connection)
