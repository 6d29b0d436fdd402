"""Errors and warnings, by exact text."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from rosarch.datalog import DatalogError, Program

DECLS = ".type A <: symbol\n.type B <: symbol\n.decl a(x: A)\n.decl b(x: B)\n.decl n(x: number)\n.decl publisher(x: symbol)\n"


@pytest.mark.parametrize(
    ("clause", "expected"),
    [
        ("a(x) :- publihser(x).", "7:9: unknown relation `publihser`, did you mean `publisher`?"),
        ("a(x, y) :- b(x), b(y).", "7:1: `a` has 1 attribute, given 2, declared `a(x)`"),
        ("a(x) :- b(x).", "7:3: variable `x` is of type `B`, but `a.x` is of type `A`"),
        ("a(x) :- a(x), b(x).", "7:3: no type fits variable `x`, `A` in `a` but `B` in `b`"),
        ("n(x) :- publisher(x).", "7:3: no type fits variable `x`"),
        ("a(1).", "7:3: numeric constant where `A` (`a.x`) is expected"),
        ('n("x").', "7:3: symbol constant where `number` (`n.x`) is expected"),
        ("n(2147483648).", "7:3: constant `2147483648` is not a valid number"),
        ("n(x) :- n(y), y < 3.", "7:3: ungrounded variable `x`"),
        ("n(1) :- n(y), !publisher(x), y > 1.", "7:26: ungrounded variable `x` in a negation"),
        ("n(_).", "7:3: `_` in the head of a clause"),
        ("n(strlen(1)).", "7:3: `strlen` is not defined for (number)"),
        ('n(x) :- x = strlen("a", "b").', "7:13: `strlen` does not take 2 arguments"),
        ('n(x) :- n(y), x = y + "a".', "7:19: `+` is not defined for (number, symbol)"),
        ("n(x) :- n(x), x = as(1, foo).", "7:19: unknown type `foo`"),
        ("n(x) :- n(x), x = $Foo().", "7:19: unknown branch `Foo`"),
        ("n(autoinc()) :- n(_).", "7:3: `autoinc()` in a recursive rule"),
        (".decl n(x: number)", "7:7: relation `n` is already declared at p.dl:5:7"),
        (".decl m(x: numbre)", "7:12: unknown type `numbre`, did you mean `number`?"),
        (".decl m(x: A, x: A)", "7:18: attribute `x` is declared twice"),
        (".type A <: number", "7:7: type `A` is already declared at p.dl:1:7"),
        (".type C <: D", "7:7: unknown type `D`"),
        (".type U = A | number", "7:7: union type `U` mixes primitive types (number, symbol)"),
        (".output pubisher", "7:9: unknown relation `pubisher`, did you mean `publisher`?"),
        ("n(x) :- n(x)", "7:13: syntax error, unexpected end of file"),
        ("n(x) :- n(x),, n(x).", "7:14: syntax error, unexpected `,`, expected `(` or an identifier"),
        ('publisher("a).', "7:11: unterminated string"),
        ("n(x) :- n(x), !b(y), n(z), x = z.", "7:18: ungrounded variable `y` in a negation"),
    ],
)
def test_error(errors: Callable[[str], str], clause: str, expected: str) -> None:
    headlines = [line for line in errors(DECLS + clause + "\n").splitlines() if line.startswith("p.dl")]
    assert headlines[0] == f"p.dl:{expected}"


def test_error_shows_the_source_line_and_a_caret(errors: Callable[[str], str]) -> None:
    assert errors(DECLS + "a(x) :- publihser(x).\n") == (
        "p.dl:7:9: unknown relation `publihser`, did you mean `publisher`?\n    a(x) :- publihser(x).\n            ^"
    )


def test_negation_in_a_cycle(errors: Callable[[str], str]) -> None:
    source = ".decl p(x: number)\n.decl q(x: number)\n.decl n(x: number)\np(x) :- n(x), !q(x).\nq(x) :- p(x).\n"
    assert errors(source).splitlines()[0] == "p.dl:4:16: cannot stratify: negation of `q` in a cycle: p -> q -> p"


def test_aggregate_in_a_cycle(errors: Callable[[str], str]) -> None:
    source = ".decl p(x: number)\np(x) :- x = count : { p(_) }.\n"
    assert errors(source).splitlines()[0] == "p.dl:2:23: cannot stratify: aggregate of `p` in a cycle: p -> p"


def test_all_errors_are_reported_together(errors: Callable[[str], str]) -> None:
    source = DECLS + "a(x) :- c(x).\nn(x) :- n(y), y > 1.\nb(1).\nsyntax error here\nb(z) :- b(.\n"
    places = [line.split(" ")[0] for line in errors(source).splitlines() if line.startswith("p.dl")]
    assert places == ["p.dl:7:9:", "p.dl:8:3:", "p.dl:9:3:", "p.dl:10:8:", "p.dl:11:11:"]


def test_unused_variable_is_a_warning(load: Callable[[str], Program]) -> None:
    program = load(".decl p(x: number, y: number)\n.decl q(x: number)\nq(x) :- p(x, y).\nq(x) :- p(_y, x).\n")
    assert [w.headline.split(":", 1)[1] for w in program.warnings] == ["3:14: warning: variable `y` occurs only once, write `_` or `_y`"]


def test_runtime_error_names_the_rule(load: Callable[[str], Program]) -> None:
    program = load(".decl p(x: number)\n.output p\n.decl z(x: number)\nz(0).\np(1 / x) :- z(x).\n")
    with pytest.raises(DatalogError, match=r"p\.dl:5:1: division by zero"):
        program.evaluate({})


def test_runaway_recursion_is_stopped(load: Callable[[str], Program]) -> None:
    program = load(".decl p(x: number)\n.output p\np(0).\np(x + 1) :- p(x).\n")
    with pytest.raises(DatalogError, match=r"p\.dl:4:1: evaluation stopped, `p`: more than 1000 rows"):
        program.evaluate({}, limit_rows=1000)
    with pytest.raises(DatalogError, match=r"p\.dl:4:1: evaluation stopped, `p`: still running after 0.05 s"):
        program.evaluate({}, time_limit=0.05)
