"""Programs, results, includes and the cache."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.datalog import Attribute, DatalogError, Program, cache, load_declarations, load_program
from rosarch.datalog.language import parser
from rosarch.datalog.language.errors import Report

TYPED = """.type Node <: symbol
.type P = [x: number]
.type E = One {} | Two {}
.decl plain(x: number)

/// `a` reaches `b`.
/// Must.
.decl edge(a: Node, b: Node) btree
.input edge
.decl all(n: number, u: unsigned, f: float, s: symbol, p: P, e: E)
.output all(IO=stdout)
"""


def test_declarations(load: Callable[[str], Program]) -> None:
    relations = load(TYPED).relations
    edge = relations["edge"]
    assert edge.attributes == (Attribute("a", "Node", "symbol"), Attribute("b", "Node", "symbol"))
    assert edge.doc == "`a` reaches `b`.\nMust."
    assert (edge.location.line, edge.location.column) == (8, 7)
    assert (edge.is_input, edge.is_output, edge.qualifiers) == (True, False, {"btree"})
    assert [a.base for a in relations["all"].attributes] == ["number", "unsigned", "float", "symbol", "record", "adt"]
    assert relations["all"].is_output
    assert relations["plain"].doc == ""


def test_load_declarations_does_not_check_rules(tmp_path: Path) -> None:
    path = tmp_path / "schema.dl"
    path.write_text(TYPED + "edge(x, y) :- unknown(x).\n")
    assert list(load_declarations(path)) == ["plain", "edge", "all"]


def test_includes_are_relative_and_entered_once(tmp_path: Path) -> None:
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "types.dl").write_text(".type T <: symbol\n")
    (tmp_path / "sub" / "schema.dl").write_text('.include "types.dl"\n.decl e(x: T)\n.input e\n')
    (tmp_path / "main.dl").write_text('.include "sub/schema.dl"\n.include "sub/types.dl"\n.decl r(x: T)\n.output r\nr(x) :- e(x).\n')
    assert load_program(tmp_path / "main.dl").evaluate({"e": [("v",)]}).rows("r") == [("v",)]


@pytest.mark.parametrize("endless", ["/dev/zero", "fifo"])
def test_include_without_end(tmp_path: Path, endless: str) -> None:
    os.mkfifo(tmp_path / "fifo")
    (tmp_path / "main.dl").write_text(f'.include "{endless}"\n')
    with pytest.raises(DatalogError) as caught:
        load_program(tmp_path / "main.dl")
    assert caught.value.diagnostics[0].headline == f"{tmp_path}/main.dl:1:10: cannot read `{tmp_path / endless}`: Not a regular file"


def test_missing_include(tmp_path: Path) -> None:
    (tmp_path / "main.dl").write_text('.include "gone.dl"\n')
    with pytest.raises(DatalogError) as caught:
        load_program(tmp_path / "main.dl")
    assert caught.value.diagnostics[0].headline == (f"{tmp_path}/main.dl:1:10: cannot read `{tmp_path}/gone.dl`: No such file or directory")


def test_several_roots_and_extra_source(tmp_path: Path) -> None:
    (tmp_path / "a.dl").write_text(".decl e(x: symbol)\n.input e\n")
    (tmp_path / "b.dl").write_text(".decl r(x: symbol)\n.output r\nr(x) :- e(x).\n")
    program = load_program([tmp_path / "a.dl", tmp_path / "b.dl"], extra_source='r("extra").')
    assert program.evaluate({"e": [("v",)]}).rows("r") == [("extra",), ("v",)]


def test_keep(load: Callable[[str], Program]) -> None:
    program = load(".decl a(x: number)\n.decl b(x: number)\n.output b\na(2). a(1).\nb(x) :- a(x).\n")
    assert program.evaluate({}).names() == ["b"]
    assert program.evaluate({}, keep="all").names() == ["a", "b"]
    assert program.evaluate({}, keep=["a"]).rows("a") == [(1,), (2,)]
    with pytest.raises(DatalogError, match="no rows of `a` were kept"):
        program.evaluate({}).rows("a")
    with pytest.raises(DatalogError, match="unknown relation `c`"):
        program.evaluate({}, keep=["c"])


def test_facts_of_other_relations_are_refused(load: Callable[[str], Program]) -> None:
    program = load(TYPED)
    with pytest.raises(DatalogError, match="facts given for the unknown relation `egde`, did you mean `edge`"):
        program.evaluate({"egde": []})
    with pytest.raises(DatalogError, match=r"facts given for `plain`, which is not an `\.input` relation"):
        program.evaluate({"plain": [(1,)]})


def test_rows_of_the_wrong_length_are_refused(load: Callable[[str], Program]) -> None:
    with pytest.raises(DatalogError, match=r"facts of `edge`: expected 2 columns, given \('a',\)"):
        load(TYPED).evaluate({"edge": [("a", "b"), ("a",)]})


def test_evaluations_are_independent(load: Callable[[str], Program]) -> None:
    program = load(".decl e(x: number)\n.input e\n.decl r(x: number)\n.output r\nr(x) :- e(x).\nr(0).\n")
    assert program.evaluate({"e": [(1,)]}).rows("r") == [(0,), (1,)]
    assert program.evaluate({"e": [(2,)]}).rows("r") == [(0,), (2,)]
    assert pickle.loads(pickle.dumps(program)).evaluate({}).rows("r") == [(0,)]


def test_a_damaged_entry_of_the_cache_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(tmp_path / "cache"))
    cache.store([tmp_path], "", {}, ("program", b"code", [1, 2, 3]))
    assert cache.load([tmp_path], "") == ("program", b"code", [1, 2, 3])
    (entry,) = (tmp_path / "cache" / "datalog").iterdir()
    content = entry.read_bytes()
    for at in range(len(content)):
        entry.write_bytes(content[:at] + bytes([content[at] ^ 1]) + content[at + 1 :])
        assert cache.load([tmp_path], "") is None


@pytest.mark.slow
def test_damaged_tables_of_the_parser_are_made_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(tmp_path / "cache"))
    text = ".decl r(x: number)\nr(1) :- r(2), !r(3)."

    def parsed() -> str:
        parser._parser.cache_clear()
        return repr(parser.parse_text(text, "", report := Report({}))) + repr(report.errors)

    expected = parsed()
    (entry,) = (tmp_path / "cache" / "datalog").iterdir()
    content = entry.read_bytes()
    assert parsed() == expected
    for at in range(40, len(content), len(content) // 8):
        entry.write_bytes(damaged := content[:at] + bytes([content[at] ^ 1]) + content[at + 1 :])
        assert parsed() == expected
        assert entry.read_bytes() != damaged
    parser._parser.cache_clear()


def test_cache_follows_content(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(tmp_path / "cache"))
    (tmp_path / "inc.dl").write_text("r(1).\n")
    (tmp_path / "main.dl").write_text('.decl r(x: number)\n.output r\n.include "inc.dl"\n')
    first = load_program(tmp_path / "main.dl")
    assert load_program(tmp_path / "main.dl").hash == first.hash
    (tmp_path / "inc.dl").write_text("r(2).\n")
    second = load_program(tmp_path / "main.dl")
    assert second.hash != first.hash
    assert second.evaluate({}).rows("r") == [(2,)]
    for entry in (tmp_path / "cache" / "datalog").iterdir():
        entry.write_bytes(b"broken")
    assert load_program(tmp_path / "main.dl").evaluate({}).rows("r") == [(2,)]


def test_rows_do_not_depend_on_the_hash_seed(tmp_path: Path) -> None:
    (tmp_path / "p.dl").write_text(
        '.decl s(x: symbol)\ns("a"). s("b"). s("c"). s("d").\n.decl r(i: number, x: symbol)\n.output r\n'
        "r(autoinc(), cat(x, y)) :- s(x), s(y), ord(x) < ord(y).\n"
    )
    command = [sys.executable, "-m", "rosarch.datalog", str(tmp_path / "p.dl"), "-F", str(tmp_path), "-D-"]
    outputs = {
        subprocess.run(command, capture_output=True, text=True, check=True, env={"PYTHONHASHSEED": seed}).stdout for seed in ("1", "2", "3")
    }
    assert len(outputs) == 1


def test_unknown_engine(load: Callable[[str], Program]) -> None:
    with pytest.raises(DatalogError, match="unknown engine `fast`, expected `embedded` or `souffle`"):
        load(TYPED).evaluate({}, engine="fast")


def test_souffle_engine_without_souffle(load: Callable[[str], Program], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    with pytest.raises(DatalogError, match="the souffle engine was asked for, but there is no `souffle` on PATH"):
        load(TYPED).evaluate({}, engine="souffle")


def test_a_result_does_not_change_with_the_facts_it_is_from(load: Callable[[str], Program]) -> None:
    facts = {"edge": [("a", "b")]}
    result = load(".decl edge(a: symbol, b: symbol)\n.input edge\n.decl node(a: symbol)\n.output node\nnode(x) :- edge(x, _).\n").evaluate(
        facts, keep="all"
    )
    facts["edge"].append(("c", "d"))
    assert result.rows("edge") == [("a", "b")]
