"""Linear temporal logic: formulas, and their negation normal form."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

from rosarch.behavior.composition.cone import Event


@dataclass(frozen=True)
class Constant:
    """True or false."""

    value: bool


@dataclass(frozen=True)
class InState:
    """A variable of a node, by its key, has one of these values."""

    node: str
    key: str
    values: frozenset[str]


@dataclass(frozen=True)
class Happens:
    """The step that led here is such an event."""

    event: Event


@dataclass(frozen=True)
class Marker:
    """Something that a transition system keeps about its run, such as `fair`."""

    name: str


@dataclass(frozen=True)
class Not:
    """Not."""

    inner: Formula


@dataclass(frozen=True)
class Binary:
    """`&`, `|`, `U` (until) or `R` (release: the right holds up to and including where the left does, or for ever)."""

    operator: str
    left: Formula
    right: Formula


@dataclass(frozen=True)
class Next:
    """After the next step."""

    inner: Formula


Atom: TypeAlias = InState | Happens | Marker
Formula: TypeAlias = Constant | InState | Happens | Marker | Not | Binary | Next

TRUE, FALSE = Constant(True), Constant(False)


def conjunction(left: Formula, right: Formula) -> Formula:
    """And."""
    return Binary("&", left, right)


def disjunction(left: Formula, right: Formula) -> Formula:
    """Or."""
    return Binary("|", left, right)


def implication(left: Formula, right: Formula) -> Formula:
    """If the left, then the right."""
    return disjunction(Not(left), right)


def until(left: Formula, right: Formula) -> Formula:
    """The right holds at some time, and the left until then."""
    return Binary("U", left, right)


def weak_until(left: Formula, right: Formula) -> Formula:
    """The left holds until the right does, or for ever."""
    return Binary("R", right, disjunction(left, right))


def eventually(inner: Formula) -> Formula:
    """At some time, now or later."""
    return until(TRUE, inner)


def always(inner: Formula) -> Formula:
    """From now on."""
    return Binary("R", FALSE, inner)


_DUAL = {"&": "|", "|": "&", "U": "R", "R": "U"}


def normal(formula: Formula, holds: bool = True) -> Formula:
    """The formula, or its opposite, with negations at atoms only."""
    if isinstance(formula, Constant):
        return Constant(formula.value is holds)
    if isinstance(formula, Not):
        return normal(formula.inner, not holds)
    if isinstance(formula, Next):
        return Next(normal(formula.inner, holds))
    if isinstance(formula, Binary):
        operator = formula.operator if holds else _DUAL[formula.operator]
        return Binary(operator, normal(formula.left, holds), normal(formula.right, holds))
    return formula if holds else Not(formula)


def is_safety(formula: Formula) -> bool:
    """Whether every violation shows after finitely many steps, as far as the form tells: nothing is promised for later."""
    return all(part.operator != "U" for part in parts(normal(formula)) if isinstance(part, Binary))


def atoms(formula: Formula) -> list[Atom]:
    """The atoms, each once, in the order of the text."""
    return list(dict.fromkeys(part for part in parts(formula) if isinstance(part, InState | Happens | Marker)))


def parts(formula: Formula) -> Iterator[Formula]:
    """All parts of a formula, itself included."""
    yield formula
    if isinstance(formula, Not | Next):
        yield from parts(formula.inner)
    elif isinstance(formula, Binary):
        yield from parts(formula.left)
        yield from parts(formula.right)
