"""State machines as the report has them: the texts of states and transitions, folded as in the other diagrams."""

from __future__ import annotations

from typing import Any

from rosarch.models.machine.build import Region, StateMachine
from rosarch.reports.machine_labels import (
    Effect,
    always_labels,
    arcs,
    edges,
    formula_text,
    outputs_texts,
    places_of,
    region_title,
    state_text,
    states_text,
    target_text,
    triggers_text,
    valuation_text,
    value_text,
)


def machine_data(machine: StateMachine) -> dict[str, Any]:
    """The machines of a component, one for each region."""
    return {
        "regions": [_region(machine, region) for region in machine.regions],
        "always": always_labels(machine),
        "left_out": list(machine.left_out),
        "dead": [{"list": row.kind, "at": row.at.split()} for row in machine.dead],
        "messages": list(machine.messages),
    }


def _region(machine: StateMachine, region: Region) -> dict[str, Any]:
    """`edges` are for the diagram, from and to numbers of states, -1 being any; `arcs` are the same for a table."""
    values = {cell.subject.key: cell.subject for cell in region.cells}
    return {
        "title": region_title(region),
        "states": [state_text(region, state) for state in range(len(region.states))],
        "initial": list(region.initial),
        "unreachable": [valuation_text(region, values) for values in region.unreachable],
        "never": [f"{values[key].text} is never {value_text(values[key], value)}" for key, never in region.never for value in never],
        "edges": [
            {"source": edge.source, "target": edge.target, "effects": list(map(_effect, edge.effects))} for edge in edges(machine, region)
        ],
        "arcs": [
            {
                "from": states_text(region, arc.sources),
                "to": target_text(region, arc),
                **_effect(
                    Effect(
                        triggers_text(machine, arc.triggers),
                        formula_text(arc.guard),
                        "; ".join(outputs_texts(machine, arc.outputs)),
                        places_of(arc.rows),
                    )
                ),
            }
            for arc in arcs(region)
        ],
    }


def _effect(effect: Effect) -> dict[str, Any]:
    return {"on": effect.triggers, "if": effect.guard, "sends": effect.sent, "at": list(effect.at)}
