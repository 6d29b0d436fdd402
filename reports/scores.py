"""A score: tables of counts and agreements, and the elements that are missed or extra."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rosarch.evaluation.experiments.comparison import CATEGORIES, EXTRA, MISSED
from rosarch.evaluation.experiments.scores import Score, misses
from rosarch.reports.labels import counted
from rosarch.reports.printable import json_text, printable
from rosarch.reports.tables import Table, table_csv, table_latex, table_markdown, table_text, tables_as

_LISTED = {MISSED: "missed", EXTRA: "extra "}


def score_tables(score: Score) -> list[Table]:
    """Recall, precision and F1 by category, then the agreement of attributes."""
    counts = score.counts
    figures = tuple(
        (category, c.hit + c.missed, c.hit, c.extra, c.recall, c.precision, c.f1)
        for category, c in ((name, counts[name]) for name in CATEGORIES)
    )
    agreement = tuple((attribute, compared, mean) for attribute, (mean, compared) in score.agreement.items())
    return [
        Table("Elements", ("category", "truth", "found", "extra", "recall", "precision", "F1"), figures),
        Table("Attributes of elements that were found", ("attribute", "compared", "agree"), agreement),
    ]


def head_text(score: Score) -> str:
    """How many components there are, and which have no model."""
    absent = ", ".join(truth.title for truth in score.absent)
    return f"{counted(len(score.comparisons), 'component')}, {len(score.absent)} without a model{f': {absent}' if absent else ''}"


def misses_text(score: Score) -> str:
    """A line for each element that is missed or extra."""
    lines = (
        f"{word} {category}: {truth.title}: {text}  {at}".rstrip()
        for verdict, word in _LISTED.items()
        for category, truth, text, at in misses(score, verdict)
    )
    return "".join(f"{printable(line)}\n" for line in lines)


def score_text(score: Score, *, listed: bool = False) -> str:
    """The report for a reader; `listed` adds all that is missed or extra."""
    text = f"{head_text(score)}\n\n{tables_as(table_text, _filled(score))}"
    return text + (f"\n{misses_text(score)}" if listed else "")


def score_json(score: Score, *, listed: bool = False) -> str:
    """The same as JSON; `listed` as above."""
    data: dict[str, Any] = {
        "components": len(score.comparisons),
        "without a model": [truth.title for truth in score.absent],
        "categories": {
            name: {"truth": c.hit + c.missed, "found": c.hit, "extra": c.extra, "recall": c.recall, "precision": c.precision, "f1": c.f1}
            for name, c in score.counts.items()
        },
        "attributes": {name: {"compared": compared, "agree": mean} for name, (mean, compared) in score.agreement.items()},
    }
    for verdict in _LISTED if listed else ():
        data[verdict] = [
            {"category": category, "system": truth.system, "component": truth.title, "element": text, "at": at}
            for category, truth, text, at in misses(score, verdict)
        ]
    return json_text(data)


def _filled(score: Score) -> list[Table]:
    return [table for table in score_tables(score) if table.rows]


WRITERS: dict[str, Callable[[Score, bool], str]] = {
    "text": lambda score, listed: score_text(score, listed=listed),
    "markdown": lambda score, _: tables_as(table_markdown, _filled(score)),
    "latex": lambda score, _: tables_as(table_latex, _filled(score)),
    "csv": lambda score, _: table_csv(score_tables(score)[0]),
    "json": lambda score, listed: score_json(score, listed=listed),
}
