"""Findings as one JSON document, for programs; its schema is `schema/findings.schema.json`."""

from __future__ import annotations

import json
from importlib.resources import files
from typing import Any

from rosarch.base.places import Place
from rosarch.findings.fixes import edits_of, region_of
from rosarch.findings.model import Finding
from rosarch.findings.policy import Reported
from rosarch.findings.withheld import Withheld
from rosarch.library import shown_path
from rosarch.reports.findings import Setting, severity_counts, tool_version
from rosarch.reports.printable import json_text


def findings_text(reported: Reported, setting: Setting) -> str:
    """The document. Its paths are relative to the workspace, `folder` says where that is."""
    rules: dict[str, Any] = {"rules": setting.rules} if setting.rules else {}
    data: dict[str, Any] = {
        "rosarch": tool_version(),
        "folder": setting.folder or ".",
        **rules,
        **_underlay(setting),
        "findings": [{**_finding(finding), **_fix(finding, setting)} for finding in reported.shown],
        "suppressed": [
            {**_finding(each.finding), "reason": each.suppression.reason, "comment_line": each.suppression.line}
            for each in reported.suppressed
        ],
        "known": [_finding(finding) for finding in reported.in_baseline],
        "gone": [
            {"check": entry.check, "message": entry.message, "file": entry.file, "fingerprint": entry.fingerprint}
            for entry in reported.gone
        ],
        **({} if reported.withheld is None else {"withheld": [_withheld(each) for each in reported.withheld]}),
        "summary": {**severity_counts(reported.shown), "compared": reported.compared, "failed": reported.failed},
    }
    return json_text(data)


def findings_schema() -> Any:
    """The JSON Schema of the document."""
    return json.loads(files("rosarch.reports").joinpath("schema/findings.schema.json").read_text(encoding="utf-8"))


def _underlay(setting: Setting) -> dict[str, Any]:
    prefixes = setting.underlay.prefixes
    return {"underlay": {"prefixes": list(prefixes), "packages": setting.underlay.count}} if prefixes else {}


def _finding(finding: Finding) -> dict[str, Any]:
    return {
        "check": finding.check.id,
        "severity": finding.severity,
        "confidence": finding.check.confidence,
        "message": finding.message,
        **_place(finding.place),
        "evidence": [{"text": step.text, **_place(step.place)} for step in finding.evidence],
        "hint": finding.check.recommendation,
        "systems": list(finding.systems),
        "fingerprint": finding.fingerprint,
    }


def _fix(finding: Finding, setting: Setting) -> dict[str, Any]:
    """The regions that are to be replaced, where the fix is certain."""
    edits = edits_of(finding, setting.read)
    names = ("line", "column", "end_line", "end_column")
    replaced = [
        {"file": change.place.path, **dict(zip(names, region_of(text, edit), strict=True)), "text": edit.text}
        for change, text, edit in edits
    ]
    description = "; ".join(str(change) for change, *_ in edits)
    return {"fix": {"description": description, "replacements": replaced}} if edits else {}


def _withheld(each: Withheld) -> dict[str, Any]:
    because = [{"node": part.node or None, "reason": part.reason, **_place(part.at)} for part in each.because]
    return {**_finding(each.finding), "because": because}


def _place(place: Place) -> dict[str, Any]:
    return {"file": shown_path(place.path), "line": place.line, "column": place.column}
