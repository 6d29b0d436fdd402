"""Control-flow graphs: one canonical text per form of statement."""

from __future__ import annotations

import pytest

HEAD = "bool a(); bool b(); int c(int); void d(); void e(); void g();\n"

# statement, then the graph: `block: what is evaluated ? condition [loop] -> label successor`
FORMS = {
    "sequence": ("d(); e();", ["0: d(); e() -> next exit"]),
    "blocks": ("{ { d(); } e(); }", ["0: d(); e() -> next exit"]),
    "comma": ("d(), e();", ["0: d(); e() -> next exit"]),
    "if": ("if (a()) d(); e();", ["0: a() ? a() -> false 1, true 2", "1: -> next 3", "2: d() -> next 3", "3: e() -> next exit"]),
    "if else": ("if (a()) d(); else e(); g();", ["0: a() ? a() -> false 1, true 2", "1: e() -> next 3", "2: d() -> next 3", "3: g() -> next exit"]),
    "if else chain": (
        "if (a()) d(); else if (b()) e(); else g(); d();",
        ["0: a() ? a() -> false 1, true 2", "1: b() ? b() -> false 3, true 4", "2: d() -> next 5", "3: g() -> next 6", "4: e() -> next 6", "5: d() -> next exit", "6: -> next 5"],
    ),
    "if with empty arm": ("if (a()) ; else d(); e();", ["0: a() ? a() -> false 1, true 2", "1: d() -> next 3", "2: -> next 3", "3: e() -> next exit"]),
    "if with declaration": ("if (int n = c(1)) d(); e();", ["0: c(1) ? n -> false 1, true 2", "1: -> next 3", "2: d() -> next 3", "3: e() -> next exit"]),
    "if with initialiser": ("if (int n = c(1); n > 2) d(); e();", ["0: c(1) ? (n > 2) -> false 1, true 2", "1: -> next 3", "2: d() -> next 3", "3: e() -> next exit"]),
    "early return": ("if (!a()) return; d();", ["0: a() ? !(a()) -> false 1, true 2", "1: -> next 3", "2: -> next exit", "3: d() -> next exit"]),
    "dead code": ("return; d();", ["0: -> next exit", "1: unreached d() -> next exit"]),
    "while": ("while (a()) { d(); } e();", ["0: -> next 1", "1: a() ? a() [while] -> false 2, true 3", "2: e() -> next exit", "3: d() -> next 1"]),
    "while with declaration": ("while (int n = c(1)) d(); e();", ["0: -> next 1", "1: c(1) ? n [while] -> false 2, true 3", "2: e() -> next exit", "3: d() -> next 1"]),
    "while with return": (
        "while (a()) { if (b()) return; d(); }",
        ["0: -> next 1", "1: a() ? a() [while] -> false 2, true 3", "2: -> next exit", "3: b() ? b() -> false 4, true 5", "4: -> next 6", "5: -> next exit", "6: d() -> next 1"],
    ),
    "while with break and continue": (
        "while (a()) { if (b()) break; if (c(1)) continue; d(); } e();",
        [
            "0: -> next 1", "1: a() ? a() [while] -> false 2, true 3", "2: e() -> next exit", "3: b() ? b() -> false 4, true 5", "4: -> next 6", "5: -> next 2",
            "6: c(1) ? c(1) -> false 7, true 8", "7: -> next 9", "8: -> next 1", "9: d() -> next 1",
        ],
    ),
    "nested loops": (
        "while (a()) while (b()) { if (c(1)) break; d(); } e();",
        [
            "0: -> next 1", "1: a() ? a() [while] -> false 2, true 3", "2: e() -> next exit", "3: -> next 4", "4: b() ? b() [while] -> false 5, true 6",
            "5: -> next 1", "6: c(1) ? c(1) -> false 7, true 8", "7: -> next 9", "8: -> next 5", "9: d() -> next 4",
        ],
    ),
    "do": ("do d(); while (a()); e();", ["0: -> next 1", "1: d() -> next 2", "2: a() ? a() [do] -> false 3, true 1", "3: e() -> next exit"]),
    "do with continue": (
        "do { d(); if (b()) continue; e(); } while (a()); g();",
        ["0: -> next 1", "1: d(); b() ? b() -> false 2, true 3", "2: -> next 4", "3: -> next 5", "4: e() -> next 5", "5: a() ? a() [do] -> false 6, true 1", "6: g() -> next exit"],
    ),
    "for": ("for (int i = 0; i < 3; i++) { d(); } e();", ["0: 0 -> next 1", "1: ? (i < 3) [for] -> false 2, true 3", "2: e() -> next exit", "3: d() -> next 4", "4: ++(i) -> next 1"]),
    "for with continue": (
        "for (int i = 0, n = c(1); i < n; i++, d()) { if (a()) continue; e(); }",
        ["0: 0; c(1) -> next 1", "1: ? (i < n) [for] -> false 2, true 3", "2: -> next exit", "3: a() ? a() -> false 4, true 5", "4: -> next 6", "5: -> next 7", "6: e() -> next 7", "7: ++(i); d() -> next 1"],
    ),
    "for without parts": (
        "for (;;) { if (a()) break; d(); } e();",
        ["0: -> next 1", "1: [for] -> next 2", "2: a() ? a() -> false 3, true 4", "3: -> next 5", "4: -> next 6", "5: d() -> next 7", "6: e() -> next exit", "7: -> next 1"],
    ),
    "for with condition only": ("for (; a();) d(); e();", ["0: -> next 1", "1: a() ? a() [for] -> false 2, true 3", "2: e() -> next exit", "3: d() -> next 4", "4: -> next 1"]),
    "for with step only": (
        "for (;; g()) { if (a()) break; d(); } e();",
        ["0: -> next 1", "1: [for] -> next 2", "2: a() ? a() -> false 3, true 4", "3: -> next 5", "4: -> next 6", "5: d() -> next 7", "6: e() -> next exit", "7: g() -> next 1"],
    ),
    "for with start only": ("for (d();;) { if (a()) break; } e();", ["0: d() -> next 1", "1: [for] -> next 2", "2: a() ? a() -> false 3, true 4", "3: -> next 5", "4: -> next 6", "5: -> next 7", "6: e() -> next exit", "7: -> next 1"]),
    "for with semicolons in a call": (
        "for (d(); a(); c([] { d(); return 1; }())) ; e();",
        ["0: d() -> next 1", "1: a() ? a() [for] -> false 2, true 3", "2: e() -> next exit", "3: -> next 4", "4: ()(lambda 2:29); c(()(lambda 2:29)) -> next 1"],
    ),
    "range for": ("int xs[2] = {1, 2}; for (int x : xs) c(x); e();", ["0: {}(1, 2) -> next 1", "1: ? xs [range_for] -> false 2, true 3", "2: e() -> next exit", "3: c(x) -> next 1"]),
    "range for with break": (
        "int xs[2] = {1, 2}; for (int x : xs) { if (c(x)) break; d(); } e();",
        ["0: {}(1, 2) -> next 1", "1: ? xs [range_for] -> false 2, true 3", "2: e() -> next exit", "3: c(x) ? c(x) -> false 4, true 5", "4: -> next 6", "5: -> next 2", "6: d() -> next 1"],
    ),
    "switch": (
        "switch (c(1)) { case 1: d(); case 2: e(); break; case 3: case 4: g(); break; default: a(); } b();",
        [
            "0: c(1) ? c(1) -> case 1 1, case 2 2, case 3 3, case 4 4, default 5", "1: d() -> next 2", "2: e() -> next 6", "3: -> next 4",
            "4: g() -> next 6", "5: a() -> next 6", "6: b() -> next exit",
        ],
    ),
    "switch without default": ("switch (c(1)) { case 1: d(); break; } e();", ["0: c(1) ? c(1) -> case 1 1, default 2", "1: d() -> next 2", "2: e() -> next exit"]),
    "switch with blocks": (
        "switch (c(1)) { case 1: { d(); break; } default: { e(); } } g();",
        ["0: c(1) ? c(1) -> case 1 1, default 2", "1: d() -> next 3", "2: e() -> next 3", "3: g() -> next exit"],
    ),
    "switch with default first": (
        "switch (c(1)) { default: d(); case 1: e(); } g();",
        ["0: c(1) ? c(1) -> case 1 1, default 2", "1: e() -> next 3", "2: d() -> next 1", "3: g() -> next exit"],
    ),
    "continue within a switch": (
        "while (a()) { switch (c(1)) { case 1: continue; case 2: break; } d(); } e();",
        [
            "0: -> next 1", "1: a() ? a() [while] -> false 2, true 3", "2: e() -> next exit", "3: c(1) ? c(1) -> case 1 4, case 2 5, default 6",
            "4: -> next 1", "5: -> next 6", "6: d() -> next 1",
        ],
    ),
    "throw": ("if (a()) throw 1; d();", ["0: a() ? a() -> false 1, true 2", "1: -> next 3", "2: throw(1) -> exception exit", "3: d() -> next exit"]),
    "try": (
        "try { d(); if (a()) throw 1; e(); } catch (int x) { g(); } catch (...) { throw; } b();",
        [
            "0: -> next 1", "1: d(); a() ? a() -> exception 2, exception 3, false 4, true 5", "2: g() -> next 6", "3: throw() -> exception exit",
            "4: -> exception 2, exception 3, next 7", "5: throw(1) -> exception 2, exception 3", "6: b() -> next exit", "7: e() -> exception 2, exception 3, next 6",
        ],
    ),
    "return from try": ("try { d(); return; } catch (...) { e(); } g();", ["0: -> next 1", "1: d() -> exception 2, next exit", "2: e() -> next 3", "3: g() -> next exit"]),
    "goto": (
        "again: d(); if (a()) goto again; if (b()) goto end; e(); end: g();",
        [
            "0: -> next 1", "1: d(); a() ? a() -> false 2, true 3", "2: -> next 4", "3: -> next 1", "4: b() ? b() -> false 5, true 6", "5: -> next 7", "6: -> next 8",
            "7: e() -> next 8", "8: g() -> next exit",
        ],
    ),
    "and": ("if (a() && b()) d(); e();", ["0: a() ? a() -> false 1, true 2", "1: ? (a() && b()) -> false 3, true 4", "2: b() -> next 1", "3: -> next 5", "4: d() -> next 5", "5: e() -> next exit"]),
    "or": ("if (a() || b()) d(); e();", ["0: a() ? a() -> false 1, true 2", "1: b() -> next 2", "2: ? (a() || b()) -> false 3, true 4", "3: -> next 5", "4: d() -> next 5", "5: e() -> next exit"]),
    "and in a loop": ("while (a() && b()) d();", ["0: -> next 1", "1: a() ? a() -> false 2, true 3", "2: ? (a() && b()) [while] -> false 4, true 5", "3: b() -> next 2", "4: -> next exit", "5: d() -> next 1"]),
    "and without calls": ("bool x = true, y = x && !x; d();", ["0: true; (x && !(x)); d() -> next exit"]),
    "ternary without calls": ("int y = 0; int x = a() ? y : 2; d();", ["0: 0; a(); ?:(a(), y, 2); d() -> next exit"]),
    "lambda": ("auto l = [] { if (a()) return 1; return 2; }; l(); d();", ["0: lambda 2:21; ()(l); d() -> next exit"]),
    "assignment": ("int x = 1; x = c(x); x += 2; x++;", ["0: 1; c(x); (x = c(x)); (x += 2); ++(x) -> next exit"]),
    "constant condition": ("if (false) d(); e();", ["0: ? false -> false 1, true 2", "1: -> next 3", "2: d() -> next 3", "3: e() -> next exit"]),
}  # fmt: skip


