"""What generated code calls in addition to arithmetic (see `domain`): string functors, ordering, counters."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Collection, Iterable
from typing import TYPE_CHECKING, Any

from rosarch.datalog.engine.records import Records
from rosarch.datalog.engine.regular import full_match
from rosarch.datalog.language.domain import EvaluationError, domain

if TYPE_CHECKING:
    from rosarch.datalog.engine.bulk import Codes


def substring(text: str, start: int, length: int) -> str:
    """Characters `start` to `start + length`, counted in UTF-8 bytes as souffle counts them.

    A negative length reaches to the end; a start outside the text gives the empty symbol.
    """
    if text.isascii():
        if not 0 <= start <= len(text):
            return ""
        return text[start:] if length < 0 else text[start : start + length]
    data = text.encode("utf-8", "surrogateescape")
    if not 0 <= start <= len(data):
        return ""
    part = data[start:] if length < 0 else data[start : start + length]
    return part.decode("utf-8", "surrogateescape")


def string_length(text: str) -> int:
    """The length in UTF-8 bytes, as souffle counts."""
    return len(text) if text.isascii() else len(text.encode("utf-8", "surrogateescape"))


def symbol_of_float(value: float) -> str:
    """`to_string` of a float: six decimals."""
    return f"{value:f}"


def matches(pattern: str, text: str) -> bool:
    """`match`: whether the whole text matches; never for a pattern that is not valid."""
    found = full_match(pattern)
    return found is not None and found(text) is not None


def differs(pattern: str, text: str) -> bool:
    """`!match`: whether the text does not match; never for a pattern that is not valid."""
    found = full_match(pattern)
    return found is not None and found(text) is None


def order_key(value: Any) -> tuple[Any, ...]:
    """A key that orders values of every kind: nil, then plain values, then records field by field, however deep."""
    tokens: list[tuple[Any, ...]] = []
    work = [value]
    while work:
        item = work.pop()
        if item is None:
            tokens.append((0,))
        elif isinstance(item, tuple):
            tokens.append((2, len(item)))
            work.extend(reversed(item))
        else:
            tokens.append((1, item))
    return tuple(tokens)


def ordered(rows: Collection[Any]) -> list[Any]:
    """The rows sorted; falls back to `order_key` where Python cannot compare: nil against a record, or records too deep."""
    try:
        return sorted(rows)
    except (TypeError, RecursionError):
        return sorted(rows, key=order_key)


class Ordinals:
    """`ord`: a number per value, handed out in the order of first use within one evaluation."""

    def __init__(self) -> None:
        self._numbers: dict[Any, int] = {}

    def number(self, value: Any) -> int:
        """The ordinal of a value."""
        return self._numbers.setdefault(value, len(self._numbers))

    def preload(self, values: Iterable[Any]) -> None:
        """Number these values first."""
        for value in values:
            self._numbers.setdefault(value, len(self._numbers))


class State:
    """What one evaluation carries in addition to rows: counters that functors advance, records, codes of values in bitmaps."""

    __slots__ = ("codes", "counter", "iteration", "ordinals", "records")

    def __init__(self) -> None:
        self.counter = 0
        self.iteration = 0
        self.ordinals = Ordinals()
        self.records = Records()
        self.codes: Codes | None = None

    def next_counter(self) -> int:
        """The next value of `autoinc()`."""
        value = self.counter
        self.counter += 1
        return value


def names(bits: int) -> dict[str, Any]:
    """What generated code may call, for a number domain of 32 or 64 bits."""
    own = (substring, string_length, symbol_of_float, full_match, matches, differs, ordered)
    constants = {"defaultdict": defaultdict, "EMPTY": (), "ONCE": (0,), "fsum": math.fsum}
    return {**constants, **domain(bits).functions(), **{f.__name__: f for f in own}}


NAMES = names(32)

__all__ = ["NAMES", "EvaluationError", "Ordinals", "State", "differs", "full_match", "matches", "names", "order_key", "ordered"]
