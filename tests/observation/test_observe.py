"""`rosarch observe` and `rosarch compare`: what was seen of a small system, beside its model."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from recordings import STAMPED, Line, every, write

from rosarch.observation.master import Master
from rosarch.observation.peer import MessageType, Peer
from rosarch.observation.processes import wait_until

pytestmark = pytest.mark.slow

PACKAGE = """<package format="2"><name>demo</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>BSD</license></package>"""
BUILD = "project(demo)\nadd_executable(filter filter.cpp)\nadd_executable(motor motor.cpp)\n"
FILTER = """#include <ros/ros.h>
#include <geometry_msgs/PointStamped.h>
ros::Publisher pub;
void onRaw(const geometry_msgs::PointStamped& raw)
{
  geometry_msgs::PointStamped smooth = raw;
  pub.publish(smooth);
}
int main(int argc, char** argv)
{
  ros::init(argc, argv, "filter");
  ros::NodeHandle nh;
  pub = nh.advertise<geometry_msgs::PointStamped>("smooth", 1);
  ros::Subscriber sub = nh.subscribe("raw", 1, onRaw);
  ros::spin();
}
"""
MOTOR = """#include <cstdlib>
#include <ros/ros.h>
#include <std_msgs/Float32.h>
int main(int argc, char** argv)
{
  ros::init(argc, argv, "motor");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<std_msgs::Float32>("current", 1);
  ros::Publisher other = nh.advertise<std_msgs::Float32>(getenv("TOPIC"), 1);
  ros::Rate rate(10);
  while (ros::ok())
  {
    std_msgs::Float32 current;
    pub.publish(current);
    other.publish(current);
    rate.sleep();
  }
}
"""
LAUNCH = '<launch><node pkg="demo" type="filter" name="filter"/><node pkg="demo" type="motor" name="motor"/></launch>'
FILES = {"package.xml": PACKAGE, "CMakeLists.txt": BUILD, "filter.cpp": FILTER, "motor.cpp": MOTOR, "demo.launch": LAUNCH}
FLOAT = MessageType("std_msgs/Float32", "73fcbf46b49191e672908e50842a83d4")
COMPARED = """demo/demo.launch: predicted and seen
  kind        predicted  seen  both  filled  under-approximation (%)  over-approximation (%)
  node                2     2     1       0                   50.000                  50.000
  topic               3     3     1       1                   66.667                  66.667
  publisher           2     3     1       1                   66.667                  50.000
  subscriber          1     1     0       0                  100.000                 100.000
  parameter           0     1     0       0                  100.000                       -
  connection          0     1     0       0                  100.000                       -

what differs (missed: seen, not predicted; unseen: predicted, not seen)
  outcome  kind        what                          reason
  filled   publisher   /torque of /motor             -
  filled   topic       /torque                       -
  missed   connection  /current /stranger of /motor  -
  missed   node        /stranger                     -
  missed   parameter   /speed                        -
  missed   publisher   /noise of /stranger           no launch file starts its node
  missed   subscriber  /current of /stranger         no launch file starts its node
  missed   topic       /noise                        -
  unseen   node        /filter                       -
  unseen   publisher   /smooth of /filter            its node did not run
  unseen   subscriber  /raw of /filter               its node did not run
  unseen   topic       /raw                          -
  unseen   topic       /smooth                       -

observed, where the sources do not tell
  what  of                                           is
  name  the publisher of /motor at demo/motor.cpp:9  /torque
