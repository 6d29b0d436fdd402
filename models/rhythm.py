"""How often a component sends of what sets it off: every time, where parameters say so, or in a rhythm that its state gives.

What a rhythm is comes of running the reaction itself, from its first state on, until a state comes again.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from rosarch.base import logic
from rosarch.base.logic import TRUE, All, Not, alternatives
from rosarch.models.behavior import Behavior, Transition
from rosarch.models.formula import Condition, Formula
from rosarch.models.machine.cells import Cell, Document, Domains
from rosarch.models.machine.conditions import Comparison, Operand, constant, parse_condition, strip
from rosarch.models.machine.conditions import Condition as Parsed
from rosarch.models.machine.counting import MOST_VALUES, whole
from rosarch.models.machine.logic import BOOLEAN
from rosarch.models.machine.reactions import PERIODIC, TooManyCases, component_steps, courses, is_ambiguous
from rosarch.models.machine.steps import Step

MOST_CHANGES = 200
"""Assignments to state in one reaction, beyond which it is not run: there is no end of its cases."""

_TRIED = (2, 3, 4, 5, 7)  # values of a parameter, from which is seen what it does
_MOST_ROUNDS = 1000
_MOST_COURSES = 100
_CHANGED = r"\s*(?:=(?!=)|\+\+|--|[-+*/%]=|\.|->|\[)"  # behind a name that is no plain value
_TEXTS = {
    "transitions": ("guard", "guard_normal", "value", "value_normal"), "reactive": ("when", "when_normal"),
    "one_shot": ("when", "when_normal"), "periodic": ("conditional", "conditional_normal"), "state_variables": ("initial",),
}  # fmt: skip


def with_few_changes(behavior: Behavior) -> Behavior:
    """A behaviour without the reactions that change state in more than `MOST_CHANGES` places, and without what they change."""
    counts = Counter(reaction for each in behavior.transitions for reaction in _reactions_of(each))
    large = {reaction for reaction, count in counts.items() if count > MOST_CHANGES}
    if not large:
        return behavior
    lost = {each.variable for each in behavior.transitions if not large.isdisjoint(_reactions_of(each))}
    return replace(
        behavior,
        transitions=tuple(each for each in behavior.transitions if each.variable not in lost),
        state_variables=tuple(each for each in behavior.state_variables if each.name not in lost),
        reactive=tuple(each for each in behavior.reactive if each.input not in large),
        periodic=tuple(each for each in behavior.periodic if str(each.at) not in large),
        one_shot=tuple(each for each in behavior.one_shot if str(each.at) not in large),
    )


def _reactions_of(transition: Transition) -> set[str]:
    """The ports, and the places of loops and timers, that a transition is set off by; its kind where that is all that is known."""
    places = {str(place) for place in transition.timed_by}
    return places | {trigger for trigger in transition.trigger if not (places and trigger == PERIODIC)}


@dataclass(frozen=True)
class Rhythm:
    """Of `rounds` successive times that `trigger` comes, and `factor` times `parameter` more, `sends` send through `output`.

    With a parameter, its value has to be known and greater than 1.
    """

    trigger: str
    output: str
    parameter: str
    factor: int
    rounds: int
    sends: int


def way_needs(guard: Formula, kept: Mapping[str, str]) -> Iterator[tuple[bool, list[tuple[str, str, bool]]]]:
    """For each alternative of a guard: whether only parameters that names keep decide, and which, with values that they need or exclude."""
    for alternative in alternatives(guard):
        needs = [_need(item, kept) for item in alternative]
        yield all(needs) and bool(needs), [one for one in needs if one]


def needs_of(item: Condition, kept: Mapping[str, str]) -> list[tuple[str, str, bool] | None]:
    """What each of the parts needs that have to hold for a condition: the parameter that decides it alone, and the value, or which not."""
    waiting, found = [(parse_condition(item.meaning or item.text), item.holds)], []
    while waiting:
        condition, holds = waiting.pop()
        if isinstance(condition, Not):
            waiting.append((condition.inner, not holds))
        elif isinstance(condition, All if holds else logic.Any):
            waiting += [(part, holds) for part in reversed(condition.parts)]
        else:
            found.append(_need_of(condition, holds, kept))
    return found


def _need(item: Condition, kept: Mapping[str, str]) -> tuple[str, str, bool] | None:
    found = needs_of(item, kept)
    return found[0] if len(found) == 1 else None


def _need_of(condition: Parsed, holds: bool, kept: Mapping[str, str]) -> tuple[str, str, bool] | None:
    if isinstance(condition, Operand) and (name := _name(condition.text)) in kept:
        return kept[name], "true", holds
    if isinstance(condition, Comparison) and condition.op == "==" and (name := _name(condition.left)) in kept:
        value = constant(condition.right)
        if value in BOOLEAN:
            return kept[name], "true", holds is (value == "true")
        if value is not None and value[:1] in "\"'":
            return kept[name], value[1:-1], holds
    return None


def _name(text: str) -> str:
    return re.sub(r"^(this->|self\.)", "", strip(text).replace(" ", ""))


@dataclass(frozen=True)
class Rhythms:
    """All of a component."""

    regular: tuple[Rhythm, ...] = ()
    used_up: tuple[Used, ...] = ()


NO_RHYTHMS = Rhythms()


def rhythms_of(document: Document) -> Rhythms:
    """The rhythms of a component, by its document."""
    reactions = Reactions(document)
    return Rhythms(tuple(rhythms(reactions)), tuple(used_up(reactions)))


class Reactions:
    """A component's reactions as they are run here: the steps of each trigger, and cells with the one value that they surely begin with."""

    def __init__(self, document: Document) -> None:
        self.document = runnable_document(document)
        domains = runnable_domains(self.document)
        self.counted = _counted(domains)
        traits = document.get("traits") or {}
        doubtful = {name for trait in ("changed_at_once", "changed_by_several") for name, *_ in traits.get(trait, ())}
        doubtful |= {row["name"] for row in document.get("state_variables") or () if row.get("from_param")}
        self.cells = [cell for cell in domains.cells.values() if len(cell.initial) == 1 and cell.variable not in doubtful]
        self.triggers = component_steps(self.document, domains) if self.cells else {}

    def place(self, trigger: str) -> str:
        """The port, or the place of the loop or timer, that a trigger is; "" where several are one trigger."""
        if trigger.partition(" ")[0] != PERIODIC:
            return trigger
        places = {str(row["at"]) for row in self.document["periodic"]}
        return trigger.partition(" ")[2] or (places.pop() if len(places) == 1 else "")

    def are_determined(self, steps: Sequence[Step], trigger: str) -> bool:
        """Whether it is known what these steps of a trigger do, one after the other, and a timer's change nothing but by it."""
        if is_ambiguous(steps, self.document):
            return False
        rows = [self.document["transitions"][step.row.index] for step in steps if step.row.kind == "transitions"]
        return trigger.partition(" ")[0] != PERIODIC or all(set(row.get("timed_by") or ()) == {self.place(trigger)} for row in rows)


