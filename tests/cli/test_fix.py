"""`rosarch check --fix` and `--diff`: each kind of fix from end to end. What was fixed is not found again."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

MANIFEST = """<package format="3">
  <name>robot</name>
  <version>0.0.0</version>
  <description>A robot.</description>
  <maintainer email="a@example.org">A</maintainer>
  <license>MIT</license>
  <depend>rclcpp</depend>
  <depend>rclcpp_components</depend>
  <test_depend>gtest</test_depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
BUILD = """project(robot)
add_library(filter SHARED filter.cpp)
rclcpp_components_register_nodes(filter "robot::Filter")
add_library(lamp SHARED lamp.cpp)
rclcpp_components_register_nodes(lamp "bot::Lamp")
install(TARGETS filter lamp DESTINATION lib)
install(FILES part.launch.xml p.yaml DESTINATION share/${PROJECT_NAME})
"""
FILTER = """#include <rclcpp/rclcpp.hpp>
#include <tools/tools.hpp>
namespace robot {
class Filter : public rclcpp::Node {
public:
  explicit Filter(const rclcpp::NodeOptions& o) : Node("filter", o) { declare_parameter<double>("max_speed", 1.0); }
};
}
RCLCPP_COMPONENTS_REGISTER_NODE(robot::Filter)
"""
LAMP = """#include <rclcpp/rclcpp.hpp>
namespace robot {
struct Lamp : rclcpp::Node { explicit Lamp(const rclcpp::NodeOptions& o) : Node("lamp", o) {} };
}
RCLCPP_COMPONENTS_REGISTER_NODE(robot::Lamp)
"""
TOP = """<launch>
  <include file="$(find-pkg-share robot)/part.launch.xml">
    <arg name="frme_id" value="x"/>
  </include>
  <node pkg="joy" exec="joy_node" nme="joy" />
  <node pkg="joy" exec="joy_node" name="joy2">
    <param from="$(find-pkg-share robot)/p.yaml"/>
  </node>
</launch>"""
PART = """<launch>
  <arg name="frame_id" default="y"/>
  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">
    <composable_node pkg="robot" plugin="robot:Filter" name="filter">
      <param name="max_sped" value="3.0"/>
    </composable_node>
  </node_container>
</launch>
"""
PARAMS = "joy2:\r\n  ros_parameters:\r\n    deadzone: 0.1\r\n"
OLD_LAUNCH = '<launch>\n  <node pkg="moveit_ros_move_group" type="move_group" name="move_group">\n    {}\n  </node>\n</launch>\n'
OLD_PARAM = '<param name="allowed_goal_duration_margin" value="0.5" />'
FIXES = [  # the file, what is wrong, what becomes of it, and the check
    ("package.xml", "rclcpp_components</depend>\n", "rclcpp_components</depend>\n  <depend>tools</depend>\n", "dependency-not-declared"),
    (
        "package.xml",
        "  <test_depend>gtest</test_depend>\n",
        "  <test_depend>gtest</test_depend>\n  <exec_depend>joy</exec_depend>\n",
        "dependency-not-declared",
    ),
    ("CMakeLists.txt", "bot::Lamp", "robot::Lamp", "class-not-registered"),
    ("top.launch.xml", "frme_id", "frame_id", "argument-not-declared"),
    ("top.launch.xml", "nme=", "name=", "launch-error"),
    ("part.launch.xml", "robot:Filter", "robot::Filter", "missing-component"),
    ("part.launch.xml", "max_sped", "max_speed", "parameter-name-mismatch"),
    ("p.yaml", "ros_parameters", "ros__parameters", "parameter-file-refused"),
]


