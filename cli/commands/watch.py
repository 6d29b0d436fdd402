"""`rosarch watch`: what the rules derive, again at every save."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.derivations import chosen_relations, datalog_errors, shorten
from rosarch.cli.errors import InputError
from rosarch.cli.questions import Question, asks
from rosarch.cli.terminal import emit_lines

if TYPE_CHECKING:
    from rosarch.datalog import RelationDecl
    from rosarch.datalog.inspection.queries import Table
    from rosarch.rule_programs.live import LiveRules, Update

Tables = Mapping[str, Mapping[str, "Table"]]
SETTLE = 50  # milliseconds in which nothing more is written, after which a save is complete


@asks("engine", "verbose")
def watch(
    question: Question,
    files: Annotated[list[Path] | None, typer.Argument(metavar="[FILE]...", help="Files of rules of your own.", show_default=False)] = None,
    relations: Annotated[
        list[str] | None,
        typer.Option("--relation", "-R", metavar="NAME", help="Show this relation; by default the `.output` of FILE.", show_default=False),
    ] = None,
) -> None:
    """Print what rules derive, and what changes whenever a rule or a source is saved. Ends with Ctrl-C."""
    from rosarch.rule_programs.live import LiveRules
    from rosarch.rule_programs.own_files import own_files
    from rosarch.rule_programs.sets import rule_history

    batches = saves([question.folder, *(files or ()), *(question.own or ())])
    before: Tables | None = None
    while True:
        try:
            with datalog_errors():
                rules = question.rules(*(files or ()))
            from rosarch.base.scratch import scratch_folder

            with question.asked(rules) as components, scratch_folder() as scratch:
                history = rule_history("system" if question.systems else "component", rules)
                live = LiveRules(components, history, scratch, jobs=question.jobs)
                wanted = _Wanted(relations or [], own_files(rules.own))
                before = _report(live, wanted, before, [])
                for saved in batches:
                    if any(path.suffix != ".dl" for path in saved):
                        break
                    before = _report(live, wanted, before, saved)
                else:
                    return
        except InputError as error:  # what is wrong at the start is rejected; later the next save may fix it
            if before is None:
                raise
            _print_error(f"rosarch: error: {error}")
            if next(batches, None) is None:
                return
        except KeyboardInterrupt:  # between two waits for a save
            if before is None:
                raise
            return


class _Wanted:
    """The relations to show: those named, else the output of files, else all output."""

    def __init__(self, names: Sequence[str], files: Sequence[Path]) -> None:
        self.names = names
        self.files = files

    def __call__(self, relations: Mapping[str, RelationDecl]) -> list[str]:
        return chosen_relations(relations, self.names, self.files) or [r.name for r in relations.values() if r.is_output]


def saves(paths: Sequence[Path]) -> Iterator[list[Path]]:
    """What is saved below some paths or in rosarch's rules, a batch at a time, until Ctrl-C."""
    try:
        from watchfiles import DefaultFilter
        from watchfiles import watch as changes
    except ImportError as error:
        raise InputError(f"this needs {error.name}: pip install '.[interactive]' in the checkout of rosarch") from None
    from rosarch.extractor.manifest import rules_folder

    for path in paths:
        if not path.exists():
            raise InputError(f"{path}: no such file or folder")
    batches = changes(
        rules_folder(), *paths, watch_filter=DefaultFilter(), debounce=4 * SETTLE, step=SETTLE, rust_timeout=SETTLE, yield_on_timeout=True,
    )  # fmt: skip
    next(batches, None)  # from here on nothing is missed, whatever is done between two batches
    return _until_interrupted(sorted({Path(path) for _, path in batch}) for batch in batches if batch)


def _until_interrupted(batches: Iterator[list[Path]]) -> Iterator[list[Path]]:
    try:
        yield from batches
    except KeyboardInterrupt:
        return


def _report(live: LiveRules, wanted: _Wanted, before: Tables | None, saved: Sequence[Path]) -> Tables | None:
    """Derive again, and print all at first, then what has changed; the tables that the next change is compared with."""
    try:
        with datalog_errors():
            update = live.derive(wanted)
    except InputError as error:
        if before is None:
            raise
        _print_error(f"{_heading(saved)}\n{error}")
        return before
    for title, failure in update.failures.items():
        _print_error(f"rosarch: {title}: {failure}")
    emit_lines(_all(live, update) if before is None else f"{_heading(saved)}  {_effort(update)}\n{_changes(live, update, before)}")
    return update.tables


def _print_error(text: str) -> None:
    sys.stderr.write(text + "\n")
    sys.stderr.flush()


def _heading(saved: Sequence[Path]) -> str:
    names = ", ".join(shorten(str(path)) for path in saved[:3]) + (", ..." if len(saved) > 3 else "")
    return f"{time.strftime('%H:%M:%S')}  {names or 'sources'}"


def _effort(update: Update) -> str:
    count = "everything" if update.affected is None else f"{len(update.affected)} relation{'s' * (len(update.affected) != 1)}"
    return f"{count} derived again, {update.seconds:.2f} s"


def _all(live: LiveRules, update: Update) -> str:
    from rosarch.datalog.inspection.queries import table_text

    assert live.program is not None
    parts = []
    for title, tables in update.tables.items():
        heading = f"== {title}\n" if len(update.tables) > 1 else ""
        parts.append(heading + "\n".join(f"{name}\n{table_text(table, live.program)}" for name, table in tables.items()))
    return "\n".join(parts)


def _changes(live: LiveRules, update: Update, before: Tables) -> str:
    """The rows that came and went."""
    lines = []
    for title, tables in update.tables.items():
        own = []
        for name, table in tables.items():
            old = before.get(title, {}).get(name)
            known = set(old.rows) if old else set()
            now = set(table.rows)
            if now != known:
                own.append(f"{name}  {len(now)} row{'s' * (len(now) != 1)}")
                own += [f"+ {text}" for text in _rows(live, table, now - known)]
                own += [f"- {text}" for text in _rows(live, old, known - now)] if old else []
        gone = [name for name in before.get(title, {}) if name not in tables]
        own += [f"{name}  is no longer put out" for name in gone]
        if own:
            lines += [f"== {title}", *own] if len(update.tables) > 1 else own
    return "".join(f"{line}\n" for line in lines or ["no row has changed"])


def _rows(live: LiveRules, table: Table, rows: Iterable[tuple[object, ...]]) -> list[str]:
    from dataclasses import replace

    from rosarch.datalog.inspection.queries import table_cells

    assert live.program is not None
    chosen = set(rows)
    part = replace(table, rows=tuple(row for row in table.rows if row in chosen))
    return ["  ".join(cells) for cells in table_cells(part, live.program)]