def _counted(domains: Domains) -> list[Cell]:
    """The variables that are counted."""
    return [cell for cell in domains.cells.values() if cell.counting]


def rhythms(reactions: Reactions) -> Iterator[Rhythm]:
    """The rhythms of a component's reactions to messages, and of its loops and timers."""
    document = reactions.document
    fixed = list(_fixed(reactions))
    yield from fixed
    known = {(rhythm.trigger, rhythm.output) for rhythm in fixed}
    for name, parameter in (document.get("traits") or {}).get("keeps_value_of", ()):
        tried = [with_numbers(document, {name: value}) for value in _TRIED]
        if tried[0] == document or _counted(runnable_domains(tried[0])) == reactions.counted:
            continue  # nothing that is run here asks for it, or nothing is counted by it
        found = [{(r.trigger, r.output): r for r in _fixed(Reactions(each))} for each in tried]
        for key, first in found[0].items():
            same = [rhythms_[key] for rhythms_ in found if key in rhythms_]
            if key in known or len(same) < len(_TRIED) or len({rhythm.sends for rhythm in same}) > 1:
                continue
            for factor in (0, 1):
                more = {rhythm.rounds - factor * value for rhythm, value in zip(same, _TRIED, strict=True)}
                if len(more) == 1:
                    yield replace(first, parameter=parameter, factor=factor, rounds=more.pop())


