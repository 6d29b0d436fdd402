"""Parameters that are lists of maps: what a round of a loop over them makes, it makes of one map."""

from __future__ import annotations

from pathlib import Path

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import analyze_systems
from rosarch.analysis.systems.launches import given
from rosarch.analysis.systems.requests import LaunchEnvironment, parse_request
from rosarch.extractor.settings import Settings

MANIFEST = """<package format="2"><name>relay</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.org">m</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>
<depend>rospy</depend><depend>std_msgs</depend></package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.0)
project(relay)
find_package(catkin REQUIRED COMPONENTS rospy std_msgs)
catkin_package()
catkin_install_python(PROGRAMS scripts/relay.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
"""
RELAY = """#!/usr/bin/env python3
import rospy
from std_msgs.msg import Empty, String


class Event:
    def __init__(self, name):
        self.publisher = rospy.Publisher(name, Empty, queue_size=1)


class Text:
    def __init__(self, name):
        self.publisher = rospy.Publisher(name, String, queue_size=1)


if __name__ == "__main__":
    rospy.init_node("relay")
    relays = []
    for one in rospy.get_param("~relays"):
        if one["type"] == "event":
            relays.append(Event(one["name"]))
        elif one["type"] == "text":
            relays.append(Text(one["name"]))
    rospy.spin()
"""
LAUNCH = """<launch>
<node pkg="relay" type="relay.py" name="relay">
<rosparam param="relays">[{name: honk, type: event}, {name: words, type: text}, {name: ring, type: event}, {name: lost, type: none}]</rosparam>
</node>
</launch>
"""


def test_names_and_types_belong_together(tmp_path: Path) -> None:
    for name, text in {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE, "main.launch": LAUNCH, "scripts/relay.py": RELAY}.items():
        (tmp_path / "relay" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "relay" / name).write_text(text)
    where = LaunchEnvironment(tmp_path, (tmp_path,), {})
    analysis = analyze_systems(tmp_path, given([parse_request("relay/main.launch")], where), Method(sources=Settings(jobs=1)))
    (node,) = analysis.systems[0].nodes
    assert {(port.name, port.type) for port in node.ports if not port.implicit} == {
        ("/honk", "std_msgs/Empty"),
        ("/words", "std_msgs/String"),
        ("/ring", "std_msgs/Empty"),
    }
