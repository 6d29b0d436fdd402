"""What checkers have in common."""

from __future__ import annotations

from dataclasses import dataclass

from rosarch.behavior.verification.explorer import Lasso


@dataclass(frozen=True)
class CheckResult:
    """What a checker reports: whether a property holds, in how many states, and a run that violates it, when it shows one."""

    holds: bool
    states: int
    lasso: Lasso | None


class CheckerError(Exception):
    """A checker cannot be used, or gives up; `large`: since there are too many states."""

    def __init__(self, message: str, *, large: bool = False) -> None:
        super().__init__(message)
        self.large = large
