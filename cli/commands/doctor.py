"""`rosarch doctor`: how well a workspace can be read, and what to do about the rest."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import typer

from rosarch.cli.inputs import check_diagnostics, check_sources
from rosarch.cli.options import Folder, Packages
from rosarch.cli.questions import ReadingOptions, asks
from rosarch.cli.terminal import emit, progress


@asks("engine", "cached", "verbose")
def doctor(reading: ReadingOptions, folder: Folder, packages: Packages = None) -> None:
    """Report what was replaced, missing, unresolved or slow in the packages below DIR, and what to do about it."""
    settings = reading.sources()
    check_sources(folder)
    rules = reading.rules()
    from rosarch.findings.health import examine
    from rosarch.reports.doctor import doctor_text

    with progress() as report:
        health = examine(folder, packages or None, replace(settings, cache=None, progress=report), rules=rules)
    check_diagnostics(folder, health.components, health.diagnostics)
    emit(doctor_text(health, Path.cwd()))
    if health.failed:
        raise typer.Exit(1)
