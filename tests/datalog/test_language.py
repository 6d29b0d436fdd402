"""One small program per feature of the language, with the rows it derives."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

Rows = Callable[..., list[tuple[Any, ...]]]

NUMBERS = ".decl n(x: number)\nn(1). n(2). n(3).\n"
EDGES = '.decl e(a: symbol, b: symbol)\ne("a", "b"). e("b", "c"). e("c", "d").\n'


@pytest.mark.parametrize(
    ("type_name", "expression", "value"),
    [
        ("number", "1 + 2 * 3", 7),
        ("number", "(1 + 2) * 3", 9),
        ("number", "7 - 2 - 1", 4),
        ("number", "2 ^ 3 ^ 2", 512),
        ("number", "-2 ^ 2", -4),
        ("number", "-(2 ^ 2)", -4),
        ("number", "-7 / 2", -3),
        ("number", "-7 % 3", -1),
        ("number", "7 % -3", 1),
        ("number", "2147483647 + 1", -2147483648),
        ("number", "-2147483648 - 1", 2147483647),
        ("number", "65536 * 65536", 0),
        ("number", "0xff band 0b1010", 10),
        ("number", "12 bor 3", 15),
        ("number", "12 bxor 10", 6),
        ("number", "1 bshl 4", 16),
        ("number", "1 bshl 33", 2),
        ("number", "-8 bshr 1", -4),
        ("number", "-8 bshru 1", 2147483644),
        ("number", "bnot 0", -1),
        ("number", "2 land 0", 0),
        ("number", "2 lor 0", 1),
        ("number", "2 lxor 3", 0),
        ("number", "lnot 5", 0),
        ("number", 'strlen("häh")', 4),
        ("number", 'to_number("42")', 42),
        ("number", "to_number(3.99)", 3),
        ("number", "max(1, 5, 3)", 5),
        ("number", "min(4, 2, 3)", 2),
        ("number", "127.0.0.1", 2130706433),
        ("number", "as(7, number)", 7),
        ("unsigned", "4294967295 + 1", 0),
        ("unsigned", "0 - 1", 4294967295),
        ("unsigned", "7u / 2u", 3),
        ("unsigned", "to_unsigned(-1)", 4294967295),
        ("float", "1.5 + 2.25", 3.75),
        ("float", "1.0 / 4.0", 0.25),
        ("float", "to_float(3)", 3.0),
        ("float", 'to_float("2.5")', 2.5),
        ("float", "1", 1.0),
        ("symbol", 'cat("a", "b", "c")', "abc"),
        ("symbol", '"a" + "b"', "ab"),
        ("symbol", 'substr("rosarch", 3, 4)', "arch"),
        ("symbol", 'substr("abc", 5, 1)', ""),
        ("symbol", "to_string(-12)", "-12"),
        ("symbol", "to_string(3.14)", "3.140000"),
        ("symbol", 'min("b", "a")', "a"),
        ("symbol", r'"q\"t\\n\n"', 'q"t\\n\n'),
    ],
)
def test_expression(rows: Rows, type_name: str, expression: str, value: object) -> None:
    assert rows(f".decl r(x: {type_name})\nr({expression}).\n") == [(value,)]


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("n(x), x = 2", [2]),
        ("n(x), x != 2", [1, 3]),
        ("n(x), x < 2", [1]),
        ("n(x), x <= 2", [1, 2]),
        ("n(x), x > 2", [3]),
        ("n(x), 2 <= x", [2, 3]),
        ("n(x), !(x = 1)", [2, 3]),
        ("n(x), !(x = 1 ; x = 3)", [2]),
        ("(n(x), x = 1 ; n(y), x = y + 10)", [1, 11, 12, 13]),
        ("n(x), true", [1, 2, 3]),
        ("n(x), false", []),
        ("n(y), x = y * 2, x > 2", [4, 6]),
        ("n(y), x - 1 = y, n(x)", [2, 3]),
        ("n(x), n(x + 1)", [1, 2]),
        ("n(x), !n(x + 1)", [3]),
        ("x = range(0, 3)", [0, 1, 2]),
        ("x = range(3, 0)", [1, 2, 3]),
        ("x = range(0, 6, 2)", [0, 2, 4]),
        ("n(x), x = range(2, 9)", [2, 3]),
        ("n(_), x = 5", [5]),
        ("n(?x), x = ?x", [1, 2, 3]),
        ("x = 1, n(_x), _x = x", [1]),
    ],
)
def test_body(rows: Rows, body: str, expected: list[int]) -> None:
    assert rows(f"{NUMBERS}.decl r(x: number)\nr(x) :- {body}.\n") == [(x,) for x in expected]


@pytest.mark.parametrize(
    ("aggregate", "expected"),
    [
        ("count : { n(_) }", [3]),
        ("count : n(_)", [3]),
        ("sum x : { n(x) }", [6]),
        ("min x : { n(x) }", [1]),
        ("max x + 1 : { n(x) }", [4]),
        ("count : { n(x), x > 5 }", [0]),
        ("sum x : { n(x), x > 5 }", [0]),
        ("max x : { n(x), x > 5 }", []),
        ("count : { n(x), n(y), x < y }", [3]),
        ("sum x : { n(x), x < max y : { n(y) } }", [3]),
        ("1 + count : { n(_) } * 2", [7]),
        ("count : { n(x), !n(x + 1) }", [1]),
    ],
)
def test_aggregate(rows: Rows, aggregate: str, expected: list[int]) -> None:
    assert rows(f"{NUMBERS}.decl r(x: number)\nr(v) :- v = {aggregate}.\n") == [(x,) for x in expected]


def test_aggregate_with_outer_variable(rows: Rows) -> None:
    program = '.decl p(k: symbol, v: number)\np("a", 1). p("a", 2). p("b", 5).\n.decl r(k: symbol, c: number, s: number)\n'
    program += "r(k, c, s) :- p(k, _), c = count : { p(k, _) }, s = sum v : { p(k, v) }.\n"
    assert rows(program) == [("a", 2, 3), ("b", 1, 5)]


def test_aggregate_over_several_atoms_ignores_unnamed_columns(rows: Rows) -> None:
    program = ".decl p(x: number, y: number)\np(1, 1). p(1, 2).\n.decl r(n: symbol, c: number)\n"
    program += 'r("one", c) :- c = count : { p(_, _) }.\nr("two", c) :- c = count : { p(x, _), p(x, _) }.\n'
    assert rows(program) == [("one", 2), ("two", 1)]


def test_mean_is_a_float(rows: Rows) -> None:
    assert rows(".decl f(x: float)\nf(1). f(2).\n.decl r(x: float)\nr(m) :- m = mean x : { f(x) }.\n") == [(1.5,)]


def test_witness_of_an_aggregate(rows: Rows) -> None:
    program = '.decl p(k: symbol, v: number)\np("a", 1). p("b", 5). p("c", 5).\n.decl r(k: symbol, v: number)\n'
    assert rows(program + "r(k, v) :- v = max x : { p(k, x) }.\n") == [("b", 5), ("c", 5)]


def test_recursion(rows: Rows) -> None:
    program = EDGES + ".decl r(a: symbol, b: symbol)\nr(x, y) :- e(x, y).\nr(x, z) :- r(x, y), r(y, z).\n"
    assert rows(program) == [(a, b) for a, b in [*zip("aaabbc", "bcdcdd", strict=True)]]


def test_mutual_recursion(rows: Rows) -> None:
    program = ".decl even(x: number)\n.decl r(x: number)\neven(0).\nr(x + 1) :- even(x), x < 9.\neven(x + 1) :- r(x).\n"
    assert rows(program) == [(1,), (3,), (5,), (7,), (9,)]


def test_negation_of_a_lower_stratum(rows: Rows) -> None:
    program = EDGES + ".decl r(x: symbol)\nr(x) :- e(x, _), !e(_, x).\n"
    assert rows(program) == [("a",)]


def test_several_heads_and_constants_in_atoms(rows: Rows) -> None:
    program = EDGES + '.decl r(x: symbol)\n.decl s(x: symbol)\nr(x), s(x) :- e("a", x).\nr(x) :- s(y), e(y, x).\n'
    assert rows(program) == [("b",), ("c",)]


def test_repeated_variable_in_an_atom(rows: Rows) -> None:
    program = ".decl p(x: number, y: number)\np(1, 1). p(1, 2). p(3, 3).\n.decl r(x: number)\nr(x) :- p(x, x).\n"
    assert rows(program) == [(1,), (3,)]


def test_nullary_relations(rows: Rows) -> None:
    assert rows(".decl a()\n.decl b()\na().\n.decl r()\nr() :- a(), !b().\n") == [()]


def test_match_and_contains(rows: Rows) -> None:
    program = '.decl s(x: symbol)\ns("/scan"). s("/cmd_vel"). s("scan").\n.decl r(x: symbol)\n'
    assert rows(program + 'r(x) :- s(x), match("/[a-z]+", x).\n') == [("/scan",)]
    assert rows(program + 'r(x) :- s(x), contains("scan", x), !match("/.*", x).\n') == [("scan",)]
    assert rows(program + 'r(x) :- s(x), match("(", x).\n') == []


def test_records(rows: Rows) -> None:
    program = """