"""


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("observed")
    (root / "demo").mkdir()
    for name, text in FILES.items():
        (root / "demo" / name).write_text(text, encoding="utf-8")
    return root


def lines(**changed: Line) -> list[Line]:
    """What the system sends when all is well."""
    raw = Line("/raw", "geometry_msgs/PointStamped", "/camera", every(0.05, 0, 5), STAMPED)
    smooth = Line("/smooth", "geometry_msgs/PointStamped", "/filter", every(0.05, 0, 5), STAMPED, delay=0.004)
    current = Line("/current", "std_msgs/Float32", "/motor", every(0.1, 0, 5))
    return list({"raw": raw, "smooth": smooth, "current": current, **changed}.values())


def test_a_recording_of_what_was_predicted(rosarch: Callable, workspace: Path) -> None:
    bag = write(workspace / "good.bag", lines())
    outcome = rosarch("observe", workspace, "--bag", bag, "--format", "json")
    found = json.loads(outcome.out)
    assert (outcome.code, found["comparison"]["contradictions"], found["problems"]) == (0, [], [])
    rates = {topic["topic"]: topic["hz"] for topic in found["topics"]}
    assert rates == {"/raw": pytest.approx(20), "/smooth": pytest.approx(20), "/current": pytest.approx(10)}
    assert {delay["by"]: delay["median"] for delay in found["delays"]} == dict.fromkeys(
        ("stamp", "sequence", "order"), pytest.approx(0.004, rel=0.02)
    )
    filled = {"what": "rate", "subject": "/raw", "value": "20 Hz", "provenance": "observed"}
    assert filled in found["comparison"]["filled"]
    outcomes = {(item["kind"], item["owner"], item["name"]): item["outcome"] for item in found["comparison"]["elements"]}
    assert outcomes["publisher", "/filter", "/smooth"] == "confirmed"
    assert ("subscriber", "/filter", "/raw") not in outcomes


def test_contradictions_have_both_proofs(rosarch: Callable, workspace: Path) -> None:
    late = [time for number, time in enumerate(every(0.05, 0, 5)) if number % 2]
    smooth = Line("/smooth", "geometry_msgs/PoseStamped", "/filter", late, STAMPED, delay=0.004)
    bag = write(workspace / "bad.bag", lines(smooth=smooth, current=Line("/current", "std_msgs/Float32", "/motor", every(0.25, 0, 5))))
    outcome = rosarch("observe", workspace, "--bag", bag)
    assert outcome.code == 1
    told = outcome.out[outcome.out.index("demo/filter.cpp:13") :]
    name = f"recording {bag}"
    assert told == (
        "demo/filter.cpp:13: warning: 50 of 100 messages on /raw were answered on /smooth, but /filter should answer each"
        "  [observed-answer-missing]\n"
        "  demo/demo.launch:1: /filter is started\n"
        f"  {name}:2: 50 messages on /smooth of /filter, 10 a second\n"
        "demo/filter.cpp:13: warning: /smooth has the type geometry_msgs/PoseStamped, but the source of /filter says geometry_msgs/PointStamped"
        "  [observed-type-differs]\n"
        "  demo/demo.launch:1: /filter is started\n"
        f"  {name}:2: 50 messages on /smooth of /filter, 10 a second\n"
        "demo/motor.cpp:8: warning: 4.0 messages per second pass through /current, but /motor and others that send there send 10.0 at least"
        "  [observed-rate-differs]\n"
        "  demo/demo.launch:1: /motor is started\n"
        f"  {name}:3: 20 messages on /current of /motor, 4 a second\n"
    )


def test_what_of_a_recording_is_not_readable(rosarch: Callable, workspace: Path) -> None:
    bag = write(workspace / "cut.bag", [*lines(), Line("/odd", "demo/Odd", "/odd", [1.0], "")])
    bag.write_bytes(bag.read_bytes()[:-10])
    outcome = rosarch("observe", workspace, "--bag", bag, "--format", "markdown")
    assert outcome.out.startswith(f"# recording {bag}: ")
    assert f"- note: {bag}: no definition of demo/Odd: headers are not read\n" in outcome.out
    assert "what comes after it is not read\n" in outcome.out
    assert "| /current | std_msgs/Float32 | /motor |" in outcome.out


def test_a_live_graph(rosarch: Callable, workspace: Path) -> None:
    """Nodes of this process stand for those of the system: one with a topic that the source does not name, one of nobody."""
    with Master() as master, Peer(master.uri, "/motor") as motor, Peer(master.uri, "/stranger") as stranger:
        motor.advertise("/current", FLOAT)
        motor.advertise("/torque", FLOAT)
        stranger.advertise("/noise", FLOAT)
        stranger.subscribe("/current", lambda *_: None)
        master.parameters.set("/speed", 3)
        assert wait_until(lambda: motor.readers("/current"), 3)
        compared = rosarch("compare", workspace, "--master", master.uri)
        observed = rosarch("observe", workspace, "--master", master.uri, "--seconds", 0.2, "--every", 0.1, "--format", "json")
    assert compared.out == COMPARED
    assert compared.code == 0
    snapshots = json.loads(observed.out)["snapshots"]
    assert [snapshot["at"] for snapshot in snapshots] == [0.0, pytest.approx(0.1, abs=0.09), pytest.approx(0.2, abs=0.09)]
    assert snapshots[0]["parameters"] == ["/speed"]
    assert {"kind": "topic", "name": "/torque", "type": "std_msgs/Float32"} in snapshots[0]["types"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "give one of --bag, --master and --domain"),
        (("--bag", "x.bag", "--master", "http://localhost:1"), "give one of --bag, --master and --domain"),
        (("--bag", "gone.bag"), "gone.bag: No such file or directory"),
        (("--master", "http://127.0.0.1:9"), "http://127.0.0.1:9: no answer to getSystemState: Connection refused"),
        (("--master", "robot"), "robot: not the address of a master, such as http://localhost:11311"),
    ],
)
def test_what_cannot_be_looked_at(arguments: tuple[str, ...], message: str, rosarch: Callable, workspace: Path) -> None:
    outcome = rosarch("observe", workspace, *arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err.splitlines()[-1] == f"rosarch: error: {message}"