def runnable_document(document: Document, numbers: Mapping[str, int] | None = None) -> Document:
    """The document as reactions are run by it: with the numbers that constants and these names are, and the loops whose place is known."""
    document = with_numbers(with_constants(document), numbers or {})
    return {**document, "periodic": [row for row in document.get("periodic") or () if row.get("at")]}


def runnable_domains(document: Document) -> Domains:
    """The cells of a document that reactions are run by: they count as far as is of use; limits part the other numbers into ranges."""
    return Domains(document, counts=MOST_VALUES, limits=True)


def with_constants(document: Document) -> Document:
    """The document where names of constants are replaced by the whole numbers that they are."""
    told = (document.get("traits") or {}).get("names_number", ())
    return with_numbers(document, {name: number for name, text in told if (number := whole(text)) is not None})


def with_numbers(document: Document, numbers: Mapping[str, int]) -> Document:
    """The document where names are replaced by the numbers that they keep."""
    if not numbers:
        return document
    known = "|".join(map(re.escape, sorted(numbers)))
    names = re.compile(rf"(?<![\w.>:\"'])(?:this->|self\.)?({known})(?![\w(:]|{_CHANGED})")

    def replaced(text: object) -> object:
        return names.sub(lambda match: str(numbers[match[1]]), text) if isinstance(text, str) else text

    def changed(row: Mapping[str, Any], fields: tuple[str, ...]) -> dict[str, Any]:
        ways = {"ways": [changed(way, fields) for way in row["ways"]]} if "ways" in row else {}
        meant = {"meant": [replaced(text) for text in row["meant"]]} if "meant" in row else {}
        return {**row, **{field: replaced(row.get(field)) for field in fields if field in row}, **meant, **ways}

    return {**document, **{key: [changed(row, fields) for row in document.get(key) or ()] for key, fields in _TEXTS.items()}}


def _fixed(reactions: Reactions) -> Iterator[Rhythm]:
    first = {cell.subject.key: cell.initial[0] for cell in reactions.cells}
    changed = {(trigger, a.cell.subject.key) for trigger, steps in reactions.triggers.items() for step in steps for a in step.assignments}
    for trigger, steps in reactions.triggers.items():
        place = reactions.place(trigger)
        shared = {key for other, key in changed if other != trigger}
        for output in _outputs(steps) if place else ():
            own = _needed([replace(step, outputs=(output,) if output in step.outputs else ()) for step in steps])
            if reactions.are_determined(own, trigger) and (found := _rounds(own, first, shared)):
                yield Rhythm(place, output, "", 0, *found)


def _outputs(steps: Sequence[Step]) -> list[str]:
    return sorted({port for step in steps for port in step.outputs})


@dataclass(frozen=True)
class Used:
    """Each run of the loop or timer at `trigger` that sends through `output` uses up what a message at `port` left.

    `each` message leaves it, and each run sends when it is there.
    """

    trigger: str
    output: str
    port: str
    each: bool


