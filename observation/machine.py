"""A component as an experimenter sees it: what it may send when something is put in, and when it is left alone."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice, product

from rosarch.behavior.composition.components import Component
from rosarch.behavior.composition.reactions import Effect, TooManyCases, effects
from rosarch.models.machine.logic import Subject
from rosarch.models.machine.steps import Row

State = frozenset[tuple[str, str]]
"""The value of each variable."""
Belief = frozenset[State]
"""The states that it may be in."""
Content = Mapping[Subject, str]

_MOST_STATES = 200
_MOST_CONTENTS = 32


@dataclass(frozen=True)
class Expected:
    """Ports that something is sent through for sure, and all that may be sent through."""

    must: frozenset[str] = frozenset()
    may: frozenset[str] = frozenset()

    def then(self, other: Expected) -> Expected:
        """What is sent first or then."""
        return Expected(self.must | other.must, self.may | other.may)

    def excludes(self, other: Expected) -> bool:
        """Whether what is seen distinguishes the two."""
        return not self.must <= other.may or not other.must <= self.may

    def fits(self, seen: frozenset[str]) -> bool:
        """Whether it may have been so."""
        return self.must <= seen <= self.may


@dataclass(frozen=True)
class Outcome:
    """What comes of something: the states afterwards, what is sent, and the rows of the model that are followed in any case."""

    belief: Belief
    expected: Expected
    rows: frozenset[Row] = frozenset()


@dataclass(frozen=True)
class Input:
    """A message on a port, and which conditions on its content hold."""

    port: str
    content: tuple[tuple[Subject, str], ...] = ()


@dataclass(frozen=True)
class Machine:
    """The reactions of a component to each port, and to time; `inputs` are all that make a difference."""

    reactions: Mapping[str, tuple[Effect, ...]]
    loops: Mapping[str, float | None]
    inputs: tuple[Input, ...]
    start: Belief
    unsolved: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    def put(self, belief: Belief, given: Input, without: Row | None = None) -> Outcome:
        """What comes of a message, as if the assignment of the row `without` were not made."""
        content = dict(given.content)
        found = [each for state in belief for each in self._ways(given.port, state, content, without)]
        return _joined(found) if found else Outcome(belief, Expected())

    def _ways(self, port: str, state: State, content: Content, without: Row | None) -> list[tuple[State, Effect]]:
        values = dict(state)
        possible = [e for e in self.reactions.get(port, ()) if all(values.get(key) == value for key, value in e.before.items())]
        fitting = [e for e in possible if all(content[s] in allowed for s, allowed in e.choices.items() if s in content)]
        return [(_after(state, effect, without), effect) for effect in fitting]

    def wait(self, belief: Belief, without: Row | None = None) -> tuple[Outcome, int]:
        """What time brings, and in how many rounds of the loops."""
        outcomes = [self._alone(state, without) for state in belief]
        states = frozenset(state for outcome, _ in outcomes for state in outcome.belief)
        must = frozenset.intersection(*(outcome.expected.must for outcome, _ in outcomes))
        may = frozenset[str]().union(*(outcome.expected.may for outcome, _ in outcomes))
        rows = frozenset.intersection(*(outcome.rows for outcome, _ in outcomes))
        return Outcome(states, Expected(must, may), rows), max(rounds for _, rounds in outcomes)

    def _alone(self, state: State, without: Row | None) -> tuple[Outcome, int]:
        """Rounds of the loops from one state, until it is one that was there before."""
        before: dict[State, int] = {}
        sent: set[str] = set()
        rows: set[Row] = set()
        while state not in before:
            before[state] = len(before)
            for trigger in self.loops:
                ways = self._ways(trigger, state, {}, without)
                if len(ways) > 1 or (ways and self.loops[trigger] is None):
                    return self._anything(frozenset(before)), len(before) + 1
                for after, effect in ways:
                    state = after
                    sent.update(effect.sent)
                    rows.update(effect.rows)
        circle = frozenset(known for known, number in before.items() if number >= before[state])
        return Outcome(circle, Expected(frozenset(sent), frozenset(sent)), frozenset(rows)), len(before) + 1

    def _anything(self, reached: Belief) -> Outcome:
        """All that loops may do, where it is not known what they do."""
        waiting, known, sent = list(reached), set(reached), set[str]()
        while waiting and len(known) < _MOST_STATES:
            state = waiting.pop()
            for trigger in self.loops:
                for after, effect in self._ways(trigger, state, {}, None):
                    sent.update(effect.sent)
                    if after not in known:
                        known.add(after)
                        waiting.append(after)
        return Outcome(frozenset(known), Expected(frozenset(), frozenset(sent)))


def _after(state: State, effect: Effect, without: Row | None) -> State:
    """The state after an effect; a row that is left out leaves what only it would have changed."""
    changed = {} if without in effect.rows else dict(effect.after)
    return frozenset({**dict(state), **changed}.items())


def _joined(ways: Sequence[tuple[State, Effect]]) -> Outcome:
    states = frozenset(state for state, _ in ways)
    sent = [frozenset(effect.sent) for _, effect in ways]
    rows = [frozenset(effect.rows) for _, effect in ways]
    return Outcome(states, Expected(frozenset.intersection(*sent), frozenset[str]().union(*sent)), frozenset.intersection(*rows))


Solve = Callable[[str, Subject, str], bool]
"""Whether a message on a port can be made for which a condition's subject has a value."""


def machine(component: Component, ports: Collection[str], solve: Solve, initial: Mapping[str, str]) -> Machine:
    """The machine of a component into whose `ports` something can be put; `initial` are first values that are known otherwise."""
    triggers = [trigger for trigger in component.steps if trigger in ports or trigger in component.rates]
    reactions: dict[str, tuple[Effect, ...]] = {}
    unsolved: dict[str, tuple[str, ...]] = {}
    for trigger in triggers:
        try:
            reactions[trigger] = tuple(effects(component.steps[trigger], component.variables, lambda subject: subject.values))
        except TooManyCases as error:
            unsolved[trigger] = (error.subject,)
    inputs: list[Input] = []
    for port in (trigger for trigger in reactions if trigger not in component.rates):
        asked = sorted({subject for effect in reactions[port] for subject in effect.choices}, key=lambda subject: subject.key)
        solved = [subject for subject in asked if all(solve(port, subject, value) for value in subject.values)]
        unsolved[port] = tuple(subject.text for subject in asked if subject not in solved)
        contents = product(*([(subject, value) for value in subject.values] for subject in solved))
        inputs += [Input(port, content) for content in islice(contents, _MOST_CONTENTS)]
    first = [[(key, value) for value in _first(variable.initial, initial.get(key))] for key, variable in component.variables.items()]
    start = frozenset(map(frozenset, islice(product(*first), _MOST_STATES)))
    loops = {trigger: hz for trigger, hz in component.rates.items() if trigger in reactions}
    return Machine(reactions, loops, tuple(inputs), start, unsolved)


def _first(values: tuple[str, ...], known: str | None) -> tuple[str, ...]:
    return (known,) if known in values else values
