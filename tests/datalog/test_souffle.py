"""The same programs on the embedded engine and on the souffle binary."""

from __future__ import annotations

import random
import shutil
from collections.abc import Callable
from typing import Any

import pytest

from rosarch.datalog import DatalogError, Program

pytestmark = pytest.mark.skipif(shutil.which("souffle") is None, reason="souffle is not on PATH")
Rows = dict[str, list[tuple[Any, ...]]]


def graph(seed: int, nodes: int, edges: int) -> list[tuple[str, str]]:
    source = random.Random(seed)
    return sorted({(f"v{source.randrange(nodes)}", f"v{source.randrange(nodes)}") for _ in range(edges)})


EDGE = ".type Node <: symbol\n.decl edge(a: Node, b: Node)\n.input edge\n"
PROGRAMS = {
    "closure": ".decl r(a: Node, b: Node)\n.output r\nr(x, y) :- edge(x, y).\nr(x, z) :- r(x, y), edge(y, z).\n",
    "nonlinear": ".decl r(a: Node, b: Node)\n.output r\nr(x, y) :- edge(x, y).\nr(x, z) :- r(x, y), r(y, z).\n",
    "same_generation": """.decl r(a: Node, b: Node)
.output r
r(x, y) :- edge(p, x), edge(p, y), x != y.
r(x, y) :- edge(p, x), r(p, q), edge(q, y).
""",
    "negation": """.decl reach(a: Node, b: Node)
.decl r(a: Node, b: Node)
.output r
reach(x, y) :- edge(x, y).
reach(x, z) :- reach(x, y), edge(y, z).
r(x, y) :- edge(x, _), edge(_, y), !reach(x, y), x < y.
""",
    "aggregates": """.decl r(a: Node, c: number, m: number, s: number)
.output r
r(x, c, m, s) :- edge(x, _), c = count : { edge(x, _) },
    m = max strlen(y) : { edge(x, y) }, s = sum to_number(substr(y, 1, 9)) : { edge(x, y), y != x }.
""",
    "aggregate_joins": """.decl r(n: symbol, c: number)
.output r
r("pairs", c) :- c = count : { edge(x, y), edge(y, z) }.
r("paths", c) :- c = count : { edge(x, _), edge(_, x) }.
r("loops", c) :- c = count : { edge(x, x) }.
r("nested", c) :- c = count : { edge(x, _), 2 < count : { edge(x, _) } }.
""",
    "records": """.type Path = [node: Node, rest: Path]
.decl path(p: Path, n: Node, l: number)
.output path
path([x, nil], x, 1) :- edge(x, _), x < "v15".
path([y, p], y, l + 1) :- path(p, x, l), edge(x, y), l < 3.
""",
    "adts": """.type T = Leaf {n: Node} | Pair {l: T, r: T} | None {}
.decl t(t: T, d: number)
.output t
t($None(), 0).
t($Leaf(x), 1) :- edge(x, x).
t($Pair(a, b), 2) :- t(a, 1), t(b, 1).
""",
    "arithmetic": """.decl r(a: number, b: unsigned, c: float, s: symbol)
.output r
r(n * 7919 ^ 2, to_unsigned(n) * 4000000000, to_float(n) / 3.0, cat(x, to_string(n))) :-
    edge(x, _), n = to_number(substr(x, 1, 9)) - 20.
r(n / 3, to_unsigned(n % 3), to_float(n % -3), to_string(n bshl 3)) :- edge(x, _), n = strlen(x) * -100.
""",
    "components": """.comp Closure<T> {
    .decl base(a: T, b: T)
    .decl all(a: T, b: T)
    all(x, y) :- base(x, y).
    all(x, z) :- all(x, y), base(y, z).
}
.init c = Closure<Node>
c.base(x, y) :- edge(y, x).
.output c.all
""",
    "equivalence": '.decl r(a: Node, b: Node) eqrel\n.output r\nr(x, y) :- edge(x, y), x < "v2".\n',
    "subsumption": """.decl r(a: Node, d: number) btree_delete
.output r
r("v1", 0).
r(y, d + 1) :- r(x, d), edge(x, y), d < 50.
r(x, d1) <= r(x, d2) :- d2 < d1.
""",
    "inline": """.decl two(a: Node, b: Node) inline
two(x, z) :- edge(x, y), edge(y, z).
.decl r(a: Node, b: Node)
.output r
r(x, y) :- two(x, y), !edge(x, y).
""",
    "disjunction": """.decl r(a: Node)
.output r
r(x) :- (edge(x, _) ; edge(_, x)), !(edge(x, x) ; contains("9", x)), match("v[0-9]{1,2}", x).
""",
}


@pytest.mark.parametrize("name", sorted(PROGRAMS))
def test_same_rows(load: Callable[[str], Program], name: str) -> None:
    program = load(EDGE + PROGRAMS[name])
    for seed in range(3):
        facts = {"edge": graph(seed, 40, 60)}
        embedded, souffle = program.evaluate(facts), program.evaluate(facts, engine="souffle")
        for relation in program.outputs:
            assert embedded.rows(relation) == souffle.rows(relation)


def test_keep_all_and_printed_relations(load: Callable[[str], Program]) -> None:
    program = load('.decl a(x: symbol)\n.decl b(x: symbol)\n.output b(IO=stdout) // .output a\na(".input a").\nb(x) :- a(x).\n')
    result = program.evaluate({}, engine="souffle", keep="all")
    assert {n: result.rows(n) for n in result.names()} == {"a": [(".input a",)], "b": [(".input a",)]}


def test_failure_of_souffle_is_reported(load: Callable[[str], Program]) -> None:
    program = load(".decl a(x: number)\n.output a\na(1 / x) :- x = range(0, 1).\n")
    with pytest.raises(DatalogError, match="souffle failed with exit code"):
        program.evaluate({}, engine="souffle")
