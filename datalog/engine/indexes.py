"""Indexes over the rows of a relation, built when a rule first asks for one."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from itertools import islice
from operator import itemgetter
from typing import Any

SAMPLE = 100  # rows to look at before an index of unique keys is tried


@dataclass(frozen=True, slots=True)
class Index:
    """What an index over a relation of two or more columns holds.

    `keys`: the columns of the key. `constants`: only rows with these values in these columns. `listed`: a key has its
    rows, reduced to their last column where `keys` and `constants` leave only one; else it is there or not. `readers`: how many
    rules ask for it.
    """

    relation: int  # the slot of the relation
    arity: int
    keys: tuple[int, ...]
    constants: tuple[tuple[int, Any], ...]
    listed: bool
    readers: int = 1

    @property
    def free(self) -> int | None:
        """The only column that is neither key nor constant, if there is one."""
        fixed = {*self.keys, *(column for column, _ in self.constants)}
        left = [column for column in range(self.arity) if column not in fixed]
        return left[0] if len(left) == 1 else None

    def build(self, rows: Collection[Any], growing: bool, column: int = 0, values: Collection[Any] | None = None) -> Any:
        """The index of a relation; `grow` extends one that is still `growing`.

        With `values`, the index of the rows that have one of them in `column`.
        """
        rows = self._chosen(rows if values is None else [row for row in rows if row[column] in values])
        if not self.listed:
            return set(map(itemgetter(*self.keys), rows))
        if not growing:
            found = self._by_key(rows)
            return self._grouped(rows) if found is None else found
        index: dict[Any, Sequence[Any]] = {}
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

    def _append(self, index: dict[Any, Sequence[Any]], rows: Collection[Any]) -> None:
        """Add rows to an index whose keys have a tuple of one row, or a list of several."""
        get = index.get
        for key, value in zip(map(itemgetter(*self.keys), rows), self._values(rows), strict=True):
            found = get(key)
            if found is None:
                index[key] = (value,)
            elif type(found) is list:
                found.append(value)
            else:
                index[key] = [*found, value]

    def _grouped(self, rows: Collection[Any]) -> dict[Any, list[Any]]:
        """The index of rows many of which share a key."""
        index: defaultdict[Any, list[Any]] = defaultdict(list)
        for key, value in zip(map(itemgetter(*self.keys), rows), self._values(rows), strict=True):
            index[key].append(value)
        return index

    def _by_key(self, rows: Collection[Any]) -> dict[Any, tuple[Any, ...]] | None:
        """The index of rows of which few share a key: less memory than lists, and hardly a loop in Python."""
        key = itemgetter(*self.keys)
        sample = list(islice(rows, SAMPLE))
        if len(set(map(key, sample))) < 0.9 * len(sample):
            return None
        found: dict[Any, tuple[Any, ...]] = dict(zip(map(key, rows), zip(self._values(rows)), strict=True))
        if len(found) < 0.8 * len(rows):
            return None
        if len(found) < len(rows):
            others: defaultdict[Any, list[Any]] = defaultdict(list)
            for k, value in zip(map(key, rows), self._values(rows), strict=True):
                if found[k][0] != value:
                    others[k].append(value)
            for k, values in others.items():
                found[k] += tuple(values)
        return found
