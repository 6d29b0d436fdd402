"""When a condition is tested: before or after assignments of the same reaction to what it is about."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from rosarch.models.machine.conditions import compact
from rosarch.models.machine.logic import BOOLEAN, Formula, Is, Subject, subjects
from rosarch.models.machine.steps import Step

_WORD = re.compile(r"(?<![\w.>:])[A-Za-z_]\w*")


class Leaf(NamedTuple):
    """A condition: its place, its text, whether it holds, and the calls by which a reaction comes to it, where their order counts."""

    place: str
    text: str
    holds: bool
    through: tuple[str, ...] = ()

    @property
    def test(self) -> str:
        """What is one test: one condition that is come to by one chain of calls."""
        return " > ".join((*self.through, self.place))


@dataclass(frozen=True)
class Guard:
    """The conditions that guard a step, by test; `alone` says that all of them have to be so."""

    at: Mapping[str, frozenset[Leaf]]
    alone: bool

    def texts(self, place: str | None = None) -> Iterator[str]:
        """The conditions, of all places or one."""
        return (compact(leaf.text) for at, leaves in self.at.items() if place in (None, at) for leaf in leaves)

    def excludes(self, other: Guard) -> bool:
        """Whether one and the same test leads to one step or to the other."""
        shared = self.at.keys() & other.at.keys() if self.alone and other.alone else ()
        return any(self.at[place].isdisjoint(other.at[place]) for place in shared)


def with_epochs(steps: Sequence[Step], trees: Mapping[Step, Any], unsteady: Collection[str] = (), anew: Collection[str] = ()) -> list[Step]:
    """The steps of a reaction, in order, with the epochs in which their guards test variables; `trees` are those of their guards.

    What is called by an `unsteady` name need not be the same where it is asked again, what a call `anew` gives not even in one condition.
    """
    guards = [guard_of(trees.get(step)) for step in steps]
    again = (_asked_again(steps, guards, unsteady) if unsteady else []) + list(_called_again(guards, anew))
    asking = {text for text in {text for guard in guards for text in guard.texts()} if any(each.search(text) for each in again)}
    found = []
    for number, step in enumerate(steps):
        epochs: dict[tuple[int, str], tuple[int, ...]] = {}
        unclear, mixed = not asking.isdisjoint(guards[number].texts()), set[int]()
        tests = {(part, subject) for part, conjunct in enumerate(step.guard) for subject in subjects(conjunct) if subject.cell}
        for part, subject in tests:
            before = [
                index
                for index, other in enumerate(steps[:number])
                if any(a.cell.subject.key == subject.key for a in other.assignments) and not guards[index].excludes(guards[number])
            ]
            places = _places_of_part(trees.get(step), part, len(step.guard), subject.text) or _places(guards[number], subject.text)
            told = {tuple(index for index in before if place not in guards[index].at) for place in places} if before else set()
            epochs[part, subject.key] = max(told, key=len, default=())
            mixed |= {part} if len(told) > 1 else set()
        tested = tuple(sorted((part, key, epoch) for (part, key), epoch in epochs.items() if epoch and part not in mixed))
        found.append(replace(step, guard=_freed(step, mixed), epochs=tested, unclear=bool(unclear or mixed)))
    return found


def _freed(step: Step, mixed: Collection[int]) -> tuple[Formula, ...]:
    """The guard of a step where conditions that ask for values of different times may hold or not."""

    def either(part: int) -> Formula:
        key = " ".join(("unclear", step.row.kind, str(step.row.index), str(part), *(step.trail or ())))
        return Is(Subject(key, f"{step.row.at} is reached", BOOLEAN, hidden=True), frozenset({BOOLEAN[0]}))

    return tuple(either(part) if part in mixed else formula for part, formula in enumerate(step.guard))


def _places_of_part(tree: object, part: int, parts: int, text: str) -> set[str]:
    """Where the condition at `part` of a guard of so many names a variable; none where the guard is not written as that."""
    written = tree.get("all", (tree,)) if isinstance(tree, Mapping) else ()
    leaves = list(leaves_of(written[part])) if len(written) == parts else []
    name = _named(text)
    return {leaf.test for leaf in leaves if name.search(leaf.text)}


def _asked_again(steps: Sequence[Step], guards: Sequence[Guard], names: Collection[str]) -> list[re.Pattern[str]]:
    """What conditions at several places ask for, of that which has one of the names in it."""
    asked = {s.text for step in steps for conjunct in step.guard for s in subjects(conjunct) if not s.cell}
    sides = {side for text in asked for side in re.split(r"[<>=!]=?", compact(text))}
    places: dict[str, set[str]] = {}
    for guard in guards:
        for place in guard.at:
            for text in guard.texts(place):
                places.setdefault(text, set()).add(place)
    found = []
    for side in sorted(side for side in sides if not set(_WORD.findall(side)).isdisjoint(names)):
        pattern = re.compile(rf"(?<![\w.>]){re.escape(side)}(?!\w)")
        if len({place for text, at in places.items() if pattern.search(text) for place in at}) > 1:
            found.append(pattern)
    return found


def _called_again(guards: Sequence[Guard], calls: Collection[str]) -> Iterator[re.Pattern[str]]:
    """Those of the calls that conditions make several times."""
    leaves = {(place, text) for guard in guards for place in guard.at for text in guard.texts(place)}
    for call in sorted(calls):
        pattern = re.compile(rf"(?<![\w.>]){re.escape(compact(call))}")
        if sum(len(pattern.findall(text)) for _, text in leaves) > 1:
            yield pattern


def _places(guard: Guard, text: str) -> set[str]:
    """Where conditions that name a variable are tested; all places when none of them names it."""
    name = _named(text)
    return {place for place, leaves in guard.at.items() if any(name.search(leaf.text) for leaf in leaves)} or set(guard.at)


def _named(text: str) -> re.Pattern[str]:
    return re.compile(rf"(?<!\w){re.escape(re.split(r'::|[.]', text.removesuffix('.size()').removesuffix('.empty()'))[-1])}(?!\w)")


def guard_of(tree: object) -> Guard:
    """The conditions of the tree of a guard."""
    at: dict[str, frozenset[Leaf]] = {}
    for leaf in leaves_of(tree):
        at[leaf.test] = at.get(leaf.test, frozenset()) | {leaf}
    return Guard(at, not (isinstance(tree, Mapping) and "any" in tree))


def leaves_of(tree: object) -> Iterator[Leaf]:
    """The conditions of a guard."""
    if not isinstance(tree, Mapping):
        return
    if "condition" in tree:
        yield Leaf(str(tree.get("at") or ""), str(tree["condition"]), bool(tree.get("holds")), tuple(tree.get("through", ())))
    for part in (*tree.get("all", ()), *tree.get("any", ())):
        yield from leaves_of(part)
