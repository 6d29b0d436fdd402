"""Composed systems as the report has them: nodes with their ports, connectors with their ends, launch files, rates."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rosarch.analysis.systems.influences import End, SystemDetails
from rosarch.models.component import component_of
from rosarch.models.system.links import connector_kind, is_implicit, ports_of
from rosarch.models.system.model import SystemModel, SystemNode, SystemPort
from rosarch.reports.include_tree import tree_data


def system_data(system: SystemModel, details: SystemDetails | None = None) -> dict[str, Any]:
    """One system, with its details. Ends of connectors are pairs of numbers: of the node, and of the port among its ports."""
    ports = ports_of(system)
    numbers = {(node.id, port.id): [at, own] for at, node in enumerate(system.nodes) for own, port in enumerate(node.ports)}
    return {
        "name": system.name,
        "nodes": [_node(node) for node in system.nodes],
        "connectors": [
            {
                "kind": connector_kind(connector, ports),
                "name": connector.name,
                "types": list(connector.types),
                "sources": [numbers[end] for end in connector.sources if end in numbers],
                "sinks": [numbers[end] for end in connector.sinks if end in numbers],
                "implicit": is_implicit(connector, ports),
            }
            for connector in system.connectors
        ],
        "files": tree_data(system)["files"],
        "rates": [
            {"topic": rate.topic, "low": rate.low, "high": rate.high, "senders": list(rate.senders), "reasons": list(rate.reasons)}
            for rate in (details.rates if details else ())
        ],
        "steps": _steps(details, numbers),
    }


def _steps(details: SystemDetails | None, numbers: Mapping[End, list[int]]) -> list[Any] | None:
    """Steps of chains of cause and effect; None when data flow was not followed."""
    if details is None or details.steps is None:
        return None
    return [
        [numbers[step.source], numbers[step.sink], step.how, step.kind, step.certain]
        for step in details.steps
        if step.source in numbers and step.sink in numbers
    ]


def _node(node: SystemNode) -> dict[str, Any]:
    return {
        "id": node.id,
        "name": node.name,
        "package": node.package,
        "type": node.type,
        "origin": node.origin,
        "component": node.component and component_of(node.component),
        "lines": [str(place) for place in node.lines],
        "conditions": list(node.conditions),
        "open": node.open,
        "ports": [_port(port) for port in node.ports],
        "rates": [[str(place), hz] for place, hz in node.rates],
    }


def _port(port: SystemPort) -> dict[str, Any]:
    """What is the usual case is left out."""
    data: dict[str, Any] = {"id": port.id, "kind": port.kind, "name": port.name, "written": port.written, "type": port.type}
    if port.at:
        data["at"] = str(port.at)
    if port.implicit:
        data["implicit"] = True
    if port.conditional:
        data["conditional"] = port.conditional
    return data
