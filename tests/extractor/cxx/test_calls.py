"""Calls and constructions: who is called, on what, with which arguments."""

from __future__ import annotations

import pytest

HEAD = """#include <memory>
#include <string>
#include <functional>
struct A {
  A(int n, int m = 2); void go(int x = 5); static void still(); virtual ~A();
  A operator+(const A& other) const; int operator()(int x); A& operator++(); bool operator==(const A&) const; int operator[](int) const;
};
struct B : A { B(); int own_; void all(); };
A operator-(const A&, const A&);
void over(int); void over(double);
template <typename T> T get(const char* key);
template <typename T, typename U> void pair(T, U);
void text(std::string s);
namespace ns { void inner(); }
"""


def body(facts_of, statements: str, parameters: str = "A& a, A* p, B& b, int (*fp)(int), std::function<int(int)> fn"):
    return facts_of(f"{HEAD}void f({parameters}) {{ {statements} }}")


def shown(facts, names: str = "") -> list[str]:
    """All calls as text, those of `f` only."""
    return [facts.show(call) for call in facts.calls() if not names or names in facts.show(call)]


@pytest.mark.parametrize(
    ("statement", "callee", "text"),
    [
        ("over(1);", "over", "over(1)"),
        ("ns::inner();", "ns::inner", "inner()"),
        ("a.go(3);", "A::go", "a.go(3)"),
        ("a.go();", "A::go", "a.go()"),
        ("p->go(4);", "A::go", "p.go(4)"),
        ("(*p).go(4);", "A::go", "*(p).go(4)"),
        ("((a)).go(4);", "A::go", "a.go(4)"),
        ("b.go(1);", "A::go", "b.go(1)"),
        ("b.A::go(1);", "A::go", "b.go(1)"),
        ("A::still();", "A::still", "still()"),
        ('text("t");', "text", 'text("t")'),
        ('get<int>("k");', "get", 'get("k")'),
        ("pair(1, 2.5);", "pair", "pair(1, 2.5)"),
        ("fp(2);", "?fp", "fp(2)"),
    ],
)
def test_a_call_has_callee_receiver_and_arguments(facts_of, statement: str, callee: str, text: str) -> None:
    facts = body(facts_of, statement)
    assert facts.callees() == [callee]
    assert shown(facts) == [text]


def test_overloads_are_told_apart(facts_of) -> None:
    facts = body(facts_of, "over(1); over(2.0);")
    assert [row[1] for row in facts["call_function"]] == ["over@:10:6", "over@:10:22"]
    assert facts["call_unresolved"] == []


@pytest.mark.parametrize(
    ("statement", "operator", "operands", "function"),
    [
        ("a + b;", "+", ["a", "b"], "A::operator+"),
        ("a - b;", "-", ["a", "b"], "operator-"),
        ("a(4);", "()", ["a", "4"], "A::operator()"),
        ("++a;", "++", ["a"], "A::operator++"),
        ("if (a == b) {}", "==", ["a", "b"], "A::operator=="),
        ("a[3];", "[]", ["a", "3"], "A::operator[]"),
    ],
)
def test_an_overloaded_operator_is_an_operator_and_a_call(
    facts_of, statement: str, operator: str, operands: list[str], function: str
) -> None:
    facts = body(facts_of, statement)
    ((expr, name),) = [row for row in facts["operator"] if facts.all("call", row[0])]
    assert name == operator
    assert [facts.show(operand) for _, operand in sorted(facts.all("operand", expr))] == operands
    assert facts.callees() == [function]


def test_a_written_operator_function_is_a_plain_call(facts_of) -> None:
    facts = body(facts_of, "a.operator+(b);")
    assert facts.callees() == ["A::operator+"]
    assert shown(facts) == ["a.operator+(b)"]


