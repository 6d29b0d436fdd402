"""Transition systems in JANI, the exchange format of model checkers (https://jani-spec.org)."""

from __future__ import annotations

import json
from functools import reduce
from typing import Any as Anything

from rosarch.base.logic import FALSE, TRUE, All, Any, Not
from rosarch.behavior.verification.ltl import Atom, Formula, Release, Until
from rosarch.behavior.verification.transitions import CHOSEN, Expression, Operation, TransitionSystem, atom_expression, equal, required

_SIGNS = {"==": "=", "<": "<", "&": "\u2227", "|": "\u2228", "+": "+", "-": "-"}


class UnsupportedError(Exception):
    """The language cannot say it."""


def expression(part: Expression) -> Anything:
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
            "comment": number.description,
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


def _property(system: TransitionSystem, formula: Formula, name: str) -> Anything:
    path = _path(system, required(system, formula))
    if system.choices:  # JANI has no `next`
        chosen = expression(equal(CHOSEN, system.choices))
        path = {"op": "U", "left": {"op": "\u00ac", "exp": chosen}, "right": {"op": "\u2227", "left": chosen, "right": path}}
    least = {"op": "Pmin", "exp": path}
    return {"name": name, "expression": {"op": "filter", "fun": "values", "values": least, "states": {"op": "initial"}}}


def _path(system: TransitionSystem, part: Formula) -> Anything:
    if part in (TRUE, FALSE):
        return part == TRUE
    if isinstance(part, Not):
        return {"op": "\u00ac", "exp": _path(system, part.inner)}
    if isinstance(part, All | Any):
        sign = "\u2227" if isinstance(part, All) else "\u2228"
        return reduce(lambda left, right: {"op": sign, "left": left, "right": right}, (_path(system, each) for each in part.parts))
    if isinstance(part, Until | Release):
        if part.left == (TRUE if isinstance(part, Until) else FALSE):
            return {"op": "F" if isinstance(part, Until) else "G", "exp": _path(system, part.right)}
        sign = "U" if isinstance(part, Until) else "R"
        return {"op": sign, "left": _path(system, part.left), "right": _path(system, part.right)}
    if isinstance(part, Atom):
        return expression(atom_expression(system, part))
    raise UnsupportedError("JANI has no `next`")
