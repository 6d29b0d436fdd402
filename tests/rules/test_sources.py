"""Sources of `sources/` that say in comments what is expected of them: one extraction for all, each a component of its own.

A file `<subject>_<what>.cpp` (or `.py`), or a package of `packages/`, is about that subject of `rules/core`, or about checks of the systems that the
launch files of the package start. Those of `hints/` are told hints.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path

import pytest

from rosarch.cli.commands.rules_test import systems_of
from rosarch.cli.questions import Reading
from rosarch.evaluation.expectations.alone import Alone
from rosarch.evaluation.expectations.cases import find_cases
from rosarch.evaluation.expectations.run import FileOutcome, Running, run_cases
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


@pytest.fixture(scope="module")
def outcomes() -> dict[str, FileOutcome]:
    """What became of each file."""
    found = {}
    for folder, rules in FOLDERS.items():
        systems = systems_of(rules, Reading(jobs=1)) if folder == "packages" else partial(Alone, rules=rules, engine="embedded")
        how = Running(rules, systems, jobs=1)
        files = [file for case in run_cases(find_cases([HERE / folder]).cases, how) for file in case.files]
        found.update({str(file.path.relative_to(HERE)): file for file in files})
    return found


@pytest.mark.parametrize("name", NAMES)
def test_expectations_are_met(outcomes: dict[str, FileOutcome], name: str) -> None:
    assert outcomes[name].expected > 0
    assert not outcomes[name].unmet, file_text(outcomes[name])
