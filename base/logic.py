"""Logical formulas over atoms of any kind: guards, conditions of sources and of state machines, and properties are such formulas."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Generic, NoReturn, TypeAlias, TypeVar, cast

Atom = TypeVar("Atom", covariant=True)
Other = TypeVar("Other")


@dataclass(frozen=True)
class Not(Generic[Atom]):
    """Not."""

    inner: Formula[Atom]


@dataclass(frozen=True)
class All(Generic[Atom]):
    """All parts hold; nothing to hold is true."""

    parts: tuple[Formula[Atom], ...] = ()


@dataclass(frozen=True)
class Any(Generic[Atom]):
    """One of the parts holds; nothing to choose from is false."""

    parts: tuple[Formula[Atom], ...] = ()


Formula: TypeAlias = Atom | Not[Atom] | All[Atom] | Any[Atom]
TRUE: All[NoReturn] = All()
FALSE: Any[NoReturn] = Any()


def truth(formula: Formula[Atom], of: Callable[[Atom], bool | None]) -> bool | None:
    """The truth of a formula by that `of` its atoms, `None` when it hangs on one of which that is not known (Kleene's logic)."""
    if isinstance(formula, Not):
        inner = truth(formula.inner, of)
        return None if inner is None else not inner
    if isinstance(formula, All | Any):
        decisive = isinstance(formula, Any)
        outcomes = [truth(part, of) for part in formula.parts]
        if decisive in outcomes:
            return decisive
        return None if None in outcomes else not decisive
    return of(formula)


def normal(formula: Formula[Atom], holds: bool, literal: Callable[[Atom, bool], Formula[Other]]) -> Formula[Other]:
    """Negation normal form of a formula or, unless it `holds`, of its opposite: `literal` says what an atom is that holds or does not."""
    if isinstance(formula, Not):
        return normal(formula.inner, not holds, literal)
    if isinstance(formula, All | Any):
        kind = All if isinstance(formula, All) is holds else Any
        return kind(tuple(normal(part, holds, literal) for part in formula.parts))
    return literal(formula, holds)


def opposite(formula: Formula[Atom]) -> Formula[Atom]:
    """The negation, without a double one."""
    if isinstance(formula, Not):
        return formula.inner
    if formula in (TRUE, FALSE):
        return FALSE if formula == TRUE else TRUE
    return Not(formula)


def substituted(formula: Formula[Atom], by: Callable[[Atom], Formula[Other]]) -> Formula[Other]:
    """The formula with others in the places of its atoms."""
    if isinstance(formula, Not):
        return Not(substituted(formula.inner, by))
    if isinstance(formula, All | Any):
        kind = All if isinstance(formula, All) else Any
        return kind(tuple(substituted(part, by) for part in formula.parts))
    return by(formula)


def atoms(formula: Formula[Atom]) -> Iterator[Atom]:
    """The atoms in the order of the text, possibly several times."""
    if isinstance(formula, Not):
        yield from atoms(formula.inner)
    elif isinstance(formula, All | Any):
        for part in formula.parts:
            yield from atoms(part)
    else:
        yield formula


def conjuncts(formula: Formula[Atom]) -> tuple[Formula[Atom], ...]:
    """The parts that all have to hold, at least one."""
    return (formula.parts if isinstance(formula, All) else ()) or (formula,)


def from_alternatives(conjunctions: Iterable[Iterable[Formula[Atom]]]) -> Formula[Atom]:
    """The disjunction of conjunctions, without what joins but one part."""
    parts = tuple(_joined(All, tuple(conjunction)) for conjunction in conjunctions)
    return _joined(Any, parts)


def _joined(kind: type[All[Atom]] | type[Any[Atom]], parts: tuple[Formula[Atom], ...]) -> Formula[Atom]:
    return parts[0] if len(parts) == 1 else kind(parts)


def alternatives(formula: Formula[Atom]) -> tuple[tuple[Atom, ...], ...]:
    """The conjunctions of atoms, of a formula that is a disjunction of these."""
    return tuple(map(_conjunction, formula.parts if isinstance(formula, Any) else (formula,)))


def _conjunction(formula: Formula[Atom]) -> tuple[Atom, ...]:
    """The atoms of a conjunction."""
    if isinstance(formula, All) and not any(isinstance(part, All | Any | Not) for part in formula.parts):
        return cast(tuple[Atom, ...], formula.parts)  # so it is nearly always
    return tuple(atoms(formula))
