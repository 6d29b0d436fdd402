"""What components do, as Markdown tables."""

from __future__ import annotations

import re
from collections.abc import Iterable

from rosarch.reports.behavior import Document, Table, heading, nothing, tables


def behaviors_text(documents: Iterable[Document]) -> str:
    """A heading and the tables of each component."""
    return "\n".join(_component(document) for document in documents)


def _component(document: Document) -> str:
    name, kind = heading(document)
    blocks = [_table(table) for table in tables(document)] or [f"{nothing(document).capitalize()}.\n"]
    return f"## {_escape(name)} ({_escape(kind)})\n\n" + "\n".join(blocks)


def _table(table: Table) -> str:
    lines = [f"### {table.title.capitalize()}\n", _row(table.columns), "|" + "---|" * len(table.columns)]
    return "\n".join([*lines, *(_row(row) for row in table.rows)]) + "\n"


def _row(cells: Iterable[str]) -> str:
    return "| " + " | ".join(_escape(cell) for cell in cells) + " |"


def _escape(text: str) -> str:
    return re.sub(r"([\\`*_|<\[\]])", r"\\\1", text)
