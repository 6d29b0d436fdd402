"""Reactions in parts that run one by one: several callbacks of a port, and what a callback continues with after it gave way."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from rosarch.base.logic import TRUE
from rosarch.models.machine.cells import Cell, Document
from rosarch.models.machine.epochs import leaves_of
from rosarch.models.machine.logic import BOOLEAN, Formula, Is, Subject
from rosarch.models.machine.meaning import Assignment
from rosarch.models.machine.steps import Row, Step
from rosarch.models.machine.switching import OFF, ON

_AFTER = " after "


def continuation(trigger: str) -> tuple[str, str] | None:
    """The port and the place of which a trigger is what comes after: what was awaited there has come."""
    port, after, place = trigger.partition(_AFTER)
    return (port, place) if after else None


def short(place: str) -> str:
    """A place without the folder of its file."""
    return place.rpartition("/")[2]


def by_callback(steps: Sequence[Step], trigger: str, document: Document) -> list[Step]:
    """The steps of a port; those of one of its callbacks hang on which of them runs."""
    callbacks: dict[str, set[str]] = {}
    for port, callback, place in _traits(document, "in_callback"):
        if port == trigger:
            callbacks.setdefault(place, set()).add(callback)
    values = tuple(sorted(set().union(*callbacks.values())))
    if not values:
        return list(steps)
    called = Subject(f"callback of {trigger}", "the callback", tuple(map(short, values)))

    def own(step: Step) -> Step:
        told = frozenset().union(*(callbacks.get(place, ()) for place in step.row.at.split()))
        return replace(step, guard=(*step.guard, Is(called, frozenset(map(short, told))))) if told else step

    return [own(step) for step in steps]


@dataclass(frozen=True)
class _Ways:
    """What is done, or tested, at once, and what after something was awaited, by the place of that."""

    at_once: frozenset[str]
    after: Mapping[str, frozenset[str]]

    def is_in(self, place: str, wait: str) -> bool:
        """Whether what is at a place may belong to the part after `wait`, or to the first one, which has no wait."""
        return place in self.after[wait] if wait else place in self.at_once or not any(place in own for own in self.after.values())

    def parts(self, step: Step, waits: Collection[str]) -> list[str]:
        """The parts that a step may be taken in."""
        return [wait for wait in ("", *waits) if any(self.is_in(place, wait) for place in step.row.at.split())]


def apart(found: Mapping[str, Sequence[Step]], trees: dict[Step, Any], document: Document) -> dict[str, list[Step]]:
    """The steps of each trigger, where what comes after something was awaited has a trigger of its own.

    What may come in several parts need not come in each. `trees` are those of the guards; steps that are made here get theirs.
    """
    after: dict[str, set[str]] = {}
    for place, wait in _traits(document, "continues_with"):
        after.setdefault(wait, set()).add(place)
    ways = _Ways(frozenset(place for (place,) in _traits(document, "done_at_once")), {w: frozenset(own) for w, own in after.items()})
    waits: dict[str, list[str]] = {}
    for port, wait in _traits(document, "gives_way"):
        if wait in ways.after:
            waits.setdefault(port, []).append(wait)
    result: dict[str, list[Step]] = {}
    for trigger, steps in found.items():
        for step in steps:
            parts = ways.parts(step, waits.get(trigger, ()))
            for wait in parts:
                own = step if not waits.get(trigger) else _in_part(step, wait, trees, ways, certain=len(parts) == 1)
                result.setdefault(f"{trigger}{_AFTER}{wait}" if wait else trigger, []).append(own)
    return result


def _in_part(step: Step, wait: str, trees: dict[Step, Any], ways: _Ways, *, certain: bool) -> Step:
    """A step as it is taken in one part: it hangs on what is tested there, and what was tested before has been so."""
    kept, tree = _tested_within(step, trees.get(step), lambda place: ways.is_in(place, wait))
    known = certain and kept is not None
    key = " ".join(("reached", step.row.kind, str(step.row.index), wait, *(step.trail or ())))
    reached = Subject(key, f"{step.row.at} is reached", BOOLEAN, hidden=True)
    guard: tuple[Formula, ...] = (kept or ()) if known else (*(kept or ()), Is(reached, frozenset({BOOLEAN[0]})))
    own = replace(step, guard=guard)
    trees[own] = tree
    return own


def _tested_within(step: Step, tree: object, is_within: Any) -> tuple[tuple[Formula, ...] | None, Any]:
    """The conditions of a guard that are tested in a part, with their tree; None where conditions of several parts are mixed."""
    if not step.guard:
        return (), None
    written = tree.get("all", (tree,)) if isinstance(tree, Mapping) else ()
    if len(written) != len(step.guard):
        return None, None
    told = [{is_within(leaf.place) for leaf in leaves_of(part)} for part in written]
    if any(len(each) != 1 for each in told):
        return None, None
    kept = [(formula, part) for formula, part, each in zip(step.guard, written, told, strict=True) if True in each]
    return tuple(formula for formula, _ in kept), {"all": [part for _, part in kept]}


def in_turn(steps: Mapping[str, Sequence[Step]]) -> tuple[dict[str, tuple[Step, ...]], list[Cell]]:
    """The steps, where nothing continues that has not given way before, with the cells that say so."""
    found = {trigger: tuple(own) for trigger, own in steps.items()}
    cells = []
    for trigger in steps:
        if not (part := continuation(trigger)):
            continue
        port, place = part
        subject = Subject(trigger, f"what is awaited at {short(place)}", (ON, OFF), cell=True)
        cell = Cell(subject, trigger, "", "", (OFF,), place)
        cells.append(cell)
        for other in (own for own in steps if own == port or (continuation(own) or ("",))[0] == port):
            found[other] = (*found[other], _perhaps(cell, ON, f"{port} gives way at {short(place)}"))
        waits = Is(subject, frozenset({ON}))
        last = _perhaps(cell, OFF, f"nothing else waits at {short(place)}")
        found[trigger] = (*(replace(step, guard=(*step.guard, waits)) for step in found[trigger]), last)
    return found, cells


def _perhaps(cell: Cell, value: str, text: str) -> Step:
    so = Is(Subject(f"{cell.variable} {value}", text, BOOLEAN, hidden=True), frozenset({BOOLEAN[0]}))
    return Step(Row("awaited", 0, cell.at), (so,), (Assignment(cell, ((TRUE, value),)),))


def _traits(document: Document, name: str) -> Iterator[tuple[str, ...]]:
    return (tuple(map(str, row)) for row in (document.get("traits") or {}).get(name, ()))
