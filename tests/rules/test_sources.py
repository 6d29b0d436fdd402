"""Sources of `sources/` that say in comments what is expected of them: one extraction for all, each a component of its own.

A file `<rule file>_<what>.cpp` is about that file of `rules/core`.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.expectations.alone import Alone
from rosarch.expectations.cases import find_cases
from rosarch.expectations.run import FileOutcome, Running, run_cases
from rosarch.models.rule_sets import SHIPPED
from rosarch.reports.expectations import file_text

SOURCES = Path(__file__).parent / "sources"


@pytest.fixture(scope="module")
def outcomes() -> dict[str, FileOutcome]:
    """What became of each file."""
    how = Running(SHIPPED, lambda folder: Alone(folder, SHIPPED, "embedded"), jobs=1)
    return {file.path.name: file for case in run_cases(find_cases([SOURCES]).cases, how) for file in case.files}


@pytest.mark.parametrize("name", sorted(path.name for path in SOURCES.glob("*.cpp")))
def test_expectations_are_met(outcomes: dict[str, FileOutcome], name: str) -> None:
    assert outcomes[name].expected > 0
    assert not outcomes[name].unmet, file_text(outcomes[name])