@pytest.mark.parametrize("form", FORMS)
def test_the_graph_of(facts_of, form: str) -> None:
    statement, graph = FORMS[form]
    assert facts_of(f"{HEAD}void f() {{ {statement} }}").flow("f").splitlines() == graph


def test_the_body_of_a_lambda_has_its_own_graph(facts_of) -> None:
    facts = facts_of(f"{HEAD}void f() {{ auto l = [] {{ if (a()) return 1; return 2; }}; }}")
    assert facts.flow("lambda").splitlines() == [
        "0: a() ? a() -> false 1, true 2",
        "1: -> next 3",
        "2: 1 -> next exit",
        "3: 2 -> next exit",
    ]


def guards(facts, wanted: str) -> set[str]:
    """Labels of the edges into the block that evaluates `wanted`."""
    (block,) = [block for block, _, expr in facts["block_expr"] if facts.show(expr) == wanted]
    return {str(label) for _, target, label in facts["block_edge"] if target == block}


def test_the_arms_of_a_ternary_are_guarded(facts_of) -> None:
    facts = facts_of(f"{HEAD}void f() {{ int x = a() ? c(1) : c(2); d(); }}")
    assert (guards(facts, "c(1)"), guards(facts, "c(2)")) == ({"true"}, {"false"})


def test_the_arms_of_a_ternary_exclude_each_other(facts_of) -> None:
    facts = facts_of(f"{HEAD}void f() {{ int x = a() ? c(1) : c(2); d(); }}")
    assert len(facts["block_condition"]) == 1