@pytest.mark.parametrize(
    ("statement", "text"),
    [
        ("A x(1);", "A(1)"),
        ("A x(1, 3);", "A(1, 3)"),
        ("A x{4};", "A(4)"),
        ("A x = A(3, 4);", "A(3, 4)"),
        ("auto x = A(3);", "A(3)"),
        ("A* x = new A(5);", "A(5)"),
        ("std::shared_ptr<A> x(new A(6));", "A(6)"),
        ("over((A(7), 1));", "A(7)"),
        ("B x;", "B()"),
        ("throw A(8);", "A(8)"),
    ],
)
def test_a_construction_names_its_class(facts_of, statement: str, text: str) -> None:
    facts = body(facts_of, statement)
    name = text.partition("(")[0]
    (call,) = [call for call, cls in facts["call_constructs"] if cls == name]
    assert facts.show(call) == text
    assert facts.one("expr_type", call) == name
    assert facts.calls()[str(call)] == f"{name}::{name}"


def test_new_is_an_operator_on_the_construction(facts_of) -> None:
    facts = body(facts_of, "p = new A(5);")
    (new,) = [expr for expr, operator in facts["operator"] if operator == "new"]
    assert facts.show(new) == "new(A(5))"
    assert facts.one("expr_type", new) == "A *"


@pytest.mark.parametrize("maker", ["make_shared", "make_unique"])
def test_make_functions_name_the_class_as_template_argument(facts_of, maker: str) -> None:
    facts = body(facts_of, f"auto q = std::{maker}<A>(6, 7);")
    call = facts.call(maker)
    assert facts.calls()[call] == f"std::{maker}"
    assert facts.all("call_template_argument", call) == [(0, "A")]
    assert [facts.show(a) for a in facts.arguments(call)] == ["6", "7"]
    assert facts["variable_initializer"][-1][1] == call


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ("int", ["int"]),
        ("unsigned long", ["unsigned long"]),
        ("std::string", ["std::basic_string<char>"]),
        ("A", ["A"]),
        ("ns::Gone", ["?ns::Gone"]),
        ("std::vector<int>", ["std::vector<int>"]),
    ],
)
def test_template_arguments_are_types(facts_of, written: str, expected: list[str]) -> None:
    facts = facts_of(
        f'#include <string>\n#include <vector>\nstruct A {{}}; struct K {{ template <typename T> T get(const char* key); }}; void f(K k) {{ k.get<{written}>("k"); }}'
    )
    assert [type_ for _, type_ in facts.all("call_template_argument", facts.call("get"))] == expected


def test_two_template_arguments_keep_their_places(facts_of) -> None:
    facts = body(facts_of, "pair<A, double>(1, 2);")
    assert facts.all("call_template_argument", facts.call("pair")) == [(0, "A"), (1, "double")]


def test_initialisers_of_bases_and_fields(facts_of) -> None:
    facts = facts_of(HEAD + "struct F { A part_; int number_; F(int n) : part_(n, 1), number_(n) {} };\nB::B() : A(1), own_{7} {}")
    values = {field: facts.show(value) for _, field, value in facts["field_initializer"]}
    assert values == {"F::part_": "A(n, 1)", "F::number_": "n", "B::own_": "{}(7)"}
    (base,) = [call for call, cls in facts["call_constructs"] if cls == "A" and facts.show(call) == "A(1)"]
    assert facts.one("this_use", facts.one("call_receiver", base)) == "B"


def test_a_constructor_of_a_template_makes_its_fields(facts_of) -> None:
    head = "template <class T> struct Client { template <class N> Client(int name, N node, bool own = false); };"
    facts = facts_of(
        head
        + "struct Caller { Client<int> client_; int level_; template <class N> Caller(int n, N node) : client_(n + 1, node, true), level_(n) {} };"
    )
    values = {field: facts.show(value) for _, field, value in facts["field_initializer"]}
    assert values == {"Caller::client_": "Client((n + 1), node, true)", "Caller::level_": "n"}
    (call,) = [call for call, cls in facts["call_constructs"] if cls == "Client"]
    assert facts.one("call_unresolved", call) == "dependent"
    assert facts.one("expr_type", call) == "Client<int>"


