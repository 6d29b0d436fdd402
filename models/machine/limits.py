"""Numbers that are only compared with limits: which of the ranges between these limits one is in, or which limit it is."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Sequence

from rosarch.models.machine.conditions import constant, number
from rosarch.models.machine.counting import COMPARE

MOST_LIMITS = 6
NO_NUMBER = "no number"
"""What fractions may be beside: it compares with nothing."""
_FIRST = "< "
_PATH = re.compile(r"\*?(?:self\.|this->)?[A-Za-z_]\w*(?:(?:->|\.)[A-Za-z_]\w*)*")


def is_path(text: str) -> bool:
    """Whether a text names a variable or a field, and is no calculation."""
    return bool(_PATH.fullmatch(text)) and constant(text) is None


def ranges(limits: Iterable[float]) -> tuple[str, ...]:
    """What the ranges around limits, and the limits themselves, are called, from the least on, and what is none of them."""
    known = sorted(set(limits))
    names = [_text(limit) for limit in known]
    found = [f"{_FIRST}{names[0]}", names[0]]
    for before, name in itertools.pairwise(names):
        found += [f"{before} .. {name}", name]
    return (*found, f"> {names[-1]}", NO_NUMBER)


def are_ranges(values: Sequence[str]) -> bool:
    """Whether values are such names."""
    return len(values) > 2 and values[0].startswith(_FIRST)


def range_of(size: float, values: Sequence[str]) -> str:
    """The one of these ranges that a number is in."""
    return next(value for value in values if _has(value, size))


def compares(op: str, value: str, limit: float) -> bool | None:
    """Whether what is in a range compares so with a limit; None where some does and some does not."""
    if value == NO_NUMBER:
        return False
    least, most = _ends(value)
    if least == most:
        return COMPARE[op](least, limit)
    if most <= limit:
        return op in ("<", "<=")
    if least >= limit:
        return op in (">", ">=")
    return None


def is_beyond(value: str, least: float, most: float) -> bool:
    """Whether such a name, or a number, stands for numbers alone that are less than `least` or more than `most`."""
    if value == NO_NUMBER or not (value[:1] in "<>" or " .. " in value or number(value) is not None):
        return False
    low, high = _ends(value)
    return high < least or low > most or (low != high and (high <= least or low >= most))


def _text(limit: float) -> str:
    return str(constant(repr(limit)))


def _ends(value: str) -> tuple[float, float]:
    if (size := number(value)) is not None:
        return size, size
    if value.startswith(_FIRST):
        return float("-inf"), float(value[len(_FIRST) :])
    if value.startswith("> "):
        return float(value[2:]), float("inf")
    least, _, most = value.partition(" .. ")
    return float(least), float(most)


def _has(value: str, size: float) -> bool:
    if value == NO_NUMBER:
        return False
    least, most = _ends(value)
    return least == size == most or least < size < most