def test_an_exception_may_pass_an_inner_handler(facts_of) -> None:
    facts = facts_of(f"{HEAD}void f() {{ try {{ try {{ d(); }} catch (int) {{ e(); }} }} catch (...) {{ g(); }} }}")
    blocks = {facts.show(expr): block for block, _, expr in facts["block_expr"]}
    assert {target for block, target, label in facts["block_edge"] if block == blocks["d()"] and label == "exception"} == {
        blocks["e()"],
        blocks["g()"],
    }


def test_a_case_label_deep_in_a_switch(facts_of) -> None:
    facts = facts_of(f"{HEAD}void f() {{ switch (c(1)) {{ case 1: if (a()) {{ case 2: d(); }} e(); }} }}")
    assert sorted(facts.show(value) for _, _, value in facts["block_case"]) == ["1", "2"]


def test_a_condition_that_clang_cannot_read_still_guards(facts_of) -> None:
    facts = facts_of(f"{HEAD}void f() {{ if (undeclared && a()) d(); e(); }}")
    (condition,) = [condition for _, condition in facts["block_condition"]]
    assert facts.all("expr_unknown", condition) == [("form",)]
    assert dict(facts["expr_text"])[condition] == "undeclared && a()"
    assert guards(facts, "d()") == {"true"}


def test_every_function_has_one_entry_and_one_exit(facts_of) -> None:
    facts = facts_of(
        f"{HEAD}struct S {{ int x_; S() : x_(c(1)) {{ d(); }} ~S() {{}} }};\nvoid f() {{ if (a()) return; }} int h(int x) try {{ return x; }} catch (...) {{ return 0; }}"
    )
    defined = [function for (function,) in facts["function_defined"]]
    assert len(defined) == 4
    assert [function for _, function in facts["block_entry"]] == defined
    assert [function for _, function in facts["block_exit"]] == defined


def test_initialisers_of_a_constructor_come_first(facts_of) -> None:
    facts = facts_of(f"{HEAD}struct S {{ int x_; S() : x_(c(1)) {{ d(); }} }};")
    assert facts.flow("S::S") == "0: c(1); d() -> next exit"


def test_reads_stand_before_the_call_that_needs_them(facts_of) -> None:
    facts = facts_of(f"{HEAD}void f(int x) {{ x = c(x); }}")
    order = [facts.show(expr) for _, _, expr in sorted(facts["block_expr"], key=lambda row: row[1])]
    assert order.index("c(x)") > [i for i, text in enumerate(order) if text == "x"][-1]
    assert order[-1] == "(x = c(x))"
