"""From the rows of checks to findings."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from rosarch.base.places import Place
from rosarch.datalog import Result
from rosarch.findings.model import Change, Evidence, Finding
from rosarch.models.system.rows import grouped
from rosarch.rule_programs.checks import CHANGE, Check, evidence_of, shown_as

_STARTED = "Start"
"""The type of columns that show where nodes are started."""
_NODES = (_STARTED, "NodePort")
"""The types of columns that messages show as the name of a node."""


def _nowhere(_path: str) -> bool:
    return False


def findings(
    checks: Sequence[Check], result: Result, places: Mapping[str, Place], system: str, is_installed: Callable[[str], bool] = _nowhere
) -> list[Finding]:
    """What the checks found in a system; `places` are those of the facts, by key.

    What is in installed files alone is left out: who reads about it cannot change them.
    """
    return [finding for _, finding in findings_with_rows(checks, result, places, system, is_installed)]


def findings_with_rows(
    checks: Sequence[Check], result: Result, places: Mapping[str, Place], system: str, is_installed: Callable[[str], bool] = _nowhere
) -> Iterator[tuple[tuple[Any, ...], Finding]]:
    """The same, each with the row of its check."""
    known = set(result.names())
    steps = {type_: grouped(result.rows(evidence_of(type_))) for type_ in _types(checks) if evidence_of(type_) in known}
    names: dict[str, dict[Any, str]] = {type_: dict(result.rows(shown_as(type_))) for type_ in _types(checks) if shown_as(type_) in known}
    for check in checks:
        fixes = _fixes(check, result)
        for row in result.rows(check.relation):
            texts = {}
            shown: list[tuple[str, list[Evidence]]] = []
            for (column, type_), value in zip(check.columns, row, strict=True):
                texts[column] = str(names[type_].get(value, value)) if type_ in names else str(value)
            entities = dict(zip((name for name, _ in check.columns), row, strict=True))
            for column, own in check.evidence:
                type_ = dict(check.columns)[column]
                found = steps[type_].get(entities[column], [])
                part = [Evidence(own.format(**texts) if own and step == 0 else text, places[place]) for step, text, place in found]
                shown += [(type_, part)] if part else []
            evidence = _workspace_first(shown, is_installed)
            if evidence:
                message = check.message.format(**texts)
                key = tuple(entities[column] for column in check.fix_columns[: -len(CHANGE)])
                changes = sorted(Change(places[at], written, meant) for at, written, meant in fixes.get(key, ()))
                shown_once = tuple(dict.fromkeys(evidence))
                about = _about(check, texts)
                yield row, Finding(check, check.severity, message, shown_once, (system,), tuple(changes), *about)


def _about(check: Check, texts: Mapping[str, str]) -> tuple[str, str]:
    """The node that a finding is about, and its message without that name; nothing when there are several, or none."""
    nodes = [column for column, type_ in check.columns if type_ in _NODES]
    return (texts[nodes[0]], check.message.format(**{**texts, nodes[0]: ""})) if len(nodes) == 1 else ("", "")


def _fixes(check: Check, result: Result) -> Mapping[tuple[Any, ...], list[tuple[Any, ...]]]:
    """How findings of a check are to be fixed, by the values of the columns that its rows share with those of the check."""
    rows: dict[tuple[Any, ...], list[tuple[Any, ...]]] = defaultdict(list)
    for row in result.rows(check.fix_relation) if check.fix_columns else ():
        rows[row[: -len(CHANGE)]].append(row[-len(CHANGE) :])
    return rows


def _workspace_first(shown: list[tuple[str, list[Evidence]]], is_installed: Callable[[str], bool]) -> list[Evidence]:
    """All that is shown of the parts of a finding, first of one that is in the workspace; nothing when there is none.

    Where a finding begins in an installed file, that the workspace starts the node is no part of its own.
    """
    inside = [not is_installed(part[0].place.path) for _, part in shown]
    own = [number for number, (type_, _) in enumerate(shown) if inside[number] and (inside[0] or type_ != _STARTED)]
    order = [*own[:1], *(number for number in range(len(shown)) if number not in own[:1])] if own else []
    return [each for number in order for each in shown[number][1]]


def _types(checks: Sequence[Check]) -> set[str]:
    return {type_ for check in checks for _, type_ in check.columns}
