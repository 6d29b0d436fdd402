"""Queries over rows that are there."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from rosarch.datalog import DatalogError, Program, query, table_text
from rosarch.datalog.inspection.queries import check_query, table_values


@pytest.mark.parametrize(
    ("text", "columns", "rows"),
    [
        ('path(X, _), edge(X, Y), X != "a"', ("X", "Y"), [("b", "c"), ("c", "a"), ("c", "d")]),
        ("edge(X, Y), !blocked(Y).", ("X", "Y"), [("a", "b"), ("b", "c"), ("c", "a"), ("c", "d")]),
        ("edge(X, _), N = count : { edge(X, _) }, N > 1, M = N * 2", ("X", "N", "M"), [("c", 2, 4)]),
        ("edge(X, Y), blocked(Y); edge(Y, X), blocked(X)", ("X", "Y"), [("d", "e"), ("e", "d")]),
        ('edge(_From, X), match("[de]", X)', ("X",), [("d",), ("e",)]),
        ('path("a", "d")', (), [()]),
        ('path("a", "e")', (), []),
        ("P = [X, 1], blocked(X), P = [Y, _]", ("P", "X", "Y"), None),
    ],
)
def test_rows(graph: Program, graph_facts: Any, text: str, columns: tuple[str, ...], rows: Any) -> None:
    if rows is None:  # nothing says of which type the record is
        with pytest.raises(DatalogError, match="the type of this record is ambiguous"):
            query(graph, graph_facts, text)
        return
    table = query(graph, graph.evaluate(graph_facts, keep="all"), text)
    assert (table.columns, list(table.rows)) == (columns, rows)


def test_table(graph: Program, graph_facts: Any) -> None:
    table = query(graph, graph_facts, "degree(Node, N)")
    assert table.types == ("symbol", "number")
    assert table_text(table, graph) == "Node  N\n----  -\na     1\nb     1\nc     2\nd     1\n4 rows\n"
    assert table_text(table, graph, most=1) == "Node  N\n----  -\na     1\n... 3 more\n4 rows\n"
    assert table_text(query(graph, graph_facts, 'start("a")'), graph) == "yes\n"
    assert table_text(query(graph, graph_facts, 'start("b")'), graph) == "no\n"
    assert table_values(table)[0] == {"Node": "a", "N": 1}


def test_records_and_branches(load: Callable[[str], Program]) -> None:
    program = load(
        ".type N <: symbol\n.type P = [k: N, n: number]\n.type T = A {x: number} | B {}\n.decl p(p: P, t: T)\n"
        'p(["k", 1], $A(2)).\np(["l", 2], $B()).\n'
    )
    table = query(program, {}, "p(P, T), P = [K, I], I > 0")
    assert (table.columns, table.types) == (("P", "T", "K", "I"), ("P", "T", "N", "number"))
    assert table_text(table, program) == "P       T      K  I\n------  -----  -  -\n[k, 1]  $A(2)  k  1\n[l, 2]  $B     l  2\n2 rows\n"
    assert table_values(table)[0] == {"P": ["k", 1], "T": ["A", 2], "K": "k", "I": 1}
    assert query(program, {}, "p([K, 1], $A(X))").rows == (("k", 2),)


def test_a_relation_called_query(load: Callable[[str], Program]) -> None:
    assert query(load(".decl query(x: number)\nquery(1).\n"), {}, "query(X)").rows == ((1,),)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("pth(X)", "<query>:1:1: unknown relation `pth`, did you mean `path`?\n    pth(X)\n    ^"),
        ("edge(X)", "<query>:1:1: `edge` has 2 attributes, given 1, declared `edge(a, b)`\n    edge(X)\n    ^"),
        ('!edge(X, "a")', '<query>:1:7: ungrounded variable `X` in a negation\n    !edge(X, "a")\n          ^'),
        ("edge(X, 1)", "<query>:1:9: numeric constant where `symbol` (`edge.b`) is expected\n    edge(X, 1)\n            ^"),
        ("edge(X", "<query>:1:7: syntax error, unexpected end of the query, expected `,` or `)`\n    edge(X\n          ^"),
        (
            "edge(X, Y). path(X, Y)",
            "<query>:1:1: a query is one rule body, such as `edge(X, Y), X != Y`\n    edge(X, Y). path(X, Y)\n    ^",
        ),
        (
            "edge(X, Y), degree(Y, X)",
            "<query>:1:6: no type fits variable `X`, `symbol` in `edge` but `number` in `degree`\n    edge(X, Y), degree(Y, X)\n         ^",
        ),
    ],
)
def test_errors(graph: Program, text: str, expected: str) -> None:
    for ask in (lambda: query(graph, {}, text), lambda: check_query(graph, text)):
        with pytest.raises(DatalogError) as caught:
            ask()
        assert str(caught.value) == expected
