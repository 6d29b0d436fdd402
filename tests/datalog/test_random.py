"""Random small programs, evaluated by the engine and by a naive interpreter."""

from __future__ import annotations

import itertools
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rosarch.datalog import Result, load_program

DOMAIN = range(4)
ARITY = {"e": 2, "f": 1, "g": 3, "p": 2, "q": 1, "s": 2}
INPUTS = ("e", "f", "g")
GOALS = st.lists(st.sampled_from(sorted(set(ARITY) - set(INPUTS))), unique=True)
STRATUM = {"e": 0, "f": 0, "g": 0, "p": 1, "q": 1, "s": 2}
VARIABLES = ("x", "y", "z", "w")


@dataclass(frozen=True)
class Literal:
    """`name(args)`; comparisons have an operator as name."""

    name: str
    args: tuple[str, ...]
    negated: bool = False

    def __str__(self) -> str:
        if self.name in ("<", "!=", "="):
            return f"{self.args[0]} {self.name} {self.args[1]}"
        return f"{'!' * self.negated}{self.name}({', '.join(self.args)})"


@dataclass(frozen=True)
class Rule:
    head: Literal
    body: tuple[Literal, ...]

    def __str__(self) -> str:
        return f"{self.head} :- {', '.join(map(str, self.body))}."


@st.composite
def rules(draw: st.DrawFn) -> Rule:
    head_name = draw(st.sampled_from(("p", "q", "s")))
    readable = [n for n in ARITY if STRATUM[n] <= STRATUM[head_name]]
    lower = [n for n in ARITY if STRATUM[n] < STRATUM[head_name]]
    terms = st.sampled_from((*VARIABLES, *VARIABLES, "_", "1"))
    body: list[Literal] = []
    for name in draw(st.lists(st.sampled_from(readable), min_size=1, max_size=3)):
        body.append(Literal(name, tuple(draw(terms) for _ in range(ARITY[name]))))
    bound = sorted({a for literal in body for a in literal.args if a in VARIABLES}) or ["2"]
    values = st.sampled_from((*bound, "0", "2"))
    if draw(st.booleans()):
        name = draw(st.sampled_from(lower))
        args = tuple(draw(st.sampled_from((*bound, "_", "3"))) for _ in range(ARITY[name]))
        body.append(Literal(name, args, negated=True))
    if draw(st.booleans()):
        body.append(Literal(draw(st.sampled_from(("<", "!=", "="))), (draw(st.sampled_from(bound)), draw(values))))
    return Rule(Literal(head_name, tuple(draw(values) for _ in range(ARITY[head_name]))), tuple(draw(st.permutations(body))))


def row_sets(name: str) -> st.SearchStrategy[set[tuple[int, ...]]]:
    return st.sets(st.tuples(*[st.sampled_from(DOMAIN)] * ARITY[name]), max_size=8)


FACTS = st.fixed_dictionaries({name: row_sets(name) for name in INPUTS})


def matches(literal: Literal, row: tuple[int, ...], binding: dict[str, int]) -> dict[str, int] | None:
    """The binding extended so that the literal's arguments equal the row."""
    extended = dict(binding)
    for arg, value in zip(literal.args, row, strict=True):
        if arg == "_":
            continue
        if arg.isdigit():
            if int(arg) != value:
                return None
        elif extended.setdefault(arg, value) != value:
            return None
    return extended


def holds(literal: Literal, binding: dict[str, int], rows: dict[str, set[tuple[int, ...]]]) -> bool:
    if literal.negated:
        return all(matches(literal, row, binding) is None for row in rows[literal.name])
    left, right = (int(a) if a.isdigit() else binding[a] for a in literal.args)
    return {"<": left < right, "!=": left != right, "=": left == right}[literal.name]


def derive(rule: Rule, rows: dict[str, set[tuple[int, ...]]]) -> Iterator[tuple[int, ...]]:
    atoms = [b for b in rule.body if b.name in ARITY and not b.negated]
    tests = [b for b in rule.body if b not in atoms]
    for chosen in itertools.product(*(rows[a.name] for a in atoms)):
        binding: dict[str, int] | None = {}
        for atom, row in zip(atoms, chosen, strict=True):
            binding = None if binding is None else matches(atom, row, binding)
        if binding is not None and all(holds(t, binding, rows) for t in tests):
            yield tuple(int(a) if a.isdigit() else binding[a] for a in rule.head.args)


def naive(program: list[Rule], facts: dict[str, set[tuple[int, ...]]]) -> dict[str, set[tuple[int, ...]]]:
    """Apply the rules of each stratum until nothing changes."""
    rows = {name: set(facts.get(name, ())) for name in ARITY}
    for stratum in (1, 2):
        changed = True
        while changed:
            changed = False
            for rule in program:
                if STRATUM[rule.head.name] == stratum:
                    new = set(derive(rule, rows)) - rows[rule.head.name]
                    rows[rule.head.name] |= new
                    changed |= bool(new)
    return rows


@pytest.mark.slow
@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(program=st.lists(rules(), min_size=1, max_size=6), facts=FACTS)
def test_engine_agrees_with_naive_evaluation(tmp_path: Path, program: list[Rule], facts: dict[str, set[tuple[int, ...]]]) -> None:
    lines = [f".decl {n}({', '.join(f'c{i}: number' for i in range(a))})" for n, a in ARITY.items()]
    lines += [f".input {name}" for name in INPUTS]
    (tmp_path / "random.dl").write_text("\n".join([*lines, *map(str, program)]) + "\n")
    result = load_program(tmp_path / "random.dl").evaluate(facts, keep="all")
    expected = naive(program, facts)
    assert {name: set(result.rows(name)) for name in ARITY} == expected


