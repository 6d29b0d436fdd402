"""Servers of actions: which may reject goals, and what they do for a goal or for the wish to end one."""

from __future__ import annotations

from pathlib import Path

import pytest
from node_package import ROS1, ROS2, node_model

from rosarch.models import formula
from rosarch.models.component import ComponentModel

ACTIONS1 = (*ROS1, "actionlib")
ACTIONS2 = (*ROS2, "rclcpp_action", "example_interfaces")


def _model(folder: Path, source: str, needs: tuple[str, ...]) -> ComponentModel:
    return node_model(folder, (Path(__file__).parent / "goals" / source).read_text(encoding="utf-8"), needs)


def test_a_server_that_returns_reject_somewhere_may_reject_goals(tmp_path: Path) -> None:
    model = _model(tmp_path, "server.cpp", ACTIONS2)
    names = {port.id: port.name for port in model.ports}
    assert [names[str(port)] for trait in model.traits if trait.name == "rejects_goals" for port in trait.values] == ["work"]


@pytest.mark.parametrize(
    ("source", "needs", "changes"),
    [
        ("docking.cpp", ACTIONS1, {("SCAN", "!cancel request"), ("IDLE", "cancel request")}),
        ("motion.cpp", ACTIONS2, {("WANTED", "!cancel request"), ("MOVING", "!cancel request"), ("IDLE", "cancel request")}),
    ],
)
def test_a_request_is_a_goal_or_the_wish_to_end_one(
    tmp_path: Path, source: str, needs: tuple[str, ...], changes: set[tuple[str, str]]
) -> None:
    found = _model(tmp_path, source, needs).behavior.transitions
    assert {(change.value, formula.text(change.guard)) for change in found} == changes
