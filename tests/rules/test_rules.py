"""Drop-in tests of rules: a folder `<area>/<case>/` with `facts/*.facts` and `expected/<relation>.csv`.

A case may bring a `program.dl` of its own; without one the rules of a component are evaluated. Only the relations that
have a file are compared. Rows are tab-separated and sorted, records are written `[a, b, c]`. A file `known_failure.txt`
tells why a case fails today; once it passes, the test asks to remove that file.
"""

from __future__ import annotations

import shutil
from functools import lru_cache
from pathlib import Path

import pytest

from rosarch.datalog import Program, load_program
from rosarch.datalog.files.facts import show_cell
from rosarch.extractor.manifest import rules_folder
from rosarch.rule_programs.sets import model_program

HERE = Path(__file__).parent
CASES = sorted(folder.parent for folder in HERE.glob("*/*/expected"))
NAMES = [str(case.relative_to(HERE)) for case in CASES]


def _parameter(case: Path) -> object:
    reason = case / "known_failure.txt"
    marks = [pytest.mark.xfail(strict=True, reason=reason.read_text(encoding="utf-8").strip())] if reason.is_file() else []
    return pytest.param(case, id=str(case.relative_to(HERE)), marks=marks)


PARAMETERS = [_parameter(case) for case in CASES]


@lru_cache
def program_of(path: Path) -> Program:
    return load_program(path)


def evaluate(case: Path, engine: str) -> tuple[dict[str, list[str]], dict[str, list[str]]]:
    """Expected and actual lines of the relations that the case names."""
    own = case / "program.dl"
    expected = {path.stem: path.read_text(encoding="utf-8").splitlines() for path in sorted((case / "expected").glob("*.csv"))}
    program = program_of(own if own.is_file() else rules_folder() / "component.dl")
    keep = "all" if engine == "embedded" else list(expected)
    result = program.evaluate(case / "facts", engine=engine, keep=keep)
    return expected, {name: sorted("\t".join(map(show_cell, row)) for row in result.rows(name)) for name in expected}


@pytest.mark.parametrize("case", PARAMETERS)
def test_case(case: Path) -> None:
    expected, actual = evaluate(case, "embedded")
    assert expected
    assert actual == expected


@pytest.mark.parametrize(
    "case", [case for case in CASES if not (case / "program.dl").is_file()], ids=lambda case: str(case.relative_to(HERE))
)
def test_what_models_are_made_of_is_derived_on_demand(case: Path) -> None:
    whole, demanded = program_of(rules_folder() / "component.dl"), model_program()
    expected = whole.evaluate(case / "facts")
    actual = demanded.evaluate(case / "facts")
    assert demanded.outputs
    assert {name: actual.rows(name) for name in demanded.outputs} == {name: expected.rows(name) for name in demanded.outputs}


@pytest.mark.skipif(shutil.which("souffle") is None, reason="there is no souffle on PATH")
@pytest.mark.parametrize("case", PARAMETERS)
def test_case_with_souffle(case: Path) -> None:
    expected, actual = evaluate(case, "souffle")
    assert actual == expected


@pytest.mark.parametrize("case", CASES, ids=NAMES)
def test_case_is_well_formed(case: Path) -> None:
    """Every fact file belongs to an extracted relation, every expected file is sorted and without duplicates."""
    from rosarch.extractor.facts import schema

    relations = set(program_of(case / "program.dl").relations) if (case / "program.dl").is_file() else set(schema())
    assert {path.stem for path in (case / "facts").iterdir()} <= relations
    for path in (case / "expected").iterdir():
        lines = path.read_text(encoding="utf-8").splitlines()
        assert lines == sorted(set(lines)), path.name


def test_there_are_cases_of_every_area() -> None:
    areas = {case.parent.name for case in CASES}
    assert areas >= {"calls", "definitions", "feasibility", "handles", "names", "ports", "reachability", "types", "unknown", "values"}
