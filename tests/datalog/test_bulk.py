"""Large relations on bitmaps: the same rows as on sets of tuples, whatever reads them afterwards."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pyroaring import BitMap

from rosarch.datalog import Program, profile
from rosarch.datalog.engine import bulk, engine
from rosarch.datalog.files.row_text import line_chunks

EDGE = ".decl e(a: symbol, b: symbol)\n.input e\n.decl f(a: symbol, b: symbol)\n.input f\n"
RULES = {
    "left": "p(x, y) :- e(x, y).\np(x, z) :- p(x, y), e(y, z).",
    "right": "p(x, y) :- e(x, y).\np(x, z) :- e(x, y), p(y, z).",
    "nonlinear": "p(x, y) :- e(x, y).\np(x, z) :- p(x, y), p(y, z).",
    "same generation": "p(x, y) :- e(a, x), e(a, y), x != y.\np(x, y) :- e(a, x), p(a, b), e(b, y), x != y.",
    "turned": "p(x, y) :- e(x, y).\np(y, x) :- p(x, y), f(y, x).\np(y, z) :- p(z, x), e(x, y).",
    "filtered": "p(x, y) :- e(x, y).\np(x, z) :- p(x, y), p(y, z), f(z, x).",
    "product": "p(x, y) :- e(x, y).\np(x, z) :- p(x, y), f(y, w), p(w, v), e(v, z), y != v.",
    "cartesian": "p(x, y) :- e(x, y).\np(x, z) :- p(x, _a), f(_a, x), e(z, _b), f(_b, z).",
    "mutual": ".decl q(a: symbol, b: symbol)\n.output q\np(x, y) :- e(x, y).\nq(x, z) :- p(x, y), f(y, z).\np(z, x) :- q(x, y), q(y, z).\np(x, y) :- q(y, x).",
}
READERS = """
.decl isolated(a: symbol, b: symbol)
.output isolated
isolated(x, y) :- e(x, _), e(_, y), !p(x, y).
.decl sources(b: symbol, n: number)
.output sources
sources(b, n) :- e(_, b), n = count : { p(_, b) }.
.decl steps(a: symbol, b: symbol)
.output steps
steps(x, z) :- f(x, y), p(y, z).
.decl ends(a: symbol)
.output ends
ends(x) :- e(x, _), !p(x, _).
.decl again(a: symbol, b: symbol)
.output again
again(x, y) :- f(x, y).
again(x, z) :- again(x, y), p(y, z).
"""
PAIRS = st.sets(st.tuples(st.sampled_from("abcde"), st.sampled_from("abcde")), max_size=14)


@pytest.fixture
def always(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Bitmaps are taken after the first sweep; the list has an entry for each time."""
    taken: list[int] = []
    start = bulk.BulkLoop.__init__

    def count(self: bulk.BulkLoop, *args: Any) -> None:
        taken.append(1)
        start(self, *args)

    monkeypatch.setattr(bulk.BulkLoop, "__init__", count)
    monkeypatch.setattr(engine, "MANY_ROWS", 1)
    monkeypatch.setattr(bulk, "worthwhile", lambda rows: True)
    return taken


def rows(program: Program, facts: Any) -> dict[str, Any]:
    result = program.evaluate(facts)
    return result.all_rows()


@pytest.mark.parametrize("name", RULES)
def test_same_rows(load: Callable[[str], Program], always: list[int], name: str) -> None:
    program = load(EDGE + ".decl p(a: symbol, b: symbol)\n.output p\n" + RULES[name] + READERS)
    never = pytest.MonkeyPatch()

    @given(e=PAIRS, f=PAIRS)
    @settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
    def check(e: set[tuple[str, str]], f: set[tuple[str, str]]) -> None:
        facts = {"e": sorted(e), "f": sorted(f)}
        with_bitmaps = rows(program, facts)
        with never.context() as patch:
            patch.setattr(engine, "MANY_ROWS", 1 << 30)
            assert with_bitmaps == rows(program, facts)

    check()
    assert always


def test_taken_by_itself_when_rows_are_many(load: Callable[[str], Program], monkeypatch: pytest.MonkeyPatch) -> None:
    finished: list[int] = []
    finish = bulk.BulkLoop.finish
    monkeypatch.setattr(bulk.BulkLoop, "finish", lambda self: (finished.append(1), finish(self)))
    program = load(".decl e(a: number, b: number)\n.input e\n.decl p(a: number, b: number)\n.output p\n" + RULES["left"])
    size = 400
    result = program.evaluate({"e": [(-i, -i - 1) for i in range(size)]})
    assert result.count("p") == size * (size + 1) // 2
    assert result.rows("p")[0] == (-size + 1, -size)
    assert finished


def test_text_of_bitmaps_is_that_of_rows(load: Callable[[str], Program], always: list[int]) -> None:
    program = load(EDGE + ".decl p(a: symbol, b: symbol)\n.output p\n" + RULES["left"])
    result = program.evaluate({"e": [("b", "a"), ("a", "c"), ("c", "b")]})
    assert always
    expected = "".join(f"{a}\t{b}\n" for a in "abc" for b in "abc")
    assert "".join(result.lines("p", [str, str])) == expected
    assert "".join(line_chunks(set(result.rows("p")), [str, str])) == expected


def test_profile_counts_bulk_rules(load: Callable[[str], Program], always: list[int]) -> None:
    program = load(EDGE + ".decl p(a: symbol, b: symbol)\n.output p\n" + RULES["left"])
    found = profile(program, {"e": [("a", "b"), ("b", "c"), ("c", "d")]})
    assert always
    assert found.result.count("p") == 6
    assert max(rule.calls for rule in found.rules) > 1


def test_row_limit_holds_on_bitmaps(load: Callable[[str], Program], always: list[int]) -> None:
    program = load(EDGE + ".decl p(a: symbol, b: symbol)\n.output p\n" + RULES["left"])
    facts = {"e": [(str(i), str(i + 1)) for i in range(50)]}
    with pytest.raises(Exception, match="more than 500 rows"):
        program.evaluate(facts, limit_rows=500)
    assert always


NUMBERS = """.decl n(x: number)
.output n
n(0).
n(x + 1) :- n(x), x < 3000.
.decl below(x: number)
.output below
below(x) :- n(x), x % 1000 = 0, !n(x - 1).
.decl odd(x: number)
.output odd
odd(x) :- n(x), x % 2 = 1.
odd(-x) :- odd(x), x > 0.
"""


def test_numbers_on_bitmaps_and_negative_ones_off_them(load: Callable[[str], Program], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine, "MANY_ROWS", 100)
    packed: list[int] = []
    pack = engine.Evaluation._pack

    def count(self: engine.Evaluation, members: Any) -> bool:
        found = pack(self, members)
        packed.extend(len(rows) for rows in self.slots if isinstance(rows, BitMap))
        return found

    monkeypatch.setattr(engine.Evaluation, "_pack", count)
    result = load(NUMBERS).evaluate({})
    assert packed
    assert result.rows("n") == [(i,) for i in range(3001)]
    assert result.rows("below") == [(0,)]
    assert result.rows("odd") == [(i,) for i in range(-2999, 3000, 2)]
