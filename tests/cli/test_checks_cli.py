"""`rosarch rules checks`, and the reference that it writes."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.rule_programs.checks import check_files

ROOT = Path(__file__).resolve().parents[2]


def test_a_line_for_each_check(rosarch: Callable) -> None:
    outcome = rosarch("rules", "checks")
    lines = outcome.out.splitlines()
    assert (outcome.code, outcome.err) == (0, "")
    assert {path.stem for path in check_files()} | {"unused-suppression", "suppression-without-reason"} == {
        line.split()[1] for line in lines[:-1]
    }
    severities = [line.split()[0] for line in lines[:-1]]
    assert severities == sorted(severities, key=["error", "warning", "note"].index)
    counts = [severities.count(word) for word in ("error", "warning", "note")]
    assert lines[-1] == f"{len(severities)} checks: {counts[0]} errors, {counts[1]} warnings, {counts[2]} notes"
    assert re.search(r"^error    topic-type-mismatch +Publisher and subscriber with different message types$", outcome.out, re.MULTILINE)


def test_an_explanation(rosarch: Callable) -> None:
    assert rosarch("rules", "checks", "unused-suppression").out == (
        "unused-suppression  note (impact low, confidence high)\n"
        "Suppression comment that suppresses nothing\n"
        "\n"
        "A `rosarch: ignore[...]` comment names a check that finds nothing there.\n"
        "The fault was repaired, the code moved, or the id is misspelt. A comment left behind hides the next true finding.\n"
        "\n"
        "for example:\n"
        "  // rosarch: ignore[topic-typ-mismatch] the simulator converts\n"
        '  sub_ = nh.subscribe("odom", 1, &Node::onOdom, this);\n'
        "\n"
        "what to do: Remove the id from the comment, or correct it.\n"
    )


def test_several_are_explained(rosarch: Callable) -> None:
    out = rosarch("rules", "checks", "topic-*", "duplicate-node").out
    assert re.findall(r"^([a-z-]+)  (?:error|warning|note) \(", out, re.MULTILINE) == [
        "duplicate-node",
        "topic-name-mismatch",
        "topic-renamed",
        "topic-silenced",
        "topic-too-fast",
        "topic-too-slow",
        "topic-type-mismatch",
    ]
    assert re.findall(r"^rules: (.*)$", out, re.MULTILINE)[0] == "rules/checks/duplicate-node.dl"


def test_an_unknown_check(rosarch: Callable) -> None:
    outcome = rosarch("rules", "checks", "topic-type-mismach")
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err == "rosarch: error: no check topic-type-mismach, did you mean `topic-type-mismatch`?\n"


def test_one_as_markdown(rosarch: Callable) -> None:
    out = rosarch("rules", "checks", "unused-suppression", "--format", "markdown").out
    assert out.startswith(
        "## unused-suppression\n\nSuppression comment that suppresses nothing. *Note*: impact low, confidence high.\n\n"
        "A `rosarch: ignore[...]` comment names a check that finds nothing there. The fault was repaired"
    )
    assert out.endswith("```\n\nWhat to do: Remove the id from the comment, or correct it.\n")


def test_the_reference_is_up_to_date(rosarch: Callable) -> None:
    """Otherwise: rosarch rules checks --format markdown > docs/check-reference.md"""
    assert (ROOT / "docs/check-reference.md").read_text(encoding="utf-8") == rosarch("rules", "checks", "--format", "markdown").out


@pytest.mark.slow
def test_checks_of_ones_own(rosarch: Callable, tmp_path: Path) -> None:
    check = (
        (ROOT / "rules/checks/home-path-of-machine.dl")
        .read_text(encoding="utf-8")
        .replace("home-path-of-machine", "own-check")
        .replace("home_path_of_machine", "own_check")
    )
    (tmp_path / "own-check.dl").write_text(check)
    (tmp_path / "plain.dl").write_text(".decl plain(x: symbol)\n")
    outcome = rosarch("rules", "checks", "own-check", "-r", tmp_path / "own-check.dl", "-r", tmp_path / "plain.dl")
    assert (outcome.code, outcome.out.splitlines()[-1]) == (0, f"rules: {tmp_path}/own-check.dl")
    (tmp_path / "own-check.dl").write_text(check.replace("// impact: low", "// impact: huge"))
    outcome = rosarch("rules", "checks", "-r", tmp_path / "own-check.dl")
    assert (outcome.code, outcome.err) == (
        2,
        f"rosarch: error: {tmp_path}/own-check.dl:4:12: impact is `huge`, not one of high, medium, low\n",
    )
