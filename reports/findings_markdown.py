"""Findings as Markdown, for a comment on a pull request."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import groupby

from rosarch.findings.fixes import edits_of
from rosarch.findings.policy import Reported
from rosarch.reports.excerpts import Excerpts
from rosarch.reports.findings import Alike, Setting, alike, summary_line
from rosarch.reports.labels import counted
from rosarch.reports.printable import code_span, printable

LONGEST = 60_000  # characters; a comment on GitHub has 65,536 at most


def findings_text(reported: Reported, setting: Setting) -> str:
    """A heading, and by file an item for each finding that unfolds to the evidence; cut where a comment has no more room."""
    excerpts = Excerpts(setting.read)
    parts = [f"### rosarch: {summary_line(reported)}\n"]
    length, left = len(parts[0]), len(reported.shown)
    for path, findings in groupby(reported.shown, key=lambda finding: finding.place.path):
        heading = f"\n#### {code_span(setting.path(path))}\n\n"
        for each in alike(findings):
            text = heading + "\n".join(_finding(each, excerpts, setting)) + "\n"
            if length + len(text) > LONGEST:
                return "".join([*parts, f"\n… and {counted(left, 'more finding')}.\n"])
            parts.append(text)
            length, left, heading = length + len(text), left - 1 - len(each.others), ""
    return "".join(parts)


def _finding(each: Alike, excerpts: Excerpts, setting: Setting) -> Iterator[str]:
    finding = each.first
    line = f"line {finding.place.line}: " if finding.place.line > 0 else ""
    yield f"- **{finding.severity}** {line}{_escape(finding.message)} ({code_span(finding.check.id)})"
    yield "  <details><summary>why, and what to do</summary>"
    yield ""
    for step in finding.evidence:
        text = f": {_escape(step.text)}" if step.text else ""
        yield f"  {code_span(setting.line(step.place))}{text}"
        excerpt = excerpts.at(step.place)
        if excerpt:
            fence = "`" * (1 + max([2, *(len(run) for run in re.findall("`+", excerpt.text))]))
            yield ""
            yield from (f"  {row}" for row in (fence, excerpt.text, excerpt.underline, fence))
        yield ""
    for message in each.messages:
        yield f"  Also: {_escape(message)}"
        yield ""
    for change, *_ in edits_of(finding, setting.read):
        yield f"  **Fix:** {code_span(setting.line(change.place))}: {_escape(str(change))}"
        yield ""
    if finding.check.recommendation:
        yield f"  **Hint:** {_escape(' '.join(finding.check.recommendation.split()))}"
        yield ""
    if each.systems:
        yield f"  In: {', '.join(map(code_span, each.systems))}"
        yield ""
    yield "  </details>"


def _escape(text: str) -> str:
    """Plain text: no markup but code spans, no HTML, no link, nobody mentioned, no issue referred to."""
    parts = re.split(r"(`[^`\n]+`)", printable(text))
    return "".join(part if number % 2 else _plain(part) for number, part in enumerate(parts))


def _plain(text: str) -> str:
    text = re.sub(r"([\\`*_|<>\[\]~&$!])", r"\\\1", text)
    return re.sub(r"[@#]|\bGH-|(?<=http)(?=s?:)|\bwww(?=\.)|(?<=ftp)(?=:)", lambda found: f"{found[0]}<!-- -->", text)
