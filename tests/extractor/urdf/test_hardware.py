"""The interfaces that robot descriptions export to controllers."""

from __future__ import annotations

from pathlib import Path

from rosarch.extractor.launch import Files, PackagePath, compose

ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="prefix" default="left_"/>
  <link name="base"/>
  <ros2_control name="Robot" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="$(arg prefix)wheel"><command_interface name="velocity"/><state_interface name="position"/></joint>
    <sensor name="imu"><state_interface name="orientation.x"/></sensor>
    <gpio name="lamp"><command_interface name="on"/></gpio>
  </ros2_control>
  {}
</robot>
"""
LAUNCH = """<launch><node pkg="robot_state_publisher" exec="robot_state_publisher">
  <param name="robot_description" value="$(command 'xacro $(dirname)/r.urdf prefix:=right_')"/></node></launch>"""

READING = """import os
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    with open(os.path.join(os.path.dirname(__file__), "r.urdf")) as file:
        robot = file.read()
    return LaunchDescription([Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[{"robot_description": robot}])])
"""


def _hardware(folder: Path, more: str) -> tuple[list[tuple[str, str, str, int]], bool]:
    package = folder / "here"
    package.mkdir(exist_ok=True)
    (package / "package.xml").write_text("<package><name>here</name></package>")
    (package / "main.launch.xml").write_text(LAUNCH)
    (package / "r.urdf").write_text(ROBOT.format(more))
    found = compose([package / "main.launch.xml"], files=Files(PackagePath([folder]), str(folder)))
    return [(one.kind, one.owner, one.name, one.place.line) for one in found.hardware], found.hardware_unseen


def test_hardware(tmp_path: Path) -> None:
    expected = [
        ("command", "right_wheel", "velocity", 6),
        ("state", "right_wheel", "position", 6),
        ("state", "imu", "orientation.x", 7),
        ("command", "lamp", "on", 8),
    ]
    assert _hardware(tmp_path, "") == (expected, False)
    # what an absent file describes may be hardware, too
    assert _hardware(tmp_path, '<xacro:include filename="$(find elsewhere)/arm.xacro"/>')[1]
    assert _hardware(tmp_path, "<xacro:include filename=") == ([], True)


def test_descriptions_that_are_not_evaluated(tmp_path: Path) -> None:
    package = tmp_path / "here"
    package.mkdir()
    (package / "package.xml").write_text("<package><name>here</name></package>")
    (package / "r.urdf").write_text(ROBOT.format(""))
    (package / "main.launch.py").write_text(READING)
    found = compose([package / "main.launch.py"], files=Files(PackagePath([tmp_path]), str(tmp_path)))
    assert found.hardware_unseen and [one.robot.is_whole for one in found.params if one.robot] == [False]


def test_descriptions_that_are_read_as_texts(tmp_path: Path) -> None:
    (tmp_path / "r.urdf").write_text(
        '<robot name="r"><link name="base"/><joint name="j" type="fixed"><parent link="base"/></joint></robot>\n'
    )
    (tmp_path / "main.launch.py").write_text(READING)
    found = compose([tmp_path / "main.launch.py"], files=Files(PackagePath([tmp_path]), str(tmp_path)))
    (robot,) = (one.robot for one in found.params if one.robot)
    assert [(part.tag, part.within, part.place.line) for part in robot.parts] == [
        ("robot", 0, 1), ("link", 0, 1), ("joint", 0, 1), ("parent", 2, 1)
    ]  # fmt: skip
    assert robot.is_whole and not found.hardware_unseen


def test_a_description_that_is_found_by_the_name_of_its_file(tmp_path: Path) -> None:
    package = tmp_path / "here"
    (package / "urdf" / "arm").mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>here</name><export><build_type>ament_cmake</build_type></export></package>")
    for folder, whole in (("urdf/arm", False), ("urdf", True)):
        (package / folder / "r.urdf").write_text('<robot name="r"><link name="base"/></robot>')
        (package / "main.launch.xml").write_text(LAUNCH.replace("$(dirname)/", "$(find-pkg-share here)/urdf/"))
        found = compose([package / "main.launch.xml"], files=Files(PackagePath([tmp_path]), str(tmp_path)))
        assert [one.robot.is_whole for one in found.params if one.robot] == [whole]
