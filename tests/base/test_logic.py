"""Formulas over atoms of any kind, against all valuations."""

from __future__ import annotations

from itertools import product

from hypothesis import given
from hypothesis import strategies as st

from rosarch.base.logic import (
    FALSE,
    TRUE,
    All,
    Any,
    Formula,
    Not,
    alternatives,
    atoms,
    conjuncts,
    from_alternatives,
    normal,
    opposite,
    substituted,
    truth,
)

VALUATIONS = [dict(zip("abc", values, strict=True)) for values in product((True, False, None), repeat=3)]
formulas = st.recursive(
    st.sampled_from(["a", "b", "c", TRUE, FALSE]),
    lambda inner: st.one_of(
        inner.map(Not),
        st.lists(inner, max_size=3).map(lambda parts: All(tuple(parts))),
        st.lists(inner, max_size=3).map(lambda parts: Any(tuple(parts))),
    ),
    max_leaves=8,
)


def literal(atom: str, holds: bool) -> Formula[str]:
    return atom if holds else Not(atom)


def are_inward(formula: Formula[str]) -> bool:
    if isinstance(formula, Not):
        return isinstance(formula.inner, str)
    return isinstance(formula, str) or all(map(are_inward, formula.parts))


@given(formulas, st.booleans())
def test_negations_move_inward(formula: Formula[str], holds: bool) -> None:
    found = normal(formula, holds, literal)
    assert are_inward(found)
    assert list(atoms(found)) == list(atoms(formula))
    for values in VALUATIONS:
        assert truth(found, values.get) is truth(formula if holds else Not(formula), values.get)


@given(formulas)
def test_the_opposite_has_no_double_negation(formula: Formula[str]) -> None:
    found = opposite(formula)
    assert not (isinstance(found, Not) and isinstance(found.inner, Not)) or isinstance(formula, Not)
    for values in VALUATIONS:
        assert truth(found, values.get) is truth(Not(formula), values.get)


@given(formulas)
def test_what_is_put_in_the_place_of_an_atom_has_its_truth(formula: Formula[str]) -> None:
    by = {"a": Any(("b", "c")), "b": Not("a"), "c": TRUE}
    for values in VALUATIONS:
        inner = {atom: truth(other, values.get) for atom, other in by.items()}
        assert truth(substituted(formula, by.__getitem__), values.get) is truth(formula, inner.get)


@given(formulas)
def test_conjuncts_are_the_formula(formula: Formula[str]) -> None:
    for values in VALUATIONS:
        assert truth(All(conjuncts(formula)), values.get) is truth(formula, values.get)


@given(st.lists(st.lists(st.sampled_from("abc"), max_size=3).map(tuple), max_size=4).map(tuple))
def test_alternatives_are_what_a_formula_was_made_from(ways: tuple[tuple[str, ...], ...]) -> None:
    assert alternatives(from_alternatives(ways)) == ways


def test_nothing_is_joined_that_is_alone() -> None:
    assert from_alternatives([["a"]]) == "a"
    assert from_alternatives([["a", "b"]]) == All(("a", "b"))
    assert from_alternatives([["a"], ["b", "c"]]) == Any(("a", All(("b", "c"))))
    assert from_alternatives([[]]) == TRUE
    assert from_alternatives([]) == FALSE
