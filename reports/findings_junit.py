"""Findings as JUnit XML, for services that know tests only: a suite for each check, a failed case for each finding that fails the run."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from xml.etree import ElementTree

from rosarch.findings.model import Finding
from rosarch.findings.policy import Policy, Reported
from rosarch.findings.suppressions import Suppressed
from rosarch.reports.findings import Setting
from rosarch.reports.printable import printable
from rosarch.rule_programs.checks import Check


def findings_text(reported: Reported, setting: Setting) -> str:
    """A document of all checks; one without findings is a case that passed."""
    shown: dict[str, list[Finding]] = defaultdict(list)
    suppressed: dict[str, list[Suppressed]] = defaultdict(list)
    for finding in reported.shown:
        shown[finding.check.id].append(finding)
    for each in reported.suppressed:
        suppressed[each.finding.check.id].append(each)
    suites = [_suite(check, shown[check.id], suppressed[check.id], reported.policy, setting) for check in reported.checks]
    root = ElementTree.Element("testsuites", {"name": "rosarch", **_totals(suites)})
    root.extend(suites)
    ElementTree.indent(root)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ElementTree.tostring(root, encoding="unicode")}\n'


def _suite(
    check: Check, shown: Sequence[Finding], suppressed: Sequence[Suppressed], policy: Policy, setting: Setting
) -> ElementTree.Element:
    cases = [_case(finding, setting) for finding in shown]
    for case, finding in zip(cases, shown, strict=True):
        kind = "failure" if policy.fails(finding) else "system-out"
        attributes = {"type": finding.severity, "message": printable(finding.message)} if policy.fails(finding) else {}
        ElementTree.SubElement(case, kind, attributes).text = _details(finding, setting)
    for each in suppressed:
        case = _case(each.finding, setting)
        ElementTree.SubElement(case, "skipped", message=printable(each.suppression.reason) or "suppressed without a reason")
        cases.append(case)
    if not cases:
        cases = [ElementTree.Element("testcase", classname=f"rosarch.{printable(check.id)}", name=printable(check.title))]
    totals = {
        "tests": str(len(cases)),
        "failures": str(sum(1 for case in cases if case.find("failure") is not None)),
        "errors": "0",
        "skipped": str(len(suppressed)),
    }
    suite = ElementTree.Element("testsuite", {"name": f"rosarch.{printable(check.id)}", **totals})
    suite.extend(cases)
    return suite


def _case(finding: Finding, setting: Setting) -> ElementTree.Element:
    """A case whose name stays when lines are shifted, so that services can follow it."""
    path = printable(setting.path(finding.place.path))
    name = f"{path}: {printable(finding.message)}"
    classname = f"rosarch.{printable(finding.check.id)}"
    return ElementTree.Element("testcase", classname=classname, name=name, file=path, line=str(finding.place.line))


def _details(finding: Finding, setting: Setting) -> str:
    """Place, steps and hint, a line each."""
    lines = [f"{setting.line(finding.place)}: {finding.severity}: {printable(finding.message)}"]
    for step in finding.evidence[1:]:
        lines.append(f"  {': '.join(filter(None, (setting.line(step.place), printable(step.text))))}")
    if finding.check.recommendation:
        lines.append(f"  hint: {printable(' '.join(finding.check.recommendation.split()))}")
    return "\n".join(lines)


def _totals(suites: Sequence[ElementTree.Element]) -> dict[str, str]:
    return {key: str(sum(int(suite.get(key, 0)) for suite in suites)) for key in ("tests", "failures", "errors", "skipped")}
