"""From the rows of checks to findings."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import Any

from rosarch.datalog import Result
from rosarch.models.checks import CheckError
from rosarch.models.findings import Check, Evidence, Finding
from rosarch.models.places import Place

_WORD = re.compile(r"(?<=[a-z0-9])(?=[A-Z])")


def evidence_of(type_: str) -> str:
    """The relation that tells where things of a column's type lie: `evidence_of_node_port` of `NodePort`."""
    return f"evidence_of_{_snake(type_)}"


def shown_as(type_: str) -> str:
    """The relation that tells how messages call things of a column's type."""
    return f"shown_as_{_snake(type_)}"


def _snake(type_: str) -> str:
    return _WORD.sub("_", type_).lower()


def require_places(checks: Iterable[Check], relations: Collection[str]) -> None:
    """Refuse a check whose findings would have no place.

    Raises:
        CheckError: `relations` do not tell where a column that a check shows lies.
    """
    for check in checks:
        for column, _ in check.evidence:
            relation = evidence_of(dict(check.columns)[column])
            if relation not in relations:
                raise CheckError(f"{check.path}:1:1: no relation `{relation}` tells the place of the column `{column}`")


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


def grouped(rows: Iterable[tuple[Any, ...]]) -> dict[Any, list[tuple[Any, ...]]]:
    """The rest of each row by its first column, sorted."""
    found: dict[Any, list[tuple[Any, ...]]] = defaultdict(list)
    for first, *rest in sorted(rows, key=lambda row: row[1:]):
        found[first].append(tuple(rest))
    return found
