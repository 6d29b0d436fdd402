"""Tests of a variable before and after assignments to it in the same reaction."""

from __future__ import annotations

from typing import Any

import pytest

from rosarch.models.machine.cells import Domains
from rosarch.models.machine.elapsed import with_elapsed
from rosarch.models.machine.reactions import component_steps, courses


def _leaf(line: int, text: str, holds: bool = True) -> dict[str, Any]:
    return {"condition": text, "holds": holds, "at": f"n.cpp:{line}"}


def _guarded(key: str, text: str, *leaves: dict[str, Any]) -> dict[str, Any]:
    return {key: text, f"{key}_tree": {"all": list(leaves)}}


def _assigned(line: int, value: str, guard: str, *leaves: dict[str, Any]) -> dict[str, Any]:
    return {"variable": "N::mode_", "trigger": ["p1"], "value": value, "at": f"n.cpp:{line}", **_guarded("guard", guard, *leaves)}


def _sent(line: int, guard: str, *leaves: dict[str, Any]) -> dict[str, Any]:
    return {"input": "p1", "output": "p2", "must": False, "at": [f"n.cpp:{line}"], **_guarded("when", guard, *leaves)}


IDLE, ARMED = _leaf(10, "mode_ == IDLE"), _leaf(12, "mode_ == ARMED")
ARM = _assigned(11, "ARMED", "mode_ == IDLE", IDLE)


@pytest.mark.parametrize(
    ("transitions", "sent", "sends", "unclear"),
    [
        # if (mode_ == IDLE) mode_ = ARMED;  if (mode_ == ARMED) send();
        ([ARM], _sent(13, "mode_ == ARMED", ARMED), {"IDLE", "ARMED"}, False),
        # if (mode_ == IDLE) mode_ = ARMED;  else if (mode_ == ARMED) send();
        ([ARM], _sent(13, "mode_ != IDLE && mode_ == ARMED", _leaf(10, "mode_ == IDLE", False), ARMED), {"ARMED"}, False),
        # if (mode_ == IDLE) mode_ = ARMED;  if (mode_ == ARMED) { mode_ = RUN; send(); }
        ([ARM, _assigned(13, "RUN", "mode_ == ARMED", ARMED)], _sent(14, "mode_ == ARMED", ARMED), {"IDLE", "ARMED"}, False),
        # if (mode_ == IDLE) { mode_ = ARMED; send(); }
        ([ARM], _sent(12, "mode_ == IDLE", IDLE), {"IDLE"}, False),
        # if (mode_ == IDLE) { mode_ = ARMED; if (mode_ == ARMED) send(); }
        ([ARM], _sent(13, "mode_ == IDLE && mode_ == ARMED", IDLE, ARMED), {"IDLE"}, False),
        # one condition that is tested at two places, before and after
        ([ARM], _sent(13, "mode_ == IDLE || mode_ == ARMED") | {"when_tree": {"any": [IDLE, ARMED]}}, None, True),
    ],
    ids=["tested_again", "else", "assigned_behind", "same_test", "before_and_after", "unclear"],
)
def test_what_a_test_sees(transitions: list[dict[str, Any]], sent: dict[str, Any], sends: set[str] | None, unclear: bool) -> None:
    variable = {"name": "N::mode_", "type": "Mode", "initial": "IDLE", "at": "n.h:3"}
    document = {"state_variables": [variable], "transitions": transitions, "reactive": [sent]}
    steps = component_steps(document, Domains(document))["p1"]
    assert any(step.unclear for step in steps) is unclear
    if sends is not None:
        found = {mode: list(courses(steps, ["N::mode_"], [mode], 10)) for mode in ("IDLE", "ARMED")}
        assert {mode for mode, ways in found.items() if any(way.outputs for way in ways)} == sends


@pytest.mark.parametrize(("guard", "unclear"), [("q.pop() == 1 && q.pop() == 2", True), ("q.pop() == 1 && ready", False)])
def test_a_call_that_gives_another_value_each_time(guard: str, unclear: bool) -> None:
    document = {"reactive": [_sent(11, guard, _leaf(10, guard))], "traits": {"gives_another": [["q.pop()"]]}}
    assert any(step.unclear for step in component_steps(document, Domains(document))["p1"]) is unclear


@pytest.mark.parametrize(("second", "clear"), [("state_ == TURN", True), ("msg->again", False)])
def test_times_that_are_asked_for_in_cases_of_which_one_is_taken(second: str, clear: bool) -> None:
    """In a switch, each case asks for the time since the last change and may change; else the second asks after the first has changed."""

    def rows(first: str, place: str, limit: str, to: str, at: int) -> list[dict[str, Any]]:
        leaves = [
            {"condition": first, "holds": True, "at": place},
            {"condition": f"now() - since_ > {limit}", "holds": True, "at": f"n.cpp:{at}"},
        ]
        guard = {"guard": f"{first} && now() - since_ > {limit}", "guard_tree": {"all": leaves}, "trigger": ["periodic"]}
        change = {"variable": "N::state_", "value": to, "at": f"n.cpp:{at + 1}"}
        return [{**change, **guard}, {"variable": "N::since_", "value": "now()", "at": f"n.cpp:{at + 2}", **guard}]

    node = {
        "state_variables": [
            {"name": "N::state_", "type": "Mode", "initial": "BACK", "at": "n.cpp:1"},
            {"name": "N::since_", "type": "Time", "initial": None, "at": "n.cpp:2"},
        ],
        "transitions": [
            *rows("state_ == BACK", "n.cpp:9", "LONG", "TURN", 10),
            *rows(second, "n.cpp:9" if clear else "n.cpp:19", "SHORT", "BACK", 20),
        ],
        "traits": {"keeps_moment": [["N::since_"]]},
    }
    steps, cells = with_elapsed(node, component_steps(node, Domains(node)))
    assert len(cells) == 2
    assert [step.unclear for step in steps["periodic"]] == [not clear] * 4
