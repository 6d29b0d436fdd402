"""Facts that several evaluations have in common: what is derived is as if each had them for itself."""

from __future__ import annotations

import random

import pytest

from rosarch.datalog import CommonFacts, DatalogError, Program, load_program

RULES = """
.type Pair = [a: symbol, b: number]
.decl edge(a: symbol, b: symbol)
.decl label(a: symbol, kind: symbol, n: number)
.decl start(a: symbol)
.decl more(a: symbol, b: symbol)
.decl pair(a: symbol, p: Pair)
.input edge
.input label
.input start
.input more
.input pair
more(B, A) :- edge(A, B), label(A, "turn", _).  // an input to which rules add
.decl reach(a: symbol, b: symbol)
reach(A, B) :- start(A), edge(A, B).
reach(A, C) :- reach(A, B), edge(B, C).
.decl lonely(a: symbol)
lonely(A) :- label(A, _, _), !edge(A, A), !reach(_, A).
.decl counted(a: symbol, n: number)
counted(A, N) :- start(A), N = sum X : { label(A, _, X) }.
.decl same(a: symbol, kind: symbol)
same(A, K) :- label(A, K, 1), edge(B, A), label(B, K, 1).
.decl found(a: symbol, n: number)
found(A, N) :- pair(A, [B, N]), more(A, B).
.output reach
.output lonely
.output counted
.output same
.output found
.output more
"""
NAMES = "abcdefgh"
Facts = dict[str, set[tuple[object, ...]]]


@pytest.fixture(scope="module", params=[False, True], ids=["all", "on demand"])
def program(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Program:
    file = tmp_path_factory.mktemp("rules") / "rules.dl"
    file.write_text(RULES)
    return load_program(file, on_demand=request.param)


def some(chosen: random.Random) -> Facts:
    def name() -> str:
        return chosen.choice(NAMES)

    count = chosen.choice([0, 3, 30])
    return {
        "edge": {(name(), name()) for _ in range(count)},
        "label": {(name(), chosen.choice(["turn", "go"]), chosen.randint(0, 2)) for _ in range(count)},
        "start": {(name(),) for _ in range(count // 10 + 1)},
        "more": {(name(), name()) for _ in range(count)},
        "pair": {(name(), (name(), chosen.randint(0, 2))) for _ in range(count)},
    }


@pytest.mark.parametrize("seed", range(10))
def test_as_if_each_had_them(program: Program, seed: int) -> None:
    chosen = random.Random(seed)
    shared = some(chosen)
    common = CommonFacts(shared)
    for _ in range(4):
        facts = some(chosen)
        own = {name: rows - shared[name] for name, rows in facts.items()}
        beside = program.evaluate({name: list(rows) if seed % 2 else rows for name, rows in own.items()}, common=common)
        alone = program.evaluate({name: own[name] | shared[name] for name in own})
        assert beside.all_rows() == alone.all_rows()
    assert common.rows == shared


def test_indexes_are_made_once(program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    from rosarch.datalog.indexes import Index

    common = CommonFacts({"edge": {("a", "b"), ("b", "c"), ("c", "d")}})
    made: list[int] = []
    build = Index.build

    def counting(self: Index, rows: set[tuple[str, str]], *rest: object) -> object:
        made.append(len(rows))
        return build(self, rows, *rest)  # type: ignore[arg-type]

    monkeypatch.setattr(Index, "build", counting)
    assert program.evaluate({"start": [("a",)]}, common=common).rows("reach") == [("a", "b"), ("a", "c"), ("a", "d")]
    assert 3 in made
    made.clear()
    own = {"start": [("c",)], "edge": [("d", "a")]}
    assert program.evaluate(own, common=common).rows("reach") == [("c", name) for name in "abcd"]
    assert 3 not in made
    assert 4 not in made


def test_facts_of_the_wrong_length(program: Program) -> None:
    with pytest.raises(DatalogError, match="facts of `edge`: expected 2 columns"):
        program.evaluate({"edge": [("a",)]}, common=CommonFacts({"edge": {("a", "b")}}))


def test_they_are_for_one_engine(program: Program) -> None:
    with pytest.raises(DatalogError, match="common facts are for the embedded engine"):
        program.evaluate({}, engine="souffle", common=CommonFacts({}))
