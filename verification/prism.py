"""Transition systems in the language of PRISM, which Storm reads, and properties of them."""

from __future__ import annotations

from rosarch.verification import ltl
from rosarch.verification.ltl import Formula
from rosarch.verification.transitions import Expression, Operation, TransitionSystem, atom_expression, from_start, required

_SIGNS = {"==": "=", "<": "<", "&": " & ", "|": " | ", "+": "+", "-": "-"}
_TEMPORAL = {"true": "true", "false": "false", "!": "!", "X": "X", "&": "&", "|": "|", "U": "U", "G": "G", "F": "F"}


def expression(part: Expression) -> str:
    """An expression."""
    if not isinstance(part, Operation):
        return str(part)
    if not part.parts:
        return "true" if part.sign == "&" else "false"
    texts = [expression(inner) for inner in part.parts]
    return f"({texts[0]} ? {texts[1]} : {texts[2]})" if part.sign == "?" else f"({_SIGNS[part.sign].join(texts)})"


def prism(system: TransitionSystem, formula: Formula | None = None) -> str:
    """The system as a Markov decision process without probabilities, with a label for each atom of the property."""
    lines = [f"// {_comment(system.model.name)}", "mdp", "", "module composition"]
    for number in system.numbers:
        names = ", ".join(f"{value}: {name}" for value, name in enumerate(number.names))
        lines.append(f"  // {_comment(number.text)}{_comment(f' ({names})') if names else ''}")
        lines.append(f"  {number.name} : [0..{max(number.high, 1)}] init {number.initial};")
    for transition in system.transitions:
        updates = " & ".join(f"({variable}'={expression(value)})" for variable, value in transition.updates) or "true"
        lines.append(f"  // {_comment(transition.text)}")
        lines.append(f"  [] {expression(transition.guard)} -> {updates};")
    lines += ["endmodule", ""]
    atoms = ltl.atoms(required(system, formula)) if formula else []
    lines += [f'label "p{index}" = {expression(atom_expression(system, atom))};' for index, atom in enumerate(atoms)]
    return "\n".join([*lines, ""])


def query(system: TransitionSystem, formula: Formula) -> str:
    """The least probability, over all ways to resolve what is not determined, that the property holds; 1 when every run satisfies it."""
    whole = required(system, formula)
    atoms = ltl.atoms(whole)
    text = ltl.written(from_start(system, whole), _TEMPORAL, lambda atom: f'"p{atoms.index(atom)}"')
    return f"Pmin=? [ {text} ]"


def _comment(text: str) -> str:
    return " ".join(text.split())
