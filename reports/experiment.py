"""The report of an experiment: tables of figures, tests, differences, costs, and what these depend on."""

from __future__ import annotations

from collections import Counter
from dataclasses import asdict
from typing import Any

from rosarch.evaluation.experiments.comparison import EXTRA, HIT, OPTIONAL
from rosarch.evaluation.experiments.results import (
    DECIDING,
    FIGURES,
    Difference,
    Results,
    agreements,
    element_differences,
    figures,
    row_differences,
    tests,
)
from rosarch.reports.printable import json_text
from rosarch.reports.tables import Cell, Table, table_csv, table_latex, table_markdown, table_text, tables_as
from rosarch.rule_programs.sets import described

_VERDICTS = {HIT: "true", EXTRA: "not true", OPTIONAL: "may be", "": None}
FORMATS = ("text", "markdown", "latex", "csv", "json")


class Report:
    """The tables of an experiment, each made once."""

    def __init__(self, results: Results) -> None:
        self.results = results
        self.figures = figures(results)
        self.tests = tests(results)
        self.elements = list(element_differences(results))
        self.rows = list(row_differences(results))

    def tables(self, most: int | None = None) -> list[Table]:
        """Those for a reader, without empty ones; of the elements that differ, no more than `most` for each pair of variants."""
        shown = [self.figures_table(), self.agreement_table(), self.tests_table(), self.elements_table(most), self.relations_table()]
        return [table for table in (*shown, self.cost_table(), self.provenance_table()) if table.rows]

    def figures_table(self) -> Table:
        """Precision, recall and F1 with their intervals."""
        rows = []
        for each in self.figures:
            cells: list[Cell] = [each.variant, each.category, each.counts.hit + each.counts.missed, each.counts.hit, each.counts.extra]
            for value, interval in each.values.values():
                cells += [value, f"[{interval[0]:.3f}, {interval[1]:.3f}]" if interval else None]
            rows.append(tuple(cells))
        columns = tuple(column for figure in FIGURES for column in (figure, "95 %"))
        title = f"Elements of {self.results.judged} components, with 95 % intervals over components (of findings: over subjects)"
        return Table(title, ("variant", "category", "truth", "found", "extra", *columns), tuple(rows))

    def figures_in_full(self) -> Table:
        """The same with the ends of intervals in columns of their own."""
        rows = []
        for each in self.figures:
            ends = [(value, *(interval or (None, None))) for value, interval in each.values.values()]
            cells = (each.variant, each.category, each.counts.hit + each.counts.missed, each.counts.hit, each.counts.extra)
            rows.append((*cells, *(cell for three in ends for cell in three)))
        columns = tuple(column for figure in FIGURES for column in (figure, f"{figure} low", f"{figure} high"))
        return Table("Elements", ("variant", "category", "truth", "found", "extra", *columns), tuple(rows))

    def agreement_table(self) -> Table:
        """How far attributes of what was found agree, and in brackets how many were compared, by variant."""
        found = agreements(self.results)
        attributes = dict.fromkeys(attribute for own in found.values() for attribute in own)
        rows = tuple(
            (name, *(f"{own[name][0]:.3f} ({own[name][1]})" if name in own else None for own in found.values())) for name in attributes
        )
        return Table("Attributes of elements that were found: how far they agree, and how many there are", ("attribute", *found), rows)

    def agreement_in_full(self) -> Table:
        """The same with a row for each variant."""
        found = agreements(self.results)
        rows = tuple((variant, name, number, mean) for variant, own in found.items() for name, (mean, number) in own.items())
        return Table("Attributes", ("variant", "attribute", "compared", "agree"), rows)

    def tests_table(self) -> Table:
        """How much figures differ, and how likely that is by chance, by category."""
        rows: dict[tuple[str, str, str], list[Cell]] = {}
        for test in self.tests:
            cells = rows.setdefault((test.one, test.other, test.category), [])
            cells += [f"{test.difference:+.3f}", test.p, *([] if test.corrected is None else [test.corrected])]
        columns = tuple(column for figure in FIGURES for column in (figure, "p", *(["corrected p"] if figure == DECIDING else [])))
        title = "How figures of the second variant differ from those of the first, with p of a paired permutation test over components"
        return Table(title, ("first", "second", "category", *columns), tuple((*key, *cells) for key, cells in rows.items()))

    def tests_in_full(self) -> Table:
        """The same with a row for each figure."""
        rows = tuple((t.one, t.other, t.category, t.figure, t.difference, t.p, t.corrected) for t in self.tests)
        return Table("Tests", ("first", "second", "category", "figure", "difference", "p", "corrected p"), rows)

    def elements_table(self, most: int | None = None) -> Table:
        """Elements that one variant has and another has not."""
        return _differences_table("Elements gained and lost by the second variant", self.elements, most)

    def rows_table(self) -> Table:
        """Rows that one variant has and another has not."""
        return _differences_table("Rows gained and lost by the second variant", self.rows, None)

    def relations_table(self) -> Table:
        """How many rows were gained and lost, by relation."""
        counted = Counter((d.one, d.other, d.kind, d.gained) for d in self.rows)
        keys = dict.fromkeys((d.one, d.other, d.kind) for d in self.rows)
        rows = tuple((one, other, kind, counted[one, other, kind, True], counted[one, other, kind, False]) for one, other, kind in keys)
        return Table("Rows gained and lost by the second variant, by relation", ("first", "second", "relation", "gained", "lost"), rows)

    def cost_table(self) -> Table:
        """Rows and processor time of each variant."""
        rows = []
        for variant, outcomes in self.results.outcomes.items():
            own = [outcome.evaluated for component, outcome in outcomes.items() if component.title]
            done = [evaluated for evaluated in own if evaluated]
            count = sum(len(found) for each in done for found in each.rows.values())
            rows.append((variant, len(done), len(own) - len(done), count, round(sum(each.seconds for each in done), 2)))
        return Table("Cost: processor time of evaluating the rules", ("variant", "components", "failed", "rows", "seconds"), tuple(rows))

    def components_table(self) -> Table:
        """The counts of each component."""
        rows = []
        for variant, outcomes in self.results.outcomes.items():
            for component, outcome in outcomes.items():
                seconds = outcome.evaluated.seconds if outcome.evaluated else None
                for category in outcome.comparison.elements if outcome.judged else ():
                    counts = outcome.comparison.counts(category)
                    cells = (variant, component.subject, component.title, category, counts.hit + counts.missed, counts.hit, counts.extra)
                    rows.append((*cells, seconds))
        columns = ("variant", "subject", "component", "category", "truth", "found", "extra", "seconds")
        return Table("Components", columns, tuple(rows))

    def provenance_table(self) -> Table:
        """What the results depend on."""
        return Table("Made from", ("what", "version or hash"), self.results.provenance)


