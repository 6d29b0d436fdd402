"""Formulas: unknown values, and formulas made from cases, against all valuations."""

from __future__ import annotations

from itertools import product

from hypothesis import given
from hypothesis import strategies as st

from rosarch.base.logic import FALSE, TRUE, All, Any, Not
from rosarch.models.machine.logic import (
    Formula,
    Is,
    Subject,
    evaluate,
    first_unknown,
    from_cases,
    negation,
    simplify,
    subjects,
    without_hidden,
)

X, Y = Subject("x", "x"), Subject("y", "y")
Z = Subject("z", "z", ("A", "B", "other"))
EVERYTHING = [dict(zip((X, Y, Z), values, strict=True)) for values in product(X.values, Y.values, Z.values)]


def is_(subject: Subject, *values: str) -> Is:
    return Is(subject, frozenset(values))


formulas = st.recursive(
    st.sampled_from([TRUE, FALSE, is_(X, "true"), is_(Y, "false"), is_(Z, "A"), is_(Z, "A", "other")]),
    lambda inner: st.one_of(
        inner.map(Not),
        st.lists(inner, max_size=3).map(lambda parts: All(tuple(parts))),
        st.lists(inner, max_size=3).map(lambda parts: Any(tuple(parts))),
    ),
    max_leaves=8,
)


@given(formulas)
def test_negation_is_the_opposite_everywhere(formula: Formula) -> None:
    for values in EVERYTHING:
        assert evaluate(negation(formula), values.get) is not evaluate(formula, values.get)


@given(formulas, st.sets(st.sampled_from([X, Y, Z])), st.sampled_from(EVERYTHING))
def test_what_is_left_open_is_decided_by_the_rest(formula: Formula, known: set[Subject], values: dict[Subject, str]) -> None:
    partial = {subject: values[subject] for subject in known}
    rest = simplify(formula, partial.get)
    assert evaluate(rest, values.get) is evaluate(formula, values.get)
    assert known.isdisjoint(subjects(rest))
    if evaluate(formula, partial.get) is None:
        assert first_unknown(formula, partial.get) not in known


@given(st.lists(st.booleans(), min_size=len(EVERYTHING), max_size=len(EVERYTHING)).filter(any))
def test_a_formula_from_cases_holds_in_them_alone(wanted: list[bool]) -> None:
    cases = [{s: frozenset({v}) for s, v in values.items()} for values in EVERYTHING]
    holding = [case for case, want in zip(cases, wanted, strict=True) if want]
    against = [case for case, want in zip(cases, wanted, strict=True) if not want]
    for formula in (from_cases(holding), from_cases(holding, against)):
        assert [evaluate(formula, values.get) for values in EVERYTHING] == wanted


def test_cases_lose_what_does_not_matter() -> None:
    first, second = frozenset({"true"}), frozenset({"false"})
    assert from_cases([{X: first, Y: first}, {X: first, Y: second}]) == is_(X, "true")
    cascade = [{X: first}, {X: second, Y: first}]
    assert from_cases(cascade, [{X: second, Y: second}]) == Any((is_(X, "true"), is_(Y, "true")))
    assert from_cases([{}]) == TRUE


def test_hidden_subjects_may_have_any_value() -> None:
    hidden = Subject("h", "h", hidden=True)
    assert without_hidden(All((is_(X, "true"), is_(hidden, "true")))) == is_(X, "true")
    assert without_hidden(Any((is_(X, "true"), is_(hidden, "true")))) == TRUE
    assert without_hidden(Not(is_(hidden, "true"))) == TRUE
    assert without_hidden(All((is_(Z, "A", "B"), is_(Z, "B", "other")))) == is_(Z, "B")
