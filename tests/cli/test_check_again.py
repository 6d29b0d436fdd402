"""`rosarch check` when something has changed since the last run: whatever it is, the answer is that of a run without a cache."""

from __future__ import annotations

import json
import os
import random
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosarch.base import tracing

pytestmark = pytest.mark.slow

BUILD = """cmake_minimum_required(VERSION 3.0)
project(robot)
find_package(catkin REQUIRED COMPONENTS roscpp)
include_directories(include)
add_executable(driver src/driver.cpp)
add_executable(watcher src/watcher.cpp)
"""
MANIFEST = """<package format="2"><name>{name}</name><version>1.0.0</version><description>d</description>
<maintainer email="m@example.com">m</maintainer><license>BSD</license><buildtool_depend>catkin</buildtool_depend>
<depend>roscpp</depend><depend>std_msgs</depend></package>
"""
DRIVER = """#include <ros/ros.h>
#include <robot/names.h>
#include <std_msgs/Int32.h>
int main(int argc, char** argv) {
  ros::init(argc, argv, "driver");
  ros::NodeHandle node, own("~");
  double speed;
  own.param("speed", speed, 1.0);
  ros::Publisher out = node.advertise<std_msgs::Int32>(TOPIC, 1);
  ros::spin();
}
"""
WATCHER = """#include <ros/ros.h>
#include <robot/Level.h>
void onLevel(const robot::Level& level) { if (level.value > 3) ROS_INFO("high"); }
int main(int argc, char** argv) {
  ros::init(argc, argv, "watcher");
  ros::NodeHandle node;
  ros::Subscriber in = node.subscribe("level", 1, onLevel);
  ros::spin();
}
"""
LAUNCH = """<launch>
  <arg name="topic" default="level"/>
  <param name="robot_description" command="$(find xacro)/xacro $(find robot)/robot.xacro"/>
  <include file="$(find robot)/launch/part.launch"/>
  <node pkg="robot" type="watcher" name="watcher"><remap from="level" to="$(arg topic)"/></node>
  <node pkg="other" type="script.py" name="$(optenv NODE script)"/>
  <node pkg="gazebo_ros" type="gzserver" name="gazebo"/>
  <node pkg="lib" type="relay" name="relay"/>
</launch>
"""
PART = """<launch>
  <node pkg="robot" type="driver" name="driver">
    <rosparam command="load" file="$(find robot)/config/driver.yaml"/>
    <rosparam command="load" file="/nowhere/at/all.yaml"/>
    <remap from="number" to="level"/>
    <param name="mode" value="fast"/>
  </node>
</launch>
"""
XACRO = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="wheel.xacro"/></robot>
"""
LIBRARY = {
    "package": "lib", "origin": "o", "revision": "1", "made": "by hand",
    "components": [{"component": "relay", "kind": "node", "ports": [{"kind": "subscriber", "name": "in", "type": "std_msgs/String"}]}],
}  # fmt: skip
RULE = """// id: my-check
// title: Nodes of a type
// help: A node of this type is started
// impact: high
// confidence: high
// description: None.
// scenario: None.
// recommendation: None.
// message: {node} is started
// at: node

