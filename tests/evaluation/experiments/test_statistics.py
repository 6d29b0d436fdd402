"""Intervals and tests: against what they are by hand and by brute force."""

from __future__ import annotations

import itertools
import random

import pytest

from rosarch.evaluation.experiments.comparison import Counts
from rosarch.evaluation.experiments.statistics import EXACT, holm, intervals, p_value, total


def f1(counts: Counts) -> float:
    return counts.f1


def test_counts() -> None:
    counts = total([Counts(3, 1, 0), Counts(1, 0, 3)])
    assert (counts.precision, counts.recall, counts.f1) == (4 / 5, 4 / 7, 8 / 12)
    assert (Counts().precision, Counts().recall, Counts().f1) == (0, 0, 0)


def test_intervals_hold_the_figure_and_narrow_with_more_components() -> None:
    counts = [Counts(hit, 1, 10 - hit) for hit in (2, 4, 6, 8)]
    (few,) = intervals(counts, [f1], samples=2000, seed=1)
    (many,) = intervals(counts * 8, [f1], samples=2000, seed=1)
    assert few and many and few[0] < many[0] < total(counts).f1 < many[1] < few[1]
    assert intervals(counts, [f1], samples=500, seed=7) == intervals(counts, [f1], samples=500, seed=7)
    assert intervals(counts[:1], [f1], samples=500, seed=7) == [None]
    assert intervals([Counts(5, 0, 0), Counts()], [f1], samples=500, seed=7) == [None]
    assert intervals([Counts(5, 0, 0), Counts(4, 0, 0), Counts(), Counts()], [f1], samples=500, seed=7) == [(1.0, 1.0)]
    assert intervals([Counts(5, 0, 0)] * 3, [f1], samples=500, seed=7) == [(1.0, 1.0)]


def test_the_interval_of_two_components() -> None:
    """Of two components, one right and one wrong, a sample has both right or both wrong in a quarter of cases each."""
    assert intervals([Counts(1, 0, 0), Counts(0, 0, 1)], [f1], samples=4000, seed=3) == [(0.0, 1.0)]


def test_p_of_few_components_is_exact() -> None:
    """One variant wins on each of n components by the same: of 2^n assignments two are as extreme."""
    for number in (1, 3, 5):
        one, other = [Counts(5, 5, 5)] * number, [Counts(9, 1, 1)] * number
        assert p_value(one, other, f1, samples=100, seed=1) == 2 / 2**number
    same = [Counts(3, 1, 2), Counts(1, 2, 0)]
    assert p_value(same, same, f1, samples=100, seed=1) == 1.0


def test_p_of_many_components_is_near_the_exact_one() -> None:
    draw = random.Random(5)
    one = [Counts(draw.randint(2, 9), draw.randint(0, 4), draw.randint(0, 4)) for _ in range(EXACT + 2)]
    other = [Counts(c.hit, c.extra + draw.choice((0, 0, 1, 3)) + 1, max(0, c.missed - 1)) for c in one]
    differences = []
    for swaps in itertools.product((False, True), repeat=len(one)):
        sides = [(b, a) if swap else (a, b) for swap, a, b in zip(swaps, one, other, strict=True)]
        differences.append(abs(total([a for a, _ in sides]).f1 - total([b for _, b in sides]).f1))
    exact = sum(d >= differences[0] - 1e-12 for d in differences) / len(differences)
    assert p_value(one, other, f1, samples=20_000, seed=1) == pytest.approx(exact, abs=0.01)
    assert p_value(one, other, f1, samples=300, seed="a") == p_value(one, other, f1, samples=300, seed="a")


def test_holm() -> None:
    assert holm([0.01, 0.04, 0.03]) == pytest.approx([0.03, 0.06, 0.06])
    assert holm([0.5, 0.9]) == [1.0, 1.0]
    assert holm([]) == []
