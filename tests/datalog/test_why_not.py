"""Why a row is not there, by exact text."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosarch.datalog import DatalogError, Program, why_not, why_not_text


def text(program: Program, facts: Any, goal: str) -> str:
    return why_not_text(why_not(program, facts, goal), lambda path: Path(path).name)


BASE = "path(X, Y) :- edge(X, Y), !blocked(Y)."
STEP = "path(X, Z) :- path(X, Y), edge(Y, Z), !blocked(Z), X != Z."


@pytest.mark.parametrize(
    ("goal", "expected"),
    [
        (
            "path(a, e)",
            f"""path("a", "e") is not there; 2 rules for `path`:
p.dl:8: {BASE}
  no row   edge("a", "e")
  nearest  edge("a", "b")
  nearest  edge("d", "e")
p.dl:9: {STEP}
  fails    !blocked("e")
  present  blocked("e")
nearest rows:
  path("a", "b")
  path("a", "c")
  path("a", "d")
""",
        ),
        (
            "path(a, a)",
            f"""path("a", "a") is not there; 2 rules for `path`:
p.dl:8: {BASE}
  no row   edge("a", "a")
  nearest  edge("a", "b")
  nearest  edge("c", "a")
p.dl:9: {STEP}
  holds    !blocked("a")
  fails    "a" != "a"
nearest rows:
  path("a", "b")
  path("a", "c")
  path("a", "d")
""",
        ),
        (
            "path(z, _)",
            f"""path("z", _) is not there; 2 rules for `path`:
p.dl:8: {BASE}
  no row   edge("z", Y)
p.dl:9: {STEP}
  no row   path("z", Y)
""",
        ),
        (
            "degree(a, 2)",
            """degree("a", 2) is not there; 1 rule for `degree`:
p.dl:11: degree(X, N) :- edge(X, _), N = count : { edge(X, _) }.
  fails    2 = count : { edge("a", _) }
           the aggregate is 1
nearest rows:
  degree("a", 1)
  degree("c", 2)
""",
        ),
        (
            "hub(a, _)",
            """hub("a", _) is not there; 1 rule for `hub`:
p.dl:13: hub(X, N + 1) :- degree(X, N), N >= max M : { degree(_, M) }.
  holds    degree("a", 1)
  fails    1 >= max M : { degree(_, M) }
           the aggregate is 2
""",
        ),
        (
            "hub(c, 4)",
            """hub("c", 4) is not there; 1 rule for `hub`:
p.dl:13: hub(X, N + 1) :- degree(X, N), N >= max M : { degree(_, M) }.
  holds    2 >= max M : { degree(_, M) }
  holds    degree("c", 2)
  differs  hub("c", 2 + 1)
nearest rows:
  hub("c", 3)
""",
        ),
        ("edge(a, c)", '''edge("a", "c") is not there; `edge` is an input relation
nearest rows:
  edge("a", "b")
  edge("b", "c")
'''),
        ("start(b)", '''start("b") is not there; 1 rule for `start`:
p.dl:15: start("a").
  differs  start("a")
'''),
        ("path(a, d)", 'path("a", "d") is there; `explain` shows why\n'),
        ("path(a, _)", 'path("a", "b") and 2 more is there; `explain` shows why\n'),
    ],
)  # fmt: skip
def test_texts(graph: Program, graph_facts: Any, goal: str, expected: str) -> None:
    assert text(graph, graph_facts, goal) == expected


def test_the_longest_prefix_and_the_nearest_attempt(load: Callable[[str], Program]) -> None:
    program = load(
        ".decl publisher(n: symbol, t: symbol)\n.input publisher\n.decl type(t: symbol, m: symbol, q: number)\n.input type\n"
        ".decl r(n: symbol, m: symbol)\nr(N, M) :- publisher(N, T), type(T, M, 1).\n"
    )
    facts = {"publisher": [("n", "t1"), ("n", "t2"), ("n", "t3")], "type": [("t2", "Int", 2), ("t3", "Float", 2)]}
    found = why_not(program, facts, "r(n, Int)")
    assert why_not_text(found).splitlines()[2:] == [
        '  holds    publisher("n", "t2")',
        '  no row   type("t2", "Int", 1)  (nearest of 3 bindings)',
        '  nearest  type("t2", "Int", 2)',
    ]
    failure = found.failures[0]
    assert (failure.reason, failure.attempts, failure.location.line) == ("no row", 3, 6)


def test_rows_that_were_removed(load: Callable[[str], Program]) -> None:
    program = load(".decl e(x: number)\n.input e\n.decl m(x: number)\nm(X) :- e(X).\nm(X) <= m(Y) :- Y < X.\n")
    assert text(program, {"e": [(1,), (2,)]}, "m(2)") == (
        "m(2) is not there; 1 rule for `m`:\np.dl:4: m(X) :- e(X).\n  holds    e(2)\n  removed  m(2), by subsumption or a choice-domain\n"
    )


def test_records_and_rules_that_cannot_fit(load: Callable[[str], Program]) -> None:
    program = load(
        ".type P = [k: symbol, n: symbol]\n.decl e(n: symbol)\n.input e\n.decl p(p: P)\n"
        'p(["pub", N]) :- e(N).\np(["sub", N]) :- e(N), N != "x".\n'
    )
    assert text(program, {"e": [("x",), ("y",)]}, "p([sub, x])") == (
        'p(["sub", "x"]) is not there; 2 rules for `p`:\n'
        'p.dl:6: p(["sub", N]) :- e(N), N != "x".\n'
        '  holds    e("x")\n'
        '  fails    "x" != "x"\n'
        'p.dl:5: p(["pub", N]) :- e(N).\n'
        '  differs  p(["pub", N])\n'
        'nearest rows:\n  p(["pub", "x"])\n  p(["sub", "y"])\n'
    )


def test_a_relation_without_rules(load: Callable[[str], Program]) -> None:
    program = load(".decl r(x: number)\n")
    assert text(program, {}, "r(1)") == "r(1) is not there; `r` has no rules\n"


def test_errors(graph: Program) -> None:
    with pytest.raises(DatalogError, match="<goal>:1:1: unknown relation `pth`, did you mean `path`"):
        why_not(graph, {}, "pth(a, b)")
