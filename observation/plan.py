"""A plan of experiments: for each reaction and transition of a component, the shortest way to it, and to what shows that it happened."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from rosarch.models.machine.steps import Row
from rosarch.observation.machine import Belief, Expected, Input, Machine, Outcome

Given = Input | None
"""What is put in; nothing lets time pass."""

_MOST_BELIEFS = 400
_FURTHER = 2
"""So many more inputs may follow until something shows it."""


@dataclass(frozen=True)
class Stimulus:
    """Something that is put in (nothing: time passes), what is expected then, and how many rounds of the loops it takes."""

    given: Given
    expected: Expected
    rounds: int


@dataclass(frozen=True)
class Experiment:
    """Stimuli, the last of which is decisive: it ends as expected if the `row` of the model is right, and `otherwise` if it is not."""

    row: Row
    stimuli: tuple[Stimulus, ...]
    otherwise: Expected


@dataclass(frozen=True)
class Plan:
    """Experiments, and the rows for which there is none, each with the reason."""

    experiments: tuple[Experiment, ...]
    unreached: tuple[tuple[Row, str], ...]


@dataclass(frozen=True)
class _Way:
    """A way that was gone: the states it leads to, and the stimuli."""

    belief: Belief
    stimuli: tuple[Stimulus, ...]


def plan(machine: Machine, rows: Mapping[Row, tuple[str, ...]]) -> Plan:
    """Experiments for `rows`, each with its triggers."""
    found: dict[Row, Experiment] = {}
    silent: set[Row] = set()
    for way, given in _ways(machine):
        outcome = _put(machine, way.belief, given)
        after, _ = machine.wait(outcome.belief)
        for row in (outcome.rows | after.rows) & rows.keys() - found.keys():
            experiment = _distinguishing_experiment(machine, way, given, row)
            if experiment:
                found[row] = experiment
            else:
                silent.add(row)
        if len(found) == len(rows):
            break
    left = tuple((row, _reason(machine, triggers, row in silent)) for row, triggers in rows.items() if row not in found)
    return Plan(tuple(found[row] for row in rows if row in found), left)


def _ways(machine: Machine) -> Iterator[tuple[_Way, Given]]:
    """All ways, the shortest first, with what is put in next; the first of all is to do nothing."""
    start = _Way(machine.start, ())
    yield start, None
    first = _gone(machine, start, None)
    known, waiting = {first.belief}, deque([first])
    while waiting:
        way = waiting.popleft()
        for given in machine.inputs:
            yield way, given
            following = _gone(machine, way, given)
            if following.belief not in known and len(known) < _MOST_BELIEFS:
                known.add(following.belief)
                waiting.append(following)


def _put(machine: Machine, belief: Belief, given: Given, without: Row | None = None) -> Outcome:
    return machine.put(belief, given, without) if given else Outcome(belief, Expected())


def _gone(machine: Machine, way: _Way, given: Given, without: Row | None = None) -> _Way:
    """The way with one more input, and then until the loops have done what they do; as if a row were not there."""
    outcome = _put(machine, way.belief, given, without)
    after, rounds = machine.wait(outcome.belief, without)
    return _Way(after.belief, (*way.stimuli, Stimulus(given, outcome.expected.then(after.expected), rounds)))


def _distinguishing_experiment(machine: Machine, way: _Way, given: Given, row: Row) -> Experiment | None:
    """The way with an input, and with more of them until what is sent shows whether the row is right."""
    right = _gone(machine, way, given)
    if row.kind != "transitions":
        otherwise = _unsent(machine, way.belief, given, row)
        return Experiment(row, right.stimuli, otherwise) if right.stimuli[-1].expected.excludes(otherwise) else None
    pairs = [(right, _gone(machine, way, given, row))]
    for _ in range(_FURTHER + 1):
        for one, two in pairs:
            if one.stimuli[-1].expected.excludes(two.stimuli[-1].expected):
                return Experiment(row, one.stimuli, two.stimuli[-1].expected)
        pairs = [(_gone(machine, one, more), _gone(machine, two, more, row)) for one, two in pairs for more in (None, *machine.inputs)]
    return None


def _unsent(machine: Machine, belief: Belief, given: Given, row: Row) -> Expected:
    """What is expected when nothing is sent for a row."""
    outcome = _put(machine, belief, given)
    at_once, later = outcome.expected, machine.wait(outcome.belief)[0].expected
    own = _sent_by(machine, row)
    if row in outcome.rows:
        return Expected(at_once.must - own, at_once.may - own).then(later)
    return at_once.then(Expected(later.must - own, later.may - own))


def _sent_by(machine: Machine, row: Row) -> frozenset[str]:
    """The ports through which something is sent with a row, and by the same trigger never without it."""
    found: set[str] = set()
    for own in machine.reactions.values():
        with_row = {sent for effect in own if row in effect.rows for sent in effect.sent}
        found |= with_row - {sent for effect in own if row not in effect.rows for sent in effect.sent}
    return frozenset(found)


def _reason(machine: Machine, triggers: tuple[str, ...], silent: bool) -> str:
    if silent:
        return "nothing that is sent tells whether it happened"
    if not any(trigger in machine.reactions for trigger in triggers):
        return "nothing can be put into what triggers it"
    unsolved = sorted({text for trigger in triggers for text in machine.unsolved.get(trigger, ())})
    if unsolved:
        return f"no message is known for which {' or '.join(f'`{text}`' for text in unsolved)} is as it should be"
    return "no sequence of inputs leads there for sure"
