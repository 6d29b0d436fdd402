"""Input that is too deep, too long or too slow: bounded, and told."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosarch.datalog import DatalogError, Program, load_program
from rosarch.datalog.engine.regular import _TOKEN, _linear, full_match
from rosarch.datalog.language.domain import EvaluationError
from rosarch.datalog.language.values import ValueReader, ValueWriter, show_value

DEPTH = 200_000
LIST = ".type L = [head: number, tail: L]\n"


@pytest.mark.slow
def test_lists_of_any_length(load: Callable[[str], Program]) -> None:
    source = f"""{LIST}.decl l(n: number, x: L)
l(0, nil).
l(n + 1, [n, x]) :- l(n, x), n < {DEPTH}.
.decl last(x: L)
.output last
last(x) :- l({DEPTH}, x).
.decl again(n: number)
.output again
again(n) :- l(n, [_, x]), last([_, x]).
"""
    program = load(source)
    result = program.evaluate({}, keep="all")
    assert result.rows("again") == [(DEPTH,)]
    text = ValueWriter(program.types).show(result.rows("last")[0][0], "L")
    assert text.startswith(f"[{DEPTH - 1}, [{DEPTH - 2}, ") and text.endswith("[0, nil" + "]" * DEPTH)
    assert show_value(result.rows("last")[0][0]) == text


@pytest.mark.slow
def test_facts_of_any_depth(load: Callable[[str], Program], tmp_path: Path) -> None:
    program = load(f"{LIST}.decl l(x: L)\n.input l\n.output l\n")
    text = "[1, " * DEPTH + "nil" + "]" * DEPTH
    (tmp_path / "l.facts").write_text(text + "\n")
    value = program.evaluate(tmp_path).rows("l")[0][0]
    assert ValueWriter(program.types).show(value, "L") == text
    with pytest.raises(ValueError, match=r"expected `\]` at ``"):
        ValueReader(program.types).read(text[:-1], "L")


def test_terms_too_deep_are_an_error_with_a_place(errors: Callable[[str], str]) -> None:
    assert errors(f"{LIST}.decl l(x: L)\nl({'[1, ' * 5000}nil{']' * 5000}).\n").startswith("p.dl:3:19999: a term is nested too deeply\n")
    assert errors(f".decl r(x: number)\nr({'1+' * 5000}1).\n").startswith("p.dl:2:1: a term is nested too deeply\n")


def test_long_expressions(rows: Callable[..., list[tuple[Any, ...]]]) -> None:
    assert rows(f".decl r(x: number)\nr({'+'.join(['1'] * 150)}).\nr({'(1-' * 150}0{')' * 150}).\n") == [(0,), (150,)]


@pytest.mark.parametrize("pattern", ["(a+)+b", "(a|aa)*b", "(.*)(.*)(.*)(.*)x", "([a-z]+[0-9]*)+!", "(a*)*b", r"(\w+\s?)*-"])
def test_expressions_that_backtrack_are_bounded(
    load: Callable[[str], Program], pattern: str, at_most: Callable[[float], AbstractContextManager[None]]
) -> None:
    program = load(
        '.decl s(x: symbol)\n.input s\n.decl r(x: symbol)\n.output r\nr(x) :- s(x), match("PATTERN", x).\n'.replace(
            "PATTERN", pattern.replace("\\", "\\\\")
        )
    )
    with at_most(10):
        assert program.evaluate({"s": [("a" * 5000,)]}).rows("r") == []


def test_an_expression_without_a_bound_is_refused(load: Callable[[str], Program]) -> None:
    source = '.decl s(x: symbol)\ns("(a+)+\\\\1b").\n.decl r(x: symbol)\n.output r\n'
    reason = "regular expression that may take for ever, with a backward reference, a look-ahead or too many repetitions: `(a+)+\\1b`"
    with pytest.raises(DatalogError) as caught:
        load(source + "r(x) :- s(x), match(x, x).\n").evaluate({})
    assert caught.value.diagnostics[0].message == reason
    with pytest.raises(DatalogError) as caught:
        load(source + 'r(x) :- s(x), match("(a+)+\\\\1b", x).\n')
    assert str(caught.value.diagnostics[0].location).endswith("p.dl:5:21")
    with pytest.raises(EvaluationError):
        full_match("(a+)+(?=b)")


ATOMS = [
    "a",
    "b",
    ".",
    "[ab]",
    "[^a{]",
    r"\d",
    r"\w",
    r"\W",
    r"\s",
    r"[\S1]",
    r"\b",
    "(a|b)",
    "(ab|a)",
    "c",
    "^",
    "$",
    "(a*)",
    r"\.",
    r"\x61",
]
REPEATS = ["", "", "*", "+", "?", "{1,2}", "{2}", "{1,}", "*?"]


@given(st.lists(st.tuples(st.sampled_from(ATOMS), st.sampled_from(REPEATS)), min_size=1, max_size=6), st.booleans(), st.integers())
def test_linear_matching_agrees_with_backtracking(parts: list[tuple[str, str]], repeated: bool, seed: int) -> None:
    pattern = "".join(atom + repeat for atom, repeat in parts)
    pattern = f"({pattern})*" if repeated else pattern
    try:
        compiled = re.compile(pattern, re.DOTALL | re.ASCII)
    except re.error:
        return
    linear, source = _linear(list(_TOKEN.finditer(pattern)), pattern), random.Random(seed)
    for _ in range(10):
        text = "".join(source.choice("abc1. \v\u00e9\udc80") for _ in range(source.randrange(7)))
        assert (linear(text) is not None) == (compiled.fullmatch(text) is not None), (pattern, text)


@pytest.mark.parametrize(
    ("pattern", "bounded"),
    [
        ("[a-z]+[0-9]*", True),
        (".*(a|b).*", True),
        ("(abc){2,9}", True),
        (r"\(.*[*+(]{3}\[x]*\*", True),
        (".*a.*b.*", False),
        ("(a|bc)*", False),
        ("(a?b){1,20}", False),
        ("((a+b))+", False),
    ],
)
def test_backtracking_is_for_what_it_does_fast(pattern: str, bounded: bool) -> None:
    assert isinstance(getattr(full_match(pattern), "__self__", None), re.Pattern) is bounded


def test_a_brace_is_a_character_within_brackets() -> None:
    matches = full_match("[^{]*[{]")
    assert matches is not None and matches("ab{") and not matches("a{b{")
    assert full_match("a{b") is None


def test_recursion_stops_at_a_size(load: Callable[[str], Program]) -> None:
    program = load(".decl a(x: number)\na(1).\na(x + 1) :- a(x), x < 1000.\n.limitsize a(n=47)\n.printsize a\n")
    assert program.evaluate({}, keep=["a"]).count("a") == 47


def test_wide_numbers(tmp_path: Path) -> None:
    (tmp_path / "p.dl").write_text(
        ".decl e(x: number)\n.input e\n.decl r(x: number, u: unsigned)\n.output r\nr(x * x, to_unsigned(x) - 4) :- e(x).\n"
    )
    narrow, wide = load_program(tmp_path / "p.dl"), load_program(tmp_path / "p.dl", bits=64)
    facts = {"e": [(3,), (100_000,)]}
    assert narrow.evaluate(facts).rows("r") == [(9, 2**32 - 1), (1_410_065_408, 99_996)]
    assert wide.evaluate(facts).rows("r") == [(9, 2**64 - 1), (10_000_000_000, 99_996)]
    with pytest.raises(DatalogError, match="numbers have 32 or 64 bits, not 16"):
        load_program(tmp_path / "p.dl", bits=16)


def test_subsumption_sees_rows_that_other_relations_get_later(rows: Callable[..., list[tuple[Any, ...]]]) -> None:
    source = """.decl same(a: number, b: number)
.decl r(a: number, b: number) btree_delete
same(x, x) :- r(x, _).
same(x, x) :- r(_, x).
same(x, y) :- same(y, x).
same(2, 3).
r(1, 2).
r(1, 3).
r(a, b) <= r(c, d) :- same(a, c), same(b, d), a <= c, b <= d.
"""
    assert rows(source) == [(1, 3)]