.type List = [head: number, tail: List]
.decl list(l: List)
list(nil).
list([x, l]) :- list(l), x = range(0, 2), (l = nil ; l = [y, _], y < x).
.decl r(l: List)
r(l) :- list(l), l != nil.
"""
    assert rows(program) == [((0, None),), ((1, None),), ((1, (0, None)),)]


def test_record_patterns(rows: Rows) -> None:
    program = """
.type Pair = [a: number, b: symbol]
.decl p(x: Pair)
p([1, "x"]). p([2, "y"]). p(nil).
.decl r(a: number, b: symbol)
r(a, b) :- p([a, b]), a > 1.
r(a, "again") :- p(x), x = [a, "x"].
"""
    assert rows(program) == [(1, "again"), (2, "y")]


def test_algebraic_data_types(rows: Rows) -> None:
    program = """
.type Expr = Number {x: number} | Add {l: Expr, r: Expr} | Unknown {}
.decl expr(e: Expr)
expr($Add($Number(1), $Add($Number(2), $Number(3)))).
expr($Unknown()).
expr(l), expr(s) :- expr($Add(l, s)).
.decl value(e: Expr, v: number)
value(e, x) :- expr(e), e = $Number(x).
value(e, x + y) :- expr(e), e = $Add(l, s), value(l, x), value(s, y).
.decl r(e: Expr, v: number)
r(e, v) :- value(e, v), v > 2.
"""
    add = ("Add", ("Number", 2), ("Number", 3))
    assert rows(program) == [(("Add", ("Number", 1), add), 6), (add, 5), (("Number", 3), 3)]


def test_subtypes_and_unions(rows: Rows) -> None:
    program = """
