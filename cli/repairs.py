"""`rosarch check --fix` and `--diff`: what is certain is fixed, or shown as a patch."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.errors import InputError
from rosarch.cli.terminal import emit, emit_lines, is_terminal, show_note

if TYPE_CHECKING:
    from rosarch.findings.fixes import Unchanged
    from rosarch.findings.model import Finding

ROUNDS = 3
"""How often files are fixed and checked again: a fix may show what else is wrong."""
Fix = Annotated[bool, typer.Option("--fix", help="Fix the findings whose fix is certain, then report the others.")]
Diff = Annotated[bool, typer.Option("--diff", help="Print what --fix would change, as a patch for DIR, and change nothing.")]


def check_repairs(fix: bool, diff: bool) -> None:
    """Reject what makes no sense together."""
    if fix and diff:
        raise InputError("--fix and --diff: one changes files, the other shows what would change")


def fixed(findings: Sequence[Finding], folder: Path, since: int) -> bool:
    """Carry out the fixes of findings; whether a file was changed. `since` is when files began to be read."""
    from rosarch.findings.fixes import repairs, write
    from rosarch.reports.labels import counted

    made, left = repairs(findings, folder, since)
    if not made and not left:
        return False
    _show(left)
    count = files = 0
    for repair in made:
        try:
            write(repair, folder)
        except OSError as error:
            show_note(f"{repair.path}: not fixed: {(error.strerror or str(error)).lower()}")
            continue
        count, files = count + repair.count, files + 1
    show_note(f"{counted(count, 'change')} in {counted(files, 'file')}")
    return files > 0


def show_diff(findings: Sequence[Finding], folder: Path, since: int) -> bool:
    """Print what fixes would change; whether there is anything."""
    from rosarch.findings.fixes import repairs, unified

    made, left = repairs(findings, folder, since)
    _show(left)
    text = "".join(unified(made))
    if is_terminal():
        emit_lines(text)
    else:
        emit(text.encode("utf-8", "surrogateescape"))
    return bool(made)


def _show(left: Sequence[Unchanged]) -> None:
    for each in left:
        show_note(f"{each.change.place}: not fixed: {each.why}")
