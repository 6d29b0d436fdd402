"""Sources that are empty, broken, not text or very large: rows as far as they go, never an exception."""

from __future__ import annotations

import gc
import os
import time
from pathlib import Path

import pytest

from rosarch.base.boundary import confined
from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.translation_unit import CompileUnit, extract_unit


@pytest.mark.parametrize(
    "source", ["", " \n\n", "// only a comment", "#include <vector>\n", "\\", "\0", bytes(range(256)) * 20, "void f();".encode("utf-16")]
)
def test_a_source_without_declarations_has_no_calls(facts_of, source: str | bytes) -> None:
    facts = facts_of(source)
    assert facts["call"] == []
    assert facts["function_defined"] == []


@pytest.mark.parametrize(
    "source",
    [
        b'void p(const char*);\nvoid f() { p("z"); /* \xff\xfe */ }\n// caf\xe9\n',
        b'\xef\xbb\xbfvoid p(const char*);\nvoid f() { p("z"); }',
        b'void p(const char*);\n\0 void f() { p("z"); }',
    ],
)
def test_bytes_that_are_not_utf8_cost_nothing_else(facts_of, source: bytes) -> None:
    facts = facts_of(source)
    assert facts.callees() == ["p"]
    assert [value for _, _, value in facts["literal"]] == ["z"]


def test_a_literal_that_is_not_utf8(facts_of) -> None:
    facts = facts_of(b'void p(const char*);\nvoid f() { p("caf\xe9"); }')
    ((_, kind, value),) = facts["literal"]
    assert kind == "string"
    assert str(value).startswith("caf") and len(str(value)) == 4


def test_a_source_that_includes_itself(facts_of) -> None:
    facts = facts_of('#ifndef ONCE\n#define ONCE\n#include "n.cpp"\nvoid g(); void f() { g(); }\n#endif\n')
    assert facts.callees() == ["g"]


def test_a_source_that_includes_itself_without_end(facts_of) -> None:
    facts = facts_of('#include "n.cpp"\nvoid g(); void f() { g(); }')
    assert facts.callees() == ["g"]


def test_missing_includes_are_rows(extract) -> None:
    facts = extract(
        '#include "gone/there.h"\n#include "h.h"\n#include <pkg_msgs/Thing.h>\nvoid g(); void f() { g(); }',
        "n.cpp",
        {"h.h": "\n#include <also.h>\n"},
    )
    found = {(str(file).partition("#")[0], line, header) for file, line, header in facts.raw["include_missing"]}
    assert found == {("n.cpp", 1, "gone/there.h"), ("n.cpp", 3, "pkg_msgs/Thing.h"), ("h.h", 2, "also.h")}
    assert ("pkg_msgs::Thing_", "message", "pkg_msgs/Thing") in facts["message_class"]
    assert facts.callees() == ["g"]


