"""What becomes of findings: severity, ignored paths, suppression comments, baseline, exit code."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations

import pytest
from handmade_findings import CHECKS, MISMATCH, NEAR_MISS, STYLE, finding

from rosarch.extractor.suppressions import Suppression
from rosarch.findings.baseline import Baseline
from rosarch.findings.model import Finding
from rosarch.findings.policy import Policy, Reported, Severities, apply_policy, identifiers, path_matches, unmatched


def comment(*checks: str, path: str = "a.cpp", line: int = 2, covers: int = 3, reason: str = "why") -> Suppression:
    return Suppression(path, line, 4, checks, reason, covers, covers)


def shown_rows(reported: Reported) -> list[tuple[str, str, int, str]]:
    return [(each.check.id, each.severity, each.place.line, each.message) for each in reported.shown]


def test_severity_is_that_of_the_check() -> None:
    reported = apply_policy([finding(STYLE), finding(NEAR_MISS), finding(MISMATCH)], Policy(), checks=CHECKS)
    assert [each.severity for each in reported.shown] == ["error", "warning", "note"]


@pytest.mark.parametrize(
    ("layers", "severity"),
    [
        ([], "warning"),
        ([(("near-miss", "error"),)], "error"),
        ([(("near-*", "note"),)], "note"),
        ([(("other", "note"),)], "warning"),
        ([(("near-miss", "error"), ("*", "ignore"))], "error"),  # the id says more than the wildcard
        ([(("near-miss", "error"), ("near-miss*", "ignore"))], "error"),
        ([(("*", "ignore"), ("near-*", "note"))], "note"),
        ([(("near-*", "note"), ("*", "ignore"))], "note"),
        ([(("*-miss", "note"), ("*ss", "ignore"))], "note"),
        ([(("near-*", "note"), ("near-*", "ignore"))], "ignore"),  # of equal ones the last
        ([(("near-miss", "error"),), (("*", "note"),)], "note"),  # a later layer overrules
        ([(("near-miss", "error"),), (("other", "note"),)], "error"),
    ],
)
def test_severity_overridden(layers: list[Severities], severity: str) -> None:
    policy = Policy(tuple(layers))
    assert policy.severity(finding(NEAR_MISS)) == severity
    shown = apply_policy([finding(NEAR_MISS)], policy, checks=CHECKS).shown
    assert [each.severity for each in shown] == ([] if severity == "ignore" else [severity])


@pytest.mark.parametrize(
    ("fail_on", "found", "code"),
    [
        ("error", MISMATCH, 1), ("error", NEAR_MISS, 0), ("error", STYLE, 0),
        ("warning", MISMATCH, 1), ("warning", NEAR_MISS, 1), ("warning", STYLE, 0),
        ("note", STYLE, 1), ("never", MISMATCH, 0),
    ],
)  # fmt: skip
def test_exit_code(fail_on: str, found, code: int) -> None:
    reported = apply_policy([finding(found)], Policy(fail_on=fail_on), checks=CHECKS)
    assert (reported.exit_code, reported.failed) == (code, bool(code))
    assert replace(reported, policy=replace(reported.policy, exit_zero=True)).exit_code == 0
    assert apply_policy([], Policy(fail_on=fail_on), checks=CHECKS).exit_code == 0


def test_overridden_severity_decides_on_failure() -> None:
    policy = Policy(((("style", "error"), ("type-mismatch", "note")),), fail_on="error")
    assert apply_policy([finding(STYLE)], policy, checks=CHECKS).exit_code == 1
    assert apply_policy([finding(MISMATCH)], policy, checks=CHECKS).exit_code == 0


def test_order_does_not_depend_on_that_of_the_findings() -> None:
    findings = [
        finding(path="b.cpp", line=1), finding(line=20), finding(line=3, column=2), finding(STYLE, line=3, column=2),
        finding(NEAR_MISS, line=3, column=2), finding(message="a", line=3, column=2),
    ]  # fmt: skip
    expected = [findings[i] for i in (5, 2, 4, 3, 1, 0)]
    for order in list(permutations(findings))[::50]:
        assert list(apply_policy(order, Policy(), checks=CHECKS).shown) == expected


@pytest.mark.parametrize(
    ("pattern", "path", "matches"),
    [
        ("third_party", "third_party/a.cpp", True),
        ("third_party/", "third_party/b/a.cpp", True),
        ("third_party", "src/third_party/a.cpp", True),
        ("third_party", "src/third_party_b/a.cpp", False),
        ("/third_party", "src/third_party/a.cpp", False),
        ("src/a", "src/a/b.cpp", True),
        ("src/a", "x/src/a/b.cpp", False),
        ("**/a/*.cpp", "x/y/a/b.cpp", True),
        ("**/a/*.cpp", "a/b.cpp", True),
        ("src/*/test", "src/p/test/t.launch", True),
        ("src/*/test", "src/p/q/test/t.launch", False),
        ("src/**/test", "src/p/q/test/t.launch", True),
        ("src/**", "src/a.cpp", True),
        ("*.test", "src/p/t.test", True),
        ("*.test", "src/p/t.tests", False),
        ("./src/a.cpp", "src/a.cpp", True),
        ("/opt/ros", "/opt/ros/x.h", True),
        ("a.cpp", "b.cpp", False),
        ("", "a.cpp", False),
        ("/", "a.cpp", False),
        ("**", "a.cpp", True),
        ("src/**/**/**/**/**/x", "src/" + "a/" * 200 + "y", False),
    ],
)
def test_paths(pattern: str, path: str, matches: bool) -> None:
    assert path_matches(pattern, path) == matches
    reported = apply_policy([finding(path=path)], Policy(ignored_paths=(pattern,)), checks=CHECKS)
    assert bool(reported.shown) != matches


def test_comment_suppresses_what_it_names_where_it_stands() -> None:
    here, elsewhere, other = finding(), finding(line=4), finding(NEAR_MISS)
    reported = apply_policy([here, elsewhere, other], Policy(), [comment("type-mismatch")], checks=CHECKS)
    assert reported.shown == (other, elsewhere)
    assert [(each.finding, each.suppression) for each in reported.suppressed] == [(here, comment("type-mismatch"))]
    assert apply_policy([here], Policy(), [comment("type-mismatch", path="b.cpp")], checks=CHECKS).shown[0] == here


def test_a_suppressed_finding_does_not_fail_the_run() -> None:
    assert apply_policy([finding()], Policy(fail_on="note"), [comment("type-mismatch")], checks=CHECKS).exit_code == 0


def test_suppressed_findings_have_the_severity_of_the_policy() -> None:
    policy = Policy(((("type-mismatch", "note"),),))
    assert [each.finding.severity for each in apply_policy([finding()], policy, [comment("type-mismatch")], checks=CHECKS).suppressed] == [
        "note"
    ]


def test_unused_suppression() -> None:
    reported = apply_policy([finding()], Policy(), [comment("type-mismatch", "style")], checks=CHECKS)
    assert shown_rows(reported) == [("unused-suppression", "note", 2, "no finding of `style` is here to be suppressed")]
    assert reported.exit_code == 0


def test_suppression_of_an_unknown_check() -> None:
    assert shown_rows(apply_policy([], Policy(), [comment("near-mis")], checks=CHECKS)) == [
        ("unused-suppression", "note", 2, "no check is called `near-mis`, did you mean `near-miss`?")
    ]


def test_suppression_without_check() -> None:
    assert shown_rows(apply_policy([], Policy(), [comment()], checks=CHECKS)) == [
        ("unused-suppression", "note", 2, "the comment names no check: write `rosarch: ignore[check-id] reason`")
    ]


def test_suppression_without_reason_counts_and_is_told() -> None:
    reported = apply_policy([finding()], Policy(), [comment("type-mismatch", reason="")], checks=CHECKS)
    assert shown_rows(reported) == [
        ("suppression-without-reason", "note", 2, "findings of `type-mismatch` are suppressed without a reason")
    ]
    assert len(reported.suppressed) == 1


def test_two_comments_on_one_finding_are_both_used() -> None:
    reported = apply_policy([finding()], Policy(), [comment("type-mismatch", line=1), comment("type-mismatch", line=2)], checks=CHECKS)
    assert reported.shown == ()
    assert [each.suppression.line for each in reported.suppressed] == [1]


def test_findings_about_comments_follow_the_policy() -> None:
    comments = [comment("style", reason="")]
    ignored = Policy(((("unused-suppression", "ignore"), ("suppression-without-reason", "error")),))
    assert [(each[0], each[1]) for each in shown_rows(apply_policy([], ignored, comments, checks=CHECKS))] == [
        ("suppression-without-reason", "error")
    ]
    assert apply_policy([], Policy(ignored_paths=("a.cpp",)), comments, checks=CHECKS).shown == ()


def test_a_comment_on_an_ignored_check_is_not_unused() -> None:
    policy = Policy(((("type-mismatch", "ignore"),),))
    reported = apply_policy([finding()], policy, [comment("type-mismatch")], checks=CHECKS)
    assert (reported.shown, reported.suppressed) == ((), ())


def test_baseline_hides_what_it_knows() -> None:
    old, new = finding(), finding(message="new")
    reported = apply_policy([old, new], Policy(), baseline=Baseline.of([old]), checks=CHECKS)
    assert (reported.shown, reported.in_baseline, reported.gone, reported.compared) == ((new,), (old,), (), True)
    assert apply_policy([old], Policy(), baseline=Baseline.of([old]), checks=CHECKS).exit_code == 0


def test_baseline_survives_shifted_lines_and_other_severities() -> None:
    baseline = Baseline.of([finding()])
    moved = apply_policy([finding(line=300)], Policy(((("*", "note"),),)), baseline=baseline, checks=CHECKS)
    assert (moved.shown, moved.gone) == ((), ())


def test_baseline_counts_equal_findings() -> None:
    lines = [finding(line=line) for line in (3, 9, 20)]
    reported = apply_policy(lines, Policy(), baseline=Baseline.of(lines[:2]), checks=CHECKS)
    assert [each.place.line for each in reported.shown] == [20]
    assert [each.message for each in apply_policy(lines[:1], Policy(), baseline=Baseline.of(lines), checks=CHECKS).gone] == ["m", "m"]


@pytest.mark.parametrize(
    ("policy", "comments"),
    [(Policy(((("type-mismatch", "ignore"),),)), []), (Policy(ignored_paths=("a.cpp",)), []), (Policy(), [comment("type-mismatch")])],
)
def test_what_is_hidden_otherwise_is_not_gone(policy: Policy, comments: list[Suppression]) -> None:
    reported = apply_policy([finding()], policy, comments, Baseline.of([finding()]), checks=CHECKS)
    assert (reported.shown, reported.in_baseline, reported.gone) == ((), (), ())


def test_new_baseline_knows_everything_active() -> None:
    findings = [finding(), finding(message="new"), finding(line=8), finding(STYLE, line=8)]
    comments = [comment("type-mismatch")]
    first = apply_policy(findings, Policy(), comments, Baseline.of(findings[:1]), checks=CHECKS)
    again = apply_policy(findings, Policy(), comments, first.baseline, checks=CHECKS)
    assert (again.shown, again.gone, len(again.in_baseline)) == ((), (), 2)


def test_a_part_of_a_workspace_does_not_tell_what_is_unused_or_gone() -> None:
    comments = [comment("style", reason=""), comment("stile", line=7)]
    reported = apply_policy([], Policy(), comments, Baseline.of([finding()]), checks=CHECKS, complete=False)
    assert [(each[0], each[2]) for each in shown_rows(reported)] == [("suppression-without-reason", 2), ("unused-suppression", 7)]
    assert (reported.gone, reported.compared) == ((), True)


def test_unmatched_patterns() -> None:
    known = identifiers(CHECKS)
    assert known == ["near-miss", "style", "suppression-without-reason", "type-mismatch", "unused-suppression"]
    assert unmatched(["style", "near-*", "x*", "Style", "*"], known) == ["x*", "Style"]


def test_checks_are_those_made_in_order() -> None:
    reported = apply_policy([], Policy(), checks=CHECKS)
    assert [each.id for each in reported.checks] == [
        "near-miss",
        "style",
        "type-mismatch",
        "unused-suppression",
        "suppression-without-reason",
    ]


def test_many_findings_and_comments() -> None:
    findings: list[Finding] = [finding(message=str(number % 100), line=number) for number in range(5000)]
    comments = [comment("type-mismatch", line=number, covers=number + 1) for number in range(0, 5000, 2)]
    reported = apply_policy(findings, Policy(), comments, Baseline.of(findings), checks=CHECKS)
    assert (len(reported.suppressed), len(reported.in_baseline), len(reported.shown)) == (2500, 2500, 0)
