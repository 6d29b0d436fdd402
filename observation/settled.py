"""Names that the sources leave open, as the running node has them."""

from __future__ import annotations

import time
from collections.abc import Sequence
from pathlib import Path

from rosarch.analysis.systems.interfaces import model_rows
from rosarch.extractor.launch.facts import launch_rows
from rosarch.extractor.launch.model import Composition, NodeStart, Place
from rosarch.models.component import ComponentModel
from rosarch.models.system.rows import merged
from rosarch.observation.compare import Filled, compare
from rosarch.observation.graph import Graph, Snapshot
from rosarch.observation.observed import Watched, watched_rows
from rosarch.observation.private import Start, private_graph
from rosarch.rule_programs.sets import SystemRules

_REST = 0.3
"""Seconds in which nothing was added to the graph: then the node is taken to be complete."""
_LOOKS = 30


def is_open(model: ComponentModel) -> bool:
    """Whether the model leaves a name open."""
    return any("?" in port.name for port in model.ports)


def settle(model: ComponentModel, name: str, command: Sequence[str], rules: SystemRules, engine: str) -> tuple[Filled, ...]:
    """Start the node in a private graph, and report what it has where its model leaves a name open: several names of one port are possible.

    Raises:
        StartError: it does not come up.
        CallError: it is gone before it was looked at.
    """
    with private_graph() as graph:
        graph.start(Start(tuple(command), name))
        watched = Watched(graph.master.uri, (_settled(Graph(graph.master.uri)),))
    start = NodeStart(model.package, model.types[0], name.strip("/"), "/", (Place(command[0], 1, 1),))
    composition = Composition(nodes=(start,), tests=(), params=(), includes=(), problems=(), files=())
    rows = merged([launch_rows(composition, Path()), model_rows(model)])
    found = compare(rules, name, rows, watched_rows(watched), engine)
    return tuple(filled for filled in found.filled if filled.what == "name")


def _settled(graph: Graph) -> Snapshot:
    """The graph when it does not change any more, or has changed for too long."""
    state = graph.state()
    for _ in range(_LOOKS):
        time.sleep(_REST)
        before, state = state, graph.state()
        if before == state:
            break
    return graph.snapshot()
