"""Transition systems in the language of PRISM, which Storm reads, and properties of them."""

from __future__ import annotations

from collections.abc import Callable

from rosarch.base.logic import FALSE, TRUE, All, Any, Not
from rosarch.behavior.verification import ltl
from rosarch.behavior.verification.ltl import Atom, Formula, Next, Release, Until
from rosarch.behavior.verification.transitions import TransitionSystem, atom_expression, from_start, required, written
from rosarch.models.machine.conditions import spaced

_SIGNS = {
    "==": "=", "<": "<", "&": " & ", "|": " | ", "+": "+", "-": "-", "?": "({} ? {} : {})", "true": "true", "false": "false",
}  # fmt: skip


def prism(system: TransitionSystem, formula: Formula | None = None) -> str:
    """The system as a Markov decision process without probabilities, with a label for each atom of the property."""
    lines = [f"// {spaced(system.model.name)}", "mdp", "", "module composition"]
    for number in system.numbers:
        lines.append(f"  // {spaced(number.description)}")
        lines.append(f"  {number.name} : [0..{max(number.high, 1)}] init {number.initial};")
    for transition in system.transitions:
        updates = " & ".join(f"({variable}'={written(value, _SIGNS)})" for variable, value in transition.updates) or "true"
        lines.append(f"  // {spaced(transition.text)}")
        lines.append(f"  [] {written(transition.guard, _SIGNS)} -> {updates};")
    lines += ["endmodule", ""]
    atoms = ltl.atoms(required(system, formula)) if formula else []
    lines += [f'label "p{index}" = {written(atom_expression(system, atom), _SIGNS)};' for index, atom in enumerate(atoms)]
    return "\n".join([*lines, ""])


def query(system: TransitionSystem, formula: Formula) -> str:
    """The least probability, over all ways to resolve what is not determined, that the property holds; 1 when every run satisfies it."""
    whole = required(system, formula)
    atoms = ltl.atoms(whole)
    text = _path(from_start(system, whole), lambda atom: f'"p{atoms.index(atom)}"')
    return f"Pmin=? [ {text} ]"


def _path(part: Formula, atom: Callable[[Atom], str]) -> str:
    """A formula, for PRISM, which has no `R`."""
    if part in (TRUE, FALSE):
        return "true" if part == TRUE else "false"
    if isinstance(part, Not):
        return f"!({_path(part.inner, atom)})"
    if isinstance(part, All | Any):
        return (" & " if isinstance(part, All) else " | ").join(f"({_path(each, atom)})" for each in part.parts)
    if isinstance(part, Next):
        return f"X ({_path(part.inner, atom)})"
    if isinstance(part, Release):
        if part.left == FALSE:
            return f"G ({_path(part.right, atom)})"
        return _path(Not(Until(Not(part.left), Not(part.right))), atom)
    if isinstance(part, Until):
        if part.left == TRUE:
            return f"F ({_path(part.right, atom)})"
        return f"({_path(part.left, atom)}) U ({_path(part.right, atom)})"
    if isinstance(part, Atom):
        return atom(part)
    raise TypeError(part)
