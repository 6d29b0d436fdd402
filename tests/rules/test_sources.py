"""Sources of `sources/` that say in comments what is expected of them: one extraction for those about one thing, each a component of its own.

A file `<subject>_<what>.cpp` (or `.py`), or a package of `packages/`, is about that subject of `rules/core`, or about checks of the systems that the
launch files of the package start. Those of `hints/` are told hints.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache, partial
from itertools import groupby
from pathlib import Path

import pytest

from rosarch.analysis.method import Method
from rosarch.cli.commands.rules_test import systems_of
from rosarch.cli.questions import ReadingOptions
from rosarch.evaluation.expectations.alone import Alone
from rosarch.evaluation.expectations.cases import Case, find_cases
from rosarch.evaluation.expectations.run import FileOutcome, Running, run_cases
from rosarch.extractor.settings import Settings
from rosarch.reports.expectations import file_text
from rosarch.rule_programs.sets import SHIPPED, rule_set

HERE = Path(__file__).parent
FOLDERS = {"sources": SHIPPED, "packages": SHIPPED, "hints": rule_set([HERE / "hints" / "hints.dl"])}
NAMES = sorted(
    f"{folder}/{path.relative_to(HERE / folder)}"
    for folder in FOLDERS
    for path in (HERE / folder).rglob("*")
    if path.suffix in (".cpp", ".py") and path.name not in ("setup.py", "__init__.py")
)


def cases(folder: Path) -> Iterator[Case]:
    """The workspaces of a folder, and its single sources by what they are about: as much as one extraction is for."""
    for case in find_cases([folder]).cases:
        if case.sources is None:
            yield case
        for _, sources in groupby(case.sources or (), subject):
            names = {path.name: path for path in sources}
            yield Case(case.root, tuple(names.values()), tuple(each for each in case.expectations if each.marked.path in names))


def subject(path: Path) -> str:
    return path.stem.partition("_")[0]


Outcomes = dict[Path, FileOutcome]


def outcomes(folder: str, case: Case) -> Outcomes:
    """What became of each file of a case."""
    rules = FOLDERS[folder]
    systems = systems_of(rules, ReadingOptions(jobs=1)) if folder == "packages" else partial(Alone, rules=rules, engine="embedded")
    (outcome,) = run_cases([case], Running(systems, Method(rules, sources=Settings(jobs=1))))
    return {file.path: file for file in outcome.files}


@cache
def by_file(folder: str) -> dict[Path, Callable[[], Outcomes]]:
    """What is to be asked for the outcome of a file: each case is run once, when the first of its files is asked about."""
    run = [(case, cache(partial(outcomes, folder, case))) for case in cases(HERE / folder)]
    return {case.root / each.marked.path: outcome for case, outcome in run for each in case.expectations}


@pytest.mark.parametrize("name", NAMES)
def test_expectations_are_met(name: str) -> None:
    path = HERE / name
    outcome = by_file(name.partition("/")[0])[path]()[path]
    assert outcome.expected > 0
    assert not outcome.unmet, file_text(outcome)
