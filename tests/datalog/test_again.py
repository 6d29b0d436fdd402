"""Evaluations one after the other, which take over rows: always those of an evaluation from the beginning, and nothing is run for nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import pytest

from rosarch.datalog import DatalogError, Program, load_program
from rosarch.datalog.engine.engine import Evaluation
from rosarch.datalog.engine.plan import Stratum

Facts = Mapping[str, Iterable[tuple[Any, ...]]]
Load = Callable[..., Program]


@pytest.fixture
def load(tmp_path: Path) -> Load:
    def from_text(source: str, *, on_demand: bool = False) -> Program:
        path = tmp_path / "p.dl"
        path.write_text(source, encoding="utf-8")
        return load_program(path, on_demand=on_demand)

    return from_text


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The relations whose strata are run."""
    names: list[str] = []
    original = Evaluation.run_stratum

    def noted(evaluation: Evaluation, stratum: Stratum) -> None:
        names.extend(member.name for member in stratum.members)
        original(evaluation, stratum)

    monkeypatch.setattr(Evaluation, "run_stratum", noted)
    return names


def agree(program: Program, each: Iterable[Facts]) -> None:
    with program.series() as evaluate:
        for facts in each:
            assert evaluate(facts).all_rows() == program.evaluate(facts).all_rows()


PATHS = """
.decl edge(a: number, b: number)
.input edge
.decl closed(a: number)
.input closed
.decl path(a: number, b: number)
path(A, B) :- edge(A, B), !closed(A).
path(A, C) :- path(A, B), edge(B, C), !closed(B).
.decl pair(p: Pair)
.type Pair = [a: number, b: number]
pair([A, B]) :- path(A, B), A < B.
.decl degree(a: number, n: number)
degree(A, count : { path(A, _) }) :- edge(A, _).
.decl goal(a: number)
.input goal
.decl r(a: number, b: number)
.output r
r(A, B) :- goal(A), pair([A, B]).
r(A, N) :- goal(A), degree(A, N).
r(A, 0) :- closed(A).
"""
EDGES = {(1, 2), (2, 3), (3, 1), (3, 4)}


@pytest.mark.parametrize("on_demand", [False, True])
def test_the_rows_are_those_of_evaluations_from_the_beginning(load: Load, on_demand: bool) -> None:
    agree(
        load(PATHS, on_demand=on_demand),
        [
            {"edge": EDGES, "goal": {(1,)}},
            {"edge": EDGES, "goal": {(1,), (3,)}},
            {"edge": EDGES, "goal": {(1,)}, "closed": {(2,)}},
            {"edge": [*EDGES, (4, 5)], "goal": {(1,), (3,)}},
            {"goal": {(1,)}},
            {"edge": EDGES, "goal": {(1,)}},
        ],
    )


def test_what_a_change_does_not_reach_is_not_run(load: Load, run: list[str]) -> None:
    with load(PATHS).series() as evaluate:
        evaluate({"edge": EDGES, "goal": {(1,)}}).rows("r")
        run.clear()
        evaluate({"edge": EDGES, "goal": {(3,)}}).rows("r")
        assert run == ["r"]


def test_what_comes_to_the_same_rows_changes_nothing(load: Load, run: list[str]) -> None:
    program = load(
        ".decl e(a: number)\n.input e\n.decl some()\nsome() :- e(_).\n.decl r(a: number)\n.output r\nr(1) :- some().\n.output some\n"
    )
    with program.series() as evaluate:
        evaluate({"e": {(1,)}}).all_rows()
        run.clear()
        assert evaluate({"e": {(2,)}}).rows("r") == [(1,)]
        assert run == ["some"]
        assert evaluate({}).rows("r") == []


TWO = """
.decl e(a: number)
.input e
.decl first(a: number)
first(A + 1) :- e(A).
.output first
.decl other(a: number)
other(A) :- first(A), A > 2.
.output other
"""


def test_only_what_is_asked_for_is_run(load: Load, run: list[str]) -> None:
    with load(TWO).series() as evaluate:
        found = evaluate({"e": {(1,)}})
        assert run == []
        assert found.rows("first") == [(2,)]
        assert run == ["first"]
        assert found.by_relation()["other"] == []
        assert run == ["first", "other"]


def test_what_was_not_asked_for_before_is_run_when_it_is(load: Load, run: list[str]) -> None:
    """Also when it is asked for before in the meantime: an evaluation goes by what was there when it began."""
    with load(TWO).series() as evaluate:
        before = evaluate({"e": {(1,)}})
        assert before.rows("first") == [(2,)]
        after, later = evaluate({"e": {(2,)}}), evaluate({"e": {(1,)}})
        assert before.rows("other") == []
        assert after.rows("other") == [(3,)]
        run.clear()
        assert later.rows("other") == []
        assert run == ["other"]


