"""State machines of a component, from its document: states are values of its state variables, transitions its reactions.

Variables whose assignments or outputs depend on one another form a region; regions are independent of each other and run side by side.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

from rosarch.base.logic import TRUE
from rosarch.models.behavior import sent_in_loop
from rosarch.models.machine.cells import Cell, Document, Domains
from rosarch.models.machine.conditions import spaced
from rosarch.models.machine.logic import Formula, Subject, conjunction, evaluate, from_cases, simplify, subjects
from rosarch.models.machine.parts import continuation, short
from rosarch.models.machine.reactions import PERIODIC, Course, TooManyCases, component_steps, courses, distinguished_loops, loop_trigger
from rosarch.models.machine.steps import Output, Row, Step

MAX_STATES = 16
MAX_COURSES = 256
MAX_CASES = 10_000  # courses of all reactions from all states of a group
REACHABLE_STATES = 256  # the bound within which a group is searched for what cannot happen, also when it is not shown as one


@dataclass(frozen=True)
class Trigger:
    """What a reaction begins with: a port, or `periodic`, `main`, `thread`, `signal`, ...; `label` is for people."""

    id: str
    label: str


@dataclass(frozen=True)
class Transition:
    """From one state to another, or back to the same one, when `trigger` arrives and `guard` holds.

    `assigned` are the values given to cells, also where they were the same before. `rows` are the rows of the model it rests on.
    """

    source: int
    target: int
    trigger: str
    guard: Formula
    outputs: tuple[Output, ...]
    assigned: tuple[tuple[str, str], ...]
    rows: tuple[Row, ...]

    @property
    def visible(self) -> bool:
        """Whether anything happens."""
        return self.source != self.target or bool(self.outputs)


@dataclass(frozen=True)
class Region:
    """A state machine over some cells. A state is a valuation, in the order of `cells`; states are referred to by their index.

    `states` are those that can be reached; `never` holds, of each cell, the values that none of them has. `unreachable` are the
    remaining valuations, as far as they are no more than a person would read.
    """

    cells: tuple[Cell, ...]
    states: tuple[tuple[str, ...], ...]
    initial: tuple[int, ...]
    transitions: tuple[Transition, ...]
    never: tuple[tuple[str, tuple[str, ...]], ...]
    unreachable: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class StateMachine:
    """The behaviour of a component.

    `always` are the reactions that no state matters to, as transitions of a region with a single state. `left_out` are state variables
    whose values are too many to distinguish. `dead` are rows of the model that no reachable state lets happen. `messages` say where
    the machines say less than the rows.
    """

    component: str
    package: str
    kind: str
    node_name: str | None
    triggers: tuple[Trigger, ...]
    ports: Mapping[str, str]
    regions: tuple[Region, ...]
    always: tuple[Transition, ...]
    left_out: tuple[str, ...]
    dead: tuple[Row, ...]
    messages: tuple[str, ...]

    def trigger(self, id_: str) -> Trigger:
        """The trigger of this name."""
        return next(trigger for trigger in self.triggers if trigger.id == id_)


@dataclass(frozen=True)
class _View:
    """How variables that depend on one another are shown."""

    max_states: int
    joint: bool


def build_machine(document: Document, *, max_states: int = MAX_STATES, joint: bool = False) -> StateMachine:
    """The state machines of a component.

    Variables that depend on one another are one region of up to `max_states` states, unless every combination of their values can be
    reached: then a region of each, with conditions on the others, says the same in less. `joint` asks for one region even so.
    """
    view = _View(max_states, joint)
    domains = Domains(document, counts=MAX_STATES)
    steps = component_steps(document, domains)
    homes = _homes(steps)
    messages = _loops_message(document, steps)
    regions: list[Region] = []
    happened: set[Row] = set()
    for group in _groups(domains, steps):
        found, rows = _group_regions(group, steps, homes, view, messages)
        regions += found
        happened |= rows
    always, rows = _always(steps, homes)
    ports = _port_labels(document)
    return StateMachine(
        component=spaced(str(document.get("component") or "")),
        package=spaced(str(document.get("package") or "")),
        kind=spaced(str(document.get("kind") or "node")),
        node_name=spaced(str(document["node_name"])) if document.get("node_name") else None,
        triggers=tuple(Trigger(id_, _trigger_label(id_, document, ports)) for id_ in steps),
        ports=ports,
        regions=tuple(regions),
        always=always,
        left_out=tuple(domains.left_out()),
        dead=_dead(steps, happened | rows),
        messages=tuple(dict.fromkeys(messages)),
    )


def _loops_message(document: Document, steps: Mapping[str, Sequence[Step]]) -> list[str]:
    """Where the model does not say which of several timed loops makes an assignment."""
    if distinguished_loops(document):
        return []
    loops = {row.get("at") for row in document.get("periodic") or () if sent_in_loop(row)}
    if len(loops) < 2 or not any(step.assignments for step in steps.get("periodic", ())):
        return []
    return [f"{len(loops)} timed loops are shown as one, `periodic`, that does what each of them does"]


def _groups(domains: Domains, steps: Mapping[str, Sequence[Step]]) -> list[list[Cell]]:
    """The cells, those together that depend on one another."""
    leader = {key: key for key in domains.cells}

    def find(key: str) -> str:
        while leader[key] != key:
            key = leader[key]
        return key

    for step in (step for own in steps.values() for step in own):
        guard = [subject.key for formula in step.guard for subject in subjects(formula) if subject.cell]
        for assignment in step.assignments:
            values = [s.key for formula, _ in assignment.table for s in subjects(formula) if s.cell]
            _join(leader, find, [*guard, *values, assignment.cell.subject.key])
        if step.outputs:
            _join(leader, find, guard)
    groups: dict[str, list[Cell]] = {}
    for key, cell in domains.cells.items():
        groups.setdefault(find(key), []).append(cell)
    return list(groups.values())


def _join(leader: dict[str, str], find: Any, keys: Sequence[str]) -> None:
    for key in keys[1:]:
        leader[find(key)] = find(keys[0])


Homes = Mapping[tuple[str, Row], str]


def _homes(steps: Mapping[str, Sequence[Step]]) -> Homes:
    """For each trigger and row that sends, the cell whose transitions it is shown with.

    That is the one assigned under the most similar guard, else one that the guard tests; nothing for what no state matters to.
    """
    found: dict[tuple[str, Row], str] = {}
    for trigger, own in steps.items():
        for step in own:
            best = (False, 0, False)
            tested = [subject.key for formula in step.guard for subject in subjects(formula) if subject.cell]
            candidates: list[tuple[str, tuple[Formula, ...] | None]] = [(key, None) for key in tested if step.outputs]
            candidates += [(a.cell.subject.key, other.guard) for other in own for a in other.assignments if step.outputs]
            for key, guard in candidates:
                shared = len(set(step.guard) & set(guard or ()))
                score = (guard == step.guard, shared, key in tested)
                if score > best:
                    best, found[trigger, step.row] = score, key
    return found


def _own_steps(cells: Sequence[Cell], steps: Mapping[str, Sequence[Step]], homes: Homes) -> dict[str, list[Step]]:
    """The steps that belong to a region: the assignments of its cells, what is sent together with them, and what these build upon.

    That is an assignment of a cell elsewhere when the same reaction tests that cell later.
    """
    keys = {cell.subject.key for cell in cells}
    found: dict[str, list[Step]] = {}
    for trigger, all_ in steps.items():
        kept: list[Step] = []
        later: set[str] = set()
        for step in reversed(all_):
            own = replace(step, assignments=tuple(a for a in step.assignments if a.cell.subject.key in keys | later))
            if own.assignments or homes.get((trigger, step.row)) in keys:
                kept.insert(0, own)
                later |= {subject.key for subject in own.tested() if subject.cell}
        if any(homes.get((trigger, step.row)) in keys or any(a.cell.subject.key in keys for a in step.assignments) for step in kept):
            found[trigger] = kept
    return found


def _group_regions(
    group: list[Cell], steps: Mapping[str, Sequence[Step]], homes: Homes, view: _View, messages: list[str]
) -> tuple[list[Region], set[Row]]:
    """A group as one region, or as one for each cell when it has too many states or cases."""
    names = ", ".join(cell.subject.text for cell in group)
    try:
        whole = _explore(group, _own_steps(group, steps, homes), max(view.max_states, REACHABLE_STATES))
    except _TooLarge as error:
        if len(group) == 1:
            messages.append(f"{names}: {error}; each assignment is shown for itself")
            whole = _one_by_one(group[0], _own_steps(group, steps, homes))
            return [_region(group, whole, view.max_states)], whole[3]
        messages.append(f"{names} depend on each other: {error}, so each is shown alone")
        parts = [_group_regions([cell], steps, homes, view, messages) for cell in group]
        return [region for regions, _ in parts for region in regions], set().union(*(rows for _, rows in parts))
    states, _, _, rows = whole
    every = len(states) == math.prod(len(cell.subject.values) for cell in group) and not view.joint
    if len(group) == 1 or (len(states) <= view.max_states and not every):
        return [_region(group, whole, view.max_states)], rows
    if not every:
        messages.append(f"{names} depend on each other: {len(states)} states together, so each is shown alone")
    parts = [_group_regions([cell], steps, homes, view, messages) for cell in group]
    seen = [{values[index] for values in states} for index in range(len(group))]
    return [_within(region, values, rows) for (regions, _), values in zip(parts, seen, strict=True) for region in regions], rows


def _within(region: Region, values: set[str], rows: set[Row]) -> Region:
    """A region of one cell without what its group as a whole never reaches."""
    kept = [index for index, (value,) in enumerate(region.states) if value in values]
    place = {old: new for new, old in enumerate(kept)}
    transitions = tuple(
        replace(t, source=place[t.source], target=place[t.target])
        for t in region.transitions
        if t.source in place and t.target in place and rows.issuperset(t.rows)
    )
    (cell,) = region.cells
    missing = tuple(value for value in cell.subject.values if value not in values)
    never = ((cell.subject.key, missing),) if missing else ()
    states = tuple(region.states[index] for index in kept)
    initial = tuple(place[index] for index in region.initial)
    return Region(region.cells, states, initial, transitions, never, tuple((value,) for value in missing))


class _TooLarge(Exception):
    """A region cannot be shown as one; the text says why."""


Explored = tuple[list[tuple[str, ...]], list[int], list[Transition], set[Row]]


def _explore(cells: Sequence[Cell], steps: Mapping[str, Sequence[Step]], max_states: int) -> Explored:
    """The reachable states and the transitions between them, breadth first."""
    keys = [cell.subject.key for cell in cells]
    if math.prod(len(cell.initial) for cell in cells) > max_states:
        raise _TooLarge(f"more than {max_states} states together")
    states = {values: index for index, values in enumerate(product(*(cell.initial for cell in cells)))}
    initial = list(states.values())
    transitions: list[Transition] = []
    rows: set[Row] = set()
    queue = list(states)
    cases = 0
    for values in queue:
        for trigger, own in steps.items():
            try:
                found = list(courses(own, keys, values, MAX_COURSES))
            except TooManyCases:
                raise _TooLarge(f"more than {MAX_COURSES} cases of one reaction") from None
            cases += len(found)
            if cases > MAX_CASES:
                raise _TooLarge(f"more than {MAX_CASES} cases together")
            rows.update(row for course in found for row in course.rows)
            for course in found:
                if course.values not in states:
                    states[course.values] = len(states)
                    queue.append(course.values)
                if len(states) > max_states:
                    raise _TooLarge(f"more than {max_states} states together")
            transitions += _merged(found, trigger, states[values], states)
    return list(states), initial, transitions, rows


def _merged(found: Sequence[Course], trigger: str, source: int, states: Mapping[tuple[str, ...], int]) -> list[Transition]:
    """One transition for all courses with the same effect, under a guard that covers them."""
    groups: dict[Any, list[Course]] = {}
    for course in found:
        groups.setdefault((course.values, course.assigned, course.outputs), []).append(course)
    cases = {effect: [{s: frozenset({v}) for s, v in course.choices.items()} for course in members] for effect, members in groups.items()}
    result = []
    for effect, members in groups.items():
        values, assigned, outputs = effect
        if assigned or outputs:
            against = [case for other, own in cases.items() if other != effect for case in own]
            guard = from_cases(cases[effect], against)
            rows = tuple(sorted({row for course in members for row in course.rows}, key=lambda row: (row.kind, row.index)))
            result.append(Transition(source, states[values], trigger, guard, outputs, assigned, rows))
    return result


def _region(cells: Sequence[Cell], explored: Explored, max_states: int) -> Region:
    states, initial, transitions, _rows = explored
    reached = set(states)
    never = []
    for index, cell in enumerate(cells):
        taken = {values[index] for values in states}
        if missing := tuple(value for value in cell.subject.values if value not in taken):
            never.append((cell.subject.key, missing))
    small = math.prod(len(cell.subject.values) for cell in cells) <= max(max_states, MAX_STATES) ** 2
    unreachable = tuple(v for v in product(*(cell.subject.values for cell in cells)) if v not in reached) if small else ()
    return Region(tuple(cells), tuple(states), tuple(initial), tuple(transitions), tuple(never), unreachable)


def _one_by_one(cell: Cell, steps: Mapping[str, Sequence[Step]]) -> Explored:
    """The transitions of a cell whose reactions have too many cases: every step as if it were the only one."""
    states: list[tuple[str, ...]] = [(value,) for value in cell.subject.values]
    transitions = []
    for source, (value,) in enumerate(states):
        for trigger, own in steps.items():
            for step in own:
                outputs = tuple(Output(port, sometimes=step.sometimes) for port in step.outputs)
                effects = [(condition, new) for a in step.assignments if a.cell == cell for condition, new in a.table]
                for condition, new in effects or [(TRUE, "")] * bool(outputs):
                    guard = conjunction(simplify(part, {cell.subject: value}.get) for part in (*step.guard, condition))
                    if evaluate(guard, dict[Subject, str]().get) is not False:
                        target = cell.subject.values.index(new) if new else source
                        assigned = ((cell.subject.key, new),) if new else ()
                        transitions.append(Transition(source, target, trigger, guard, outputs, assigned, (step.row,)))
    initial = [cell.subject.values.index(value) for value in cell.initial]
    return states, initial, transitions, {row for transition in transitions for row in transition.rows}


def _always(steps: Mapping[str, Sequence[Step]], homes: Homes) -> tuple[tuple[Transition, ...], set[Row]]:
    """What is sent in reaction to a trigger whatever the state."""
    found = []
    for trigger, all_ in steps.items():
        own = [step for step in all_ if step.outputs and (trigger, step.row) not in homes]
        for course in courses(own, (), (), MAX_COURSES):
            if course.outputs:
                found.append(Transition(0, 0, trigger, TRUE, course.outputs, (), course.rows))
    return tuple(found), {row for transition in found for row in transition.rows}


def _dead(steps: Mapping[str, Sequence[Step]], happened: set[Row]) -> tuple[Row, ...]:
    """Rows that could be followed, and never happen."""
    followed = {step.row for own in steps.values() for step in own if step.assignments or step.outputs}
    return tuple(sorted(followed - happened, key=lambda row: (row.kind, row.index)))


def _port_labels(document: Document) -> dict[str, str]:
    """The names of the ports, with the port's id where several have the same name or none is known."""
    ports = {str(port["id"]): spaced(str(port.get("name") or "?")) for port in document.get("ports") or ()}
    times = Counter(ports.values())
    return {id_: f"{name} ({id_})" if times[name] > 1 or name == "?" else name for id_, name in ports.items()}


def _trigger_label(id_: str, document: Document, ports: Mapping[str, str]) -> str:
    if after := continuation(id_):
        return f"{_trigger_label(after[0], document, ports)} after {short(after[1])}"
    if id_ in ports:
        return "reconfigure" if ports[id_] == "~" else ports[id_]
    loops = {str(row.get("at")): row.get("hz") for row in document.get("periodic") or ()}
    rates = set(loops.values())
    if id_ == PERIODIC and len(rates) == 1 and (hz := next(iter(rates))):
        return f"{hz:g} Hz"
    for at, hz in loops.items():
        if id_ == loop_trigger(at):
            rate = f"{hz:g} Hz" if hz else PERIODIC
            return rate if hz and list(loops.values()).count(hz) == 1 else f"{rate} {at.rpartition('/')[2]}"
    return spaced(id_)
