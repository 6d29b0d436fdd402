"""Findings for people: each with its source line, the steps that lead to it, and what to change.

What repeats is said once: what a check finds at one place for several nodes, the source line of findings that share it, and the hint of a
check. Notes, which are many and matter little, are only counted unless they are asked for or make the run fail.
"""

from __future__ import annotations

import io
from collections.abc import Iterator
from itertools import groupby

from rich.text import Text

from rosarch.findings.fixes import edits_of
from rosarch.findings.model import Evidence, added
from rosarch.findings.policy import Reported
from rosarch.reports.excerpts import Excerpts
from rosarch.reports.findings import Alike, Setting, alike, because, summary_line
from rosarch.reports.printable import printable

_STYLES = {"error": "bold red", "warning": "bold yellow", "note": "bold cyan"}


def findings_text(reported: Reported, setting: Setting) -> str:
    """A paragraph for each finding, by file and line, and a summary."""
    excerpts = Excerpts(setting.read)
    told = [finding for finding in reported.shown if setting.notes or finding.severity != "note" or reported.policy.fails(finding)]
    lines: list[Text] = []
    hinted: set[str] = set()
    before = None
    for each in alike(told):
        place, check = setting.line(each.first.place), each.first.check.id
        lines += [*_finding(each, excerpts, setting, excerpted=place != before, hint=check not in hinted), Text()]
        hinted.add(check)
        before = place
    lines += _withheld(reported, setting)
    worst = min((finding.severity for finding in reported.shown), key=list(_STYLES).index, default="")
    hidden = "; -v shows the notes" if len(told) < len(reported.shown) else ""
    lines.append(Text(f"{summary_line(reported)}{hidden}", style=_STYLES.get(worst, "bold green")))
    if setting.scope:
        lines.append(Text(setting.scope))
    if not setting.terminal:
        return "".join(f"{line.plain.rstrip()}\n" for line in lines)
    from rich.console import Console

    buffer = io.StringIO()
    console = Console(file=buffer, force_terminal=True, highlight=False)
    console.print(Text("\n").join(lines), soft_wrap=True)
    return buffer.getvalue()


def _withheld(reported: Reported, setting: Setting) -> Iterator[Text]:
    """What would be findings if there were no more than was seen, each with what was not."""
    for each in reported.withheld or ():
        finding = each.finding
        yield Text.assemble(
            (f"{setting.place(finding.place)}: ", "bold"),
            ("withheld: ", "bold"),
            printable(finding.message),
            (f"  [{finding.check.id}]", "dim"),
        )
        for reason in because(each, setting):
            yield Text.assemble("  ", ("not seen: ", "bold"), reason)
        yield Text()


def _finding(each: Alike, excerpts: Excerpts, setting: Setting, *, excerpted: bool, hint: bool) -> Iterator[Text]:
    """Headline, excerpt, the other steps with theirs, other findings at the place, fix, hint, and the systems that have it."""
    finding = each.first
    width = max(len(str(step.place.line)) for step in finding.evidence)
    yield Text.assemble(
        (f"{setting.place(finding.place)}: ", "bold"),
        (f"{finding.severity}: ", _STYLES[finding.severity]),
        printable(finding.message),
        (f"  [{printable(finding.check.id)}]", "dim"),
    )
    shown = set() if excerpted else {(finding.place.path, finding.place.line)}
    for number, step in enumerate(finding.evidence):
        if number:
            text = f": {printable(step.text)}" if step.text else ""
            yield Text.assemble("  ", (setting.line(step.place), "bold"), text)
        if (step.place.path, step.place.line) not in shown:
            yield from _excerpt(step, excerpts, width, finding.severity, labelled=not number)
            shown.add((step.place.path, step.place.line))
    for message in each.messages:
        yield Text.assemble("  ", ("also: ", "bold"), message)
    edits = [change for change, *_ in dict.fromkeys(part for found in (each.first, *each.others) for part in edits_of(found, setting.read))]
    for line, changes in groupby(edits, key=lambda change: None if change.written else setting.line(change.place)):
        if line is None:
            yield from (Text.assemble("  ", ("fix: ", "bold"), f"{setting.line(one.place)}: {printable(str(one))}") for one in changes)
        else:
            yield Text.assemble("  ", ("fix: ", "bold"), f"{line}: {printable(added([one.meant for one in changes]))}")
    if finding.check.recommendation and hint:
        yield Text.assemble("  ", ("hint: ", "bold"), printable(" ".join(finding.check.recommendation.split())))
    if each.systems:
        yield Text.assemble("  ", ("in: ", "bold"), ", ".join(each.systems))


def _excerpt(step: Evidence, excerpts: Excerpts, width: int, severity: str, *, labelled: bool) -> Iterator[Text]:
    """The source line of a step, what is meant underlined; with `labelled`, the step's text follows the underline."""
    excerpt = excerpts.at(step.place)
    label = f" {printable(step.text)}" if labelled and step.text else ""
    if excerpt is None:
        if label:
            yield Text(f" {label}")
        return
    yield Text.assemble((f"  {step.place.line:>{width}} | ", "dim"), excerpt.text)
    yield Text.assemble((f"  {'':{width}} | ", "dim"), (f"{excerpt.underline}{label}", _STYLES[severity] if labelled else "dim"))
