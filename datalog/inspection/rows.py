"""The rows an explanation works on: those of any engine's result, with indexes built as they are asked for."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from rosarch.datalog.language.errors import DatalogError, Diagnostic

if TYPE_CHECKING:
    from rosarch.datalog.program import Program, Result

Row = tuple[Any, ...]
Index = Mapping[Any, list[Row]]
Given: TypeAlias = "Result | RowStore | Mapping[str, Iterable[Row]] | Path"


class RowStore:
    """Rows by relation, in sorted order; `facts` are those given from outside, if they are known."""

    def __init__(self, result: Result, facts: Mapping[str, Collection[Row]] | None = None) -> None:
        self._result = result
        self._names = set(result.names())
        self._facts = facts
        self._rows: dict[str, dict[Row, None]] = {}
        self._indexes: dict[tuple[str, tuple[int, ...]], Index] = {}
        self._given: dict[str, set[Row]] = {}

    @property
    def names(self) -> Collection[str]:
        """The relations whose rows were kept."""
        return self._names

    def rows(self, name: str) -> Collection[Row]:
        """The rows of a relation."""
        found = self._rows.get(name)
        if found is None:
            if name not in self._names:
                raise DatalogError([Diagnostic(f"no rows of `{name}` were kept", hint='evaluate with keep="all"')])
            found = self._rows[name] = dict.fromkeys(self._result.rows(name))
        return found

    def has(self, name: str, row: Row) -> bool:
        """Whether a relation has a row."""
        return row in self.rows(name)

    def count(self, name: str) -> int:
        """The number of rows of a relation."""
        return len(self.rows(name))

    def matching(self, name: str, columns: tuple[int, ...], key: Row) -> Iterable[Row]:
        """The rows with these values in these columns."""
        if not columns:
            return self.rows(name)
        index = self._indexes.get((name, columns))
        if index is None:
            built: dict[Any, list[Row]] = defaultdict(list)
            for row in self.rows(name):
                built[tuple([row[c] for c in columns])].append(row)
            index = self._indexes[name, columns] = dict(built)
        return index.get(key, ())

    def given(self, name: str, row: Row) -> bool | None:
        """Whether a row was given as a fact; None when the facts are not known."""
        if self._facts is None:
            return None
        if name not in self._given:
            self._given[name] = {tuple(r) for r in self._facts.get(name, ())}
        return row in self._given[name]


def row_store(program: Program, rows: Given, *, engine: str = "embedded") -> RowStore:
    """The rows of a result, or of the evaluation of facts, which may be a folder."""
    if isinstance(rows, RowStore):
        return rows
    if isinstance(rows, (str, Path, Mapping)):
        facts = program.read_facts(Path(rows)) if isinstance(rows, (str, Path)) else {name: list(r) for name, r in rows.items()}
        return RowStore(program.evaluate(facts, engine=engine, keep="all"), facts)
    return RowStore(rows)
