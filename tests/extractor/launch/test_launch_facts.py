"""Compositions as rows of `rules/schema/launch.dl`. Places are written `line:column` where the file is the launch file of the test."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from launch_builder import MANIFEST, composed

from rosarch.analysis.systems import manifests
from rosarch.analysis.systems.workspace import container_rows, dependencies, first_rows, workspace_rows
from rosarch.datalog import load_declarations
from rosarch.extractor.launch import Files, compose
from rosarch.extractor.launch.facts import kind_and_text, launch_rows, library_name, started
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.launch.scripts import MAX_FILES, script_rows
from rosarch.extractor.launch.values import Binary
from rosarch.extractor.manifest import rules_folder
from rosarch.library import load

Rows = dict[str, set[tuple[Any, ...]]]
MAIN = "here/main.launch:"


def short(rows: set[tuple[Any, ...]]) -> set[tuple[Any, ...]]:
    return {tuple(cell.removeprefix(MAIN) if isinstance(cell, str) else cell for cell in row) for row in rows}


def rows_of(folder: Path, content: str, **others: str) -> Rows:
    found = launch_rows(composed(folder, content, **others), folder)
    return {relation: short(rows) for relation, rows in found.items()}


def test_a_node(tmp_path: Path) -> None:
    rows = rows_of(tmp_path, '<group ns="arm">\n<node pkg="p" type="t" name="n"/>\n</group>')
    assert rows["started"] == {("/arm/n", "p", "t")}
    assert rows["started_name"] == {("/arm/n", "/arm/n", "/arm")}
    assert rows["started_at"] == {("/arm/n", 0, "3:1")}
    assert rows["place"] == {("3:1", "here/main.launch", 3, 1)}


def test_names_of_the_command_line(tmp_path: Path) -> None:
    rows = rows_of(
        tmp_path,
        '<node pkg="p" type="t" name="root"/>\n<node pkg="p" type="t" name="moved" args="__ns:=other __name:=ignored"/>\n'
        '<node pkg="p" type="t" name="deep" args="__ns:=/a//b/"/>',
    )
    assert rows["started_name"] == {("/root", "/root", "/"), ("/other/moved", "/other/moved", "/other"), ("/a/b/deep", "/a/b/deep", "/a/b")}


def test_arguments_parameters_and_remappings_of_the_command_line(tmp_path: Path) -> None:
    rows = rows_of(
        tmp_path,
        '<node pkg="p" type="t" name="n" args="load \'two words\' scan:=/front//scan _rate:=5 _frame:=map --fast">\n'
        '  <remap from="~cmd" to="cmd_vel/"/>\n</node>',
    )
    assert rows["started_argument"] == {("/n", 1, "load"), ("/n", 2, "two words"), ("/n", 3, "--fast")}
    assert rows["param_set"] == {("/n/rate", "int", "5", "2:1"), ("/n/frame", "string", "map", "2:1")}
    assert rows["started_remap"] == {("/n", "scan", "/front/scan", "2:1"), ("/n", "~cmd", "cmd_vel", "3:3")}


def test_an_element_overrides_the_command_line(tmp_path: Path) -> None:
    rows = rows_of(tmp_path, '<remap from="a" to="b"/>\n<node pkg="p" type="t" name="n" args="a:=c"/>')
    assert rows["started_remap"] == {("/n", "a", "b", "2:1")}
    assert rows["remap_written"] == {("2:1", "here/main.launch", "a", "b")}


def test_a_package_that_a_robot_description_names(tmp_path: Path) -> None:
    robot = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">\n<xacro:include filename="$(find gone)/arm.xacro"/>\n</robot>'
    rows = rows_of(tmp_path, '<param name="r" command="$(find xacro)/xacro $(find here)/robot.xacro"/>', robot_xacro=robot)
    assert ("here/robot.xacro:2:1", "gone") in rows["package_named"]


def test_a_remapping_that_no_node_follows(tmp_path: Path) -> None:
    rows = rows_of(tmp_path, '<remap from="a//x" to="/b/"/>')
    assert rows["remap_written"] == {("2:1", "here/main.launch", "a/x", "/b")}
    assert "started_remap" not in rows


def test_nodes_of_one_name(tmp_path: Path) -> None:
    rows = rows_of(
        tmp_path, '<arg name="x"/>\n<node pkg="p" type="a" name="n" if="$(arg x)"/>\n<node pkg="p" type="b" name="n" unless="$(arg x)"/>'
    )
    assert rows["started"] == {("/n", "p", "a"), ("/n#2", "p", "b")}
    assert rows["started_name"] == {("/n", "/n", "/"), ("/n#2", "/n", "/")}
    assert rows["started_if"] == {("/n", "if $(arg x)"), ("/n#2", "unless $(arg x)")}


def test_parameters_that_a_condition_decides_on(tmp_path: Path) -> None:
    rows = rows_of(tmp_path, '<arg name="x"/>\n<param name="a" value="1" if="$(arg x)"/>\n<param name="b" value="1"/>')
    assert rows["param_set_if"] == {("/a", "if $(arg x)")}


def test_a_chain_of_includes(tmp_path: Path) -> None:
    rows = rows_of(
        tmp_path,
        '<include file="$(dirname)/part.launch" pass_all_args="true"/>\n<include file="$(dirname)/gone.launch"/>\n'
        '<include file="$(dirname)/part.launch">\n  <arg name="name" value="b"/>\n</include>',
        part_launch='<launch>\n<arg name="name" default="a"/>\n<node pkg="p" type="t" name="$(arg name)"/>\n</launch>',
    )
    part = "here/part.launch"
    assert rows["included"] == {("2:1", "here/main.launch", part), ("3:1", "here/main.launch", ""), ("4:1", "here/main.launch", part)}
    assert rows["included_with_all"] == {("2:1",)}
    assert rows["started_at"] == {("/a", 0, "2:1"), ("/a", 1, f"{part}:3:1"), ("/b", 0, "4:1"), ("/b", 1, f"{part}:3:1")}
    assert rows["argument_passed"] == {("4:1", "name", "b", "5:3")}
    assert rows["argument_declared"] == {(part, "name", "default", "a", f"{part}:2:1")}
    gone = "here/gone.launch"
    assert {(*row[:3], row[4]) for row in rows["launch_problem"]} == {("3:1", "file", gone, "refused")}


def test_declared_arguments(tmp_path: Path) -> None:
    rows = rows_of(tmp_path, '<arg name="a"/>\n<arg name="b" default=""/>\n<arg name="c" value="1"/>')
    assert rows["argument_declared"] == {
        ("here/main.launch", "a", "", "", "2:1"),
        ("here/main.launch", "b", "default", "", "3:1"),
        ("here/main.launch", "c", "value", "1", "4:1"),
    }


def test_parameters_from_files_are_at_the_line_of_their_key(tmp_path: Path) -> None:
    rows = rows_of(
        tmp_path,
        '<rosparam command="load" file="$(dirname)/p.yaml" ns="n"/>\n<rosparam>\nc: [1, a]\n</rosparam>',
        p_yaml="# all\na: 1\nb:\n  deep: true\n",
    )
    source = "here/p.yaml"
    assert rows["param_set"] == {
        ("/n/a", "int", "1", f"{source}:2:1"),
        ("/n/b/deep", "bool", "true", f"{source}:4:1"),
        ("/c", "list", '[1, "a"]', "4:1"),
    }
    maps = rows_of(tmp_path, '<rosparam command="load" file="$(dirname)/m.yaml"/>', m_yaml="m:\n- {topic: joy, priority: 1}\n- a\n")
    assert maps["param_entry"] == {("/m", "0/topic", "joy", "here/m.yaml:1:1")}
    assert rows["param_source"] == {("/n/a", f"{source}:2:1", source), ("/n/b/deep", f"{source}:4:1", source)}


def test_parameters_that_cannot_be_read(tmp_path: Path) -> None:
    rows = rows_of(tmp_path, '<rosparam command="load" file="$(find gone)/p.yaml" ns="n"/>')
    assert rows["params_unread"] == {("/n", "2:1")}
    assert rows["launch_problem"] == {("2:1", "package", "gone", "package `gone` is not on the package path", "refused")}


def test_what_is_only_warned_of(tmp_path: Path) -> None:
    rows = rows_of(tmp_path, '<node pkg="p" type="t" name="n" surprise="1"/>')
    assert {(row[1], row[4]) for row in rows["launch_problem"]} == {("unknown-attribute", "warned")}


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (True, ("bool", "true")),
        (False, ("bool", "false")),
        (3, ("int", "3")),
        (0.5, ("double", "0.5")),
        (None, ("none", "")),
        ("a", ("string", "a")),
        ("", ("string", "")),
        ("$(env ROBOT)/x", ("unknown", "$(env ROBOT)/x")),
        ([1, "é"], ("list", '[1, "\\u00e9"]')),
        ({"a": 1}, ("map", '{"a": 1}')),
        (Binary(b"x"), ("binary", "")),
        ("x" * 5000, ("string", "x" * 4096)),
    ],
)
def test_kinds_of_values(value: Any, expected: tuple[str, str]) -> None:
    assert kind_and_text(value) == expected


def test_plugins_of_robots(tmp_path: Path) -> None:
    rows = rows_of(
        tmp_path,
        '<param name="robot_description" textfile="$(dirname)/robot.urdf"/>',
        robot_urdf='<robot name="r">\n<gazebo>\n<plugin name="drive" filename="libdrive">\n<topic>cmd</topic>\n</plugin>\n</gazebo>\n</robot>',
    )
    ((plugin, file, place),) = rows["simulated_plugin"]
    assert (file, place) == ("libdrive.so", "here/robot.urdf:3:1")
    assert rows["plugin_element"] == {(plugin, "topic", "cmd")}
    assert rows["plugin_called"] == {(plugin, "drive")}


def test_library_names() -> None:
    assert [library_name(name) for name in (" lib/libx.so ", "libx", "x")] == ["libx.so", "libx.so", "libx.so"]


def test_files_outside_the_workspace_are_absolute(tmp_path: Path) -> None:
    found = launch_rows(composed(tmp_path, '<node pkg="p" type="t" name="n"/>'), tmp_path / "elsewhere")
    assert {row[1] for row in found["place"]} == {f"{tmp_path}/here/main.launch"}


def test_paths_in_words_are_relative_to_the_workspace(tmp_path: Path) -> None:
    found = launch_rows(composed(tmp_path, '<include file="$(dirname)/gone.launch"/>'), tmp_path)
    assert [row[3] for row in found["launch_problem"]] == ["no such file: here/gone.launch"]


def test_what_is_started_with_which_words(tmp_path: Path) -> None:
    found = composed(tmp_path, '<node pkg="nodelet" type="nodelet" name="n" args="load a/B manager x:=y"/>')
    assert list(started(found)) == [("nodelet", "nodelet", ("load", "a/B", "manager"))]


def test_scripts(tmp_path: Path) -> None:
    composition = composed(
        tmp_path,
        '<node pkg="here" type="run.py" name="a"><remap from="left/scan" to="b"/><param name="max_speed" value="1"/></node>\n'
        '<node pkg="here" type="tool" name="t"/>\n<node pkg="here" type="binary" name="c"/>\n<node pkg="gone" type="run.py" name="d"/>',
        run_py="import rospy, helper\nrospy.Subscriber('scan')\n",
        helper_py="rospy.get_param('~max_speed')\n",
        tool="#!/usr/bin/env python3\nprint('left')\n",
        binary="\x7fELF left scan",
    )
    rows = script_rows(composition, PackagePath([tmp_path]))
    assert rows["script"] == {("here", "run.py"), ("here", "tool")}
    assert rows["word_of_name"] == {("left/scan", "left"), ("left/scan", "scan"), ("/a/max_speed", "a"), ("/a/max_speed", "max_speed")}
    both = {("scan",), ("max_speed",)}
    assert rows["script_word"] == {("here", "run.py", word) for (word,) in both} | {
        ("here", "tool", word) for (word,) in {*both, ("left",)}
    }


def test_no_scripts(tmp_path: Path) -> None:
    composition = composed(tmp_path, '<node pkg="here" type="t" name="n"/>')
    assert script_rows(composition, PackagePath([tmp_path])) == {"word_of_name": set()}


def test_a_package_with_very_many_modules_is_read_in_part(tmp_path: Path) -> None:
    composition = composed(tmp_path, '<node pkg="here" type="run.py" name="n"/><param name="word" value="1"/>', run_py="")
    for number in range(MAX_FILES):
        (tmp_path / "here" / f"a{number:03}.py").write_text("")
    (tmp_path / "here" / "z.py").write_text("word")
    assert script_rows(composition, PackagePath([tmp_path])).get("script", set()) == set()


EVERYTHING = """<arg name="x"/><arg name="y" default="1"/>
<include file="$(dirname)/part.launch" pass_all_args="true"><arg name="name" value="b"/></include>
<rosparam file="$(find other)/p.yaml" ns="n"/><rosparam file="$(dirname)/p.yaml"/><param name="d" textfile="$(dirname)/robot.urdf"/>
<node pkg="here" type="run.py" name="n" args="load _p:=1" if="$(arg x)"><remap from="a" to="b"/><param name="q" value="/home/anna/x"/></node>
<node pkg="here" type="built" name="m"/><node pkg="here" type="mentioned" name="o"/><include file="$(find here)/gone.launch"/>
<node pkg="here" type="mentioned" name="o"/>"""


IN_PYTHON = """import os
from launch import LaunchDescription
from launch.actions import ExecuteProcess, IncludeLaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch.substitutions import Command
from launch_ros.descriptions import ComposableNode

