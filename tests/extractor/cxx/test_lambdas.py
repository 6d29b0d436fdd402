"""Lambdas: each has a body that is a function of its own."""

from __future__ import annotations

import pytest


def owner_of_returns(facts) -> dict[str, str]:
    names = dict(facts["function_name"])
    return {facts.show(value): str(names[function]) for function, value in facts["return_value"]}


@pytest.mark.parametrize(
    "capture",
    [
        "",
        "&",
        "this",
        pytest.param("n"),
        "&n",
        pytest.param("="),
        pytest.param("k = n"),
        pytest.param("this, n"),
    ],
)
def test_the_body_is_a_function_of_its_own(facts_of, capture: str) -> None:
    used = {"": "x", "this": "field_", "k = n": "k"}.get(capture, "n")
    facts = facts_of(
        f"struct C {{ int field_; int m() {{ int n = 1; auto l = [{capture}](int x) {{ return x + {used}; }}; l(3); return n; }} }};"
    )
    (lambda_,) = [function for function, kind in facts["function"] if kind == "lambda"]
    assert (lambda_,) in facts["function_defined"]
    assert owner_of_returns(facts) == {f"(x + {used})": "lambda", "n": "C::m"}
    assert facts.flow("C::m").startswith("0: 1; lambda ")
    assert facts.flow("lambda") == f"0: (x + {used}) -> next exit"


def test_parameters_and_location(facts_of) -> None:
    facts = facts_of("void f() {\n  auto l = [](int x, double) { return x; };\n}")
    ((expr, function),) = facts["lambda"]
    assert facts.all("location", function) == [("@", 2, 12)]
    assert facts.all("location", expr) == [("@", 2, 12)]
    assert [(index, facts.one("variable_type", parameter)) for index, parameter in facts.all("function_parameter", function)] == [
        (0, "int"),
        (1, "double"),
    ]
    assert facts.all("function_class", function) == []


def test_a_lambda_is_an_argument(facts_of) -> None:
    facts = facts_of("#include <functional>\nvoid take(std::function<void(int)> fn); void g(int); void f() { take([](int x) { g(x); }); }")
    assert [facts.show(a) for a in facts.arguments(facts.call("take"))] == ["lambda 2:70"]
    owners = {facts.show(call): facts.one("expr_function", call) for call in facts.calls()}
    assert owners["g(x)"] == "lambda@:2:70"
    assert owners["take(lambda 2:70)"] == "f@:2:59"


def test_nested_lambdas(facts_of) -> None:
    facts = facts_of("void g(int); void f() { auto a = [&] { auto b = [&] { g(1); }; g(2); b(); }; a(); g(3); }")
    owners = {facts.show(call): str(facts.one("expr_function", call)) for call in facts.calls() if facts.show(call).startswith("g")}
    assert owners == {"g(1)": "lambda@:1:49", "g(2)": "lambda@:1:34", "g(3)": "f@:1:19"}


def test_a_called_lambda_is_an_operand(facts_of) -> None:
    facts = facts_of("void f() { auto l = [](int x) { return x; }; int y = l(4); [] { return 5; }(); }")
    shown = [facts.show(expr) for expr, operator in facts["operator"] if operator == "()"]
    assert shown == ["()(l, 4)", "()(lambda 1:60)"]


def test_this_in_a_lambda_is_that_of_the_class(facts_of) -> None:
    facts = facts_of("struct C { void cb(int); void m() { auto l = [this](int x) { cb(x); }; l(1); } };")
    receiver = facts.one("call_receiver", facts.call("cb"))
    assert facts.one("this_use", receiver) == "C"


def test_a_generic_lambda_with_captures_as_callback(facts_of) -> None:
    facts = facts_of("template <class F> void take(F f); void g(int, int); void f(int n) { take([n](auto x) { g(n, 1); }); g(0, 0); }")
    owners = {
        facts.show(call): str(facts.one("expr_function", call)).partition("@")[0]
        for call in facts.calls()
        if facts.show(call).startswith("g(")
    }
    assert owners == {"g(n, 1)": "lambda", "g(0, 0)": "f"}


def test_what_is_captured_by_name(facts_of) -> None:
    facts = facts_of("void f(int p) { int n = 1, o = 2; auto l = [n, &p, m = n] { return m; }; auto k = [&, o] { return n; }; }")
    captured: dict[str, list[str]] = {}
    for expr, variable in facts["lambda_captures"]:
        captured.setdefault(facts.show(expr), []).append(str(variable).partition("@")[0])
    assert captured == {"lambda 1:44": ["f", "m", "n"], "lambda 1:83": ["o"]}
