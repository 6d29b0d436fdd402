"""What goes on at times only: each `switches/*.cpp` says in `// expect:` comments what its component has, and what switches it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rosarch.analysis.components import analyze
from rosarch.analysis.method import Method
from rosarch.extractor.settings import Settings
from rosarch.models import formula
from rosarch.models.switches import Switched

HERE = Path(__file__).parent
NODES = sorted((HERE / "switches").glob("*.cpp"))
MANAGED = {"managed"}


def _files(source: str, *, managed: bool) -> dict[str, str]:
    ros2, ros1 = ("ament_cmake", "rclcpp rclcpp_lifecycle std_msgs"), ("catkin", "roscpp std_msgs")
    tool, needs = ros2 if managed else ros1
    found = "".join(f"find_package({name} REQUIRED)\n" for name in (tool, *needs.split()))
    cmake = f"cmake_minimum_required(VERSION 3.8)\nproject(node)\n{found}add_executable(node node.cpp)\n"
    package = f"""<package format="2"><name>node</name><version>0.0.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>l</license><buildtool_depend>{tool}</buildtool_depend></package>
"""
    return {"node.cpp": source, "CMakeLists.txt": cmake, "package.xml": package}


def _line(each: Switched) -> str:
    ways = []
    for way in each.switches:
        guard = formula.text(way.guard)
        ways.append(f"{way.at.line} {way.to}{' perhaps' * way.perhaps}{f' if {guard}' if guard else ''}")
    return f"{each.at.line} {each.begins}: {', '.join(ways)}"


@pytest.mark.parametrize("node", NODES, ids=lambda node: node.stem)
def test_what_is_on_at_times_is_as_expected(node: Path, tmp_path: Path) -> None:
    source = node.read_text(encoding="utf-8")
    for name, text in _files(source, managed=node.stem in MANAGED).items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    (model,) = analyze(tmp_path, method=Method(sources=Settings(jobs=1))).models
    assert [_line(each) for each in model.behavior.switched] == re.findall(r"^// expect: (.*)$", source, re.MULTILINE)
    names = {port.id: port.name for port in model.ports}
    starts = ", ".join(sorted(f"{names[port]} {place.line} {how}" for port, place, how in model.behavior.starting))
    assert [starts] * bool(starts) == re.findall(r"^// starts: (.*)$", source, re.MULTILINE)