def generate_launch_description():
    inner = ComposableNode(package="here", plugin="here::Inner")
    here = os.path.dirname(__file__)
    viewer = Node(package="rviz2", executable="rviz2", name="viewer", remappings=[("rostopic://a", "b")], arguments=["-d", os.path.join(here, "demo.rviz")], additional_env={"ROS_DOMAIN_ID": "7"})
    arm = os.path.join(here, "arm.launch.xml")
    forgotten = Node(package="here", executable="forgotten")
    arms = [IncludeLaunchDescription(arm, launch_arguments=[("rate", "1")]), IncludeLaunchDescription(arm)]
    bridge = Node(package="ros_gz_bridge", executable="parameter_bridge", name="bridge", arguments=["/odom@nav_msgs/msg/Odometry@gz.msgs.Odometry"], parameters=[{"config_file": "/none.yaml"}])
    refusing = Node(package="ros_gz_bridge", executable="parameter_bridge", name="refusing", parameters=[{"config_file": os.path.join(here, "bridge.yaml")}])
    manager = Node(package="controller_manager", executable="ros2_control_node", parameters=[{"arm.type": "here/Arm", "joints": ["a", "b"], "robot_description": Command(["xacro ", os.path.join(here, "arm.urdf")])}])
    spawner = Node(package="controller_manager", executable="spawner", arguments=["arm"])
    return LaunchDescription([bridge, refusing, manager, spawner, *arms, viewer, ExecuteProcess(cmd=["date"]), ComposableNodeContainer(package="rclcpp_components", executable="component_container", name="box",
                                                      composable_node_descriptions=[inner],
                                                      parameters=[os.path.join(here, "box.yaml"), {"map": os.path.join(here, "gone.yaml"), "own": os.path.join(here, "made.yaml")}])])

