"""Classes: bases, overrides, templates and their instances."""

from __future__ import annotations


def test_kinds_and_bases(facts_of) -> None:
    facts = facts_of(
        "struct A {}; class B : public A {}; struct C : A, virtual private B {}; union U { int a; }; enum E { X }; void f(E e, U u) { E l = X; }"
    )
    assert set(facts["class"]) >= {("A", "struct"), ("B", "class"), ("C", "struct"), ("U", "union"), ("E", "enum")}
    assert facts["class_base"] == [("B", "A"), ("C", "A"), ("C", "B")]


def test_nested_and_anonymous_classes(facts_of) -> None:
    facts = facts_of("namespace ns { struct N { struct In { int q; }; }; }\nnamespace { struct Hidden {}; }\nstruct { int z; } nameless;")
    names = {name for name, _ in facts["class"]}
    assert {"ns::N", "ns::N::In", "(anonymous)::Hidden", "(anonymous 3:1)"} <= names
    assert facts.all("field_class", "ns::N::In::q") == [("ns::N::In",)]


def test_an_absent_base_is_left_out(facts_of) -> None:
    facts = facts_of("struct D : Absent { void m() {} };")
    assert facts["class_base"] == []
    assert facts.all("function_class", "D::m@:1:26") == [("D",)]


def test_overrides_are_direct(facts_of) -> None:
    facts = facts_of(
        "struct A { virtual void v(); virtual void w(int); };\nstruct M { virtual void v(); };\n"
        "struct B : A, M { void v() override {} };\nstruct C : B { void v() {} void w(double) {} };"
    )
    names = dict(facts["function_name"])
    assert [(names[a], names[b]) for a, b in facts["function_overrides"]] == [("B::v", "A::v"), ("B::v", "M::v"), ("C::v", "B::v")]


def test_function_kinds(facts_of) -> None:
    facts = facts_of(
        "struct A { A() {} ~A() {} void m() {} static void s() {} operator int() { return 1; } template <class T> void t(T) {} };\n"
        "void f() {}\ntemplate <class T> void g(T) {}"
    )
    names = dict(facts["function_name"])
    assert {str(names[function]): kind for function, kind in facts["function"]} == {
        "A::A": "constructor", "A::~A": "destructor", "A::m": "method", "A::s": "static_method", "A::operator int": "conversion", "A::t": "method",
        "f": "function", "g": "function",
    }  # fmt: skip


def test_definition_out_of_the_class_is_the_same_method(facts_of) -> None:
    facts = facts_of("struct A {\n void m(int declared);\n};\nvoid A::m(int defined) { m(1); }\nvoid f(A a) { a.m(2); }")
    assert [function for function, _ in facts["function"] if "A::m" in str(function)] == ["A::m@:2:7"]
    assert facts["function_defined"] == [("A::m@:2:7",), ("f@:5:6",)]
    assert facts.all("variable_name", "A::m@:2:7#0") == [("declared",), ("defined",)]


def test_a_class_template_and_its_instances(facts_of) -> None:
    facts = facts_of(
        "template <class T> struct Box { T t_; void set(T t) { t_ = t; } };\ntemplate <class T> struct Sub : Box<T> {};\n"
        "struct I : Box<int> {};\nvoid f() { Box<double> b; b.set(1.0); Sub<char> s; }"
    )
    assert set(facts["class"]) >= {("Box", "template"), ("Sub", "template"), ("I", "struct")}
    assert facts["class_base"] == [("I", "Box"), ("Sub", "Box")]
    assert facts.all("type_class", "Box<double>") == [("Box",)]
    assert facts.all("type_argument", "Box<double>") == [(0, "double")]
    assert facts.callees().count("Box::set") == 1
    assert facts["template_parameter"] == [("type-parameter-0-0", 0)]
    assert facts.one("variable_type", "Box::t_") == "type-parameter-0-0"
    bodies = [function for (function,) in facts["function_defined"] if "Box::set" in str(function)]
    assert bodies == ["Box::set@:1:44"]


def test_the_second_template_parameter_has_its_index(facts_of) -> None:
    facts = facts_of("template <class A, class B> struct Two { A a_; B b_; };")
    assert {facts.one("variable_name", v): i for v, t in facts["variable_type"] for i in [facts.one("template_parameter", t)]} == {
        "a_": 0,
        "b_": 1,
    }


def test_locations_of_declarations(facts_of) -> None:
    facts = facts_of("struct A {\n  int f_;\n  void m() {}\n};\nint g;\nvoid f(\n) { int l; }")
    places = {entity: row[1:] for entity, *row in facts["location"]}
    assert places["A"] == [1, 8]
    assert places["A::f_"] == [2, 7]
    assert places["A::m@:3:8"] == [3, 8]
    assert places["g"] == [5, 5]
    assert places["f@:6:6"] == [6, 6]


def test_parameters_and_return_types(facts_of) -> None:
    facts = facts_of("double f(int a, const char* b) { return a; }")
    assert [(index, facts.one("variable_type", p)) for index, p in facts.all("function_parameter", "f@:1:8")] == [
        (0, "int"),
        (1, "const char *"),
    ]
    assert facts.one("function_return_type", "f@:1:8") == "double"


def test_a_class_in_a_function(facts_of) -> None:
    facts = facts_of("void g(int); void f() { struct L { void m() { g(1); } }; L l; l.m(); }")
    owners = {facts.show(call): facts.one("function_name", facts.one("expr_function", call)) for call in facts.calls()}
    assert owners["g(1)"] == "f::L::m"
    assert owners["l.m()"] == "f"


def test_slots_are_marked(facts_of) -> None:
    facts = facts_of(
        "#include <QObject>\nclass W : public QObject { Q_OBJECT public: void plain(); public slots: void a(); void b(int) {} private: void c();\n"
        "signals: void fired(); private Q_SLOTS: void d(); };\nvoid W::a() { emit fired(); }"
    )
    names = dict(facts["function_name"])
    assert {(names[function], mark) for function, mark in facts["function_annotation"]} == {(f"W::{name}", "qt_slot") for name in "abd"}


def test_a_type_without_name_is_called_by_its_place_whatever_way_leads_there(extract) -> None:
    files = {"inner/part.h": "#pragma once\nstruct Part { struct { int level; } tank; };\n", "outer/x.h": ""}
    snippet = extract('#include "outer/../inner/part.h"\nPart part;\n', files=files)
    types = {row[1] for row in snippet.raw["variable_type"] if row[0] == "Part::tank"}
    assert types == {"Part::(unnamed struct at inner/part.h:2:15)"}
