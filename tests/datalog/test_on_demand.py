"""Programs of which only what their outputs need is derived: the same rows, whatever is asked for how."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import pytest

from rosarch.datalog import DatalogError, Program, load_program

Rows = Mapping[str, Iterable[tuple[Any, ...]]]
Load = Callable[[str], tuple[Program, Program]]


@pytest.fixture
def both(tmp_path: Path) -> Load:
    """A program from its text, as a whole and on demand."""

    def load(source: str) -> tuple[Program, Program]:
        path = tmp_path / "p.dl"
        path.write_text(source, encoding="utf-8")
        return load_program(path), load_program(path, on_demand=True)

    return load


def tables(program: Program) -> set[tuple[str, tuple[int, ...]]]:
    return {(table.relation, table.keys) for table in program.code.tables}


def same(programs: tuple[Program, Program], facts: Rows) -> list[tuple[Any, ...]]:
    """The rows of `r`, which both programs have."""
    whole, demanded = (program.evaluate(facts).rows("r") for program in programs)
    assert demanded == whole
    return whole


TREE = """
.decl below(a: symbol, b: symbol)
.input below
.decl leaf(a: symbol, n: number)
.input leaf
.decl name(a: symbol)
.input name
.decl asked(a: symbol)
asked(A) :- name(A).
.decl holds(a: symbol, n: number)
holds(A, N) :- leaf(A, N).
holds(A, N) :- below(A, B), holds(B, N).
.decl r(a: symbol, n: number)
.output r
r(A, N) :- asked(A), holds(A, N).
"""


def test_recursion_down_a_tree(both: Load) -> None:
    programs = both(TREE)
    assert tables(programs[1]) == {("holds", (0,))}
    facts = {"below": [("a", "b"), ("b", "c"), ("a", "d"), ("x", "y")], "leaf": [("c", 1), ("d", 2), ("y", 3)], "name": [("a",), ("d",)]}
    assert same(programs, facts) == [("a", 1), ("a", 2), ("d", 2)]


def test_recursion_in_circles(both: Load) -> None:
    circles = [("a", "b"), ("b", "a"), ("b", "c"), ("c", "d"), ("d", "c"), ("e", "e"), ("f", "a")]
    facts = {"below": circles, "leaf": [("d", 1), ("e", 2), ("a", 3)], "name": [(x,) for x in "cafe"]}
    assert same(both(TREE), facts) == [("a", 1), ("a", 3), ("c", 1), ("e", 2), ("f", 1), ("f", 3)]


def test_long_chains_need_no_stack(both: Load) -> None:
    chain = [(f"n{i}", f"n{i + 1}") for i in range(5000)]
    assert same(both(TREE), {"below": chain, "leaf": [("n5000", 7)], "name": [("n0",)]}) == [("n0", 7)]


def test_many_keys(both: Load) -> None:
    """So many that the relation is derived as a whole."""
    names = [f"n{i}" for i in range(2000)]
    facts = {"below": [(n, f"{n}b") for n in names], "leaf": [(f"{n}b", i) for i, n in enumerate(names)], "name": [(n,) for n in names]}
    assert len(same(both(TREE), facts)) == 2000


def test_a_relation_that_is_derived_as_a_whole(both: Load) -> None:
    programs = both(TREE.replace(".decl holds(a: symbol, n: number)", ".decl holds(a: symbol, n: number) no_magic"))
    assert not tables(programs[1])
    facts = {"below": [("a", "b"), ("b", "c"), ("x", "y")], "leaf": [("c", 1), ("y", 3)], "name": [("a",), ("y",), ("z",)]}
    assert same(programs, facts) == [("a", 1), ("y", 3)]


def test_recursion_that_keeps_its_key(both: Load) -> None:
    programs = both(TREE.replace("r(A, N) :- asked(A), holds(A, N).", 'r(A, N) :- asked(A), leaf(A, N), holds("top", N).'))
    assert ("holds", (0, 1)) not in tables(programs[1])
    loops = both(
        """
.decl edge(a: number, b: number)
.input edge
.decl given(a: number)
.input given
.decl from(a: number)
from(A) :- given(A).
.decl path(a: number, b: number)
path(A, B) :- edge(A, B).
path(A, C) :- path(A, B), edge(B, C).
.decl r(a: number, b: number)
.output r
r(A, B) :- from(A), path(A, B).
"""
    )
    assert tables(loops[1]) == {("path", (0,))}
    assert same(loops, {"edge": [(1, 2), (2, 3), (3, 1), (4, 5)], "given": [(2,)]}) == [(2, 1), (2, 2), (2, 3)]


def test_negation_constants_records_and_aggregates(both: Load) -> None:
    programs = both(
        """
