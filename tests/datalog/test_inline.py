"""Relations that are inlined, and records that only meet each other."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosarch.datalog import Program, explain, proof_text

Rows = Callable[..., list[tuple[Any, ...]]]
NUMBERS = ".decl n(x: number)\nn(1). n(2). n(3).\n"


@pytest.mark.parametrize(
    ("rules", "expected"),
    [
        (".decl plus(a: number, b: number, c: number) inline\nplus(a, b, a + b).\nr(c) :- n(a), plus(a, 10, c).", [11, 12, 13]),
        (".decl less(a: number, b: number) inline\nless(a, b) :- a < b.\nr(a) :- n(a), less(a, 3).", [1, 2]),
        (".decl less(a: number, b: number) inline\nless(a, b) :- a < b.\nr(a) :- n(a), !less(a, 3).", [3]),
        (".decl odd(a: number) inline\nodd(a) :- a = 1.\nodd(a) :- a = 3.\nr(a) :- n(a), odd(a).", [1, 3]),
        (".decl odd(a: number) inline\nodd(a) :- a = 1.\nodd(a) :- a = 3.\nr(a) :- n(a), !odd(a).", [2]),
        (".decl same(a: number, b: number) inline\nsame(x, x) :- true.\nr(a) :- n(a), n(b), b = a + 1, !same(a, b).", [1, 2]),
        (".decl near(a: number, b: number) inline\nnear(a, b) :- b = a + 1.\nr(c) :- n(a), c = count : { n(b), near(a, b) }.", [0, 1]),
        (
            ".decl a(x: number, y: number) inline\n.decl b(x: number, y: number) inline\n"
            "a(x, y) :- y = x * 2.\nb(x, y) :- a(x, z), a(z, y).\nr(y) :- n(x), b(x, y).",
            [4, 8, 12],
        ),
        (".decl pair(x: number, y: number) inline\npair(x, y) :- n(x), n(y).\nr(x) :- pair(x, x), x < 3.", [1, 2]),
        ("r(x) :- n(x), a = [x, 5], b = a, b = [y, 5], y > 1.", [2, 3]),
        ("r(x) :- n(x), [x, [2, 3]] = [y, z], z = [y, 3].", [2]),
        ("r(x) :- n(x), [x, x] != [1, 2].", [1, 2, 3]),
        ("r(x) :- n(x), _ = [x], [x, 1] != [1, 1].", [2, 3]),
    ],
)
def test_rows(rows: Rows, rules: str, expected: list[int]) -> None:
    assert rows(f"{NUMBERS}.decl r(x: number)\n{rules}\n") == [(x,) for x in expected]


def test_a_product_that_is_only_looked_into_is_never_made(rows: Rows) -> None:
    source = """.decl n(x: number)
n(0). n(x + 1) :- n(x), x < 20000.
.decl pair(x: number, y: number) inline
pair(x, y) :- n(x), n(y).
.decl r(x: number)
r(x) :- pair(x, x), x < 2.
"""
    assert rows(source) == [(0,), (1,)]


@pytest.mark.parametrize(
    ("rules", "message"),
    [
        (
            ".decl a(x: number) inline\n.decl b(x: number) inline\na(x) :- b(x).\nb(x) :- a(x).",
            "p.dl:5:1: relation `a` cannot be inlined: it is recursive",
        ),
        (
            ".decl a(x: number) inline\na(x) :- x = y, n(z), z < y, y = x.\n.decl r(x: number)\nr(x) :- n(x), !a(x).",
            "p.dl:6:16: relation `a` is inlined here, and its negation would leave variables without a value",
        ),
        (".decl a(x: number) inline\na(x) :- x > 1.\n.decl r(x: number)\nr(x) :- a(x).", "p.dl:6:3: ungrounded variable `x`"),
        (".decl a(x: number) inline\n.output a\na(1).", "p.dl:4:9: `a` is inline and has no rows to read or write"),
    ],
)
def test_errors(errors: Callable[[str], str], rules: str, message: str) -> None:
    assert errors(f"{NUMBERS}{rules}\n").splitlines()[0] == message


def test_explanations_speak_of_the_clause_as_written(load: Callable[[str], Program], tmp_path: Path) -> None:
    program = load(
        f"{NUMBERS}.decl plus(a: number, b: number) inline\nplus(a, b) :- b = a + 1.\n.decl r(x: number)\n.output r\nr(y) :- n(x), plus(x, y).\n"
    )
    text = proof_text(explain(program, program.evaluate({}, keep="all"), "r(4)")).replace(f"{tmp_path}/", "")
    assert text == "r(4)  p.dl:7\n├─ n(3)  p.dl:2\n└─ 4 = 3 + 1\n"
