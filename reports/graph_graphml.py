"""The system graph as GraphML, for yEd, Gephi, networkx and their like."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from xml.sax.saxutils import escape

from rosarch.models.system.view import View
from rosarch.reports.printable import printable

_TYPES = MappingProxyType({bool: "boolean", int: "int", str: "string"})
_HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns"
         xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
         xsi:schemaLocation="http://graphml.graphdrawing.org/xmlns http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd">"""

Data = Mapping[str, str | int | bool]


def graph_text(view: View) -> str:
    """One directed graph; connectors are nodes of it too."""
    nodes, edges = dict(_nodes(view)), list(_edges(view))
    ids = {name: f"n{number}" for number, name in enumerate(nodes)}
    keys = {("node", name): type(value) for data in nodes.values() for name, value in data.items()}
    keys |= {("edge", name): type(value) for _, _, data in edges for name, value in data.items()}
    out = [_HEAD]
    for (owner, name), type_ in keys.items():
        out.append(f'  <key id="{owner}_{name}" for="{owner}" attr.name="{name}" attr.type="{_TYPES[type_]}"/>')
    out += ['  <graph id="g" edgedefault="directed">', f"    <desc>{escape(printable(view.name))}</desc>"]
    for name, data in nodes.items():
        out += [f'    <node id="{ids[name]}">', *_data("node", data), "    </node>"]
    for number, (source, target, data) in enumerate(edges):
        out += [f'    <edge id="e{number}" source="{ids[source]}" target="{ids[target]}">', *_data("edge", data), "    </edge>"]
    return "\n".join([*out, "  </graph>", "</graphml>"]) + "\n"


def _nodes(view: View) -> Iterator[tuple[str, Data]]:
    for node in view.nodes:
        yield (
            node.id,
            {
                "label": node.name,
                "kind": "group" if node.members else "node",
                "package": node.package,
                "type": node.type,
                "origin": node.origin,
                "open": node.open,
                "condition": " and ".join(node.conditions),
                "at": str(node.lines[-1]) if node.lines else "",
                "group": node.group or "",
                "members": " ".join(node.members),
            },
        )
    for connector in view.connectors:
        label = " ".join(connector.names)
        yield connector.id, {"label": label, "kind": connector.kind, "type": " ".join(connector.types), "one_sided": connector.one_sided}


def _edges(view: View) -> Iterator[tuple[str, str, Data]]:
    for edge in view.edges:
        label = " ".join(edge.names or edge.ports)
        yield edge.source, edge.target, {"label": label, "kind": edge.kind, "count": edge.count, "conditional": edge.conditional}


def _data(owner: str, data: Data) -> Iterator[str]:
    for name, value in data.items():
        if value == "":
            continue
        text = str(value).lower() if isinstance(value, bool) else escape(printable(str(value)))
        yield f'      <data key="{owner}_{name}">{text}</data>'
