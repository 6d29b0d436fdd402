"""The connectors of a composed system with the ports at their ends, for what selects, merges and compares them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from rosarch.models.system.model import CONNECTOR_KINDS, Connector, SystemModel, SystemPort

TRANSFORMS = "tf"
KINDS = (*CONNECTOR_KINDS, TRANSFORMS)
_TRANSFORM_PORTS = ("tf_broadcaster", "tf_listener")


@dataclass(frozen=True)
class End:
    """A port at a connector; `node` is the id of a node or of what it was merged into."""

    node: str
    port: SystemPort
    conditional: bool


@dataclass(frozen=True)
class Link:
    """A connector with the ends that are shown."""

    kind: str
    names: tuple[str, ...]
    types: tuple[str, ...]
    one_sided: bool
    sources: tuple[End, ...]
    sinks: tuple[End, ...]

    @property
    def ends(self) -> tuple[End, ...]:
        return (*self.sources, *self.sinks)


def connector_kind(connector: Connector, ports: Mapping[tuple[str, str], SystemPort]) -> str:
    """The kind of a connector, where topics of transforms are one of their own."""
    ends = (ports[end].kind for end in (*connector.sources, *connector.sinks) if end in ports)
    return TRANSFORMS if any(kind in _TRANSFORM_PORTS for kind in ends) else connector.kind


def is_implicit(connector: Connector, ports: Mapping[tuple[str, str], SystemPort]) -> bool:
    """Whether only libraries make the ports of a connector."""
    ends = [ports[end] for end in (*connector.sources, *connector.sinks) if end in ports]
    return bool(ends) and all(port.implicit for port in ends)


def ports_of(system: SystemModel) -> dict[tuple[str, str], SystemPort]:
    """The ports of all nodes by what connectors call them."""
    return {(node.id, port.id): port for node in system.nodes for port in node.ports}


def neighbourhood(start: set[str], links: Iterable[Link], hops: int) -> set[str]:
    """The nodes that are reached through up to `hops` connectors."""
    members = [{end.node for end in link.ends} for link in links]
    found = set(start)
    for _ in range(hops):
        reached = found.union(*(ends for ends in members if ends & found))
        if reached == found:
            break
        found = reached
    return found


def cut(link: Link, nodes: set[str]) -> Link:
    """The connector with its ends at `nodes` only."""
    kept = [tuple(end for end in ends if end.node in nodes) for ends in (link.sources, link.sinks)]
    return replace(link, sources=kept[0], sinks=kept[1])


def moved(link: Link, ids: Mapping[str, str]) -> Link:
    """The connector with other ids of nodes."""
    sources, sinks = (tuple(replace(end, node=ids[end.node]) for end in ends) for ends in (link.sources, link.sinks))
    return replace(link, sources=sources, sinks=sinks)


def merged(links: Iterable[Link], hidden: dict[str, int]) -> list[Link]:
    """Connectors with the same ends as one; those within one group are no longer seen."""
    together: dict[tuple[str, bool, frozenset[str], frozenset[str]], list[Link]] = defaultdict(list)
    for link in links:
        sources, sinks = frozenset(end.node for end in link.sources), frozenset(end.node for end in link.sinks)
        if sources and sources == sinks and len(sources) == 1:
            hidden["inside"] += 1
        else:
            together[link.kind, link.one_sided, sources, sinks].append(link)
    return [
        Link(
            kind,
            tuple(sorted({name for link in same for name in link.names})),
            tuple(sorted({type_ for link in same for type_ in link.types})),
            one_sided,
            tuple(end for link in same for end in link.sources),
            tuple(end for link in same for end in link.sinks),
        )
        for (kind, one_sided, _, _), same in together.items()
    ]


def by_node(ends: Iterable[End]) -> list[tuple[str, list[End]]]:
    """The ends by node, sorted."""
    found: dict[str, list[End]] = defaultdict(list)
    for end in ends:
        found[end.node].append(end)
    return sorted(found.items())
