"""Indexes over the rows of a relation, built when a rule first asks for one."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from itertools import islice
from operator import itemgetter
from typing import Any

SAMPLE = 100  # rows to look at before an index of unique keys is tried


@dataclass(frozen=True, slots=True)
class Index:
    """What an index over a relation of two or more columns holds.

    `keys`: the columns of the key. `constants`: only rows with these values in these columns. `listed`: a key has its
    rows, reduced to their last column where `keys` and `constants` leave only one; else it is there or not.
    """

    relation: int  # the slot of the relation
    arity: int
    keys: tuple[int, ...]
    constants: tuple[tuple[int, Any], ...]
    listed: bool

    @property
    def free(self) -> int | None:
        """The only column that is neither key nor constant, if there is one."""
        fixed = {*self.keys, *(column for column, _ in self.constants)}
        left = [column for column in range(self.arity) if column not in fixed]
        return left[0] if len(left) == 1 else None

    def build(self, rows: Collection[Any], growing: bool) -> Any:
        """The index of a relation; one that is still `growing` is a mapping to lists, which `grow` extends."""
        rows = self._chosen(rows)
        if not self.listed:
            return set(map(itemgetter(*self.keys), rows))
        if not growing:
            found = self._unique(rows)
            if found is not None:
                return found
        index: defaultdict[Any, list[Any]] = defaultdict(list)
        self._append(index, rows)
        return index

    def grow(self, index: Any, rows: Collection[Any]) -> None:
        """Add rows to an index that was built as growing."""
        rows = self._chosen(rows)
        if self.listed:
            self._append(index, rows)
        else:
            index.update(map(itemgetter(*self.keys), rows))

    def _chosen(self, rows: Collection[Any]) -> Collection[Any]:
        for column, value in self.constants:
            rows = [row for row in rows if row[column] == value]
        return rows

    def _values(self, rows: Collection[Any]) -> Iterable[Any]:
        free = self.free
        return rows if free is None else map(itemgetter(free), rows)

    def _append(self, index: defaultdict[Any, list[Any]], rows: Collection[Any]) -> None:
        for key, value in zip(map(itemgetter(*self.keys), rows), self._values(rows), strict=True):
            index[key].append(value)

    def _unique(self, rows: Collection[Any]) -> dict[Any, tuple[Any]] | None:
        """The index of rows with different keys: less memory than lists, and built without a loop in Python."""
        key = itemgetter(*self.keys)
        sample = list(islice(rows, SAMPLE))
        if len(set(map(key, sample))) != len(sample):
            return None
        found = dict(zip(map(key, rows), zip(self._values(rows)), strict=True))
        return found if len(found) == len(rows) else None
