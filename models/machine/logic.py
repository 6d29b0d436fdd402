"""Conditions over subjects with finitely many values: evaluation with unknowns, simplification, and formulas made from cases."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from rosarch.base import logic
from rosarch.base.logic import FALSE, TRUE, All, Any, Not, atoms, from_alternatives

OTHER = "other"
BOOLEAN = ("true", "false")


@dataclass(frozen=True)
class Subject:
    """What a condition is about: a variable of the node, or an input, and the values distinguished.

    `key` is the identity and `text` the spelling for people. `OTHER` stands for every value that is not named. `cell` says that it is
    one of the node's variables. A `hidden` subject stands for something that the source does not say; there is nothing to show.
    """

    key: str
    text: str
    values: tuple[str, ...] = BOOLEAN
    cell: bool = False
    hidden: bool = False
    negative: str = ""  # the spelling of its opposite, when it is a truth value and that is not `!` before `text`


@dataclass(frozen=True)
class Is:
    """The value of `subject` is one of `values`."""

    subject: Subject
    values: frozenset[str]


Formula: TypeAlias = logic.Formula[Is]
Case: TypeAlias = Mapping[Subject, frozenset[str]]
Lookup: TypeAlias = Callable[[Subject], str | None]

_MOST_PAIRS = 20_000  # of cases, compared to shorten a condition


def evaluate(formula: Formula, value_of: Lookup) -> bool | None:
    """The truth of a formula, `None` when it hangs on a subject of which `value_of` knows no value."""

    def truth(atom: Is) -> bool | None:
        value = value_of(atom.subject)
        return None if value is None else value in atom.values

    return logic.truth(formula, truth)


def simplify(formula: Formula, value_of: Lookup) -> Formula:
    """What remains of a formula when the known values are filled in."""
    known = evaluate(formula, value_of)
    if known is not None:
        return TRUE if known else FALSE
    if isinstance(formula, Is):
        return formula
    if isinstance(formula, Not):
        return negation(simplify(formula.inner, value_of))
    neutral = TRUE if isinstance(formula, All) else FALSE
    parts = [part for part in (simplify(part, value_of) for part in formula.parts) if part != neutral]
    return parts[0] if len(parts) == 1 else type(formula)(tuple(parts))


def negation(formula: Formula) -> Formula:
    """The opposite, with negations moved inward to where they vanish."""
    return logic.normal(formula, False, _literal)


def _literal(atom: Is, holds: bool) -> Is:
    return atom if holds else Is(atom.subject, frozenset(atom.subject.values) - atom.values)


def conjunction(parts: Iterable[Formula]) -> Formula:
    """All parts, flattened, each once."""
    found: dict[Formula, None] = {}
    for part in parts:
        found.update(dict.fromkeys(part.parts if isinstance(part, All) else (part,)))
    return next(iter(found)) if len(found) == 1 else All(tuple(found))


def subjects(formula: Formula) -> Iterator[Subject]:
    """The subjects in the order of the text, possibly several times."""
    return (atom.subject for atom in atoms(formula))


def first_unknown(formula: Formula, value_of: Lookup) -> Subject:
    """The subject to ask for next when `evaluate` gave `None`: the first whose value can still matter."""
    return next(subject for subject in subjects(simplify(formula, value_of)) if value_of(subject) is None)


def from_cases(cases: Iterable[Case], against: Sequence[Case] = ()) -> Formula:
    """A formula that holds in these cases and in none of those `against`; together they are all there are, and exclude one another.

    Values that do not matter are left out.
    """
    merged = [dict(case) for case in cases]
    while (pair := _mergeable(merged)) is not None:
        first, second, subject = pair
        union = merged[first][subject] | merged[second][subject]
        del merged[second]
        merged[first] = {s: v for s, v in merged[first].items() if s != subject}
        if union != frozenset(subject.values):
            merged[first][subject] = union
    if against and len(merged) * len(against) <= _MOST_PAIRS:
        merged = _widened(merged, against)
    return from_alternatives([Is(subject, values) for subject, values in case.items()] for case in merged)


def _widened(cases: Sequence[Case], against: Sequence[Case]) -> list[dict[Subject, frozenset[str]]]:
    """The cases without conditions that only distinguish them from one another."""
    found: list[dict[Subject, frozenset[str]]] = []
    for case in cases:
        wide = dict(case)
        for subject in case:
            rest = {s: v for s, v in wide.items() if s != subject}
            if not any(_overlap(rest, other) for other in against):
                wide = rest
        found.append(wide)
    return [
        case
        for index, case in enumerate(found)
        if not any(_within(case, other) and (case != other or at < index) for at, other in enumerate(found) if at != index)
    ]


def _overlap(one: Case, two: Case) -> bool:
    return all(subject not in two or values & two[subject] for subject, values in one.items())


def _within(one: Case, two: Case) -> bool:
    return all(subject in one and one[subject] <= values for subject, values in two.items())


def _mergeable(cases: Sequence[Case]) -> tuple[int, int, Subject] | None:
    """Two cases that differ in the values of a single subject."""
    seen: dict[tuple[Subject, frozenset[tuple[Subject, frozenset[str]]]], int] = {}
    for index, case in enumerate(cases):
        for subject in case:
            rest = frozenset((s, v) for s, v in case.items() if s != subject)
            if (other := seen.setdefault((subject, rest), index)) != index:
                return other, index, subject
    return None


def without_hidden(formula: Formula) -> Formula:
    """A formula without what cannot be shown: hidden subjects may have any value."""
    if isinstance(formula, Is):
        return TRUE if formula.subject.hidden else formula
    if isinstance(formula, Not):
        inner = without_hidden(formula.inner)
        return TRUE if inner == TRUE else negation(inner)
    parts = _by_subject(type(formula), [without_hidden(part) for part in formula.parts])
    if isinstance(formula, All):
        return conjunction(part for part in parts if part != TRUE)
    if TRUE in parts:
        return TRUE
    return parts[0] if len(parts) == 1 else Any(tuple(parts))


def _by_subject(kind: type[All[Is]] | type[Any[Is]], parts: Sequence[Formula]) -> list[Formula]:
    """The parts of a conjunction or disjunction, each once, those about the same subject as one."""
    found: dict[object, Formula] = {}
    for part in parts:
        key = part.subject if isinstance(part, Is) else part
        earlier = found.get(key)
        if isinstance(part, Is) and isinstance(earlier, Is):
            part = Is(part.subject, earlier.values & part.values if kind is All else earlier.values | part.values)
        found[key] = part
    return list(found.values())
