"""`rosarch ask`: chains of cause and effect, and rates, in one small workspace."""

from __future__ import annotations

import base64
import json
import re
import shutil
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

PACKAGE = """<package format="2"><name>demo</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>BSD</license></package>"""
BUILD = "cmake_minimum_required(VERSION 3.0)\nproject(demo)\nadd_executable(filter filter.cpp)\nadd_executable(motor motor.cpp)\n"
FILTER = """#include <ros/ros.h>
#include <std_msgs/Float32.h>
ros::Publisher pub;
void onRaw(const std_msgs::Float32& raw)
{
  std_msgs::Float32 smooth;
  smooth.data = raw.data / 2;
  pub.publish(smooth);
}
int main(int argc, char** argv)
{
  ros::init(argc, argv, "filter");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Float32>("smooth", 1);
  ros::Subscriber sub = nh.subscribe("raw", 1, onRaw);
  ros::spin();
}
"""
MOTOR = """#include <ros/ros.h>
#include <std_msgs/Float32.h>
float goal = 0;
void onGoal(const std_msgs::Float32& smooth)
{
  goal = smooth.data;
}
int main(int argc, char** argv)
{
  ros::init(argc, argv, "motor");
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("smooth", 2, onGoal);
  ros::Publisher pub = nh.advertise<std_msgs::Float32>("current", 1);
  ros::Rate rate(10);
  while (ros::ok())
  {
    ros::spinOnce();
    std_msgs::Float32 current;
    current.data = goal;
    if (goal > 0)
      pub.publish(current);
    rate.sleep();
  }
}
"""
LAUNCH = '<launch><node pkg="demo" type="filter" name="filter"/><node pkg="demo" type="motor" name="motor"/></launch>'
FILES = {"package.xml": PACKAGE, "CMakeLists.txt": BUILD, "filter.cpp": FILTER, "motor.cpp": MOTOR, "demo.launch": LAUNCH}
YES = """yes: raw of filter can cause current of motor in demo/demo.launch
  /filter reads /raw  demo/filter.cpp:15
    /filter reacts, data: /raw -> /smooth  demo/filter.cpp:8
    arrives at /motor reads /smooth  demo/motor.cpp:12
    /motor sends it in a loop or timer, data: /smooth -> /current; through ::goal; if goal > 0; decided by ::goal;\
 callbacks run once a round: 0.1 s; sent in the next round: 0.1 s  demo/motor.cpp:22
  waits 0.2 s at most, besides execution
"""


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("ask")
    (root / "demo").mkdir()
    for name, text in FILES.items():
        (root / "demo" / name).write_text(text, encoding="utf-8")
    (root / ".rosarch.yml").write_text("rates: {/raw: [4, 20]}\n", encoding="utf-8")
    return root


def test_a_chain_is_told(rosarch: Callable, workspace: Path) -> None:
    outcome = rosarch("ask", str(workspace), "can raw of filter cause current of motor")
    assert (outcome.code, outcome.out, outcome.err) == (0, YES, "")


def test_what_cuts_it_is_told(rosarch: Callable, workspace: Path) -> None:
    outcome = rosarch("ask", str(workspace), "can current of motor cause raw of filter?")
    assert outcome.out == (
        "no: current of motor cannot cause raw of filter in demo/demo.launch\n"
        "the influence ends at:\n"
        "  /motor publishes /current  demo/motor.cpp:13: no node reads it\n"
    )


def test_what_need_not_follow_is_told(rosarch: Callable, workspace: Path) -> None:
    assert rosarch("ask", str(workspace), "must raw of filter cause smooth of motor").out.startswith(
        "yes: raw of filter always causes smooth"
    )
    outcome = rosarch("ask", str(workspace), "must raw cause current", "--format", "json")
    (answer,) = json.loads(outcome.out)
    assert (answer["answer"], answer["waits"]) == ("no", pytest.approx(0.2))
    assert [(step["from"]["name"], step["to"]["name"], step["condition"]) for step in answer["uncertain"]] == [
        ("/smooth", "/current", "goal > 0")
    ]


def test_a_mark_before_a_question_does_not_change_it(rosarch: Callable, workspace: Path) -> None:
    assert rosarch("ask", str(workspace), "? must raw cause current") == rosarch("ask", str(workspace), "must raw cause current")


