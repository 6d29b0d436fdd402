"""Component models as rows of `rules/schema/interfaces.dl`."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any

Rows = dict[str, set[tuple[Any, ...]]]
_PLACE = re.compile(r"(.*):(\d+)")


def interface_rows(document: Mapping[str, Any], origin: str) -> Rows:
    """The rows of one component's document (`models.component.to_json`, or one of the library of interfaces)."""
    rows: Rows = {}

    def add(relation: str, *row: Any) -> None:
        rows.setdefault(relation, set()).add(row)

    def place(text: str | None) -> str | None:
        match = _PLACE.fullmatch(text or "")
        if match is None:
            return None
        add("place", f"{text}:1", match[1], int(match[2]), 1)
        return f"{text}:1"

    component = f"{document['package']}/{document['component']}"
    plugin = document.get("plugin") or {}
    type_ = plugin.get("name") or document["component"]
    add("interface", component, document["package"], type_, document["kind"], origin)
    if plugin.get("base"):
        add("interface_base", component, plugin["base"])
    if document.get("open"):
        add("interface_open", component)
    for name in document.get("loads", ()):
        add("interface_loads", component, name)
    for number, port in enumerate(document.get("ports", ()), 1):
        _port(component, f"{component}#{port.get('id') or f'p{number}'}", port, add, place)
    for number, access in enumerate(document.get("params", ()), 1):
        _access(component, f"{component}#a{number}", access, add, place)
    for reaction in document.get("reactive", ()):
        if reaction["input"] and reaction["output"]:
            add("interface_reacts", f"{component}#{reaction['input']}", f"{component}#{reaction['output']}",
                "always" if reaction["must"] else "sometimes")  # fmt: skip
    for loop in document.get("periodic", ()):
        for port in loop["publishes"]:
            add("interface_periodic", f"{component}#{port}", float(loop["hz"] or 0), loop["hz_from_param"] or "")
    return rows


def _port(component: str, key: str, port: Mapping[str, Any], add: Any, place: Any) -> None:
    add("interface_port", component, key, port["kind"], port["name"])
    for field, relation in (
        ("type", "type"), ("queue", "queue"), ("from_param", "parameter"), ("conditional", "conditional"), ("from_arg", "argument"),
        ("param_pattern", "pattern"), ("callback", "callback"),
    ):  # fmt: skip
        if port.get(field) is not None:
            add(f"interface_port_{relation}", key, port[field])
    if port.get("latched"):
        add("interface_port_latched", key)
    if port.get("implicit"):
        add("interface_port_implicit", key)
    at = place(port.get("at"))
    if at:
        add("interface_port_at", key, at)


def _access(component: str, key: str, access: Mapping[str, Any], add: Any, place: Any) -> None:
    add("interface_parameter", component, key, access.get("op") or "read", access["name"])
    if access.get("type"):
        add("interface_parameter_type", key, access["type"])
    default = access.get("default")
    if default is not None:
        add("interface_parameter_default", key, default if isinstance(default, str) else json.dumps(default))
    at = place(access.get("at"))
    if at:
        add("interface_parameter_at", key, at)
