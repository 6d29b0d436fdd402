"""`rosarch launch`: the table, the record, arguments, and what it says about wrong usage."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

FEATURES = Path(__file__).resolve().parents[1] / "extractor" / "launch" / "features"
EXPECTED = FEATURES.parent / "expected.jsonl"

MAIN = """<launch>
  <arg name="sim"/>
  <arg name="rate" default="5"/>
  <include file="$(find robot)/launch/drivers.launch" ns="base"><arg name="rate" value="$(arg rate)"/></include>
  <node pkg="robot" type="brain" name="brain" required="true" if="$(arg sim)"/>
  <include file="$(find maps)/launch/map.launch"/>
  <rosparam file="$(find maps)/map.yaml" ns="map"/>
  <param name="robot_description" command="xacro robot.xacro"/>
  <test pkg="robot" type="check" test-name="drives"/>
</launch>
"""
DRIVERS = """<launch>
  <arg name="rate"/>
  <remap from="cmd" to="/cmd_vel"/>
  <node pkg="robot" type="driver" name="driver" args="--fast _x:=1" respawn="true" machine="front">
    <param name="rate" value="$(arg rate)"/>
    <param name="text" value="two   words
                              and a very long line that does not fit into the table at all"/>
  </node>
</launch>
"""
TABLE = """\
/base/driver  robot/driver
  args    --fast _x:=1
  remap   cmd -> /cmd_vel
  param   ~rate=5
  param   ~text=two words and a very long line that does not fit into the...
  run     respawn, on machine front
  from    src/robot/launch/main.launch:4 > src/robot/launch/drivers.launch:4

/brain        robot/brain
  only    if $(arg sim)
  run     required
  from    src/robot/launch/main.launch:5

/drives       robot/check (test drives)
  from    src/robot/launch/main.launch:9

parameters
  /robot_description=$(command xacro robot.xacro)

not read
  include $(find maps)/launch/map.launch  from  src/robot/launch/main.launch:6
  rosparam /map of $(find maps)/map.yaml  from  src/robot/launch/main.launch:7

2 nodes, 1 test, 3 parameters, 2 launch files
roslaunch would refuse this: src/robot/launch/main.launch:5:3: argument `sim` must be passed, it has no value
"""
DIAGNOSTICS = """\
launch-arg: 1
  src/robot/launch/main.launch:5:3: argument `sim` must be passed, it has no value
launch-command: 1
  src/robot/launch/main.launch:8:3: command `xacro` would fail: no such file: robot.xacro
launch-package: 2
  src/robot/launch/main.launch:6:3: package `maps` is not on the package path
  src/robot/launch/main.launch:7:3: package `maps` is not on the package path
