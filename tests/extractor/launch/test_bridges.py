"""What bridges to another middleware pass on."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from rosarch.extractor.launch import Files, PackagePath, compose
from rosarch.extractor.launch.bridges import of_arguments, unread_of_arguments
from rosarch.extractor.launch.facts import launch_rows
from rosarch.extractor.launch.model import Composition, NodeStart, Place


def _bridge(args: str) -> NodeStart:
    return NodeStart("ros_gz_bridge", "parameter_bridge", "bridge", "/", (Place("l.launch.py", 3),), args=args, ros=2)


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        ("/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock", ("/clock", ("publisher",))),
        ("cmd_vel@geometry_msgs/Twist]gz.msgs.Twist", ("cmd_vel", ("subscriber",))),
        ("/odom@nav_msgs/msg/Odometry@ignition.msgs.Odometry", ("/odom", ("publisher", "subscriber"))),
        ("/world/w/control@ros_gz_interfaces/srv/ControlWorld", None),
        ("/world/w/control@ros_gz_interfaces/srv/ControlWorld@gz.msgs.WorldControl@gz.msgs.Boolean", None),
        ("somebody@example.com", None),
        ("/scan", None),
    ],
)
def test_arguments(word: str, expected: tuple[str, tuple[str, ...]] | None) -> None:
    found = [(one.name, one.kinds) for one in of_arguments(_bridge(f"--verbose {word}"))]
    assert found == ([] if expected is None else [expected])


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        ("/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock", False),
        ("/world/$(var world)/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock", True),
        ("/world/w/control@ros_gz_interfaces/srv/ControlWorld@gz.msgs.WorldControl@gz.msgs.Boolean", True),
        ("$(var topics)", True),
        ("--verbose", False),
    ],
)
def test_arguments_that_may_say_more(word: str, expected: bool) -> None:
    node = _bridge(f"'{word}'")
    assert unread_of_arguments(node) == ([word] if expected else [])
    rows = launch_rows(Composition((node,), (), (), (), (), (), ros=2), Path("."))
    assert ("bridge_unread" in rows) == expected


LAUNCH = """
<launch>
  <node pkg="ros_gz_bridge" exec="parameter_bridge" name="bridge" args="/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V">
    <param name="config_file" value="$(dirname)/{}"/>
  </node>
</launch>
"""
CONFIG = """
- {topic_name: /scan, ros_type_name: sensor_msgs/msg/LaserScan, gz_type_name: gz.msgs.LaserScan, direction: GZ_TO_ROS}
- {ros_topic_name: cmd, gz_topic_name: other, ros_type_name: geometry_msgs/msg/Twist, gz_type_name: gz.msgs.Twist, direction: ROS_TO_GZ}
- {topic_name: both, ros_type_name: std_msgs/msg/Bool, gz_type_name: gz.msgs.Boolean}
- {topic_name: nowhere, ros_type_name: std_msgs/msg/Bool, gz_type_name: gz.msgs.Boolean, direction: SOMEWHERE}
- {topic_name: untyped}
"""


@pytest.mark.parametrize(
    ("file", "expected"),
    [
        (
            "bridge.yaml",
            {("/tf", "publisher"), ("/scan", "publisher"), ("cmd", "subscriber"), ("both", "publisher"), ("both", "subscriber")},
        ),
        ("absent.yaml", {("/tf", "publisher")}),
        ("other.yaml", {("/tf", "publisher")}),
        ("broken.yaml", {("/tf", "publisher")}),
    ],
)
def test_files(tmp_path: Path, file: str, expected: set[tuple[str, str]]) -> None:
    package = tmp_path / "here"
    package.mkdir()
    (package / "package.xml").write_text("<package><name>here</name></package>")
    (package / "main.launch.xml").write_text(LAUNCH.format(file))
    (package / "bridge.yaml").write_text(CONFIG)
    (package / "other.yaml").write_text("here: {ros__parameters: {a: 1}}\n")
    (package / "broken.yaml").write_text("- [\n")
    composition = compose([package / "main.launch.xml"], files=Files(PackagePath([tmp_path]), str(tmp_path)))
    rows = launch_rows(composition, tmp_path)
    ports = {port for _, port in rows["bridge_port"]}
    assert {(name, kind) for _, port, kind, name in rows["interface_port"] if port in ports} == expected
    assert ("bridge_unread" in rows) == (file != "bridge.yaml")
    if file == "bridge.yaml":
        types = {type_ for port, type_ in rows["interface_port_type"] if port in ports}
        assert types == {"tf2_msgs/TFMessage", "sensor_msgs/LaserScan", "geometry_msgs/Twist", "std_msgs/Bool"}
        places = {place for port, place in rows["interface_port_at"] if "/scan" in port}
        assert places == {"here/bridge.yaml:2:16"}
        assert {port.rpartition("#")[2] for port, _ in rows["interface_port_conditional"]} == {"publisher", "subscriber"}


def test_entries_that_are_refused(tmp_path: Path) -> None:
    (tmp_path / "c.yaml").write_text(
        "- topic_name: /scan\n  ros_type: sensor_msgs/msg/LaserScan\n  gz_type_name: gz.msgs.LaserScan\n"
        "- {topic_name: a, ros_type_name: a/msg/A, gz_type_name: b, direction: TO_GZ}\n- {ros_type_name: a/msg/A, gz_type_name: b, far: 1}\n"
    )
    (tmp_path / "l.launch.xml").write_text(LAUNCH.format("c.yaml"))
    found = compose([tmp_path / "l.launch.xml"], files=Files(PackagePath([tmp_path]), str(tmp_path)))
    rows = launch_rows(found, tmp_path)
    assert {(place, message) for _, place, message in rows["bridge_refused"]} == {
        ("c.yaml:2:3", "the entry has no ros_type_name"),
        ("c.yaml:4:60", "there is no direction TO_GZ"),
        ("c.yaml:5:3", "the entry has no topic_name"),
    }
    assert rows["launch_meant"] == {("c.yaml:2:3", "the entry has no ros_type_name", "ros_type", "ros_type_name")}


def test_a_bridge_that_is_called_as_its_code_says(tmp_path: Path) -> None:
    (tmp_path / "c.yaml").write_text(CONFIG)
    (tmp_path / "l.launch.xml").write_text(LAUNCH.format("c.yaml").replace(' name="bridge"', ""))
    found = compose([tmp_path / "l.launch.xml"], files=Files(PackagePath([tmp_path]), str(tmp_path)))
    renamed = tuple(replace(node, called="ros_gz_bridge") for node in found.nodes)
    assert {row[-1] for row in launch_rows(replace(found, nodes=renamed), tmp_path)["interface_port"]} >= {"/scan", "cmd", "both"}
