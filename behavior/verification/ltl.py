"""Linear temporal logic: formulas over the states and events of a run, and their negation normal form."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

from rosarch.base import logic
from rosarch.base.logic import FALSE, TRUE, Any, Not
from rosarch.behavior.composition.cone import Event


class Part:
    """What a formula is made of: an `Atom`, or a temporal operator."""


@dataclass(frozen=True)
class InState(Part):
    """A variable of a node, by its key, has one of these values."""

    node: str
    key: str
    values: frozenset[str]


@dataclass(frozen=True)
class Happens(Part):
    """The step that led here is such an event."""

    event: Event


@dataclass(frozen=True)
class Marker(Part):
    """Something that a transition system keeps about its run, such as `fair`."""

    name: str


Atom: TypeAlias = InState | Happens | Marker
Formula: TypeAlias = logic.Formula[Part]


@dataclass(frozen=True)
class Next(Part):
    """After the next step."""

    inner: Formula


@dataclass(frozen=True)
class Until(Part):
    """The right holds at some time, and the left until then."""

    left: Formula
    right: Formula


@dataclass(frozen=True)
class Release(Part):
    """The right holds up to and including where the left does, or forever."""

    left: Formula
    right: Formula


def implication(left: Formula, right: Formula) -> Formula:
    """If the left, then the right."""
    return Any((Not(left), right))


def weak_until(left: Formula, right: Formula) -> Formula:
    """The left holds until the right does, or forever."""
    return Release(right, Any((left, right)))


def eventually(inner: Formula) -> Formula:
    """At some time, now or later."""
    return Until(TRUE, inner)


def always(inner: Formula) -> Formula:
    """From now on."""
    return Release(FALSE, inner)


def normal(formula: Formula, holds: bool = True) -> Formula:
    """The formula, or its opposite, with negations at atoms only."""
    return logic.normal(formula, holds, _normal_part)


def _normal_part(part: Part, holds: bool) -> Formula:
    if isinstance(part, Next):
        return Next(normal(part.inner, holds))
    if isinstance(part, Until | Release):
        kind = Until if isinstance(part, Until) is holds else Release
        return kind(normal(part.left, holds), normal(part.right, holds))
    return part if holds else Not(part)


def is_safety(formula: Formula) -> bool:
    """Whether every violation shows after finitely many steps, as far as the form shows: nothing is promised for later."""
    return not any(isinstance(part, Until) for part in parts(normal(formula)))


def atoms(formula: Formula) -> list[Atom]:
    """The atoms, each once, in the order of the text."""
    return list(dict.fromkeys(part for part in parts(formula) if isinstance(part, Atom)))


def parts(formula: Formula) -> Iterator[Part]:
    """The atoms and temporal operators, also those within others."""
    for part in logic.atoms(formula):
        yield part
        if isinstance(part, Next):
            yield from parts(part.inner)
        elif isinstance(part, Until | Release):
            yield from parts(part.left)
            yield from parts(part.right)
