"""What generated code calls: arithmetic with souffle's semantics, string functions, ordering.

Numbers are 32-bit two's complement with wrap-around, unsigned numbers 32-bit, floats single precision, as in a
default build of souffle. Division truncates towards zero.
"""

from __future__ import annotations

import math
import re
import struct
from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Iterator
from functools import lru_cache
from typing import Any

HALF = 0x80000000
MASK = 0xFFFFFFFF
_FLOAT = struct.Struct("f")
_INFINITY = math.inf


class EvaluationError(Exception):
    """A functor applied to a value it has no result for."""


def wrap(value: int) -> int:
    """The value as a signed 32-bit number."""
    return (value + HALF & MASK) - HALF


def single(value: float) -> float:
    """The nearest single-precision float."""
    try:
        return float(_FLOAT.unpack(_FLOAT.pack(value))[0])
    except OverflowError:
        return math.copysign(_INFINITY, value)


def quotient(a: int, b: int) -> int:
    """Integer division that truncates towards zero."""
    if b == 0:
        raise EvaluationError("division by zero")
    q = abs(a) // abs(b)
    return q if (a < 0) == (b < 0) else -q


def divide_number(a: int, b: int) -> int:
    """Number division."""
    return wrap(quotient(a, b))


def modulo_number(a: int, b: int) -> int:
    """The remainder, with the sign of the dividend."""
    return a - b * quotient(a, b)


def divide_float(a: float, b: float) -> float:
    """Float division; by zero it gives infinity or NaN."""
    if b == 0:
        return math.nan if a == 0 or math.isnan(a) else math.copysign(_INFINITY, a) * math.copysign(1.0, b)
    return single(a / b)


def power_number(a: int, b: int) -> int:
    """`a ^ b` by way of a double; out of range it is the least number, as x86 converts it."""
    if b < 0:
        return 1 if a == 1 or (a == -1 and b % 2 == 0) else -1 if a == -1 else -HALF if a == 0 else 0
    result = pow(a, b) if b < 64 or a in (-1, 0, 1) else HALF
    return result if -HALF <= result < HALF else -HALF


def power_unsigned(a: int, b: int) -> int:
    """`a ^ b` by way of a double, reduced to 32 bits."""
    result = pow(a, b) if b < 64 or a < 2 else 1 << 63
    return int(float(result)) & MASK if result < 1 << 63 else 0


def power_float(a: float, b: float) -> float:
    """`a ^ b` of floats."""
    try:
        result = a**b
    except OverflowError:
        return _INFINITY
    except ZeroDivisionError:
        return _INFINITY
    return math.nan if isinstance(result, complex) else single(result)


def shift_left(a: int, b: int) -> int:
    """`bshl`; the distance counts modulo 32."""
    return wrap(a << (b & 31))


def shift_right(a: int, b: int) -> int:
    """`bshr`, which keeps the sign."""
    return a >> (b & 31)


def shift_right_unsigned(a: int, b: int) -> int:
    """`bshru`, which shifts in zeros."""
    return wrap((a & MASK) >> (b & 31))


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


_NUMBER = re.compile(r"[ \t\n\r\v\f]*[+-]?[0-9]+")


def _integer(text: str) -> int:
    try:
        if text[:2].lower() in ("0x", "0b"):
            return int(text, 0)
        return int(text)
    except ValueError:
        raise EvaluationError(f"`{text}` is not a number") from None


def number_of_symbol(text: str) -> int:
    """`to_number` of a symbol."""
    value = _integer(text)
    if not -HALF <= value < HALF:
        raise EvaluationError(f"`{text}` is out of range for a number")
    return value


def unsigned_of_symbol(text: str) -> int:
    """`to_unsigned` of a symbol."""
    value = _integer(text)
    if not 0 <= value <= MASK:
        raise EvaluationError(f"`{text}` is out of range for an unsigned number")
    return value


def float_of_symbol(text: str) -> float:
    """`to_float` of a symbol."""
    try:
        return single(float(text))
    except ValueError:
        raise EvaluationError(f"`{text}` is not a float") from None


