"""Facts on disk: only what the schema allows, one file per relation."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.datalog import read_facts
from rosarch.extractor.facts import SchemaError, schema, validate, write_component

GOOD = {"call": {("c1", "go")}, "call_argument": {("c1", 0, "a")}, "location": [("c1", "f", 3, 4)]}


@pytest.mark.parametrize("rows", [GOOD, {}, {"call": ()}])
def test_good_rows_are_written_as_they_are(tmp_path: Path, rows: dict[str, set[tuple[str | int, ...]]]) -> None:
    entry = write_component(tmp_path, "pkg", "node", "node", (), rows)
    assert {name: count for name, count in entry.rows.items() if count} == {name: len(found) for name, found in rows.items() if found}
    back = read_facts(tmp_path / "pkg/node", schema())
    assert {name: set(back[name]) for name in rows} == {name: set(found) for name, found in rows.items()}


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ({"calls": {("c1",)}}, "calls: no such relation in the schema"),
        ({"call": {("c1",)}}, "call: ('c1',) does not fit (call: Expr, name: symbol)"),
        ({"call": {("c1", "go", "more")}}, "call: ('c1', 'go', 'more') does not fit (call: Expr, name: symbol)"),
        ({"call": {("c1", 3)}}, "call: ('c1', 3) does not fit (call: Expr, name: symbol)"),
        ({"call_argument": {("c1", "0", "a")}}, "call_argument: ('c1', '0', 'a') does not fit (call: Expr, index: number, argument: Expr)"),
        (
            {"call_argument": {("c1", True, "a")}},
            "call_argument: ('c1', True, 'a') does not fit (call: Expr, index: number, argument: Expr)",
        ),
        ({"call": {("c1", None)}}, "call: ('c1', None) does not fit (call: Expr, name: symbol)"),
    ],
)
def test_bad_rows_are_refused(rows: dict[str, set[tuple[object, ...]]], message: str) -> None:
    with pytest.raises(SchemaError) as caught:
        validate(rows)  # type: ignore[arg-type]
    assert str(caught.value) == message


def test_the_schema_is_read_from_the_rules() -> None:
    assert {"call", "location", "component", "block_edge", "type_class"} <= set(schema())
    assert [(a.name, a.type, a.base) for a in schema()["call_argument"].attributes] == [
        ("call", "Expr", "symbol"),
        ("index", "number", "number"),
        ("argument", "Expr", "symbol"),
    ]


def test_a_component_is_a_folder_with_a_file_per_relation(tmp_path: Path) -> None:
    entry = write_component(tmp_path, "pkg", "node", "node", ("a.cpp",), GOOD)
    folder = tmp_path / "pkg/node"
    assert (entry.package, entry.component, entry.kind, entry.folder, entry.sources) == ("pkg", "node", "node", "pkg/node", ("a.cpp",))
    assert {path.stem for path in folder.iterdir()} == set(schema())
    assert (folder / "call_argument.facts").read_text(encoding="utf-8") == "c1\t0\ta\n"
    assert (folder / "variable.facts").read_text(encoding="utf-8") == ""
    assert {name: count for name, count in entry.rows.items() if count} == {"call": 1, "call_argument": 1, "location": 1}


def test_rows_are_sorted_and_read_back(tmp_path: Path) -> None:
    found = {"call": {("b", "x"), ("a", "ä y"), ("a", "")}}
    write_component(tmp_path, "p", "n", "node", (), found)
    assert (tmp_path / "p/n/call.facts").read_text(encoding="utf-8") == "a\t\na\tä y\nb\tx\n"
    assert set(read_facts(tmp_path / "p/n", schema())["call"]) == found["call"]


def test_tabs_and_line_breaks_are_no_separators(tmp_path: Path) -> None:
    write_component(tmp_path, "p", "n", "node", (), {"expr_text": {("e", "a\tb\nc")}})
    assert (tmp_path / "p/n/expr_text.facts").read_text(encoding="utf-8") == "e\ta b c\n"


def test_nothing_is_written_for_bad_rows(tmp_path: Path) -> None:
    with pytest.raises(SchemaError):
        write_component(tmp_path, "p", "n", "node", (), {"call": {("c",)}})
    assert list(tmp_path.iterdir()) == []


def test_the_digest_depends_on_the_rows(tmp_path: Path) -> None:
    one = write_component(tmp_path / "1", "p", "n", "node", (), GOOD)
    two = write_component(tmp_path / "2", "p", "n", "node", (), GOOD)
    three = write_component(tmp_path / "3", "p", "n", "node", (), {"call": {("c1", "stay")}})
    assert one.digest == two.digest != three.digest
