"""The whole models of the example workspaces, which were written by hand, against what the command writes."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
NAMES = sorted(path.parent.name for path in EXAMPLES.glob("*/expected"))


def documents(folder: Path) -> dict[str, str]:
    return {path.relative_to(folder).as_posix(): path.read_text() for path in sorted(folder.glob("*/*.json"))}


@pytest.mark.parametrize("name", NAMES)
def test_models_are_as_written_by_hand(name: str, rosarch: Callable, tmp_path: Path) -> None:
    outcome = rosarch("analyze", EXAMPLES / name, "-o", tmp_path)
    found, expected = documents(tmp_path), documents(EXAMPLES / name / "expected")
    assert outcome.code == 0
    assert sorted(found) == sorted(expected)
    for path, text in expected.items():
        assert json.loads(found[path]) == json.loads(text), path
        assert found[path] == text, path


@pytest.mark.parametrize("name", NAMES)
def test_nothing_is_left_unsaid(name: str, rosarch: Callable) -> None:
    assert rosarch("analyze", EXAMPLES / name).err == ""


def test_every_example_has_expected_models() -> None:
    assert sorted(path.name for path in EXAMPLES.iterdir() if path.is_dir()) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_places_name_the_call(name: str) -> None:
    for path in (EXAMPLES / name / "expected").glob("*/*.json"):
        for port in json.loads(path.read_text())["ports"]:
            file, line = port["at"].rsplit(":", 1)
            assert (EXAMPLES / name / file).read_text().splitlines()[int(line) - 1].strip(), port
