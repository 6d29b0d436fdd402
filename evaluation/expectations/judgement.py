"""Whether expectations are met by what rosarch found, and what was there instead."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from fnmatch import fnmatchcase
from typing import Any, Protocol

from rosarch.evaluation.expectations.comments import Marked
from rosarch.evaluation.expectations.elements import ANY, FINDING, Element, Kind, kinds
from rosarch.evaluation.expectations.grammar import Expectation
from rosarch.evaluation.experiments.normal_texts import conjuncts, normal, same_name

_GUARDS = frozenset({"guard", "when", "conditional"})
_CXX_NAMES = frozenset({"name", "variable", "callback", "type", "value", "initial"})
_MOST = 2


class Observed(Protocol):
    """What was found: `elements` of the components that a file is a source of, `findings` of the systems."""

    def elements(self, path: str) -> Sequence[Element]:
        """The elements of the components that have this source; of all where none has it, as of a header."""

    def findings(self) -> Sequence[Element]:
        """All that checks found."""

    def rows(self, marked: Marked, query: str) -> Sequence[str]:
        """The rows that answer a query, as texts."""

    def placed_rows(self, marked: Marked, query: str) -> Sequence[PlacedRow]:
        """The rows that answer a query and lie in the file of the expectation."""

    def near_rows(self, marked: Marked, query: str) -> Sequence[str]:
        """The rows that come nearest to a query without an answer."""


@dataclass(frozen=True)
class PlacedRow:
    """A row as text, and the line of the first of its values that has a place."""

    text: str
    line: int


@dataclass(frozen=True)
class Unmet:
    """An expectation that is not met; `instead` says what was there: what must not be, or what comes nearest."""

    expectation: Expectation
    instead: tuple[str, ...]


def unmet(expectation: Expectation, observed: Observed, expected: Sequence[Expectation]) -> Unmet | None:
    """The expectation, if it is not met; `expected` is all that is."""
    if expectation.kind is None:
        return _unmet_only(expectation, observed, expected) if expectation.here else _unmet_query(expectation, observed)
    marked = expectation.marked
    found = observed.findings() if expectation.kind.name == FINDING else observed.elements(marked.path)
    own = [element for element in found if _is_of(expectation.kind, element)]
    met = [element for element in own if not _faults(expectation, element)]
    if marked.sense == "only":
        asked = [e for e in expected if not e.marked.sense and e.marked.path == marked.path]
        met = [element for element in met if not any(e.kind and _is_of(e.kind, element) and not _faults(e, element) for e in asked)]
    if bool(met) != bool(marked.sense):
        return None
    if marked.sense:
        return Unmet(expectation, tuple(dict.fromkeys(shown(element) for element in met)))
    return Unmet(expectation, _nearest(expectation, own))


def _is_of(kind: Kind, element: Element) -> bool:
    return element.kind == kind.name or (kind is ANY and element.kind != "component")


def _unmet_query(expectation: Expectation, observed: Observed) -> Unmet | None:
    marked = expectation.marked
    rows = observed.rows(marked, expectation.query)
    if bool(rows) != bool(marked.sense):
        return None
    return Unmet(expectation, tuple(rows if marked.sense else observed.near_rows(marked, expectation.query)))


def _unmet_only(expectation: Expectation, observed: Observed, expected: Sequence[Expectation]) -> Unmet | None:
    """A query that is answered in the lines of the expectation, and nowhere in the file where the same is not said."""
    marked = expectation.marked
    same = [e.marked for e in expected if e.here and (e.marked.path, e.query) == (marked.path, expectation.query)]
    rows = observed.placed_rows(marked, expectation.query)
    others = [row for row in rows if not any(each.first <= row.line <= each.last for each in same)]
    if not others and any(marked.first <= row.line <= marked.last for row in rows):
        return None
    return Unmet(expectation, tuple(dict.fromkeys(f"{row.text}  {marked.path}:{row.line}" for row in others)))


def _faults(expectation: Expectation, element: Element) -> list[str]:
    """In what an element is not as expected: attributes, and its line."""
    faults = [name for name, wanted in expectation.wanted if not agrees(name, wanted, element.attributes.get(name))]
    return faults + ([] if _lies_here(expectation, element) else ["line"])


def _lies_here(expectation: Expectation, element: Element) -> bool:
    marked = expectation.marked
    lines = {f"{marked.path}:{line}" for line in range(marked.first, marked.last + 1)}
    return not expectation.here or not element.at or not lines.isdisjoint(element.at)


def agrees(name: str, wanted: str, value: Any) -> bool:
    """Whether the value of an attribute is as wanted: it matches where that has a `*`, else it is equal but for spaces and the like."""
    if isinstance(value, list):
        return any(agrees(name, wanted, item) for item in value)
    if name in _GUARDS:
        return conjuncts(wanted) == conjuncts(value)
    if "*" in wanted and fnmatchcase(normal(value), normal(wanted)):
        return True
    return normal(wanted) == normal(value) or (name in _CXX_NAMES and value is not None and same_name(wanted, value))


def _nearest(expectation: Expectation, found: Sequence[Element]) -> tuple[str, ...]:
    """The elements of the kind that come nearest, with what is not as expected."""
    wanted = dict(expectation.wanted)
    subject = expectation.kind.subject if expectation.kind else ()

    def distance(element: Element) -> tuple[float, int]:
        alike = [SequenceMatcher(None, wanted.get(name, ""), _text(element.attributes.get(name))).ratio() for name in subject]
        return -sum(alike), len(_faults(expectation, element))

    nearest = sorted(found, key=distance)[:_MOST]
    nearest = [element for element in nearest if distance(element)[0] == distance(nearest[0])[0]]
    return tuple(dict.fromkeys(f"{shown(element)} ({_deviations(expectation, element)})" for element in nearest))


def _deviations(expectation: Expectation, element: Element) -> str:
    """What is not as expected: other attributes than those that are shown anyway with their value."""
    kind = expectation.kind
    visible = (*kind.subject, kind.then, "line") if kind else ()
    faults = _faults(expectation, element)
    values = [f"{name} is {_text(element.attributes.get(name)) or 'none'}" for name in faults if name not in visible]
    other = [name for name in faults if name in visible]
    return ", ".join([*values, *([f"other {' and '.join(other)}"] if other else [])])


def shown(element: Element) -> str:
    """An element as expectations write it, with its place."""
    kind: Kind = kinds()[element.kind]
    between = f" {kind.between} " if kind.between else " "
    names = [_text(element.attributes.get(name)) for name in kind.subject]
    then = _text(element.attributes.get(kind.then)) if kind.then else ""
    text = between.join([*names, then] if then else names)
    return f"{kind.name} {text}{f'  {element.at[0]}' if element.at else ''}"


def _text(value: Any) -> str:
    if isinstance(value, list):
        return ",".join(map(str, value))
    if isinstance(value, bool):
        return "true" if value else "false"
    return "" if value is None else str(value)
