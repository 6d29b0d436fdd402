"""Findings as SARIF 2.1.0, for code scanning services and editors."""

from __future__ import annotations

import os
import re
from collections import Counter, defaultdict
from collections.abc import Iterable
from textwrap import dedent
from typing import Any
from urllib.parse import quote

from rosarch.base.places import Place
from rosarch.findings.baseline import BaselineEntry
from rosarch.findings.fixes import Edit, edits_of, region_of
from rosarch.findings.model import Change, Evidence, Finding
from rosarch.findings.policy import Reported
from rosarch.findings.suppressions import Suppressed
from rosarch.reports.findings import Setting, tool_version
from rosarch.reports.printable import json_text, printable
from rosarch.rule_programs.checks import Check

SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
ROOT = "%SRCROOT%"
FINGERPRINT = "rosarchFinding/v1"
_PROBLEM = {"error": "error", "warning": "warning", "note": "recommendation"}

_REGION = ("startLine", "startColumn", "endLine", "endColumn")

Json = dict[str, Any]


def findings_text(reported: Reported, setting: Setting) -> str:
    """A log of one run."""
    run = {
        "tool": {"driver": {"name": "rosarch", "semanticVersion": tool_version(), "rules": [_rule(check) for check in reported.checks]}},
        "invocations": [{"executionSuccessful": True}],
        "originalUriBaseIds": {ROOT: {"description": {"text": "The folder that paths begin in: the root of the checkout."}}},
        "columnKind": "unicodeCodePoints",
        "results": _Results(reported, setting).all(),
    }
    return json_text({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]})


class _Results:
    """The results of a run."""

    def __init__(self, reported: Reported, setting: Setting) -> None:
        self.reported = reported
        self.setting = setting
        self.indexes = {check.id: number for number, check in enumerate(reported.checks)}
        self.occurrences: Counter[str] = Counter()

    def all(self) -> list[Json]:
        """Those that are new come first; without a baseline nothing says whether one is new."""
        compared = self.reported.compared
        return [
            *(self._result(finding, {"baselineState": "new"} if compared else {}) for finding in self.reported.shown),
            *(self._result(finding, {"baselineState": "unchanged"}) for finding in self.reported.in_baseline),
            *(self._suppressed(each, {"baselineState": "unchanged"} if compared else {}) for each in self.reported.suppressed),
            *map(self._gone, self.reported.gone),
        ]

    def _result(self, finding: Finding, more: Json) -> Json:
        """One result; steps beyond the place of the fault make it a path through the source."""
        self.occurrences[finding.fingerprint] += 1
        result = {
            **self._head(finding.check.id, finding.message),
            "level": finding.severity,
            "locations": [self._location(finding.evidence[0])],
            "partialFingerprints": {FINGERPRINT: f"{finding.fingerprint}:{self.occurrences[finding.fingerprint]}"},
            **more,
        }
        if len(finding.evidence) > 1:
            steps = [{"location": self._location(step)} for step in finding.evidence]
            result["codeFlows"] = [{"threadFlows": [{"locations": steps}]}]
            result["relatedLocations"] = [{"id": number, **self._location(step)} for number, step in enumerate(finding.evidence[1:], 1)]
        edits = edits_of(finding, self.setting.read)
        if edits:
            result["fixes"] = [self._fix(edits)]
        if finding.systems:
            result["properties"] = {"systems": [printable(system) for system in finding.systems]}
        return result

    def _fix(self, edits: Iterable[tuple[Change, str, Edit]]) -> Json:
        """What is to be replaced, by files."""
        replacements: dict[str, list[Json]] = defaultdict(list)
        for change, text, edit in edits:
            region = dict(zip(_REGION, region_of(text, edit), strict=True))
            replacements[change.place.path].append({"deletedRegion": region, "insertedContent": {"text": edit.text}})
        return {
            "description": {"text": _message("; ".join(str(change) for change, *_ in edits))},
            "artifactChanges": [
                {"artifactLocation": _artifact(self.setting, path), "replacements": found} for path, found in replacements.items()
            ],
        }

    def _suppressed(self, each: Suppressed, more: Json) -> Json:
        comment = each.suppression
        suppression: Json = {
            "kind": "inSource",
            "status": "accepted",
            "location": self._location(Evidence("", Place(comment.path, comment.line, comment.column))),
        }
        if comment.reason:
            suppression["justification"] = printable(comment.reason)
        return self._result(each.finding, {"suppressions": [suppression], **more})

    def _gone(self, entry: BaselineEntry) -> Json:
        self.occurrences[entry.fingerprint] += 1
        return {
            **self._head(entry.check, entry.message),
            "locations": [self._location(Evidence("", Place(entry.file, 0, 0)))],
            "partialFingerprints": {FINGERPRINT: f"{entry.fingerprint}:{self.occurrences[entry.fingerprint]}"},
            "baselineState": "absent",
        }

    def _head(self, check: str, message: str) -> Json:
        index = {"ruleIndex": self.indexes[check]} if check in self.indexes else {}  # a check of the baseline may be gone
        return {"ruleId": check, **index, "message": {"text": _message(message)}}

    def _location(self, step: Evidence) -> Json:
        place: Json = {"artifactLocation": _artifact(self.setting, step.place.path)}
        if step.place.line > 0:
            place["region"] = {"startLine": step.place.line, **({"startColumn": step.place.column} if step.place.column > 0 else {})}
        return {"physicalLocation": place, **({"message": {"text": _message(step.text)}} if step.text else {})}


def _rule(check: Check) -> Json:
    return {
        "id": check.id,
        "name": "".join(word.capitalize() for word in check.id.split("-")),
        "shortDescription": {"text": _message(check.title)},
        "fullDescription": {"text": _message(check.help)},
        "help": {"text": _help(check), "markdown": _help_markdown(check)},
        "defaultConfiguration": {"level": check.severity},
        "properties": {
            "tags": ["ros", "architecture"],
            "precision": check.confidence,
            "impact": check.impact,
            "problem.severity": _PROBLEM[check.severity],
        },
    }


def _help(check: Check) -> str:
    """The help. Its braces stay single, unlike those of messages: services show help as it is."""
    parts = (check.help, check.description, f"Example:\n{check.scenario}" if check.scenario else "", check.recommendation)
    return "\n\n".join(filter(None, parts))


def _help_markdown(check: Check) -> str:
    """The help with the bad code in a block of its own."""
    scenario = dedent(check.scenario).strip("\n")
    fence = "`" * max(3, 1 + max((len(run) for run in re.findall("`+", check.scenario)), default=0))
    parts = (
        check.help,
        check.description,
        f"**Example**\n\n{fence}\n{scenario}\n{fence}" if check.scenario else "",
        f"**What to do**\n\n{check.recommendation}" if check.recommendation else "",
    )
    return "\n\n".join(filter(None, parts))


def _message(text: str) -> str:
    """A plain text message: nothing in it is a placeholder (3.11.5 of the standard) or a link (3.11.6)."""
    linkless = re.sub(r"\[(?=[^\]]*\]\()", r"\\[", printable(text))
    return linkless.replace("{", "{{").replace("}", "}}")


def _artifact(setting: Setting, path: str) -> Json:
    """A file below the root by a relative reference, any other by its URI."""
    text = quote(os.fsencode(path if path.startswith("/") else setting.path(path)), safe="/~")
    return {"uri": f"file://{text}"} if path.startswith("/") else {"uri": text, "uriBaseId": ROOT}
