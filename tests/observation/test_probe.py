"""Experiments with real nodes: what they do is confirmed, and where they do something else the model is refuted."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from nodes import EXAMPLES, build, needs_ros

pytestmark = pytest.mark.slow

DOCKING = "docking_states/src/auto_docking"
CANCELLED = "  state_ = State::IDLE;\n  publishState();"


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """The node of the example, and one that does not stop when it is cancelled and crashes when it is charged."""
    folder = tmp_path_factory.mktemp("nodes")
    text = (EXAMPLES / DOCKING / "src" / "docking.cpp").read_text()
    assert CANCELLED in text
    other = text.replace(CANCELLED, "  publishState();").replace("    state_ = State::DOCKED;\n", "    ::abort();\n")
    (folder / "other.cpp").write_text(other)
    docking, changed = build(folder, [f"{DOCKING}/src/docking.cpp", str(folder / "other.cpp")], f"{DOCKING}/include")
    return {"docking": docking, "other": changed}


def probed(rosarch: Callable, program: Path) -> tuple[int, dict]:
    outcome = rosarch("probe", EXAMPLES / "docking_states", "docking", "--executable", program, "--trials", 8, "--format", "json")
    return outcome.code, json.loads(outcome.out)


@needs_ros
def test_what_the_node_does_is_confirmed(rosarch: Callable, built: dict[str, Path]) -> None:
    code, found = probed(rosarch, built["docking"])
    verdicts = [each["verdict"] for each in found["verdicts"]]
    assert (code, verdicts.count("refuted")) == (0, 0)
    assert verdicts.count("confirmed") >= 0.9 * 12
    (rate,) = found["rates"]
    assert rate["measured"] == pytest.approx(rate["predicted"], rel=0.05)
    (response,) = (time for time in found["times"] if (time["from"], time["to"]) == ("/docking/cancel", "response"))
    assert 0 < response["least"] <= response["median"] <= response["p99"]
    assert found["node"] == "/docking"


@needs_ros
def test_what_the_node_does_otherwise_is_refuted(rosarch: Callable, built: dict[str, Path]) -> None:
    code, found = probed(rosarch, built["other"])
    verdicts = {(each["kind"], each["at"].rpartition(":")[2]): each for each in found["verdicts"]}
    assert code == 1
    assert verdicts["transitions", "40"]["verdict"] == "refuted"
    assert verdicts["transitions", "40"]["reason"] == "/docking/cancel made it send /cmd_vel and /docking/state"
    assert verdicts["transitions", "71"]["reason"] == "after /charging with charging->data it was killed by SIGABRT"
    assert [each["at"] for each in found["verdicts"] if each["verdict"] == "refuted"] == ["src/auto_docking/src/docking.cpp:40"]


OPEN = """\
#include <algorithm>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <string>
int main(int argc, char ** argv)
{
  ros::init(argc, argv, "open");
  ros::NodeHandle nh;
  std::string robot("tobor");
  std::reverse(robot.begin(), robot.end());
  ros::Publisher any = nh.advertise<std_msgs::Bool>(robot, 1);
  ros::Publisher below = nh.advertise<std_msgs::Bool>(robot + "/ready", 1);
  ros::Publisher known = nh.advertise<std_msgs::Bool>("known", 1);
  ros::spin();
}
"""


@needs_ros
def test_names_that_the_sources_leave_open_are_those_of_the_node(rosarch: Callable, tmp_path: Path) -> None:
    package = tmp_path / "ws" / "open"
    package.mkdir(parents=True)
    (package / "open.cpp").write_text(OPEN)
    (package / "CMakeLists.txt").write_text("project(open)\nfind_package(catkin)\ncatkin_package()\nadd_executable(open open.cpp)\n")
    (package / "package.xml").write_text(
        '<package format="2"><name>open</name><version>1.0.0</version><description>d</description>'
        '<maintainer email="m@example.com">m</maintainer><license>BSD</license><buildtool_depend>catkin</buildtool_depend></package>'
    )
    (program,) = build(tmp_path, [str(package / "open.cpp")])
    outcome = rosarch("probe", tmp_path / "ws", "open", "--executable", program, "--format", "json")
    names = {(each["of"], each["name"], each["provenance"]) for each in json.loads(outcome.out)["names"]}
    assert names == {
        ("the publisher of /open at open/open.cpp:11", "/robot", "observed"),
        ("the publisher of /open at open/open.cpp:11", "/robot/ready", "observed"),
        ("the publisher of /open at open/open.cpp:12", "/robot/ready", "observed"),
    }


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("docking",), "name the node that was built with --executable, or ask for the plan alone with --plan"),
        (("docking", "--executable", "gone"), "gone: no executable"),
        (("dockin", "--plan"), "no node or nodelet dockin, did you mean `docking`?"),
    ],
)
def test_what_cannot_be_probed(arguments: tuple[str, ...], message: str, rosarch: Callable) -> None:
    folder = EXAMPLES / "docking_states"
    outcome = rosarch("probe", folder, *arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err.splitlines()[-1] == f"rosarch: error: {message}"
