"""The system graph as JSON, in the form of `schema/graph.schema.json`."""

from __future__ import annotations

import json
from collections.abc import Iterable
from importlib.resources import files
from typing import Any

from rosarch.models.system.view import View, ViewConnector, ViewEdge, ViewNode
from rosarch.reports.printable import json_text


def graphs_text(views: Iterable[View]) -> str:
    """An array of graphs."""
    return json_text([graph_data(view) for view in views])


def graph_schema() -> Any:
    """The JSON Schema of one graph."""
    return json.loads(files("rosarch.reports").joinpath("schema/graph.schema.json").read_text(encoding="utf-8"))


def graph_data(view: View) -> dict[str, Any]:
    """One graph."""
    return {
        "system": view.name,
        "launch": list(view.launch),
        "nodes": [_node(node) for node in view.nodes],
        "connectors": [_connector(connector) for connector in view.connectors],
        "edges": [_edge(edge) for edge in view.edges],
        "hidden": dict(view.hidden),
    }


def _node(node: ViewNode) -> dict[str, Any]:
    return {
        "id": node.id,
        "name": node.name,
        "package": node.package or None,
        "type": node.type or None,
        "origin": node.origin,
        "component": node.component,
        "open": node.open,
        "conditions": list(node.conditions),
        "lines": [str(place) for place in node.lines],
        "group": node.group,
        "members": list(node.members),
    }


def _connector(connector: ViewConnector) -> dict[str, Any]:
    return {
        "id": connector.id,
        "kind": connector.kind,
        "names": list(connector.names),
        "types": list(connector.types),
        "one_sided": connector.one_sided,
        "group": connector.group,
    }


def _edge(edge: ViewEdge) -> dict[str, Any]:
    return {
        "source": edge.source,
        "target": edge.target,
        "kind": edge.kind,
        "count": edge.count,
        "ports": list(edge.ports),
        "names": list(edge.names),
        "conditional": edge.conditional,
    }
