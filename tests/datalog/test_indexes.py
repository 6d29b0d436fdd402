"""Indexes hold exactly the rows of each key."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rosarch.datalog.engine.indexes import Index

UNHURRIED = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
VALUES = st.integers(0, 5)
ROWS = st.sets(st.tuples(st.one_of(VALUES, st.integers()), VALUES, VALUES), max_size=40)
SHAPES = st.sampled_from(
    [((0,), ()), ((1,), ()), ((0, 1), ()), ((0,), ((1, 2),)), ((2,), ((1, 0),)), ((2, 0), ()), ((0,), ((1, 1), (2, 3)))]
)


def expected(rows: set[tuple[int, ...]], index: Index) -> dict[Any, list[Any]]:
    found: dict[Any, list[Any]] = defaultdict(list)
    for row in rows:
        if all(row[column] == value for column, value in index.constants):
            key = tuple(row[column] for column in index.keys)
            left = [column for column in range(3) if column not in index.keys and column not in dict(index.constants)]
            found[key if len(key) > 1 else key[0]].append(row[left[0]] if len(left) == 1 else row)
    return {key: sorted(values) for key, values in found.items()}


@UNHURRIED
@given(rows=ROWS, later=ROWS, shape=SHAPES, growing=st.booleans())
def test_lists(rows: set[tuple[int, ...]], later: set[tuple[int, ...]], shape: Any, growing: bool) -> None:
    index = Index(0, 3, shape[0], shape[1], True)
    built = index.build(rows, growing)
    if growing:
        index.grow(built, later - rows)
        rows = rows | later
    assert {key: sorted(values) for key, values in built.items()} == expected(rows, index)


@UNHURRIED
@given(rows=ROWS, later=ROWS, shape=SHAPES)
def test_sets(rows: set[tuple[int, ...]], later: set[tuple[int, ...]], shape: Any) -> None:
    index = Index(0, 3, shape[0], shape[1], False)
    built = index.build(rows, True)
    index.grow(built, later)
    assert built == set(expected(rows | later, index))


@UNHURRIED
@given(rows=ROWS, shape=SHAPES, values=st.sets(VALUES))
def test_parts(rows: set[tuple[int, ...]], shape: Any, values: set[int]) -> None:
    index = Index(0, 3, shape[0], shape[1], True)
    built = index.build(rows, False, 2, values)
    assert {key: sorted(v) for key, v in built.items()} == expected({row for row in rows if row[2] in values}, index)
