"""The rules of systems. `systems/*.dl` have cases: facts, with the shorthand of `checks/shorthand.dl`, below lines `// case: name`.

`// expect: relation(a, b)` is a row that must come out, and all rows of a relation that is named so are told; records are written `[a, b, c]`.
`// none: relation` names one that must be empty, `// none: relation("a", _); ...` rows that must not be there.
"""

from __future__ import annotations

import re
import shutil
from collections import Counter
from pathlib import Path

import pytest
from system_cases import Case, cases_in, check_cases, evaluated, program_of, whole

from rosarch.datalog.files.facts import show_cell
from rosarch.datalog.inspection.rule_coverage import Collector
from rosarch.datalog.language.errors import Location

HERE = Path(__file__).parent
CASES = [case for path in sorted((HERE / "systems").glob("*.dl")) for case in cases_in(path)]
CHECK_CASES = check_cases()
EXPECT = re.compile(r"^// expect: (\w+)\((.*)\)$", re.MULTILINE)
NONE = re.compile(r"^// none: (.*)$", re.MULTILINE)
ATOM = re.compile(r"(\w+)\((.*)\)")


def expectations(case: Case) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {name: [] for name in nothing(case) if name.isidentifier()}
    for name, row in EXPECT.findall(case.text):
        found.setdefault(name, []).append(row)
    return {name: sorted(rows) for name, rows in found.items()}


def nothing(case: Case) -> list[str]:
    return [each for line in NONE.findall(case.text) for each in line.split("; ")]


def unwanted(case: Case) -> list[tuple[str, re.Pattern[str]]]:
    """Relations, with what rows they must not have."""
    atoms = [match.groups() for match in map(ATOM.fullmatch, nothing(case)) if match]
    cells = [(name, arguments.replace('"', "").split(", ")) for name, arguments in atoms]
    return [(name, re.compile(", ".join("[^,]*" if cell == "_" else re.escape(cell) for cell in row))) for name, row in cells]


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
