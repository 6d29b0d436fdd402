"""Transition systems in JANI, the exchange format of model checkers (https://jani-spec.org)."""

from __future__ import annotations

import json
from typing import Any

from rosarch.behavior.verification import ltl
from rosarch.behavior.verification.ltl import Binary, Constant, Formula, Next, Not
from rosarch.behavior.verification.transitions import CHOSEN, Expression, Operation, TransitionSystem, atom_expression, equal, required

_SIGNS = {"==": "=", "<": "<", "&": "\u2227", "|": "\u2228", "+": "+", "-": "-"}


class UnsupportedError(Exception):
    """The language cannot say it."""


def expression(part: Expression) -> Any:
    """An expression."""
    if not isinstance(part, Operation):
        return part
    if part.sign == "?":
        keys = ("if", "then", "else")
        return {"op": "ite", **dict(zip(keys, map(expression, part.parts), strict=True))}
    if not part.parts:
        return part.sign == "&"
    found = expression(part.parts[0])
    for other in part.parts[1:]:
        found = {"op": _SIGNS[part.sign], "left": found, "right": expression(other)}
    return found


def jani(system: TransitionSystem, formula: Formula | None = None, name: str = "property") -> str:
    """The system as one automaton, and the property."""
    variables = [
        {
            "name": number.name,
            "type": {"kind": "bounded", "base": "int", "lower-bound": 0, "upper-bound": max(number.high, 1)},
            "initial-value": number.initial,
            "comment": number.told,
        }
        for number in system.numbers
    ]
    edges = [
        {
            "location": "running",
            "guard": {"exp": expression(transition.guard)},
            "destinations": [
                {
                    "location": "running",
                    "assignments": [{"ref": name, "value": expression(value)} for name, value in transition.updates],
                    "comment": transition.text,
                }
            ],
        }
        for transition in system.transitions
    ]
    document = {
        "jani-version": 1,
        "name": system.model.name,
        "type": "mdp",
        "features": ["derived-operators"],
        "variables": variables,
        "properties": [] if formula is None else [_property(system, formula, name)],
        "automata": [
            {"name": "composition", "locations": [{"name": "running"}], "initial-locations": ["running"], "edges": edges},
        ],
        "system": {"elements": [{"automaton": "composition"}]},
    }
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"


def _property(system: TransitionSystem, formula: Formula, name: str) -> Any:
    path = _path(system, required(system, formula))
    if system.choices:  # JANI has no `next`
        chosen = expression(equal(CHOSEN, system.choices))
        path = {"op": "U", "left": {"op": "\u00ac", "exp": chosen}, "right": {"op": "\u2227", "left": chosen, "right": path}}
    least = {"op": "Pmin", "exp": path}
    return {"name": name, "expression": {"op": "filter", "fun": "values", "values": least, "states": {"op": "initial"}}}


def _path(system: TransitionSystem, part: Formula) -> Any:
    if isinstance(part, Constant):
        return part.value
    if isinstance(part, Not):
        return {"op": "\u00ac", "exp": _path(system, part.inner)}
    if isinstance(part, Next):
        raise UnsupportedError("JANI has no `next`")
    if not isinstance(part, Binary):
        return expression(atom_expression(system, part))
    if part == ltl.always(part.right):
        return {"op": "G", "exp": _path(system, part.right)}
    if part == ltl.eventually(part.right):
        return {"op": "F", "exp": _path(system, part.right)}
    sign = {"&": "\u2227", "|": "\u2228"}.get(part.operator, part.operator)
    return {"op": sign, "left": _path(system, part.left), "right": _path(system, part.right)}
