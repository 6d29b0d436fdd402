"""Expectations as cases of the mutation of rules."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest

from rosarch.analysis.method import Method
from rosarch.evaluation.expectations.alone import Alone
from rosarch.evaluation.expectations.cases import find_cases
from rosarch.evaluation.expectations.mutation import mutation_cases
from rosarch.evaluation.expectations.run import Running
from rosarch.evaluation.expectations.system_mutation import finding_cases
from rosarch.extractor.settings import Settings
from rosarch.rule_programs.sets import SHIPPED, component_program
from tests.rules.rule_cases import case_of, facts_and_program

pytestmark = pytest.mark.slow

CHECKS = Path(__file__).resolve().parents[2] / "rules" / "checks"

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
    how = Running(partial(Alone, rules=SHIPPED, engine="embedded"), Method(sources=Settings(jobs=1)))
    (case,) = mutation_cases(component_program(), find_cases([tmp_path / "node.cpp"]).cases, how)
    assert case.fails is not None and not case.fails(case.rows)
    assert case.notices({"port_latched": []})
    assert not case.notices({"port_latched": case.rows["port_latched"]})


def test_a_script_beside_other_sources_is_one_component(tmp_path: Path) -> None:
    (tmp_path / "node.cpp").write_text(NODE)
    (tmp_path / "script.py").write_text(SCRIPT)
    how = Running(partial(Alone, rules=SHIPPED, engine="embedded"), Method(sources=Settings(jobs=1)))
    cases = list(mutation_cases(component_program(), find_cases([tmp_path]).cases, how))
    assert sorted(case.name for case in cases) == [f"{tmp_path}: node", f"{tmp_path}: script"]


ECHO = """\
#include <ros/ros.h>
#include <std_msgs/String.h>
ros::Publisher pub;
void echo(const std_msgs::String& text) { pub.publish(text); }
int main(int argc, char** argv)
{
  ros::init(argc, argv, "echo");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::String>("/text", 1);
  ros::Subscriber sub = nh.subscribe("/text", 1, echo);  // expect: finding reactive-cycle
  ros::spin();
}
"""


def test_findings_that_are_gone_are_noticed(tmp_path: Path) -> None:
    (tmp_path / "echo.cpp").write_text(ECHO)
    how = Running(partial(Alone, rules=SHIPPED, engine="embedded"), Method(sources=Settings(jobs=1)))
    (case,) = mutation_cases(component_program(), find_cases([tmp_path / "echo.cpp"]).cases, how)
    assert case.notices({"reacts": []})
    assert not case.notices({"node_name": []})


def test_systems_in_which_checks_find_other_things(tmp_path: Path) -> None:
    """The systems of a workspace are looked at together: what one of them has, another need not have."""
    facts, _ = facts_and_program(case_of(CHECKS / "topic-type-mismatch.dl", "fires"))
    (tmp_path / "package.xml").write_text("<package><name>demo</name></package>")
    (tmp_path / "demo.launch").write_text("<launch>\n  <!-- expect: finding topic-type-mismatch -->\n  <group/>\n</launch>\n")
    expected = find_cases([tmp_path]).cases

    def noticed(*systems: object) -> list[bool]:
        cases = finding_cases(expected, Running(lambda _: SimpleNamespace(rows=lambda: systems)))
        return [case.notices({"topic_type_mismatch": []}) for case in cases]

    placed = {**facts, "place": [(at, "demo.launch", 3, 1) for at, *_ in facts["place"]]}
    assert (noticed(placed), noticed(placed, placed)) == ([True], [False, False])