def test_what_was_left_out_in_between_is_taken_over_from_further_back(load: Load, run: list[str]) -> None:
    source = TWO + ".decl g(a: number)\n.input g\n.decl apart(a: number)\n.output apart\napart(A) :- g(A), A > 0.\n"
    with load(source).series() as evaluate:
        kept = [evaluate({"e": {(1,)}, "g": {(1,)}})]
        assert kept[0].rows("first") == [(2,)] and kept[0].rows("apart") == [(1,)]
        kept.append(evaluate({"e": {(2,)}, "g": {(1,)}}))
        assert kept[1].rows("first") == [(3,)]
        run.clear()
        last = evaluate({"e": {(2,)}, "g": {(1,)}})
        assert last.rows("apart") == [(1,)] and last.rows("first") == [(3,)]
        assert run == []
        assert evaluate({"e": {(2,)}, "g": {(7,)}}).rows("apart") == [(7,)]


def test_rows_by_relation_are_those_of_all_that_are_kept(load: Load) -> None:
    with load(TWO).series() as evaluate:
        found = evaluate({"e": {(5,)}})
        assert found.by_relation() == {"first": [(6,)], "other": [(6,)]}
        assert "e" not in found.by_relation()


ASKED = """
.decl below(a: number, b: number)
.input below
.decl name(a: number)
.input name
.decl asked(a: number)
asked(A) :- name(A).
.decl holds(a: number, n: number)
.decl r(a: number, n: number)
.output r
r(A, N) :- asked(A), holds(A, N).
"""


def test_a_table_that_changes_reach_is_asked_anew(load: Load) -> None:
    """`holds` is derived on demand; after many keys, as a whole."""
    source = """
.decl leaf(a: number, n: number)
.input leaf
holds(A, N) :- leaf(A, N).
holds(A, N) :- below(A, B), holds(B, N).
"""
    tree = {(n, 2 * n + k) for n in range(1, 50) for k in (0, 1)}
    all_ = {(n,) for n in range(1, 100)}
    agree(
        load(ASKED + source, on_demand=True),
        [
            {"below": tree, "leaf": {(77, 1)}, "name": {(1,)}},
            {"below": tree, "leaf": {(77, 1)}, "name": all_},
            {"below": tree, "leaf": {(77, 1), (50, 2)}, "name": all_},
            {"below": tree, "leaf": {(50, 2)}, "name": {(1,), (2,)}},
        ],
    )


def test_a_table_that_nothing_asked_before_is_asked_anew(load: Load) -> None:
    """`holds` is derived on demand; in the evaluation before only what it is derived from was run."""
    source = """
.decl above(a: number, b: number)
.output above
above(B, A) :- below(A, B).
holds(A, B) :- above(A, B).
holds(A, C) :- above(A, B), holds(B, C).
"""
    with load(ASKED + source, on_demand=True).series() as evaluate:
        assert evaluate({"below": {(1, 2)}, "name": {(2,)}}).rows("r") == [(2, 1)]
        assert evaluate({"below": {(1, 2), (0, 1)}, "name": {(2,)}}).rows("above") == [(1, 0), (2, 1)]
        assert evaluate({"below": {(1, 2), (0, 1)}, "name": {(2,), (1,)}}).rows("r") == [(1, 0), (2, 0), (2, 1)]


def test_subsumption_choices_and_equivalences(load: Load) -> None:
    source = """
.decl e(a: number, b: number)
.input e
.decl least(a: number, b: number) btree_delete
least(A, B) :- e(A, B).
least(A, B) <= least(A, C) :- C <= B.
.decl one(a: number, b: number) choice-domain a
one(A, B) :- e(A, B).
.decl alike(a: number, b: number) eqrel
alike(A, B) :- e(A, B).
.output least
.output one
.output alike
"""
    agree(load(source), [{"e": EDGES}, {"e": {*EDGES, (1, 1)}}, {"e": {(3, 0)}}, {"e": EDGES}])


def test_facts_of_derived_relations_and_of_the_program(load: Load) -> None:
    source = ".decl e(a: number)\n.input e\ne(7).\ne(A + 1) :- e(A), A < 3.\n.decl r(a: number)\n.output r\nr(A) :- e(A).\n"
    agree(load(source), [{"e": {(1,)}}, {"e": {(2,)}}, {}, {"e": [(1,)]}])


def test_counters_count_from_the_beginning(load: Load) -> None:
    source = ".decl e(a: number)\n.input e\n.decl r(n: number, a: number)\n.output r\nr(autoinc(), A) :- e(A).\n"
    agree(load(source), [{"e": {(1,)}}, {"e": {(5,)}}])


def test_nothing_is_taken_over_from_an_evaluation_that_failed(load: Load) -> None:
    program = load(".decl e(a: symbol)\n.input e\n.decl r(n: number)\n.output r\nr(to_number(A)) :- e(A).\n")
    with program.series() as evaluate:
        with pytest.raises(DatalogError):
            evaluate({"e": {("x",)}}).rows("r")
        assert evaluate({"e": {("4",)}}).rows("r") == [(4,)]