@pytest.fixture
def ws(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A workspace with all that can be fixed, below the current folder."""
    files = {"package.xml": MANIFEST, "CMakeLists.txt": BUILD, "filter.cpp": FILTER, "lamp.cpp": LAMP}
    files |= {"top.launch.xml": TOP, "part.launch.xml": PART, "p.yaml": PARAMS}
    (tmp_path / "ws" / "robot").mkdir(parents=True)
    for name, text in files.items():
        (tmp_path / "ws" / "robot" / name).write_bytes(text.encode())
    (tmp_path / "ws" / "tools" / "include" / "tools").mkdir(parents=True)
    (tmp_path / "ws" / "tools" / "include" / "tools" / "tools.hpp").write_text("#pragma once\n")
    (tmp_path / "ws" / "tools" / "package.xml").write_text(MANIFEST.replace("robot</name>", "tools</name>"))
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("ROS_PACKAGE_PATH", raising=False)
    return Path("ws")


def texts(ws: Path) -> dict[str, str]:
    return {path.name: path.read_bytes().decode() for path in (ws / "robot").iterdir()}


@pytest.mark.slow
def test_each_kind(ws: Path, rosarch: Callable) -> None:
    expected = texts(ws)
    for name, wrong, right, _ in FIXES:
        assert expected[name].count(wrong) == 1
        expected[name] = expected[name].replace(wrong, right)
    before = json.loads(rosarch("check", ws, "--format", "json").out)["findings"]
    later = {"parameter-name-mismatch"}  # shows when its component is found
    assert {found["check"] for found in before if "fix" in found} == {check for *_, check in FIXES} - later
    outcome = rosarch("check", ws, "--fix", "--format", "json")
    assert texts(ws) == expected
    assert not [found for found in json.loads(outcome.out)["findings"] if "fix" in found]
    assert not {found["check"] for found in json.loads(outcome.out)["findings"]} & {check for *_, check in FIXES}
    again = rosarch("check", ws, "--fix")
    assert (texts(ws), "change" in again.err) == (expected, False)


@pytest.mark.slow
def test_a_diff_changes_nothing(ws: Path, rosarch: Callable) -> None:
    before = texts(ws)
    outcome = rosarch("check", ws, "--launch", "robot/top.launch.xml", "--diff")
    assert outcome.code == 1
    assert "--- a/robot/p.yaml\n+++ b/robot/p.yaml\n@@ -1,3 +1,3 @@\n joy2:\r\n-  ros_parameters:\r\n+  ros__parameters:\r\n" in outcome.out
    assert texts(ws) == before


@pytest.mark.slow
def test_what_is_suppressed_or_ignored_stays(ws: Path, rosarch: Callable) -> None:
    manifest = ws / "robot" / "package.xml"
    before = manifest.read_bytes()
    outcome = rosarch("check", ws, "--fix", "--ignore", "dependency-not-declared,missing-component,class-not-registered")
    assert manifest.read_bytes() == before
    assert "robot:Filter" in (ws / "robot" / "part.launch.xml").read_text()
    assert "becomes" not in outcome.out


@pytest.mark.slow
def test_a_renamed_parameter(tmp_path: Path, rosarch: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    launch = tmp_path / "move.launch"
    launch.write_text(OLD_LAUNCH.format(OLD_PARAM))
    told = rosarch("check", ".").out
    fix = "  fix: move.launch:3: `allowed_goal_duration_margin` becomes `trajectory_execution/allowed_goal_duration_margin`\n"
    assert fix in told
    again = rosarch("check", ".", "--fix")
    assert launch.read_text() == OLD_LAUNCH.format(OLD_PARAM.replace("allowed", "trajectory_execution/allowed"))
    assert ("parameter-renamed" in again.out, again.err.count("rosarch: 1 change in 1 file\n")) == (False, 1)


@pytest.mark.slow
def test_a_program_by_the_name_of_its_file(tmp_path: Path, rosarch: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    setup = "from setuptools import setup\nsetup(name='kitchen', packages=['kitchen'], entry_points={'console_scripts': ['cook = kitchen.cook:main']})\n"
    files = {
        "package.xml": MANIFEST.replace("robot</name>", "kitchen</name>").replace("ament_cmake<", "ament_python<"),
        "setup.py": setup,
        "setup.cfg": "[install]\ninstall_scripts=$base/lib/kitchen\n",
        "kitchen/__init__.py": "",
        "kitchen/cook.py": "import rclpy\n\n\ndef main():\n    rclpy.init()\n    rclpy.spin(rclpy.create_node('cook'))\n",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    launch = tmp_path / "a.launch.xml"
    launch.write_text('<launch>\n  <node pkg="kitchen" exec="cook.py" name="cook"/>\n</launch>\n')
    assert "  fix: a.launch.xml:2: `cook.py` becomes `cook`\n" in rosarch("check", ".").out
    again = rosarch("check", ".", "--fix")
    assert 'exec="cook" name' in launch.read_text()
    assert "program-not-installed" not in again.out


def test_fix_and_diff_exclude_each_other(tmp_path: Path, rosarch: Callable) -> None:
    outcome = rosarch("check", tmp_path, "--fix", "--diff")
    assert outcome.code == 2
    assert "--fix and --diff: one changes files, the other shows what would change" in outcome.err
