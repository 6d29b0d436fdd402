"""Arithmetic in a number domain: 32 bits, as a default build of souffle has it, or 64.

Numbers are two's complement with wrap-around, unsigned numbers wrap around as well, floats have single or double precision.
Division truncates towards zero.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from typing import Any

_SINGLE = struct.Struct("f")


class EvaluationError(Exception):
    """A functor applied to a value it has no result for."""


def single(value: float) -> float:
    """The nearest single-precision float."""
    try:
        return float(_SINGLE.unpack(_SINGLE.pack(value))[0])
    except OverflowError:
        return math.copysign(math.inf, value)


def quotient(a: int, b: int) -> int:
    """Integer division that truncates towards zero."""
    if b == 0:
        raise EvaluationError("division by zero")
    q = abs(a) // abs(b)
    return q if (a < 0) == (b < 0) else -q


def modulo_number(a: int, b: int) -> int:
    """The remainder, with the sign of the dividend."""
    return a - b * quotient(a, b)


class Domain:
    """The functions of one width, named as generated code calls them."""

    def __init__(self, bits: int) -> None:
        self.bits = bits
        self.half = 1 << (bits - 1)
        self.mask = (1 << bits) - 1
        self.single: Callable[[float], float] = single if bits == 32 else float
        self.digits = 9 if bits == 32 else 17  # that identify a float

    def functions(self) -> dict[str, Callable[..., Any]]:
        """The functions of this domain by name."""
        named = {name: getattr(self, name) for name in dir(type(self)) if name[0] != "_" and name not in ("functions", "show_float")}
        return {**named, "single": self.single, "quotient": quotient, "modulo_number": modulo_number}

    def wrap(self, value: int) -> int:
        """The value as a signed number."""
        return (value + self.half & self.mask) - self.half

    def wrap_unsigned(self, value: int) -> int:
        """The value as an unsigned number."""
        return value & self.mask

    def divide_number(self, a: int, b: int) -> int:
        """Number division."""
        return self.wrap(quotient(a, b))

    def divide_float(self, a: float, b: float) -> float:
        """Float division; by zero it gives infinity or NaN."""
        if b == 0:
            return math.nan if a == 0 or math.isnan(a) else math.copysign(math.inf, a) * math.copysign(1.0, b)
        return self.single(a / b)

    def power_number(self, a: int, b: int) -> int:
        """`a ^ b` by way of a double; out of range it is the least number, as x86 converts it."""
        if b < 0:
            return 1 if a == 1 or (a == -1 and b % 2 == 0) else -1 if a == -1 else -self.half if a == 0 else 0
        result = pow(a, b) if b < 64 or a in (-1, 0, 1) else self.half
        if abs(result) > 1 << 53:
            result = int(float(result)) if abs(result) < 1 << 70 else self.half
        return result if -self.half <= result < self.half else -self.half

    def power_unsigned(self, a: int, b: int) -> int:
        """`a ^ b` by way of a double, reduced to the domain; nothing is left of what does not fit into 64 bits."""
        result = pow(a, b) if b < 64 or a < 2 else 1 << 64
        limit = 1 << (63 if self.bits == 32 else 64)
        return int(float(result)) & self.mask if result < limit else 0

    def power_float(self, a: float, b: float) -> float:
        """`a ^ b` of floats."""
        try:
            result = a**b
        except (OverflowError, ZeroDivisionError):
            return math.inf
        return math.nan if isinstance(result, complex) else self.single(result)

    def shift_left(self, a: int, b: int) -> int:
        """`bshl`; the distance counts modulo the width."""
        return self.wrap(a << (b & self.bits - 1))

    def shift_right(self, a: int, b: int) -> int:
        """`bshr`, which keeps the sign."""
        return a >> (b & self.bits - 1)

    def shift_right_unsigned(self, a: int, b: int) -> int:
        """`bshru`, which shifts in zeros."""
        return self.wrap((a & self.mask) >> (b & self.bits - 1))

    def number_of_symbol(self, text: str) -> int:
        """`to_number` of a symbol."""
        value = _integer(text)
        if not -self.half <= value < self.half:
            raise EvaluationError(f"`{text}` is out of range for a number")
        return value

    def unsigned_of_symbol(self, text: str) -> int:
        """`to_unsigned` of a symbol."""
        value = _integer(text)
        if not 0 <= value <= self.mask:
            raise EvaluationError(f"`{text}` is out of range for an unsigned number")
        return value

    def float_of_symbol(self, text: str) -> float:
        """`to_float` of a symbol."""
        try:
            return self.single(float(text))
        except ValueError:
            raise EvaluationError(f"`{text}` is not a float") from None

    def number_of_float(self, value: float) -> int:
        """`to_number` of a float."""
        return self.wrap(_truncated(value))

    def unsigned_of_float(self, value: float) -> int:
        """`to_unsigned` of a float."""
        return _truncated(value) & self.mask

    def float_range(self, start: float, stop: float, step: float | None = None) -> Iterator[float]:
        """`range` over floats."""
        return self._steps(start, stop, (1.0 if start <= stop else -1.0) if step is None else step)

    def number_range(self, start: int, stop: int, step: int | None = None) -> Iterable[int]:
        """`range(start, stop[, step])`; without a step it counts towards `stop`."""
        if step is None:
            step = 1 if start <= stop else -1
        return self._steps(start, stop, step) if step == 0 else range(start, stop, step)  # type: ignore[return-value]

    def _steps(self, start: float, stop: float, step: float) -> Iterator[float]:
        if step == 0:
            if start != stop:
                yield start
            return
        value = start
        while value < stop if step > 0 else value > stop:
            yield value
            value = self.single(value + step)

    def show_float(self, value: float) -> str:
        """A float with the significant digits that identify it."""
        return f"{value:.{self.digits}g}"


@cache
def domain(bits: int) -> Domain:
    """The domain of 32 or 64 bits."""
    return Domain(bits)


def _integer(text: str) -> int:
    try:
        return int(text, 0) if text.lstrip("+-")[:2].lower() in ("0x", "0b") else int(text)
    except ValueError:
        raise EvaluationError(f"`{text}` is not a number") from None


def _truncated(value: float) -> int:
    """The integer part of a finite float."""
    if math.isnan(value) or math.isinf(value):
        raise EvaluationError(f"{value} has no integer value")
    return int(value)
