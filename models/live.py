"""The rows of components or systems, kept up to date while the rules are edited."""

from __future__ import annotations

import marshal
import time
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rosarch.datalog import Program, RelationDecl
from rosarch.datalog.queries import Table
from rosarch.datalog.rederive import Edit, RuleHistory
from rosarch.extractor.limits import LIMITS
from rosarch.extractor.pool import Failure, default_jobs, run_tasks
from rosarch.models.selection import SelectedComponent

Row = tuple[Any, ...]


@dataclass(frozen=True)
class Update:
    """What the rules derive now: the tables of the relations that were asked for, by component and relation.

    `affected` are the relations that were derived again, None for all. `failures` tell of components without rows.
    """

    tables: Mapping[str, Mapping[str, Table]]
    affected: frozenset[str] | None
    seconds: float
    failures: Mapping[str, str]


class LiveRules:
    """Derives the rows of components, and after an edit of the rules again only what it reaches.

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

        def work(index: int) -> dict[str, list[Row]]:
            return self._whole(index, names) if edit is None else self._part(index, edit, names)

        tables: dict[str, Mapping[str, Table]] = {}
        failures: dict[str, str] = {}
        for index, outcome in run_tasks(work, range(len(self.components)), jobs=self.jobs, timeout=LIMITS.evaluation):
            title = self.components[index].title
            if isinstance(outcome, Failure):
                failures[title] = f"{outcome.reason}: {outcome.detail}"
            else:
                tables[title] = {name: _table(relations[name], rows) for name, rows in outcome.items()}
        ordered = {c.title: tables[c.title] for c in self.components if c.title in tables}
        return Update(ordered, edit.affected if edit else None, time.perf_counter() - start, failures)

    def _file(self, index: int) -> Path:
        return self.folder / f"{index}.rows"

    def _whole(self, index: int, wanted: Collection[str]) -> dict[str, list[Row]]:
        assert self.program is not None
        inputs = set(self.program.inputs)
        facts = {name: rows for name, rows in self.components[index].load().items() if name in inputs}
        result = self.program.evaluate(facts, keep="all")
        _write(self._file(index), result.all_rows())
        return {name: result.rows(name) for name in wanted}

    def _part(self, index: int, edit: Edit, wanted: Collection[str]) -> dict[str, list[Row]]:
        derived = [name for name in wanted if name in edit.affected]
        known = _read(self._file(index), {*(edit.needed if derived else ()), *(n for n in wanted if n not in edit.affected)})
        found = {name: known[name] for name in wanted if name in known}
        if derived and edit.slice is not None:
            result = edit.slice.evaluate({name: known[name] for name in edit.needed}, keep=derived)
            found |= {name: result.rows(name) for name in derived}
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


def _read(path: Path, wanted: Collection[str]) -> dict[str, list[Row]]:
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
