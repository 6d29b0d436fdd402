"""Fact files: one tab-separated `.facts` file per relation, as souffle reads and writes them.

A symbol cannot hold a tab or a line break in this format; the writer replaces each by a space.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from rosarch.datalog.files.cells import show_cell, show_cells
from rosarch.datalog.files.tables import PLAIN, Columned, Layout, parse_table, read_text
from rosarch.datalog.language.errors import DatalogError, Diagnostic
from rosarch.datalog.language.types import Types
from rosarch.datalog.language.values import ValueReader


def read_facts(
    folder: Path, relations: Mapping[str, Columned] | Iterable[Columned], *, reader: ValueReader | None = None, extension: str = ".facts"
) -> dict[str, list[tuple[Any, ...]]]:  # fmt: skip
    """The rows of each relation that has a file in `folder`; a relation without one has no rows.

    Bytes that are not UTF-8 are kept. Raises DatalogError with `path:line: message` for rows that do not fit their declaration.
    """
    declared = relations.values() if isinstance(relations, Mapping) else relations
    result: dict[str, list[tuple[Any, ...]]] = {}
    errors: list[Diagnostic] = []
    pool: dict[str, str] = {}
    for relation in declared:
        path = folder / f"{relation.name}{extension}"
        if path.is_file():
            result[relation.name] = read_fact_file(path, relation, errors, reader, pool=pool)
    if errors:
        raise DatalogError(errors)
    return result


def read_fact_file(
    path: Path, relation: Columned, errors: list[Diagnostic], reader: ValueReader | None = None, layout: Layout = PLAIN,
    pool: dict[str, str] | None = None, *, strict: bool = False,
) -> list[tuple[Any, ...]]:  # fmt: skip
    """The rows of one file; rows that do not fit are added to `errors`. With `strict`, so are bytes that are not UTF-8."""
    try:
        text = read_text(path, strict=strict)
    except DatalogError as error:
        errors.extend(error.diagnostics)
        return []
    return parse_table(text, str(path), relation, errors, reader, layout, pool)


def write_facts(
    folder: Path, rows: Mapping[str, Iterable[tuple[Any, ...]]], relations: Mapping[str, Columned] | Iterable[Columned],
    *, extension: str = ".facts", types: Types | None = None,
) -> None:  # fmt: skip
    """Write one file per relation that `rows` holds; checks the number of columns against the declaration.

    `types` are needed to write algebraic data types.
    """
    declared = relations if isinstance(relations, Mapping) else {r.name: r for r in relations}
    folder.mkdir(parents=True, exist_ok=True)
    for name, relation_rows in rows.items():
        if name not in declared:
            raise DatalogError(f"cannot write facts of the undeclared relation `{name}`")
        attributes = declared[name].attributes
        arity = len(attributes)
        nested = types is not None and (types.bits != 32 or any(a.base in ("record", "adt") for a in attributes))
        lines = []
        for row in relation_rows:
            if len(row) != arity:
                raise DatalogError(f"`{name}` has {arity} attribute{'s' * (arity != 1)}, given {len(row)}: {row!r}")
            lines.append("\t".join(show_cells(row, attributes, types) if nested else map(show_cell, row)) if arity else "()")
        text = "\n".join(lines) + "\n" if lines else ""
        (folder / f"{name}{extension}").write_text(text, encoding="utf-8", errors="surrogateescape", newline="")