def joined():
    return os.path.join(here, "/config")


def unused(context):
    mode = LaunchConfiguration("mode")
    if mode or mode.perform(context):
        pass
"""


def test_every_relation_of_the_schema_is_filled(tmp_path: Path) -> None:
    composition = composed(
        tmp_path,
        EVERYTHING,
        part_launch='<launch><arg name="name"/></launch>',
        p_yaml="a: 1\nm: [{topic: t}]\n",
        robot_urdf='<robot name="r"><gazebo><plugin name="p" filename="p"><t>u</t></plugin></gazebo></robot>',
        run_py="a",
    )
    (tmp_path / "here" / "package.xml").write_text(MANIFEST.format("here").replace("</package>", "<depend>other</depend></package>"))
    (tmp_path / "here" / "CMakeLists.txt").write_text("add_executable(mentioned a.cpp)\nregister(Inner)\n")
    filled = launch_rows(composition, tmp_path)
    filled |= script_rows(composition, PackagePath([tmp_path]))
    (tmp_path / "here" / "arm.launch.xml").write_text('<launch><arg name="rate" default="2" descrption="x"/></launch>')
    (tmp_path / "here" / "ros2.launch.py").write_text(IN_PYTHON)
    hardware = '<joint name="a"><command_interface name="position"/></joint>'
    (tmp_path / "here" / "arm.urdf").write_text(
        f'<robot name="r"><ros2_control name="c">{hardware}</ros2_control><link name="$(find none)"/></robot>'
    )
    (tmp_path / "here" / ".gitignore").write_text("made.yaml\n")
    (tmp_path / "here" / "box.yaml").write_text("box:\n  ros__parameters:\n    p: 1\n")
    view = "Visualization Manager: {Displays: [{Class: rviz/Map, Topic: {Value: /map, Reliability Policy: Reliable}}], Global Options: {Fixed Frame: map}}"
    (tmp_path / "here" / "demo.rviz").write_text(view)
    (tmp_path / "here" / "bridge.yaml").write_text("- {ros_topic_name: /imu}\n")
    in_python = compose([tmp_path / "here" / "ros2.launch.py"], files=Files(PackagePath([tmp_path])))
    whole = in_python.with_controllers()
    filled |= launch_rows(replace(whole, nodes=(*whole.nodes, replace(whole.nodes[0], inside="/"))), tmp_path)
    filled |= container_rows([in_python])
    filled |= first_rows([composition], tmp_path)
    needed = dependencies(manifests.declared(tmp_path))
    filled |= workspace_rows(needed, [composition], {("here", "built")}, load().packages, (), {"/home/dev"})
    declared = load_declarations(rules_folder() / "schema" / "launch.dl")
    ports = load_declarations(rules_folder() / "schema" / "interfaces.dl")  # of viewers
    assert {name for name, rows in filled.items() if rows and name not in ports} == set(declared)
    declared = {**declared, **ports}
    for name, rows in filled.items():
        assert {len(row) for row in rows} == {len(declared[name].attributes)}, name
