"""Things of two states that are paired, and what is different of them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher

from rosarch.base.places import Place

MOST_ALIKE = 50
HOW = ("lost", "gained", "renamed", "changed")


@dataclass(frozen=True)
class Detail:
    """An attribute, as it was and as it is; None where there is none."""

    name: str
    old: str | None
    new: str | None


@dataclass(frozen=True)
class Change:
    """A thing, of the kind `subject`, that was gained, lost, renamed or changed in `where`, a component, node or system.

    `details` has the attributes that differ; those of something lost or gained are all there. `old_at` and `new_at` are its places.
    """

    subject: str
    where: str
    how: str
    title: str
    details: tuple[Detail, ...] = ()
    old_at: Place | None = None
    new_at: Place | None = None


@dataclass(frozen=True)
class Item:
    """A thing to be compared: equal `key` makes it the same in both states, equal `likeness` makes a renamed one likely the same."""

    key: Hashable
    name: str
    title: str
    attributes: tuple[tuple[str, str | None], ...] = ()
    at: Place | None = None
    likeness: Hashable = None


Pair = tuple[Item, Item]


def paired(old: Iterable[Item], new: Iterable[Item]) -> tuple[list[Pair], list[Item], list[Item]]:
    """The items that are the same in both states, those only in the old, those only in the new one."""
    pairs: list[Pair] = []
    lost, gained = list(old), list(new)
    for same in (lambda item: (item.key, item.attributes), lambda item: item.key):
        found, lost, gained = _matched(lost, gained, same)
        pairs += found
    found, lost, gained = _alike(lost, gained)
    return pairs + found, lost, gained


def _matched(old: Sequence[Item], new: Sequence[Item], same: Callable[[Item], Hashable]) -> tuple[list[Pair], list[Item], list[Item]]:
    waiting: dict[Hashable, list[Item]] = defaultdict(list)
    for item in reversed(new):
        waiting[same(item)].append(item)
    pairs, lost = [], []
    for item in old:
        partners = waiting[same(item)]
        if partners:
            pairs.append((item, partners.pop()))
        else:
            lost.append(item)
    left = {id(item) for partners in waiting.values() for item in partners}
    return pairs, lost, [item for item in new if id(item) in left]


def _alike(old: list[Item], new: list[Item]) -> tuple[list[Pair], list[Item], list[Item]]:
    """Renamed items; of several that are alike, those with the most similar names. Very many cannot be distinguished."""
    likely: dict[Hashable, tuple[list[int], list[int]]] = defaultdict(lambda: ([], []))
    for side, items in enumerate((old, new)):
        for index, item in enumerate(items):
            if item.likeness is not None:
                likely[item.likeness][side].append(index)
    partners: dict[int, int] = {}
    taken: set[int] = set()
    for before, after in likely.values():
        pairs = [(first, second) for first in before for second in after] if max(len(before), len(after)) <= MOST_ALIKE else []
        for _, index, other in sorted((-SequenceMatcher(None, old[i].name, new[o].name).ratio(), i, o) for i, o in pairs):
            if index not in partners and other not in taken:
                partners[index] = other
                taken.add(other)
    renamed = [(old[index], new[other]) for index, other in sorted(partners.items())]
    return renamed, [o for i, o in enumerate(old) if i not in partners], [n for i, n in enumerate(new) if i not in taken]


def differences(subject: str, where: str, old: Iterable[Item], new: Iterable[Item]) -> Iterator[Change]:
    """What is different of all things of one kind in one place."""
    pairs, lost, gained = paired(old, new)
    for item in lost:
        yield Change(subject, where, "lost", item.title, _only(item, old=True), item.at, None)
    for item in gained:
        yield Change(subject, where, "gained", item.title, _only(item, old=False), None, item.at)
    for first, second in pairs:
        before, after = dict(first.attributes), dict(second.attributes)
        details = [Detail(name, before.get(name), after.get(name)) for name in {**before, **after} if before.get(name) != after.get(name)]
        if first.key != second.key:
            details.insert(0, Detail("name", first.name, second.name))
        if details:
            how = "changed" if first.key == second.key else "renamed"
            yield Change(subject, where, how, second.title if how == "changed" else first.title, tuple(details), first.at, second.at)


def _only(item: Item, *, old: bool) -> tuple[Detail, ...]:
    return tuple(Detail(name, value if old else None, None if old else value) for name, value in item.attributes if value is not None)
