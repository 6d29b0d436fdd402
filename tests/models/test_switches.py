"""What goes on at times only: each `switches/*.cpp` says in `// expect:` comments what its component has, and what switches it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from node_package import ROS1, ROS2, node_model

from rosarch.models import formula
from rosarch.models.switches import Switched

HERE = Path(__file__).parent
NODES = sorted((HERE / "switches").glob("*.cpp"))
MANAGED = (*ROS2, "rclcpp_lifecycle")


def _line(each: Switched) -> str:
    ways = []
    for way in each.switches:
        guard = formula.text(way.guard)
        ways.append(f"{way.at.line} {way.to}{' perhaps' * way.perhaps}{f' if {guard}' if guard else ''}")
    return f"{each.at.line} {each.begins}: {', '.join(ways)}"


@pytest.mark.parametrize("node", NODES, ids=lambda node: node.stem)
def test_what_is_on_at_times_is_as_expected(node: Path, tmp_path: Path) -> None:
    source = node.read_text(encoding="utf-8")
    model = node_model(tmp_path, source, MANAGED if node.stem == "managed" else ROS1)
    assert [_line(each) for each in model.behavior.switched] == re.findall(r"^// expect: (.*)$", source, re.MULTILINE)
    names = {port.id: port.name for port in model.ports}
    starts = ", ".join(sorted(f"{names[port]} {place.line} {how}" for port, place, how in model.behavior.starting))
    assert [starts] * bool(starts) == re.findall(r"^// starts: (.*)$", source, re.MULTILINE)
