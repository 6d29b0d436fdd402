"""The options of `rosarch check` on what becomes of findings, and the policy they make together with the configuration file."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.errors import InputError
from rosarch.cli.inputs import read_input
from rosarch.cli.options import path_argument

if TYPE_CHECKING:
    from rosarch.findings.configuration import Configuration
    from rosarch.findings.policy import Policy, Severities
    from rosarch.rule_programs.checks import Check


class FailOn(str, Enum):
    """The least severity that makes the exit code 1."""

    error = "error"
    warning = "warning"
    note = "note"
    never = "never"


_IDS = "the check ID, `*` and `?` are wildcards; may be repeated."
Errors = Annotated[list[str] | None, typer.Option("--error", metavar="ID", help=f"Report as an error {_IDS}", show_default=False)]
Warnings = Annotated[list[str] | None, typer.Option("--warning", metavar="ID", help=f"Report as a warning {_IDS}", show_default=False)]
Notes = Annotated[list[str] | None, typer.Option("--note", metavar="ID", help=f"Report as a note {_IDS}", show_default=False)]
Ignored = Annotated[list[str] | None, typer.Option("--ignore", metavar="ID", help=f"Do not report {_IDS}", show_default=False)]
Failing = Annotated[
    FailOn | None, typer.Option("--fail-on", help="The least severity that makes the exit code 1; warning by default.", show_default=False)
]
ExitZero = Annotated[bool, typer.Option("--exit-zero", help="Exit with 0 whatever the findings.")]
ConfigFile = Annotated[
    Path | None,
    typer.Option(
        "--config", parser=path_argument, metavar="FILE", help="The configuration; DIR/.rosarch.yml by default.", show_default=False
    ),
]
BaselineFile = Annotated[
    Path | None,
    typer.Option(
        "--baseline", parser=path_argument, metavar="FILE", help="Report only findings that are not in this baseline.", show_default=False
    ),
]
NewBaseline = Annotated[
    Path | None,
    typer.Option("--write-baseline", parser=path_argument, metavar="FILE", help="Write the findings as a baseline.", show_default=False),
]
ShowWithheld = Annotated[
    bool,
    typer.Option("--withheld", help="Also show findings withheld because something was not seen, and what that was. Never fails the run."),
]
Talkative = Annotated[bool, typer.Option("--verbose", "-v", help="Show notes in the text report, and every diagnostic.")]


def load_configuration(folder: Path, file: Path | None, checks: Iterable[Check]) -> Configuration:
    """The configuration in `file`, or of a workspace, with paths relative to the current folder; an empty one when there is none."""
    from rosarch.findings.configuration import NAME, Configuration

    path = file or folder / NAME
    if file is None and not os.path.exists(path):
        return Configuration()
    from rosarch.findings.configuration_reader import ConfigurationError, read_configuration
    from rosarch.findings.policy import identifiers

    try:
        found = read_configuration(read_input(path), str(path), identifiers(checks))
    except ConfigurationError as error:
        raise InputError(str(error)) from None
    base = path.parent
    return replace(
        found,
        baseline=found.baseline and str(base / found.baseline),
        launch=tuple(replace(entry, files=tuple(str(base / name) for name in entry.files)) for entry in found.launch),
        package_path=tuple(str(base / name) for name in found.package_path),
    )


def make_policy(
    configuration: Configuration,
    checks: Iterable[Check],
    *,
    errors: Sequence[str] | None = None,
    warnings: Sequence[str] | None = None,
    notes: Sequence[str] | None = None,
    ignored: Sequence[str] | None = None,
    fail_on: FailOn | None = None,
    exit_zero: bool = False,
) -> Policy:
    """What a workspace and its user want reported; the options overrule the file."""
    from rosarch.findings.policy import Policy, identifiers

    known = identifiers(checks)
    given = {"error": errors, "warning": warnings, "note": notes, "ignore": ignored}
    options: Severities = tuple((name, severity) for severity, texts in given.items() for name in _names(severity, texts, known))
    threshold = fail_on.value if fail_on else configuration.fail_on or FailOn.warning.value
    return Policy((configuration.checks, options), configuration.ignore_paths, threshold, exit_zero)


def _names(option: str, texts: Iterable[str] | None, known: Collection[str]) -> Iterator[str]:
    """The ids and patterns of an option; each must mean a check."""
    from rosarch.base.hints import hint
    from rosarch.findings.policy import unmatched

    names = [name.strip() for text in texts or () for name in text.split(",")]
    for name in unmatched(names, known):
        raise InputError(f"--{option} {name}: no such check{hint(name, known)}")
    yield from names
