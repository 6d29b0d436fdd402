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

    `epochs` say, for a condition of its guard and a variable, how many assignments of its reaction to this come before it is tested, where
    some do; the step is `unclear` when one condition tests a variable before and after.
    """

    row: Row
    guard: tuple[Formula, ...]
    assignments: tuple[Assignment, ...] = ()
    outputs: tuple[str, ...] = ()
    sometimes: bool = False
    done_at: str = ""  # where it is done, when its row is about another place
    epochs: tuple[tuple[int, str, int], ...] = ()
    unclear: bool = False

    def tested(self) -> set[Subject]:
        """What its guard and its values are about."""
        values = (formula for assignment in self.assignments for formula, _ in assignment.table)
        return {subject for formula in (*self.guard, *values) for subject in subjects(formula)}

    def tested_as(self, key: str, part: int) -> str:
        """A variable as a condition of the guard tests it: what tests it at the same time sees the same."""
        epoch = next((number for at, name, number in self.epochs if (at, name) == (part, key)), 0)
        return f"{key} {epoch}" if epoch else key
