"""What is shown in addition to the report: progress and diagnostics, on stderr."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from rosarch.cli.errors import BROKEN_PIPE, InputError

if TYPE_CHECKING:
    from rich.progress import TaskID

    from rosarch.analysis.systems.analysis import SystemAnalysis
    from rosarch.analysis.systems.check_result import CheckResult
    from rosarch.base.diagnostics import Diagnostic

REFRESH_SECONDS = 0.1
_reports: list[Callable[[str, int, int], None]] = []
"""The progress that is shown at the moment: a terminal has room for one display."""


def emit_lines(text: str) -> None:
    """Write a report for readers to stdout: nothing of the input that is in it moves the cursor or turns what is beside it around."""
    from rosarch.reports.printable import printable_lines

    emit(printable_lines(text))


def emit(text: str | bytes) -> None:
    """Write a report to stdout; a reader that went away (`| head`) is no error."""
    if not sys.stdout:
        raise InputError("standard output: cannot write (it is closed)")
    try:
        if isinstance(text, bytes):
            sys.stdout.buffer.write(text)
        else:
            sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # what is still in the buffer must not fail again
        if isinstance(error, BrokenPipeError):
            raise typer.Exit(BROKEN_PIPE) from None
        raise InputError(f"standard output: cannot write ({(error.strerror or str(error)).lower()})") from None


def is_terminal() -> bool:
    """Whether the report is read by a person at a terminal."""
    return bool(sys.stdout) and sys.stdout.isatty()


def show_diagnostics(diagnostics: Iterable[Diagnostic], verbose: bool, base: Path | None = None) -> None:
    """Report on stderr what was not understood; paths are relative to `base`, by default to the current folder."""
    from rosarch.reports.diagnostics import diagnostics_text

    sys.stderr.write(diagnostics_text(diagnostics, base or Path.cwd(), complete=verbose))


def show_remaining(analysis: SystemAnalysis | CheckResult, folder: Path, verbose: bool) -> None:
    """Report on stderr what of systems was not understood: all of it, or in short what no finding reports."""
    from rosarch.reports.diagnostics import diagnostics_summary

    if verbose:
        return show_diagnostics(analysis.diagnostics, verbose)
    top = folder.absolute()
    told = {(os.path.join(top, step.place.path), step.place.line) for finding in analysis.findings for step in finding.evidence}
    rest = [found for found in analysis.diagnostics if (str(found.path.absolute()), found.line) not in told]
    sys.stderr.write(diagnostics_summary(rest, Path.cwd()))
    return None


def show_note(text: str) -> None:
    """Print on stderr what a reader of the report should know."""
    from rosarch.reports.printable import printable

    sys.stderr.write(f"rosarch: {printable(text)}\n")


@contextmanager
def progress() -> Iterator[Callable[[str, int, int], None] | None]:
    """A progress bar per stage when stderr is a terminal, else nothing. Within another one, that is used."""
    if _reports:
        yield _reports[-1]
        return
    if not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn("{task.description:<10}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    # without auto_refresh there is no thread, and worker processes can be forked
    with Progress(*columns, console=Console(stderr=True), transient=True, auto_refresh=False) as bars:
        tasks: dict[str, TaskID] = {}
        shown = 0.0

        def report(stage: str, done: int, total: int) -> None:
            nonlocal shown
            if stage not in tasks:
                tasks[stage] = bars.add_task(stage, total=total)
            bars.update(tasks[stage], completed=done, total=total)
            if done == total or time.monotonic() - shown > REFRESH_SECONDS:
                shown = time.monotonic()
                bars.refresh()

        _reports.append(report)
        try:
            yield report
        finally:
            _reports.pop()
