"""Statements that clang leaves out: their calls are read from the text."""

from __future__ import annotations

import pytest

HEAD = """struct Pub { void publish(int); void send(const char*, double, bool); template <class T> Pub advertise(const char*, int); };
struct N {
  Pub pub_; Pub* ptr_; int count_;
  void cb(int) {} void helper(int, void (N::*)(int), N*, int, bool) {} static void still(int) {}
  void m(Pub& arg, int n) {
"""


def recovered(facts) -> list[str]:
    """The recovered calls as text."""
    return [facts.show(call) for call in facts.calls() if facts.all("call_unresolved", call) == [("recovered",)]]


def method(facts_of, statements: str):
    return facts_of(HEAD + statements + "\n  }\n};\n")


@pytest.mark.parametrize(
    ("statement", "shown"),
    [
        ("pub_.publish(undeclared);", "pub_.publish(?recovered)"),
        ("ptr_->publish(undeclared);", "ptr_.publish(?recovered)"),
        ("this->pub_.publish(undeclared);", "pub_.publish(?recovered)"),
        ("arg.publish(undeclared);", "arg.publish(?recovered)"),
        ("if (n > 0) pub_.publish(undeclared);", "pub_.publish(?recovered)"),
        ('ptr_->send("a" "b", -1.5, nope::x);', 'ptr_.send("ab", -1.5, ?recovered)'),
        ("arg.send(undeclared, n, true);", "arg.send(?recovered, n, true)"),
        ("arg.publish(f(g(undeclared), {1, 2}), h[3]);", "arg.publish(?recovered, ?recovered)"),
        ('arg.advertise<unk::T>("base" + undeclared, 1);', 'arg.advertise(("base" + ?recovered), 1)'),
        ("helper(undeclared, &N::cb, this, count_, true);", "helper(?recovered, &N::cb, this, count_, true)"),
        ("N::still(undeclared);", "still(?recovered)"),
    ],
)
def test_a_dropped_call_is_read(facts_of, statement: str, shown: str) -> None:
    assert recovered(method(facts_of, statement)) == [shown]


def test_places_and_owner(facts_of) -> None:
    facts = method(facts_of, "    pub_.publish(undeclared);")
    call = facts.call("publish")
    assert facts.all("location", call) == [("@", 6, 5)]
    assert facts.one("function_name", facts.one("expr_function", call)) == "N::m"
    assert facts.one("variable_use", facts.one("call_receiver", call)) == "N::pub_"
    assert dict(facts["expr_text"])[call] == "pub_.publish(undeclared)"


def test_an_object_made_in_a_dropped_statement(facts_of) -> None:
    facts = facts_of("template <class T> struct Sub { explicit Sub(int); };\nvoid f() { consume(undeclared, new Sub<unk::T>(1)); }\n")
    call = facts.call("Sub")
    assert facts.one("call_constructs", call) == "Sub"
    assert facts.one("function_name", facts.one("call_function", call)) == "Sub::Sub"
    assert facts.all("type_argument", facts.one("expr_type", call)) == [(0, "?unk::T")]


def test_template_arguments_of_a_dropped_call(facts_of) -> None:
    facts = method(facts_of, 'auto p = arg.advertise<unk::T>("topic", 10);')
    call = facts.call("advertise")
    assert facts.all("call_template_argument", call) == [(0, "?unk::T")]
    assert facts.all("type_class", "?unk::T") == [("unk::T",)]
    assert [facts.show(a) for a in facts.arguments(call)] == ['"topic"', "10"]


def test_the_target_of_a_dropped_assignment(facts_of) -> None:
    facts = method(facts_of, 'pub_ = arg.advertise<unk::T>("topic", 10);')
    assert [facts.show(expr) for expr, operator in facts["operator"] if operator == "="] == ['(pub_ = arg.advertise("topic", 10))']


def test_a_name_without_type_finds_the_function(facts_of) -> None:
    facts = method(facts_of, "Gone gone; gone.connect(&N::cb, this);")
    call = facts.call("connect")
    assert "&N::cb" in [facts.show(a) for a in facts.arguments(call)]


QUIET = {
    "line comment": "// pub_.publish(undeclared);",
    "block comment": "/* pub_.publish(undeclared) */",
    "string": 'const char* s = "pub_.publish(undeclared)";',
    "escaped quote": 'const char* s = "\\" pub_.publish(undeclared)";',
    "raw string": 'const char* s = R"(pub_.publish(undeclared))";',
    "if 0": "#if 0\n    pub_.publish(undeclared);\n#endif",
    "else of if 1": "#if 1\n#else\n    pub_.publish(undeclared);\n#endif",
    "ifdef": "#ifdef NEVER_DEFINED\n    pub_.publish(undeclared);\n#endif",
    "macro": "#define LOG(x) pub_.publish(x)",
    "declaration": "Gone thing(undeclared);",
    "keywords": "if (undeclared) {} while (undeclared) {} switch (undeclared) {} return (undeclared);",
    "calls that clang read": "pub_.publish(1); ptr_->publish(n); pub_\n.publish(2); cb(3);",
}