4 diagnostics
"""


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for variable in ("ROS_PACKAGE_PATH", "ROS_NAMESPACE"):
        monkeypatch.delenv(variable, raising=False)
    folder = tmp_path / "src" / "robot" / "launch"
    folder.mkdir(parents=True)
    (folder.parent / "package.xml").write_text("<package><name>robot</name></package>")
    (folder / "main.launch").write_text(MAIN)
    (folder / "drivers.launch").write_text(DRIVERS)


def test_table(rosarch: Callable) -> None:
    outcome = rosarch("launch", "src/robot/launch/main.launch")
    assert (outcome.code, outcome.out, outcome.err) == (1, TABLE, DIAGNOSTICS)


def test_arguments_decide(rosarch: Callable) -> None:
    outcome = rosarch("launch", "src/robot/launch/drivers.launch", "rate:=20", "__ns:=left")
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.startswith("/left/driver  robot/driver\n")
    assert "  param   ~rate=20\n" in outcome.out


def test_record(rosarch: Callable) -> None:
    outcome = rosarch("launch", "src/robot/launch/drivers.launch", "rate:=20", "--json")
    document = json.loads(outcome.out)
    assert (outcome.code, sorted(document)) == (0, ["nodes", "params", "problems", "started_by", "tests"])
    assert document["nodes"] == [
        {
            "package": "robot",
            "type": "driver",
            "name": "driver",
            "namespace": "/",
            "remap": [["cmd", "/cmd_vel"]],
            "args": "--fast _x:=1",
            "respawn": True,
            "required": False,
            "machine": "front",
            "output": None,
            "launch_prefix": None,
        }
    ]
    assert document["params"]["/driver/rate"] == 20
    assert document["started_by"] == [{"node": "/driver", "lines": [f"{Path.cwd()}/src/robot/launch/drivers.launch:4"]}]


def test_record_is_that_of_roslaunch(rosarch: Callable) -> None:
    """The command prints what roslaunch has in its memory, with --package-path alone."""
    for line in EXPECTED.read_text(encoding="utf-8").splitlines():
        expected = json.loads(line.replace("ROOT", str(FEATURES)))
        if (
            expected["file"] in ("alpha/launch/params.launch", "alpha/launch/rosparam.launch", "alpha/launch/find.launch")
            and "nodes" in expected
        ):
            outcome = rosarch("launch", str(FEATURES / expected["file"]), "--package-path", str(FEATURES), "--json")
            document = json.loads(outcome.out)
            assert outcome.code == 0
            assert (document["nodes"], document["params"]) == (expected["nodes"], expected["params"])


def test_environment(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "env.launch").write_text(
        '<launch><param name="a" value="$(env WHO)"/><param name="b" value="$(env ROS_PACKAGE_PATH)"/></launch>'
    )
    outcome = rosarch("launch", "env.launch", "--env", "WHO=me", "--package-path", "src", "--json")
    assert json.loads(outcome.out)["params"] == {"/a": "me", "/b": f"{tmp_path}/src"}


def test_the_version_of_ros_that_starts_a_file(rosarch: Callable, tmp_path: Path) -> None:
    folder = tmp_path / "src" / "arm"
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text("<package><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>")
    (folder / "main.launch.xml").write_text('<launch><arg name="port" default="1"/><param name="port" value="$(arg port)"/></launch>')
    words = ["launch", "src/arm/main.launch.xml", "--package-path", "src"]
    assert rosarch(*words).code == 0
    refused = rosarch(*words, "--env", "ROS_VERSION=2")
    assert refused.code == 1
    assert "unknown element <param> in <launch>" in refused.err


def test_several_files(rosarch: Callable) -> None:
    outcome = rosarch("launch", "src/robot/launch/drivers.launch", "src/robot/launch/drivers.launch", "rate:=1")
    assert outcome.code == 1
    assert outcome.out.endswith("drivers.launch:4:3: a second node `/driver`, the first is at src/robot/launch/drivers.launch:4\n")


def test_overview(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "src/robot/launch/empty.launch").write_text("<launch/>")
    outcome = rosarch("launch", ".")
    assert (outcome.code, outcome.err) == (1, "")
    assert outcome.out == (
        "src/robot/launch/empty.launch  0 nodes  0 parameters\n"
        "src/robot/launch/main.launch   2 nodes  3 parameters  refused: argument `sim` must be passed, it has no value\n"
        "\n"
        "2 launch files that no other includes, 1 of them refused with their default arguments\n"
    )
    assert [entry["file"].rpartition("/")[2] for entry in json.loads(rosarch("launch", ".", "--json").out)] == [
        "empty.launch",
        "main.launch",
    ]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["none.launch"], "none.launch: no such file"),
        (["a:=b"], "no launch file given"),
        (["src/robot/launch/main.launch", "9:=b"], "9:=b: not of the form NAME:=VALUE"),
        (["src/robot/launch/main.launch", "a:="], "a:=: not of the form NAME:=VALUE"),
        (["src/robot/launch/main.launch", "__ns:=~a"], "__ns:=~a: a namespace cannot be a private name"),
        (["src/robot/launch/main.launch", "--env", "A"], "--env A: not of the form NAME=VALUE"),
        (["src/robot/launch/main.launch", "--package-path", "none"], "none: no such folder"),
        (["src/robot/package.xml"], "src/robot/package.xml:1:1: root element is <package>, not <launch>"),
        (["src/robot/launch/main.launch", "src"], "src: not a file"),
        (["empty"], "empty: no launch file below this folder"),
    ],
)
def test_wrong_usage(rosarch: Callable, tmp_path: Path, words: list[str], message: str) -> None:
    (tmp_path / "empty").mkdir()
    outcome = rosarch("launch", *words)
    assert (outcome.code, outcome.out, outcome.err) == (2, "", f"rosarch: error: {message}\n")


def test_package_path_by_default(rosarch: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The workspace is found from the file; ROS_PACKAGE_PATH comes first."""
    assert "drivers.launch:4" in rosarch("launch", "src/robot/launch/main.launch").out
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "elsewhere"))
    assert "package `robot` is not on the package path" in rosarch("launch", "src/robot/launch/main.launch").err
