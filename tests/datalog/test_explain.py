"""Proofs: of recursive, negated and aggregated rows, by exact text, on either engine's result."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosarch.datalog import DatalogError, Layout, Program, Proof, Result, explain, explain_all, load_program, proof_text, row_store
from rosarch.datalog.inspection import clauses
from rosarch.datalog.inspection.proofs import Absent, AggregateValue, Condition

GRAPH = """.decl edge(a: symbol, b: symbol)
.input edge
.decl blocked(a: symbol)
.input blocked
.decl path(a: symbol, b: symbol)
.output path
path(X, Y) :- edge(X, Y), !blocked(Y).
path(X, Z) :- path(X, Y), edge(Y, Z), !blocked(Z), X != Z.
.decl degree(a: symbol, n: number)
degree(X, N) :- edge(X, _), N = count : { edge(X, _) }.
.decl hub(a: symbol, next: number)
hub(X, N + 1) :- degree(X, N), N >= max M : { degree(_, M) }.
.decl start(a: symbol)
start("a").
"""
FACTS = {"edge": [("a", "b"), ("b", "c"), ("c", "a"), ("c", "d"), ("d", "e")], "blocked": [("e",)]}
SHORT = Layout(shorten=lambda path: Path(path).name)


@pytest.fixture
def show(load: Callable[[str], Program]) -> Callable[..., str]:
    def text(source: str, facts: Any, goal: str, layout: Layout = SHORT) -> str:
        return proof_text(explain(load(source), facts, goal), layout=layout)

    return text


def test_recursion_and_negation(show: Callable[..., str]) -> None:
    assert show(GRAPH, FACTS, "path(a, d)") == (
        'path("a", "d")  p.dl:8\n'
        '├─ path("a", "c")  p.dl:8\n'
        '│  ├─ path("a", "b")  p.dl:7\n'
        '│  │  ├─ edge("a", "b")  input\n'
        '│  │  └─ !blocked("b")  absent\n'
        '│  ├─ edge("b", "c")  input\n'
        '│  ├─ !blocked("c")  absent\n'
        '│  └─ "a" != "c"\n'
        '├─ edge("c", "d")  input\n'
        '├─ !blocked("d")  absent\n'
        '└─ "a" != "d"\n'
    )


def test_rules_that_were_read_before_are_not_parsed_again(load: Callable[[str], Program], monkeypatch: pytest.MonkeyPatch) -> None:
    source = (
        GRAPH + '.decl long(a: symbol, n: float)\nlong(X, N / 2.0) :- X = cat("no", to_string(K)), K = 1 + 2 * 3, N = to_float("1.5").\n'
    )
    program, goals = load(source), ("path(a, d)", "hub(_, _)", "long(_, _)")
    first = [proof_text(explain(program, FACTS, goal)) for goal in goals]
    assert 'long("no7", 0.75)' in first[-1]

    def refuse(*_: Any) -> None:
        raise AssertionError("parsed again")

    monkeypatch.setattr(clauses, "_kept_rules", {})
    monkeypatch.setattr(clauses, "remembered", refuse)
    assert [proof_text(explain(program, FACTS, goal)) for goal in goals] == first


def test_aggregates_with_their_rows(show: Callable[..., str]) -> None:
    assert show(GRAPH, FACTS, "hub(_, _)") == (
        'hub("c", 3)  p.dl:12\n'
        '├─ degree("c", 2)  p.dl:10\n'
        '│  ├─ edge("c", "a")  input\n'
        '│  └─ count : { edge("c", _) } = 2\n'
        '│     ├─ edge("c", "a")\n'
        '│     └─ edge("c", "d")\n'
        "├─ max M : { degree(_, M) } = 2\n"
        '│  └─ degree("c", 2)\n'
        "└─ 2 >= 2\n"
    )


def test_many_rows_of_an_aggregate_are_cut(show: Callable[..., str]) -> None:
    source = ".decl e(x: number)\n.input e\n.decl r(n: number)\nr(N) :- N = sum X : { e(X) }.\n"
    facts = {"e": [(i,) for i in range(1, 11)]}
    assert show(source, facts, "r(_)") == (
        "r(55)  p.dl:4\n└─ sum X : { e(X) } = 55\n   ├─ e(1)\n   ├─ e(2)\n   ├─ e(3)\n   ├─ e(4)\n   ├─ e(5)\n   └─ ... 5 more\n"
    )


def test_an_empty_aggregate(show: Callable[..., str]) -> None:
    source = ".decl e(x: number)\n.input e\n.decl r(n: number)\nr(N) :- N = count : { e(_) }.\n"
    assert show(source, {}, "r(0)") == "r(0)  p.dl:4\n└─ count : { e(_) } = 0  no rows\n"


def test_depth_rules_and_rows_proven_above(show: Callable[..., str]) -> None:
    layout = Layout(depth=1, rules=True, shorten=SHORT.shorten)
    assert show(GRAPH, FACTS, "path(a, c)", layout) == (
        'path("a", "c")  p.dl:8\n'
        "│  path(X, Z) :- path(X, Y), edge(Y, Z), !blocked(Z), X != Z.\n"
        '├─ path("a", "b")  p.dl:7, ...\n'
        "│     path(X, Y) :- edge(X, Y), !blocked(Y).\n"
        '├─ edge("b", "c")  input\n'
        '├─ !blocked("c")  absent\n'
        '└─ "a" != "c"\n'
    )
    twice = ".decl e(x: number)\n.input e\n.decl d(x: number)\nd(X) :- e(X).\n.decl r(x: number)\nr(X) :- d(X), d(Y), X = Y.\n"
    assert show(twice, {"e": [(1,)]}, "r(1)") == "r(1)  p.dl:6\n├─ d(1)  p.dl:4\n│  └─ e(1)  input\n└─ d(1)  p.dl:4, proven above\n"


def test_the_proof_as_data(load: Callable[[str], Program]) -> None:
    proof = explain(load(GRAPH), FACTS, "path(a, c)")
    assert (proof.relation, proof.row, proof.kind) == ("path", ("a", "c"), "rule")
    assert proof.location is not None and proof.location.line == 8
    assert proof.bindings == (("X", '"a"'), ("Y", '"b"'), ("Z", '"c"'))
    assert [type(p) for p in proof.premises] == [Proof, Proof, Absent, Condition]
    assert [leaf.text for leaf in proof.leaves()] == ['edge("a", "b")', 'edge("b", "c")']
    degree = explain(load(GRAPH), FACTS, "degree(c, _)")
    counted = degree.premises[1]
    assert isinstance(counted, AggregateValue)
    assert (counted.value, [r.row for r in counted.rows]) == ("2", [("c", "a"), ("c", "d")])


def test_a_fact_of_the_program(show: Callable[..., str]) -> None:
    assert show(GRAPH, FACTS, "start(a)") == 'start("a")  p.dl:14\n'


def test_no_row_supports_itself(load: Callable[[str], Program]) -> None:
    """On a cycle every row could be derived from itself; the proof that is found is the lowest."""
    program = load(
        ".decl edge(a: number, b: number)\n.input edge\n.decl path(a: number, b: number)\n"
        "path(X, Z) :- path(X, Y), path(Y, Z).\npath(X, Y) :- edge(X, Y).\n"
    )
    edges = [(i, (i + 1) % 12) for i in range(12)]
    proof = explain(program, {"edge": edges}, "path(0, 0)")
    assert _height(proof) == 5  # twelve edges in balanced halves, and the edge itself
    size = 300
    linear = load(
        ".decl edge(a: number, b: number)\n.input edge\n.decl path(a: number, b: number)\n"
        "path(X, Z) :- path(X, Y), edge(Y, Z).\npath(X, Y) :- edge(X, Y).\n"
    )
    chain = explain(linear, {"edge": [(i, (i + 1) % size) for i in range(size)]}, "path(0, 0)")
    assert _height(chain) == size
    assert len(proof_text(chain).splitlines()) == 2 * size


def _height(proof: Proof) -> int:
    """The rows on the longest way down; RecursionError when a row rests on itself."""
    known: dict[int, int] = {}
    path: set[int] = set()
    work = [(proof, False)]
    while work:
        node, done = work.pop()
        if done:
            path.discard(id(node))
            known[id(node)] = 1 + max((known[id(p)] for p in node.derived), default=-1)
        elif id(node) not in known:
            if id(node) in path:
                raise RecursionError(node.text)
            path.add(id(node))
            work.append((node, True))
            work += [(p, False) for p in node.derived]
    return known[id(proof)]


def test_mutual_recursion(load: Callable[[str], Program]) -> None:
    program = load(
        ".decl n(x: number)\n.input n\n.decl even(x: number)\n.decl odd(x: number)\n"
        "even(0).\nodd(X + 1) :- even(X), n(X).\neven(X + 1) :- odd(X), n(X).\n"
    )
    proof = explain(program, {"n": [(i,) for i in range(10)]}, "even(4)")
    assert [p.text for p in _spine(proof)] == ["even(4)", "odd(3)", "even(2)", "odd(1)", "even(0)"]


def _spine(proof: Proof) -> list[Proof]:
    return [proof, *(_spine(proof.derived[0]) if proof.derived else [])]


def test_records_and_branches(show: Callable[..., str]) -> None:
    source = (
        ".type P = [x: number, y: symbol]\n.type T = Leaf {} | Node {l: T, v: number}\n.decl e(x: number, y: symbol)\n.input e\n"
        ".decl p(p: P)\np([X, Y]) :- e(X, Y).\n.decl t(t: T)\nt($Leaf()).\nt($Node(L, X)) :- t(L), p([X, _]), L = $Leaf().\n"
    )
    facts = {"e": [(1, 'a "b"')]}
    assert show(source, facts, 'p([1, "a \\"b\\""])') == 'p([1, "a \\"b\\""])  p.dl:6\n└─ e(1, "a \\"b\\"")  input\n'
    assert show(source, facts, "t($Node(_, 1))") == (
        't($Node($Leaf(), 1))  p.dl:9\n├─ t($Leaf())  p.dl:8\n└─ p([1, "a \\"b\\""])  p.dl:6\n   └─ e(1, "a \\"b\\"")  input\n'
    )


def test_functors_disjunctions_and_ranges(show: Callable[..., str]) -> None:
    source = (
        ".decl e(x: number)\n.input e\n.decl r(x: number, s: symbol)\n"
        'r(Y, cat("n", to_string(X))) :- e(X), Y = range(X, X + 3), (Y > X + 1; X < 0), match("[0-9]+", to_string(X)).\n'
    )
    assert show(source, {"e": [(5,)]}, "r(7, n5)") == (
        'r(7, "n5")  p.dl:4\n├─ e(5)  input\n├─ 7 = range(5, 5 + 3)\n├─ 7 > 5 + 1\n└─ match("[0-9]+", to_string(5))\n'
    )


def test_eqrel_subsumption_counters(show: Callable[..., str]) -> None:
    eqrel = ".decl e(x: number, y: number)\n.input e\n.decl q(x: number, y: number) eqrel\nq(X, Y) :- e(X, Y).\n"
    assert show(eqrel, {"e": [(1, 2)]}, "q(2, 1)") == "q(2, 1)  p.dl:3\n└─ q(1, 2)  p.dl:4\n   └─ e(1, 2)  input\n"
    least = ".decl e(x: number)\n.input e\n.decl m(x: number)\nm(X) :- e(X).\nm(X) <= m(Y) :- Y < X.\n"
    assert show(least, {"e": [(3,), (1,)]}, "m(_)") == "m(1)  p.dl:4\n└─ e(1)  input\n"
    counter = ".decl e(x: symbol)\n.input e\n.decl c(i: number, x: symbol)\nc(autoinc(), X) :- e(X).\n"
    assert show(counter, {"e": [("a",)]}, "c(_, a)") == 'c(0, "a")  p.dl:4\n└─ e("a")  input\n'


def test_on_a_result_and_on_rows_read_once(load: Callable[[str], Program]) -> None:
    program = load(GRAPH)
    result = program.evaluate(FACTS, keep="all")
    assert proof_text(explain(program, result, "path(a, d)")) == proof_text(explain(program, FACTS, "path(a, d)"))
    assert len(explain_all(program, row_store(program, FACTS), "path(a, _)")) == 3
    with pytest.raises(DatalogError) as caught:
        explain(program, program.evaluate(FACTS), "path(a, d)")
    assert str(caught.value) == 'no rows of `edge` were kept, evaluate with keep="all"'


@pytest.mark.skipif(shutil.which("souffle") is None, reason="there is no souffle on PATH")
def test_on_the_result_of_souffle(load: Callable[[str], Program]) -> None:
    program = load(GRAPH)
    result: Result = program.evaluate(FACTS, engine="souffle", keep="all")
    for goal in ("path(a, d)", "hub(c, 3)"):
        assert proof_text(explain(program, result, goal)) == proof_text(explain(program, FACTS, goal))


@pytest.mark.parametrize(
    ("goal", "expected"),
    [
        ("path(a, e)", 'there is no row path("a", "e"), `why-not` shows what is missing'),
        ("degree(_, 7)", "there is no row degree(_, 7), `why-not` shows what is missing"),
        ("pth(a, b)", "<goal>:1:1: unknown relation `pth`, did you mean `path`?\n    pth(a, b)\n    ^"),
        ("path(a)", "<goal>:1:1: `path` has 2 attributes, given 1, declared `path(a: symbol, b: symbol)`\n    path(a)\n    ^"),
        (
            "path(a, b, c)",
            "<goal>:1:1: `path` has 2 attributes, given more, declared `path(a: symbol, b: symbol)`\n    path(a, b, c)\n    ^",
        ),
        ("degree(a, b)", "<goal>:1:11: `b` is not a number, the column is of type `number`\n    degree(a, b)\n              ^"),
        ("path(a, b", "<goal>:1:10: expected `,`, found the end\n    path(a, b\n             ^"),
        ("path(a, b) x", "<goal>:1:12: unexpected `x` after the goal\n    path(a, b) x\n               ^"),
        ("path", "<goal>:1:1: expected a goal of the form `relation(value, ...)`\n    path\n    ^"),
    ],
)
def test_errors(load: Callable[[str], Program], goal: str, expected: str) -> None:
    with pytest.raises(DatalogError) as caught:
        explain(load(GRAPH), FACTS, goal)
    assert str(caught.value) == expected


@pytest.mark.slow
def test_a_port_of_an_example(examples: Path) -> None:
    """Down to the source: every leaf is a fact, and the lines of the source tell the story."""
    from rosarch.base.files import folder_reader
    from rosarch.datalog import SourceLines
    from rosarch.extractor.manifest import rules_folder
    from rosarch.extractor.pipeline import extract

    program = load_program(rules_folder() / "component.dl")
    with extract(examples / "mobile_base", ["base_odometry"]) as extraction:
        facts = next(c for c in extraction.components if c.name == "odometry_node").rows()
    store = row_store(program, {name: rows for name, rows in facts.items() if name in program.inputs})
    proof = explain(program, store, "port([_, publisher, odom])")
    assert proof.row[0][1:] == ("publisher", "odom")
    assert {leaf.kind for leaf in proof.leaves()} <= {"input", "fact", "rule"}
    assert {p.name for p in program.relations.values() if p.is_input} >= {leaf.relation for leaf in proof.leaves() if leaf.kind == "input"}
    text = proof_text(proof, layout=Layout(depth=1), lines=SourceLines(program, store, folder_reader(examples / "mobile_base")))
    lines = text.split("source lines:\n")[1].splitlines()
    assert '  src/base_odometry/src/odometry.cpp:17: private_nh.param<std::string>("odom_topic", odom_topic_, "odom");' in lines
    assert "  src/base_odometry/include/base_odometry/odometry.h:29: return nh.advertise<Message>(topic, queue_size_);" in lines
