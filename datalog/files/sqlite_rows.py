"""Rows in SQLite databases, in souffle's schema.

The table `_R` has the rows of `R` with symbols as numbers, `__SymbolTable` has the symbols, and the view `R` joins them.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Iterable
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.datalog.files.cells import converter
from rosarch.datalog.files.tables import complain
from rosarch.datalog.language.errors import DatalogError, Diagnostic
from rosarch.datalog.language.types import Types
from rosarch.datalog.language.values import ValueReader

if TYPE_CHECKING:
    from rosarch.datalog.program import RelationDecl

Row = tuple[Any, ...]


def _quote(name: str) -> str:
    return '"' + name.replace('"', '""') + '"'


def read_rows(path: Path, table: str, relation: RelationDecl, reader: ValueReader, errors: list[Diagnostic]) -> list[Row]:
    """The rows of a table or view; rows that do not fit are added to `errors`."""
    _refuse_records(relation)
    pool: dict[str, str] = {}
    converters = [converter(a, reader, pool.setdefault) for a in relation.attributes]
    rows: list[Row] = []
    try:
        with closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as database:
            for number, values in enumerate(database.execute(f"SELECT * FROM {_quote(table)}"), 1):
                if len(values) != len(converters):
                    raise DatalogError(f"{path}: `{table}` has {len(values)} columns, `{relation.name}` has {len(converters)}")
                try:
                    rows.append(tuple(c("" if v is None else str(v)) for c, v in zip(converters, values, strict=True)))
                except ValueError as error:
                    complain(errors, f"{path}: `{table}`, row {number}: {error}")
    except sqlite3.Error as error:
        raise DatalogError(f"{path}: cannot read `{table}`: {error}") from None
    return rows


def write_rows(path: Path, table: str, rows: Iterable[Row], relation: RelationDecl, types: Types) -> None:
    """Write a relation into a database, beside the others that are there; all of it or nothing."""
    _refuse_records(relation)
    kinds = [types.kind(a.type) for a in relation.attributes]
    columns = ", ".join(f'"{i}" INTEGER' for i in range(len(kinds))) or '"unit" INTEGER'
    shown, sources, joins = [], [_quote(f"_{table}")], []
    for index, (attribute, kind) in enumerate(zip(relation.attributes, kinds, strict=True)):
        column = f'{_quote(f"_{table}")}."{index}"'
        if kind == "s":
            sources.append(f'__SymbolTable AS "_symtab_{index}"')
            joins.append(f'{column} = "_symtab_{index}".id')
            column = f'"_symtab_{index}".symbol'
        shown.append(f"{column} AS {_quote(attribute.name)}")
    where = f" WHERE {' AND '.join(joins)}" if joins else ""
    try:
        with closing(sqlite3.connect(path)) as database, database:
            database.execute("BEGIN")
            database.execute(f"CREATE TABLE IF NOT EXISTS {_quote(f'_{table}')} ({columns})")
            database.execute(f"DELETE FROM {_quote(f'_{table}')}")
            database.execute("CREATE TABLE IF NOT EXISTS __SymbolTable (id INTEGER PRIMARY KEY, symbol TEXT UNIQUE)")
            database.execute(
                f"CREATE VIEW IF NOT EXISTS {_quote(table)} AS SELECT {', '.join(shown) or '1'} FROM {', '.join(sources)}{where}"
            )
            known = {symbol: number for number, symbol in database.execute("SELECT id, symbol FROM __SymbolTable")}
            texts = {v for row in rows for v, kind in zip(row, kinds, strict=True) if kind == "s"} - known.keys()
            database.executemany("INSERT INTO __SymbolTable VALUES (NULL, ?)", [(t,) for t in sorted(texts)])
            known = {symbol: number for number, symbol in database.execute("SELECT id, symbol FROM __SymbolTable")}
            places = ", ".join("?" * max(len(kinds), 1))
            values = ([known[v] if k == "s" else v for v, k in zip(row, kinds, strict=True)] or [1] for row in rows)
            database.executemany(f"INSERT INTO {_quote(f'_{table}')} VALUES ({places})", values)
    except sqlite3.Error as error:
        raise DatalogError(f"{path}: cannot write `{table}`: {error}") from None


def _refuse_records(relation: RelationDecl) -> None:
    for attribute in relation.attributes:
        if attribute.base in ("record", "adt"):
            raise DatalogError(f"`{relation.name}.{attribute.name}` is of type `{attribute.type}`, which SQLite cannot hold")
