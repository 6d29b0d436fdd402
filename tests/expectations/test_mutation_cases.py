"""Expectations as cases of the mutation of rules."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from rosarch.expectations.alone import Alone
from rosarch.expectations.cases import find_cases
from rosarch.expectations.mutation import mutation_cases
from rosarch.expectations.run import Running
from rosarch.models.rule_sets import SHIPPED, component_program

NODE = """\
// expect: publisher /out latched
// expect: N = count : { port_latched(Port) }, N = 1
#include <ros/ros.h>
#include <std_msgs/String.h>
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<std_msgs::String>("/out", 1, true);
}
"""
SCRIPT = "#!/usr/bin/env python3\n# expect: publisher /text\nimport rospy\nfrom std_msgs.msg import String\nrospy.Publisher('/text', String, queue_size=1)\n"


def test_other_rows_are_noticed_and_the_same_are_not(tmp_path: Path) -> None:
    (tmp_path / "node.cpp").write_text(NODE)
    how = Running(SHIPPED, partial(Alone, rules=SHIPPED, engine="embedded"), jobs=1)
    (case,) = mutation_cases(component_program(), find_cases([tmp_path / "node.cpp"]).cases, how)
    assert case.fails is not None and not case.fails(case.rows)
    assert case.notices({"port_latched": []})
    assert not case.notices({"port_latched": case.rows["port_latched"]})


def test_a_script_beside_other_sources_is_one_component(tmp_path: Path) -> None:
    (tmp_path / "node.cpp").write_text(NODE)
    (tmp_path / "script.py").write_text(SCRIPT)
    how = Running(SHIPPED, partial(Alone, rules=SHIPPED, engine="embedded"), jobs=1)
    cases = list(mutation_cases(component_program(), find_cases([tmp_path]).cases, how))
    assert sorted(case.name for case in cases) == [f"{tmp_path}: node", f"{tmp_path}: script"]
