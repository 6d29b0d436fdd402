"""The steps of a reaction: an assignment or a sending, each under a guard."""

from __future__ import annotations

from dataclasses import dataclass

from rosarch.base.logic import TRUE
from rosarch.models.machine.logic import Formula, Subject, subjects
from rosarch.models.machine.meaning import Assignment


@dataclass(frozen=True)
class Row:
    """The row of the component model that an element rests on: its list, its index there, and its source line."""

    kind: str
    index: int
    at: str


@dataclass(frozen=True)
class Output:
    """A port that is sent to, under a condition of its own; `sometimes` when the source's condition is not known."""

    port: str
    when: Formula = TRUE
    sometimes: bool = False


@dataclass(frozen=True)
class Step:
    """An assignment or a sending, under a guard.

    `epochs` say how many assignments of its reaction to a variable come before its guard tests this, where some do; it is `unclear` when
    the guard tests one before and after.
    """

    row: Row
    guard: tuple[Formula, ...]
    assignments: tuple[Assignment, ...] = ()
    outputs: tuple[str, ...] = ()
    sometimes: bool = False
    done_at: str = ""  # where it is done, when its row is about another place
    epochs: tuple[tuple[str, int], ...] = ()
    unclear: bool = False

    def tested(self) -> set[Subject]:
        """What its guard and its values are about."""
        values = (formula for assignment in self.assignments for formula, _ in assignment.table)
        return {subject for formula in (*self.guard, *values) for subject in subjects(formula)}

    def tested_as(self, key: str) -> str:
        """A variable as the guard tests it: what tests it at the same time sees the same."""
        epoch = next((number for name, number in self.epochs if name == key), 0)
        return f"{key} {epoch}" if epoch else key
