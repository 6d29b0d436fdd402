"""Tables of figures as text, Markdown, LaTeX and CSV."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from rosarch.reports.printable import printable

Cell = str | int | float | None
_LATEX = {
    "\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": r"\textless{}", ">": r"\textgreater{}",
    **{char: f"\\{char}" for char in "&%$#_{}"},
}  # fmt: skip
_SPECIAL = re.compile("|".join(map(re.escape, _LATEX)))


@dataclass(frozen=True)
class Table:
    """A table: numbers are aligned to the right, a float is shown with three digits, None is not known."""

    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]


def table_text(table: Table) -> str:
    """Aligned columns below the title."""
    cells = [[_shown(cell) for cell in row] for row in table.rows]
    widths = [max(map(len, column)) for column in zip(table.columns, *cells, strict=True)]
    right = _right(table)
    lines = [
        [name.rjust(w) if r else name.ljust(w) for name, w, r in zip(row, widths, right, strict=True)] for row in (table.columns, *cells)
    ]
    return "".join(f"{line}\n" for line in (table.title, *("  " + "  ".join(line).rstrip() for line in lines)))


def table_markdown(table: Table) -> str:
    """A heading and a table."""
    rules = ["--:" if right else "---" for right in _right(table)]
    lines = [table.columns, rules, *([_shown(cell).replace("|", "\\|") for cell in row] for row in table.rows)]
    return f"## {table.title}\n\n" + "".join(f"| {' | '.join(line)} |\n" for line in lines)


def table_latex(table: Table) -> str:
    r"""A `tabular` with the title as caption; needs the package booktabs."""
    rows = [" & ".join(_latex(_shown(cell)) for cell in row) + r" \\" for row in table.rows]
    columns = "".join("r" if right else "l" for right in _right(table))
    head = " & ".join(map(_latex, table.columns)) + r" \\"
    return "\n".join([
        r"\begin{table}", rf"  \caption{{{_latex(table.title)}}}", rf"  \begin{{tabular}}{{{columns}}}", r"    \toprule", f"    {head}",
        r"    \midrule", *(f"    {row}" for row in rows), r"    \bottomrule", r"  \end{tabular}", r"\end{table}", "",
    ])  # fmt: skip


def table_csv(table: Table) -> str:
    """Comma-separated, with a line of column names; numbers in full."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(table.columns)
    writer.writerows(["" if cell is None else cell for cell in row] for row in table.rows)
    return text.getvalue()


def tables_as(write: Callable[[Table], str], tables: Sequence[Table]) -> str:
    """Tables with an empty line between them."""
    return "\n".join(map(write, tables))


def _right(table: Table) -> list[bool]:
    columns = zip(*table.rows, strict=True) if table.rows else [()] * len(table.columns)
    return [bool(cells) and all(cell is None or not isinstance(cell, str) for cell in cells) for cells in columns]


def _shown(cell: Cell) -> str:
    if cell is None:
        return "-"
    return f"{cell:.3f}" if isinstance(cell, float) else printable(str(cell))


def _latex(text: str) -> str:
    return _SPECIAL.sub(lambda match: _LATEX[match[0]], text)
