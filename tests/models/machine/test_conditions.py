"""Reading conditions, and what they mean, against a reference that evaluates them on values."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from typing import Any as Anything

import pytest
from hypothesis import given
from hypothesis import strategies as st
from machine_documents import document

from rosarch.base.logic import FALSE, TRUE, All, Any, Not
from rosarch.models.machine.cells import Domains
from rosarch.models.machine.conditions import (
    Comparison,
    Condition,
    Operand,
    choice,
    compact,
    constant,
    number,
    parse_condition,
    strip,
)
from rosarch.models.machine.logic import evaluate
from rosarch.models.machine.meaning import Meaning

A, B = Operand("a"), Operand("b")


@pytest.mark.parametrize(
    ("text", "condition"),
    [
        ("a", A),
        ("!a", Not(A)),
        ("!!a", A),
        ("not a", Not(A)),
        ("a && b", All((A, B))),
        ("a and b", All((A, B))),
        ("a && (b && c)", All((A, B, Operand("c")))),
        ("a || b && c", Any((A, All((B, Operand("c")))))),
        ("(a || b) && c", All((Any((A, B)), Operand("c")))),
        ("!(a && b)", Not(All((A, B)))),
        ("a == true", A),
        ("false == a", Not(A)),
        ("a != true", Not(A)),
        ("true", TRUE),
        ("!true", FALSE),
        ("x == 3", Comparison("==", "x", "3")),
        ("3 == x", Comparison("==", "x", "3")),
        ("x != 3", Not(Comparison("==", "x", "3"))),
        ("3 < x", Comparison(">", "x", "3")),
        ("x is None", Comparison("==", "x", "None")),
        ("x is not None", Not(Comparison("==", "x", "None"))),
        ("x == True", Comparison("==", "x", "True")),
        ("x != True", Not(Comparison("==", "x", "True"))),
        ("(x > 3) == True", Comparison(">", "x", "3")),
        ("x is True", Comparison("is", "x", "True")),
        ("x is not False", Not(Comparison("is", "x", "False"))),
        ("(x == 3) is True", Comparison("==", "x", "3")),
        ("static_cast<Mode>(m->mode) == Mode::AUTO", Comparison("==", "m->mode", "Mode::AUTO")),
        ("f(a && b, c) > 3.0f", Comparison(">", "f(a && b, c)", "3.0f")),
        ("std::max<int>(a, b) == 2", Comparison("==", "std::max<int>(a, b)", "2")),
        ("a < b && c > d", All((Comparison("<", "a", "b"), Comparison(">", "c", "d")))),
        ("s == \"a && b\"", Comparison("==", "s", '"a && b"')),
        ("c == '('", Comparison("==", "c", "'('")),
        ("(n = read(fd, buf, 8)) >= 0", Comparison(">=", "n = read(fd, buf, 8)", "0")),
    ],
)  # fmt: skip
def test_reads_the_logical_skeleton(text: str, condition: Condition) -> None:
    assert parse_condition(text) == condition


@pytest.mark.parametrize("text", ["", "   ", "((", ")", "a ? b : c", "x = 3", "0 < x < 3", "x ==", "&&", "a ]", "@#$", "lambda: a", "(" * 200 + "a" + ")" * 200, "! " * 9000 + "a"])  # fmt: skip
def test_what_is_not_understood_is_one_condition(text: str) -> None:
    assert parse_condition(text) in (Operand(" ".join(text.split())), Operand(""), All((Operand(""), Operand(""))))


@given(st.text(max_size=60))
def test_no_text_is_an_error(text: str) -> None:
    parse_condition(text)
    constant(text)
    compact(text)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("true", "true"), ("False", "false"), ("NULL", "null"), ("nullptr", "null"), ("None", "null"), ("0", "0"), ("0.0f", "0"), ("-1", "-1"),
        ("1.5", "1.5"), ("0x10", "16"), ("010", "8"), ("0o10", "8"), ("0b101", "5"), ("1'000", "1000"), ("1_000", "1000"), ("08", None), ("10UL", "10"), ("IDLE", "IDLE"), ("Mode::AUTO", "AUTO"), ("a::Mode::idle", "idle"), ("kIdle", "kIdle"),
        ("State.IDLE", "IDLE"), ('"red"', '"red"'), ("'q'", "'q'"), ("(3)", "3"), ("static_cast<int>(3)", "3"),
        ("mode", None), ("mode_", None), ("msg->data", None), ("f()", None), ("a + 1", None), ("Mode::get()", None), ("", None),
    ],
)  # fmt: skip
def test_constants(text: str, value: str | None) -> None:
    assert constant(text) == value


def test_operands_without_what_changes_no_value() -> None:
    assert strip("((static_cast<bool>( (m->x) )))") == "m->x"
    assert strip("(a) + (b)") == "(a) + (b)"
    assert compact("this->mode_  ==  A") == "mode_==A"
    assert compact("unsigned  int x") == "unsigned int x"


SPELLINGS: Mapping[str, Callable[[Anything, Anything], bool]] = {
    "==": operator.eq, "!=": operator.ne, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
}  # fmt: skip
FLAGS, NUMBERS, MODES = ("a_", "b_"), ("0", "1", "2"), ("IDLE", "BUSY")
NODE = dict(
    variables=[*((f"N::{flag}", "bool", "false") for flag in FLAGS), ("N::n_", "int", "0"), ("N::m_", "Mode", "Mode::IDLE")],
    transitions=[
        *((f"N::{flag}", "in", None, "msg.data") for flag in FLAGS),
        *(("N::n_", "in", None, value) for value in NUMBERS),
        *(("N::m_", "in", None, f"Mode::{value}") for value in MODES),
    ],
)
Spelled = tuple[str, Callable[[Mapping[str, Anything]], bool]]


def atom() -> st.SearchStrategy[Spelled]:
    flags = st.sampled_from(FLAGS).flatmap(
        lambda name: st.sampled_from(
            [(name, True), (f"{name} == true", True), (f"{name} != true", False), (f"false == this->{name}", False)]
        ).map(lambda pair: (pair[0], lambda values: values[name] is pair[1]))
    )
    numbers = st.tuples(st.sampled_from(sorted(SPELLINGS)), st.integers(-1, 3), st.booleans()).map(
        lambda t: (
            (f"{t[1]} {t[0]} n_", lambda values: SPELLINGS[t[0]](t[1], values["n_"]))
            if t[2]
            else (f"n_ {t[0]} {t[1]}", lambda values: SPELLINGS[t[0]](values["n_"], t[1]))
        )
    )
    modes = st.tuples(st.sampled_from(["==", "!="]), st.sampled_from(MODES)).map(
        lambda t: (f"m_ {t[0]} Mode::{t[1]}", lambda values: SPELLINGS[t[0]](values["m_"], t[1]))
    )
    return st.one_of(flags, numbers, modes)


def larger(inner: st.SearchStrategy[Spelled]) -> st.SearchStrategy[Spelled]:
    def join(word: str, parts: list[Spelled]) -> Spelled:
        decide = all if word == "&&" else any
        return f" {word} ".join(f"({text})" for text, _ in parts), lambda values: decide(f(values) for _, f in parts)

    joined = st.tuples(st.sampled_from(["&&", "||"]), st.lists(inner, min_size=2, max_size=3)).map(lambda t: join(*t))
    return st.one_of(joined, inner.map(lambda part: (f"!({part[0]})", lambda values: not part[1](values))))


@given(
    st.recursive(atom(), larger, max_leaves=8),
    st.fixed_dictionaries({"a_": st.booleans(), "b_": st.booleans(), "n_": st.integers(0, 2), "m_": st.sampled_from(MODES)}),
)
def test_guards_hold_where_the_reference_says(spelled: Spelled, values: Mapping[str, Anything]) -> None:
    text, reference = spelled
    node = document(variables=NODE["variables"], transitions=[*NODE["transitions"], ("N::a_", "in", text, "true")])
    formula = Meaning(Domains(node)).formula(parse_condition(text), "N")
    seen = {f"N::{name}": str(value).lower() if isinstance(value, bool) else str(value) for name, value in values.items()}
    assert evaluate(formula, lambda subject: seen[subject.key]) is reference(values), text


def test_numbers_in_conditions() -> None:
    assert [number(text) for text in ("1.5e3", ".5", "- 2", "0x1F", "5u", "x", "1 2")] == [1500.0, 0.5, -2.0, 31.0, 5.0, None, None]


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("mode_ == Mode::A ? Mode::B : Mode::A", ("mode_ == Mode::A", "Mode::B", "Mode::A")),
        ("(ready ? 1 : 0)", ("ready", "1", "0")),
        ("a ? b ? c : d : e", ("a", "b ? c : d", "e")),
        ("Mode.A if self.mode == Mode.B else Mode.B", ("self.mode == Mode.B", "Mode.A", "Mode.B")),
        ("x[1:2]", None), ("f(a ? b : c)", None), ("x if y", None), ("ready", None),
    ],
)  # fmt: skip
def test_a_choice_is_a_condition_and_what_it_chooses_between(text: str, parts: tuple[str, str, str] | None) -> None:
    assert choice(text) == parts