def truncate(value: float) -> int:
    """The integer part of a finite float."""
    if math.isnan(value) or math.isinf(value):
        raise EvaluationError(f"{value} has no integer value")
    return int(value)


def number_of_float(value: float) -> int:
    """`to_number` of a float."""
    return wrap(truncate(value))


def unsigned_of_float(value: float) -> int:
    """`to_unsigned` of a float."""
    return truncate(value) & MASK


def symbol_of_float(value: float) -> str:
    """`to_string` of a float: six decimals."""
    return f"{value:f}"


_POSIX_CLASSES = {
    "alnum": "a-zA-Z0-9", "alpha": "a-zA-Z", "blank": r" \t", "digit": "0-9", "lower": "a-z", "space": r"\s",
    "upper": "A-Z", "xdigit": "0-9a-fA-F", "punct": r"!-/:-@\[-`{-~", "w": r"\w", "d": r"\d", "s": r"\s",
}  # fmt: skip
_BARE_BRACE = re.compile(r"(?<!\\)(?:\\\\)*\{(?!\d+(?:,\d*)?\})")


@lru_cache(maxsize=4096)
def full_match(pattern: str) -> Callable[[str], Any] | None:
    """The matcher of an ECMAScript regular expression, or None when it is not valid."""
    translated = re.sub(r"\[:(\w+):\]", lambda m: _POSIX_CLASSES.get(m[1], m[0]), pattern)
    if _BARE_BRACE.search(translated):
        return None
    try:
        return re.compile(translated, re.DOTALL | re.ASCII).fullmatch
    except re.error:
        return None


def matches(pattern: str, text: str) -> bool:
    """`match`: whether the whole text matches; never for a pattern that is not valid."""
    found = full_match(pattern)
    return found is not None and found(text) is not None


def differs(pattern: str, text: str) -> bool:
    """`!match`: whether the text does not match; never for a pattern that is not valid."""
    found = full_match(pattern)
    return found is not None and found(text) is None


def number_range(start: int, stop: int, step: int | None = None) -> Iterable[int]:
    """`range(start, stop[, step])`; without a step it counts towards `stop`."""
    if step is None:
        step = 1 if start <= stop else -1
    return _floats(start, stop, step) if step == 0 else range(start, stop, step)  # type: ignore[return-value]


def float_range(start: float, stop: float, step: float | None = None) -> Iterator[float]:
    """`range` over floats."""
    return _floats(start, stop, (1.0 if start <= stop else -1.0) if step is None else step)


def _floats(start: float, stop: float, step: float) -> Iterator[float]:
    if step == 0:
        if start != stop:
            yield start
        return
    value = start
    while value < stop if step > 0 else value > stop:
        yield value
        value = single(value + step)


def order_key(value: Any) -> Any:
    """A key that orders values of every kind: nil, then plain values, then records field by field."""
    if value is None:
        return (0,)
    if isinstance(value, tuple):
        return (2, tuple(order_key(v) for v in value))
    return (1, value)


def ordered(rows: Collection[Any]) -> list[Any]:
    """The rows sorted; falls back to `order_key` where Python cannot compare (nil against a record)."""
    try:
        return sorted(rows)
    except TypeError:
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
    """What one evaluation carries besides rows: counters that functors advance."""

    __slots__ = ("counter", "iteration", "ordinals")

    def __init__(self) -> None:
        self.counter = 0
        self.iteration = 0
        self.ordinals = Ordinals()

    def next_counter(self) -> int:
        """The next value of `autoinc()`."""
        value = self.counter
        self.counter += 1
        return value


NAMES: dict[str, Any] = {
    "defaultdict": defaultdict, "EMPTY": (), "ONCE": (0,), "fsum": math.fsum,
    **{f.__name__: f for f in (
        wrap, single, divide_number, modulo_number, divide_float, power_number, power_unsigned, power_float, quotient,
        shift_left, shift_right, shift_right_unsigned, substring, string_length, number_of_symbol, unsigned_of_symbol,
        float_of_symbol, number_of_float, unsigned_of_float, symbol_of_float, full_match, matches, differs, number_range, float_range,
        ordered,
    )},
}  # fmt: skip
