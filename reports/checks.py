"""The checks that exist, as a list, explained one by one, and as the reference in `docs/`."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from textwrap import dedent, fill

from rosarch.reports.labels import counted
from rosarch.reports.printable import printable
from rosarch.rule_programs.checks import SEVERITIES, Check

_WIDTH = 120
_HEAD = """# Reference of checks

[Checking a workspace](checks.md) explains how findings are reported. This page is what `rosarch rules checks --format markdown`
prints: it is made from the heads of the files in `rules/checks/`.
"""


def list_text(checks: Sequence[Check]) -> str:
    """A line for each check, the severest first, and how many there are."""
    order = sorted(checks, key=lambda check: (SEVERITIES.index(check.severity), check.id))
    width = max((len(check.id) for check in order), default=0)
    counts = [(severity, sum(check.severity == severity for check in order)) for severity in SEVERITIES]
    lines = [printable(f"{check.severity:7}  {check.id:{width}}  {check.title}") for check in order]
    return "\n".join([*lines, f"{counted(len(order), 'check')}: {', '.join(counted(n, word) for word, n in counts if n)}"]) + "\n"


def explanation_text(checks: Iterable[Check], shorten: Callable[[str], str]) -> str:
    """All that the block of fields of each check says, and where its rules are; `shorten` makes their path one to show."""
    return "\n".join("".join(f"{printable(line).rstrip()}\n" for line in _explained(check, shorten)) for check in checks)


def sections_markdown(checks: Iterable[Check]) -> str:
    """The same as Markdown, a section for each check."""
    return "\n".join("\n".join(_section(check)) + "\n" for check in checks)


def reference_markdown(checks: Sequence[Check]) -> str:
    """The reference of all checks, with a table of what there is."""
    rows = [f"| [{check.id}](#{check.id}) | {check.severity} | {check.title} |" for check in checks]
    return "\n".join([_HEAD, "| check | severity | finds |", "|---|---|---|", *rows, "", sections_markdown(checks)])


def _explained(check: Check, shorten: Callable[[str], str]) -> Iterator[str]:
    yield f"{check.id}  {check.severity} (impact {check.impact}, confidence {check.confidence})"
    yield check.title
    yield ""
    for text in (check.help, check.description):
        yield from fill(" ".join(text.split()), _WIDTH, break_on_hyphens=False, break_long_words=False).splitlines()
    yield ""
    yield "for example:"
    yield from (f"  {line}" for line in _code(check))
    yield ""
    yield from fill(f"what to do: {' '.join(check.recommendation.split())}", _WIDTH, subsequent_indent="  ").splitlines()
    if check.path:
        yield f"rules: {shorten(check.path)}"


def _section(check: Check) -> Iterator[str]:
    yield f"## {check.id}"
    yield ""
    yield f"{check.title}. *{check.severity.capitalize()}*: impact {check.impact}, confidence {check.confidence}."
    yield ""
    yield f"{check.help} {' '.join(check.description.split())}"
    yield ""
    fence = "````" if "```" in check.scenario else "```"
    yield from (fence, *_code(check), fence, "")
    yield f"What to do: {' '.join(check.recommendation.split())}"


def _code(check: Check) -> list[str]:
    return dedent(check.scenario).strip("\n").splitlines()
