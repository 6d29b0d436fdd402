"""A private graph: a master of its own on loopback, and the nodes that are started in it, all of which end with it."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

from rosarch.observation.graph import Graph
from rosarch.observation.master import Master
from rosarch.observation.processes import Process, wait_until
from rosarch.observation.rpc import LOOPBACK


class StartError(Exception):
    """A node that does not come up; the text is one line that says why."""


@dataclass(frozen=True)
class Start:
    """How a node is started: a command, its name and remappings."""

    command: tuple[str, ...]
    name: str
    remappings: Mapping[str, str] = field(default_factory=dict)


class PrivateGraph:
    """The nodes of a graph that nobody else sees; made by `private_graph`."""

    def __init__(self, master: Master, folder: Path, stack: ExitStack) -> None:
        self.master = master
        self._folder = folder
        self._stack = stack

    def environment(self) -> dict[str, str]:
        """What nodes find in their environment."""
        own = {"ROS_MASTER_URI": self.master.uri, "ROS_IP": LOOPBACK, "ROS_HOME": str(self._folder), "ROS_LOG_DIR": str(self._folder)}
        return {**{name: value for name, value in os.environ.items() if name not in ("ROS_HOSTNAME", "ROS_NAMESPACE")}, **own}

    def start(self, start: Start, seconds: float = 10.0) -> Process:
        """Start a node and wait until the graph knows it.

        Raises:
            StartError: it ended, or did not come up in time.
        """
        words = [f"{name}:={target}" for name, target in start.remappings.items()]
        namespace, _, own = start.name.rpartition("/")
        environment = {**self.environment(), **({"ROS_NAMESPACE": namespace} if namespace else {})}
        log = self._folder / f"{own}.log"
        command = [*start.command, f"__name:={own}", *words]
        try:
            process = self._stack.enter_context(Process(command, self._folder, log, environment))
        except OSError as error:
            raise StartError(f"{start.command[0]}: {error.strerror}") from None
        graph = Graph(self.master.uri)
        wait_until(lambda: process.ended is not None or start.name in graph.state().nodes(), seconds)
        if process.ended is not None:
            raise StartError(f"{start.name} {process.ended}{last_line(log)}")
        if start.name not in graph.state().nodes():
            raise StartError(f"{start.name} did not come up within {seconds:g} s{last_line(log)}")
        return process


def last_line(log: Path) -> str:
    """The last line that a process printed, as the end of a message."""
    lines = log.read_text(encoding="utf-8", errors="replace").strip().splitlines()
    return f": {lines[-1]}" if lines else ""


@contextmanager
def private_graph() -> Iterator[PrivateGraph]:
    """A private graph, of which nothing is left afterwards."""
    with TemporaryDirectory(prefix="rosarch-", ignore_cleanup_errors=True) as folder, ExitStack() as stack:
        yield PrivateGraph(stack.enter_context(Master()), Path(folder), stack)
