"""Where the findings of `rosarch check` go: to stdout, to files, into a baseline."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rosarch.cli.errors import InputError
from rosarch.cli.inputs import read_input
from rosarch.cli.outputs import write_output
from rosarch.cli.terminal import emit, is_terminal

if TYPE_CHECKING:
    from rosarch.extractor.suppressions import Suppression
    from rosarch.extractor.underlay import Underlay
    from rosarch.findings.baseline import Baseline
    from rosarch.findings.model import Finding
    from rosarch.findings.policy import Policy, Reported
    from rosarch.rule_programs.checks import Check

_ALL = "text, json, sarif, junit, github or markdown"
Formats = Annotated[str, typer.Option("--format", metavar="FORMAT", help=f"The form of the report on stdout: {_ALL}.")]
Outputs = Annotated[
    list[str] | None,
    typer.Option("--output", "-o", metavar="FORMAT=FILE", help="Write a report to a file as well; may be repeated.", show_default=False),
]


@dataclass(frozen=True)
class Destinations:
    """The formats for stdout, and the files with theirs."""

    stdout: tuple[str, ...] = ("text",)
    files: tuple[tuple[str, Path], ...] = ()


def parse_destinations(formats: str, outputs: Sequence[str] | None) -> Destinations:
    """What `--format` and `--output` say: better rejected before a long analysis than after it."""
    from rosarch.reports.findings import LINE_FORMATS

    stdout = tuple(dict.fromkeys(_format(name.strip(), f"--format {formats}") for name in formats.split(",")))
    alone = [name for name in stdout if name not in LINE_FORMATS]
    if alone and len(stdout) > 1:
        raise InputError(f"--format {formats}: {alone[0]} must be alone on stdout; write it to a file with --output {alone[0]}=FILE")
    files = []
    for text in outputs or ():
        name, equals, file = text.partition("=")
        if not (name and equals and file):
            raise InputError(f"--output {text}: not of the form FORMAT=FILE")
        if os.path.isdir(file):
            raise InputError(f"--output {text}: {file} is a folder")
        files.append((_format(name, f"--output {text}"), Path(file)))
    return Destinations(stdout, tuple(files))


def judge(
    findings: Iterable[Finding],
    policy: Policy,
    suppressions: Iterable[Suppression],
    *,
    checks: Iterable[Check],
    baseline: Path | None,
    new_baseline: Path | None,
    complete: bool = True,
) -> Reported:
    """What is reported of `findings`, see `apply_policy`. All of them are known as soon as a new baseline is written."""
    from rosarch.findings.baseline import baseline_text
    from rosarch.findings.policy import apply_policy

    findings, suppressions, checks = tuple(findings), tuple(suppressions), tuple(checks)
    reported = apply_policy(findings, policy, suppressions, _load(baseline), checks=checks, complete=complete)
    if new_baseline is None:
        return reported
    write_output(new_baseline, baseline_text(reported.baseline))
    return apply_policy(findings, policy, suppressions, reported.baseline, checks=checks, complete=complete)


def write_reports(
    reported: Reported,
    destinations: Destinations,
    folder: Path,
    read: Callable[[str], str | None],
    *,
    notes: bool = True,
    scope: str = "",
    underlay: Underlay | None = None,
    rules: Mapping[str, Any] | None = None,
) -> None:
    """Write all reports on the findings of the workspace `folder`; see `Setting` for `read` and for what those for people show."""
    from rosarch.extractor.underlay import NOTHING_INSTALLED
    from rosarch.reports.findings import Setting, report_text

    seen_from = _seen_from_here(folder)
    setting = Setting(read, seen_from, notes=notes, scope=scope, underlay=underlay or NOTHING_INSTALLED, rules=rules or {})
    for name, file in destinations.files:
        write_output(file, report_text(name, reported, setting))
    for name in destinations.stdout:
        emit(report_text(name, reported, replace(setting, terminal=is_terminal())))


def _format(name: str, given: str) -> str:
    from rosarch.base.hints import hint
    from rosarch.reports.findings import FORMATS

    if name not in FORMATS:
        near = hint(name, FORMATS) or f", there are {', '.join(FORMATS)}"
        raise InputError(f"{given}: no format `{name}`{near}")
    return name


def _load(path: Path | None) -> Baseline | None:
    from rosarch.findings.baseline import BaselineError, read_baseline

    try:
        return None if path is None else read_baseline(read_input(path), str(path))
    except BaselineError as error:
        raise InputError(str(error)) from None


def _seen_from_here(folder: Path) -> str:
    """A folder below the current one relative to it, any other from the root: a path that editors and services find."""
    relative = os.path.relpath(folder)
    return os.path.abspath(folder) if relative.startswith("..") else relative
