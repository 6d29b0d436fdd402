"""Small systems whose answers are known by reasoning, asked of every checker and of the search for counterexamples."""

from __future__ import annotations

from functools import reduce
from pathlib import Path

import pytest
from hand_made import load, system_of

from rosarch.composition.inputs import Inputs
from rosarch.composition.scenario import read_scenario
from rosarch.verification import ltl, spin, storm
from rosarch.verification.check import HOLDS, model_for, verify
from rosarch.verification.explorer import violation
from rosarch.verification.properties import read_properties

FILES = sorted((Path(__file__).parent / "systems").glob("*.yml"))


def _case(file: Path):
    data = load(file)
    system = system_of(data["nodes"], data.get("unknown"))
    inputs = read_scenario(data["scenario"], "scenario.yml", system).inputs if "scenario" in data else Inputs()
    return system, read_properties(data["properties"], "properties", system), inputs, data["verdicts"]


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_the_search_finds_a_violation_where_there_is_one(file: Path) -> None:
    system, properties, inputs, verdicts = _case(file)
    found = {item.name: violation(model_for(system, item.formula, inputs), item.formula) for item in properties}
    assert {name: lasso is None for name, lasso in found.items()} == {name: verdict == HOLDS for name, verdict in verdicts.items()}


@pytest.mark.skipif(not storm.is_installed(), reason=storm.HINT)
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_storm_agrees(file: Path) -> None:
    system, properties, inputs, verdicts = _case(file)
    found = verify(system, properties, inputs, "storm")
    assert {item.property.name: item.verdict for item in found} == verdicts
    assert all((item.trace is None) is (item.verdict == HOLDS) for item in found)


@pytest.mark.skipif(not spin.is_installed(), reason=spin.HINT)
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_spin_agrees(file: Path) -> None:
    """All properties in one model, that of them together, since most of the time it takes is that of the C compiler."""
    system, properties, inputs, verdicts = _case(file)
    formulas = {item.name: item.formula for item in properties}
    together = model_for(system, reduce(ltl.conjunction, formulas.values()), inputs)
    found = spin.check_all(together, list(formulas.values()), timeout=60, memory=1024)
    assert {name: one.holds for name, one in zip(formulas, found, strict=True)} == {name: verdicts[name] == HOLDS for name in formulas}
