"""Which action servers may reject goals."""

from __future__ import annotations

import shutil
from pathlib import Path

from rosarch.analysis.components import analyze
from rosarch.analysis.method import Method
from rosarch.extractor.settings import Settings

CMAKE = """cmake_minimum_required(VERSION 3.8)
project(node)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(rclcpp_action REQUIRED)
find_package(example_interfaces REQUIRED)
add_executable(node server.cpp)
ament_target_dependencies(node rclcpp rclcpp_action example_interfaces)
ament_package()
"""
PACKAGE = """<package format="3"><name>node</name><version>0.0.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>l</license><buildtool_depend>ament_cmake</buildtool_depend>
<depend>rclcpp</depend><depend>rclcpp_action</depend><depend>example_interfaces</depend></package>
"""


def test_a_server_that_returns_reject_somewhere_may_reject_goals(tmp_path: Path) -> None:
    shutil.copy(Path(__file__).parent / "goals/server.cpp", tmp_path)
    (tmp_path / "CMakeLists.txt").write_text(CMAKE)
    (tmp_path / "package.xml").write_text(PACKAGE)
    (model,) = analyze(tmp_path, method=Method(sources=Settings(jobs=1))).models
    names = {port.id: port.name for port in model.ports}
    assert [names[str(port)] for trait in model.traits if trait.name == "rejects_goals" for port in trait.values] == ["work"]
