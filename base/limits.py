"""How much time and memory worker processes have; what is beyond is ended from outside. The options `--timeout` and `--memory` set it."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

SOURCE_SECONDS = 60.0
"""For one source, and for the CMake code of one package."""
_EVALUATION = 5
"""The rules of a component or system have so many times the limit of a source."""


@dataclass
class Limits:
    """Seconds for the rules of one component or system, bytes of address space of a worker process."""

    evaluation: float = _EVALUATION * SOURCE_SECONDS
    memory: int = 4 << 30

    def set_source_seconds(self, seconds: float) -> None:
        """Derive what follows from the limit of one source."""
        self.evaluation = _EVALUATION * seconds


LIMITS = Limits()
_DEPTH = 20_000


@contextmanager
def deep_recursion() -> Iterator[None]:
    """Let functions call each other as deeply as expressions and statements of sources are nested."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, _DEPTH))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)
