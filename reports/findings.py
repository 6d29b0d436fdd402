"""What the reports of findings share: the formats there are, and what a writer is given in addition to the findings."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from importlib import import_module
from itertools import groupby
from typing import Any

from rosarch.analysis.systems.check_result import Scope
from rosarch.base.places import Place
from rosarch.extractor.underlay import NOTHING_INSTALLED, Underlay
from rosarch.findings.model import Finding
from rosarch.findings.policy import Reported
from rosarch.findings.withheld import Withheld
from rosarch.library import shown_path
from rosarch.reports.labels import counted, underlay_text
from rosarch.reports.printable import printable
from rosarch.rule_programs.checks import SEVERITIES

FORMATS = ("text", "json", "sarif", "junit", "github", "markdown")
MOST = 5  # systems, and findings at one place, that a report for people names
LINE_FORMATS = ("text", "github")
"""Formats that may follow each other in one stream: nobody parses the whole of it."""


@dataclass(frozen=True)
class Setting:
    """Where a report is read.

    `read` gives the text of a file of the workspace, or None. `folder` is the workspace as seen from where the reader stands, empty when
    that is the workspace itself: people, editors and services find a file by the path that begins there. `notes` says whether people want
    notes, `scope` describes what was checked, `underlay` is what is installed. `rules` describes rules other than those that ship, see
    `described`.
    """

    read: Callable[[str], str | None] = field(default=lambda _path: None)
    folder: str = ""
    terminal: bool = False
    notes: bool = True
    scope: str = ""
    underlay: Underlay = NOTHING_INSTALLED
    rules: Mapping[str, Any] = field(default_factory=dict)

    def path(self, path: str) -> str:
        """The path of a file of the workspace as the reader knows it."""
        if path.startswith("/"):
            return shown_path(path)
        return path if self.folder in ("", ".") else f"{self.folder.rstrip('/')}/{path}"

    def place(self, place: Place) -> str:
        """`path:line:column`, printable, as far as it is known."""
        numbers = [number for number in (place.line, place.column) if number > 0]
        return ":".join([printable(self.path(place.path)), *map(str, numbers)])

    def line(self, place: Place) -> str:
        """`path:line`, as `place`."""
        return self.place(replace(place, column=0))


def report_text(output_format: str, reported: Reported, setting: Setting) -> str:
    """A report in one of `FORMATS`."""
    writer: Callable[[Reported, Setting], str] = import_module(f"rosarch.reports.findings_{output_format}").findings_text
    return writer(reported, setting)


def tool_version() -> str:
    """The version of rosarch that reports name."""
    from importlib.metadata import version

    return version("rosarch")


@dataclass(frozen=True)
class Alike:
    """What a check found at one place: in all likelihood one fault, which several nodes have. The `first` stands for the `others`."""

    first: Finding
    others: tuple[Finding, ...] = ()

    @property
    def systems(self) -> list[str]:
        """The systems that have the fault, as printable text; of many the first ones."""
        return _some([printable(name) for name in dict.fromkeys(name for each in (self.first, *self.others) for name in each.systems)])

    @property
    def messages(self) -> list[str]:
        """What the other findings say, printable; of many the first ones."""
        return _some([printable(finding.message) for finding in self.others])


def alike(findings: Iterable[Finding]) -> Iterator[Alike]:
    """Findings, sorted by place, with those of the same check at the same place together."""
    for _, together in groupby(findings, key=lambda finding: (finding.place, finding.severity, finding.check.id)):
        first, *others = together
        yield Alike(first, tuple(others))


def _some(texts: list[str]) -> list[str]:
    return texts if len(texts) <= MOST else [*texts[: MOST - 1], f"{len(texts) - MOST + 1} more"]


def scope_text(scope: Scope, underlay: Underlay = NOTHING_INSTALLED) -> str:
    """How much was checked, and of how much nothing is known; what it was composed with that is installed."""
    known = f", {scope.unknown} of them without a model" if scope.unknown else ""
    more = f", {scope.open} may have more ports than were seen" if scope.open else ""
    return f"checked {counted(scope.systems, 'system')} with {counted(scope.nodes, 'node')}{known}{more}{underlay_text(underlay)}"


def because(each: Withheld, setting: Setting) -> list[str]:
    """Why a claim was withheld, printable; of many reasons the first ones."""
    return _some(
        [f"{printable(part.node)}{': ' if part.node else ''}{printable(part.reason)} ({setting.line(part.at)})" for part in each.because]
    )


def severity_counts(findings: Iterable[Finding]) -> dict[str, int]:
    """How many findings there are of each severity, the worst first."""
    found = [finding.severity for finding in findings]
    return {severity: found.count(severity) for severity in SEVERITIES}


def summary_line(reported: Reported) -> str:
    """All in one line: `3 findings: 1 error, 2 warnings; 1 suppressed`."""
    counts = [counted(number, severity) for severity, number in severity_counts(reported.shown).items() if number]
    if counts:
        words = [f"{counted(len(reported.shown), 'finding')}: {', '.join(counts)}"]
    else:
        words = ["no new findings" if reported.in_baseline else "no findings"]
    if reported.suppressed:
        words.append(f"{len(reported.suppressed)} suppressed")
    if reported.in_baseline:
        words.append(f"{len(reported.in_baseline)} known from the baseline")
    if reported.gone:
        words.append(f"{len(reported.gone)} of the baseline gone")
    return "; ".join(words)
