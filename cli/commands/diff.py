"""`rosarch diff`: what changed between two folders or two revisions."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.check_options import load_configuration
from rosarch.cli.errors import FINDINGS, InputError
from rosarch.cli.inputs import check_input
from rosarch.cli.options import Packages
from rosarch.cli.questions import ReadingOptions, asks
from rosarch.cli.systems import Launches, load_systems
from rosarch.cli.terminal import emit, show_diagnostics, show_note

if TYPE_CHECKING:
    from rosarch.analysis.comparison import Snapshot
    from rosarch.base.git_revisions import Exported


class DiffFormat(str, Enum):
    """The formats of a comparison on stdout."""

    text = "text"
    markdown = "markdown"
    json = "json"


@dataclass(frozen=True)
class State:
    """One side of the comparison: a folder, and the one that paths in messages start from."""

    folder: Path
    base: Path


Load = Callable[[State], "Snapshot"]

Side = Annotated[
    str,
    typer.Argument(help="A folder with ROS packages, or a revision of the git repository in the current folder.", show_default=False),
]


@asks()
def diff(
    reading: ReadingOptions,
    old: Side,
    new: Side,
    packages: Packages = None,
    launches: Launches = None,
    output_format: Annotated[DiffFormat, typer.Option("--format", help="The form of the report on stdout.")] = DiffFormat.text,
) -> None:
    """Compare two folders or git revisions: ports, rates, reactions, states, connections, findings. Exits with 1 when something differs.

    With --package, only components are compared.
    """
    rules = reading.rules()

    def load(state: State) -> Snapshot:
        from rosarch.analysis.comparison import Snapshot
        from rosarch.extractor.stored_facts import has_facts
        from rosarch.rule_programs.sets import system_rules

        analysis = reading.analysis(rules, state.folder, packages)
        show_diagnostics(analysis.diagnostics, reading.verbose, state.base)
        if packages or has_facts(state.folder):
            return Snapshot(analysis.models)
        configuration = load_configuration(state.folder, None, system_rules(rules).checks)
        composed = load_systems(reading.systems_in(state.folder, launches, rules), configuration)
        return Snapshot(analysis.models, composed.systems, composed.findings)

    compare_states(old, new, output_format, load)


def compare_states(old: str, new: str, output_format: DiffFormat, load: Load) -> None:
    """Report what differs between what `load` makes of both sides."""
    from rosarch.analysis.comparison import compare
    from rosarch.reports import comparison

    writers = {
        DiffFormat.text: comparison.changes_text,
        DiffFormat.markdown: comparison.changes_markdown,
        DiffFormat.json: comparison.changes_json,
    }
    with _states(old, new) as (before, after):
        changes = compare(load(before), load(after))
    emit(writers[output_format](changes))
    if changes:
        raise typer.Exit(FINDINGS)


@contextmanager
def _states(old: str, new: str) -> Iterator[tuple[State, State]]:
    """Both sides as paths; revisions are written to temporary folders, which are called alike."""
    from rosarch.base.scratch import scratch_folder
    from rosarch.extractor.stored_facts import is_facts_text

    with scratch_folder() as temporary:
        commits = [None if os.path.isdir(side) or is_facts_text(Path(side)) else _commit(side) for side in (old, new)]
        states = []
        for number, (side, commit) in enumerate(zip((old, new), commits, strict=True)):
            if commit is None:
                states.append(State(check_input(Path(side)), Path.cwd()))
            else:
                folder = Path(temporary, str(number), Path.cwd().name or "root")
                _note_omissions(side, _exported(commit, folder))
                states.append(State(folder, folder))
        yield states[0], states[1]


def _commit(revision: str) -> str:
    from rosarch.base.git_revisions import RevisionError, resolve

    try:
        return resolve(revision, Path.cwd())
    except RevisionError as error:
        raise InputError(str(error)) from None


def _exported(commit: str, folder: Path) -> Exported:
    from rosarch.base.git_revisions import RevisionError, export

    try:
        return export(commit, Path.cwd(), folder)
    except RevisionError as error:
        raise InputError(str(error)) from None


def _note_omissions(revision: str, exported: Exported) -> None:
    """What of a revision is not compared."""
    for what, paths in (
        ("submodule", exported.submodules),
        ("file that this repository does not have", exported.missing),
        ("file that cannot be written or a link that leads out of the repository", exported.refused),
    ):
        if paths:
            more = f" and {len(paths) - 3} more" if len(paths) > 3 else ""
            show_note(f"{revision}: not read: {what}: {', '.join(paths[:3])}{more}")
