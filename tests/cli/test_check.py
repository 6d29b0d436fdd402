"""`rosarch check` from end to end, over a workspace with a talker, a listener and their launch files."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

LISTENER = """#include <ros/ros.h>
#include <std_msgs/Int32.h>

void onNumber(const std_msgs::Int32::ConstPtr&) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "listener");
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("numbers", 10, onNumber);
  ros::spin();
}
"""
ROBOT = """<launch>
  <arg name="topic" default="other"/>
  <node pkg="talker" type="talker" name="talker"/>
  <node pkg="talker" type="listener" name="listener">
    <remap from="numbers" to="$(arg topic)"/>
  </node>
</launch>
"""
MISMATCH = (
    "ws/talker/listener.cpp:10:25: error: /listener reads /chatter as std_msgs/Int32, but /talker publishes it as std_msgs/String"
    "  [topic-type-mismatch]"
)


@pytest.fixture
def ws(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The workspace, below the current folder."""
    package = workspace / "talker"
    (package / "listener.cpp").write_text(LISTENER)
    with (package / "CMakeLists.txt").open("a") as build:
        build.write("add_executable(listener listener.cpp)\n")
    (package / "robot.launch").write_text(ROBOT)
    monkeypatch.chdir(workspace.parent)
    monkeypatch.delenv("ROS_PACKAGE_PATH", raising=False)
    return Path("ws")


def heads(out: str) -> list[str]:
    return [line for line in out.splitlines() if line.endswith("]")]


@pytest.mark.slow
def test_a_finding(ws: Path, rosarch: Callable) -> None:
    outcome = rosarch("check", ws, "--launch", "talker/robot.launch topic:=chatter")
    assert (outcome.code, outcome.err) == (1, "")
    assert outcome.out == (
        f"{MISMATCH}\n"
        '  10 |   ros::Subscriber sub = nh.subscribe("numbers", 10, onNumber);\n'
        "     |                         ^~~~~~~~~~~~ subscriber /chatter of /listener\n"
        "  ws/talker/robot.launch:5: /numbers is remapped to /chatter\n"
        '   5 |     <remap from="numbers" to="$(arg topic)"/>\n'
        "     |     ^~~~~~\n"
        "  ws/talker/robot.launch:4: /listener is started\n"
        '   4 |   <node pkg="talker" type="listener" name="listener">\n'
        "     |   ^~~~~\n"
        "  ws/talker/talker.cpp:8: publisher /chatter of /talker\n"
        '   8 |   ros::Publisher pub = nh.advertise<std_msgs::String>("chatter", 10);\n'
        "     |                        ^~~~~~~~~~~~\n"
        "  ws/talker/robot.launch:3: /talker is started\n"
        '   3 |   <node pkg="talker" type="talker" name="talker"/>\n'
        "     |   ^~~~~\n"
        "  hint: Use one message type, or rename one of the topics.\n"
        "  in: talker/robot.launch topic:=chatter\n"
        "\n"
        "1 finding: 1 error\n"
        "checked 1 system with 2 nodes\n"
    )


@pytest.mark.slow
def test_only_notes_are_no_failure(ws: Path, rosarch: Callable) -> None:
    outcome = rosarch("check", ws)
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out == "2 findings: 2 notes; -v shows the notes\nchecked 1 system with 2 nodes\n"
    assert [line.partition(": note: ")[2] for line in heads(rosarch("check", ws, "-v").out)] == [
        "/listener reads /other (std_msgs/Int32), and no publisher of it was seen  [subscriber-without-publisher]",
        "/talker publishes /chatter (std_msgs/String), and no subscriber of it was seen  [publisher-without-subscriber]",
    ]
    assert rosarch("check", ws, "--fail-on", "note").code == 1


@pytest.mark.slow
def test_what_is_withheld_is_shown_with_what_was_not_seen(ws: Path, rosarch: Callable) -> None:
    (ws / "talker/listener.cpp").write_text(LISTENER.replace("  ros::spin();", "  absent::attach(nh);\n  ros::spin();"))
    (ws / "talker/robot.launch").write_text(ROBOT.replace('from="numbers"', 'from="figures"'))
    assert "remap-without-effect" not in rosarch("check", ws).out
    outcome = rosarch("check", ws, "--withheld")
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.splitlines()[:2] == [
        "ws/talker/robot.launch:5:5: withheld: the remapping of figures to other has no effect: no node that gets it uses the name"
        "  [remap-without-effect]",
        "  not seen: /listener: the node is handed to absent::attach, which was not seen (ws/talker/listener.cpp:11)",
    ]
    (withheld,) = json.loads(rosarch("check", ws, "--withheld", "--format", "json").out)["withheld"]
    assert [(part["node"], part["file"], part["line"]) for part in withheld["because"]] == [("/listener", "talker/listener.cpp", 11)]


