"""Command lines as a part of the configuration of nodes: words, how many there are, options."""

from __future__ import annotations

import pytest

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import analyze_systems
from rosarch.analysis.systems.launches import given
from rosarch.analysis.systems.requests import LaunchEnvironment, parse_request
from rosarch.extractor.settings import Settings
from rosarch.models.system.model import SystemModel

MANIFEST = """<package format="2"><name>said</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.org">m</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>
<depend>roscpp</depend><depend>rospy</depend><depend>std_msgs</depend></package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.0)
project(said)
find_package(catkin REQUIRED COMPONENTS roscpp rospy std_msgs)
catkin_package()
add_executable(counts src/counts.cpp)
catkin_install_python(PROGRAMS scripts/words.py scripts/options.py scripts/left.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
"""
COUNTS = """#include <ros/ros.h>
#include <std_msgs/String.h>
std::string topic;
int main(int argc, char *argv[]) {
  ros::init(argc, argv, "counts");
  ros::NodeHandle n;
  if (argc > 1) {
    topic = argv[1];
  } else {
    topic = "plain";
  }
  ros::Publisher first = n.advertise<std_msgs::String>(topic, 1), second;
  if (argc == 3 && std::string(argv[2]) == "--twice")
    second = n.advertise<std_msgs::String>("twice", 1);
  ros::spin();
}
"""
WORDS = """#!/usr/bin/env python3
import sys
import rospy
from std_msgs.msg import String


def send(name):
    rospy.Publisher(name, String, queue_size=1)


if __name__ == "__main__":
    rospy.init_node("words")
    send(sys.argv[1] + "/first")
    if len(sys.argv) < 3:
        send("few")
    space = rospy.get_namespace()
    if space and space != "/":
        send("inside")
    else:
        send("/outside")
"""
LEFT = """#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

if __name__ == "__main__":
    rospy.init_node("left")
    words = rospy.myargv()[1:]
    if len(words) >= 2:
        rospy.Publisher("several", String, queue_size=1)
    if len(words) < 2:
        rospy.Publisher("single", String, queue_size=1)
    for word in words:
        rospy.Publisher(word, String, queue_size=1)
"""
OPTIONS = """#!/usr/bin/env python3
import argparse
import rospy
from std_msgs.msg import String


def send(name):
    rospy.Publisher(name, String, queue_size=1)


class Robot:
    def __init__(self, own, other, kind):
        self.accompanied = not (other is None)
        if self.accompanied:
            send(other + "/seen")
        if other is None and own == "alone":
            send(own + "/solitary")
        if kind == "fast":
            send("hurry")
        elif kind == "slow":
            send("crawl")


if __name__ == "__main__":
    rospy.init_node("options")
    parser = argparse.ArgumentParser()
    parser.add_argument("own")
    parser.add_argument("-o", "--other-name", required=False)
    parser.add_argument("--kind", default="slow")
    parser.add_argument("--loud", action="store_true")
    parser.add_argument("--sources", nargs="+", default=["none"])
    parser.add_argument("goal", nargs="?", default="home")
    args, _ = parser.parse_known_args()
    send(args.own)
    send(args.goal)
    for source in args.sources:
        send(source)
    if args.loud:
        send("noise")
    if args.other_name:
        send("together")
    own, other = args.own, args.other_name
    Robot(own, other, args.kind)
    rospy.spin()
"""
LAUNCH = """<launch>
<arg name="who" default="two"/>
<node pkg="said" type="counts" name="none"/>
<node pkg="said" type="counts" name="one" args="given"/>
<node pkg="said" type="counts" name="two" args="$(arg who) --twice other:=name"/>
<node pkg="said" type="words.py" name="words" args="a"/>
<node pkg="said" type="words.py" name="more" args="b c" ns="deep"/>
<node pkg="said" type="left.py" name="left" args="x"/>
<node pkg="said" type="left.py" name="both" args="y z"/>
<node pkg="said" type="options.py" name="alone" args="alone"/>
<node pkg="said" type="options.py" name="pair" args="a --kind=fast --other-name b there --loud --sources s t"/>
<node pkg="said" type="options.py" name="short" args="-o c a"/>
</launch>
"""


@pytest.fixture(scope="module")
def system(tmp_path_factory: pytest.TempPathFactory) -> SystemModel:
    root = tmp_path_factory.mktemp("ws")
    for name, text in {
        "package.xml": MANIFEST, "CMakeLists.txt": CMAKE, "main.launch": LAUNCH, "src/counts.cpp": COUNTS, "scripts/words.py": WORDS,
        "scripts/options.py": OPTIONS, "scripts/left.py": LEFT,
    }.items():  # fmt: skip
        (root / "said" / name).parent.mkdir(parents=True, exist_ok=True)
        (root / "said" / name).write_text(text)
    where = LaunchEnvironment(root, (root,), {})
    analysis = analyze_systems(root, given([parse_request("said/main.launch")], where), Method(sources=Settings(jobs=1)))
    return analysis.systems[0]


@pytest.mark.parametrize(
    ("node", "names"),
    [
        ("none", {"/plain"}),
        ("one", {"/given"}),
        ("two", {"/two", "/twice"}),
        ("words", {"/a/first", "/few", "/outside"}),  # what is for ROS may be among the words
        ("deep/more", {"/deep/b/first", "/deep/inside"}),
        ("left", {"/x", "/single"}),
        ("both", {"/y", "/z", "/several"}),
        ("alone", {"/alone", "/home", "/none", "/alone/solitary", "/crawl"}),
        ("pair", {"/a", "/there", "/s", "/t", "/noise", "/together", "/b/seen", "/hurry"}),
        ("short", {"/a", "/home", "/none", "/together", "/c/seen", "/crawl"}),
    ],
)
def test_ports_that_the_command_line_makes(system: SystemModel, node: str, names: set[str]) -> None:
    (found,) = (each for each in system.nodes if each.name == f"/{node}")
    assert {port.name for port in found.ports if not port.implicit} == names
