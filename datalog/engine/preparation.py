"""From a syntax tree to checked clauses: components, records, witnesses, inlining, checks, in this order."""

from __future__ import annotations

from dataclasses import replace

from rosarch.datalog.engine.compile import eqrel_clauses
from rosarch.datalog.language.anonymous_records import resolve_records
from rosarch.datalog.language.components import instantiate
from rosarch.datalog.language.errors import Report
from rosarch.datalog.language.inlining import check_cycles, inline_clauses, inlined_relations
from rosarch.datalog.language.semantics import CheckResult, check
from rosarch.datalog.language.syntax import Relation, Unit
from rosarch.datalog.language.witness import ground_witnesses


def prepare(unit: Unit, report: Report, bits: int = 32) -> tuple[CheckResult, int]:
    """The checked program, and how many of its clauses are written rather than made by a qualifier.

    Raises DatalogError with all errors found. `bits` is the width of numbers.
    """
    unit = instantiate(unit, report)
    unit.clauses = [ground_witnesses(c) for clause in unit.clauses for c in resolve_records(clause)]
    excluded = {name for pragma in unit.pragmas if pragma.key == "inline-exclude" for name in pragma.value.split(",")}
    limits = {d.relation: int(n) for d in unit.directives if d.kind == "limitsize" and (n := dict(d.params).get("n", "")).isdigit()}
    unit.relations = [replace(r, limit=limits[r.name]) if r.name in limits else r for r in unit.relations]
    unit.relations = [r if _inlined(r, excluded) else replace(r, qualifiers=r.qualifiers - {"inline"}) for r in unit.relations]
    check_cycles(unit.relations, unit.clauses, report)
    names = inlined_relations(unit.relations, unit.clauses)
    if names:
        check(unit, report, bits)  # so that messages speak of the clauses as written
        later = Report(report.sources)
        unit.clauses = [c for clause in inline_clauses(names, unit.clauses, later) for c in resolve_records(clause)]
        later.raise_errors()
        unit.relations = [replace(r, qualifiers=r.qualifiers - {"inline"}) if r.name in names else r for r in unit.relations]
        return _checked(unit, later, bits)
    return _checked(unit, report, bits)


def _inlined(relation: Relation, excluded: set[str]) -> bool:
    return "no_inline" not in relation.qualifiers and relation.name not in excluded


def _checked(unit: Unit, report: Report, bits: int) -> tuple[CheckResult, int]:
    written = len(unit.clauses)
    for relation in unit.relations:
        if "eqrel" in relation.qualifiers and len(relation.attributes) == 2:
            unit.clauses.extend(eqrel_clauses(relation))
    return check(unit, report, bits), written