def test_a_matrix_of_arguments(ws: Path, rosarch: Callable) -> None:
    outcome = rosarch("check", ws, "--launch", "talker/robot.launch topic:=chatter,other", "--format", "json")
    (found,) = (finding for finding in json.loads(outcome.out)["findings"] if finding["severity"] == "error")
    assert (outcome.code, found["check"], found["systems"]) == (1, "topic-type-mismatch", ["talker/robot.launch topic:=chatter"])
    assert (found["file"], found["line"]) == ("talker/listener.cpp", 10)


def test_launch_files_that_are_started_together(ws: Path, rosarch: Callable) -> None:
    (ws / "talker" / "second.launch").write_text(
        '<launch><node pkg="talker" type="talker" name="loud"><remap from="chatter" to="other"/></node></launch>'
    )
    outcome = rosarch("check", ws, "--launch", "talker/robot.launch talker/second.launch")
    assert outcome.code == 1
    assert "error: /listener reads /other as std_msgs/Int32, but /loud publishes it as std_msgs/String" in outcome.out
    assert "  in: talker/robot.launch talker/second.launch\n" in outcome.out
    apart = rosarch("check", ws, "--launch", "talker/robot.launch", "--launch", "talker/second.launch")
    assert (apart.code, apart.out.splitlines()[-1]) == (0, "checked 2 systems with 3 nodes")


def test_the_launch_section_of_the_configuration(ws: Path, rosarch: Callable) -> None:
    (ws / ".rosarch.yml").write_text("launch: [{files: [talker/robot.launch], arguments: {topic: [chatter]}}]\n")
    assert heads(rosarch("check", ws).out) == [MISMATCH]
    assert rosarch("check", ws, "--launch", "talker/robot.launch").code == 0
    (ws / "other.yml").write_text("launch: [talker/robot.launch]\nchecks: {'*': ignore}\n")
    assert rosarch("check", ws, "--config", ws / "other.yml").out == "no findings\nchecked 1 system with 2 nodes\n"


def test_graphs_are_of_what_the_configuration_starts(ws: Path, rosarch: Callable) -> None:
    (ws / ".rosarch.yml").write_text("launch: [{files: [talker/robot.launch], arguments: {topic: [chatter]}}]\n")
    outcome = rosarch("show", "graph", ws, "--format", "json", "--no-leaves")
    (graph,) = json.loads(outcome.out)
    assert (outcome.code, outcome.err, graph["system"]) == (0, "", "talker/robot.launch topic:=chatter")
    assert [connector["names"] for connector in graph["connectors"]] == [["/chatter"]]


def test_variables_of_the_environment(ws: Path, rosarch: Callable) -> None:
    launch = ws / "talker" / "robot.launch"
    launch.write_text(ROBOT.replace('default="other"', 'default="$(env ROBOT_TOPIC)"'))
    outcome = rosarch("check", ws)
    assert (outcome.code, outcome.err) == (
        0,
        "ws/talker/robot.launch:2:3: environment variable `ROBOT_TOPIC` is not set\n1 diagnostic\n",
    )
    assert heads(rosarch("check", ws, "--env", "ROBOT_TOPIC=chatter").out) == [MISMATCH]
    (ws / ".rosarch.yml").write_text("environment: {ROBOT_TOPIC: chatter}\n")
    assert heads(rosarch("check", ws).out) == [MISMATCH]


def test_a_workspace_of_interfaces_alone(tmp_path: Path, rosarch: Callable) -> None:
    folder = tmp_path / "levels" / "level_msgs"
    (folder / "msg").mkdir(parents=True)
    (folder / "msg" / "Level.msg").write_text("Header header\n")
    group = "<member_of_group>rosidl_interface_packages</member_of_group><export><build_type>ament_cmake</build_type></export>"
    (folder / "package.xml").write_text(f'<package format="3"><name>level_msgs</name>{group}</package>')
    build = "project(level_msgs)\nfind_package(ament_cmake)\nrosidl_generate_interfaces(level_msgs msg/Level.msg)\nament_package()\n"
    (folder / "CMakeLists.txt").write_text(build)
    outcome = rosarch("check", tmp_path / "levels")
    assert [line.rpartition("  ")[2] for line in heads(outcome.out)] == ["[interfaces-refused]"]


