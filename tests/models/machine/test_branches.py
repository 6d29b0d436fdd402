"""A function that sets the state and reports it, called in several branches of one callback: each call sends."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.analysis.components import analyze
from rosarch.analysis.method import Method
from rosarch.extractor.settings import Settings
from rosarch.models.component import to_json
from rosarch.models.machine.build import build_machine

CMAKE = """cmake_minimum_required(VERSION 2.8.3)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs)
catkin_package()
add_executable(node node.cpp)
"""
PACKAGE = """<package><name>node</name><version>0.0.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>l</license><buildtool_depend>catkin</buildtool_depend></package>
"""
NODE = """#include <ros/ros.h>
#include <std_msgs/Float32.h>
enum Mode { SEARCH, APPROACH, DOCKED };
class Docker {
public:
  Docker() {
    status_ = nh_.advertise<std_msgs::Float32>("status", 1);
    REGISTER
  }
private:
  void set(Mode mode) {
    mode_ = mode;
    status_.publish(std_msgs::Float32());
  }
  void CALLBACK {
    if (mode_ == SEARCH) {
      set(APPROACH);
    } else if (mode_ == APPROACH && ros::isStarted()) {
      set(DOCKED);
    }
  }
  Mode mode_ = SEARCH;
  ros::NodeHandle nh_;
  ros::Publisher status_;
  ros::Subscriber sub_;
  ros::Timer timer_;
};
int main(int argc, char** argv) {
  ros::init(argc, argv, "docker");
  Docker docker;
  ros::spin();
}
"""
MESSAGE = ('sub_ = nh_.subscribe("marker", 1, &Docker::step, this);', "step(const std_msgs::Float32& msg)")
TIMER = ("timer_ = nh_.createTimer(ros::Duration(0.1), &Docker::step, this);", "step(const ros::TimerEvent&)")


@pytest.mark.parametrize(("register", "callback"), [MESSAGE, TIMER])
def test_every_branch_that_calls_it_sends(tmp_path: Path, register: str, callback: str) -> None:
    sources = {
        "node.cpp": NODE.replace("REGISTER", register).replace("CALLBACK", callback),
        "CMakeLists.txt": CMAKE,
        "package.xml": PACKAGE,
    }
    for name, text in sources.items():
        (tmp_path / name).write_text(text)
    (model,) = analyze(tmp_path, method=Method(sources=Settings(jobs=1))).models
    (region,) = build_machine(to_json(model)).regions
    changing = [(each.target, len(each.outputs)) for each in region.transitions if each.target != each.source]
    assert changing
    assert all(sent == 1 for _, sent in changing)
