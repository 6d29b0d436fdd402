"""What a reaction of a node does: its steps, run for every case that makes a difference or for one that is chosen on the way.

A reaction is atomic and its steps are taken in the order of their lines, as `models.machine.reactions` has it; conditions of equal text
are one condition.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

from rosarch.base.logic import alternatives
from rosarch.behavior.composition.contents import fields_of
from rosarch.models.machine.logic import (
    BOOLEAN,
    Case,
    Formula,
    Subject,
    conjunction,
    evaluate,
    first_unknown,
    from_cases,
    simplify,
    subjects,
)
from rosarch.models.machine.meaning import Assignment
from rosarch.models.machine.steps import Row, Step

MOST_CASES = 5000
MOST_WAYS = 16

Pick = Callable[[Subject], Iterable[str]]
"""The values that a subject may have where nothing is known about it yet."""


class TooManyCases(Exception):
    """A reaction has more than `MOST_CASES` cases; `subject` is what its conditions ask most often."""

    def __init__(self, subject: str) -> None:
        super().__init__(f"a reaction has more than {MOST_CASES} cases, most of them for `{subject}`")
        self.subject = subject


@dataclass(frozen=True)
class Effect:
    """One way that a reaction may go.

    `before` are the variables it depends on with their values, `choices` what it takes for granted of anything else (there may be other
    ways to the same), `after` the values that it gives to variables, `sent` ports, in order. `rows` are the rows of the model that were
    followed, `contents` what is known about the messages that were sent: the port, and the values of the fields that were asked for.
    """

    before: Mapping[str, str]
    choices: Mapping[Subject, frozenset[str]]
    after: Mapping[str, str]
    sent: tuple[str, ...]
    rows: tuple[Row, ...]
    contents: tuple[tuple[str, tuple[tuple[str, str], ...]], ...] = ()

    def content(self, port: str) -> Mapping[str, str]:
        """What is known about the message that goes through a port, by the paths of its fields: nothing where several differ."""
        found = [dict(content) for name, content in self.contents if name == port]
        return found[0] if found and all(content == found[0] for content in found) else {}


@dataclass(frozen=True)
class _Run:
    """A reaction under way.

    `fields` are the variables that are fields of messages. `values` are those of variables now, `seen` those that conditions see,
    `chosen` the values of what else was asked and will be again, `ways` the alternatives in what was asked and will not be.
    """

    values: Mapping[str, str] = field(default_factory=dict)
    seen: Mapping[str, str] = field(default_factory=dict)
    chosen: Mapping[Subject, str] = field(default_factory=dict)
    ways: tuple[Case, ...] = ({},)
    effect: Effect = field(default_factory=lambda: Effect({}, {}, {}, (), ()))
    fields: frozenset[str] = frozenset()

    def tested(self, subject: Subject, step: Step, part: int = 0) -> str | None:
        """The value that a condition of the guard of a step sees."""
        seen = self.seen.get(step.tested_as(subject.key, part))
        return self.current(subject) if seen is None else seen

    def current(self, subject: Subject) -> str | None:
        """The value that an assignment reads."""
        return self.values.get(subject.key) or self.chosen.get(subject)

    def choosing(self, subject: Subject, value: str, *, variable: bool) -> _Run:
        """The same with one thing more that is known."""
        if not variable:
            return replace(self, chosen={**self.chosen, subject: value})
        before = {**self.effect.before, subject.key: value}
        return replace(self, values={**self.values, subject.key: value}, effect=replace(self.effect, before=before))

    def assigned(self, key: str, value: str) -> _Run:
        """The same after an assignment."""
        if key in self.fields:
            return replace(self, values={**self.values, key: value})
        return replace(self, values={**self.values, key: value}, effect=replace(self.effect, after={**self.effect.after, key: value}))

    def followed(self, step: Step, sent: tuple[str, ...]) -> _Run:
        """The same after a step that was taken."""
        effect = replace(self.effect, sent=self.effect.sent + sent, rows=(*self.effect.rows, step.row))
        fields = {port: fields_of(message, self.fields) for port, message in step.messages}
        known = tuple((port, tuple((path, self.values[key]) for path, key in fields.get(port, {}).items())) for port in sent)
        return replace(self, effect=replace(effect, contents=effect.contents + known if self.fields else ()))


def effects(steps: Sequence[Step], variables: Collection[str], pick: Pick, fields: Mapping[str, str] | None = None) -> list[Effect]:
    """All ways that a reaction may go, from any values of `variables`; cases that end alike are one.

    `fields` are variables of the reaction alone, with the values that they begin with.

    Raises:
        TooManyCases: there are too many.
    """
    later: list[set[Subject]] = [set()]
    for step in reversed(steps):
        later.insert(0, later[0] | set(_tested(step)))
    runs = [_Run(values=fields or {}, fields=frozenset(fields or ()))]
    for index, step in enumerate(steps):
        found: dict[object, _Run] = {}
        for run in runs:
            for outcome in _outcomes(run, step, variables, pick):
                settled = _settled(outcome, later[index + 1])
                key = _key(settled)
                found[key] = _merged(found[key], settled) if key in found else settled
            if len(found) > MOST_CASES:
                raise TooManyCases(_most_asked(steps))
        runs = list(found.values())
    return [replace(run.effect, choices=min(run.ways, key=len)) for run in runs]


def react(
    steps: Sequence[Step], values: Mapping[str, str], choose: Callable[[Subject], str], fields: Mapping[str, str] | None = None
) -> Effect:
    """The way that a reaction goes from these values of all variables, where `choose` decides everything else. `fields`: see `effects`."""
    run = _Run(values={**values, **(fields or {})}, fields=frozenset(fields or ()))
    for step in steps:
        run = next(_outcomes(run, step, (), lambda subject: (choose(subject),)))
    return run.effect


def _settled(run: _Run, later: set[Subject]) -> _Run:
    """The run where what will not be asked again is part of the ways that lead there."""
    past = {subject: frozenset({value}) for subject, value in run.chosen.items() if subject not in later}
    if not past:
        return run
    left = {subject: value for subject, value in run.chosen.items() if subject in later}
    return replace(run, chosen=left, ways=tuple({**way, **past} for way in run.ways))


def _key(run: _Run) -> object:
    """What the rest of a reaction, and what comes of it, hangs on."""
    parts = (run.values, run.seen, run.chosen, run.effect.before, run.effect.after)
    return (*(frozenset(part.items()) for part in parts), run.effect.sent, bool(run.effect.rows), run.effect.contents)


def _merged(one: _Run, two: _Run) -> _Run:
    """Two runs that differ only in the ways that lead there."""
    return replace(one, ways=tuple(cases_of(from_cases([*one.ways, *two.ways])))[:MOST_WAYS])


def cases_of(formula: Formula) -> Iterator[Case]:
    """The cases of a formula that was made from cases."""
    return ({literal.subject: literal.values for literal in literals} for literals in alternatives(formula))


def _most_asked(steps: Sequence[Step]) -> str:
    asked = [subject.text for step in steps for subject in _tested(step)]
    return max(sorted(set(asked)), key=asked.count, default="")


def _tested(step: Step) -> Iterator[Subject]:
    yield from step.tested()
    if step.sometimes:
        yield from (whether_sent(step, port) for port in step.outputs)


def whether_sent(step: Step, port: str) -> Subject:
    """Whether a step sends, where the model does not say."""
    key = " ".join(("sends", port, step.row.kind, str(step.row.index), *(step.trail or ())))
    return Subject(key, f"sending at {step.row.at}")


def _outcomes(run: _Run, step: Step, variables: Collection[str], pick: Pick) -> Iterator[_Run]:
    """The ways in which a step may end."""
    rest, run = _residue(step, run)
    tested = partial(run.tested, step=step)
    truth = evaluate(rest, tested)
    if truth is None:
        subject = first_unknown(rest, tested)
        for value in pick(subject):
            yield from _outcomes(run.choosing(subject, value, variable=subject.key in variables), step, variables, pick)
    elif truth:
        yield from _taken(run, step, step.assignments, variables, pick)
    else:
        yield run


def _taken(run: _Run, step: Step, left: Sequence[Assignment], variables: Collection[str], pick: Pick) -> Iterator[_Run]:
    """The ways in which a step whose guard holds may end, when these assignments are left to be made."""
    if not left:
        yield from _sent(run, step, step.outputs, (), pick)
        return
    for condition, value in left[0].table:
        truth = evaluate(condition, run.current)
        if truth:
            yield from _taken(run.assigned(left[0].cell.subject.key, value), step, left[1:], variables, pick)
            return
        if truth is None:
            subject = first_unknown(condition, run.current)
            for chosen in pick(subject):
                yield from _taken(run.choosing(subject, chosen, variable=subject.key in variables), step, left, variables, pick)
            return
    yield from _taken(run, step, left[1:], variables, pick)


def _sent(run: _Run, step: Step, left: Sequence[str], sent: tuple[str, ...], pick: Pick) -> Iterator[_Run]:
    if not left:
        yield run.followed(step, sent)
    elif not step.sometimes:
        yield run.followed(step, tuple(left))
    else:
        subject = whether_sent(step, left[0])
        for value in pick(subject):
            more = (left[0],) if value == BOOLEAN[0] else ()
            yield from _sent(run.choosing(subject, value, variable=False), step, left[1:], sent + more, pick)


def _residue(step: Step, run: _Run) -> tuple[Formula, _Run]:
    """What of the guard of a step is open, and the run, in which the variables that it tests are seen from now on."""
    parts = []
    for part, conjunct in enumerate(step.guard):
        rest = simplify(conjunct, partial(run.tested, step=step, part=part))
        seen = {
            step.tested_as(s.key, part): run.values[s.key]
            for s in subjects(conjunct)
            if s.key in run.values and step.tested_as(s.key, part) not in run.seen
        }
        run = replace(run, seen={**run.seen, **seen}) if seen else run
        parts.append(rest)
        if evaluate(rest, partial(run.tested, step=step)) is False:
            break
    return conjunction(parts), run
