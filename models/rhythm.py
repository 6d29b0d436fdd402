"""How often a component sends of what sets it off: every time, where parameters say so, or in a rhythm that its counters give.

What a rhythm is comes of running the reaction itself, from its first state on, until a state comes again.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from rosarch.models import formula
from rosarch.models.machine.cells import Document, Domains
from rosarch.models.machine.conditions import Comparison, Negation, Operand, constant, parse_condition, strip
from rosarch.models.machine.counting import stepped, whole
from rosarch.models.machine.logic import TRUE
from rosarch.models.machine.reactions import PERIODIC, TooManyCases, component_steps, courses
from rosarch.models.machine.steps import Step

_TRIED = (2, 3, 4, 5, 7)  # values of a parameter, from which is seen what it does
_MOST_ROUNDS = 1000
_CHANGED = r"\s*(?:=(?!=)|\+\+|--|[-+*/%]=|\.|->|\[)"  # behind a name that is no plain value
_TEXTS = {
    "transitions": ("guard", "guard_normal", "value"), "reactive": ("when", "when_normal"), "one_shot": ("when", "when_normal"),
    "periodic": ("conditional", "conditional_normal"), "state_variables": ("initial",),
}  # fmt: skip


@dataclass(frozen=True)
class Rhythm:
    """Of `rounds` successive times that `trigger` comes, and as many more as `parameter` says, `sends` send through `output`."""

    trigger: str
    output: str
    parameter: str
    rounds: int
    sends: int


def way_needs(guard: formula.Formula, kept: Mapping[str, str]) -> Iterator[tuple[bool, list[tuple[str, str, bool]]]]:
    """For each alternative of a guard: whether only parameters that names keep decide, and which, with values that they need or exclude."""
    for alternative in guard.alternatives:
        needs = [_need(item, kept) for item in alternative]
        yield all(needs) and bool(needs), [need for need in needs if need]


def _need(item: formula.Condition, kept: Mapping[str, str]) -> tuple[str, str, bool] | None:
    condition, holds = parse_condition(item.meaning or item.text), item.holds
    while isinstance(condition, Negation):
        condition, holds = condition.inner, not holds
    if isinstance(condition, Operand) and (name := _name(condition.text)) in kept:
        return kept[name], "true", holds
    if isinstance(condition, Comparison) and condition.op == "==" and (name := _name(condition.left)) in kept:
        value = constant(condition.right)
        if value is not None and value[:1] in "\"'":
            return kept[name], value[1:-1], holds
    return None


def _name(text: str) -> str:
    return re.sub(r"^(this->|self\.)", "", strip(text).replace(" ", ""))


def rhythms(document: Document) -> Iterator[Rhythm]:
    """The rhythms of a component's reactions to messages, and of its loops and timers."""
    traits: Mapping[str, Any] = document.get("traits") or {}
    document = with_constants(document)
    values = [str(row.get("value")) for row in document.get("transitions") or ()]
    if not any(stepped(value, sized) for value in values for sized in (False, True)):
        return
    yield from _fixed(document)
    for name, parameter in traits.get("keeps_value_of", ()):
        found = [{(r.trigger, r.output): r for r in _fixed(with_numbers(document, {name: value}))} for value in _TRIED]
        for key, first in found[0].items():
            same = [rhythms_.get(key) for rhythms_ in found]
            more = [rhythm.rounds - value if rhythm else None for rhythm, value in zip(same, _TRIED, strict=True)]
            if None not in more and len(set(more)) == 1 and len({rhythm.sends for rhythm in same if rhythm}) == 1:
                yield Rhythm(first.trigger, first.output, parameter, first.rounds - _TRIED[0], first.sends)


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
        return {**row, **{field: replaced(row.get(field)) for field in fields if field in row}, **ways}

    return {**document, **{key: [changed(row, fields) for row in document.get(key) or ()] for key, fields in _TEXTS.items()}}


def _fixed(document: Document) -> Iterator[Rhythm]:
    document = {**document, "periodic": [row for row in document.get("periodic") or () if row.get("at")]}
    domains = Domains(document, counts=True)
    counted = {cell.subject.key: cell.initial[0] for cell in domains.cells.values() if cell.counting}
    if not counted:
        return
    triggers = component_steps(document, domains)
    traits = document.get("traits") or {}
    doubtful = {name for name, *_ in traits.get("changed_at_once", ())}
    counted = {key: value for key, value in counted.items() if not any(key == name or key.startswith(f"{name}.") for name in doubtful)}
    changed = {(trigger, a.cell.subject.key) for trigger, steps in triggers.items() for step in steps for a in step.assignments}
    for trigger, steps in triggers.items():
        place = _place(trigger, document)
        shared = {key for other, key in changed if other != trigger}
        for output in sorted({port for step in steps for port in step.outputs}) if place else ():
            own = _needed([replace(step, outputs=(output,) if output in step.outputs else ()) for step in steps])
            if not _told_in_order(own, traits.get("several_orders", ())) or not _of_one_timer(own, trigger, place, document):
                continue
            if found := _rounds(own, counted, shared):
                yield Rhythm(place, output, "", *found)


def _place(trigger: str, document: Document) -> str:
    """The port, or the place of the loop or timer, that a trigger is; "" where several are one trigger."""
    if trigger.partition(" ")[0] != PERIODIC:
        return trigger
    places = {str(row["at"]) for row in document["periodic"]}
    return trigger.partition(" ")[2] or (places.pop() if len(places) == 1 else "")


def _told_in_order(steps: list[Step], unclear: list[list[str]]) -> bool:
    places = {place for step in steps for place in step.row.at.split()}
    return not any(places.issuperset(pair) for pair in unclear)


def _of_one_timer(steps: list[Step], trigger: str, place: str, document: Document) -> bool:
    """Whether all that changes in these steps of a timer is changed by it."""
    rows = [document["transitions"][step.row.index] for step in steps if step.row.kind == "transitions"]
    return trigger.partition(" ")[0] != PERIODIC or all(set(row.get("timed_by") or ()) == {place} for row in rows)


def _needed(steps: list[Step]) -> list[Step]:
    """The steps that send, and those that change what these, or such steps, test."""
    needed: set[str] = set()
    while True:
        own = [step for step in steps if step.outputs or any(a.cell.subject.key in needed for a in step.assignments)]
        own = [replace(step, assignments=tuple(a for a in step.assignments if a.cell.subject.key in needed)) for step in own]
        asked = {subject.key for step in own for subject in step.tested()}
        if asked <= needed:
            return own
        needed |= asked


def _rounds(steps: list[Step], counted: Mapping[str, str], shared: set[str]) -> tuple[int, int] | None:
    """After how many rounds the counters are as they were, and how often it was sent meanwhile; None when more than counters decides."""
    keys = sorted({subject.key for step in steps for subject in step.tested()})
    if not keys or not counted.keys() >= set(keys) or shared.intersection(keys) or any(step.sometimes for step in steps):
        return None
    state = tuple(counted[key] for key in keys)
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
