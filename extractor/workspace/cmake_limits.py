"""What evaluating CMake code may cost: it is a program, and the input's author may have written one that never ends."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from rosarch.base import tracing

MAX_WORDS = 600_000
"""Commands, arguments and words of conditions that are evaluated."""
MAX_DEPTH = 60
MAX_ROUNDS = 10_000
MAX_VALUE = 4 << 20
"""Characters of one value."""
MAX_TEXT = 512 << 20
"""Characters, roughly bytes, that a package's code may make in all."""
ELEMENT = 64
"""Bytes that an element of a list costs beside its text."""


class OutOfTime(Exception):
    """The time limit has passed."""


@contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Raise `OutOfTime` when the body takes longer, also from within a regular expression.

    Limits may nest; the clock of the outer one stands still meanwhile. In another than the main thread there is no limit: signals do not
    reach it.
    """
    if threading.current_thread() is not threading.main_thread() or not hasattr(signal, "setitimer"):
        yield
        return
    handler = signal.signal(signal.SIGALRM, _expire)
    remaining, interval = signal.setitimer(signal.ITIMER_REAL, seconds, 1.0)  # again and again: the first may be lost in a callback
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, handler)
        signal.setitimer(signal.ITIMER_REAL, remaining, interval)


def _expire(_number: int, _frame: object) -> None:
    tracing.uncertain()
    raise OutOfTime
