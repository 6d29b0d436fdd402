"""The system graph for Graphviz: nodes as ellipses, what connects them as boxes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping

from rosarch.models.system.view import View, ViewConnector, ViewEdge, ViewNode
from rosarch.reports.graph_style import (
    GROUP_FILL,
    NODE_FILL,
    NODE_LINE,
    ONE_SIDED_LINE,
    STYLES,
    LegendEntry,
    connector_lines,
    edge_details,
    edge_lines,
    hidden_text,
    legend,
    node_details,
    node_lines,
    title,
)
from rosarch.reports.printable import printable

COLUMN = 12  # nodes that nothing connects are in columns of so many


def graph_text(view: View, *, ports: bool = False, with_legend: bool = True) -> str:
    """One directed graph; with `ports`, connectors show their types, edges the names that the source has."""
    out = [
        f"digraph {quoted([title(view)])} {{",
        "  rankdir=LR; nodesep=0.15; ranksep=0.7; fontname=Helvetica; fontsize=12; compound=true; newrank=true;",
        '  node [fontname=Helvetica, fontsize=11, height=0.3, margin="0.12,0.05"];',
        "  edge [fontname=Helvetica, fontsize=9, arrowsize=0.7];",
    ]
    if with_legend:
        out.append(f"  labelloc=b; label={_legend(view)};")
    out += _nodes(view, ports)
    connectors = {connector.id: connector for connector in view.connectors}
    out += [_edge(edge, connectors, ports) for edge in view.edges]
    return "\n".join([*out, "}"]) + "\n"


def _nodes(view: View, ports: bool) -> Iterator[str]:
    """Nodes and connectors: those of one group in a box, nodes that nothing connects in columns."""
    groups: dict[str, list[str]] = defaultdict(list)
    alone: dict[str, list[ViewNode]] = defaultdict(list)
    connected = {end for edge in view.edges for end in (edge.source, edge.target)}
    for node in view.nodes:
        groups[node.group or ""].append(f"{quoted([node.id])} [{_node(node)}];")
        if node.id not in connected:
            alone[node.group or ""].append(node)
    for connector in view.connectors:
        groups[connector.group or ""].append(f"{quoted([connector.id])} [{_connector(connector, ports)}];")
    yield from (f"  {line}" for line in groups.pop("", ()))
    for number, (group, lines) in enumerate(sorted(groups.items())):
        yield f"  subgraph cluster_{number} {{"
        yield f'    label={quoted([printable(group)])}; labelloc=t; labeljust=l; style=rounded; color="#a0a0a0";'
        yield from (f"    {line}" for line in lines)
        yield "  }"
    for nodes in alone.values():
        for first, second in zip(nodes, nodes[COLUMN:], strict=False):
            yield f"  {quoted([first.id])} -> {quoted([second.id])} [style=invis];"


def _node(node: ViewNode) -> str:
    shape = "box" if node.members else "ellipse"
    style = "filled,dashed" if node.origin == "unknown" else "filled"
    fill = GROUP_FILL if node.members else NODE_FILL
    return (
        f'label={quoted(node_lines(node))}, shape={shape}, style="{style}", color="{NODE_LINE}", fillcolor="{fill}", '
        f"tooltip={quoted([node_details(node)])}"
    )


def _connector(connector: ViewConnector, ports: bool) -> str:
    style = STYLES[connector.kind]
    line, border = (ONE_SIDED_LINE, "filled,dashed") if connector.one_sided else (style.line, "filled")
    return (
        f'label={quoted(connector_lines(connector, types=ports))}, shape={style.shape}, style="{border}", color="{line}", '
        f'fillcolor="{style.fill}", tooltip={quoted([printable(", ".join(connector.types)) or "type not known"])}'
    )


def _edge(edge: ViewEdge, connectors: Mapping[str, ViewConnector], ports: bool) -> str:
    attributes = [f'color="{STYLES[edge.kind].line}"', f"tooltip={quoted([edge_details(edge)])}"]
    if edge.conditional:
        attributes.append("style=dashed")
    if edge.count > 1:
        attributes.append(f"penwidth={min(1 + edge.count / 4, 4):g}")
    lines = edge_lines(edge, connectors, ports=ports)
    if lines:
        attributes.append(f'label={quoted(lines)}, fontcolor="{STYLES[edge.kind].line}"')
    return f"  {quoted([edge.source])} -> {quoted([edge.target])} [{', '.join(attributes)}];"


def _legend(view: View) -> str:
    """A row of samples below the drawing."""
    cells = [f"<TD><B>{_markup(title(view))}</B></TD>", *map(_sample, legend(view))]
    rest = hidden_text(view)
    if rest:
        cells.append(f"<TD>{_markup(rest)}</TD>")
    return f'<<TABLE BORDER="0" CELLSPACING="8" CELLPADDING="3"><TR>{"".join(cells)}</TR></TABLE>>'


def _sample(entry: LegendEntry) -> str:
    style = ",".join(word for word in ("rounded" if entry.rounded else "", "dashed" if entry.style == "dashed" else "") if word)
    shown = f' STYLE="{style}"' if style else ""
    return f'<TD BORDER="1" COLOR="{entry.line}" BGCOLOR="{entry.fill}"{shown}>{_markup(entry.text)}</TD>'


def _markup(text: str) -> str:
    """Text within Graphviz' markup."""
    for character, entity in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;")):
        text = text.replace(character, entity)
    return text


def quoted(lines: list[str]) -> str:
    """A quoted string of centred lines, in which Graphviz finds neither escapes nor entities."""
    return '"' + "\\n".join(line.replace("\\", "\\\\").replace('"', '\\"').replace("&", "&amp;") for line in lines) + '"'