def test_packages_elsewhere(ws: Path, tmp_path: Path, rosarch: Callable) -> None:
    other = tmp_path / "underlay" / "other"
    other.mkdir(parents=True)
    (other / "package.xml").write_text("<package><name>other</name></package>")
    (other / "part.launch").write_text('<launch><node pkg="talker" type="talker" name="again"/></launch>')
    (ws / "talker" / "robot.launch").write_text('<launch><include file="$(find other)/part.launch"/></launch>')
    manifest = ws / "talker" / "package.xml"
    manifest.write_text(manifest.read_text().replace("</package>", "<exec_depend>other</exec_depend></package>"))
    alone = rosarch("check", ws)
    assert alone.out.splitlines()[-1] == "checked 1 system with 0 nodes"
    found = rosarch("check", ws, "--package-path", tmp_path / "underlay")
    assert (found.code, found.err, found.out.splitlines()[-1]) == (0, "", "checked 1 system with 1 node")


@pytest.mark.slow
def test_a_finding_that_a_comment_suppresses(ws: Path, rosarch: Callable) -> None:
    source = ws / "talker" / "listener.cpp"
    source.write_text(LISTENER.replace("onNumber);", "onNumber);  // rosarch: ignore[topic-type-mismatch] for the test"))
    outcome = rosarch("check", ws, "--launch", "talker/robot.launch topic:=chatter")
    assert (outcome.code, outcome.out) == (0, "no findings; 1 suppressed\nchecked 1 system with 2 nodes\n")


def test_a_missing_file_is_a_finding_and_no_diagnostic(ws: Path, rosarch: Callable) -> None:
    (ws / "talker" / "robot.launch").write_text('<launch>\n  <include file="$(find talker)/gone.launch"/>\n</launch>')
    outcome = rosarch("check", ws)
    assert (outcome.code, outcome.err) == (1, "")
    assert heads(outcome.out) == [
        "ws/talker/robot.launch:2:3: error: the included file talker/gone.launch does not exist  [missing-include]"
    ]
    assert "no such file" in rosarch("check", ws, "-v").err


def test_malformed_xml_costs_that_file(ws: Path, rosarch: Callable) -> None:
    (ws / "talker" / "broken.launch").write_text("<launch>\n  <node>\n</launch>\n")
    outcome = rosarch("check", ws)
    assert outcome.code == 1
    assert [head.partition("error: ")[0] for head in heads(outcome.out)] == ["ws/talker/broken.launch:3:3: "]
    assert outcome.out.splitlines()[-1] == "checked 2 systems with 2 nodes"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--launch", "talker/gone.launch"), "talker/gone.launch: no such launch file, neither here nor below ws"),
        (("--launch", "x:=1"), "`x:=1` names no launch file"),
        (("--launch", "talker/robot.launch 1x:=2"), "1x:=2: not of the form NAME:=VALUE"),
        (("--launch", "talker/robot.launch 'x"), "`talker/robot.launch 'x`: no closing quotation"),
        (("--env", "ROBOT"), "--env ROBOT: not of the form NAME=VALUE"),
        (("--package-path", "gone"), "gone: no such folder"),
        (("--library", "gone"), "gone: no such folder"),
        (("--config", "gone.yml"), "gone.yml: cannot be read (no such file or directory)"),
        (("--error", "topic-typ"), "--error topic-typ: no such check, did you mean `topic-type-mismatch`?"),
        (("--format", "xml"), "--format xml: no format `xml`, there are text, json, sarif, junit, github, markdown"),
    ],
)
def test_bad_words(words: tuple[str, ...], message: str, ws: Path, rosarch: Callable) -> None:
    outcome = rosarch("check", ws, *words)
    assert (outcome.code, outcome.out, outcome.err) == (2, "", f"rosarch: error: {message}\n")


def test_no_folder(ws: Path, rosarch: Callable) -> None:
    outcome = rosarch("check", "gone")
    assert (outcome.code, outcome.err) == (2, "rosarch: error: gone: no such folder\n")


def test_a_workspace_without_launch_files(ws: Path, rosarch: Callable) -> None:
    (ws / "talker" / "robot.launch").unlink()
    outcome = rosarch("check", ws)
    assert (outcome.code, outcome.out) == (0, "no findings\nchecked 2 systems with 2 nodes\n")
    assert outcome.err == "ws:1:1: no launch file below this folder: each program is checked by itself\n1 diagnostic\n"
