"""Findings as JUnit XML."""

from __future__ import annotations

from xml.etree import ElementTree

from findings_reports import BELOW, EVIL_SETTING, HERE, everything, hostile, nothing, one
from handmade_findings import CHECKS, FULL, STYLE, finding

from rosarch.findings.policy import Policy, apply_policy
from rosarch.reports.findings_junit import findings_text


def suites(reported, setting=HERE) -> dict[str, ElementTree.Element]:
    """The suites by name; their numbers are those of their cases."""
    root = ElementTree.fromstring(findings_text(reported, setting).encode())
    found = {suite.get("name", ""): suite for suite in root}
    counts = {"tests": "testcase", "failures": "testcase/failure", "errors": "testcase/error", "skipped": "testcase/skipped"}
    for attribute, path in counts.items():
        assert [int(suite.get(attribute)) for suite in root] == [len(suite.findall(path)) for suite in root]
        assert int(root.get(attribute)) == sum(int(suite.get(attribute)) for suite in root)
    return found


def test_a_failure() -> None:
    (case,) = suites(one(), BELOW)["rosarch.type-mismatch"]
    assert case.attrib == {
        "classname": "rosarch.type-mismatch",
        "name": f"ws/odom/src/odom.cpp: {FULL.message}",
        "file": "ws/odom/src/odom.cpp",
        "line": "3",
    }
    (failure,) = case
    assert (failure.tag, failure.attrib) == ("failure", {"type": "error", "message": FULL.message})
    assert failure.text == (
        f"ws/odom/src/odom.cpp:3: error: {FULL.message}\n"
        "  ws/base/launch/base.launch:3: remapped\n"
        "  ws/base/src/base.cpp:3: published as Int32\n"
        "  hint: Use one type, or rename one topic."
    )


def test_a_check_without_findings_has_passed() -> None:
    found = suites(nothing())
    assert list(found) == [
        "rosarch.near-miss", "rosarch.style", "rosarch.type-mismatch", "rosarch.unused-suppression", "rosarch.suppression-without-reason",
    ]  # fmt: skip
    assert all([len(case) for case in suite] == [0] for suite in found.values())


def test_only_what_fails_the_run_is_a_failure() -> None:
    def kinds(fail_on: str) -> list[str]:
        reported = apply_policy([finding(STYLE)], Policy(fail_on=fail_on), checks=CHECKS)
        return [part.tag for part in suites(reported)["rosarch.style"].iter()][2:]

    assert (kinds("note"), kinds("warning"), kinds("never")) == (["failure"], ["system-out"], ["system-out"])


def test_suppressed_findings_are_skipped() -> None:
    (case,) = suites(everything())["rosarch.style"]
    assert [(part.tag, part.get("message")) for part in case] == [("skipped", "as agreed")]


def test_a_case_keeps_its_name_when_lines_shift() -> None:
    names = {suites(one(finding(line=line)))["rosarch.type-mismatch"][0].get("name") for line in (3, 30)}
    assert names == {"a.cpp: m"}


def test_hostile_texts_are_valid_xml() -> None:
    found = suites(hostile(), EVIL_SETTING)
    assert found["rosarch.near-miss"].find("testcase/failure").get("message").startswith("a\\n::error::x\\r\\x1b[31m")
