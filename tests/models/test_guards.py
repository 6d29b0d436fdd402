"""Guards where functions call each other in circles."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import AbstractContextManager
from typing import Any

import pytest

from rosarch.base.logic import TRUE
from rosarch.models.guards import MOST_WAYS, Guards, Way
from rosarch.models.normal import folded, truth_of

EMPTY = (
    "node_text",
    "silent_condition",
    "loop_condition",
    "stable_condition",
    "settled_local",
    "switch_case",
    "activity_part",
    "activity_enters",
    "activity",
)


def test_ways_through_circles_of_calls_are_not_all_walked(at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    """Thirteen functions that all call each other have more than six thousand million ways."""
    functions = [f"f{number}" for number in range(13)]
    calls = [(callee, f"{caller} B0", "", "always", "") for callee in functions for caller in functions if caller != callee]
    steps = [*calls, *((f"{function} B0", function, "", "", "") for function in functions)]
    relations = dict.fromkeys(EMPTY, ()) | {"node_block": [("send", "f0 B0")], "guard_step": steps}
    relations["activity_enters"] = [("callback", function) for function in functions]
    with at_most(20):
        assert Guards(relations, {}).guard("callback", "send") == TRUE


def test_of_very_many_ways_none_gives_a_value() -> None:
    """Each of many calls gives the parameter another value: beyond a number, it stays the parameter."""

    def ways(count: int) -> list[Way]:
        calls = [f"call{number}" for number in range(count)]
        relations: dict[str, Iterable[Any]] = dict.fromkeys(EMPTY, ()) | {
            "node_block": [("assignment", "set B0"), *((call, "run B0") for call in calls)],
            "node_text": [("x", "x"), *((f"{call}:1", str(number)) for number, call in enumerate(calls))],
            "guard_step": [
                ("set B0", "set", "", "", ""),
                ("run B0", "run", "", "", ""),
                *(("set", "run B0", "", "always", "") for _ in calls),
            ],
            "activity_enters": [("run", "set"), ("run", "run")],
            "entered_by": [("set", call, "run B0") for call in calls],
            "argument_given": [(call, "set", "x", f"{call}:1") for call in calls],
            "own_name": [("set", "x")],
        }
        return Guards(relations, {}).ways("run", "assignment", "x")

    assert [way.value for way in ways(3)] == ["0", "1", "2"]
    assert len(ways(MOST_WAYS)) == MOST_WAYS
    assert [way.value for way in ways(MOST_WAYS + 1)] == ["x"]


def test_decisions_one_after_the_other() -> None:
    """A function with a thousand of them is no circle."""
    steps = [(f"f B{number}", f"f B{number + 1}", f"choice{number}", "true", "") for number in range(1000)]
    relations = dict.fromkeys(EMPTY, ()) | {"node_block": [("send", "f B0")], "guard_step": [*steps, ("f B1000", "f", "", "", "")]}
    relations["activity_enters"] = [("callback", "f")]
    assert Guards(relations, {}).guard("callback", "send") == TRUE


@pytest.mark.parametrize(
    ("condition", "holds"),
    [
        ("Mode::RUN == Mode::RUN", True), ("Mode::RUN == Mode::IDLE", False), ("Mode::RUN != Mode::IDLE", True), ("3 == 4", False), ("True", True),
        ("RUN == IDLE", False), ("kRun == kIdle", False), ("Fast == Slow", None), ("mode == Mode::RUN", None), ("3 < 4", None),
        ("LIMIT == 3", None), ("a && 3 == 4", False), ("a || 3 == 3", True), ("a && 3 == 3", None),
    ],
)  # fmt: skip
def test_constants_decide_and_names_that_may_be_variables_do_not(condition: str, holds: bool | None) -> None:
    assert truth_of(condition) is holds


@pytest.mark.parametrize(
    ("condition", "left"),
    [
        ("!(Mode::RUN == Mode::RUN && ready_)", "!ready_"), ("!(Mode::RUN == Mode::IDLE && ready_)", "true"),
        ("ready_ && (Mode::RUN == Mode::IDLE || set_)", "ready_ && set_"), ("!(ready_ && set_)", "!(ready_ && set_)"),
    ],
)  # fmt: skip
def test_what_constants_decide_is_no_part_of_a_condition(condition: str, left: str) -> None:
    assert folded(condition) == left
