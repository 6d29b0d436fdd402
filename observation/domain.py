"""A live graph of ROS 2, through a participant that is run by a Python with rclpy; and domains that nobody else uses."""

from __future__ import annotations

import json
import os
import random
import select
import shutil
import socket
import subprocess
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from rosarch.observation.graph import Snapshot, State, snapshots
from rosarch.observation.processes import Process
from rosarch.observation.recording import plain_type
from rosarch.observation.rpc import LOOPBACK, CallError

VARIABLE = "ROSARCH_ROS2_PYTHON"
_PROGRAM = Path(__file__).with_name("participant.py")
_FIRST_PORT, _PORTS = 7400, 250
_DOMAINS = range(1, 101)
"""Those whose ports are not among the ones that systems give away."""
_START, _ANSWER = 20.0, 15.0
_REST, _FEWEST, _MOST = 0.5, 5, 20
"""A participant has met all when so many seconds nothing was added to the graph; it looks so often at least and at most."""


def python_with_ros() -> str:
    """The Python that has rclpy.

    Raises:
        CallError: there is none.
    """
    named = os.environ.get(VARIABLE)
    for program in [named] if named else ["python3", "python"]:
        found = shutil.which(program)
        if found and subprocess.run([found, "-c", "import rclpy"], capture_output=True, check=False).returncode == 0:
            return found
    told = f"{named}, which {VARIABLE} names, has" if named else "no python3 on PATH has"
    raise CallError(f"{told} no rclpy: source ROS 2, or let {VARIABLE} name a Python that has it")


def environment(domain: int) -> dict[str, str]:
    """What keeps a program in a domain, on this machine."""
    own = {
        "ROS_DOMAIN_ID": str(domain), "ROS_LOCALHOST_ONLY": "1", "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "FASTDDS_BUILTIN_TRANSPORTS": "UDPv4", "PYTHONUNBUFFERED": "1",
    }  # fmt: skip
    return {**{name: value for name, value in os.environ.items() if name != "ROS_STATIC_PEERS"}, **own}


class Participant:
    """A participant that runs; `with` ends it."""

    def __init__(self, python: str, domain: int, *, private: bool) -> None:
        self._folder = Path(tempfile.mkdtemp(prefix="rosarch-"))
        own = environment(domain)
        if not private:
            own = {**os.environ, "ROS_DOMAIN_ID": str(domain)}
        self._log = self._folder / "participant.log"
        requests, self._requests = os.pipe()
        self._answers, answers = os.pipe()
        try:
            self._process = Process([python, str(_PROGRAM)], self._folder, self._log, own, requests, answers)
        finally:
            os.close(requests)
            os.close(answers)
        self._left = b""
        self._line(_START)

    def __enter__(self) -> Participant:
        return self

    def __exit__(self, *_: object) -> None:
        for end in (self._requests, self._answers):
            with suppress(OSError):
                os.close(end)
        self._process.stop()
        shutil.rmtree(self._folder, ignore_errors=True)

    def ask(self, request: str, **arguments: Any) -> Any:
        """What the participant answers.

        Raises:
            CallError: it has ended, does not answer, or cannot do it.
        """
        try:
            os.write(self._requests, json.dumps({"do": request, **arguments}).encode() + b"\n")
        except OSError:
            raise CallError(f"the participant {self._process.ended or 'is gone'}") from None
        return self._line(_ANSWER)

    def _line(self, seconds: float) -> Any:
        end = time.monotonic() + seconds
        while b"\n" not in self._left:
            ready, _, _ = select.select([self._answers], [], [], max(0.0, end - time.monotonic()))
            data = os.read(self._answers, 1 << 20) if ready else b""
            if not data:
                lines = self._log.read_text(encoding="utf-8", errors="replace").strip().splitlines()
                raise CallError(
                    f"no participant of ROS 2{f': {lines[-1]}' if lines else ''}" if ready else "the participant does not answer"
                )
            self._left += data
        line, _, self._left = self._left.partition(b"\n")
        answer = json.loads(line)
        if "error" in answer:
            raise CallError(answer["error"])
        return answer["answer"]

    def settle(self) -> None:
        """Wait until the graph does not change any more, or has changed for too long."""
        before: Any = None
        for look in range(_MOST):
            time.sleep(_REST)
            now = self.ask("graph", parameters=False)
            if now == before and look >= _FEWEST:
                break
            before = now

    def snapshot(self, at: float = 0.0) -> Snapshot:
        """The graph as it is now."""
        return _snapshot(self.ask("graph"), at)


_KINDS = {"publisher": "topic", "subscriber": "topic", "service": "service", "action": "action"}
"""What types are those of, by the first word of the kinds of ports."""


def _snapshot(found: Mapping[str, Any], at: float) -> Snapshot:
    ports = [(str(kind), str(node), str(name)) for kind, node, name in found["ports"]]
    publishers, subscribers, services = (
        frozenset((node, name) for kind, node, name in ports if kind == wanted) for wanted in ("publisher", "subscriber", "service_server")
    )
    others = frozenset(port for port in ports if port[0] not in ("publisher", "subscriber", "service_server"))
    types = {(_KINDS[kind], name): plain_type(type_) for kind, name, type_ in found["types"]}
    state = State(publishers, subscribers, services, others, frozenset(found["nodes"]))
    return Snapshot(at, state, types, frozenset(found["parameters"]), frozenset(), dict(found["silent"]))


def watch_domain(domain: int, seconds: float, every: float) -> Iterator[Snapshot]:
    """A snapshot of a domain now and then another one `every` so many seconds, until `seconds` have passed.

    Raises:
        CallError: there is no Python with rclpy, or it does not answer.
    """
    with Participant(python_with_ros(), domain, private=False) as participant:
        participant.settle()
        yield from snapshots(participant.snapshot, seconds, every)


@contextmanager
def free_domain() -> Iterator[int]:
    """A domain that no program of this machine uses.

    Raises:
        CallError: all are in use.
    """
    used = _used_domains()
    for domain in random.sample(_DOMAINS, len(_DOMAINS)):
        if domain in used:
            continue
        with _locked(domain) as is_ours:
            if is_ours:
                yield domain
                return
    raise CallError("all domains of ROS 2 are in use")


@contextmanager
def _locked(domain: int) -> Iterator[bool]:
    """Keep other runs of rosarch out of a domain, by a port that DDS does not use; whether none is in it."""
    with socket.socket() as lock:
        try:
            lock.bind((LOOPBACK, _FIRST_PORT + _PORTS * domain))
        except OSError:
            yield False
        else:
            yield True


def _used_domains() -> set[int]:
    """The domains on whose ports something listens."""
    ports = set()
    for table in ("/proc/net/udp", "/proc/net/udp6"):
        with suppress(OSError, ValueError, IndexError):
            for line in Path(table).read_text(encoding="ascii").splitlines()[1:]:
                ports.add(int(line.split()[1].rpartition(":")[2], 16))
    return {(port - _FIRST_PORT) // _PORTS for port in ports if port >= _FIRST_PORT}