@pytest.mark.skipif(shutil.which("souffle") is None, reason="souffle is not on PATH")
@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(program=st.lists(rules(), min_size=1, max_size=6), facts=FACTS)
def test_both_engines_agree(tmp_path: Path, program: list[Rule], facts: dict[str, set[tuple[int, ...]]]) -> None:
    lines = [f".decl {n}({', '.join(f'c{i}: number' for i in range(a))})" for n, a in ARITY.items()]
    lines += [f".input {name}" for name in INPUTS]
    (tmp_path / "random.dl").write_text("\n".join([*lines, *map(str, program)]) + "\n")
    loaded = load_program(tmp_path / "random.dl")
    embedded, souffle = loaded.evaluate(facts, keep="all"), loaded.evaluate(facts, keep="all", engine="souffle")
    for name in ARITY:
        assert embedded.rows(name) == souffle.rows(name), name


TERMS = st.recursive(
    st.one_of(st.sampled_from(("x", "y")), st.integers(-(2**31), 2**31 - 1).map(lambda n: str(n) if n >= 0 else f"({n})")),
    lambda inner: st.one_of(
        st.tuples(
            inner, st.sampled_from(("+", "-", "*", "band", "bor", "bxor", "bshl", "bshr", "bshru", "land", "lor", "lxor")), inner
        ).map(lambda t: f"({t[0]} {t[1]} {t[2]})"),
        inner.map(lambda t: f"(bnot {t})"),
        inner.map(lambda t: f"(lnot {t})"),
        inner.map(lambda t: f"strlen(to_string({t}))"),
        inner.map(lambda t: f"to_number(to_unsigned({t}))"),
        st.tuples(inner, inner).map(lambda t: f"max({t[0]}, {t[1]})"),
    ),
    max_leaves=8,
)


@pytest.mark.skipif(shutil.which("souffle") is None, reason="souffle is not on PATH")
@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    terms=st.lists(TERMS, min_size=1, max_size=8), values=st.lists(st.integers(-(2**31), 2**31 - 1), min_size=1, max_size=4, unique=True)
)
def test_both_engines_compute_the_same(tmp_path: Path, terms: list[str], values: list[int]) -> None:
    rules = [f"r({number}, x, y, {term}) :- n(x), n(y)." for number, term in enumerate(terms)]
    source = [".decl n(x: number)", ".input n", ".decl r(i: number, x: number, y: number, z: number)", ".output r", *rules]
    (tmp_path / "terms.dl").write_text("\n".join(source) + "\n")
    loaded = load_program(tmp_path / "terms.dl")
    facts = {"n": [(v,) for v in values]}
    assert loaded.evaluate(facts).rows("r") == loaded.evaluate(facts, engine="souffle").rows("r")


@pytest.mark.slow
@settings(max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(program=st.lists(rules(), min_size=1, max_size=6), facts=FACTS, goal=st.sampled_from(sorted(set(ARITY) - set(INPUTS))))
def test_on_demand_the_rows_are_the_same(
    tmp_path: Path, program: list[Rule], facts: dict[str, set[tuple[int, ...]]], goal: str
) -> None:  # fmt: skip
    lines = [f".decl {n}({', '.join(f'c{i}: number' for i in range(a))})" for n, a in ARITY.items()]
    lines += [*(f".input {name}" for name in INPUTS), f".output {goal}"]
    (tmp_path / "random.dl").write_text("\n".join([*lines, *map(str, program)]) + "\n")
    result = load_program(tmp_path / "random.dl", on_demand=True).evaluate(facts)
    assert set(result.rows(goal)) == naive(program, facts)[goal]


@pytest.mark.slow
@settings(max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    program=st.lists(rules(), min_size=1, max_size=6), each=st.lists(st.tuples(FACTS, GOALS), min_size=2, max_size=12),
    goals=GOALS.filter(bool), on_demand=st.booleans(),
)  # fmt: skip
def test_in_a_series_the_rows_are_the_same(
    tmp_path: Path, program: list[Rule], each: list[tuple[dict[str, set[tuple[int, ...]]], list[str]]], goals: list[str], on_demand: bool
) -> None:
    """Also those that are asked for when other evaluations have begun."""
    lines = [f".decl {n}({', '.join(f'c{i}: number' for i in range(a))})" for n, a in ARITY.items()]
    lines += [*(f".input {name}" for name in INPUTS), *(f".output {goal}" for goal in goals)]
    (tmp_path / "random.dl").write_text("\n".join([*lines, *map(str, program)]) + "\n")
    with load_program(tmp_path / "random.dl", on_demand=on_demand).series() as evaluate:
        waiting: list[tuple[Result, dict[str, set[tuple[int, ...]]]]] = []
        for facts, first in each:
            result, expected = evaluate(facts), naive(program, facts)
            for goal in first:
                assert goal not in goals or set(result.rows(goal)) == expected[goal]
            waiting.append((result, expected))
        for result, expected in waiting:
            for goal in goals:
                assert set(result.rows(goal)) == expected[goal]
