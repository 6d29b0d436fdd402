"""The blocks of fields at the heads of checks, and what is said about those that are not as they should be."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.rule_programs.checks import FIELDS, CheckError, check_files, read_check, read_checks

BLOCK = """// id: demo-check
// title: A title
// help: What it finds.
// impact: high
// confidence: medium
// description:
// | Two lines
// | of text.
// scenario:
// |   first();
// |     second();
// recommendation: Repair it.
// message: {node} at {place} is wrong
// at: place
// evidence:
// | node
// | place: told as {node}

/// There is `node` at `place`. Must.
.decl demo_check(node: Start, place: Place)
"""


def write(folder: Path, text: str) -> Path:
    path = folder / "demo-check.dl"
    path.write_text(text)
    return path


def test_a_block(tmp_path: Path) -> None:
    check = read_check(write(tmp_path, BLOCK))
    assert (check.id, check.title, check.help, check.severity) == ("demo-check", "A title", "What it finds.", "warning")
    assert check.description == "Two lines\nof text."
    assert check.scenario == "first();\n  second();"
    assert (check.relation, check.columns) == ("demo_check", (("node", "Start"), ("place", "Place")))
    assert check.evidence == (("place", ""), ("node", ""), ("place", "told as {node}"))


@pytest.mark.parametrize(
    ("impact", "confidence", "severity"),
    [
        ("high", "high", "error"), ("high", "medium", "warning"), ("medium", "high", "warning"), ("medium", "medium", "warning"),
        ("low", "high", "note"), ("high", "low", "note"), ("low", "low", "note"),
    ],
)  # fmt: skip
def test_severities(impact: str, confidence: str, severity: str, tmp_path: Path) -> None:
    text = BLOCK.replace("impact: high", f"impact: {impact}").replace("confidence: medium", f"confidence: {confidence}")
    assert read_check(write(tmp_path, text)).severity == severity


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("// id: demo-check", "// id: other-check", "1:8: the id `other-check` is not the name of the file"),
        ("// impact: high", "// impact: huge", "4:12: impact is `huge`, not one of high, medium, low"),
        ("// confidence: medium", "// confidence: sure", "5:16: confidence is `sure`, not one of high, medium, low"),
        ("// help: What", "// halp: What", "3:1: a check has no field `halp`, did you mean `help`?"),
        ("// title: A title", "// title: A title\n// title: B", "3:1: the field `title` is there twice"),
        ("is wrong", "is {wrong}", "13:35: demo_check has no column `wrong`"),
        ("// at: place", "// at: plaice", "14:8: demo_check has no column `plaice`, did you mean `place`?"),
        ("told as {node}", "told as {nod}", "17:22: demo_check has no column `nod`, did you mean `node`?"),
        (".decl demo_check", ".decl demo_chek", "1:1: the relation `demo_check` of the check is not declared"),
    ],
)
def test_what_is_wrong_with_a_block(old: str, new: str, message: str, tmp_path: Path) -> None:
    assert old in BLOCK
    path = write(tmp_path, BLOCK.replace(old, new))
    with pytest.raises(CheckError) as caught:
        read_check(path)
    assert str(caught.value) == f"{path}:{message}"


@pytest.mark.parametrize("columns", ["node: Start, at: Place, written: symbol", "other: Start, at: Place, written: symbol, meant: symbol"])
def test_fixes_with_other_columns(columns: str, tmp_path: Path) -> None:
    path = write(tmp_path, f"{BLOCK}.decl demo_check_fix({columns})\n")
    with pytest.raises(CheckError, match="1:1: demo_check_fix has other columns than some of demo_check and at, written, meant"):
        read_check(path)


@pytest.mark.parametrize("field", [name for name in FIELDS if name != "evidence"])
def test_a_missing_field(field: str, tmp_path: Path) -> None:
    path = write(tmp_path, BLOCK.replace(f"// {field}:", "// |"))
    with pytest.raises(CheckError) as caught:
        read_check(path)
    assert str(caught.value) == f"{path}:1:1: the check has no field `{field}`"


def test_evidence_may_be_left_out(tmp_path: Path) -> None:
    head, _, rest = BLOCK.partition("// evidence:")
    assert read_check(write(tmp_path, head + rest[rest.index("\n\n") :])).evidence == (("place", ""),)


def test_checks_are_found_on_disk(tmp_path: Path) -> None:
    path = write(tmp_path, BLOCK)
    (tmp_path / "notes.txt").write_text("")
    assert check_files(tmp_path) == [path]
    assert [check.id for check in read_checks([path])] == ["demo-check"]


def test_all_that_ship_can_be_read() -> None:
    found = read_checks(check_files())
    assert len(found) > 20
    for check in found:
        assert check.scenario and check.recommendation.endswith(".") and check.help.endswith("."), check.id
