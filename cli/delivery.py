"""Reports on composed systems: loading the systems, and printing what is made of them or writing a file for each."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypeVar

import typer

from rosarch.cli.check_options import load_configuration
from rosarch.cli.derivations import datalog_errors
from rosarch.cli.errors import InputError
from rosarch.cli.outputs import check_output, write_files
from rosarch.cli.questions import SystemQuestion
from rosarch.cli.systems import load_systems
from rosarch.cli.terminal import emit, show_remaining

if TYPE_CHECKING:
    from rosarch.models.system.model import SystemModel
    from rosarch.models.system.view import View

Named = TypeVar("Named", "SystemModel", "View")
Out = Annotated[
    Path | None, typer.Option("--output", "-o", metavar="DIR", help="Write a file for each system into DIR.", show_default=False)
]


def systems_of(question: SystemQuestion) -> Sequence[SystemModel]:
    """The systems to show, of the launch files in the configuration when none are named; what was not understood goes to stderr."""
    from rosarch.rule_programs.sets import system_rules

    rules = question.rules()
    with datalog_errors():
        checks = system_rules(rules).checks
    analysis = load_systems(question.inputs(rules), load_configuration(question.folder, None, checks))
    show_remaining(analysis, question.folder, question.verbose)
    return analysis.systems


def deliver(folder: Path, systems: Sequence[Named], write: Callable[[Named], str], form: str, out: Path | None) -> None:
    """Print what `write` makes of the only system, or write a file for each."""
    if out is not None:
        check_output(out)
        suffix = "txt" if form == "text" else form
        names = _file_names(system.name for system in systems)
        write_files(out, ((f"{name}.{suffix}", write(system)) for name, system in zip(names, systems, strict=True)))
        return
    if len(systems) != 1:
        known = ", ".join(system.name for system in systems) or "none"
        raise InputError(f"{folder}: {len(systems)} systems; choose one for {form} with --launch, or write all with --output DIR: {known}")
    emit(write(systems[0]))


def _file_names(names: Iterable[str]) -> list[str]:
    """A file's name for each system: what is no letter, digit, dot or dash is an underscore."""
    found: list[str] = []
    for name in names:
        first = re.sub(r"[^\w.-]+", "_", name).strip("._") or "system"
        file, number = first, 1
        while file in found:
            number += 1
            file = f"{first}_{number}"
        found.append(file)
    return found
