"""What came of each workspace of a corpus: a table and JSON."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from rosarch.evaluation.corpus.task import Done, Failed
from rosarch.reports.labels import counted
from rosarch.reports.printable import json_text, printable
from rosarch.reports.tables import Table, table_markdown, table_text
from rosarch.rule_programs.checks import SEVERITIES


def summary(name: str, folder: str, outcome: Done | Failed) -> dict[str, Any]:
    """A workspace in figures, or why it has none."""
    head = {"workspace": name, "folder": folder}
    if isinstance(outcome, Failed):
        return {**head, "failed": outcome.reason}
    found: dict[str, Any] = {**head, "seconds": outcome.seconds, "components": len(outcome.reports["models"])}
    found["ports"] = sum(len(model["ports"]) for model in outcome.reports["models"])
    if "findings" in outcome.reports:
        findings = outcome.reports["findings"]["findings"]
        found.update({severity: sum(finding["severity"] == severity for finding in findings) for severity in SEVERITIES})
    return found


def _text(summaries: Sequence[Mapping[str, Any]], table: Callable[[Table], str]) -> str:
    """A row for each workspace, then those that failed."""
    keys = ("components", "ports", *SEVERITIES, "seconds")
    good = [each for each in summaries if "failed" not in each]
    failed = [printable(f"{each['workspace']}: {each['failed']}") for each in summaries if "failed" in each]
    rows = tuple((printable(each["workspace"]), *(each.get(key) for key in keys)) for each in good)
    shown = table(Table("Workspaces", ("workspace", "components", "ports", *(f"{s}s" for s in SEVERITIES), "seconds"), rows))
    return "\n".join([shown, *failed, *([""] if failed else []), f"{counted(len(summaries), 'workspace')}, {len(failed)} failed"]) + "\n"


Outcomes = Mapping[str, tuple[str, Done | Failed]]
"""Folder and outcome of workspaces by name."""
WRITERS: Mapping[str, Callable[[Outcomes], str]] = {
    "json": lambda outcomes: json_text(_summaries(outcomes)),
    "table": lambda outcomes: _text(_summaries(outcomes), table_text),
    "markdown": lambda outcomes: _text(_summaries(outcomes), table_markdown),
}


def _summaries(outcomes: Outcomes) -> list[dict[str, Any]]:
    return [summary(name, *outcomes[name]) for name in sorted(outcomes)]
