"""User-defined functors as Python functions."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosarch.datalog import DatalogError, Program, load_program, query

SOURCE = """.type P = [x: number, s: symbol]
.type T = Leaf {n: number} | Pair {l: T, r: T}
.functor f({types}): {result}
.decl r(x: {result})
.output r
r(@f({args})).
"""


def program(folder: Path, types: str, result: str, args: str, function: Callable[..., Any] | None) -> Program:
    path = folder / "p.dl"
    text = SOURCE
    for name, value in (("types", types), ("result", result), ("args", args)):
        text = text.replace(f"{{{name}}}", value)
    path.write_text(text)
    return load_program(path, functors={} if function is None else {"f": function})


@pytest.mark.parametrize(
    ("types", "result", "args", "function", "expected"),
    [
        ("a: symbol", "symbol", '"ab c"', lambda s: s.title(), "Ab C"),
        ("number, number", "number", "7, 5", lambda a, b: a * b, 35),
        ("number", "number", "7", lambda a: 2**31 + a, -(2**31) + 7),
        ("number", "unsigned", "7", lambda a: -a, 2**32 - 7),
        ("float", "float", "0.5", lambda a: a / 3, 0.1666666716337204),
        ("P", "P", '[1, "a"]', lambda p: (p[0] + 1, p[1] * 2), (2, "aa")),
        ("P", "P", "nil", lambda p: p, None),
        ("T", "T", "$Leaf(3)", lambda t: ("Pair", t, ("Leaf", 4)), ("Pair", ("Leaf", 3), ("Leaf", 4))),
    ],
)
def test_values(tmp_path: Path, types: str, result: str, args: str, function: Callable[..., Any], expected: Any) -> None:
    assert program(tmp_path, types, result, args, function).evaluate({}).rows("r") == [(expected,)]


@pytest.mark.parametrize(
    ("function", "message"),
    [
        (None, "6:3: functor `@f` has no Python function, give one with `functors=` or `-l FILE.py`"),
        (lambda a: "x", "6:1: functor `@f` returned 'x', which is not of type `number`"),
        (lambda a: 1.5, "6:1: functor `@f` returned 1.5, which is not of type `number`"),
        (lambda a: 1 // 0, "6:1: functor `@f` failed: ZeroDivisionError: integer division or modulo by zero"),
    ],
)
def test_errors(tmp_path: Path, function: Callable[..., Any] | None, message: str) -> None:
    with pytest.raises(DatalogError) as caught:
        program(tmp_path, "number", "number", "1", function).evaluate({})
    assert caught.value.diagnostics[0].headline == f"{tmp_path}/p.dl:{message}"


def test_declarations_are_checked(tmp_path: Path) -> None:
    (tmp_path / "p.dl").write_text(".functor f(a: nambers): number\n.decl r(x: number)\nr(@f(1)).\n.functor f(): number\n")
    with pytest.raises(DatalogError) as caught:
        load_program(tmp_path / "p.dl")
    found = [d.headline.removeprefix(f"{tmp_path}/") for d in caught.value.diagnostics]
    assert found == [
        "p.dl:1:10: unknown type `nambers`, did you mean `number`?",
        "p.dl:4:10: functor `f` is already declared at " + f"{tmp_path}/p.dl:1:10",
    ]


def test_queries_may_call_them(tmp_path: Path) -> None:
    loaded = program(tmp_path, "number", "number", "1", lambda a: a + 1)
    assert query(loaded, loaded.evaluate({}, keep="all"), "r(X), Y = @f(X)").rows == ((2, 3),)
