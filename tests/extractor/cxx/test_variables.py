"""Variables: kinds, identities, initial values, and types that nobody declares."""

from __future__ import annotations

import pytest


def kinds(facts) -> dict[str, str]:
    return {
        str(facts.one("variable_name", variable)): str(kind) for variable, kind in facts["variable"] if facts.all("variable_name", variable)
    }


def test_kinds(facts_of) -> None:
    facts = facts_of(
        "extern int shared; static int own; int mine = 3; namespace ns { int inner; }\n"
        "struct S { int field_ = 1; static int common_; }; int S::common_ = 2;\n"
        "void f(int parameter) { int local = own; static int kept = 2; shared = mine + ns::inner; }"
    )
    assert kinds(facts) == {
        "shared": "global", "own": "global", "mine": "global", "inner": "global", "field_": "field", "common_": "static_field",
        "parameter": "parameter", "local": "local", "kept": "static_local",
    }  # fmt: skip


def test_initial_values(facts_of) -> None:
    facts = facts_of(
        "int g = 1; struct S { int f_ = 2; static int s_; }; int S::s_ = 3; void f() { static int k = 4; int l{5}, m(6), n; for (int i = 7;;) {} }"
    )
    values = {facts.one("variable_name", variable): facts.show(value) for variable, value in facts["variable_initializer"]}
    assert values == {"g": "1", "f_": "2", "s_": "3", "k": "4", "l": "{}(5)", "m": "6", "i": "7"}


@pytest.mark.parametrize(
    ("declaration", "seen"),
    [
        ("auto [a, b] = make(); use(a); use(b);", ["[a, b].first", "[a, b].second"]),
        ("const auto & [a, b] = pairs[0]; auto l = [b] { use(b); };", ["[a, b].second"]),
        ("for (auto & [a, b] : pairs) use(b);", ["[a, b].second"]),
        ("int array[2]; auto [a, b] = array; use(b);", ["[]([a, b], 1)"]),
        ("auto [a, b] = std::make_tuple(1, 2); use(b);", ["[]([a, b], 1)"]),
        ("if (auto [a, b] = make(); a) use(b);", ["[a, b].second"]),
    ],
)
def test_structured_bindings(facts_of, declaration: str, seen: list[str]) -> None:
    """A name stands for a data member of a value that has no name, or for its part at an index."""
    facts = facts_of(
        "#include <tuple>\n#include <utility>\n#include <vector>\nvoid use(int); std::pair<int, int> make(); std::vector<std::pair<int, int>> pairs;\n"
        f"void f() {{ {declaration} }}"
    )
    calls = facts.calls()
    assert [facts.show(facts.arguments(call)[0]) for call, name in calls.items() if name == "use"] == seen
    assert ("make" in calls.values()) == ("make()" in declaration)


def test_structured_bindings_in_templates_and_of_structures(facts_of) -> None:
    facts = facts_of(
        "struct P { int x; int y; }; P p(); void use(int); template <class T> void f(T t) { auto [a, b] = t; use(b); }\n"
        "void g() { auto [a, b] = p(); a = 3; use(b); }"
    )
    assert [facts.show(facts.arguments(call)[0]) for call, name in facts.calls().items() if "use" in name] == ["[]([a, b], 1)", "[a, b].y"]
    assert [
        facts.show(operand) for operator, name in facts["operator"] if name == "=" for _, operand in facts.all("operand", operator)
    ] == ["[a, b].x", "3"]


def test_locals_of_one_name_are_two_variables(facts_of) -> None:
    facts = facts_of("void g(int); void f() {\n int l = 1;\n {\n  int l = 2;\n  g(l);\n }\n g(l);\n}")
    uses = [facts.one("variable_use", facts.arguments(call)[0]) for call in facts.calls()]
    assert uses == ["l@:4:7", "l@:2:6"]


def test_locals_and_parameters_belong_to_their_function(facts_of) -> None:
    facts = facts_of("void f(int p) { int l = p; }")
    assert {facts.one("variable_name", v): f for v, f in facts["variable_function"]} == {"p": "f@:1:6", "l": "f@:1:6"}


def test_a_field_use_has_an_object(facts_of) -> None:
    facts = facts_of("struct S { int f_; void m() { f_ = 1; this->f_ = 2; } }; void f(S a, S* b) { a.f_ = 3; b->f_ = 4; }")
    objects = [facts.show(base) for _, base in facts["field_object"]]
    assert sorted(objects) == ["a", "b", "this", "this"]
    assert {variable for _, variable in facts["variable_use"]} >= {"S::f_"}
    assert facts.all("field_class", "S::f_") == [("S",)]


HEADER = "#pragma once\nextern int shared; static int each; struct S { int f_; static int s_; }; void declared(int q); inline int both(int x) { int l = x; return l; }\n"


def test_identities_hold_across_units(extract) -> None:
    files = {"h.h": HEADER}
    one = extract(
        '#include "h.h"\nint shared = 1; static int hidden; namespace { int anonymous; } int S::s_; void fa(S s) { shared = each = hidden = s.f_ = S::s_ = anonymous; declared(1); both(2); }',
        "a.cpp",
        files,
    )
    two = extract(
        '#include "h.h"\nextern int shared; static int hidden; namespace { int anonymous; } void fb(S s) { shared = each = hidden = s.f_ = S::s_ = anonymous; declared(1); both(2); }',
        "sub/b.cpp",
        files,
    )
    common = {row[0] for row in one.raw["variable"] & two.raw["variable"]}
    names = {row[0]: row[1] for row in one.raw["variable_name"] | two.raw["variable_name"]}
    assert sorted(names[variable] for variable in common) == ["each", "f_", "l", "q", "s_", "shared", "x"]
    assert {"shared", "S::f_", "S::s_"} <= common
    apart = {names[row[0]] for row in one.raw["variable"] - two.raw["variable"]}
    assert apart == {"hidden", "anonymous", "s"}


