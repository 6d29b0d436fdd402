"""What happens in one go: the steps of a node's reaction to a trigger, run from a state for every course they may take.

A reaction is atomic, as callbacks of a single-threaded spinner are. Its steps are taken in the order of their lines or, where these do not
show it, of the calls that lead to them. What one test
of a variable finds is what all see that hangs on it, whatever is assigned behind it, as the cases of a `switch` do; a later test sees
what was assigned before it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

from rosarch.base.logic import TRUE
from rosarch.models.behavior import sent_in_loop
from rosarch.models.machine.cells import Document, Domains, variable_and_field
from rosarch.models.machine.epochs import with_epochs
from rosarch.models.machine.logic import Formula, Subject, conjunction, evaluate, first_unknown, simplify, subjects
from rosarch.models.machine.meaning import Meaning
from rosarch.models.machine.parts import apart, by_callback
from rosarch.models.machine.steps import Output, Row, Step, trail_of
from rosarch.models.machine.switching import WAYS, gated, gates, switch_steps

PERIODIC = "periodic"


class TooManyCases(Exception):
    """A reaction has more courses than anyone wants to see."""


@dataclass(frozen=True)
class Course:
    """One way a reaction may go: what was chosen, the values after it, the cells that were assigned, what was sent."""

    choices: Mapping[Subject, str]
    values: tuple[str, ...]
    assigned: tuple[tuple[str, str], ...]
    outputs: tuple[Output, ...]
    rows: tuple[Row, ...]


def component_steps(document: Document, domains: Domains) -> dict[str, list[Step]]:
    """The steps of each trigger, in the order they are taken; triggers in the order of the document."""
    meaning = Meaning(domains)
    names = {row["name"] for row in document.get("state_variables") or ()}
    found: dict[str, list[Step]] = {}
    trees: dict[Step, Any] = {}
    loops = distinguished_loops(document)
    known_messages = Messages(document)
    for index, row in enumerate(document.get("transitions") or ()):
        if not row.get("variable"):
            continue
        variable, suffix = variable_and_field(row, names)
        owner = variable.rpartition("::")[0].rsplit("::", 1)[-1]
        messages = names_of_messages(document, _list(row.get("trigger")))
        assignments = meaning.assignments(variable, suffix, domains.assigned(row), owner, messages)
        guard = meaning.guard(row, "guard", owner)
        step = Step(Row("transitions", index, _place(row)), guard, tuple(assignments), trail=trail_of(row))
        trees[step] = row.get("guard_tree")
        for trigger in _triggers(row, loops):
            found.setdefault(trigger, []).append(step)
    for index, row in enumerate(document.get("reactive") or ()):
        for way in row.get("ways") or (row,):
            guard = meaning.guard(way, "when", "")
            sometimes = not guard and row.get("must") is False
            step = Step(Row("reactive", index, _place(way)), guard, (), (str(row["output"]),), sometimes, trail=trail_of(way))
            step = known_messages.of_call(step)
            trees[step] = way.get("when_tree")
            for trigger in _list(row.get("input")):
                found.setdefault(trigger, []).append(step)
    for index, row in _rounds(document):
        for way in row.get("ways") or (row,):
            guard = meaning.guard(way, "conditional", "")
            sending = {**row, "publishes": way["publishes"], "calls": []} if way is not row and "publishes" in way else row
            for sometimes, sent in _sent_in_round(document, sending, certain=bool(guard)):
                place = _last_condition(way.get("conditional_tree"))
                step = Step(Row("periodic", index, _place(row)), guard, (), sent, sometimes, done_at=place, trail=trail_of(way))
                step = known_messages.of_round(step, row)
                trees[step] = way.get("conditional_tree")
                found.setdefault(loop_trigger(row.get("at")) if loops else PERIODIC, []).append(step)
    for index, row in enumerate(document.get("one_shot") or ()):
        for way in row.get("ways") or (row,):
            guard = meaning.guard(way, "when", "")
            step = Step(Row("one_shot", index, _place(row)), guard, (), (str(row["output"]),), trail=trail_of(way))
            step = known_messages.of_call(step, tuple(_list(row.get("sent_at"))))
            trees[step] = way.get("when_tree")
            found.setdefault("timer", []).append(step)
    known = gates(document)
    for number, gate in enumerate(known):
        for switch, step in switch_steps(gate, meaning):
            own = replace(step, row=replace(step.row, index=number * WAYS + step.row.index))
            trees[own] = switch.get("guard_tree")
            for trigger in _triggers(switch, loops):
                found.setdefault(trigger, []).append(own)
    traits = document.get("traits") or {}
    unsteady, anew = ({str(name) for (name,) in traits.get(trait, ())} for trait in ("unsteady_name", "gives_another"))
    parts = apart(found, trees, document)
    ordered = {trigger: with_epochs(sorted(steps, key=_order), trees, unsteady, anew) for trigger, steps in parts.items()}
    return {trigger: by_callback(gated(steps, trigger, known, document), trigger, document) for trigger, steps in ordered.items()}


class Messages:
    """What the document says about the messages that are sent."""

    def __init__(self, document: Document) -> None:
        contents = document.get("contents") or {}
        self._at: dict[tuple[str, str], set[str]] = {}
        for port, place, message in contents.get("sent", ()):
            self._at.setdefault((port, place), set()).add(message)
        self._rounds: dict[tuple[str, str, str | None], set[str]] = {}
        for port, place, loop, condition in contents.get("rounds", ()):
            self._rounds.setdefault((port, loop, condition), set()).add(place)

    def of_call(self, step: Step, places: Sequence[str] = ()) -> Step:
        """The step, whose row is about calls that send, with the message, if there is only one."""
        (place, *others) = places or step.row.at.split(" ")
        return step if others else replace(step, messages=self._messages(step, place))

    def of_round(self, step: Step, row: Mapping[str, Any]) -> Step:
        """The step of a timed loop or timer with the messages that it sends by one call each; the last of these is its place."""
        called = {port: self._rounds.get((port, str(row.get("at")), row.get("conditional")), set()) for port in step.outputs}
        known = [(port, *places) for port, places in called.items() if len(places) == 1]
        messages = tuple(found for port, place in known for found in self._messages(step, place) if found[0] == port)
        done = max([place for _, place in known], key=_position) if messages else step.done_at
        return replace(step, messages=messages, done_at=done)

    def _messages(self, step: Step, place: str) -> tuple[tuple[str, str], ...]:
        found = {port: self._at.get((port, place), set()) for port in step.outputs}
        return tuple((port, next(iter(messages))) for port, messages in found.items() if len(messages) == 1)


def _rounds(document: Document) -> Iterator[tuple[int, Mapping[str, Any]]]:
    """The rows of timed loops and timers, those that differ in their rates alone once."""
    told: list[dict[str, Any]] = []
    for index, row in enumerate(document.get("periodic") or ()):
        own = {key: value for key, value in row.items() if key not in ("hz", "hz_from_param")}
        if own not in told:
            told.append(own)
            yield index, row


def _sent_in_round(document: Document, row: Mapping[str, Any], *, certain: bool) -> Iterator[tuple[bool, tuple[str, ...]]]:
    """What a row of a timed loop or timer sends, that of each round apart from that of some rounds of which no condition says which.

    What runs for each of several objects sends through the ports of one of them.
    """
    traits = document.get("traits")
    always = {port for place, port in (traits or {}).get("round_always", ()) if place == _place(row)}
    of_each = [_place(row)] in (list(values) for values in (traits or {}).get("round_of_each", ()))
    sent = sent_in_loop(row)
    for sometimes in (False, True):
        ports = tuple(port for port in sent if (of_each or (not certain and traits is not None and port not in always)) is sometimes)
        if ports:
            yield sometimes, ports


def names_of_messages(document: Document, triggers: Sequence[str]) -> frozenset[str]:
    """What the code that all of these triggers run calls the message, and nothing else."""
    told = (document.get("traits") or {}).get("names_message", ())
    names = [frozenset(name for port, name in told if port == trigger) for trigger in triggers]
    return frozenset.intersection(*names) if names else frozenset()


def is_ambiguous(steps: Iterable[Step], document: Document) -> bool:
    """Whether the order of some of these steps, all of one reaction, is not known, or that of their tests."""
    missed = {place for (place,) in (document.get("traits") or {}).get("may_be_missed", ())}
    return any(step.unclear or step.trail == () or not missed.isdisjoint(step.row.at.split()) for step in steps)


def distinguished_loops(document: Document) -> frozenset[str]:
    """The places of the timed loops, if there are several and every assignment that one of them makes says which."""
    rows = [row for row in document.get("transitions") or () if PERIODIC in _list(row.get("trigger"))]
    loops = frozenset(str(row.get("at")) for row in document.get("periodic") or ())
    return loops if len(loops) > 1 and all(loops.intersection(_list(row.get("timed_by"))) for row in rows) else frozenset()


def loop_trigger(place: object) -> str:
    """The trigger of the timed loop that waits at `place`."""
    return f"{PERIODIC} {place}"


def _triggers(row: Mapping[str, object], loops: frozenset[str]) -> list[str]:
    triggers = _list(row.get("trigger"))
    if not loops or PERIODIC not in triggers:
        return triggers
    timed = [loop_trigger(place) for place in _list(row.get("timed_by")) if place in loops]
    return [trigger for trigger in triggers if trigger != PERIODIC] + timed


def _list(value: object) -> list[str]:
    if value is None:
        return []
    return [str(item) for item in value] if isinstance(value, list | tuple) else [str(value)]


def _place(row: Mapping[str, object]) -> str:
    return " ".join(_list(row.get("at")))


def _last_condition(tree: object) -> str:
    """The place of the last condition of a guard: what it guards is done behind it."""
    if not isinstance(tree, Mapping):
        return ""
    if "condition" in tree:
        return str(tree.get("at") or "")
    found = [place for part in (*tree.get("all", ()), *tree.get("any", ())) if (place := _last_condition(part))]
    return max(found, key=_line, default="")


def _position(place: str) -> tuple[str, int, int]:
    """The file of a place, its line, and its column where it has one."""
    match = re.fullmatch(r"(.*?)(?::(\d+))?(?::(\d+))?", place)
    return (match[1], int(match[2] or 0), int(match[3] or 0)) if match else (place, 0, 0)


def _line(place: str) -> tuple[str, int]:
    path, _, line = place.rpartition(":")
    return path, int(line) if re.fullmatch(r"\d+", line) else 0


def _order(step: Step) -> tuple[tuple[tuple[str, int, int], ...], bool, int]:
    """By line, or by calls; the place of a timed loop or timer is its pause or beginning: what it sends is behind its conditions."""
    trail = step.trail or (step.done_at or step.row.at).split(" ")[:1]
    return tuple(map(_position, trail)), bool(step.outputs), step.row.index


@dataclass
class _Run:
    """A reaction under way."""

    step: int = 0
    part: int = 0
    values: dict[str, str] = field(default_factory=dict)
    seen: dict[str, str] = field(default_factory=dict)
    choices: dict[Subject, str] = field(default_factory=dict)
    assigned: dict[str, str] = field(default_factory=dict)
    outputs: list[Output] = field(default_factory=list)
    rows: list[Row] = field(default_factory=list)

    def fork(self, subject: Subject, value: str) -> _Run:
        """The same with a choice more."""
        copy = replace(
            self, values=dict(self.values), seen=dict(self.seen), choices={**self.choices, subject: value}, assigned=dict(self.assigned)
        )
        copy.outputs, copy.rows = list(self.outputs), list(self.rows)
        if subject.cell:
            copy.values[subject.key] = value
        return copy

    def tested(self, subject: Subject, step: Step, part: int = 0) -> str | None:
        """The value that a condition of the guard of a step sees."""
        if not subject.cell:
            return self.choices.get(subject)
        return self.seen.get(step.tested_as(subject.key, part), self.values.get(subject.key))

    def current(self, subject: Subject) -> str | None:
        """The value that an assignment reads."""
        return self.values.get(subject.key) if subject.cell else self.choices.get(subject)


def courses(steps: Sequence[Step], cells: Sequence[str], values: Sequence[str], limit: int) -> Iterator[Course]:
    """All courses of a reaction from a state, given as the values of the cells of a region; cells elsewhere begin like inputs.

    Raises `TooManyCases` beyond `limit` courses.
    """
    deciding = set().union(*(step.tested() for step in steps if step.assignments)) if steps else set()
    waiting = [_Run(values=dict(zip(cells, values, strict=True)))]
    done = 0
    while waiting:
        run = waiting.pop()
        open_subject = _advance(run, steps, set(cells), deciding)
        if open_subject is not None:
            waiting += [run.fork(open_subject, value) for value in reversed(open_subject.values)]
        else:
            done += 1
            yield Course(
                run.choices,
                tuple(run.values[cell] for cell in cells),
                tuple((cell, run.assigned[cell]) for cell in cells if cell in run.assigned),
                _once(run.outputs),
                tuple(dict.fromkeys(run.rows)),
            )
        if done + len(waiting) > limit:
            raise TooManyCases


def _advance(run: _Run, steps: Sequence[Step], cells: set[str], deciding: set[Subject]) -> Subject | None:
    """Run on to the end, or to a subject that something hangs on and of which nothing is known."""
    while run.step < len(steps):
        step = steps[run.step]
        rest = _residue(step, run)
        tested = partial(run.tested, step=step)
        truth = evaluate(rest, tested)
        if truth is None and (step.assignments or not deciding.isdisjoint(subjects(rest))):
            return first_unknown(rest, tested)
        if truth is not False:
            if (subject := _assign(run, step)) is not None:
                return subject
            run.outputs += [Output(port, rest, step.sometimes) for port in step.outputs]
            if step.outputs or any(assignment.cell.subject.key in cells for assignment in step.assignments):
                run.rows.append(step.row)
        run.step, run.part = run.step + 1, 0
    return None


def _residue(step: Step, run: _Run) -> Formula:
    """What of the guard of a step is open; the cells that it tests are seen from now on."""
    parts = []
    for part, conjunct in enumerate(step.guard):
        tested = partial(run.tested, step=step, part=part)
        rest = simplify(conjunct, tested)
        for subject in subjects(conjunct):
            if subject.cell and subject.key in run.values:
                run.seen.setdefault(step.tested_as(subject.key, part), run.values[subject.key])
        parts.append(rest)
        if evaluate(rest, tested) is False:
            break
    return conjunction(parts)


def _assign(run: _Run, step: Step) -> Subject | None:
    """Make the assignments of a step that are left; stop at a subject that a value hangs on."""
    while run.part < len(step.assignments):
        assignment = step.assignments[run.part]
        key = assignment.cell.subject.key
        for condition, value in assignment.table:
            truth = evaluate(condition, run.current)
            if truth is None:
                return first_unknown(condition, run.current)
            if truth:
                run.values[key] = run.assigned[key] = value
                break
        run.part += 1
    return None


def _once(outputs: Iterable[Output]) -> tuple[Output, ...]:
    """Each port once for each condition, and only once when one of them is none."""
    found = list(dict.fromkeys(outputs))
    certain = {output.port for output in found if output.when == TRUE and not output.sometimes}
    return tuple(output for output in found if output.port not in certain or (output.when == TRUE and not output.sometimes))