def _differences_table(title: str, differences: list[Difference], most: int | None) -> Table:
    rows: list[tuple[Cell, ...]] = []
    counted: Counter[tuple[str, str]] = Counter()
    for d in differences:
        counted[d.one, d.other] += 1
        if most is None or counted[d.one, d.other] <= most:
            change = "gained" if d.gained else "lost"
            rows.append((d.one, d.other, change, d.kind, d.component.subject, d.component.title, d.text, d.at, _VERDICTS[d.verdict]))
    left = len(differences) - len(rows)
    columns = ("first", "second", "change", "kind", "subject", "component", "what", "at", "truth")
    return Table(f"{title}, {left} more in differences.csv" if left else title, columns, tuple(rows))


def report_text(report: Report, form: str, most: int | None = None) -> str:
    """The report in one of `FORMATS`; CSV has the figures only."""
    if form == "json":
        return report_json(report)
    if form == "csv":
        return table_csv(report.figures_in_full())
    write = {"text": table_text, "markdown": table_markdown, "latex": table_latex}[form]
    head = {"text": "", "markdown": f"# {report.results.experiment.name}\n\n", "latex": "% needs \\usepackage{booktabs}\n"}[form]
    return head + tables_as(write, report.tables(most))


def report_json(report: Report) -> str:
    """Everything, as JSON."""
    results = report.results
    data: dict[str, Any] = {
        "experiment": results.experiment.name,
        "made_from": dict(results.provenance),
        "variants": {each.name: described(each.rules) for each in results.experiment.variants},
        "figures": [
            {
                "variant": each.variant,
                "category": each.category,
                **asdict(each.counts),
                **{name: {"value": value, "interval": interval} for name, (value, interval) in each.values.items()},
            }
            for each in report.figures
        ],
        "agreement": [dict(zip(report.agreement_in_full().columns, row, strict=True)) for row in report.agreement_in_full().rows],
        "tests": [asdict(test) for test in report.tests],
        "cost": [dict(zip(report.cost_table().columns, row, strict=True)) for row in report.cost_table().rows],
        "elements": [asdict(each) for each in report.elements],
        "rows": [asdict(each) for each in report.rows],
    }
    return json_text(data, 1)


def report_files(report: Report) -> dict[str, str]:
    """The files of a report, by name."""
    tables = {
        "figures.csv": report.figures_in_full(),
        "agreement.csv": report.agreement_in_full(),
        "tests.csv": report.tests_in_full(),
        "differences.csv": report.elements_table(),
        "rows.csv": report.rows_table(),
        "cost.csv": report.cost_table(),
        "components.csv": report.components_table(),
    }
    texts = {name: table_csv(table) for name, table in tables.items()}
    most = 50
    return {
        **texts,
        "report.md": report_text(report, "markdown", most),
        "report.tex": report_text(report, "latex", most),
        "results.json": report_json(report),
    }
