"""The whole models of the example workspaces, which were written by hand, against what the command writes."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.examples.source_lines import making_line

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
ALL = sorted(path.parent.name for path in EXAMPLES.glob("*/expected"))
NAMES = sorted({path.parents[2].name for path in EXAMPLES.glob("*/expected/*/*.json")})
SYSTEMS = sorted(path.parents[1].name for path in EXAMPLES.glob("*/expected/findings.txt"))

BEHAVIOR = ("periodic", "reactive", "state_variables", "configuration", "transitions", "one_shot")


def documents(folder: Path) -> dict[str, Any]:
    return {path.relative_to(folder).as_posix(): json.loads(path.read_text()) for path in sorted(folder.glob("*/*.json"))}


def expected_documents(name: str) -> dict[str, Any]:
    """The models written by hand."""
    return documents(EXAMPLES / name / "expected")


@pytest.mark.parametrize("name", NAMES)
def test_models_are_as_written_by_hand(name: str, rosarch: Callable, tmp_path: Path) -> None:
    outcome = rosarch("analyze", EXAMPLES / name, "-o", tmp_path)
    found, expected = documents(tmp_path), expected_documents(name)
    assert outcome.code == 0
    agree(found, expected)


def agree(found: dict[str, Any], expected: dict[str, Any]) -> None:
    assert sorted(found) == sorted(expected)
    for path, wanted in expected.items():
        model = found[path]
        assert list(model) == list(wanted), path
        for key in wanted:
            if key not in BEHAVIOR:
                assert model[key] == wanted[key], (path, key)
            else:
                assert rows(model[key], wanted[key]) == wanted[key], (path, key)


def rows(found: list[dict[str, Any]], expected: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """What was found, with no other fields than are expected: conditions have more forms than the text that is written by hand."""
    fields = {key for row in expected for key in row}
    return [{key: value for key, value in row.items() if key in fields} for row in found]


@pytest.mark.skipif(shutil.which("souffle") is None, reason="there is no souffle on PATH")
@pytest.mark.parametrize("name", NAMES)
def test_models_are_the_same_with_souffle(name: str, rosarch: Callable, tmp_path: Path) -> None:
    assert rosarch("analyze", EXAMPLES / name, "--engine", "souffle", "-o", tmp_path).code == 0
    agree(documents(tmp_path), expected_documents(name))


@pytest.mark.parametrize("name", ALL)
def test_facts_are_as_shipped_and_nothing_is_left_unsaid(name: str, rosarch: Callable, tmp_path: Path) -> None:
    assert rosarch("extract", EXAMPLES / name, "--text", "--out", tmp_path / "facts.txt").err == ""
    shipped, found = (
        (folder / file).read_text().split("\n") for folder, file in ((EXAMPLES / "facts", f"{name}.txt"), (tmp_path, "facts.txt"))
    )
    assert shipped[1] == f"root\t../{name}"
    assert found[:1] + found[2:] == shipped[:1] + shipped[2:], "run `make facts`"


def test_no_facts_of_other_examples_are_shipped() -> None:
    assert sorted(path.stem for path in (EXAMPLES / "facts").iterdir()) == ALL


def test_every_example_has_expected_models_or_findings() -> None:
    assert sorted(path.parent.name for path in EXAMPLES.glob("*/src")) == ALL == sorted({*NAMES, *SYSTEMS})


def places(name: str) -> Iterator[tuple[dict[str, Any], list[str], int, re.Pattern[str]]]:
    """Each port, the lines of the file where it is made, the number of the line, and what that line should match."""
    headers = sorted((EXAMPLES / name / "src").rglob("*.h"))
    for path in (EXAMPLES / name / "expected").glob("*/*.json"):
        for port in json.loads(path.read_text())["ports"]:
            file, _, line = port["at"].rpartition(":")
            yield port, (EXAMPLES / name / file).read_text().splitlines(), int(line), making_line(port, EXAMPLES / name / file, headers)


@pytest.mark.parametrize("name", NAMES)
def test_places_name_what_makes_the_port(name: str) -> None:
    for port, lines, number, making in places(name):
        assert making.search(lines[number - 1]), (port, lines[number - 1])


@pytest.mark.parametrize("name", NAMES)
def test_other_lines_do_not(name: str) -> None:
    for port, lines, _, making in places(name):
        others = [text for text in lines if re.search(r"ros::init\(|ros::spin|spinOnce|ROS_|\breturn;|^ *}?$", text)]
        assert not [text for text in others if making.search(text)], port
