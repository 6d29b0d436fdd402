"""From the rows of checks to findings."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from rosarch.base.places import Place
from rosarch.datalog import Result
from rosarch.findings.model import Evidence, Finding
from rosarch.models.system.rows import grouped
from rosarch.rule_programs.checks import Check, evidence_of, shown_as


def findings(checks: Sequence[Check], result: Result, places: Mapping[str, Place], system: str) -> list[Finding]:
    """What the checks found in a system; `places` are those of the facts, by key."""
    return [finding for _, finding in findings_with_rows(checks, result, places, system)]


def findings_with_rows(
    checks: Sequence[Check], result: Result, places: Mapping[str, Place], system: str
) -> Iterator[tuple[tuple[Any, ...], Finding]]:
    """The same, each with the row of its check."""
    known = set(result.names())
    steps = {type_: grouped(result.rows(evidence_of(type_))) for type_ in _types(checks) if evidence_of(type_) in known}
    names: dict[str, dict[Any, str]] = {type_: dict(result.rows(shown_as(type_))) for type_ in _types(checks) if shown_as(type_) in known}
    for check in checks:
        for row in result.rows(check.relation):
            texts = {}
            evidence = []
            for (column, type_), value in zip(check.columns, row, strict=True):
                texts[column] = str(names[type_].get(value, value)) if type_ in names else str(value)
            entities = dict(zip((name for name, _ in check.columns), row, strict=True))
            for column, own in check.evidence:
                for step, text, place in steps[dict(check.columns)[column]].get(entities[column], []):
                    evidence.append(Evidence(own.format(**texts) if own and step == 0 else text, places[place]))
            if evidence:
                message = check.message.format(**texts)
                yield row, Finding(check, check.severity, message, tuple(dict.fromkeys(evidence)), (system,))


def _types(checks: Sequence[Check]) -> set[str]:
    return {type_ for check in checks for _, type_ in check.columns}
