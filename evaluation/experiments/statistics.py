"""How sure figures are: confidence intervals and tests over components.

Precision, recall and F1 are of all elements of all components together. They are no means of figures per component (a component without
timed loops has no recall for these), so that tests on ranks of such figures, as Wilcoxon's, do not apply. What is drawn at random is which
components there are (bootstrap), or for each which variant made which counts (paired permutation, also called approximate randomisation):
components are independent of each other, their elements are not.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable, Sequence

from rosarch.evaluation.experiments.comparison import Counts

Figure = Callable[[Counts], float]

LEVEL = 0.95
EXACT = 12
"""Components that differ up to which all of their permutations are tried."""


def total(counts: Sequence[Counts]) -> Counts:
    """The sum."""
    return Counts(sum(c.hit for c in counts), sum(c.extra for c in counts), sum(c.missed for c in counts))


def intervals(counts: Sequence[Counts], figures: Sequence[Figure], *, samples: int, seed: int | str) -> list[tuple[float, float] | None]:
    """The 95 % percentile interval of each figure over samples of the components; None with fewer than two components that have elements.

    A sample without any element has no figures.
    """
    if sum(each != Counts() for each in counts) < 2:
        return [None] * len(figures)
    draw = random.Random(seed)
    drawn: list[list[float]] = [[] for _ in figures]
    for _ in range(samples):
        sample = total(draw.choices(counts, k=len(counts)))
        if sample == Counts():
            continue
        for values, figure in zip(drawn, figures, strict=True):
            values.append(figure(sample))
    return [_middle(sorted(values)) if values else None for values in drawn]


def _middle(values: Sequence[float]) -> tuple[float, float]:
    """What lies between both tails, each of half of what is left out."""
    tail = (1 - LEVEL) / 2
    last = len(values) - 1
    return values[round(tail * last)], values[round((1 - tail) * last)]


def p_value(one: Sequence[Counts], other: Sequence[Counts], figure: Figure, *, samples: int, seed: int | str) -> float:
    """How often a difference of a figure at least as large arises when it is chance which of both variants made the counts of a component.

    `one` and `other` are the counts of the same components. Components with equal counts change nothing; of the others all permutations
    are tried when there are few, else `samples` drawn at random, the observed one among them.
    """
    pairs = [(a, b) for a, b in zip(one, other, strict=True) if a != b]
    same = total([a for a, b in zip(one, other, strict=True) if a == b])
    observed = _difference(pairs, same, figure, (False,) * len(pairs))
    if len(pairs) <= EXACT:
        swaps = list(itertools.product((False, True), repeat=len(pairs)))
        return sum(_difference(pairs, same, figure, swap) >= observed - 1e-12 for swap in swaps) / len(swaps)
    draw = random.Random(seed)
    as_large = 1
    for _ in range(samples):
        bits = draw.getrandbits(len(pairs))
        as_large += _difference(pairs, same, figure, [bool(bits >> i & 1) for i in range(len(pairs))]) >= observed - 1e-12
    return as_large / (samples + 1)


def _difference(pairs: Sequence[tuple[Counts, Counts]], same: Counts, figure: Figure, swapped: Sequence[bool]) -> float:
    first = total([same, *(pair[swap] for pair, swap in zip(pairs, swapped, strict=True))])
    second = total([same, *(pair[not swap] for pair, swap in zip(pairs, swapped, strict=True))])
    return abs(figure(first) - figure(second))


def holm(values: Sequence[float]) -> list[float]:
    """P values of tests that are made together, corrected for that (Holm's method)."""
    order = sorted(range(len(values)), key=lambda index: values[index])
    corrected = [0.0] * len(values)
    highest = 0.0
    for rank, index in enumerate(order):
        highest = max(highest, min(1.0, values[index] * (len(values) - rank)))
        corrected[index] = highest
    return corrected
