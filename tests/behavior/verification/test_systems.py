"""Small systems whose answers are known by reasoning, asked of every checker and of the search for counterexamples."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hand_made import load, system_of

from rosarch.base.logic import All
from rosarch.behavior.composition.components import component
from rosarch.behavior.composition.inputs import Inputs
from rosarch.behavior.composition.scenario import read_scenario
from rosarch.behavior.verification import spin, storm
from rosarch.behavior.verification.check import HOLDS, POSSIBLE, VIOLATED, model_for, verify
from rosarch.behavior.verification.explorer import violation
from rosarch.behavior.verification.properties import read_properties
from rosarch.models.machine.logic import BOOLEAN

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


@pytest.mark.slow
@pytest.mark.skipif(not spin.is_installed(), reason=spin.HINT)
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_spin_agrees(file: Path) -> None:
    """All properties in one model, that of them together, since most of the time it takes is that of the C compiler."""
    system, properties, inputs, verdicts = _case(file)
    formulas = {item.name: item.formula for item in properties}
    together = model_for(system, All(tuple(formulas.values())), inputs)
    found = spin.check_all(together, list(formulas.values()), timeout=60, memory=1024)
    assert {name: one.holds for name, one in zip(formulas, found, strict=True)} == {name: verdicts[name] == HOLDS for name in formulas}


@pytest.mark.slow
@pytest.mark.skipif(not spin.is_installed(), reason=spin.HINT)
@pytest.mark.parametrize(
    ("traits", "verdict"),
    [
        ({}, HOLDS),
        ({"changed_at_once": [["Guard::stopped_", "guard.cpp:20", "guard.cpp:20"]]}, POSSIBLE),
        ({"may_be_missed": [["guard.cpp:10"]]}, POSSIBLE),
        ({"sent_by_several": [["p2"]]}, POSSIBLE),
        ({"changed_by_several": [["Guard::stopped_"]]}, POSSIBLE),
    ],
    ids=["one_at_a_time", "at_once", "missed", "sent_by_several", "changed_by_several"],
)
def test_nothing_is_proved_of_reactions_that_are_not_as_modelled(traits: dict[str, list[list[str]]], verdict: str) -> None:
    nodes = load(Path(__file__).parent / "systems" / "order.yml")["nodes"]
    nodes["guard"]["traits"] |= traits
    system = system_of(nodes)
    (found,) = verify(system, read_properties("p: always (sent(/halt) -> guard.stopped_)\n", "properties", system), Inputs(), "spin")
    assert found.verdict == verdict


@pytest.mark.slow
@pytest.mark.skipif(not spin.is_installed(), reason=spin.HINT)
@pytest.mark.parametrize(
    ("formula", "unseen", "traits"),
    [
        ("always (sent(/halt) -> guard.stopped_)", {"opened": ["/halt"]}, {}),
        ("always (sent(/halt) -> guard.stopped_)", {"condition": "$(arg guarded)"}, {}),
        ("response(sent(/stop), received(guard, /stop))", {}, {"unheard": [["p1", "what holds it goes out of scope"]]}),
    ],
    ids=["sender_not_seen", "started_on_condition", "not_heard"],
)
def test_nothing_is_proved_of_what_may_be_otherwise(formula: str, unseen: dict[str, Any], traits: dict[str, list[list[str]]]) -> None:
    nodes = load(Path(__file__).parent / "systems" / "order.yml")["nodes"]
    for system, verdict in ((system_of(nodes), HOLDS), (system_of(_with(nodes, traits), **unseen), POSSIBLE)):
        (found,) = verify(system, read_properties(f"p: {formula}\n", "properties", system), Inputs(), "spin")
        assert found.verdict == verdict


@pytest.mark.slow
@pytest.mark.skipif(not spin.is_installed(), reason=spin.HINT)
def test_nothing_is_taken_for_granted_of_a_timer_that_would_do_nothing() -> None:
    door = {
        "ports": [{"id": "p1", "kind": "subscriber", "name": "/call", "queue": 1}],
        "state_variables": [{"name": "Door::open_", "type": "bool", "initial": "false", "at": "door.cpp:3"}],
        "transitions": [
            {"variable": "Door::open_", "trigger": ["timer"], "guard": "open_", "value": "false", "at": "door.cpp:9"},
            {"variable": "Door::open_", "trigger": ["p1"], "value": "true", "at": "door.cpp:12"},
        ],
    }
    system = system_of({"door": door})
    properties = read_properties("shut: left(!door.open_)\nopen: left(door.open_)\n", "properties", system)
    assert [found.verdict for found in verify(system, properties, Inputs(), "spin")] == [VIOLATED, POSSIBLE]


FILTER = {
    "ports": [
        {"id": "p1", "kind": "subscriber", "name": "/in", "queue": 1}, {"id": "p2", "kind": "publisher", "name": "/out", "queue": 1},
        {"id": "p3", "kind": "publisher", "name": "/auto", "queue": 1}, {"id": "p4", "kind": "publisher", "name": "/nth", "queue": 1},
    ],
    "traits": {"keeps_value_of": [["active_", "~active"], ["mode_", "~mode"], ["skip_", "~skip"]]},
    "state_variables": [{"name": "Filter::left_", "type": "int", "initial": "skip_", "at": "filter.h:3"}],
    "transitions": [
        {"variable": "Filter::left_", "trigger": ["p1"], "value": "--left_", "at": "filter.cpp:12"},
        {"variable": "Filter::left_", "trigger": ["p1"], "guard": "--left_ == 0", "value": "skip_", "at": "filter.cpp:13"},
    ],
    "reactive": [
        {"input": "p1", "output": "p2", "when": "active_", "must": False, "at": ["filter.cpp:10"]},
        {"input": "p1", "output": "p3", "when": 'mode_ == "auto"', "must": False, "at": ["filter.cpp:11"]},
        {"input": "p1", "output": "p4", "when": "--left_ == 0", "must": False, "at": ["filter.cpp:14"]},
    ],
}  # fmt: skip


@pytest.mark.parametrize(
    ("settings", "first"), [({"~enabled": ("bool", "true")}, ("true",)), ({"~enabled": ("string", "on")}, BOOLEAN), ({}, BOOLEAN)]
)
def test_state_begins_with_what_its_parameter_is_set_to(settings: dict[str, tuple[str, str]], first: tuple[str, ...]) -> None:
    document = {
        "ports": FILTER["ports"],
        "traits": {"begins_with_value_of": [["Filter::enabled_", "~enabled"]]},
        "state_variables": [{"name": "Filter::enabled_", "type": "bool", "initial": "false", "from_param": "~enabled", "at": "filter.h:3"}],
        "transitions": [{"variable": "Filter::enabled_", "trigger": ["p1"], "value": "false", "at": "filter.cpp:12"}],
        "reactive": [{"input": "p1", "output": "p2", "when": "enabled_", "must": False, "at": ["filter.cpp:10"]}],
    }
    assert sorted(component(document, settings).variables["Filter::enabled_"].initial) == sorted(first)


@pytest.mark.slow
@pytest.mark.skipif(not spin.is_installed(), reason=spin.HINT)
@pytest.mark.parametrize(
    ("settings", "verdicts"),
    [
        ([("~active", "bool", "false"), ("~mode", "string", "manual"), ("~skip", "int", "3")], (HOLDS, HOLDS, HOLDS)),
        ([("~active", "bool", "true"), ("~mode", "string", "auto"), ("~skip", "int", "1")], (VIOLATED, VIOLATED, VIOLATED)),
        ([("~active", "string", "false")], (POSSIBLE, POSSIBLE, POSSIBLE)),
    ],
    ids=["off", "on", "not_known"],
)
def test_parameters_of_nodes_decide(settings: list[tuple[str, str, str]], verdicts: tuple[str, ...]) -> None:
    system = system_of({"filter": FILTER}, settings={"filter": settings})
    gap = "always (sent(/nth) -> next (received(filter, /in) -> !sent(/nth)))"
    properties = read_properties(f"a: absence(sent(/out))\nb: absence(sent(/auto))\nc: {gap}\n", "properties", system)
    assert tuple(found.verdict for found in verify(system, properties, Inputs(), "spin")) == verdicts


def _with(nodes: dict[str, Any], traits: dict[str, list[list[str]]]) -> dict[str, Any]:
    return {"guard": {**nodes["guard"], "traits": {**nodes["guard"]["traits"], **traits}}}
