"""What the functions of a program read: relations, indexes and tables, and what Python calls them."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

IndexKey = tuple[str, tuple[int, ...], tuple[tuple[int, Any], ...]]  # relation, key columns, columns with a constant
TableKey = tuple[str, tuple[int, ...]]  # relation, key columns


class RowsNeeded(Exception):
    """A rule cannot ask `relation` for single keys only: all of its rows must be there."""

    def __init__(self, relation: str) -> None:
        super().__init__(relation)
        self.relation = relation


@dataclass(slots=True)
class Storage:
    """Which indexes the functions of a program use."""

    arity: dict[str, int]
    indexes: dict[IndexKey, int] = field(default_factory=dict)  # numbered in the order of their first use
    readers: defaultdict[int, int] = field(default_factory=lambda: defaultdict(int))  # of an index, how many rules
    probed: set[str] = field(default_factory=set)  # relations that are asked for whole rows
    listed: set[IndexKey] = field(default_factory=set)  # those that are iterated; others only say whether a key exists
    demanded: set[str] = field(default_factory=set)  # relations of which only the keys that are asked for are derived
    tables: dict[TableKey, int] = field(default_factory=dict)  # what is asked of them
    ranks: Mapping[str, float] = field(default_factory=dict)  # of relations to begin with, the higher the sooner

    def table(self, key: TableKey) -> int:
        """The number of a table."""
        return self.tables.setdefault(key, len(self.tables))

    def index(self, key: IndexKey) -> int:
        """The number of an index."""
        return self.indexes.setdefault(key, len(self.indexes))


def local(relation: str) -> str:
    """The Python name of a relation inside functions."""
    return f"r_{re.sub('[^A-Za-z0-9_]', '_', relation)}"


def row_of(parts: Sequence[str]) -> str:
    """The expression of a row: the bare value for one column."""
    if len(parts) == 1:
        return parts[0]
    return f"({', '.join(parts)})"