.type Pair = [a: number, b: number]
.decl e(a: number, b: number)
.input e
.decl d(a: number, b: number)
d(A, B) :- e(A, B).
.decl small(a: number)
small(A) :- e(A, B), B < 3.
.decl named(a: number, name: symbol)
named(A, "small") :- small(A).
named(A, "two") :- e(A, _), A = 2.
.decl pair(p: Pair, n: number)
pair([A, B], A + B) :- e(A, B).
.decl size(a: number, n: number)
size(A, N) :- e(A, _), N = count : { e(A, _) }.
.decl next(a: number, b: number)
next(A, A + 1) :- e(A, _).
.decl r(a: number, b: number)
.output r
r(A, 0) :- d(A, _), !small(A).
r(A, 1) :- d(A, _), named(A, "two").
r(A, N) :- d(A, B), P = [A, B], pair(P, N), N > 6.
r(A, N * 100) :- d(A, _), size(A, N).
r(A, 1000) :- d(A, _), next(B, A), d(B, _).
"""
    )
    assert {name for name, _ in tables(programs[1])} == {"small", "named", "pair", "size", "next"}
    assert same(programs, {"e": [(1, 2), (2, 2), (2, 5), (7, 4)]}) == [
        (1, 100), (2, 1), (2, 7), (2, 200), (2, 1000), (7, 0), (7, 11), (7, 100),
    ]  # fmt: skip


def test_what_is_gone_through_is_whole(both: Load) -> None:
    source = """
.decl e(a: number, b: number)
.input e
.decl d(a: number, b: number)
d(A, B) :- e(B, A).
.decl r(a: number)
.output r
r(A) :- d(A, _).
r(A) :- d(A, B), e(B, A).
"""
    programs = both(source)
    assert tables(programs[1]) == set()
    assert same(programs, {"e": [(1, 2)]}) == [(2,)]


def test_an_error_is_at_its_clause(both: Load) -> None:
    _, program = both(
        """.decl e(a: symbol)
.input e
.decl n(a: symbol, n: number)
n(A, to_number(A)) :- e(A).
.decl d(a: symbol)
d(A) :- e(A).
.decl r(a: symbol, n: number)
.output r
r(A, N) :- d(A), n(A, N).
"""
    )
    with pytest.raises(DatalogError, match=r"p.dl:4:1: .*`x`"):
        program.evaluate({"e": [("x",)]})


def test_other_rows_are_refused(both: Load) -> None:
    _, program = both(TREE)
    with pytest.raises(DatalogError, match="no rows of `holds`: the program derives those of its outputs only"):
        program.evaluate({}, keep=["holds"])
    with pytest.raises(DatalogError, match="no rows of `below`"):
        program.evaluate({}, keep="all")


KNOWN = """
.decl given(a: symbol)
.input given
.decl base(a: symbol, n: number)
base("one", 1).
base(cat("t", "wo"), N + 1) :- base("one", N).
.decl small(a: symbol, n: number)
small("one", 1). small("two", 2). small("three", 3).
.decl api(a: symbol, n: number)
api(cat(A, "!"), N) :- small(A, N), N < 3.
.decl chosen(a: symbol)
chosen(A) :- given(A).
.decl r(a: symbol, n: number)
.output r
r(A, N) :- chosen(A), api(A, N).
r(A, N) :- chosen(A), base(A, N).
"""


def test_what_no_input_has_a_part_in_is_known_when_it_is_compiled(both: Load) -> None:
    programs = both(KNOWN)
    assert same(programs, {"given": [("two!",), ("three!",), ("two",)]}) == [("two", 2), ("two!", 2)]
    code = programs[1].code
    assert code.facts["api"] == [("one!", 1), ("two!", 2)]
    targets = {rule.target for stratum in code.strata for rule in (*stratum.base, *stratum.loop)}
    assert "api" not in targets | {table.relation for table in code.tables}
    assert code.facts["base"] == [("one", 1)], "what is recursive has the limits of an evaluation"


def test_a_known_relation_that_cannot_be_derived_fails_in_the_evaluation(both: Load) -> None:
    programs = both(
        '.decl n(a: number)\nn(to_number("x")).\n.decl m(a: number)\nm(A + 1) :- n(A).\n.decl r(a: number)\n.output r\nr(A) :- m(A).\n'
    )
    for program in programs:
        with pytest.raises(DatalogError, match="to_number"):
            program.evaluate({})
