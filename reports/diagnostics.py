"""What was not understood, summarised by kind."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.library import shown_path
from rosarch.reports.labels import counted
from rosarch.reports.printable import printable

if TYPE_CHECKING:
    from rosarch.base.diagnostics import Diagnostic

SHOWN = 20
SUMMARY = 5


def diagnostics_text(diagnostics: Iterable[Diagnostic], base: Path, *, complete: bool = False) -> str:
    """One line per diagnostic below a line per kind; at most `SHOWN`, every kind represented, unless `complete`."""
    groups: dict[str, list[str]] = {}
    for diagnostic in diagnostics:
        groups.setdefault(diagnostic.kind, []).append(diagnostic_line(diagnostic, base))
    total = sum(map(len, groups.values()))
    if not total:
        return ""
    turns = zip_longest(*([(kind, number) for number in range(len(found))] for kind, found in sorted(groups.items())))
    fair = [entry for turn in turns for entry in turn if entry]
    shown = set(fair if complete else fair[:SHOWN])
    lines = []
    for kind, found in sorted(groups.items()):
        lines.append(f"{kind}: {len(found)}")
        lines += [f"  {text}" for number, text in enumerate(found) if (kind, number) in shown]
    tail = "" if len(shown) == total else f"; {len(shown)} shown, -v shows all"
    lines.append(f"{counted(total, 'diagnostic')}{tail}")
    return "\n".join(lines) + "\n"


def diagnostics_summary(diagnostics: Iterable[Diagnostic], base: Path) -> str:
    """A line for what was not understood the same way, the most frequent first; at most `SUMMARY` lines and how many there are."""
    groups: dict[tuple[str, str], list[Diagnostic]] = {}
    for diagnostic in diagnostics:
        groups.setdefault((diagnostic.kind, diagnostic.message.partition("\n")[0]), []).append(diagnostic)
    if not groups:
        return ""
    lines = []
    for (_, message), found in sorted(groups.items(), key=lambda group: (-len(group[1]), group[0]))[:SUMMARY]:
        lines.append(diagnostic_line(found[0], base) if len(found) == 1 else f"{printable(message)} ({len(found)} places)")
    total = sum(map(len, groups.values()))
    shortened = len(groups) > SUMMARY or total > len(groups)
    return "\n".join([*lines, f"{counted(total, 'diagnostic')}{'; -v shows all' if shortened else ''}"]) + "\n"


def diagnostic_line(diagnostic: Diagnostic, base: Path) -> str:
    """The first line of a diagnostic, with a path relative to `base` when it lies there."""
    first = replace(diagnostic, message=diagnostic.message.partition("\n")[0])
    return printable(shown_path(str(first)).removeprefix(f"{base}/"))