def test_members_of_an_anonymous_union_are_in_the_scope_around_it(extract) -> None:
    code = extract(
        """static union { int global_; };
struct C { union { struct { int inner_; }; int field_; }; int other_; };
void f(C c) { union { int local; }; c.inner_ = c.field_ = global_ = local; C d; }
"""
    )
    names = {row[0]: row[1] for row in code.raw["variable_name"]}
    assert {"C::inner_", "C::field_", "C::other_"} <= {row[0] for row in code.raw["field_class"] if row[1] == "C"}
    assert {("global_", "global"), ("local", "local")} <= {(names[row[0]], row[1]) for row in code.raw["variable"]}
    assert not any("/" in str(value) for value in names), "an identifier would tell where the workspace lies"


def test_functions_of_a_header_are_one(extract) -> None:
    files = {"h.h": HEADER}
    one = extract('#include "h.h"\nvoid declared(int other) {} void fa() { both(1); declared(1); }', "a.cpp", files)
    two = extract('#include "h.h"\nvoid fb() { both(2); declared(2); }', "b.cpp", files)
    shared = {str(row[0]).partition("@")[0] for row in one.raw["function"] & two.raw["function"]}
    assert shared == {"both", "declared"}
    for relation in ("block_expr", "block_edge", "return_value", "variable_initializer"):
        inner = {row for row in one.raw[relation] if str(row[0]).startswith(("both@", "l@"))}
        assert inner and inner == {row for row in two.raw[relation] if str(row[0]).startswith(("both@", "l@"))}


def test_functions_with_one_name_in_two_files_are_two(extract) -> None:
    one = extract("static void helper() {} void fa() { helper(); }", "a.cpp")
    two = extract("static void helper() {} void fb() { helper(); }", "b.cpp")
    assert one.raw["function"] & two.raw["function"] == set()


def test_extern_in_a_function_is_the_global(facts_of) -> None:
    facts = facts_of("void f() { extern int shared; shared = 1; }")
    assert facts["variable"] == [("shared", "global")]


UNKNOWN = [
    ("Gone v;", "?Gone"), ("const Gone& v;", "?Gone"), ("Gone* v;", "?Gone"), ("ns::Gone v;", "?ns::Gone"), ("static Gone v;", "?Gone"),
    ("std::vector<Gone> v;", "?std::vector<Gone>"), ("Splint v;", "?Splint"), ("int v;", "int"), ("unsigned v;", "unsigned int"), ("long v;", "long"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("declaration", "type_"),
    [
        *UNKNOWN,
        pytest.param("Gone<int> v;", "?Gone<int>"),
        pytest.param("ns::Gone<unsigned int, 3> v;", "?ns::Gone<unsignedint,3>"),
    ],
)
def test_a_type_without_declaration_is_marked(facts_of, declaration: str, type_: str) -> None:
    facts = facts_of(f"#include <vector>\nstruct S {{ {declaration} }};")
    assert facts.one("variable_type", "S::v") == type_


def test_unknown_types_of_locals_parameters_and_globals(facts_of) -> None:
    facts = facts_of("Glob g; void f(Par p, const Ref& r, int ok) { Loc l; static Kept k; }")
    types = {facts.one("variable_name", variable): type_ for variable, type_ in facts["variable_type"]}
    assert types == {"g": "?Glob", "p": "?Par", "r": "?Ref", "ok": "int", "l": "?Loc", "k": "?Kept"}
    assert facts.all("type_class", "?Par") == [("Par",)]


def test_the_structure_of_types(facts_of) -> None:
    facts = facts_of(
        "#include <vector>\n#include <memory>\nstruct A {}; struct S { const A& r_; A* p_; A a_[3]; std::vector<A> v_; std::shared_ptr<const A> s_; };"
    )
    assert facts.one("variable_type", "S::r_") == "const A &"
    assert set(facts["type_inner"]) >= {
        ("const A &", "reference", "const A"),
        ("const A", "const", "A"),
        ("A *", "pointer", "A"),
        ("A[3]", "array", "A"),
    }
    assert facts.all("type_class", "A") == [("A",)]
    assert facts.all("type_argument", "std::vector<A>")[0] == (0, "A")
    assert facts.all("type_class", "std::vector<A>") == [("std::vector",)]
    assert facts.all("type_argument", "std::shared_ptr<const A>") == [(0, "const A")]


def test_typedefs_are_seen_through(facts_of) -> None:
    facts = facts_of("struct A {}; typedef A* Pointer; using Alias = Pointer; struct S { Alias f_; };")
    assert facts.one("variable_type", "S::f_") == "A *"


@pytest.mark.parametrize(
    "declaration",
    ["int a, v;", "int a = f(1, 2), v = 3;", "unsigned int a[2], *b, v;", "const int a{1}, v = 2;", "long int a(3), &b = a, v;"],
)
def test_a_later_declarator_has_the_declared_type(facts_of, declaration: str) -> None:
    facts = facts_of(f"int f(int, int); void g() {{ {declaration} }}")
    (variable,) = [variable for variable, name in facts["variable_name"] if name == "v"]
    assert facts.one("variable_type", variable) in ("int", "const int", "unsigned int", "long")
