"""Findings as commands of GitHub workflows, which become annotations beside the changed lines."""

from __future__ import annotations

from rosarch.findings.model import Finding
from rosarch.findings.policy import Reported
from rosarch.reports.findings import Setting
from rosarch.reports.printable import printable

_COMMANDS = {"error": "error", "warning": "warning", "note": "notice"}


def findings_text(reported: Reported, setting: Setting) -> str:
    """A command for each finding, on a line of its own."""
    return "".join(f"{_command(finding, setting)}\n" for finding in reported.shown)


def _command(finding: Finding, setting: Setting) -> str:
    place = finding.place
    properties = {
        "file": setting.path(place.path),
        "line": place.line,
        "col": place.column,
        "title": f"{finding.check.title} ({finding.check.id})",
    }
    named = ",".join(f"{key}={_property(str(value))}" for key, value in properties.items() if value)
    lines = [printable(finding.message)]
    for step in finding.evidence[1:]:
        lines.append(": ".join(filter(None, (setting.line(step.place), printable(step.text)))))
    if finding.check.recommendation:
        lines.append(f"hint: {printable(' '.join(finding.check.recommendation.split()))}")
    return f"::{_COMMANDS[finding.severity]} {named}::{_escape(chr(10).join(lines))}"


def _property(text: str) -> str:
    return _escape(printable(text)).replace(":", "%3A").replace(",", "%2C")


def _escape(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")
