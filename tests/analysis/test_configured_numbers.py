"""Conditions on numbers that the configuration decides, and those that only seem to be decided by it."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import analyze_systems
from rosarch.analysis.systems.launches import given
from rosarch.analysis.systems.requests import LaunchEnvironment, parse_request
from rosarch.extractor.settings import Settings

MANIFEST = """<package format="2"><name>num</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>
<depend>roscpp</depend><depend>std_msgs</depend></package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.0)
project(num)
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs)
add_executable(num src/num.cpp)
"""
SOURCE = """#include <algorithm>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
class Num {
public:
  Num() : own_("~") {
    own_.param("turbo", turbo_, -1);
    own_.param("rate", rate_, 10.0);
    own_.param("count", count_, 3);
    own_.param("whole", whole_, 1);
    own_.param("wide", wide_, 7);
    own_.param("left", left_, 2);
    own_.param("limit", limit_, 3);
    own_.param("speed", speed_, 5.0);
    own_.param("angle", angle_, 90.0);
    own_.param("least", least_, 4);
    speed_ = std::min(speed_, 1.0);
    angle_ *= 0.01;
    if (least_ < 0) least_ = 0;
    const size_t many = wide_;
    if (turbo_ >= 0) open("turbo");
    if (rate_ == 0) open("no_rate");
    if (0 < count_ && count_ != 2) open("counted");
    if (whole_ > 0) open("whole");
    if (many > 5) open("many");
    if (least_ == 0) open("least");
    if (speed_ > 2.0) open("fast");
    if (angle_ > 2.0) open("turned");
    in_ = nh_.subscribe("in", 1, &Num::onIn, this);
  }

private:
  void open(const std::string& name) { out_.push_back(nh_.advertise<std_msgs::Int32>(name, 1)); }
  void onIn(const std_msgs::Int32& msg) {
    --left_;
    limit_ = msg.data;
    if (left_ <= 0) open("gone");
    if (limit_ > 3) open("above");
  }
  ros::NodeHandle nh_, own_;
  ros::Subscriber in_;
  std::vector<ros::Publisher> out_;
  int turbo_, count_, whole_, wide_, left_, limit_, least_;
  double rate_, speed_, angle_;
};
int main(int argc, char** argv) {
  ros::init(argc, argv, "num");
  Num num;
  ros::spin();
}
"""
LAUNCH = """<launch>
<node pkg="num" type="num" name="plain"/>
<node pkg="num" type="num" name="other">
  <param name="turbo" value="2"/> <param name="rate" value="0.0"/> <param name="count" value="2"/>
  <param name="whole" value="0.5"/> <param name="wide" value="-1"/> <param name="least" value="-3"/>
</node>
</launch>
"""


@pytest.mark.slow
def test_comparisons_of_numbers(tmp_path: Path) -> None:
    for name, text in {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE, "src/num.cpp": SOURCE, "main.launch": LAUNCH}.items():
        (tmp_path / "num" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "num" / name).write_text(text)
    where = LaunchEnvironment(tmp_path, (tmp_path,), {})
    system = analyze_systems(tmp_path, given([parse_request("num/main.launch")], where), Method(sources=Settings(jobs=1))).systems[0]
    found = {
        node.name: {port.name.strip("/"): bool(port.conditional) for port in node.ports if port.kind == "publisher" and not port.implicit}
        for node in system.nodes
    }
    # what is decided is there without a condition, or not at all; what counts, is assigned or converted is open
    open_ = {"many", "fast", "turned", "gone", "above"}
    assert found["/plain"] == dict.fromkeys(("counted", "whole"), False) | dict.fromkeys(open_, True)
    assert found["/other"] == dict.fromkeys(("turbo", "no_rate", "least"), False) | dict.fromkeys(("whole", *open_), True)
