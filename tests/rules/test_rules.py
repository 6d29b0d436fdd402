"""The rules of components. `components/*.dl` have cases, see `rule_cases.py`, with the shorthand of `components/shorthand.dl`.

A folder `<area>/<case>/` with `facts/*.facts`, `expected/<relation>.csv` and a `program.dl` is about some files of rules alone. Only the relations
that have a file are compared. Rows are tab-separated and sorted, records are written `[a, b, c]`.
"""

from __future__ import annotations

import shutil
from functools import cache
from pathlib import Path

import pytest
from rule_cases import Case, cases_in, component_cases, component_facts, expectations

from rosarch.datalog import Program, load_program
from rosarch.datalog.files.facts import show_cell
from rosarch.extractor.manifest import rules_folder
from rosarch.rule_programs.sets import model_program

HERE = Path(__file__).parent
CASES = component_cases()
FOLDERS = sorted(folder.parent for folder in HERE.glob("*/*/expected"))


@cache
def program_of(path: Path) -> Program:
    return load_program(path)


def rows(case: Case, engine: str) -> dict[str, list[str]]:
    """The rows of the relations that a case names."""
    relations = list(expectations(case))
    keep = "all" if engine == "embedded" else relations
    result = program_of(rules_folder() / "component.dl").evaluate(component_facts(case), engine=engine, keep=keep)
    return {name: sorted(", ".join(map(show_cell, row)) for row in result.rows(name)) for name in relations}


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_case(case: Case) -> None:
    assert expectations(case)
    assert rows(case, "embedded") == expectations(case)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_what_models_are_made_of_is_derived_on_demand(case: Case) -> None:
    whole, demanded = program_of(rules_folder() / "component.dl"), model_program()
    facts = component_facts(case)
    expected, actual = whole.evaluate(facts), demanded.evaluate(facts)
    assert demanded.outputs
    assert {name: actual.rows(name) for name in demanded.outputs} == {name: expected.rows(name) for name in demanded.outputs}


@pytest.mark.skipif(shutil.which("souffle") is None, reason="there is no souffle on PATH")
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_case_with_souffle(case: Case) -> None:
    assert rows(case, "souffle") == expectations(case)


def of_folder(case: Path, engine: str) -> tuple[dict[str, list[str]], dict[str, list[str]]]:
    """Expected and actual lines of the relations that a folder names."""
    expected = {path.stem: path.read_text(encoding="utf-8").splitlines() for path in sorted((case / "expected").glob("*.csv"))}
    result = program_of(case / "program.dl").evaluate(case / "facts", engine=engine, keep=list(expected))
    return expected, {name: sorted("\t".join(map(show_cell, row)) for row in result.rows(name)) for name in expected}


@pytest.mark.parametrize("case", FOLDERS, ids=lambda case: case.name)
def test_folder(case: Path) -> None:
    expected, actual = of_folder(case, "embedded")
    assert expected
    assert actual == expected


@pytest.mark.skipif(shutil.which("souffle") is None, reason="there is no souffle on PATH")
@pytest.mark.parametrize("case", FOLDERS, ids=lambda case: case.name)
def test_folder_with_souffle(case: Path) -> None:
    expected, actual = of_folder(case, "souffle")
    assert actual == expected


@pytest.mark.parametrize("case", FOLDERS, ids=lambda case: case.name)
def test_folder_is_well_formed(case: Path) -> None:
    """Every fact file belongs to a relation of the program, every expected file is sorted and without duplicates."""
    assert {path.stem for path in (case / "facts").iterdir()} <= set(program_of(case / "program.dl").relations)
    for path in (case / "expected").iterdir():
        lines = path.read_text(encoding="utf-8").splitlines()
        assert lines == sorted(set(lines)), path.name


def test_there_are_cases_of_every_area() -> None:
    areas = {case.path.stem for case in CASES}
    assert areas >= {"calls", "definitions", "feasibility", "handles", "names", "ports", "reachability", "types", "unknown", "values"}


def test_every_file_is_read() -> None:
    """Cases of systems, checks and components are in files, and each file has some."""
    for folder in ("systems", "checks", "components"):
        files = [path for path in (HERE / folder).iterdir() if path.name != "shorthand.dl"]
        assert [path.name for path in files if path.suffix != ".dl" or not cases_in(path)] == []
