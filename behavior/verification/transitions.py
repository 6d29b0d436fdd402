"""Models as transition systems over bounded integers, the common ground of the languages of model checkers."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from rosarch.behavior.composition.model import Command, Model
from rosarch.behavior.verification import ltl
from rosarch.behavior.verification.ltl import Atom, Formula


@dataclass(frozen=True)
class Operation:
    """`==`, `<`, `&`, `|`, `+`, `-` or `?` (if, then, else) of parts."""

    sign: str
    parts: tuple[Expression, ...]


Expression: TypeAlias = int | str | Operation
"""A number, a variable, or an operation."""


def written(part: Expression, signs: Mapping[str, str], name: Callable[[str], str] = str) -> str:
    """An expression in a language with these `signs`, `true` and `false` among them; `?` is a pattern. `name` writes a variable."""
    if not isinstance(part, Operation):
        return name(part) if isinstance(part, str) else str(part)
    if not part.parts:
        return signs["true" if part.sign == "&" else "false"]
    texts = [written(inner, signs, name) for inner in part.parts]
    return signs["?"].format(*texts) if part.sign == "?" else f"({signs[part.sign].join(texts)})"


@dataclass(frozen=True)
class Number:
    """A variable from 0 to `high`; `names` are what its values stand for, `text` what it stands for itself."""

    name: str
    high: int
    initial: int
    text: str
    names: tuple[str, ...] = ()

    @property
    def description(self) -> str:
        """What it and its values stand for."""
        names = ", ".join(f"{value}: {name}" for value, name in enumerate(self.names))
        return f"{self.text} ({names})" if names else self.text


@dataclass(frozen=True)
class Transition:
    """When `guard` holds, all `updates` are made at once; `command` is the index of what it stands for, None for a pause.

    `choice` is a first value that it chooses instead: the index of a variable, and the value.
    """

    guard: Expression
    updates: tuple[tuple[str, Expression], ...]
    command: int | None
    text: str
    choice: tuple[int, int] | None = None


@dataclass(frozen=True)
class TransitionSystem:
    """Numbers and transitions. A run is fair when `fair` (the variable and its value) comes again and again."""

    model: Model
    numbers: tuple[Number, ...]
    transitions: tuple[Transition, ...]
    fair: tuple[str, int] | None

    @property
    def choices(self) -> int:
        """How many first values every run begins with choosing."""
        return len(self.model.choices)


def equal(left: Expression, right: Expression) -> Expression:
    """`==`."""
    return Operation("==", (left, right))


def every(parts: Iterable[Expression]) -> Expression:
    """And; true for nothing."""
    found = tuple(parts)
    return found[0] if len(found) == 1 else Operation("&", found)


def some(parts: Iterable[Expression]) -> Expression:
    """Or; false for nothing."""
    found = tuple(parts)
    return found[0] if len(found) == 1 else Operation("|", found)


def choose(condition: Expression, then: Expression, otherwise: Expression) -> Expression:
    """If, then, else."""
    return Operation("?", (condition, then, otherwise))


class _Names:
    """Identifiers that every language accepts, each used once."""

    def __init__(self) -> None:
        self._used: set[str] = set()

    def new(self, text: str) -> str:
        base = "v_" + re.sub(r"\W+", "_", text).strip("_")
        name, number = base, 1
        while name in self._used:
            number += 1
            name = f"{base}_{number}"
        self._used.add(name)
        return name


def transition_system(model: Model) -> TransitionSystem:
    """The transition system of a model."""
    return _Encoder(model).encoded()


class _Encoder:
    def __init__(self, model: Model) -> None:
        names = _Names()
        self.model = model
        self.variables = [names.new(variable.text) for variable in model.variables]
        self.queues = [names.new(f"{queue.node} queue {queue.topic}") for queue in model.queues]
        self.slots = {
            index: [names.new(f"{queue.node} content {queue.topic}") for _ in range(queue.size)]
            for index, queue in enumerate(model.queues)
            if queue.contents
        }
        self.beyond = {
            index: [names.new(f"{queue.node} beyond {queue.topic}") for _ in queue.contents]
            for index, queue in enumerate(model.queues)
            if queue.open and queue.contents
        }
        self.events = {event: names.new(str(event)) for event in model.events}
        self.begun, self.stage, self.turn = CHOSEN, "stage", "turn"
        self.choices = len(model.choices)

    def encoded(self) -> TransitionSystem:
        model = self.model
        transitions = [
            Transition(
                equal(self.begun, step),
                ((self.variables[index], model.variables[index].values.index(value)), (self.begun, step + 1)),
                None,
                f"{model.variables[index].text} begins as {value}",
                (index, model.variables[index].values.index(value)),
            )
            for step, index in enumerate(model.choices)
            for value in model.variables[index].initial
        ]
        quiet = every([*self._ready(), *(equal(queue, 0) for queue in self.queues)])
        transitions.append(Transition(quiet, self._observations((), (), None), None, "nothing happens"))
        transitions += [self._transition(index, command) for index, command in enumerate(model.commands)]
        fair = (self.turn, len(model.obligations)) if model.obligations else None
        return TransitionSystem(model, tuple(self._numbers()), tuple(transitions), fair)

    def _numbers(self) -> Iterable[Number]:
        model = self.model
        for name, variable in zip(self.variables, model.variables, strict=True):
            first = variable.values.index(variable.initial[0])
            yield Number(name, len(variable.values) - 1, first, variable.text, variable.values)
        for name, queue in zip(self.queues, model.queues, strict=True):
            more = " (the last: or more)" if queue.open else ""
            yield Number(name, queue.size, 0, f"messages on {queue.topic} that wait for {queue.node}{more}")
        for event, name in self.events.items():
            yield Number(name, 1, 0, str(event))
        if self.choices:
            yield Number(self.begun, self.choices, 0, "first values that are chosen")
        if model.stages:
            yield Number(self.stage, model.stages, 0, "messages of the scenario that were sent")
        if model.obligations:
            yield Number(self.turn, len(model.obligations), 0, "what has to get its turn next, for a run to be fair")
        for index, names in self.beyond.items():
            queue = model.queues[index]
            for name, content in zip(names, queue.contents, strict=True):
                yield Number(name, 1, 0, f"more than {queue.size} on {queue.topic} wait for {queue.node}, {content} among them")
        for index, slots in self.slots.items():
            queue = model.queues[index]
            for place, name in enumerate(slots):
                text = f"message {place + 1} on {queue.topic} that waits for {queue.node}"
                yield Number(name, len(queue.contents) - 1, 0, text, queue.contents)

    def _ready(self) -> list[Expression]:
        return [equal(self.begun, self.choices)] if self.choices else []

    def _transition(self, index: int, command: Command) -> Transition:
        guard = self._ready()
        for variable, values in command.when:
            known = self.model.variables[variable].values
            guard.append(some(equal(self.variables[variable], known.index(value)) for value in sorted(values, key=known.index)))
        if command.takes is not None:
            guard.append(Operation("<", (0, self.queues[command.takes])))
            if command.taken is not None and command.takes in self.slots:
                guard.append(some(equal(self.slots[command.takes][0], content) for content in sorted(command.taken)))
            if command.takes in self.beyond and not command.keeps:
                size, beyond = self.model.queues[command.takes].size, self.beyond[command.takes]
                none = every(equal(name, 0) for name in beyond)
                guard.append(some([Operation("<", (self.queues[command.takes], size)), none]))
        if (kept := command.drops if command.takes is None else command.takes if command.keeps else None) in self.beyond:
            guard.append(equal(self.beyond[kept][command.kept_content], 1))
        guard += [equal(self.queues[queue], self.model.queues[queue].size) for queue in command.full]
        if command.stage is not None:
            guard.append(equal(self.stage, command.stage))
        updates = list(self._observations(command.events, command.full_events, command.obligation))
        updates += self._queued(command)
        for variable, value in command.given:
            updates.append((self.variables[variable], self.model.variables[variable].values.index(value)))
        if command.stage is not None:
            updates.append((self.stage, command.stage + 1))
        return Transition(every(guard), tuple(updates), index, f"{command.actor} {command.cause}")

    def _queued(self, command: Command) -> Iterable[tuple[str, Expression]]:
        for queue in dict.fromkeys((*command.puts, *(() if command.takes is None else (command.takes,)))):
            if queue in self.slots:
                yield from self._contents(command, queue)
            if queue in self.beyond:
                yield from self._more(command, queue)
        if command.drops is not None:
            slots = self.slots[command.drops]
            yield from zip(slots, (*slots[1:], command.kept_content), strict=True)
        for queue in command.puts:
            if queue != command.takes:
                name, size = self.queues[queue], self.model.queues[queue].size
                yield name, choose(Operation("<", (name, size)), Operation("+", (name, 1)), size)
        if command.takes is not None and command.takes not in command.puts and not command.keeps:
            yield self.queues[command.takes], Operation("-", (self.queues[command.takes], 1))

    def _contents(self, command: Command, queue: int) -> Iterable[tuple[str, Expression]]:
        """What messages in a queue hold, in an order in which each is set before those that it is set from."""
        count, slots, of = self.queues[queue], self.slots[queue], self.model.queues[queue]
        put: Expression = dict(command.given_contents).get(queue, 0)
        for place, slot in enumerate(slots):
            following: Expression = slots[place + 1] if place + 1 < len(slots) else 0
            if queue == command.takes and queue in command.puts and not command.keeps:
                yield slot, choose(equal(count, place + 1), put, following)
            elif queue == command.takes:
                yield slot, command.kept_content if command.keeps and place + 1 == len(slots) else following
            else:
                oldest: Expression = slot if of.open else put if place + 1 == len(slots) else following
                yield slot, choose(equal(count, place), put, choose(equal(count, of.size), oldest, slot))

    def _more(self, command: Command, queue: int) -> Iterable[tuple[str, Expression]]:
        """What waits in an open queue beyond those that are counted."""
        put = dict(command.given_contents).get(queue, 0) if queue in command.puts else None
        full = equal(self.queues[queue], self.model.queues[queue].size)
        for content, name in enumerate(self.beyond[queue]):
            if put == content and (queue != command.takes or command.keeps):
                yield name, choose(full, 1, name)
            elif queue == command.takes and command.settles:
                yield name, 0

    def _observations(
        self, events: Iterable[object], full: Sequence[tuple[object, int]], obligation: int | None
    ) -> tuple[tuple[str, Expression], ...]:
        """The updates of what only observes; they come first, since they are about the state before."""
        updates: list[tuple[str, Expression]] = []
        if last := len(self.model.obligations):
            due = some([*([equal(self.turn, obligation)] if obligation is not None else []), *self._fulfilled(obligation)])
            following = choose(due, Operation("+", (self.turn, 1)), self.turn) if due != some(()) else self.turn
            updates.append((self.turn, choose(equal(self.turn, last), 0, following)))
        happened = set(events)
        for event, name in self.events.items():
            queues = [queue for other, queue in full if other == event]
            size = [equal(self.queues[queue], self.model.queues[queue].size) for queue in queues]
            updates.append((name, 1 if event in happened else choose(some(size), 1, 0) if size else 0))
        return tuple(updates)

    def _fulfilled(self, but: int | None) -> Iterable[Expression]:
        """What need not get its turn now: a queue without messages, a scenario that is over."""
        for index, what in enumerate(self.model.obligations):
            if index == but:
                continue
            if isinstance(what, int):
                yield every([equal(self.turn, index), equal(self.queues[what], 0)])
            elif what == "scenario":
                yield every([equal(self.turn, index), equal(self.stage, self.model.stages)])


def required(system: TransitionSystem, formula: Formula) -> Formula:
    """What has to hold when first values are chosen: `formula`, on fair runs."""
    return ltl.implication(ltl.always(ltl.eventually(FAIR)), formula) if system.fair else formula


def from_start(system: TransitionSystem, formula: Formula) -> Formula:
    """What has to hold from the first state on, which is before first values are chosen."""
    for _ in range(system.choices):
        formula = ltl.Next(formula)
    return formula


FAIR = ltl.Marker("fair")
CHOSEN = "begun"  # the number of first values that are chosen


def atom_expression(system: TransitionSystem, atom: Atom) -> Expression:
    """An atom of what is `required`, over the numbers."""
    if isinstance(atom, ltl.Marker):
        return equal(*system.fair) if system.fair else some(())
    if isinstance(atom, ltl.Happens):
        name = next(number.name for number in system.numbers if number.text == str(atom.event))
        return equal(name, 1)
    number = system.numbers[system.model.index[atom.node, atom.key]]
    return some(equal(number.name, place) for place, value in enumerate(number.names) if value in atom.values)
