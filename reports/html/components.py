"""Components as the report has them: the model's document without what only programs need, and its state machines."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rosarch.models.component import ComponentModel, to_json
from rosarch.models.machine.build import build_machine
from rosarch.reports.machine_json import machine_data

_FOR_PROGRAMS = ("_normal", "_tree")
"""Endings of fields that say again, in another form, what others say for people."""


def component_data(model: ComponentModel) -> dict[str, Any]:
    """One component; it is called `package/name`, as systems call it."""
    document = to_json(model)
    machine = machine_data(build_machine(document))
    return {
        "name": f"{model.package}/{model.component}",
        **{field: _readable(value) for field, value in document.items() if field not in ("system",)},
        "reconfigurable": [{"name": p.name, "type": p.type, "default": p.default, "at": str(p.at)} for p in model.reconfigurable],
        "machine": {field: _without_formulas(machine[field]) for field in _OF_MACHINES},
    }


_OF_MACHINES = ("triggers", "regions", "always", "without_finite_values", "never_happens", "messages")


def _readable(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _readable(inner) for key, inner in value.items() if not key.endswith(_FOR_PROGRAMS)}
    return [_readable(inner) for inner in value] if isinstance(value, list) else value


def _without_formulas(value: Any) -> Any:
    """Conditions as their texts."""
    if isinstance(value, Mapping):
        return value["text"] if value.keys() == {"text", "formula"} else {key: _without_formulas(inner) for key, inner in value.items()}
    return [_without_formulas(inner) for inner in value] if isinstance(value, list) else value
