"""What components do, as tables of plain text."""

from __future__ import annotations

from collections.abc import Iterable

from rosarch.reports.behavior import Document, Table, heading, nothing, tables


def behaviors_text(documents: Iterable[Document]) -> str:
    """A heading and the tables of each component."""
    return "\n".join(_component(document) for document in documents)


def _component(document: Document) -> str:
    found = tables(document)
    blocks = [_table(table) for table in found] or [f"  {nothing(document)}\n"]
    return "  ".join(heading(document)) + "\n" + "\n".join(blocks)


def _table(table: Table) -> str:
    """Columns as wide as their contents; those without any are left out."""
    shown = [i for i in range(len(table.columns)) if any(row[i] for row in table.rows)]
    rows = [[table.columns[i] for i in shown], *([row[i] for i in shown] for row in table.rows)]
    widths = [max(len(row[column]) for row in rows) for column in range(len(shown))]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows]
    return "\n".join([f"  {table.title}", *(f"    {line}" for line in lines)]) + "\n"