def test_rates_are_told(rosarch: Callable, workspace: Path) -> None:
    assert rosarch("ask", str(workspace), "rate of *").out == (
        "rates in demo/demo.launch\n  /current  0 to 10 Hz  /motor\n  /raw      4 to 20 Hz\n  /smooth   4 to 20 Hz  /filter\n"
    )
    (found,) = json.loads(rosarch("ask", str(workspace), "rate of smooth", "--format", "json").out)
    assert found["rates"] == [{"topic": "/smooth", "low": 4.0, "high": 20.0, "senders": ["/filter"], "reasons": []}]


def test_systems_that_lack_what_is_asked_about_are_left_out(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    shutil.copytree(workspace, copy)
    (copy / "demo" / "a.launch").write_text('<launch><node pkg="demo" type="motor" name="motor"/></launch>', encoding="utf-8")
    assert rosarch("ask", str(copy), "rate of raw").out == "rates in demo/demo.launch\n  /raw  4 to 20 Hz\n"
    assert rosarch("ask", str(copy), "can raw of filter cause current of motor").out == YES


@pytest.mark.parametrize(
    ("question", "message"),
    [
        ("can raw of filtr cause current", "no node `filtr` with ports, did you mean `/filter`?"),
        ("can raw of motor cause current", "`/motor` has no port `raw`"),
        ("can raww cause current", "there is no port `raww`, did you mean `raw`?"),
        ("rate of /smoth", "there is no topic `/smoth`, did you mean `/smooth`?"),
        ("does raw cause current", "question:1:1: expected `can` or `must` or `rate`, not `does`"),
        ("can raw couse current", "question:1:9: expected `cause`, not `couse`, did you mean `cause`?"),
        ("can raw cause", "question:1:14: expected a name, not the end"),
        ("can raw cause current now", "question:1:23: expected the end, not `now`"),
    ],
)
def test_what_is_wrong_with_a_question_is_told(rosarch: Callable, workspace: Path, question: str, message: str) -> None:
    outcome = rosarch("ask", str(workspace), question)
    assert (outcome.code, outcome.out, outcome.err) == (2, "", f"rosarch: error: {message}\n")


def test_rates_that_are_none_are_told(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    shutil.copytree(workspace, copy)
    (copy / ".rosarch.yml").write_text("rates:\n  raw: 1\n  /a: fast\n  /b: [3, 2]\n  /c: [1, 2, 3]\n", encoding="utf-8")
    path = copy / ".rosarch.yml"
    assert rosarch("ask", str(copy), "rate of *").err == (
        f"rosarch: error: {path}:2:3: the name of a topic begins with `/`, not `raw`\n"
        f"{path}:3:7: `fast` is no number of messages a second\n"
        f"{path}:4:7: the least rate, 3, is more than the most, 2\n"
        f"{path}:5:7: a rate is a number, or two: the least and the most\n"
    )


def test_queries_have_the_flow_of_data_followed_that_they_rest_on(rosarch: Callable, workspace: Path) -> None:
    launch = ("--launch", "demo/demo.launch")
    asked = 'chain_step([_, From, _], [_, To, _], How, "reactive")'
    (found,) = json.loads(rosarch("query", workspace, asked, *launch, "--format", "json").out)
    assert [(row["From"], row["To"], row["How"]) for row in found["rows"]] == [("demo/filter#p2", "demo/filter#p1", "data")]
    explained = rosarch("explain", workspace, asked.replace("From", "_").replace("To", "_").replace("How", "_"), *launch)
    assert "interface_port_flow" in explained.out, explained.err
    told = rosarch("query", workspace, "flows_analysed(Name)", "--component", "filter")
    assert told.out.splitlines()[-2:] == ["filter", "1 row"]


def test_reports_have_the_steps_of_chains(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    page = tmp_path / "report.html"
    assert rosarch("report", workspace, "--chains", "--no-proofs", "-o", page).code == 0
    block = re.search(r'id="document">([^<]*)<', page.read_text(encoding="utf-8"))
    (system,) = json.loads(zlib.decompress(base64.b64decode(block[1])))["systems"]  # type: ignore[index]

    def name(end: list[int]) -> str:
        node = system["nodes"][end[0]]
        return f"{node['name']} {node['ports'][end[1]]['name']}"

    found = {(name(source), name(sink), how, kind, certain) for source, sink, how, kind, certain in system["steps"]}
    assert found == {
        ("/filter /raw", "/filter /smooth", "data", "reactive", True),
        ("/filter /smooth", "/motor /smooth", "data", "connection", True),
        ("/motor /smooth", "/motor /current", "data", "deferred", False),
    }
    assert {rate["topic"]: (rate["low"], rate["high"]) for rate in system["rates"]}["/current"] == (0.0, 10.0)
