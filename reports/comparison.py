"""What is different between two states of a workspace: as text, for Markdown, as JSON."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from importlib.resources import files
from itertools import groupby
from types import MappingProxyType
from typing import Any

from rosarch.analysis.comparison.changes import HOW, Change, Detail
from rosarch.reports.labels import counted
from rosarch.reports.printable import json_text, printable

_MARKS = MappingProxyType({"lost": "-", "gained": "+", "renamed": ">", "changed": "~"})
WIDEST = 50  # of a column; what is wider pushes the rest of its line
_SAME = "no differences"


def changes_text(changes: Sequence[Change]) -> str:
    """A paragraph for each component and system, a line for each difference."""
    lines: list[str] = []
    for where, group in _by_place(changes):
        rows = [(f"{_MARKS[c.how]} {c.subject}", printable(c.title), _details(c), _source(c)) for c in group]
        widths = [min(WIDEST, max(len(row[column]) for row in rows)) for column in range(2)]
        lines.append(printable(where))
        for subject, title, details, source in rows:
            cells = [f"  {subject:{widths[0]}}", f"{title:{widths[1]}}", *(cell for cell in (details, source) if cell)]
            lines.append("  ".join(cells).rstrip())
        lines.append("")
    return "".join(f"{line}\n" for line in (*lines, _summary(changes)))


def changes_markdown(changes: Sequence[Change]) -> str:
    """A table for each component and system."""
    lines: list[str] = []
    for where, group in _by_place(changes):
        lines += [f"## {_markdown(where)}", "", "| | what | | details | source |", "|---|---|---|---|---|"]
        for change in group:
            cells = (change.how, change.subject, change.title, _details(change), _source(change))
            lines.append("| " + " | ".join(_markdown(cell) for cell in cells) + " |")
        lines.append("")
    return "".join(f"{line}\n" for line in (*lines, f"{_summary(changes)[0].upper()}{_summary(changes)[1:]}."))


def changes_json(changes: Sequence[Change]) -> str:
    """All differences, with how many there are."""
    count = Counter(change.how for change in changes)
    data = {"summary": {how: count[how] for how in HOW}, "changes": [_data(change) for change in changes]}
    return json_text(data)


def changes_schema() -> Any:
    """The JSON Schema of the differences."""
    return json.loads(files("rosarch.reports").joinpath("schema/diff.schema.json").read_text(encoding="utf-8"))


def _by_place(changes: Iterable[Change]) -> Iterator[tuple[str, list[Change]]]:
    for where, group in groupby(changes, key=lambda change: change.where):
        yield where, list(group)


def _details(change: Change) -> str:
    return ", ".join(_detail(change.how, detail) for detail in change.details)


def _detail(how: str, detail: Detail) -> str:
    if how in ("lost", "gained"):
        return printable(f"{detail.name} {detail.old or detail.new}")
    return printable(f"{detail.name} {_value(detail.old)} -> {_value(detail.new)}")


def _value(value: str | None) -> str:
    return "none" if value is None else value or '""'


def _source(change: Change) -> str:
    place = change.new_at or change.old_at
    return printable(str(place)) if place else ""


def _summary(changes: Sequence[Change]) -> str:
    if not changes:
        return _SAME
    count = Counter(change.how for change in changes)
    parts = [f"{count[how]} {how}" for how in HOW if count[how]]
    return f"{counted(len(changes), 'difference')}: {', '.join(parts)}"


def _markdown(text: str) -> str:
    """Text that stays what it is in a cell of a table."""
    return re.sub(r"[|`*_\\\[\]]", r"\\\g<0>", printable(text)).replace("<", "&lt;")


def _data(change: Change) -> dict[str, Any]:
    return {
        "subject": change.subject,
        "where": change.where,
        "how": change.how,
        "title": change.title,
        "details": [vars(detail) for detail in change.details],
        "old_at": None if change.old_at is None else str(change.old_at),
        "new_at": None if change.new_at is None else str(change.new_at),
    }
