"""Rows of relations, of several origins."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping
from typing import Any

Rows = Mapping[str, Collection[tuple[Any, ...]]]


def merged(parts: Iterable[Rows]) -> dict[str, set[tuple[Any, ...]]]:
    """The union of rows, relation by relation."""
    rows: dict[str, set[tuple[Any, ...]]] = defaultdict(set)
    for part in parts:
        for relation, found in part.items():
            rows[relation].update(found)
    return rows


def grouped(rows: Iterable[tuple[Any, ...]]) -> dict[Any, list[tuple[Any, ...]]]:
    """The rest of each row by its first column, sorted."""
    found: dict[Any, list[tuple[Any, ...]]] = defaultdict(list)
    for first, *rest in sorted(rows, key=lambda row: row[1:]):
        found[first].append(tuple(rest))
    return found