@pytest.mark.parametrize("case", QUIET)
def test_nothing_is_read_from(facts_of, case: str) -> None:
    assert recovered(method(facts_of, QUIET[case])) == []


def test_nothing_is_read_from_a_raw_string_of_several_lines(facts_of) -> None:
    assert recovered(method(facts_of, 'const char* s = R"(\n pub_.publish(undeclared);\n)";')) == []


def test_nothing_is_read_from_a_macro_of_two_lines(facts_of) -> None:
    assert recovered(method(facts_of, "#define LOG(x) \\\n  pub_.publish(x)")) == []


def test_a_digit_separator_hides_nothing(facts_of) -> None:
    assert recovered(method(facts_of, "int big = 1'000; pub_.publish(undeclared); char c = 'x';")) == ["pub_.publish(?recovered)"]


@pytest.mark.parametrize(
    ("statement", "name"),
    [
        ('auto m = ros::topic::waitForMessage<Gone>("topic", nh);', "waitForMessage"),
        ('ros::service::call("service", undeclared);', "call"),
        ('ros::param::get("name", undeclared);', "get"),
        ("declared_only(undeclared);", "declared_only"),
    ],
)
def test_a_dropped_call_of_a_declared_function_is_read(facts_of, statement: str, name: str) -> None:
    facts = facts_of(f"#include <ros/ros.h>\nvoid declared_only(int);\nvoid f(ros::NodeHandle nh) {{ {statement} }}")
    assert [facts.one("call", call) for call in facts.calls()] == [name]


def test_the_ros_api_is_recovered_with_its_handle(facts_of) -> None:
    facts = facts_of(
        '#include <ros/ros.h>\nstruct N { ros::NodeHandle nh_; ros::Subscriber sub_; void cb(const Gone::ConstPtr& m) {} void m() { sub_ = nh_.subscribe("in", 5, &N::cb, this); } };'
    )
    call = facts.call("subscribe")
    assert facts.show(facts.one("call_receiver", call)) == "nh_"
    assert [facts.show(a) for a in facts.arguments(call)][:2] == ['"in"', "5"]
    assert "N::cb@:2:60" in [function for _, function in facts["function_use"]]


def test_a_method_whose_call_has_wrong_arguments_stands_for_the_call(facts_of) -> None:
    facts = facts_of("struct N { int one(int); }; void f(N n) { int k = n.one(1, 2, 3); }")
    ((remnant, call),) = facts["call_remnant"]
    assert facts.show(call) == "n.one(1, 2, 3)"
    assert facts.all("function_use", remnant) == [("N::one@:1:16",)]


def test_what_stands_for_a_call_is_the_initial_value(facts_of) -> None:
    facts = facts_of("struct N { int one(int); }; void f(N n) { int k = n.one(1, 2, 3); }")
    ((remnant, _),) = facts["call_remnant"]
    ((variable, value),) = facts["variable_initializer"]
    assert variable == "k@:1:47"
    assert facts.all("operand", value)[0] == (0, remnant)


def test_a_dropped_call_of_a_method_that_may_be_inherited(facts_of) -> None:
    source = 'struct B {}; struct N : B { int x; void f() { x = make<int>("a", unknown_); far::Thing y(unknown_); later(unknown_); } };'
    facts = facts_of(source)
    calls = {name: call for call, name in facts["call"]}
    assert set(calls) == {"make", "later"}
    assert facts.arguments(calls["make"])[:1] and facts.one("this_use", facts.one("call_receiver", calls["make"])) == "N"


def test_a_cast_is_no_call_of_what_may_be_inherited(facts_of) -> None:
    facts = facts_of("struct N : far::B { int x; void f(double y) { x = static_cast<int>(y); } };")
    assert [name for _, name in facts["call"]] == []


def test_an_assignment_that_is_kept_is_not_read_again(facts_of) -> None:
    facts = facts_of("struct N { int one(int); }; void f(N n, int k) { k = n.one(k, 2, 3); }")
    ((remnant, call),) = facts["call_remnant"]
    ((assignment, operator),) = facts["operator"]
    assert operator == "="
    assigned = dict(facts.all("operand", assignment))[1]
    assert facts.all("operand", assigned)[0] == (0, remnant)
    # what the call is given is read where the call is, so that definitions before it reach it
    (use, *_) = facts.arguments(call)
    assert [expr for _, _, expr in facts["block_expr"] if expr == use] == [use]
