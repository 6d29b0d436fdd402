"""Recursion over large relations of pairs, with compressed bitmaps of small numbers in place of rows.

A stratum is passed to this module when its rows have become many (`worthwhile`). Values are numbered, pairs are kept as one
bitmap per value of the first column: a few bytes a row, and the functions of `bulk_rules.py` join a set at a time.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import chain, repeat
from typing import Any, TypeAlias

from pyroaring import BitMap

from rosarch.datalog.engine.plan import BulkRule, Grouping

Group: TypeAlias = Any  # a BitMap, or a tuple of codes: what can be iterated and tested for a code
Groups: TypeAlias = dict[int, Group]
ROWS_PER_KEY = 4  # with fewer, a bitmap for each takes more than the rows


def worthwhile(rows: Collection[tuple[Any, Any]]) -> bool:
    """Whether a relation of many rows is better kept as bitmaps."""
    return len({row[0] for row in rows}) * ROWS_PER_KEY <= len(rows)


class Codes:
    """The numbers that stand for values, handed out as values come."""

    def __init__(self) -> None:
        self.values: list[Any] = []
        self.numbers: dict[Any, int] = {}

    def number(self, value: Any) -> int:
        """The number of a value."""
        found = self.numbers.get(value)
        if found is None:
            found = self.numbers[value] = len(self.values)
            self.values.append(value)
        return found

    def grouped(self, rows: Iterable[tuple[Any, Any]], *, by_second: bool = False) -> defaultdict[int, list[int]]:
        """Pairs of values as codes, by the first of them or by the second."""
        groups: defaultdict[int, list[int]] = defaultdict(list)
        number = self.number
        for a, b in rows:
            if by_second:
                groups[number(b)].append(number(a))
            else:
                groups[number(a)].append(number(b))
        return groups


class Pairs(Collection[tuple[Any, Any]]):
    """The rows of a relation of pairs, kept as bitmaps."""

    def __init__(self, groups: Groups, codes: Codes) -> None:
        self.groups = groups
        self.codes = codes
        self._length = sum(map(len, groups.values()))

    def __len__(self) -> int:
        return self._length

    def __iter__(self) -> Iterator[tuple[Any, Any]]:
        value = self.codes.values.__getitem__
        return chain.from_iterable(zip(repeat(value(key)), map(value, group)) for key, group in self.groups.items())

    def __contains__(self, row: Any) -> bool:
        number = self.codes.numbers.get
        group, code = self.groups.get(number(row[0], -1)), number(row[1])
        return group is not None and code is not None and code in group

    def by_first(self) -> PairsByFirst:
        """The index by the first column."""
        return PairsByFirst(self)

    def sorted_groups(self) -> Iterator[tuple[Any, list[Any]]]:
        """Each value of the first column with those of the second, both in order."""
        value = self.codes.values.__getitem__
        for first, key in sorted((value(key), key) for key in self.groups):
            yield first, sorted(map(value, self.groups[key]))


class PairsByFirst(Mapping[Any, list[Any]]):
    """The index of pairs by their first column, made of their bitmaps."""

    def __init__(self, pairs: Pairs) -> None:
        self.pairs = pairs

    def get(self, key: Any, default: Any = None) -> Any:
        """The values of the second column."""
        group = self.pairs.groups.get(self.pairs.codes.numbers.get(key, -1))
        return default if group is None else list(map(self.pairs.codes.values.__getitem__, group))

    def __getitem__(self, key: Any) -> list[Any]:
        found = self.get(key)
        if found is None:
            raise KeyError(key)
        return found  # type: ignore[no-any-return]

    def __contains__(self, key: object) -> bool:
        return self.pairs.codes.numbers.get(key, -1) in self.pairs.groups

    def __len__(self) -> int:
        return len(self.pairs.groups)

    def __iter__(self) -> Iterator[Any]:
        return map(self.pairs.codes.values.__getitem__, self.pairs.groups)


def merged(groups: Groups, keys: Iterable[int]) -> Group:
    """The union of the groups of some keys."""
    return _union(list(filter(None, map(groups.get, keys))))


def _union(found: list[Group]) -> Group:
    """A new bitmap of the codes of all groups; nothing when there are none."""
    bitmaps = [group for group in found if type(group) is BitMap]
    if len(bitmaps) == len(found):
        return BitMap.union(*found) if found else None
    result = BitMap(chain.from_iterable(group for group in found if type(group) is not BitMap))
    return result.union(*bitmaps) if bitmaps else result


@dataclass(slots=True)
class Growing:
    """A relation of the stratum: its pairs by first and, where a rule asks for them, by second; and what is new."""

    by_first: Groups
    by_second: Groups | None
    delta: Groups = field(default_factory=dict)
    delta_by_second: Groups = field(default_factory=dict)
    rows: int = 0
    forward: defaultdict[int, list[Group]] = field(default_factory=lambda: defaultdict(list))
    backward: defaultdict[int, list[Group]] = field(default_factory=lambda: defaultdict(list))
    single: defaultdict[int, list[int]] = field(default_factory=lambda: defaultdict(list))

    def settle(self) -> None:
        """Take what the rules of a round have derived; what was not there before is the next delta."""
        for second, found in self.backward.items():
            group = _union(found)
            if self.by_second is not None and second in self.by_second:
                group -= self.by_second[second]
            for first in group:
                self.single[first].append(second)
        for first, codes in self.single.items():
            self.forward[first].append(BitMap(codes))
        self.delta = {}
        while self.forward:
            first, found = self.forward.popitem()
            group = _union(found)
            known = self.by_first.get(first)
            if known is None:
                self.by_first[first] = group.copy()
            else:
                group -= known
                known |= group
            if group:
                self.delta[first] = group
                self.rows += len(group)
        self.backward.clear()
        self.single.clear()
        self._turn()

    def _turn(self) -> None:
        """Keep the pairs by their second column up to date."""
        if self.by_second is None:
            return
        turned: defaultdict[int, list[int]] = defaultdict(list)
        for first, group in self.delta.items():
            for second in group:
                turned[second].append(first)
        self.delta_by_second = {second: BitMap(codes) for second, codes in turned.items()}
        for second, group in self.delta_by_second.items():
            known = self.by_second.get(second)
            if known is None:
                self.by_second[second] = group.copy()
            else:
                known |= group


class BulkLoop:
    """The rest of the evaluation of a stratum, from its rows so far and those that were new in the last round."""

    def __init__(
        self, rules: Iterable[BulkRule], functions: Mapping[str, Callable[..., None]], slots: list[Any],
        members: Mapping[str, int], deltas: Mapping[str, Iterable[tuple[Any, Any]]], codes: Codes,
    ) -> None:  # fmt: skip
        self.rules = tuple(rules)
        self.functions = functions
        self.slots = slots
        self.codes = codes
        self.members = members
        wanted = {grouping for rule in self.rules for grouping in rule.groupings}
        turned = {m for m in members if Grouping(members[m], True) in wanted}
        turned |= {rule.delta for rule in self.rules if rule.delta_reversed}
        self.growing: dict[str, Growing] = {}
        for name, slot in members.items():
            self.growing[name] = self._start(slots[slot], deltas[name], name in turned)
            slots[slot] = Pairs({}, codes)
        self.groups: dict[Grouping, Groups | None] = {}
        by_slot = {slot: self.growing[name] for name, slot in members.items()}
        for grouping in wanted:
            if grouping.relation in by_slot:
                found = by_slot[grouping.relation]
                self.groups[grouping] = found.by_second if grouping.reversed else found.by_first
            else:
                self.groups[grouping] = self._static(slots[grouping.relation], grouping.reversed)

    def _start(self, rows: Iterable[tuple[Any, Any]], delta: Iterable[tuple[Any, Any]], turned: bool) -> Growing:
        found = Growing(_bitmaps(self.codes.grouped(rows)), _bitmaps(self.codes.grouped(rows, by_second=True)) if turned else None)
        found.rows = sum(map(len, found.by_first.values()))
        found.delta = _bitmaps(self.codes.grouped(delta))
        if turned:
            found.delta_by_second = _bitmaps(self.codes.grouped(delta, by_second=True))
        return found

    def _static(self, rows: Collection[tuple[Any, Any]], by_second: bool) -> Groups:
        """The pairs of a relation that does not grow."""
        if isinstance(rows, Pairs) and not by_second:
            return rows.groups
        return {key: tuple(codes) for key, codes in self.codes.grouped(rows, by_second=by_second).items()}

    def call(self, rule: BulkRule) -> None:
        """Call the function of one rule on the delta."""
        source, target = self.growing[rule.delta], self.growing[rule.target]
        delta = source.delta_by_second if rule.delta_reversed else source.delta
        groups = (self.groups[grouping] for grouping in rule.groupings)
        self.functions[rule.function](delta, target.forward, target.backward, target.single, *groups)

    def settle(self) -> bool:
        """End a round; whether something was new."""
        for found in self.growing.values():
            found.settle()
        return any(found.delta for found in self.growing.values())

    def finish(self) -> None:
        """Put the relations back into their slots."""
        for name, slot in self.members.items():
            self.slots[slot] = Pairs(self.growing[name].by_first, self.codes)


def _bitmaps(groups: Mapping[int, list[int]]) -> Groups:
    return {key: BitMap(codes) for key, codes in groups.items()}


NAMES: dict[str, Any] = {"merged": merged, "EMPTY": ()}
