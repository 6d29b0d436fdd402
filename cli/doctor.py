"""`rosarch doctor`: how well a workspace can be read, and what to do about the rest."""

from __future__ import annotations

from pathlib import Path

import typer

from rosarch.cli.inputs import check_diagnostics, check_sources
from rosarch.cli.options import Defines, Folder, Jobs, Packages, Timeout, parse_defines
from rosarch.cli.terminal import emit, progress


def doctor(
    folder: Folder,
    packages: Packages = None,
    jobs: Jobs = None,
    defines: Defines = None,
    timeout: Timeout = 60.0,
) -> None:
    """Tell what of the packages below DIR was replaced, missing, unresolved or slow, and what to do about it."""
    variables = parse_defines(defines)
    check_sources(folder)
    from rosarch.models.health import examine
    from rosarch.reports.doctor import doctor_text

    with progress() as report:
        health = examine(
            folder,
            packages or None,
            jobs=jobs,
            timeout=timeout,
            defines=variables,
            progress=report,
        )
    check_diagnostics(folder, health.components, health.diagnostics)
    emit(doctor_text(health, Path.cwd()))
    if health.failed:
        raise typer.Exit(1)
