"""The rules of systems. `systems/*.dl` have cases, see `rule_cases.py`, with the shorthand of `checks/shorthand.dl`."""

from __future__ import annotations

import shutil
from collections import Counter
from pathlib import Path

import pytest
from rule_cases import Case, cases_in, check_cases, evaluated, expectations, nothing, program_of, unwanted, whole

from rosarch.datalog.files.facts import show_cell
from rosarch.datalog.inspection.rule_coverage import Collector
from rosarch.datalog.language.errors import Location

HERE = Path(__file__).parent
CASES = [case for path in sorted((HERE / "systems").glob("*.dl")) for case in cases_in(path)]
CHECK_CASES = check_cases()


def rows(case: Case, relations: list[str], engine: str) -> dict[str, list[str]]:
    result = evaluated(case, relations) if engine == "embedded" else program_of(case).evaluate({}, engine=engine, keep=relations)
    return {name: sorted(", ".join(map(show_cell, row)) for row in result.rows(name)) for name in relations}


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_case(case: Case) -> None:
    expected, without = expectations(case), unwanted(case)
    assert expected
    assert len(nothing(case)) == len(without) + sum(not found for found in expected.values())
    actual = rows(case, list({*expected, *(relation for relation, _ in without)}), "embedded")
    assert {relation: actual[relation] for relation in expected} == expected
    assert [row for relation, pattern in without for row in actual[relation] if pattern.fullmatch(row)] == []


@pytest.mark.skipif(shutil.which("souffle") is None, reason="there is no souffle on PATH")
@pytest.mark.parametrize("case", [*CASES, *CHECK_CASES], ids=lambda case: f"{case.path.parent.name}/{case.id}")
def test_souffle_derives_the_same(case: Case) -> None:
    relations = [case.path.stem.replace("-", "_"), "port_name", "connected"] if case in CHECK_CASES else list(expectations(case))
    assert rows(case, relations, "souffle") == rows(case, relations, "embedded")


@pytest.mark.slow
def test_every_clause_fires_in_some_case() -> None:
    """Those of `rules/system`, each alternative by itself, in one of the components that it is instantiated in."""
    collector = Collector(whole())
    clauses = Counter(clause_of(rule.clause.location, rule.clause.head.name) for rule in collector.all)
    for case in (*CASES, *CHECK_CASES):
        collector.add(evaluated(case, "all"))
    unfired = Counter(clause_of(clause.location, clause.relation) for clause in collector.coverage().unfired)
    assert [clause for clause, count in unfired.items() if "/rules/system/" in clause and count == clauses[clause]] == []


def clause_of(location: Location, relation: str) -> str:
    return f"{location.path}:{location.line}:{location.column} {relation.rpartition('.')[2]}"