def test_a_header_that_is_a_pipe_is_not_opened(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.h")
    (tmp_path / "n.cpp").write_text('#include "pipe.h"\nvoid g(); void f() { g(); }')
    with confined([tmp_path]):
        finder = HeaderFinder(tmp_path, tmp_path / "scratch", lambda _name: None)
        rows = extract_unit(CompileUnit(tmp_path / "n.cpp"), tmp_path, finder, None)
    assert len(rows["call_function"]) == 1


def test_a_source_that_is_not_there(tmp_path: Path, prelude: Path) -> None:
    unit = CompileUnit(tmp_path / "gone.cpp")
    with pytest.raises(FileNotFoundError, match=r"No such file or directory: '.*/gone\.cpp'$"):
        extract_unit(unit, tmp_path, HeaderFinder(tmp_path, tmp_path / "scratch", lambda _name: None), prelude)


@pytest.mark.parametrize(
    "source",
    [
        "void f() { if ( { g(; }\nvoid h() {}", "void f() { { { ", "}}}}\nvoid f() {}", "class {", "template <", "#if 1\nvoid f() {}", "#define\n#include\nvoid f() {}",
        '"unterminated', "void f() { for (;;", "struct S { S() : a(", "auto f() -> decltype(", "void f() { switch (1) { case }", "void f() { [&](", "enum { A = };",
        "namespace a { namespace a { void a::a::a() { a(); } } }", "using namespace gone; void f() { try { } }", "void f() { int a[]; a[1](2)(3)->x; }", "int x = x;",
        "struct A : A { A a; };", "struct S; struct T : S { S s; void m() { s.gone(); } };", "template <class T> struct R : R<R<T>> {}; R<int> r;",
    ],
)  # fmt: skip
def test_broken_code_is_no_error(facts_of, source: str) -> None:
    facts = facts_of(source)
    assert set(row[0] for row in facts["function_defined"]) <= {row[0] for row in facts["function"]}
    assert {row[0] for row in facts["call_argument"]} <= {row[0] for row in facts["call"]}


def test_two_hundred_parentheses(facts_of) -> None:
    facts = facts_of("void g(); int f(int x) { return " + "(" * 200 + "x" + ")" * 200 + "; }\nvoid h() { g(); }")
    assert [facts.show(value) for _, value in facts["return_value"]] == ["x"]
    assert facts.callees() == ["g"]


@pytest.mark.parametrize("brackets", ["()", "{}"])
def test_five_hundred_brackets(facts_of, brackets: str) -> None:
    inner = "g();" if brackets == "{}" else "x"
    body = f"void f(int x) {{ {'' if brackets == '{}' else 'x = '}{brackets[0] * 500}{inner}{brackets[1] * 500}; }}"
    facts = facts_of(f"void g();\n{body}\nvoid h() {{ g(); }}")
    assert "h@:3:6" in [row[0] for row in facts["function_defined"]]


@pytest.mark.parametrize(("term", "kind"), [("1", "int"), ('"a"', "std::string")])
def test_a_sum_of_two_thousand_terms(facts_of, term: str, kind: str) -> None:
    facts = facts_of(f"#include <string>\n{kind} f({kind} x) {{ return x{f' + {term}' * 2000}; }}")
    assert len([1 for _, operator in facts["operator"] if operator == "+"]) == 2000
    assert len(facts["return_value"]) == 1


def test_a_chain_of_five_hundred_else_ifs(facts_of) -> None:
    facts = facts_of("void g(); void f(int a) {" + " else ".join(f"if (a == {i}) g();" for i in range(500)) + "}")
    assert len(facts["call"]) == 500
    assert len(facts["block_condition"]) == 500


@pytest.mark.slow
@pytest.mark.parametrize(
    "deep",
    [
        "int f(int x) { return x" + " + 1" * 9000 + "; }",
        "struct G { G & operator()(); }; void f(G g) { g" + "()" * 7000 + "; }",
        "bool f(bool x) { if (x" + " && x" * 7000 + ") return true; return false; }",
        "void f(int x) { " + "".join(f"if (x == {i}) " for i in range(3000)) + "; }",
    ],
    ids=["sum", "calls", "condition", "statements"],
)
def test_what_is_nested_too_deeply_is_told_once_and_costs_nothing_else(facts_of, deep: str) -> None:
    facts = facts_of(f"void g();\n{deep}\nvoid h() {{ g(); }}")
    assert facts.callees()[-1] == "g"
    assert [(line, message) for _, line, _, message in facts.problems] == [(2, "nested too deeply, left out")]


def test_a_table_of_twenty_thousand_lines(facts_of) -> None:
    facts = facts_of("const int table[] = {\n" + "".join(f"  {i},\n" for i in range(20_000)) + "};\nvoid g(); void f() { g(); }")
    assert facts.callees() == ["g"]
    assert len(facts["literal"]) == 20_000


def _seconds(facts_of, source: str) -> float:
    gc.collect()
    gc.freeze()  # what other tests left is not looked through
    start = time.process_time()
    facts_of(source)
    gc.unfreeze()
    return time.process_time() - start


def _functions(count: int) -> str:
    return "void g(int);\n" + "".join(f"void f{i}(int a) {{ if (a > {i}) g(a + {i}); }}\n" for i in range(count))


@pytest.mark.slow
def test_many_functions_take_time_in_proportion(facts_of) -> None:
    """20,000 functions take two minutes; ten times as many functions may take fifteen times as long, not fifty."""
    facts_of(_functions(10))
    assert _seconds(facts_of, _functions(3000)) < 15 * _seconds(facts_of, _functions(300))
