"""The rules of systems. `systems/*.dl` are facts, with the shorthand of `checks/shorthand.dl`.

`// expect: relation(a, b)` is a row that must come out, and all rows of a relation that is named so are told; records are written `[a, b, c]`.
`// none: relation` names one that must be empty.
"""

from __future__ import annotations

import re
import shutil
from collections import Counter
from pathlib import Path

import pytest
from system_cases import evaluated, program_of, whole

from rosarch.datalog.files.facts import show_cell
from rosarch.datalog.inspection.rule_coverage import Collector
from rosarch.datalog.language.errors import Location

HERE = Path(__file__).parent
CASES = sorted((HERE / "systems").glob("*.dl"))
CHECK_CASES = sorted((HERE / "checks").glob("*/*.dl"))
EXPECT = re.compile(r"^// expect: (\w+)\((.*)\)$", re.MULTILINE)
NONE = re.compile(r"^// none: (\w+)$", re.MULTILINE)


def expectations(case: Path) -> dict[str, list[str]]:
    text = case.read_text(encoding="utf-8")
    found: dict[str, list[str]] = {name: [] for name in NONE.findall(text)}
    for name, row in EXPECT.findall(text):
        found.setdefault(name, []).append(row)
    return {name: sorted(rows) for name, rows in found.items()}


def rows(case: Path, relations: list[str], engine: str) -> dict[str, list[str]]:
    result = evaluated(case, relations) if engine == "embedded" else program_of(case).evaluate({}, engine=engine, keep=relations)
    return {name: sorted(", ".join(map(show_cell, row)) for row in result.rows(name)) for name in relations}


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.stem)
def test_case(case: Path) -> None:
    expected = expectations(case)
    assert expected
    assert rows(case, list(expected), "embedded") == expected


@pytest.mark.skipif(shutil.which("souffle") is None, reason="there is no souffle on PATH")
@pytest.mark.parametrize("case", [*CASES, *CHECK_CASES], ids=lambda case: f"{case.parent.name}/{case.stem}")
def test_souffle_derives_the_same(case: Path) -> None:
    relations = [case.parent.name.replace("-", "_"), "port_name", "connected"] if case in CHECK_CASES else list(expectations(case))
    assert rows(case, relations, "souffle") == rows(case, relations, "embedded")


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
