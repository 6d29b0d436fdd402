"""Systems that are written by hand, as YAML: the documents of their nodes, which meet at topics of the same name."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection
from pathlib import Path
from typing import Any

import yaml

from rosarch.base.places import Place
from rosarch.behavior.composition.system import System, composed
from rosarch.models.system.model import Connector, SystemModel, SystemNode

_SOURCES = ("publisher", "service_client")


def load(file: Path) -> dict[str, Any]:
    data: dict[str, Any] = yaml.safe_load(file.read_text("utf-8"))
    return data


def system_of(
    nodes: dict[str, dict[str, Any]],
    unknown: dict[str, list[str]] | None = None,
    serving: dict[str, tuple[Place, float]] | None = None,
    *,
    settings: dict[str, list[tuple[str, str, str]]] | None = None,
    opened: Collection[str] = (),
    condition: str | None = None,
) -> System:
    """The system; `unknown` nodes have no behaviour, only topics that they send to; loops that are `serving` handle the messages of nodes.

    There may be more ports at topics that are `opened`; all nodes are started under the `condition`. `settings`
    are parameters of nodes with the kinds and texts of their values.
    """
    ends: dict[tuple[str, str], tuple[list[tuple[str, str]], list[tuple[str, str]]]] = defaultdict(lambda: ([], []))
    for name, document in nodes.items():
        for port in document["ports"]:
            kind = next((asked for asked in ("service", "action") if asked in port["kind"]), "topic")
            ends[kind, port["name"]][port["kind"] not in _SOURCES].append((f"/{name}", port["id"]))
    for name, topics in (unknown or {}).items():
        for topic in topics:
            ends["topic", topic][0].append((f"/{name}", "p1"))
    loops = {name: (loop,) for name, loop in (serving or {}).items()}
    started = [
        SystemNode(
            f"/{name}", f"/{name}", "p", name, "source", f"p/{name}", (), (), (condition,) if condition else (),
            rates=loops.get(name, ()), serving=tuple(place for place, _ in loops.get(name, ())),
            settings=tuple((settings or {}).get(name, ())),
        )
        for name in nodes
    ]  # fmt: skip
    started += [SystemNode(f"/{name}", f"/{name}", "q", name, "unknown", None, (), ()) for name in unknown or ()]
    connectors = tuple(
        Connector(kind, topic, (), tuple(sources), tuple(sinks), topic in opened) for (kind, topic), (sources, sinks) in ends.items()
    )
    return composed(SystemModel("by hand", (), tuple(started), connectors), {f"p/{name}": document for name, document in nodes.items()})
