"""Counterexamples as people read them: messages and changes of state, each with its source lines."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from rosarch.behavior.composition.model import Command, Model
from rosarch.behavior.verification.explorer import Explorer, Lasso, State
from rosarch.behavior.verification.transitions import Transition


@dataclass(frozen=True)
class Step:
    """Something that happens: who does what, why, and what changes. `dropped` are the nodes that lose a waiting message of a topic."""

    actor: str
    cause: str
    sends: tuple[str, ...] = ()
    changes: tuple[tuple[str, str, str], ...] = ()
    inputs: tuple[str, ...] = ()
    assumes: tuple[str, ...] = ()
    places: tuple[str, ...] = ()
    dropped: tuple[tuple[str, str], ...] = ()
    takes: str | None = None


@dataclass(frozen=True)
class Trace:
    """A run: the values that variables begin with, steps, and the steps that are then repeated forever."""

    first: tuple[tuple[str, str], ...]
    assumed_first: tuple[str, ...]
    stem: tuple[Step, ...]
    loop: tuple[Step, ...]

    @property
    def assumes(self) -> tuple[str, ...]:
        """What has to be so for this run to be one of the system, of which the model does not know whether it can."""
        steps = (assumption for step in (*self.stem, *self.loop) for assumption in step.assumes)
        return tuple(dict.fromkeys((*self.assumed_first, *steps)))


def trace(explorer: Explorer, lasso: Lasso, asked: Collection[tuple[str, str]] = ()) -> Trace:
    """The run as steps; the transitions have to be possible one after another.

    First values that are chosen count as assumed where a step depends on them or the property has `asked` for the variable.
    """
    model, state = explorer.system.model, explorer.initial
    begins: list[str] = []
    tested = {index for index, variable in enumerate(model.variables) if variable.key in asked} | _tested(explorer, lasso)
    told: list[list[Step]] = [[], []]
    first: tuple[tuple[str, str], ...] | None = None
    for part, indexes in enumerate((lasso.stem, lasso.loop)):
        for index in indexes:
            transition = explorer.system.transitions[index]
            if transition.choice is not None and transition.choice[0] in tested:
                begins.append(transition.text)
            if transition.choice is None and first is None:
                first = _values(model, state)
            following = explorer.step(state, index)
            told[part] += _steps(model, transition, state, following)
            state = following
    if lasso.loop and not told[1]:
        told[1].append(Step("", "nothing happens"))
    return Trace(first or _values(model, state), tuple(begins), tuple(told[0]), tuple(told[1]))


def _tested(explorer: Explorer, lasso: Lasso) -> set[int]:
    """The variables that some step depends on."""
    taken = (explorer.system.transitions[index].command for index in (*lasso.stem, *lasso.loop))
    return {variable for index in taken if index is not None for variable, _ in explorer.system.model.commands[index].when}


def _values(model: Model, state: State) -> tuple[tuple[str, str], ...]:
    return tuple((variable.text, variable.values[state[index]]) for index, variable in enumerate(model.variables))


def _steps(model: Model, transition: Transition, before: State, after: State) -> Iterable[Step]:
    if transition.command is None:
        return
    command = model.commands[transition.command]
    changes = tuple(
        (variable.text, variable.values[before[index]], variable.values[after[index]])
        for index, variable in enumerate(model.variables)
        if before[index] != after[index]
    )
    yield Step(
        command.actor, command.cause, command.sends, changes, command.inputs, command.assumes, command.places,
        tuple(_dropped(model, command, before)), None if command.takes is None else model.queues[command.takes].topic,
    )  # fmt: skip


def _dropped(model: Model, command: Command, before: State) -> Iterable[tuple[str, str]]:
    for index in command.puts:
        queue = model.queues[index]
        if before[len(model.variables) + index] == queue.size and index != command.takes and not queue.open:
            yield queue.node, queue.topic
