"""What of a composed system a drawing shows: nodes and connectors that are chosen, gathered and merged; the same for every format."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fnmatch import fnmatchcase

from rosarch.base.places import Place
from rosarch.models.component import component_of
from rosarch.models.system.links import KINDS, End, Link, by_node, connector_kind, cut, is_implicit, merged, moved, neighbourhood, ports_of
from rosarch.models.system.model import CONNECTOR_KINDS, SystemModel, SystemNode


class UnknownName(Exception):
    """A name that nothing in the system has; `candidates` are those that it could have been."""

    def __init__(self, name: str, known: Iterable[str]) -> None:
        super().__init__(name)
        self.name = name
        self.candidates = frozenset(known)


@dataclass(frozen=True)
class Selection:
    """What is shown of a system; patterns are those of file names, in which `*` stands for anything.

    Of `focus`, node names or patterns, what is up to `hops` connectors away is shown. `kinds` of connectors are shown, `TRANSFORMS` being
    topics of transforms; the rest of those that only libraries make, such as the status of an action, with `implicit`. Without `leaves`,
    connectors with one side only are left out. Nodes of one namespace or package, by `collapse`, are one; by `group`, they stand together;
    of namespaces, the first `depth` names count. Without `connectors`, edges lead from node to node.
    """

    nodes: tuple[str, ...] = ()
    exclude: tuple[str, ...] = ()
    namespaces: tuple[str, ...] = ()
    packages: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    kinds: tuple[str, ...] = CONNECTOR_KINDS
    focus: tuple[str, ...] = ()
    hops: int = 1
    implicit: bool = False
    leaves: bool = True
    collapse: str | None = None
    group: str | None = None
    depth: int = 1
    connectors: bool = True


@dataclass(frozen=True)
class ViewNode:
    """A node, or with `members` (names) all nodes of a namespace or package. `lines` lead to the launch line that starts it."""

    id: str
    name: str
    package: str
    type: str
    origin: str
    component: str | None
    lines: tuple[Place, ...]
    conditions: tuple[str, ...]
    open: bool
    group: str | None = None
    members: tuple[str, ...] = ()


@dataclass(frozen=True)
class ViewConnector:
    """A connector, or several with the same ends, which then have several `names`; one that is `one_sided` lacks a sender or a receiver.

    `group` is that of the nodes which it connects, if they are all of one.
    """

    id: str
    kind: str
    names: tuple[str, ...]
    types: tuple[str, ...]
    one_sided: bool
    group: str | None = None


@dataclass(frozen=True)
class ViewEdge:
    """An arrow: `count` ports of the nodes at one end meet the connectors at the other, or node meets node through the connectors `names`.

    `ports` are the names as the source writes them, `conditional` says that all of it depends on conditions.
    """

    source: str
    target: str
    kind: str
    count: int
    ports: tuple[str, ...]
    conditional: bool = False
    names: tuple[str, ...] = ()


@dataclass(frozen=True)
class View:
    """What is drawn; `hidden` counts the connectors that were left out, by the reason."""

    name: str
    launch: tuple[str, ...]
    nodes: tuple[ViewNode, ...]
    connectors: tuple[ViewConnector, ...]
    edges: tuple[ViewEdge, ...]
    hidden: Mapping[str, int] = field(default_factory=dict)


def build_view(system: SystemModel, selection: Selection) -> View:
    """The part of `system` that is selected. Raises `UnknownName` when no node has a name of `focus`."""
    hidden: dict[str, int] = defaultdict(int)
    nodes = {node.id: node for node in system.nodes if _selected(node, selection)}
    links = _links(system, nodes, selection, hidden)
    if selection.focus:
        nodes, links = _focused(nodes, links, selection)
    if not selection.leaves:
        both_sides = [link for link in links if link.sources and link.sinks]
        hidden["one-sided"] += len(links) - len(both_sides)
        links = both_sides
    if selection.collapse:
        shown, ids = _collapsed(nodes.values(), selection.collapse, selection.depth)
        links = merged([moved(link, ids) for link in links], hidden)
    else:
        ids = _ids([(node.id, node.name) for node in nodes.values()], "node")
        shown = [_view_node(node, ids[node.id], _group(node, selection.group, selection.depth)) for node in nodes.values()]
        links = [moved(link, ids) for link in links]
    if selection.connectors:
        connectors, edges = _with_connectors(links, {node.id: node.group for node in shown})
    else:
        connectors, edges = (), _between_nodes(links, {node.id for node in shown if node.members})
    counts = {reason: number for reason, number in sorted(hidden.items()) if number}
    return View(system.name, system.launch, tuple(sorted(shown, key=lambda node: node.id)), connectors, edges, counts)


def namespace(node: SystemNode) -> str:
    """The namespace that a node lives in; "/" is that of no other."""
    return node.name.rpartition("/")[0] or "/"


def _matches(name: str, patterns: Sequence[str]) -> bool:
    return any(fnmatchcase(name, pattern) for pattern in patterns)


def _selected(node: SystemNode, selection: Selection) -> bool:
    if selection.nodes and not _matches(node.name, selection.nodes):
        return False
    if selection.packages and not _matches(node.package, selection.packages):
        return False
    if selection.namespaces and not any(_in_namespace(node, pattern) for pattern in selection.namespaces):
        return False
    return not _matches(node.name, selection.exclude)


def _in_namespace(node: SystemNode, pattern: str) -> bool:
    """Whether a node is in a namespace, or in one below it."""
    above = namespace(node)
    pattern = "/" + pattern.strip("/")
    while above not in ("", "/"):
        if fnmatchcase(above, pattern):
            return True
        above = above.rpartition("/")[0]
    return pattern == "/"


def _links(system: SystemModel, nodes: Mapping[str, SystemNode], selection: Selection, hidden: dict[str, int]) -> list[Link]:
    """The connectors that are shown, with their ends at the nodes that are; why others are not is counted."""
    ports = ports_of(system)

    def ends(given: Iterable[tuple[str, str]]) -> tuple[End, ...]:
        shown = ((node, ports[node, port]) for node, port in sorted(set(given)) if node in nodes and (node, port) in ports)
        return tuple(End(node, port, bool(port.conditional or nodes[node].conditions)) for node, port in shown)

    found = []
    for connector in system.connectors:
        kind = connector_kind(connector, ports)
        one_sided = not (connector.sources and connector.sinks)
        types = tuple(sorted(connector.types))
        link = Link(kind, (connector.name,), types, one_sided, ends(connector.sources), ends(connector.sinks))
        if not link.ends or (selection.names and not _matches(connector.name, selection.names)):
            continue
        if _matches(connector.name, selection.exclude):
            continue
        reason = kind if kind not in selection.kinds else "implicit" if is_implicit(connector, ports) and not selection.implicit else ""
        if reason:
            hidden[reason] += 1
        else:
            found.append(link)
    return found


def _focused(nodes: Mapping[str, SystemNode], links: Sequence[Link], selection: Selection) -> tuple[dict[str, SystemNode], list[Link]]:
    """What is near the nodes in focus: of connectors, those on the way there and those between what is shown."""
    start: set[str] = set()
    for pattern in selection.focus:
        absolute = pattern if pattern.startswith(("/", "*")) else f"/{pattern}"
        matching = {id_ for id_, node in nodes.items() if fnmatchcase(node.name, absolute)}
        if not matching:
            raise UnknownName(pattern, (node.name for node in nodes.values()))
        start |= matching
    inner = neighbourhood(start, links, max(0, selection.hops - 1))
    near = neighbourhood(inner, links, min(1, selection.hops))
    kept = [cut(link, near) for link in links]
    shown = [link for link in kept if len(ends := {end.node for end in link.ends}) > 1 or ends & inner]
    return {id_: node for id_, node in nodes.items() if id_ in near}, shown


def _ids(items: Iterable[tuple[str, str]], kind: str) -> dict[str, str]:
    """An id of `kind` and name for each key, without what formats cannot have in an id; what shares a name is numbered."""
    found: dict[str, str] = {}
    seen: set[str] = set()
    for key, name in sorted(items, key=lambda item: (item[1], item[0])):
        first = f"{kind}:{''.join(c if c.isprintable() else '?' for c in name)}"
        id_, number = first, 1
        while id_ in seen:
            number += 1
            id_ = f"{first}#{number}"
        seen.add(id_)
        found[key] = id_
    return found


def _view_node(node: SystemNode, id_: str, group: str | None) -> ViewNode:
    component = node.component and component_of(node.component)
    return ViewNode(id_, node.name, node.package, node.type, node.origin, component, node.lines, tuple(node.conditions), node.open, group)


def _group(node: SystemNode, by: str | None, depth: int) -> str | None:
    """What a node is grouped by; nodes of no namespace stand for themselves."""
    if by == "package":
        return node.package
    if by == "namespace" and namespace(node) != "/":
        return "/" + "/".join(namespace(node).split("/")[1 : depth + 1])
    return None


def _collapsed(nodes: Iterable[SystemNode], by: str, depth: int) -> tuple[list[ViewNode], dict[str, str]]:
    """A node for each group, and the id of that which each node is part of."""
    groups: dict[str, list[SystemNode]] = defaultdict(list)
    alone: list[SystemNode] = []
    for node in nodes:
        group = _group(node, by, depth)
        if group is None:
            alone.append(node)
        else:
            groups[group].append(node)
    ids = _ids([(node.id, node.name) for node in alone], "node")
    found = [_view_node(node, ids[node.id], None) for node in alone]
    group_ids = _ids([(group, group) for group in groups], by)
    for group, inside in groups.items():
        id_ = group_ids[group]
        packages = {node.package for node in inside}
        package = packages.pop() if len(packages) == 1 else ""
        origins = {node.origin for node in inside}
        origin = origins.pop() if len(origins) == 1 else "mixed"
        members = tuple(sorted(node.name for node in inside))
        found.append(ViewNode(id_, group, package, "", origin, None, (), (), any(node.open for node in inside), None, members))
        ids.update((node.id, id_) for node in inside)
    return found, ids


def _with_connectors(links: Sequence[Link], groups: Mapping[str, str | None]) -> tuple[tuple[ViewConnector, ...], tuple[ViewEdge, ...]]:
    connectors, edges = [], []
    ids: dict[str, str] = {}
    for kind in KINDS:
        own = [(str(index), link.names[0]) for index, link in enumerate(links) if link.kind == kind]
        ids |= _ids(own, kind)
    for index, link in enumerate(links):
        id_ = ids[str(index)]
        around = {groups[end.node] for end in link.ends}
        connectors.append(ViewConnector(id_, link.kind, link.names, link.types, link.one_sided, around.pop() if len(around) == 1 else None))
        edges += [_edge(node, id_, link.kind, ends) for node, ends in by_node(link.sources)]
        edges += [_edge(id_, node, link.kind, ends) for node, ends in by_node(link.sinks)]
    return tuple(sorted(connectors, key=lambda c: c.id)), tuple(sorted(edges, key=_edge_order))


def _edge(source: str, target: str, kind: str, ends: Sequence[End]) -> ViewEdge:
    return ViewEdge(
        source, target, kind, len(ends), tuple(sorted({end.port.written for end in ends})), all(end.conditional for end in ends)
    )


def _between_nodes(links: Iterable[Link], groups: Collection[str]) -> tuple[ViewEdge, ...]:
    """An arrow for each pair of nodes that something of one kind leads from and to; none within one of the `groups`."""
    found: dict[tuple[str, str, str], dict[tuple[str, ...], bool]] = defaultdict(dict)
    for link in links:
        for source, first in by_node(link.sources):
            for sink, second in by_node(link.sinks):
                if source == sink and source in groups:
                    continue
                certain = any(not end.conditional for end in first) and any(not end.conditional for end in second)
                found[source, sink, link.kind][link.names] = not certain
    edges = []
    for (source, sink, kind), pieces in found.items():
        names = tuple(sorted({name for piece in pieces for name in piece}))
        edges.append(ViewEdge(source, sink, kind, len(names), (), all(pieces.values()), names))
    return tuple(sorted(edges, key=_edge_order))


def _edge_order(edge: ViewEdge) -> tuple[str, str, str]:
    return edge.source, edge.target, edge.kind
