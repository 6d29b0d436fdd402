"""`rosarch doctor`: how well a workspace can be read, and what to do about the rest."""

from __future__ import annotations

from pathlib import Path

import typer

from rosarch.cli.inputs import check_diagnostics, check_sources
from rosarch.cli.options import Folder, Packages, parse_defines
from rosarch.cli.questions import Reading, asks
from rosarch.cli.terminal import emit, progress


@asks("engine", "cached", "verbose")
def doctor(reading: Reading, folder: Folder, packages: Packages = None) -> None:
    """Report what was replaced, missing, unresolved or slow in the packages below DIR, and what to do about it."""
    variables = parse_defines(reading.defines)
    check_sources(folder)
    rules = reading.rules()
    from rosarch.findings.health import examine
    from rosarch.reports.doctor import doctor_text

    with progress() as report:
        health = examine(
            folder,
            packages or None,
            rules=rules,
            jobs=reading.jobs,
            timeout=reading.timeout,
            defines=variables,
            progress=report,
        )
    check_diagnostics(folder, health.components, health.diagnostics)
    emit(doctor_text(health, Path.cwd()))
    if health.failed:
        raise typer.Exit(1)