.type A <: symbol
.type B <: symbol
.type AB = A | B
.decl a(x: A)
.decl b(x: B)
a("1"). b("2").
.decl r(x: AB)
r(x) :- a(x).
r(x) :- b(x).
"""
    assert rows(program) == [("1",), ("2",)]


def test_equivalence_relation(rows: Rows) -> None:
    program = ".decl r(x: number, y: number) eqrel\nr(1, 2). r(2, 3).\n"
    assert rows(program) == [(x, y) for x in (1, 2, 3) for y in (1, 2, 3)]


def test_choice_domain_takes_the_first_row_in_sorted_order(rows: Rows) -> None:
    program = NUMBERS + ".decl r(x: number, y: number) choice-domain x\nr(1, y) :- n(y).\nr(2, 7).\n"
    assert rows(program) == [(1, 1), (2, 7)]


def test_subsumption_keeps_undominated_rows(rows: Rows) -> None:
    program = (
        EDGES
        + """
.decl r(x: symbol, d: number) btree_delete
r("a", 0).
r(y, d + 1) :- r(x, d), e(x, y), d < 10.
r("c", 9).
r(x, d1) <= r(x, d2) :- d2 < d1.
"""
    )
    assert rows(program) == [("a", 0), ("b", 1), ("c", 2), ("d", 3)]


def test_counter_numbers_rows_in_sorted_order(rows: Rows) -> None:
    program = EDGES + ".decl r(i: number, x: symbol)\nr(autoinc(), x) :- e(x, _).\n"
    assert rows(program) == [(0, "a"), (1, "b"), (2, "c")]


def test_components(rows: Rows) -> None:
    program = """
.comp Base<T> {
    .decl edge(a: T, b: T)
    .decl reach(a: T, b: T) overridable
    reach(x, y) :- edge(x, y).
    reach(x, z) :- reach(x, y), edge(y, z).
}
.comp Direct : Base<symbol> {
    .override reach
    reach(x, y) :- edge(x, y).
}
.init all = Base<symbol>
.init direct = Direct
all.edge("a", "b"). all.edge("b", "c").
direct.edge(x, y) :- all.edge(x, y).
.decl r(from: symbol, a: symbol, b: symbol)
r("all", x, y) :- all.reach(x, y).
r("direct", x, y) :- direct.reach(x, y).
"""
    assert rows(program) == [
        ("all", "a", "b"),
        ("all", "a", "c"),
        ("all", "b", "c"),
        ("direct", "a", "b"),
        ("direct", "b", "c"),
    ]


def test_comments(rows: Rows) -> None:
    program = '// one\n/* two\n * three */ .decl r(x: symbol) // four\nr("// not a comment"). /**/\n'
    assert rows(program) == [("// not a comment",)]


def test_constraints_guard_partial_functors(rows: Rows) -> None:
    program = '.decl s(x: symbol)\ns("12"). s("x").\n.decl r(x: number)\nr(n) :- n = to_number(x), s(x), match("[0-9]+", x).\n'
    assert rows(program) == [(12,)]


def test_input_relations_may_have_rules(rows: Rows) -> None:
    program = ".decl r(x: number)\n.input r\nr(x + 1) :- r(x), x < 3.\n"
    assert rows(program, {"r": [(1,)]}) == [(1,), (2,), (3,)]


def test_more_atoms_than_python_nests_loops(rows: Rows) -> None:
    chain = ", ".join(f"e(x{i}, x{i + 1})" for i in range(25))
    source = ".decl e(a: number, b: number)\n.input e\n.decl r(a: number, b: number)\nr(x0, x25) :- " + chain + ".\n"
    assert rows(source, {"e": [(n, n + 1) for n in range(26)]}) == [(0, 25), (1, 26)]


def test_witness_inside_a_nested_aggregate(rows: Rows) -> None:
    program = ".decl b(x: number, y: number)\nb(2, 1). b(2, 2).\n.decl d(x: number, y: number)\nd(1, 1). d(1, 2). d(3, 0).\n"
    program += ".decl r(c: number, w: number)\nr(c, w) :- c = count : { b(x, _), x < max y : { d(y, w) } }.\n"
    assert rows(program) == [(1, 0)]
