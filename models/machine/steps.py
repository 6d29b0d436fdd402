"""The steps of a reaction: an assignment or a sending, each under a guard."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

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

    `epochs` say, for a condition of its guard and a variable, which assignments of its reaction to this may come before it is tested, where
    some do: the numbers of their steps. The step is `unclear` when one condition tests a variable before and after.
    Where a reaction does things in the order of its calls, `trail` are the places of those that lead to the step, and its own; it is empty
    where these are not known.
    """

    row: Row
    guard: tuple[Formula, ...]
    assignments: tuple[Assignment, ...] = ()
    outputs: tuple[str, ...] = ()
    sometimes: bool = False
    done_at: str = ""  # where it is done, when its row is about another place
    epochs: tuple[tuple[int, str, tuple[int, ...]], ...] = ()
    unclear: bool = False
    trail: tuple[str, ...] | None = None
    messages: tuple[tuple[str, str], ...] = ()  # for ports that it sends through, what the document calls the message, where it is known

    def tested(self) -> set[Subject]:
        """What its guard and its values are about."""
        values = (formula for assignment in self.assignments for formula, _ in assignment.table)
        return {subject for formula in (*self.guard, *values) for subject in subjects(formula)}

    def within(self, condition: Formula) -> Step:
        """The step under one condition more, which is tested first."""
        moved = tuple((part + 1, key, steps) for part, key, steps in self.epochs)
        return replace(self, guard=(condition, *self.guard), epochs=moved)

    def tested_as(self, key: str, part: int) -> str:
        """A variable as a condition of the guard tests it: what tests it at the same time sees the same."""
        epoch = next((steps for at, name, steps in self.epochs if (at, name) == (part, key)), ())
        return " ".join((key, *map(str, epoch)))


def trail_of(row: Mapping[str, Any]) -> tuple[str, ...] | None:
    """The trail of the step that a row of a document is."""
    return tuple(map(str, row["trail"])) if "trail" in row else None
