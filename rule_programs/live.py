"""The rows of components or systems, kept up to date while the rules are edited."""

from __future__ import annotations

import marshal
import time
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rosarch.base.limits import LIMITS
from rosarch.base.pool import Failure, default_jobs, run_tasks
from rosarch.datalog import Program, RelationDecl
from rosarch.datalog.engine.rederive import Edit, Part, RuleHistory
from rosarch.datalog.inspection.queries import Table
from rosarch.extractor.selection import SelectedComponent

Row = tuple[Any, ...]
Rows = dict[str, list[Row]]


@dataclass(frozen=True)
class Update:
    """What the rules derive now: the tables of the relations that were asked for, by component and relation.

    `affected` are the relations that were derived again, None for all. `failures` name components without rows.
    """

    tables: Mapping[str, Mapping[str, Table]]
    affected: frozenset[str] | None
    seconds: float
    failures: Mapping[str, str]


class LiveRules:
    """Derives the rows of components, and after an edit of the rules again only what it reaches, where it changes anything.

    The rows of the whole program lie in `folder`, a file a component.
    """

    def __init__(self, components: Sequence[SelectedComponent], history: RuleHistory, folder: Path, *, jobs: int | None = None) -> None:
        self.components = list(components)
        self.history = history
        self.folder = folder
        self.jobs = jobs or default_jobs()
        self.program: Program | None = None

    def derive(self, wanted: Callable[[Mapping[str, RelationDecl]], Sequence[str]]) -> Update:
        """The rows of the relations that `wanted` chooses of those that are declared now.

        Raises:
            DatalogError: the rules are wrong.
        """
        start = time.perf_counter()
        edit = self.history.edit() if self.program is not None else None
        if edit is None:
            self.program = self.history.whole()
        assert self.program is not None
        relations = edit.relations if edit else self.program.relations
        names = wanted(relations)

        if edit is None:
            again = None
            found = self._run(lambda index: self._whole(index, names), range(len(self.components)))
        else:
            leading = edit.leading_to(names)
            again = edit.first.names if edit.first and leading else frozenset()
            found = self._run(lambda index: self._edited(index, edit, leading, names), range(len(self.components)))
            changed = [index for index, outcome in found.items() if outcome is None]
            if changed:
                part = edit.part(leading)
                again |= part.names
                found |= self._run(lambda index: self._derived(index, part, names), changed)
        titles = [component.title for component in self.components]
        failures = {titles[i]: f"{each.reason}: {each.detail}" for i, each in sorted(found.items()) if isinstance(each, Failure)}
        tables = {
            titles[i]: {name: _table(relations[name], rows) for name, rows in each.items()}
            for i, each in sorted(found.items())
            if each is not None and not isinstance(each, Failure)
        }
        return Update(tables, again, time.perf_counter() - start, failures)

    def _run(self, work: Callable[[int], Rows | None], indexes: Sequence[int]) -> dict[int, Rows | Failure | None]:
        """What `work` gives for each of these components."""
        outcomes = run_tasks(work, indexes, jobs=self.jobs, timeout=LIMITS.evaluation)
        return {indexes[number]: outcome for number, outcome in outcomes}

    def _file(self, index: int) -> Path:
        return self.folder / f"{index}.rows"

    def _whole(self, index: int, wanted: Collection[str]) -> Rows:
        assert self.program is not None
        inputs = set(self.program.inputs)
        facts = {name: rows for name, rows in self.components[index].load().items() if name in inputs}
        result = self.program.evaluate(facts, keep="all")
        _write(self._file(index), result.all_rows())
        return {name: result.rows(name) for name in wanted}

    def _edited(self, index: int, edit: Edit, leading: frozenset[str], wanted: Collection[str]) -> Rows | None:
        """The rows after an edit; None when edited relations have others than before, so that those that rest on them may, too."""
        if edit.first is None or not leading:
            return _read(self._file(index), wanted)
        if edit.first.names >= leading:
            return self._derived(index, edit.first, wanted)
        known = _read(self._file(index), edit.first.needed | edit.first.names)
        result = edit.first.program.evaluate({name: known[name] for name in edit.first.needed}, keep=edit.first.names)
        if any(name not in known or set(known[name]) != set(result.rows(name)) for name in result.names()):
            return None
        return _read(self._file(index), wanted)

    def _derived(self, index: int, part: Part, wanted: Collection[str]) -> Rows:
        """The rows with those that a part of the rules derives."""
        known = _read(self._file(index), part.needed.union(wanted))
        result = part.program.evaluate({name: known[name] for name in part.needed}, keep=part.names)
        found = {**known, **{name: result.rows(name) for name in part.names.intersection(wanted, result.names())}}
        return {name: found[name] for name in wanted if name in found}


def _write(path: Path, relations: Mapping[str, Iterable[Row]]) -> None:
    """Rows by relation, each relation by itself, behind a table of where each begins."""
    parts = {name: marshal.dumps(list(rows)) for name, rows in relations.items()}
    places, at = {}, 0
    for name, part in parts.items():
        places[name] = at, len(part)
        at += len(part)
    head = marshal.dumps(places)
    path.write_bytes(len(head).to_bytes(8, "little") + head + b"".join(parts.values()))


def _read(path: Path, wanted: Collection[str]) -> Rows:
    with path.open("rb") as file:
        start = 8 + int.from_bytes(file.read(8), "little")
        places = marshal.loads(file.read(start - 8))
        found = {}
        for name in wanted:
            if name in places:
                at, length = places[name]
                file.seek(start + at)
                found[name] = marshal.loads(file.read(length))
        return found


def _table(relation: RelationDecl, rows: Sequence[Row]) -> Table:
    return Table(tuple(a.name for a in relation.attributes), tuple(a.type for a in relation.attributes), tuple(rows))
