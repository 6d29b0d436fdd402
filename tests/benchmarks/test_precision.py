"""Findings and judgements: which belongs to which, and how they are counted."""

from __future__ import annotations

from pathlib import Path

import pytest
from precision import Judgement, Reported, counted, matched, read_judgements, table

pytestmark = pytest.mark.slow


def _finding(line: int, message: str = "a", *, system: str = "robot") -> Reported:
    return Reported(system, "missing-file", "a.launch", line, message)


def _judged(line: int, verdict: str, message: str = "a") -> Judgement:
    return Judgement(_finding(line, message), verdict, "cause")


def test_a_finding_may_have_moved_by_three_lines() -> None:
    judgement = _judged(10, "true")
    assert matched([_finding(13)], [judgement]) == {_finding(13): judgement}
    assert matched([_finding(14)], [judgement]) == {}
    assert matched([_finding(10, "b")], [judgement]) == {}
    assert matched([_finding(10, system="other")], [judgement]) == {}


def test_each_judgement_is_for_one_finding_the_nearest() -> None:
    first, second = _judged(10, "true"), _judged(12, "false")
    assert matched([_finding(11), _finding(12)], [first, second]) == {_finding(12): second, _finding(11): first}
    assert matched([_finding(12), _finding(13)], [first]) == {_finding(12): first}


def test_counts() -> None:
    judgements = [_judged(1, "true"), _judged(20, "harmless"), _judged(30, "false", "b"), _judged(40, "true"), _judged(50, "false")]
    counts = counted([_finding(1), _finding(20), _finding(30, "b"), _finding(60)], judgements)
    assert table(counts).splitlines() == [
        "| check | true | harmless | false | not judged | lost |",
        "|---|---:|---:|---:|---:|---:|",
        "| missing-file | 1 | 1 | 1 | 1 | 1 |",
        "| all | 1 | 1 | 1 | 1 | 1 |",
        "",
        "33.3 % true, 33.3 % harmless, 33.3 % false",
    ]


def test_verdicts_are_known_words(tmp_path: Path) -> None:
    path = tmp_path / "judgements.yml"
    row = "{system: robot, check: missing-file, file: a.launch, line: 3, message: a, cause: c, verdict: %s}"
    head = "systems: {robot: {}, empty: {}}\njudgements:\n"
    path.write_text(f"{head}- {row % 'true'}\n- {row % 'harmless'}\n")
    systems, judgements = read_judgements(path)
    assert (systems, [judgement.verdict for judgement in judgements]) == (["empty", "robot"], ["true", "harmless"])
    path.write_text(f"{head}- {row % 'maybe'}\n")
    with pytest.raises(SystemExit, match=r"verdict 'maybe' of a.launch:3 is none of true, harmless, false"):
        read_judgements(path)


def test_judgements_that_are_kept_here() -> None:
    systems, judgements = read_judgements(Path(__file__).parents[2] / "benchmarks" / "judgements.yml")
    assert {judgement.finding.system for judgement in judgements} <= set(systems)
    assert len({judgement.finding for judgement in judgements}) == len(judgements)
