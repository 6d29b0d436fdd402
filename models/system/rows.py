"""Rows of relations, of several origins."""

from __future__ import annotations

import marshal
from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping
from typing import Any

from rosarch.extractor.cache import hash_of

Rows = Mapping[str, Collection[tuple[Any, ...]]]


def merged(parts: Iterable[Rows]) -> dict[str, set[tuple[Any, ...]]]:
    """The union of rows, relation by relation."""
    rows: dict[str, set[tuple[Any, ...]]] = defaultdict(set)
    for part in parts:
        for relation, found in part.items():
            rows[relation].update(found)
    return rows


def rows_digest(rows: Rows) -> str:
    """A hash of rows."""
    return hash_of([marshal.dumps([(name, sorted(found)) for name, found in sorted(rows.items())], 2)])