def used_up(reactions: Reactions) -> Iterator[Used]:
    """What loops and timers send once for what came: a flag, or a message that is kept, which they take away."""
    heard = {str(port["id"]) for port in reactions.document.get("ports") or () if port.get("kind") == "subscriber"}
    timed = [trigger for trigger in reactions.triggers if trigger.partition(" ")[0] == PERIODIC and reactions.place(trigger)]
    for trigger in timed:
        steps = reactions.triggers[trigger]
        for cell in reactions.cells if reactions.are_determined(steps, trigger) else ():
            others = {other: own for other, own in reactions.triggers.items() if other != trigger and _assigns(own, cell)}
            if cell.counting or not _assigns(steps, cell) or not all(reactions.are_determined(own, other) for other, own in others.items()):
                continue
            for output in _outputs(steps):
                found = list(_used(reactions.place(trigger), steps, cell, output, others))
                yield from found if heard.issuperset(used.port for used in found) else ()


def _used(place: str, steps: list[Step], cell: Cell, output: str, others: Mapping[str, list[Step]]) -> Iterator[Used]:
    """What these steps use up of what others, by trigger, leave in a cell."""
    try:
        taken = _taken(steps, cell, output)
        ports = {other: _sets(own, cell, taken[0]) for other, own in others.items()} if taken else {}
    except TooManyCases:
        return
    for port, how in sorted(ports.items()):
        if taken and how:
            yield Used(place, output, port, how == "each" and taken[1] and len(ports) == 1)


def _assigns(steps: list[Step], cell: Cell) -> bool:
    return any(assignment.cell == cell for step in steps for assignment in step.assignments)


def _taken(steps: list[Step], cell: Cell, output: str) -> tuple[frozenset[str], bool] | None:
    """The values of a cell with which these steps may send, and whether they surely do; None where one may be left when they have sent."""
    found = {value: list(courses(steps, [cell.subject.key], (value,), _MOST_COURSES)) for value in cell.subject.values}
    sent = {value: [[out for out in course.outputs if out.port == output] for course in own] for value, own in found.items()}
    sending = frozenset(value for value, own in sent.items() if any(own))
    if not sending or cell.initial[0] in sending:
        return None
    for value, own in found.items():
        for course, outputs in zip(own, sent[value], strict=True):
            if course.values[0] in sending and (outputs or value not in sending):
                return None
    surely = all(any(out.when == TRUE and not out.sometimes for out in outputs) for value in sending for outputs in sent[value])
    return sending, surely


def _sets(steps: list[Step], cell: Cell, values: frozenset[str]) -> str:
    """Whether a reaction may give a cell one of these values, at some times or at each; "" when never."""
    found = (courses(steps, [cell.subject.key], (value,), _MOST_COURSES) for value in cell.subject.values)
    ends = [course.values[0] in values for own in found for course in own]
    return "each" if all(ends) else "at times" if any(ends) else ""


def _needed(steps: list[Step]) -> list[Step]:
    """The steps that send, and those that change what these, or such steps, test."""
    needed: set[str] = set()
    while True:
        own = [step for step in steps if step.outputs or any(a.cell.subject.key in needed for a in step.assignments)]
        own = [replace(step, assignments=tuple(a for a in step.assignments if a.cell.subject.key in needed)) for step in own]
        asked = {subject.key for step in own for subject in step.tested() if not subject.hidden}
        if asked <= needed:
            return own
        needed |= asked


def _rounds(steps: list[Step], first: Mapping[str, str], shared: set[str]) -> tuple[int, int] | None:
    """After how many rounds the state is as it was, and how often it was sent meanwhile; None when more than that state decides."""
    keys = sorted({subject.key for step in steps for subject in step.tested() if not subject.hidden})
    if not keys or not first.keys() >= set(keys) or shared.intersection(keys) or any(step.sometimes for step in steps):
        return None
    state = tuple(first[key] for key in keys)
    seen: dict[tuple[str, ...], int] = {}
    sent: list[bool] = []
    while state not in seen:
        seen[state] = len(sent)
        try:
            found = list(courses(steps, keys, state, 1))
        except TooManyCases:
            return None
        if len(found) != 1 or len(sent) > _MOST_ROUNDS or any(out.when != TRUE for out in found[0].outputs):
            return None
        sent.append(bool(found[0].outputs))
        state = found[0].values
    cycle = sent[seen[state] :]
    return len(cycle), sum(cycle)
