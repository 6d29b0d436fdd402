"""Literals, operators, braces, constants and the text of expressions."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.translation_unit import CompileUnit, extract_unit


def literals(facts) -> list[tuple[str, str]]:
    return [(str(kind), str(value)) for _, kind, value in facts["literal"]]


STRINGS = [
    ('"plain"', "plain"),
    ('""', ""),
    ('"a" "b"', "ab"),
    (r'"tab\tend"', "tab\tend"),
    (r'"q\"uote"', 'q"uote'),
    (r'"back\\slash"', "back\\slash"),
    (r'"\x41\102"', "AB"),
    (r'"what\?"', "what?"),
    (r'"two\nlines"', "two\nlines"),
    ('u8"u8"', "u8"),
    (r'R"(raw\n)"', "raw\\n"),
    ('R"x(in)")x"', 'in)"'),
    ('NAME "/x"', "topic/x"),
    pytest.param('"ä"', "ä"),
    pytest.param(r'"\u00e4"', "ä"),
]


@pytest.mark.parametrize(("written", "value"), STRINGS)
def test_string_literals_are_decoded(facts_of, written: str, value: str) -> None:
    facts = facts_of(f'#define NAME "topic"\nvoid p(const char*);\nvoid f() {{ p({written}); }}')
    assert literals(facts) == [("string", value)]


NUMBERS = [
    ("42", "integer", "42"), ("0x1D", "integer", "29"), ("017", "integer", "15"), ("0b101", "integer", "5"), ("1'000", "integer", "1000"),
    ("7UL", "integer", "7"), ("2.50", "float", "2.5"), ("1e3", "float", "1000.0"), (".5f", "float", "0.5"), ("'c'", "character", "c"),
    ("true", "boolean", "true"), ("nullptr", "null", "nullptr"), ("NULL", "null", "nullptr"), ("MACRO", "integer", "12"), ("LIMIT", "float", "0.25"),
    pytest.param("0x1F", "integer", "31"),
]  # fmt: skip


@pytest.mark.parametrize(("written", "kind", "value"), NUMBERS)
def test_other_literals(facts_of, written: str, kind: str, value: str) -> None:
    facts = facts_of(f"#include <cstddef>\n#define MACRO 12\n#define LIMIT 0.25\nvoid f() {{ auto x = {written}; }}")
    assert literals(facts) == [(kind, value)]


OPERATORS = [
    ("a + b * 2", "(a + (b * 2))"), ("(a + b) * 2", "((a + b) * 2)"), ("-a", "-(a)"), ("!a", "!(a)"), ("a && b || a", "((a && b) || a)"),
    ("a == b", "(a == b)"), ("a != 1", "(a != 1)"), ("a <= b", "(a <= b)"), ("a | b & 3", "(a | (b & 3))"), ("a << 2", "(a << 2)"),
    ("a % 2", "(a % 2)"), ("~a", "~(a)"), ("a ? 1 : b", "?:(a, 1, b)"), ("list[a]", "[](list, a)"), ("*pointer", "*(pointer)"),
    ("*&a", "*(&(a))"), ("(double)a", "cast(a)"), ("static_cast<double>(a)", "cast(a)"), ("double(a)", "cast(a)"), ("sizeof(a)", "sizeof(a)"),
    ("a++", "++(a)"), ("--a", "--(a)"), ("(a = 3)", "(a = 3)"), ("(a += b)", "(a += b)"), ("s.x", "s.x"), ("s.inner.y", "s.inner.y"),
    ("ptr->inner.y", "ptr.inner.y"), ("RED", "Color::RED"), ("Color::GREEN", "Color::GREEN"), ("Kind::One | Kind::Two", "(Kind::One | Kind::Two)"),
    ("(a)", "a"), ("((a))", "a"),
]  # fmt: skip
DECLARED = """
enum Color { RED, GREEN = 5 }; enum Kind_ { K }; namespace Kind { enum V { One = 1, Two = 2 }; }
struct I { int y; }; struct S { int x; I inner; };
"""


@pytest.mark.parametrize(("written", "shown"), OPERATORS)
def test_operators_and_operands(facts_of, written: str, shown: str) -> None:
    facts = facts_of(f"{DECLARED}void f(int a, int b, int* list, int* pointer, S s, S* ptr) {{ auto result = {written}; }}")
    ((_, value),) = facts["variable_initializer"]
    expected = shown.replace("Kind::", "Kind::V::")
    assert facts.show(value) == expected


def test_strings_are_joined_by_an_operator(facts_of) -> None:
    facts = facts_of('#include <string>\nvoid f(std::string a) { std::string s = a + "/x" + std::string("y"); s += "z"; }')
    ((_, value),) = facts["variable_initializer"]
    assert facts.show(value) == '((a + "/x") + basic_string("y"))'
    assert [facts.show(expr) for expr, operator in facts["operator"] if operator == "+="] == ['(s += "z")']


def test_enum_constants_have_name_and_number(facts_of) -> None:
    facts = facts_of(
        "enum E { X, Y = 5 }; enum class F : char { Z = 7 }; struct S { enum In { Q = 9 }; }; void f() { int a = X; E b = Y; F c = F::Z; int d = S::Q; }"
    )
    values = {value: facts.one("expr_constant", expr) for expr, kind, value in facts["literal"] if kind == "enum"}
    assert values == {"E::X": "0", "E::Y": "5", "F::Z": "7", "S::In::Q": "9"}


def test_braced_lists(facts_of) -> None:
    facts = facts_of('#include <vector>\n#include <string>\nvoid f() { int a[] = {1, 2}; std::vector<std::string> v = {"x", "y"}; }')
    values = {variable.partition("@")[0]: facts.show(value) for variable, value in facts["variable_initializer"]}
    assert values["a"] == "{}(1, 2)"
    assert '"x"' in values["v"] and '"y"' in values["v"]


def test_braced_lists_that_make_structures_have_a_type(facts_of) -> None:
    facts = facts_of("struct S { int a; int b; }; void g(const S &); void f() { S s{1, 2}; g({3, 4}); int a[]{5}; }")
    lists = {facts.show(expr): facts.all("expr_type", expr) for expr, name in facts["operator"] if name == "{}"}
    assert lists == {"{}(1, 2)": [("S",)], "{}(3, 4)": [("const S",)], "{}(5)": []}


def test_range_for(facts_of) -> None:
    facts = facts_of(
        "#include <vector>\n#include <string>\nvoid g(const std::string&);\n"
        'void f(std::vector<std::string> names) { for (const auto& n : names) g(n); for (const char* c : {"a", "b"}) g(c); }'
    )
    found = {variable.partition("@")[0]: facts.show(container) for variable, container in facts["range_variable"]}
    assert found == {"n": "names", "c": '{}("a", "b")'}
    assert facts.callees() == ["g", "g"]


def test_text_is_the_source_folded(facts_of) -> None:
    facts = facts_of(
        "void g(int, int);\nvoid f(int a) {\n  g(a +\n      1,   a\n);\n  if (a\n   > 2) {}\n  int b = a  *  3;\n  a = b  - 1;\n}"
    )
    texts = {text for _, text in facts["expr_text"]}
    assert {"a + 1", "a", "a > 2", "a * 3", "b - 1"} <= texts


def test_text_is_cut_at_2000_characters(facts_of) -> None:
    facts = facts_of(f'void g(const char*); void f() {{ g("{"x" * 3000}"); }}')
    texts = {text for _, text in facts["expr_text"]}
    (text,) = (text for text in texts if text.startswith('"'))
    assert len(text) == 2000
    assert text.endswith("...")
    assert literals(facts) == [("string", "x" * 3000)]


def test_arguments_of_operators_keep_source_order(facts_of) -> None:
    facts = facts_of('#include <string>\nvoid f() { std::string s; s = "a" + s; bool b = "x" == s; }')
    shown = {facts.show(expr) for expr, _ in facts["operator"]}
    assert {'("a" + s)', '(s = ("a" + s))', '("x" == s)'} <= shown


def test_an_unknown_form_is_a_row_with_its_parts(facts_of) -> None:
    facts = facts_of("int g(int); void f() { auto x = missing(g(1)); }")
    ((_variable, value),) = facts["variable_initializer"]
    assert facts.all("expr_unknown", value) == [("form",)]
    assert dict(facts["expr_text"])[value] == "missing(g(1))"
    assert [facts.show(call) for call in facts.calls()] == ["g(1)"]


def test_throw_and_delete_are_operators(facts_of) -> None:
    facts = facts_of("struct E { E(int); }; void f(int* p) { delete p; throw E(1); }")
    assert sorted(facts.show(expr) for expr, operator in facts["operator"] if operator in ("throw", "delete")) == [
        "delete(p)",
        "throw(E(1))",
    ]


def test_casts_and_lambdas_have_a_type(facts_of) -> None:
    facts = facts_of("struct A {}; struct B : A {}; void f(A* a) { auto b = static_cast<B*>(a); }")
    (cast,) = [expr for expr, operator in facts["operator"] if operator == "cast"]
    assert facts.one("expr_type", cast) == "B *"


def test_return_values(facts_of) -> None:
    facts = facts_of('const char* f(int a) { if (a) return "x"; return a > 1 ? "y" : "z"; }')
    assert [facts.show(value) for _, value in facts["return_value"]] == ['"x"', '?:((a > 1), "y", "z")']


def test_a_path_that_a_definition_gives_is_told_from_the_workspace(tmp_path: Path) -> None:
    source = tmp_path / "src" / "n.cpp"
    source.parent.mkdir()
    source.write_text('const char* a = CONFIG_DIR "/a.yaml"; const char* b = "/etc/b.yaml";')
    unit = CompileUnit(source, definitions=(f'CONFIG_DIR="{tmp_path}/src/config"',))
    rows = extract_unit(unit, tmp_path, HeaderFinder(tmp_path, tmp_path / "scratch", lambda _name: None), None)
    assert sorted(value for _, _, value in rows["literal"]) == ["/etc/b.yaml", "src/config/a.yaml"]
