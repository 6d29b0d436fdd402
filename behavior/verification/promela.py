"""Transition systems in Promela, the language of SPIN."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from rosarch.base.logic import Not
from rosarch.behavior.verification.automaton import Automaton, automaton
from rosarch.behavior.verification.ltl import Formula
from rosarch.behavior.verification.transitions import Number, TransitionSystem, atom_expression, required, written

_SIGNS = {
    "==": " == ", "<": " < ", "&": " && ", "|": " || ", "+": " + ", "-": " - ", "?": "({} -> {} : {})", "true": "true", "false": "false",
}  # fmt: skip
STEP = "step "
"""Begins the line that SPIN prints for a transition when it runs a trail."""


def promela(system: TransitionSystem, claims: Mapping[str, Formula]) -> str:
    """The system as one process, and as claims, in their order, the runs that properties forbid."""
    lines = [f"/* {_comment(system.model.name)} */"]
    lines += [_declaration(number) for number in system.numbers]
    lines += ["active proctype composition() {", "  do"]
    for index, transition in enumerate(system.transitions):
        updates = "; ".join(f"{variable} = {written(value, _SIGNS)}" for variable, value in transition.updates)
        told = f'printf("{STEP}{index}\\n")'
        body = "; ".join(part for part in (written(transition.guard, _SIGNS), updates, told) if part)
        lines.append(f"  /* {_comment(transition.text)} */\n  :: d_step {{ {body} }}")
    lines += ["  od", "}"]
    for index, (name, formula) in enumerate(claims.items()):
        opposite = automaton(Not(required(system, formula)))
        lines += [f"/* {_comment(name)} */", f"never claim{index} {{", *_claim(system, opposite), "}"]
    return "\n".join([*lines, ""])


def _claim(system: TransitionSystem, runs: Automaton) -> Iterator[str]:
    """A Büchi automaton with one set of accepting states: a copy for each of the sets, left where that set is visited."""
    copies = len(runs.accepting) or 1
    yield from ["  true;"] * system.choices
    yield from _goto(system, runs, runs.initial, 0)
    for node, following in enumerate(runs.following):
        for copy in range(copies):
            done = not runs.accepting or node in runs.accepting[copy]
            yield f"{'accept_' if done and copy == 0 else ''}S{node}_{copy}:"
            yield from _goto(system, runs, following, (copy + 1) % copies if done else copy)


def _goto(system: TransitionSystem, runs: Automaton, nodes: Sequence[int], copy: int) -> Iterator[str]:
    yield "  if"
    for node in nodes:
        literals = [written(atom_expression(system, atom), _SIGNS) for atom in sorted(runs.true[node], key=repr)]
        literals += [f"!({written(atom_expression(system, atom), _SIGNS)})" for atom in sorted(runs.false[node], key=repr)]
        accepts = copy == 0 and (not runs.accepting or node in runs.accepting[0])
        yield f"  :: ({' && '.join(literals) or 'true'}) -> goto {'accept_' if accepts else ''}S{node}_{copy}"
    if not nodes:
        yield "  :: false -> skip"
    yield "  fi;"


def _declaration(number: Number) -> str:
    type_ = "bool" if number.high == 1 else "byte" if number.high < 256 else "int"
    return f"{type_} {number.name} = {number.initial}; /* {_comment(number.description)} */"


def _comment(text: str) -> str:
    return text.replace("*/", "* /").replace("/*", "/ *")
