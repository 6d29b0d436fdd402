"""Components as the report has them: the model's document without what only programs need, and its state machines."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rosarch.models.component import ComponentModel, to_json
from rosarch.models.machine.build import build_machine
from rosarch.reports.html.machines import machine_data

_FOR_PROGRAMS = ("_normal", "_tree", "trail", "meant")
"""Endings of fields that are for programs, or say again, in another form, what others say for people."""


def component_data(model: ComponentModel) -> dict[str, Any]:
    """One component; it is called `package/name`, as systems call it."""
    document = to_json(model)
    return {
        "name": f"{model.package}/{model.component}",
        **{field: _readable(value) for field, value in document.items() if field != "system"},
        "reconfigurable": [{"name": p.name, "type": p.type, "default": p.default, "at": str(p.at)} for p in model.reconfigurable],
        "machine": machine_data(build_machine(document)),
    }


def _readable(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _readable(inner) for key, inner in value.items() if not key.endswith(_FOR_PROGRAMS)}
    return [_readable(inner) for inner in value] if isinstance(value, list) else value
