"""Checks, each with cases in which it must fire and cases in which it must stay silent.

`checks/<id>.dl` has its cases: facts, with the shorthand of `checks/shorthand.dl`, below lines `// case: name`. `// expect: message` and, if told,
`// at: path:line` after it are the findings that this check must make there; cases called `silent*` have none. `// fix: path:line: ...` are all
the changes that fix them, as reports show them; `// evidence: path:line: ...`, if told, are all the places that they show beside their own.
Other checks do not count.
"""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

import pytest
from rule_cases import Case, check_cases, facts_and_program

from rosarch.base.places import Place
from rosarch.extractor.manifest import rules_folder
from rosarch.findings.model import Finding
from rosarch.findings.of_systems import findings
from rosarch.models.system.build import evaluate
from rosarch.rule_programs.checks import check_files, read_check
from rosarch.rule_programs.sets import SystemRules

CASES = check_cases()
FIX = re.compile(r"^// fix: (.*)$", re.MULTILINE)
EVIDENCE = re.compile(r"^// evidence: (.*)$", re.MULTILINE)
EXPECT = re.compile(r"^// expect: (.*)(?:\n// at: (.*))?$", re.MULTILINE)


@lru_cache
def found(case: Case) -> list[Finding]:
    check = read_check(rules_folder() / "checks" / case.path.name)
    facts, program = facts_and_program(case)
    rules = SystemRules(program, (check,))
    result = evaluate(rules, facts, keep=("place",))
    places = {row[0]: Place(*row[1:]) for row in result.rows("place")}
    return findings(rules.checks, result, places, "demo")


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_case(case: Case) -> None:
    expected = EXPECT.findall(case.text)
    assert bool(expected) != case.name.startswith("silent")
    actual = sorted({(finding.message, str(finding.place)) for finding in found(case)})
    assert [message for message, _ in actual] == sorted(message for message, _ in expected)
    told = {message: place for message, place in expected if place}
    assert {message: place for message, place in actual if message in told} == told
    assert sorted({f"{change.place}: {change}" for finding in found(case) for change in finding.fix}) == sorted(FIX.findall(case.text))
    shown = EVIDENCE.findall(case.text)
    assert not shown or sorted(beside(found(case))) == sorted(shown)


def beside(those: list[Finding]) -> list[str]:
    """What findings show beside the places where the faults lie."""
    return [f"{each.place}: {each.text}" for finding in those for each in finding.evidence[1:]]


@pytest.mark.parametrize("path", check_files(), ids=lambda path: path.stem)
def test_every_check_fires_and_stays_silent(path: Path) -> None:
    names = {case.name.partition("_")[0] for case in CASES if case.path.name == path.name}
    assert {"fires", "silent"} <= names
