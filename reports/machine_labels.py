"""How the views of a state machine name its parts: states, conditions, triggers, outputs, source lines; and what they show as one."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from rosarch.base.logic import FALSE, TRUE, All, Any, Not
from rosarch.models.machine.build import Region, StateMachine, Transition
from rosarch.models.machine.conditions import NULL
from rosarch.models.machine.logic import BOOLEAN, OTHER, Formula, Is, Subject, from_cases, without_hidden
from rosarch.models.machine.steps import Output, Row

_SIMPLE = re.compile(r"[\w.:>\-]+(\([^()]*\))?")


def value_text(subject: Subject, value: str) -> str:
    """A value of a variable; the abstract one by what it is not."""
    named = [v for v in subject.values if v != OTHER]
    if value != OTHER or len(named) != 1:
        return value
    return "set" if named[0] == NULL else f"not {named[0]}"


def formula_text(formula: Formula) -> str:
    """A condition in the notation of C++, with sets for several values; `""` when it always holds."""
    shown = without_hidden(formula)
    return "" if shown == TRUE else _text(shown, False)


def alternatives(formula: Formula) -> list[str]:
    """The same, one text for each way in which it can hold; `[""]` when it always holds."""
    shown = without_hidden(formula)
    if isinstance(shown, Any) and shown.parts:
        return [_text(part, False) for part in shown.parts]
    return [formula_text(formula)]


def _text(formula: Formula, inside: bool) -> str:
    if isinstance(formula, Is):
        return _membership(formula)
    if isinstance(formula, Not):
        return f"!({_text(formula.inner, False)})"
    if formula in (TRUE, FALSE):
        return "true" if formula == TRUE else "false"
    if isinstance(formula, All):
        return " && ".join(_text(part, True) for part in formula.parts)
    text = " || ".join(f"({part})" if " && " in part else part for part in (_text(part, False) for part in formula.parts))
    return f"({text})" if inside else text


def _membership(formula: Is) -> str:
    subject, values = formula.subject, formula.values
    text = subject.text
    if subject.values == BOOLEAN and len(values) == 1:
        if "true" in values:
            return text if subject.negative or not re.search(r"&&|\|\||\?| or | and ", text) else f"({text})"
        return subject.negative or (f"!{text}" if _SIMPLE.fullmatch(text) else f"!({text})")
    rest = [value for value in subject.values if value not in values]
    if len(values) == 1 and OTHER not in values:
        return f"{text} == {next(iter(values))}"
    if len(rest) == 1:
        return f"{text} != {rest[0]}"
    listed = rest if OTHER in values else [value for value in subject.values if value in values]
    return f"{text} {'not in' if OTHER in values else 'in'} {{{', '.join(listed)}}}"


def outputs_texts(machine: StateMachine, outputs: Iterable[Output]) -> list[str]:
    """All that is sent, ports under the same condition together."""
    groups: dict[str, list[str]] = {}
    for output in outputs:
        name = machine.ports.get(output.port, output.port) + ("?" if output.sometimes else "")
        groups.setdefault(formula_text(output.when), []).append(name)
    return [", ".join(names) + (f" if {condition}" if condition else "") for condition, names in groups.items()]


def region_title(region: Region) -> str:
    """The variables of a region."""
    return ", ".join(cell.subject.text for cell in region.cells)


def state_text(region: Region, state: int) -> str:
    """A state by the values of its variables: the value alone when there is one variable, a flag by its name."""
    values = region.states[state]
    if len(region.cells) == 1:
        return value_text(region.cells[0].subject, values[0])
    return ", ".join(_setting(cell.subject, value) for cell, value in zip(region.cells, values, strict=True))


def valuation_text(region: Region, values: Sequence[str]) -> str:
    """The same for a state that need not be one of the region."""
    return ", ".join(_setting(cell.subject, value) for cell, value in zip(region.cells, values, strict=True))


def _setting(subject: Subject, value: str) -> str:
    if subject.values == BOOLEAN:
        return subject.text if value == "true" else f"!{subject.text}"
    return f"{subject.text}={value_text(subject, value)}"


def states_text(region: Region, states: Sequence[int]) -> str:
    """Several states by what they have in common, exactly."""
    if len(states) == len(region.states):
        return "any state"
    if len(states) == 1 or len(region.cells) == 1:
        return " or ".join(state_text(region, state) for state in states)
    chosen = [region.states[state] for state in states]
    seen = [frozenset(values[i] for values in region.states) for i in range(len(region.cells))]
    sides = [frozenset(values[i] for values in chosen) for i in range(len(region.cells))]
    box = [values for values in region.states if all(value in side for value, side in zip(values, sides, strict=True))]
    if len(box) == len(chosen):  # a box, as far as states exist: only its narrow sides need be shown
        narrow = [i for i, side in enumerate(sides) if side != seen[i]]
        return ", ".join(_side(region.cells[i].subject, sides[i]) for i in narrow)
    cases = [{cell.subject: frozenset({v}) for cell, v in zip(region.cells, values, strict=True)} for values in chosen]
    formula = from_cases(cases)
    return formula_text(formula)


def _side(subject: Subject, values: frozenset[str]) -> str:
    if len(values) == 1:
        return _setting(subject, next(iter(values)))
    return f"{subject.text}={'|'.join(value_text(subject, value) for value in subject.values if value in values)}"


@dataclass(frozen=True)
class Arc:
    """Transitions that differ in nothing but where they begin and what triggers them."""

    sources: tuple[int, ...]
    triggers: tuple[str, ...]
    guard: Formula
    outputs: tuple[Output, ...]
    assigned: tuple[tuple[str, str], ...]
    moves: bool
    rows: tuple[Row, ...]


def arcs(region: Region) -> list[Arc]:
    """The transitions of a region, folded; in the order of the states and triggers.

    Those without any effect are left out, unless something else may happen under the same condition.
    """
    groups: dict[object, list[Transition]] = {}
    for transition in region.transitions:
        key = (transition.trigger, transition.guard, transition.outputs, transition.assigned)
        groups.setdefault(key, []).append(transition)
    folded: dict[object, list[list[Transition]]] = {}
    told = {(t.source, t.trigger, formula_text(t.guard)) for t in region.transitions if t.visible}
    for members in groups.values():
        if any((member.source, member.trigger, formula_text(member.guard)) in told for member in members):
            first = members[0]
            sources = tuple(sorted({member.source for member in members}))
            folded.setdefault((sources, first.guard, first.outputs, first.assigned), []).append(members)
    found = []
    for parts in folded.values():
        every = [member for members in parts for member in members]
        first = every[0]
        found.append(
            Arc(
                tuple(sorted({member.source for member in every})),
                tuple(members[0].trigger for members in parts),
                first.guard,
                first.outputs,
                first.assigned,
                any(member.source != member.target for member in every),
                tuple(sorted({row for member in every for row in member.rows}, key=lambda row: (row.kind, row.index))),
            )
        )
    return sorted(found, key=lambda arc: (len(arc.sources) != len(region.states), arc.sources))


def target_text(region: Region, arc: Arc) -> str:
    """Where an arc leads: the new values, nothing when it leads back."""
    if not arc.moves:
        return ""
    subjects = {cell.subject.key: cell.subject for cell in region.cells}
    if len(subjects) == 1:
        return "".join(value_text(subjects[key], value) for key, value in arc.assigned)
    return ", ".join(_setting(subjects[key], value) for key, value in arc.assigned)


@dataclass(frozen=True)
class Effect:
    """What `triggers` lead to under one guard, all as texts; `at` are the places in the source."""

    triggers: str
    guard: str
    sent: str
    at: tuple[str, ...]

    @property
    def label(self) -> str:
        """`trigger [guard] sends outputs`."""
        return _label(self.triggers, self.guard, self.sent)


@dataclass(frozen=True)
class Edge:
    """All transitions between two states, or those that stay in one.

    A `source` of `ANY` stands for all states of the region.
    """

    source: int
    target: int
    effects: tuple[Effect, ...]

    @property
    def labels(self) -> tuple[str, ...]:
        """The lines of a diagram."""
        return tuple(effect.label for effect in self.effects)


ANY = -1
_MANY = 3  # states, from which on transitions that lead from all of them to one are drawn as one


def edges(machine: StateMachine, region: Region) -> list[Edge]:
    """What a diagram of a region draws, in the order of the states."""
    sources: dict[object, set[int]] = {}
    for t in region.transitions:
        sources.setdefault(_effect(t), set()).add(t.source)
    found: dict[tuple[int, int], dict[tuple[str, str], list[Transition]]] = {}
    for t in region.transitions:
        everywhere = len(sources[_effect(t)]) == len(region.states) >= _MANY
        if t.visible or everywhere:
            effect = formula_text(t.guard), "; ".join(outputs_texts(machine, t.outputs))
            found.setdefault((ANY if everywhere else t.source, t.target), {}).setdefault(effect, []).append(t)
    return [
        Edge(source, target, tuple(_folded(machine, guard, sent, same) for (guard, sent), same in effects.items()))
        for (source, target), effects in sorted(found.items())
    ]


def _folded(machine: StateMachine, guard: str, sent: str, same: Sequence[Transition]) -> Effect:
    triggers = dict.fromkeys(machine.trigger(t.trigger).label for t in same)
    return Effect(", ".join(triggers), guard, sent, places_of(row for t in same for row in t.rows))


def places_of(rows: Iterable[Row]) -> tuple[str, ...]:
    """The places of rows, each once; first those where the state changes."""
    ordered = sorted(rows, key=lambda row: row.kind != "transitions")
    return tuple(dict.fromkeys(place for row in ordered for place in row.at.split()))


def _effect(transition: Transition) -> object:
    return transition.target, transition.trigger, transition.guard, transition.outputs


def state_id(name: str, state: int) -> str:
    """The identifier of a state in a diagram, within the region `name`."""
    return f"{name}_{'any' if state == ANY else state}"


def always_labels(machine: StateMachine) -> list[str]:
    """The reactions that no state matters to; triggers with the same outputs together."""
    found: dict[str, list[str]] = {}
    for t in machine.always:
        found.setdefault("; ".join(outputs_texts(machine, t.outputs)), []).append(machine.trigger(t.trigger).label)
    return [_label(", ".join(triggers), "", sent) for sent, triggers in found.items()]


def _label(triggers: str, guard: str, sent: str) -> str:
    return triggers + (f" [{guard}]" if guard else "") + (f" sends {sent}" if sent else "")


def wrapped(label: str) -> list[str]:
    """A label on lines that a diagram has room for."""
    return textwrap.wrap(label, 60, break_long_words=False, break_on_hyphens=False) or [""]


def title(machine: StateMachine) -> str:
    """`package/component`."""
    return f"{machine.package}/{machine.component}" if machine.package else machine.component


def triggers_text(machine: StateMachine, triggers: Iterable[str]) -> str:
    """The triggers by their labels."""
    return ", ".join(machine.trigger(id_).label for id_ in triggers)


class Lines:
    """Source places, short: without the folder that all share, without the file when there is only one, several of a file as one."""

    def __init__(self, machine: StateMachine) -> None:
        places = [*(p for row in _rows(machine) for p in row.at.split()), *(c.at for r in machine.regions for c in r.cells if c.at)]
        self._files = sorted({place.rpartition(":")[0] for place in places})
        parts = [file.split("/")[:-1] for file in self._files]
        shared = 0
        while parts and all(len(p) > shared and p[shared] == parts[0][shared] for p in parts):
            shared += 1
        self._folder = "".join(f"{part}/" for part in parts[0][:shared]) if parts else ""

    @property
    def shared(self) -> str:
        """The file of all places, or the folder of their files."""
        return self._files[0] if len(self._files) == 1 else self._folder

    def text(self, places: Iterable[str]) -> str:
        """`:12 :31`, or `a.cpp:12 :31 b.cpp:7`."""
        found: dict[str, set[int]] = {}
        for place in places:
            file, _, line = place.rpartition(":")
            found.setdefault(file, set()).add(int(line) if line.isdigit() else 0)
        words = []
        for file, lines in sorted(found.items()):
            name = "" if len(self._files) == 1 else file.removeprefix(self._folder)
            words.append(name + " ".join(f":{line}" for line in sorted(lines)))
        return " ".join(words)

    def of(self, rows: Iterable[Row]) -> str:
        """The places of rows."""
        return self.text(place for row in rows for place in row.at.split())


def _rows(machine: StateMachine) -> Iterator[Row]:
    for transition in (*machine.always, *(t for region in machine.regions for t in region.transitions)):
        yield from transition.rows
    yield from machine.dead
