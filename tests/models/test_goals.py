"""Which action servers may reject goals."""

from __future__ import annotations

from pathlib import Path

from node_package import ROS2, node_model


def test_a_server_that_returns_reject_somewhere_may_reject_goals(tmp_path: Path) -> None:
    source = (Path(__file__).parent / "goals/server.cpp").read_text(encoding="utf-8")
    model = node_model(tmp_path, source, (*ROS2, "rclcpp_action", "example_interfaces"))
    names = {port.id: port.name for port in model.ports}
    assert [names[str(port)] for trait in model.traits if trait.name == "rejects_goals" for port in trait.values] == ["work"]
