"""From a syntax tree to checked clauses: components, records, witnesses, inlining, checks, in this order."""

from __future__ import annotations

from dataclasses import replace

from .anonymous_records import resolve_records
from .compile import eqrel_clauses
from .components import instantiate
from .errors import Report
from .inlining import inline_clauses, inlined_relations
from .semantics import Checked, check
from .syntax import Unit
from .witness import ground_witnesses


def prepare(unit: Unit, report: Report, bits: int = 32) -> tuple[Checked, int]:
    """The checked program, and how many of its clauses are written rather than made by a qualifier.

    Raises DatalogError with all errors found. `bits` is the width of numbers.
    """
    unit = instantiate(unit, report)
    unit.clauses = [ground_witnesses(c) for clause in unit.clauses for c in resolve_records(clause)]
    names = inlined_relations(unit.relations, unit.clauses)
    if names:
        check(unit, report, bits)  # so that messages speak of the clauses as written
        later = Report(report.sources)
        unit.clauses = inline_clauses(names, unit.clauses, later)
        later.raise_errors()
        unit.relations = [replace(r, qualifiers=r.qualifiers - {"inline"}) if r.name in names else r for r in unit.relations]
        return _checked(unit, later, bits)
    return _checked(unit, report, bits)


def _checked(unit: Unit, report: Report, bits: int) -> tuple[Checked, int]:
    written = len(unit.clauses)
    for relation in unit.relations:
        if "eqrel" in relation.qualifiers and len(relation.attributes) == 2:
            unit.clauses.extend(eqrel_clauses(relation))
    return check(unit, report, bits), written
