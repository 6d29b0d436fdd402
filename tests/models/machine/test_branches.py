"""A function that sets the state and reports it, called in several branches of one callback: each call sends."""

from __future__ import annotations

from pathlib import Path

import pytest
from node_package import node_model

from rosarch.models.component import to_json
from rosarch.models.machine.build import build_machine

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
    model = node_model(tmp_path, NODE.replace("REGISTER", register).replace("CALLBACK", callback))
    (region,) = build_machine(to_json(model)).regions
    changing = [(each.target, len(each.outputs)) for each in region.transitions if each.target != each.source]
    assert changing
    assert all(sent == 1 for _, sent in changing)
