"""Conditions over texts that are not known, as formulas: whether several of them can hold at once."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, TypeAlias

from rosarch.extractor.launch.unknowns import Unknowns, marks_in
from rosarch.extractor.launch.values import boolean

MAX_CASES = 4096
MAX_TESTS = 64


@dataclass(frozen=True)
class Test:
    """The text `subject`, which has unknown parts, is `value`; without one, it counts as true.

    `opaque` is a subject of which no more is known than how the source writes it: it may depend on any other.
    """

    subject: str
    value: Any = None
    opaque: bool = False


@dataclass(frozen=True)
class Not:
    """`of` does not hold."""

    of: Formula


@dataclass(frozen=True)
class Every:
    """All of these hold."""

    parts: tuple[Formula, ...] = ()


@dataclass(frozen=True)
class Some:
    """One of these holds, at least."""

    parts: tuple[Formula, ...] = ()


Formula: TypeAlias = "Test | Not | Every | Some"
TRUE, FALSE = Every(), Some()


def choice(condition: Formula, first: Formula, second: Formula) -> Formula:
    """`first` when the condition holds, else `second`."""
    return Some((Every((condition, first)), Every((Not(condition), second))))


def equals(subject: Any, value: Any) -> Formula:
    """A text with unknown parts has a value; one that cannot be, where what is known about the text differs."""
    if isinstance(value, str) and isinstance(subject, str) and not _may_be(subject, value):
        return FALSE
    return Test(subject, value)


def bounded(formula: Formula, text: str) -> Formula:
    """The formula, or `text` as all that is known about it when it is too large."""
    return Test(text, opaque=True) if len(list(itertools.islice(tests_of(formula), MAX_TESTS + 1))) > MAX_TESTS else formula


def truth(unknowns: Unknowns, text: str) -> Formula:
    """A text with unknown parts counts as true."""
    return unknowns.truths.get(text) or Test(text)


@lru_cache(maxsize=4096)
def _may_be(subject: str, value: str) -> bool:
    known = marks_in(subject)
    pattern = re.escape(subject)
    for mark in known:
        pattern = pattern.replace(mark, ".*")
    return re.fullmatch(pattern, value, re.DOTALL) is not None


@lru_cache(maxsize=16384)
def possible(formulas: tuple[Formula, ...]) -> bool | None:
    """Whether all of these can hold at once; None when it is not known."""
    found = [_satisfiable(group) for group in _groups(formulas)]
    if False in found:
        return False
    return None if None in found or _dependent(test for formula in formulas for test in tests_of(formula)) else True


def _groups(formulas: tuple[Formula, ...]) -> list[list[Formula]]:
    """Formulas that have a subject in common, or are linked by others that have, together."""
    groups: list[tuple[set[str], list[Formula]]] = []
    for formula in formulas:
        subjects, members = {test.subject for test in tests_of(formula)}, [formula]
        for group in [group for group in groups if not subjects.isdisjoint(group[0])]:
            groups.remove(group)
            subjects |= group[0]
            members += group[1]
        groups.append((subjects, members))
    return [members for _, members in groups]


def _satisfiable(formulas: list[Formula]) -> bool | None:
    tests = {test for formula in formulas for test in tests_of(formula)}
    subjects = sorted({test.subject for test in tests})
    domains = [_domain([test for test in tests if test.subject == subject]) for subject in subjects]
    if math.prod(map(len, domains)) > MAX_CASES:
        return None
    cases = (dict(zip(subjects, case, strict=True)) for case in itertools.product(*domains))
    return any(all(_holds(formula, case) for formula in formulas) for case in cases)


def tests_of(formula: Formula) -> Iterator[Test]:
    """The tests that a formula consists of."""
    if isinstance(formula, Test):
        yield formula
    else:
        for part in (formula.of,) if isinstance(formula, Not) else formula.parts:
            yield from tests_of(part)


_OTHER = object()


def _domain(tests: list[Test]) -> list[Any]:
    """The values of one subject that tests distinguish. Of what has to be a Boolean, other values end the launch."""
    values = list(dict.fromkeys(test.value for test in tests if test.value is not None))
    if all(test.value is not None for test in tests):
        return [*values, _OTHER]
    return [*(value for value in values if _boolean(value) is not None), "true", "false"]


def _boolean(value: Any) -> bool | None:
    try:
        return boolean(str(value))
    except ValueError:
        return None


def _holds(formula: Formula, case: dict[str, Any]) -> bool:
    if isinstance(formula, Test):
        value = case[formula.subject]
        return _boolean(value) is True if formula.value is None else bool(value == formula.value)
    if isinstance(formula, Not):
        return not _holds(formula.of, case)
    return (all if isinstance(formula, Every) else any)(_holds(part, case) for part in formula.parts)


def _dependent(tests: Iterable[Test]) -> bool:
    """Whether two subjects may have to do with each other: they share an unknown part, or more is not known about them."""
    subjects = {test.subject: test.opaque for test in tests}
    return any(
        (opaque and other_opaque) or not marks_in(subject).isdisjoint(marks_in(other))
        for (subject, opaque), (other, other_opaque) in itertools.combinations(subjects.items(), 2)
    )