def test_a_delegating_constructor_calls_the_other_on_this(facts_of) -> None:
    facts = facts_of("struct D { int x_; D(int x) : x_(x) {} D() : D(9) {} };")
    (call,) = [call for call, _ in facts["call"]]
    assert facts.show(call) == "D(9)"
    assert facts.one("this_use", facts.one("call_receiver", call)) == "D"


def test_the_implicit_this_is_a_receiver(facts_of) -> None:
    facts = facts_of(HEAD + "void B::all() { go(); this->go(3); still(); A::go(); own_ = 1; }")
    receivers = [[facts.one("this_use", r) for (r,) in facts.all("call_receiver", call)] for call in facts.calls()]
    assert facts.callees() == ["A::go", "A::go", "A::still", "A::go"]
    assert receivers == [["B"], ["B"], [], ["B"]]
    assert [facts.show(use) for use, variable in facts["variable_use"] if variable == "B::own_"] == ["own_"]


def test_default_arguments_are_not_listed_but_known(facts_of) -> None:
    facts = facts_of(
        "struct A { void go(int x = 5); };\nvoid A::go(int x) {}\nvoid g(int y = 6);\nvoid g(int y) {}\nvoid f(A a) { a.go(); g(); }"
    )
    assert facts["call_argument"] == []
    defaults = {facts.one("variable_name", parameter): facts.show(value) for parameter, value in facts["parameter_default"]}
    assert defaults == {"x": "5", "y": "6"}


@pytest.mark.parametrize(
    "statement",
    ['text("t");', 'text(std::string("t"));', 'std::string s = "t"; text(s);', "over('c');", "b.go(1); a = b;"],
)
def test_implicit_conversions_and_copies_leave_no_call(facts_of, statement: str) -> None:
    facts = body(facts_of, statement)
    implicit = [
        c for c in facts.callees() if c in ("A::A", "B::B") or (c == "std::basic_string::basic_string" and "string(" not in statement)
    ]
    assert implicit == []


def test_a_conversion_operator_is_left_out(facts_of) -> None:
    facts = facts_of("struct W { operator bool() const; }; void g(bool); void f(W w) { if (w) g(w); }")
    assert facts.callees() == ["g"]
    assert [facts.show(a) for a in facts.arguments(facts.call("g"))] == ["w"]


def test_a_call_through_a_function_pointer_or_object(facts_of) -> None:
    facts = body(facts_of, "fp(2); fn(3);")
    ((call, callee),) = facts["call_through"]
    assert (facts.show(call), facts.show(callee)) == ("fp(2)", "fp")
    ((expr, _),) = [row for row in facts["operator"] if row[1] == "()"]
    assert [facts.show(operand) for _, operand in facts.all("operand", expr)] == ["fn", "3"]


def test_bind_keeps_its_arguments(facts_of) -> None:
    facts = facts_of(
        "#include <functional>\nstruct C { void cb(int); void m() { std::function<void(int)> fn = std::bind(&C::cb, this, std::placeholders::_1); } };"
    )
    call = facts.call("bind")
    assert [facts.show(a) for a in facts.arguments(call)] == ["&C::cb", "this", "_1"]
    assert facts.calls()[call] == "std::bind"
    assert facts["variable_initializer"] == [("fn@:2:62", call)]


def test_an_overloaded_function_as_value_is_a_set(facts_of) -> None:
    facts = facts_of("struct C { void cb(int); void cb(double); }; template <class F> void take(F); void f() { take(&C::cb); }")
    (argument,) = facts.arguments(facts.call("take"))
    assert [function for (function,) in facts.all("function_use", argument)] == ["C::cb@:1:17", "C::cb@:1:31"]
    assert [call for call, _ in facts["call_unresolved"]] == [facts.call("take")]


