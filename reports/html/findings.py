"""Findings as the report has them, and the checks that made them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from rosarch.findings.model import Finding
from rosarch.findings.policy import Reported
from rosarch.reports.html.sources import Marks
from rosarch.rule_programs.checks import Check


def findings_data(reported: Reported, read: Callable[[str], str | None]) -> dict[str, Any]:
    """All that is reported, with the checks that are named."""
    marks = Marks(read)
    shown = [_finding(finding, marks) for finding in (*reported.shown, *reported.in_baseline)]
    suppressed = [{**_finding(each.finding, marks), "reason": each.suppression.reason} for each in reported.suppressed]
    named = [*reported.shown, *reported.in_baseline, *(each.finding for each in reported.suppressed)]
    return {"shown": shown, "suppressed": suppressed, "checks": _checks(finding.check for finding in named)}


def _finding(finding: Finding, marks: Marks) -> dict[str, Any]:
    return {
        "id": finding.fingerprint,
        "check": finding.check.id,
        "severity": finding.severity,
        "message": finding.message,
        "systems": list(finding.systems),
        "evidence": [{"text": step.text, "at": str(step.place), "mark": marks.at(step.place)} for step in finding.evidence],
    }


def _checks(checks: Iterable[Check]) -> dict[str, Any]:
    return {
        check.id: {
            "title": check.title,
            "description": check.description,
            "scenario": check.scenario,
            "recommendation": check.recommendation,
        }
        for check in sorted(set(checks), key=lambda check: check.id)
    }
