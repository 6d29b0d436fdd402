"""The system graph as a Mermaid flowchart."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator

from rosarch.models.system.view import View, ViewConnector, ViewEdge, ViewNode
from rosarch.reports.graph_style import (
    GROUP_FILL,
    NODE_FILL,
    NODE_LINE,
    ONE_SIDED_LINE,
    STYLES,
    connector_lines,
    edge_lines,
    hidden_text,
    legend,
    node_lines,
    title,
)
from rosarch.reports.printable import printable

_SPECIAL = re.compile(r"[^\w\s.,/~!=&()+*?:-]|-(?=-)|%")


def graph_text(view: View, *, ports: bool = False, with_legend: bool = True) -> str:
    """One flowchart; with `ports`, connectors show their types, edges the names that the source has."""
    ids = {id_: f"n{number}" for number, id_ in enumerate([*(n.id for n in view.nodes), *(c.id for c in view.connectors)])}
    out = ["---", f'title: "{_escape(title(view))}"', "---", "flowchart LR"]
    groups: dict[str, list[str]] = defaultdict(list)
    for node in view.nodes:
        groups[node.group or ""].append(f"  {ids[node.id]}{_node(node)}")
    for connector in view.connectors:
        groups[connector.group or ""].append(f"  {ids[connector.id]}{_connector(connector, ports)}")
    out += groups.pop("", ())
    for number, (group, lines) in enumerate(sorted(groups.items())):
        out += [f'  subgraph g{number}["{_escape(printable(group))}"]', *(f"  {line}" for line in lines), "  end"]
    connectors = {connector.id: connector for connector in view.connectors}
    out += [_edge(edge, ids, edge_lines(edge, connectors, ports=ports)) for edge in view.edges]
    out += _edge_styles(view)
    if with_legend:
        out += _legend(view)
    return "\n".join([*out, *_classes()]) + "\n"


def _node(node: ViewNode) -> str:
    class_ = "group" if node.members else "unknown" if node.origin == "unknown" else "node"
    left, right = ("[", "]") if node.members else ("([", "])")
    return f"{left}{_label(node_lines(node))}{right}:::{class_}"


def _connector(connector: ViewConnector, ports: bool) -> str:
    left, right = STYLES[connector.kind].brackets
    class_ = f"{connector.kind}_one_sided" if connector.one_sided else connector.kind
    return f"{left}{_label(connector_lines(connector, types=ports))}{right}:::{class_}"


def _edge(edge: ViewEdge, ids: dict[str, str], lines: list[str]) -> str:
    arrow = "-.->" if edge.conditional else "==>" if edge.count > 1 else "-->"
    label = f"|{_label(lines)}|" if lines else ""
    return f"  {ids[edge.source]} {arrow}{label} {ids[edge.target]}"


def _edge_styles(view: View) -> Iterator[str]:
    """The colours of edges, which Mermaid knows by number."""
    numbers: dict[str, list[str]] = defaultdict(list)
    for number, edge in enumerate(view.edges):
        numbers[edge.kind].append(str(number))
    for kind in STYLES:
        if numbers[kind]:
            yield f"  linkStyle {','.join(numbers[kind])} stroke:{STYLES[kind].line}"


def _legend(view: View) -> Iterator[str]:
    """A box of samples."""
    entries = list(legend(view))
    rest = hidden_text(view)
    if not entries and not rest:
        return
    yield '  subgraph legend["legend"]'
    for number, entry in enumerate(entries):
        left, right = ("([", "])") if entry.rounded else ("[", "]")
        dash = ",stroke-dasharray:4" if entry.style == "dashed" else ""
        yield f"    l{number}{left}{_label([entry.text])}{right}"
        yield f"    style l{number} fill:{entry.fill},stroke:{entry.line}{dash}"
    if rest:
        yield f"    hidden[{_label([rest])}]"
        yield "    style hidden fill:none,stroke:none"
    yield "  end"


def _classes() -> Iterator[str]:
    yield f"  classDef node fill:{NODE_FILL},stroke:{NODE_LINE}"
    yield f"  classDef unknown fill:{NODE_FILL},stroke:{NODE_LINE},stroke-dasharray:4"
    yield f"  classDef group fill:{GROUP_FILL},stroke:{NODE_LINE}"
    for kind, style in STYLES.items():
        yield f"  classDef {kind} fill:{style.fill},stroke:{style.line}"
        yield f"  classDef {kind}_one_sided fill:{style.fill},stroke:{ONE_SIDED_LINE},stroke-dasharray:4"


def _label(lines: list[str]) -> str:
    return '"' + "<br/>".join(map(_escape, lines)) + '"'


def _escape(text: str) -> str:
    """Characters that mean something in Mermaid as their code points."""
    return _SPECIAL.sub(lambda match: f"#{ord(match[0])};", text)
