"""Checking the properties of a system, each in the part of the system that it is about."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass

from rosarch.base.logic import Not
from rosarch.behavior.composition.commands import BOUND, model_of
from rosarch.behavior.composition.cone import Watched, cone_of_influence
from rosarch.behavior.composition.inputs import Inputs
from rosarch.behavior.composition.reactions import TooManyCases
from rosarch.behavior.composition.system import System
from rosarch.behavior.verification import ltl, spin, storm
from rosarch.behavior.verification.checkers import CheckerError, CheckResult
from rosarch.behavior.verification.explorer import Explorer, Lasso, TooManyStates, violation
from rosarch.behavior.verification.ltl import Formula
from rosarch.behavior.verification.properties import Property
from rosarch.behavior.verification.timing import begins_first, clocks_compared
from rosarch.behavior.verification.trace import Trace, trace
from rosarch.behavior.verification.transitions import TransitionSystem, transition_system

CHECKERS = {"spin": spin, "storm": storm}
HOLDS, VIOLATED, POSSIBLE, UNDECIDED = "holds", "violated", "possibly violated", "undecided"


@dataclass(frozen=True)
class Limits:
    """What a check may cost: states of the own search for a short counterexample, seconds, MiB."""

    states: int = 100_000
    seconds: float = 60.0
    memory: int = 3072


@dataclass(frozen=True)
class Verdict:
    """What is found about a property: `holds`, `violated`, `undecided`, or `possibly violated`, which needs something that is not known.

    `notes` say what the model leaves open, and why nothing was found out.
    """

    property: Property
    verdict: str
    states: int
    seconds: float
    trace: Trace | None
    notes: tuple[str, ...]


def chosen_checker(wanted: str | None) -> str:
    """The checker that is wanted, or one that is installed.

    Raises:
        CheckerError: there is none.
    """
    installed = [name for name, checker in CHECKERS.items() if checker.is_installed()]
    if wanted is None and not installed:
        raise CheckerError("no model checker is installed; either will do: " + "; ".join(checker.HINT for checker in CHECKERS.values()))
    if wanted is not None and wanted not in installed:
        raise CheckerError(CHECKERS[wanted].HINT)
    return wanted or installed[0]


def model_for(system: System, formula: Formula, inputs: Inputs, bound: int = BOUND) -> TransitionSystem:
    """The part of a system that a formula is about."""
    timed = system.with_times
    cone = cone_of_influence(timed, _watched(formula))
    return transition_system(model_of(timed, cone, inputs, bound=bound, fair=not ltl.is_safety(formula)))


def _watched(formula: Formula) -> Watched:
    """What a formula asks for."""
    atoms = ltl.atoms(formula)
    return Watched(
        frozenset((atom.node, atom.key) for atom in atoms if isinstance(atom, ltl.InState)),
        frozenset(atom.event for atom in atoms if isinstance(atom, ltl.Happens)),
    )


def verify(
    system: System, properties: Sequence[Property], inputs: Inputs, checker: str, bound: int = BOUND, limits: Limits | None = None
) -> list[Verdict]:
    """What a checker finds about each property; one that costs more than the limits is `undecided`, the others are not the worse for it."""
    return [_verdict(system, item, inputs, checker, bound, limits or Limits()) for item in properties]


def _verdict(system: System, item: Property, inputs: Inputs, checker: str, bound: int, limits: Limits) -> Verdict:
    start = time.perf_counter()
    try:
        transitions = model_for(system, item.formula, inputs, bound)
    except TooManyCases as error:
        return Verdict(item, UNDECIDED, 0, time.perf_counter() - start, None, (str(error),))
    notes = transitions.model.notes
    try:
        found = CHECKERS[checker].check(transitions, item.formula, timeout=limits.seconds, memory=limits.memory)
    except CheckerError as error:
        reason = f"{error}{_largest(transitions) if error.large else ''}"
        return Verdict(item, UNDECIDED, 0, time.perf_counter() - start, None, (*notes, reason))
    lasso = None if found.holds else _lasso(transitions, item.formula, found, limits)
    shown = trace(Explorer(transitions), lasso, _watched(item.formula).variables) if lasso else None
    taken = _commands(transitions, (*lasso.stem, *lasso.loop, *lasso.loop)) if lasso else []
    repeated = _commands(transitions, lasso.loop) if lasso else []
    clocks = clocks_compared(transitions.model, taken, repeated)
    if clocks and begins_first(transitions.model, taken, clocks):
        notes, clocks = (*notes, "the nodes of other loops and timers may begin later"), frozenset()
    if clocks and _never(system, item, inputs, checker, bound, limits):
        clocks = frozenset()
    if clocks:
        notes = (*notes, f"whether this can be hangs on how fast they run: {', '.join(sorted(clocks))}")
    sure = HOLDS if found.holds else POSSIBLE if shown is None or shown.assumes or clocks else VIOLATED
    verdict = POSSIBLE if transitions.model.doubts else sure
    return Verdict(item, verdict, found.states, time.perf_counter() - start, shown, notes)


def _never(system: System, item: Property, inputs: Inputs, checker: str, bound: int, limits: Limits) -> bool:
    """Whether a property is violated in every run, however fast clocks run."""
    opposite = Not(item.formula)
    try:
        transitions = model_for(system, opposite, inputs, bound)
        found: CheckResult = CHECKERS[checker].check(transitions, opposite, timeout=limits.seconds, memory=limits.memory)
    except (CheckerError, TooManyCases):
        return False
    return found.holds


def _lasso(system: TransitionSystem, formula: Formula, found: CheckResult, limits: Limits) -> Lasso | None:
    """A run that violates the property: a shortest one, where that can be searched for, else the checker's."""
    try:
        return violation(system, formula, limits.states) or found.lasso
    except TooManyStates:
        return found.lasso


def _commands(system: TransitionSystem, transitions: Sequence[int]) -> list[int]:
    """What happens in transitions of a run."""
    taken = (system.transitions[index].command for index in transitions)
    return [command for command in taken if command is not None]


def _largest(system: TransitionSystem) -> str:
    """What makes the states many."""
    numbers = [number for number in system.numbers if number.high > 1] or list(system.numbers)
    largest = sorted(numbers, key=lambda number: -number.high)[:3]
    return "; most values have " + ", ".join(f"{number.text} ({number.high + 1})" for number in largest)
