"""What `docs/expectations.md` shows is so."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.evaluation.expectations.comments import marked
from rosarch.evaluation.expectations.elements import kinds
from rosarch.evaluation.expectations.grammar import parse

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "docs/expectations.md").read_text(encoding="utf-8")
FOLLOWER = ROOT / "examples/expectations/wall_follower.cpp"


def block(language: str) -> str:
    found: str = re.findall(rf"```{language}\n(.*?)```", TEXT, re.DOTALL)[0]
    return found


def test_the_comments_are_those_of_the_example() -> None:
    assert {line.strip() for line in block("cpp").splitlines()} <= {line.strip() for line in FOLLOWER.read_text().splitlines()}


def test_the_report(rosarch: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "wall_follower.cpp").write_text(FOLLOWER.read_text().replace("Twist queue=1\n", "Twist queue=10\n"))
    monkeypatch.chdir(tmp_path)
    outcome = rosarch("rules", "test", "wall_follower.cpp")
    shown = TEXT.partition("is not understood):\n\n```text\n")[2].partition("```")[0]
    assert (outcome.code, "".join(outcome.out.splitlines(keepends=True)[:-1])) == (1, shown)


def test_every_kind_and_attribute_is_described() -> None:
    table = {row[0]: row[1] for row in re.findall(r"^\| (.*?) \| (.*?) \|$", TEXT, re.MULTILINE)}
    words = " ".join(f"{key} {value}" for key, value in table.items())
    for kind in kinds().values():
        assert re.search(rf"`{kind.name}\b", words), kind.name
    told = {name for value in table.values() for name in re.findall(r"`(\w+)`", value)}
    assert told == {name for kind in kinds().values() for name in kind.attributes if name not in (*kind.subject, kind.then)}


def test_what_is_shown_is_understood() -> None:
    shown = [text for text in re.findall(r"`((?:finding|port_type|\d+ =) [^`]*|port_type\(.*?)`", TEXT) if "CHECK" not in text]
    assert len(shown) >= 3
    for text in shown:
        (found,) = marked("a.cpp", f"// expect: {text}\n")
        parse(found)
