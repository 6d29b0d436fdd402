"""Programs written for the C preprocessor: what they derive, and that messages name lines as written."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.datalog import DatalogError, explain, load_program, proof_text

SOURCE = """#define EDGE(a, b) edge(a, b). edge(b, a).
.decl edge(a: symbol, b: symbol)
EDGE("a", "b")
#ifdef MORE
EDGE("b", "c")
#endif
.decl path(a: symbol, b: symbol)
.output path
path(X, Y) :- edge(X, Y), X < Y.
"""


def test_macros_and_conditions(tmp_path: Path) -> None:
    path = tmp_path / "p.dl"
    path.write_text(SOURCE)
    assert load_program(path, preprocess=True).evaluate({}).rows("path") == [("a", "b")]
    more = load_program(path, macros=["MORE"])
    assert more.evaluate({}).rows("path") == [("a", "b"), ("b", "c")]
    proof = proof_text(explain(more, more.evaluate({}, keep="all"), "path(b, c)"))
    assert proof.splitlines()[0] == f'path("b", "c")  {path}:9'


def test_it_is_off_unless_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "p.dl"
    path.write_text("#define X 1\n.decl r(a: number)\nr(X) :- X = 2.\n")
    assert load_program(path).evaluate({}, keep=["r"]).rows("r") == [(2,)]
    assert load_program(path, preprocess=True).evaluate({}, keep=["r"]).rows("r") == []


def test_messages_name_the_place_as_written(tmp_path: Path) -> None:
    (tmp_path / "lib.dl").write_text("// a library\n.decl n(x: number)\nn(y).\n")
    path = tmp_path / "p.dl"
    path.write_text('#include "lib.dl"\n#define TWICE(x) (x + x)\n\nn(TWICE(1)).\nn(TWICE(1)) :- m(1).\n')
    with pytest.raises(DatalogError) as caught:
        load_program(path, preprocess=True)
    first, second = caught.value.diagnostics
    assert (first.headline, first.source) == (f"{tmp_path}/lib.dl:3:3: ungrounded variable `y`", "n(y).")
    assert (second.headline, second.source) == (f"{path}:5:16: unknown relation `m`", "n(TWICE(1)) :- m(1).")


def test_a_missing_file_is_an_error_where_it_is_included(tmp_path: Path) -> None:
    path = tmp_path / "p.dl"
    path.write_text('.decl n(x: number)\n#include "nowhere.dl"\n')
    with pytest.raises(DatalogError) as caught:
        load_program(path, preprocess=True)
    assert caught.value.diagnostics[0].headline == f"{path}:2:1: cannot find `nowhere.dl`"


def test_files_that_include_each_other(tmp_path: Path) -> None:
    path = tmp_path / "p.dl"
    path.write_text('#include "p.dl"\n')
    with pytest.raises(DatalogError) as caught:
        load_program(path, preprocess=True)
    assert caught.value.diagnostics[0].headline == f"{path}:1:1: files include each other without end"


def test_a_file_may_be_included_in_two_components(tmp_path: Path) -> None:
    (tmp_path / "body.dl").write_text(".decl r(x: number)\nr(1).\n")
    path = tmp_path / "p.dl"
    path.write_text('.comp A { .include "body.dl" }\n.comp B { .include "body.dl" r(2). }\n.init a = A\n.init b = B\n')
    result = load_program(path).evaluate({}, keep="all")
    assert (result.rows("a.r"), result.rows("b.r")) == ([(1,)], [(1,), (2,)])


def test_text_that_is_not_utf8(tmp_path: Path) -> None:
    path = tmp_path / "p.dl"
    path.write_bytes(b'.decl r(x: symbol)\nr("\xc3\xa4\xff").\n')
    with pytest.raises(DatalogError) as caught:
        load_program(path)
    assert str(caught.value) == f"{path}:2:5: not UTF-8 text: byte 0xff"