/// `node` is a watcher. Must.
.decl my_check(node: Start)
my_check(N) :- started(N, _, "watcher").
"""


@pytest.fixture
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The package `robot` in a workspace below the current folder, with all kinds of files."""
    texts = {
        "ws/robot/package.xml": MANIFEST.format(name="robot"),
        "ws/robot/CMakeLists.txt": BUILD,
        "ws/robot/include/robot/names.h": '#define TOPIC "number"\n',
        "ws/robot/src/driver.cpp": DRIVER,
        "ws/robot/src/watcher.cpp": WATCHER,
        "ws/robot/msg/Level.msg": "int32 value\n",
        "ws/robot/launch/main.launch": LAUNCH,
        "ws/robot/launch/part.launch": PART,
        "ws/robot/config/driver.yaml": "speed: 2.0\nlimits: {low: 1}\n",
        "ws/robot/robot.xacro": XACRO,
        "ws/robot/wheel.xacro": "<robot/>\n",
        "ws/other/package.xml": MANIFEST.format(name="other"),
        "ws/other/scripts/script.py": "#!/usr/bin/env python\nprint('mode')\n",
        "library/lib.json": json.dumps(LIBRARY),
        "my-check.dl": RULE,
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("ROS_PACKAGE_PATH", raising=False)
    return tmp_path / "ws" / "robot"


Check = Callable[..., tuple[int, str, str]]
OPTIONS = ("--library", "library", "--rules", "my-check.dl", "-v", "--format", "json")


@pytest.fixture
def check(rosarch: Callable) -> Check:
    """What a check says."""

    def run(*options: str) -> tuple[int, str, str]:
        outcome = rosarch("check", "ws", *OPTIONS, *options)
        return outcome.code, outcome.out, outcome.err

    return run


@pytest.fixture
def afresh(check: Check, monkeypatch: pytest.MonkeyPatch) -> Check:
    """What a check says that knows of no earlier results, but for sources and models of components, which have tests of their own."""

    def run(*options: str) -> tuple[int, str, str]:
        with monkeypatch.context() as patch:
            patch.setattr("rosarch.cli.systems._memo", lambda *_args: None)
            patch.setattr("rosarch.analysis.systems.analysis.SystemCache.load", lambda *_args: None)
            return check(*options)

    return run


@pytest.fixture
def done(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The folders that were checked, and not only said to be as before."""
    from rosarch.cli import systems

    found: list[str] = []
    real = systems._analyze

    def analyze(inputs: systems.SystemInputs, *rest: Any, **options: Any) -> object:
        found.append(str(inputs.folder))
        return real(inputs, *rest, **options)

    monkeypatch.setattr(systems, "_analyze", analyze)
    return found


def replace(file: str, old: str, new: str) -> Callable[[Path], object]:
    def change(robot: Path) -> None:
        text = (robot / file).read_text()
        assert old in text
        (robot / file).write_text(text.replace(old, new))

    return change


CHANGES = {
    "source": replace("src/watcher.cpp", '"level"', '"height"'),
    "header": replace("include/robot/names.h", "number", "numbers"),
    "CMake": replace("CMakeLists.txt", "add_executable(watcher", "add_executable(guard"),
    "manifest": replace("package.xml", "<name>robot<", "<name>machine<"),
    "message": lambda robot: (robot / "msg" / "Level.msg").unlink(),
    "launch file": replace("launch/main.launch", 'default="level"', 'default="height"'),
    "included launch file": replace("launch/part.launch", 'to="level"', 'to="number"'),
    "YAML": replace("config/driver.yaml", "speed", "sped"),
    "robot description": replace("wheel.xacro", "<robot/>", "<robot"),
    "script": replace("../other/scripts/script.py", "python", "nothing"),
    "file that was missing": lambda robot: (robot / "launch" / "more.launch").write_text("<launch><node pkg='x' type='y' name='z'/></launch>"),
    "file that is gone": lambda robot: (robot / "launch" / "part.launch").unlink(),
    "ignored": lambda robot: (robot / "CATKIN_IGNORE").touch(),
    "link": lambda robot: (robot.parent / "other" / "scripts" / "driver.yaml").symlink_to(robot / "config"),
    "library": replace("../../library/lib.json", "std_msgs/String", "std_msgs/Int32"),
    "rule": replace("../../my-check.dl", '"watcher"', '"driver"'),
    "message of a rule": replace("../../my-check.dl", "is started", "is begun"),
}  # fmt: skip
UNSEEN = [CHANGES[name] for name in ("message", "script", "link")]
"""What has no finding here."""


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_a_change(robot: Path, check: Check, afresh: Check, done: list[str], change: Callable[[Path], object]) -> None:
    (robot / "launch" / "sometimes.launch").write_text('<launch><include file="$(find robot)/launch/more.launch"/></launch>')
    first = check()
    assert check() == first
    assert done == ["ws"]
    change(robot)
    again = check()
    assert done == ["ws", "ws"]
    assert check() == again == afresh()
    if change not in UNSEEN:
        assert again != first


@pytest.mark.parametrize(
    "options",
    [
        ("--launch", "robot/launch/main.launch"),
        ("--launch", "robot/launch/main.launch topic:=height"),
        ("--env", "NODE=x"),
        ("--package-path", "elsewhere"),
        ("-D", "CATKIN_ENABLE_TESTING=1"),
        ("--timeout", "50"),
        ("--ignore", "my-check"),
    ],
)
def test_an_option(robot: Path, check: Check, afresh: Check, options: tuple[str, ...]) -> None:
    (robot.parent.parent / "elsewhere").mkdir()
    first = check()
    assert check(*options) == afresh(*options)
    assert check() == first


def test_a_variable(robot: Path, check: Check, afresh: Check, monkeypatch: pytest.MonkeyPatch) -> None:
    first = check()
    monkeypatch.setenv("UNRELATED", "x")
    assert check() == first
    monkeypatch.setenv("NODE", "driver")
    second = check()
    assert second != first
    assert second == afresh()
    monkeypatch.delenv("NODE")
    assert check() == first


def test_the_configuration(robot: Path, check: Check, afresh: Check) -> None:
    first = check()
    (robot.parent / ".rosarch.yml").write_text("environment: {NODE: driver}\n")
    second = check()
    assert second != first
    assert second == afresh()
    (robot.parent / ".rosarch.yml").write_text("checks: {my-check: ignore}\n")
    assert check() == afresh() not in (first, second)


def test_a_comment_that_suppresses(robot: Path, check: Check, afresh: Check) -> None:
    first = check()
    path = robot / "launch" / "main.launch"
    path.write_text(LAUNCH.replace("<launch>", "<launch> <!-- rosarch: ignore-file my-check, it is meant so -->", 1))
    assert check() == afresh() != first


def test_a_build(robot: Path, check: Check, afresh: Check) -> None:
    first = check()
    (robot.parent / "build").mkdir()
    command = {"directory": str(robot), "file": "src/driver.cpp", "command": 'g++ "-DTOPIC=\\"built\\"" -c src/driver.cpp'}
    (robot / "include" / "robot" / "names.h").write_text('#ifndef TOPIC\n#define TOPIC "number"\n#endif\n')
    (robot.parent / "build" / "compile_commands.json").write_text(json.dumps([command]))
    assert check() == afresh() != first


def test_a_file_beside_the_workspace(robot: Path, check: Check, afresh: Check) -> None:
    outside = robot.parent.parent / "all.yaml"
    path = robot / "launch" / "part.launch"
    path.write_text(PART.replace("/nowhere/at/all.yaml", str(outside)))
    first = check()
    outside.write_text("a: 1\n")
    assert check() == afresh() != first


def test_a_launch_file_beside_the_workspace_that_an_option_names(robot: Path, check: Check, afresh: Check) -> None:
    beside = robot.parent.parent / "beside.launch"
    beside.write_text('<launch><include file="$(find robot)/launch/part.launch"/></launch>')
    arguments = ("--launch", str(beside))
    first = check(*arguments)
    assert "outside of the workspace" not in repr(first) and "/nowhere/at/all.yaml" in repr(first)
    beside.write_text('<launch><node pkg="robot" type="absent" name="x"/></launch>')
    assert check(*arguments) == afresh(*arguments) != first


def test_nothing_changed(robot: Path, check: Check, done: list[str]) -> None:
    first = check()
    (robot.parent / "README.md").touch()
    (robot.parent / "README.md").unlink()
    for path in robot.rglob("*.*"):
        path.touch()
    assert check() == first == check("--no-cache")
    assert done == ["ws", "ws"]


def test_what_a_change_does_not_reach_is_not_evaluated_again(robot: Path, check: Check, monkeypatch: pytest.MonkeyPatch) -> None:
    (robot / "launch" / "alone.launch").write_text('<launch><node pkg="robot" type="driver" name="d"/></launch>')
    check()
    from rosarch.analysis.systems.analysis import SystemCache

    evaluated: list[str] = []
    monkeypatch.setattr(SystemCache, "store", lambda _self, launch, _own, _composed: evaluated.append(launch.name))
    monkeypatch.setattr("rosarch.analysis.components.analyze", lambda *_args, **_options: pytest.fail("components are read again"))
    replace("launch/main.launch", 'default="level"', 'default="height"')(robot)
    check()
    assert evaluated == ["robot/launch/main.launch"]


def test_a_component_that_changed_reaches_the_systems_that_start_it(robot: Path, check: Check, monkeypatch: pytest.MonkeyPatch) -> None:
    (robot / "launch" / "alone.launch").write_text('<launch><node pkg="rviz" type="rviz" name="view"/></launch>')
    check()
    from rosarch.analysis.systems.analysis import SystemCache

    evaluated: list[str] = []
    monkeypatch.setattr(SystemCache, "store", lambda _self, launch, _own, _composed: evaluated.append(launch.name))
    source = min(robot.rglob("*.cpp"))
    source.write_text("\n" + source.read_text())
    check()
    assert evaluated == ["robot/launch/main.launch"]


def test_random_edits(robot: Path, rosarch: Callable) -> None:
    """Whatever is edited, models and findings are byte for byte those of a run without a cache."""
    chosen = random.Random(0)
    original = {path: path.read_text() for path in sorted(robot.parent.rglob("*.*")) if path.is_file()}
    words = sorted({word for text in original.values() for word in re.findall(r"\w+|[<>{}();&/$]", text)})

    def edit() -> None:
        path = chosen.choice(list(original))
        text = path.read_text() if path.is_file() else ""
        kind = chosen.choice(["word", "word", "line", "again", "gone", "touch", "back", "back"])
        places = list(re.finditer(r"\w+|[<>{}();&/$]", text))
        if kind == "word" and places:
            place = chosen.choice(places)
            path.write_text(text[: place.start()] + chosen.choice(words) + text[place.end() :])
        elif kind in ("line", "again") and text:
            lines = text.splitlines(keepends=True)
            index = chosen.randrange(len(lines))
            lines[index : index + 1] = [lines[index]] * (2 if kind == "again" else 0)
            path.write_text("".join(lines))
        elif kind == "gone":
            path.unlink(missing_ok=True)
        elif kind == "touch" and path.is_file():
            path.touch()
        else:
            path.write_text(original[path])

    different = set()
    for _ in range(8):
        for _ in range(chosen.randint(1, 3)):
            edit()
        for command in (("analyze", "ws", "--format", "json"), ("check", "ws", *OPTIONS)):
            outcome = rosarch(*command)
            assert outcome == rosarch(*command) == rosarch(*command, "--no-cache")
            different.add(outcome)
    assert len(different) >= 5  # the edits did say something


def test_all_that_is_read_is_observed(robot: Path, rosarch: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    """Files are read in one way only, so that none is missed: what Python opens below the workspace is what was recorded."""
    import sys

    opened: set[str] = set()
    listening = True

    def hear(event: str, arguments: tuple[object, ...]) -> None:
        if listening and event == "open" and isinstance(arguments[0], (str, os.PathLike)):
            opened.add(os.path.abspath(arguments[0]))

    kept: list[tracing.Trace] = []
    real = tracing.Recording.trace
    monkeypatch.setattr(tracing.Recording, "trace", lambda self: kept.append(real(self)) or kept[-1])
    sys.addaudithook(hear)
    try:
        with monkeypatch.context() as patch:
            patch.setattr("rosarch.extractor.suppressions.find_suppressions", lambda *_args: ())
            patch.setattr("rosarch.cli.commands.check.write_reports", lambda *_args, **_options: None)
            rosarch("check", "ws", "--jobs", "1")
    finally:
        listening = False
    below = {path for path in opened if path.startswith(f"{robot.parent}/")}
    assert {f"{robot}/CMakeLists.txt", f"{robot}/launch/part.launch"} <= below
    assert below <= set(kept[-1].reads)
    assert {f"{robot}/src/watcher.cpp", f"{robot}/include/robot/names.h", f"{robot}/wheel.xacro"} <= set(kept[-1].reads)
