"""`rosarch why-silent`: the chain back to the first broken link, in one small workspace."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

PACKAGE = """<package format="3"><name>demo</name><version>1.0.0</version><description>A chain.</description>
<maintainer email="a@example.com">A</maintainer><license>Apache-2.0</license><buildtool_depend>catkin</buildtool_depend>
<depend>roscpp</depend><depend>std_msgs</depend></package>
"""
BUILD = """cmake_minimum_required(VERSION 3.10)
project(demo)
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs)
catkin_package()
add_executable(sensor sensor.cpp)
add_executable(filter filter.cpp)
add_executable(motor motor.cpp)
"""
SENSOR = """#include <ros/ros.h>
#include <std_msgs/Float64.h>
int main(int argc, char** argv) {
  ros::init(argc, argv, "sensor");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<std_msgs::Float64>("range_raw", 1);
  ros::Rate rate(10);
  while (ros::ok()) {
    pub.publish(std_msgs::Float64());
    rate.sleep();
  }
}
"""
FILTER = """#include <ros/ros.h>
#include <std_msgs/Float64.h>
ros::Publisher pub;
void take(const std_msgs::Float64& m) { pub.publish(m); }
int main(int argc, char** argv) {
  ros::init(argc, argv, "filter");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Float64>("range", 1);
  ros::Subscriber sub = nh.subscribe("range_rwa", 1, take);
  ros::spin();
}
"""
MOTOR = """#include <ros/ros.h>
#include <std_msgs/Float64.h>
void take(const std_msgs::Float64& m) {}
int main(int argc, char** argv) {
  ros::init(argc, argv, "motor");
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("range", 1, take);
  ros::spin();
}
"""
NODES = "".join(f'<node pkg="demo" type="{name}" name="{name}"/>' for name in ("sensor", "filter", "motor"))
FILES = {"package.xml": PACKAGE, "CMakeLists.txt": BUILD, "sensor.cpp": SENSOR, "filter.cpp": FILTER, "motor.cpp": MOTOR}
CHAIN = """/range in demo/demo.launch: nothing arrives
  read by /motor
  /filter sends on it  demo/filter.cpp:8
    it is made from /range_rwa: no node that is started sends on it
      /range_raw is sent and read by nobody (a few letters differ)
      /filter reads /range_rwa, which no node seen here publishes; /sensor publishes /range_raw, which none reads (a few letters differ)\
 [topic-name-mismatch]  demo/filter.cpp:9
"""


def workspace(root: Path, **changed: str) -> Path:
    (root / "demo").mkdir()
    for name, text in {**FILES, "demo.launch": f"<launch>{NODES}</launch>", **changed}.items():
        (root / "demo" / name).write_text(text, encoding="utf-8")
    return root


@pytest.mark.slow
def test_the_chain_leads_to_the_first_broken_link(rosarch: Callable, tmp_path: Path) -> None:
    root = workspace(tmp_path)
    outcome = rosarch("why-silent", str(root), "/range")
    assert (outcome.code, outcome.out, outcome.err) == (0, CHAIN, "")
    (found,) = json.loads(rosarch("why-silent", str(root), "range", "--format", "json").out)
    assert (found["system"], found["topic"], found["broken"], found["readers"]) == ("demo/demo.launch", "/range", True, ["/motor"])
    (sender,) = found["senders"]
    assert (sender["node"], sender["file"], sender["line"], sender["never_sent"]) == ("/filter", "demo/filter.cpp", 8, False)
    assert [(each["topic"], each["similar"]) for each in sender["inputs"]] == [
        ("/range_rwa", [{"topic": "/range_raw", "reason": "a few letters differ"}])
    ]
    assert rosarch("why-silent", str(root), "ranges").err == "rosarch: error: there is no topic `ranges`, did you mean `/range`?\n"


@pytest.mark.slow
def test_where_nothing_is_wrong(rosarch: Callable, tmp_path: Path) -> None:
    root = workspace(tmp_path, **{"filter.cpp": FILTER.replace("range_rwa", "range_raw")})
    assert rosarch("why-silent", str(root), "range").out == (
        "/range in demo/demo.launch: nothing was found that keeps messages from arriving\n"
        "  read by /motor\n"
        "  /filter sends on it  demo/filter.cpp:8\n"
        "    nothing was found that keeps it from sending\n"
    )


@pytest.mark.slow
def test_of_what_is_not_seen_nothing_is_claimed(rosarch: Callable, tmp_path: Path) -> None:
    nodes = NODES.replace('type="sensor"', 'type="driver"').replace('pkg="demo" type="driver"', 'pkg="other" type="driver"')
    root = workspace(tmp_path, **{"demo.launch": f"<launch>{nodes}</launch>"})
    shown = rosarch("why-silent", str(root), "range").out
    assert shown.startswith("/range in demo/demo.launch: nothing arrives, as far as was seen\n")
    assert "/range_rwa: no node that is started sends on it, as far as was seen" in shown
    assert [each["broken"] for each in json.loads(rosarch("why-silent", str(root), "range", "--format", "json").out)] == [False]


@pytest.mark.slow
def test_a_node_that_never_spins_and_a_part_of_a_node(rosarch: Callable, tmp_path: Path) -> None:
    root = workspace(tmp_path, **{"motor.cpp": MOTOR.replace("ros::spin", "ros::waitForShutdown")})
    assert "  /motor never spins" in rosarch("why-silent", str(root), "range").out
