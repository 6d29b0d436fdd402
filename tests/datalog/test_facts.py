"""Fact files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.datalog import DatalogError, Program, read_facts, write_facts

SOURCE = """.type P = [x: number, y: symbol]
.type E = One {p: P} | Two {}
.decl e(a: symbol, n: number)
.input e
.decl f(n: number, u: unsigned, f: float)
.input f
.decl p(p: P, e: E)
.input p
.output p
.decl flag()
.input flag
"""


def test_round_trip(load: Callable[[str], Program], tmp_path: Path) -> None:
    relations = load(SOURCE).relations
    rows = {"e": [("a b", -1), ("", 2)], "f": [(1, 4294967295, 0.5)], "flag": [()]}
    write_facts(tmp_path / "facts", rows, relations)
    assert (tmp_path / "facts" / "e.facts").read_text() == "a b\t-1\n\t2\n"
    declared = {name: relations[name] for name in rows}
    assert read_facts(tmp_path / "facts", declared) == rows


def test_tabs_and_line_breaks_become_spaces(load: Callable[[str], Program], tmp_path: Path) -> None:
    write_facts(tmp_path, {"e": [("a\tb\nc", 1)]}, load(SOURCE).relations)
    assert (tmp_path / "e.facts").read_text() == "a b c\t1\n"


def test_records_and_branches(load: Callable[[str], Program], tmp_path: Path) -> None:
    (tmp_path / "p.facts").write_text("[1, x]\t$One([2, y])\nnil\t$Two\n")
    rows = load(SOURCE).evaluate(tmp_path).rows("p")
    assert rows == [(None, ("Two",)), ((1, "x"), ("One", (2, "y")))]


def test_missing_files_are_empty_and_windows_line_ends_are_read(load: Callable[[str], Program], tmp_path: Path) -> None:
    (tmp_path / "e.facts").write_bytes(b"a\t1\r\nb\t2\r\n")
    assert load(SOURCE).read_facts(tmp_path) == {"e": [("a", 1), ("b", 2)]}


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("e", "a\t1\na\n", "e.facts:2: expected 2 columns, found 1"),
        ("e", "a\tx\n", "e.facts:1: column 2 (`n`): `x` is not a number"),
        ("e", "a\t2147483648\n", "e.facts:1: column 2 (`n`): `2147483648` is out of range for a number"),
        ("f", "1\t-1\t0\n", "f.facts:1: column 2 (`u`): `-1` is out of range for an unsigned"),
        ("f", "1\t1\tx\n", "f.facts:1: column 3 (`f`): `x` is not a float"),
        ("p", "[1]\t$Two\n", "p.facts:1: column 1 (`p`): expected `,` at `]`"),
        ("p", "nil\t$Three\n", "p.facts:1: column 2 (`e`): expected a branch of `E` at `$Three`"),
    ],
)
def test_bad_rows(load: Callable[[str], Program], tmp_path: Path, name: str, text: str, message: str) -> None:
    (tmp_path / f"{name}.facts").write_text(text)
    with pytest.raises(DatalogError) as caught:
        load(SOURCE).evaluate(tmp_path)
    assert str(caught.value) == f"{tmp_path}/{message}"


def test_writing_checks_names_and_columns(load: Callable[[str], Program], tmp_path: Path) -> None:
    relations = load(SOURCE).relations
    with pytest.raises(DatalogError, match="cannot write facts of the undeclared relation `x`"):
        write_facts(tmp_path, {"x": []}, relations)
    with pytest.raises(DatalogError, match="`e` has 2 attributes, given 1"):
        write_facts(tmp_path, {"e": [("a",)]}, relations)


def test_parameters_of_input_directives(load: Callable[[str], Program], tmp_path: Path) -> None:
    (tmp_path / "edges.csv").write_text("a,b\nb,c\n")
    program = load('.decl e(a: symbol, b: symbol)\n.input e(IO=file, filename="edges.csv", delimiter=",")\n')
    assert program.evaluate(tmp_path, keep="all").rows("e") == [("a", "b"), ("b", "c")]
