"""State machines as JSON, in the form of `schema/machine.schema.json`."""

from __future__ import annotations

import json
from collections.abc import Iterable
from importlib.resources import files
from typing import Any as Anything

from rosarch.base.logic import Any, Not
from rosarch.models.machine.build import Region, StateMachine, Transition
from rosarch.models.machine.logic import Formula, Is, without_hidden
from rosarch.models.machine.steps import Row
from rosarch.reports.machine_labels import formula_text
from rosarch.reports.printable import json_text


def machines_text(machines: Iterable[StateMachine]) -> str:
    """An array of machines."""
    return json_text([machine_data(machine) for machine in machines])


def machine_schema() -> Anything:
    """The JSON Schema of one machine."""
    return json.loads(files("rosarch.reports").joinpath("schema/machine.schema.json").read_text(encoding="utf-8"))


def machine_data(machine: StateMachine) -> dict[str, Anything]:
    """One machine."""
    return {
        "package": machine.package,
        "component": machine.component,
        "kind": machine.kind,
        "node_name": machine.node_name,
        "triggers": [{"id": trigger.id, "label": trigger.label} for trigger in machine.triggers],
        "regions": [_region(machine, region) for region in machine.regions],
        "always": [{k: v for k, v in _transition(machine, t).items() if k in ("trigger", "outputs", "rows")} for t in machine.always],
        "without_finite_values": list(machine.left_out),
        "never_happens": [_row(row) for row in machine.dead],
        "messages": list(machine.messages),
    }


def _region(machine: StateMachine, region: Region) -> dict[str, Anything]:
    names = [cell.subject.key for cell in region.cells]
    variables = [
        {
            "id": cell.subject.key,
            "variable": cell.variable,
            "field": cell.suffix.removeprefix(".") or None,
            "type": cell.type or None,
            "values": list(cell.subject.values),
            "initial": list(cell.initial),
            "at": cell.at or None,
        }
        for cell in region.cells
    ]
    return {
        "variables": variables,
        "states": [dict(zip(names, values, strict=True)) for values in region.states],
        "initial": list(region.initial),
        "unreachable_states": [dict(zip(names, values, strict=True)) for values in region.unreachable],
        "unreachable_values": {key: list(values) for key, values in region.never},
        "transitions": [_transition(machine, transition) for transition in region.transitions],
    }


def _transition(machine: StateMachine, transition: Transition) -> dict[str, Anything]:
    return {
        "source": transition.source,
        "target": transition.target,
        "trigger": transition.trigger,
        "guard": _condition(transition.guard),
        "outputs": [
            {"port": output.port, "name": machine.ports.get(output.port), "when": _condition(output.when), "sometimes": output.sometimes}
            for output in transition.outputs
        ],
        "assigned": dict(transition.assigned),
        "rows": [_row(row) for row in transition.rows],
    }


def _row(row: Row) -> dict[str, Anything]:
    return {"list": row.kind, "index": row.index, "at": row.at.split()}


def _condition(formula: Formula) -> dict[str, Anything] | None:
    """A condition as text and as a tree; nothing when it always holds."""
    shown = without_hidden(formula)
    text = formula_text(formula)
    return {"text": text, "formula": _tree(shown)} if text else None


def _tree(formula: Formula) -> dict[str, Anything]:
    if isinstance(formula, Is):
        kind = "variable" if formula.subject.cell else "input"
        name = formula.subject.key if formula.subject.cell else formula.subject.text
        return {"is": {kind: name, "in": [v for v in formula.subject.values if v in formula.values]}}
    if isinstance(formula, Not):
        return {"not": _tree(formula.inner)}
    return {"any" if isinstance(formula, Any) else "all": [_tree(part) for part in formula.parts]}
