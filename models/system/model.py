"""The model of a composed system, as plain data."""

from __future__ import annotations

from dataclasses import dataclass

from rosarch.base.places import Place
from rosarch.models.openness import OpenPart

CONNECTOR_KINDS = ("topic", "service", "action")


@dataclass(frozen=True)
class SystemPort:
    """A port of a node that is started.

    `name` is that of the ROS graph, after namespaces, parameters and remappings; "?" stands for a part that is not known. `written` is the
    name in the component's model. `id` is unique in the node, `at` is None for ports of the library of interfaces.
    """

    id: str
    kind: str
    name: str
    written: str
    type: str | None
    at: Place | None
    implicit: bool = False
    conditional: str | None = None


@dataclass(frozen=True)
class SystemNode:
    """A node that is started.

    `id` distinguishes nodes of the same name. `component` is `package/name` of its model; `origin` says where that is from: `source`,
    `library`, or `unknown` when there is none; a host of nodelets, which has no ports to speak of, is known without one. `lines` lead from
    the launch file given to the `<node>`, `conditions` are those that launch files leave open. `open` nodes may have more ports than are
    known. `rates` are those of timed loops and timers by place, as often a second as launch files make them; the loops at `serving` handle
    the messages that have come. `settings` are parameters, as the component calls them, with the kinds and texts of their values.
    """

    id: str
    name: str
    package: str
    type: str
    origin: str
    component: str | None
    lines: tuple[Place, ...]
    ports: tuple[SystemPort, ...]
    conditions: tuple[str, ...] = ()
    open: bool = False
    rates: tuple[tuple[Place, float], ...] = ()
    serving: tuple[Place, ...] = ()
    settings: tuple[tuple[str, str, str], ...] = ()


@dataclass(frozen=True)
class Connector:
    """A topic, service or action that ports meet at; `sources` send or call, `sinks` receive or serve: pairs of node id and port id.

    At one that is `open` there may be ports that are not known.
    """

    kind: str
    name: str
    types: tuple[str, ...]
    sources: tuple[tuple[str, str], ...]
    sinks: tuple[tuple[str, str], ...]
    open: bool = False


@dataclass(frozen=True)
class Inclusion:
    """A launch file that another one includes, at `at`; `file` is None when it is not there."""

    at: Place
    text: str
    file: str | None


@dataclass(frozen=True)
class SystemModel:
    """One composed system.

    `name` distinguishes it from others of the workspace, `launch` are the launch files (relative) with their arguments, `unseen` is what of
    it may be there and is not known.
    """

    name: str
    launch: tuple[str, ...]
    nodes: tuple[SystemNode, ...]
    connectors: tuple[Connector, ...]
    inclusions: tuple[Inclusion, ...] = ()
    unseen: tuple[OpenPart, ...] = ()
