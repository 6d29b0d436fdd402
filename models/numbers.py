"""Numbers as the rules leave them: literals, or bracketed numbers joined by `*`, `/`, `>` (the greater of the two) and `<` (the lesser)."""

from __future__ import annotations

import re

_INTEGER = re.compile(r"-?[0-9]+")
_OPERATORS = frozenset({"*", "/", "<", ">"})


def calculated(text: str) -> float | None:
    """The value of `text`, with C++'s division of integers; None when it is no number."""
    try:
        return float(text)
    except ValueError:
        pass
    left, operator, right = _split(text)
    first, second = (calculated(left), calculated(right)) if operator in _OPERATORS else (None, None)
    if first is None or second is None:
        return None
    if operator == "*":
        return first * second
    if operator in ("<", ">"):
        return min(first, second) if operator == "<" else max(first, second)
    if second == 0:
        return None
    whole = _INTEGER.fullmatch(left) and _INTEGER.fullmatch(right)
    return float(int(first / second)) if whole else first / second


def _split(text: str) -> tuple[str, str, str]:
    """The parts of `(left)operator(right)`; empty when it is something else."""
    depth = 0
    for index, char in enumerate(text):
        depth += {"(": 1, ")": -1}.get(char, 0)
        if depth == 0:
            return text[1:index], text[index + 1 : index + 2], text[index + 3 : -1]
    return "", "", ""


def frequency(amount: str, per_second: int) -> float | None:
    """How often in a second something runs with a period of `amount` units; None when that is not known.

    `per_second` units are a second; when it is 0, `amount` itself is how often.
    """
    value = calculated(amount)
    if value is None:
        return None
    if per_second == 0:
        return value
    return per_second / value if value else None