def test_a_call_of_an_overload_set_lists_its_candidates(facts_of) -> None:
    facts = facts_of("struct C { void go(int); void go(const char*); }; void f(C c, Unknown u) { c.go(u); }")
    call = facts.call("go")
    assert facts.all("call_function", call) == [("C::go@:1:17",), ("C::go@:1:31",)]
    assert facts.all("call_unresolved", call) == [("overloaded",)]
    assert facts.show(facts.one("call_receiver", call)) == "c"
    assert len(facts.arguments(call)) == 1


def test_a_call_on_an_unknown_type_is_kept(facts_of) -> None:
    facts = facts_of('void f(Gone g) { g.go(1, "x"); }')
    call = facts.call("go")
    assert facts.all("call_unresolved", call) == [("dependent",)]
    assert facts.show(facts.one("call_receiver", call)) == "g"
    assert [facts.show(a) for a in facts.arguments(call)] == ["1", '"x"']


def test_a_call_in_a_template_is_dependent(facts_of) -> None:
    facts = facts_of("template <class T> struct Box { T t_; void run(int n) { t_.go(n); } };")
    call = facts.call("go")
    assert facts.all("call_unresolved", call) == [("dependent",)]
    assert [facts.show(a) for a in facts.arguments(call)] == ["n"]
    assert facts.show(facts.one("call_receiver", call)) == "t_"


def test_calls_nest(facts_of) -> None:
    facts = facts_of("int g(int); int h(int, int); void f() { h(g(g(1)), g(2)); }")
    assert next(facts.show(c) for c in facts.calls()) == "h(g(g(1)), g(2))"
    assert facts.callees().count("g") == 3


def test_a_call_belongs_to_the_function_that_holds_it(facts_of) -> None:
    facts = facts_of("int g(int); int global = g(1); struct S { int field_ = g(2); }; void f() { g(3); }")
    owners = {facts.show(call): [f for (f,) in facts.all("expr_function", call)] for call in facts.calls()}
    assert owners == {"g(1)": [], "g(2)": [], "g(3)": ["f@:1:70"]}


def test_the_result_type_of_a_call(facts_of) -> None:
    facts = facts_of("#include <string>\nconst std::string& g(); void f() { g(); }")
    assert facts.all("expr_type", facts.call("g")) in ([("const std::basic_string<char>",)], [("const std::basic_string<char> &",)])


@pytest.mark.parametrize("parameters", ["A& a", "A* a", "std::shared_ptr<A> a", "std::unique_ptr<A> a"])
def test_the_receiver_is_the_object_behind_any_pointer(facts_of, parameters: str) -> None:
    facts = body(facts_of, "a.go(1);" if "&" in parameters else "a->go(1);", parameters)
    call = facts.call("go")
    receiver = facts.one("call_receiver", call)
    assert facts.calls()[call] == "A::go"
    assert facts.show(receiver) == ("*(a)" if "ptr" in parameters else "a")


def test_a_call_through_a_dereferenced_pointer(facts_of) -> None:
    facts = body(facts_of, "(*fp)(2);")
    ((call, callee),) = facts["call_through"]
    assert facts.show(callee) == "*(fp)"
    assert [facts.show(a) for a in facts.arguments(str(call))] == ["2"]


def test_a_called_function_object_has_its_arguments(facts_of) -> None:
    facts = body(facts_of, "a(4);")
    assert [facts.show(argument) for argument in facts.arguments(facts.call("operator()"))] == ["4"]


def test_objects_of_a_parameter_of_the_template(extract) -> None:
    facts = extract("template <class T> void f(int x) { T* p = new T(x, 3); T local(x); T* q = new T; }")
    calls = sorted(str(call) for call, name in facts["call"] if name == "T")
    assert [facts.arguments(call) and facts.show(facts.arguments(call)[0]) for call in calls] == ["x", "x", []]
    assert {facts.one("call_unresolved", call) for call in calls} == {"dependent"}
    assert {facts.one("expr_type", call) for call in calls} == {"type-parameter-0-0"}
    assert {row[2] for row in facts["operand"] if str(row[0]).endswith(":new")} == {
        call for call in calls if "3" in map(facts.show, facts.arguments(call)) or not facts.arguments(call)
    }
