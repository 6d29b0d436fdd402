"""What the shipped library says of nodes, as launch files start them."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch import library
from tests.extractor.workspace_builder import write
from tests.library.test_files import MANIFEST

DISTRIBUTIONS = {
    1: {"indigo", "kinetic", "melodic", "noetic"},
    2: {"dashing", "foxy", "galactic", "humble", "iron", "jazzy", "kilted", "rolling"},
}
CLIENTS = ("list_controllers", "load_controller", "configure_controller", "switch_controller", "unload_controller")


@pytest.fixture
def ports(tmp_path: Path, rosarch: Callable, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], dict[str, set[tuple[str, str]]]]:
    """The topics, services and actions of each node that a launch file in XML starts, with `in` or `out`."""
    monkeypatch.chdir(tmp_path)

    def found(content: str, **files: str) -> dict[str, set[tuple[str, str]]]:
        launch = {
            "launch/main.launch.xml": f"<launch>{content}</launch>\n",
            **{name.replace("__", "/"): text for name, text in files.items()},
        }
        write(Path("ws"), {"package.xml": MANIFEST.format("robot"), "CMakeLists.txt": "project(robot)\n", **launch})
        [system] = json.loads(rosarch("show", "graph", "ws", "--implicit", "--format", "json").out)
        names = {each["id"]: each["names"] for each in system["connectors"]}
        nodes = {node["id"]: node["name"] for node in system["nodes"]}
        seen: dict[str, set[tuple[str, str]]] = {name: set() for name in nodes.values()}
        for edge in system["edges"]:
            ends = edge["source"], edge["target"]
            way, node, connector = ("in", *reversed(ends)) if ends[0] in names else ("out", *ends)
            seen[nodes[node]] |= {(way, name) for name in names[connector]}
        return seen

    return found


def test_each_file_says_for_which_version_it_holds() -> None:
    files = [json.loads(path.read_text()) for path in Path(library.__path__[0]).glob("*/*.json")]
    for file in files:
        [version] = file["ros"]
        assert file["distributions"] and set(file["distributions"]) <= DISTRIBUTIONS[version], file["package"]


def test_a_spawner_asks_the_manager_that_it_is_given(ports: Callable) -> None:
    spawner = '<node pkg="controller_manager" exec="spawner" name="{}" args="{}"/>'
    arguments = {"a": "arm -c /boss", "b": "arm --controller-manager=boss -n left", "c": "arm"}
    found = ports("".join(spawner.format(name, words) for name, words in arguments.items()))
    managers = {"/a": "/boss", "/b": "/left/boss", "/c": "/controller_manager"}
    for name, manager in managers.items():
        clients = {topic for way, topic in found[name] if way == "out" and "controller" in topic}
        assert clients == {f"{manager}/{service}" for service in CLIENTS}


def test_transforms_that_a_costmap_hears_are_in_the_namespace_of_its_server(ports: Callable) -> None:
    server = '<node pkg="nav2_planner" exec="planner_server" namespace="robot"><remap from="/tf_static" to="tf_static"/></node>'
    found = ports(server)["/robot/global_costmap/global_costmap"]
    assert ("in", "/robot/tf_static") in found
    assert not any("global_costmap/tf" in name for _, name in found)


def test_servo_sends_what_its_parameters_name(ports: Callable) -> None:
    servo = '<node pkg="moveit_servo" exec="servo_node_main" name="servo">{}</node>'
    given = {
        "command_out_topic": "/arm/commands",
        "command_out_type": "std_msgs/Float64MultiArray",
        "is_primary_planning_scene_monitor": "false",
    }
    parameters = "".join(f'<param name="moveit_servo.{name}" value="{value}"/>' for name, value in given.items())
    found = ports(servo.format(parameters))["/servo"]
    assert {
        ("out", "/arm/commands"),
        ("out", "/get_planning_scene"),
        ("in", "/servo/delta_twist_cmds"),
        ("in", "/servo/start_servo"),
    } <= found
    assert ("in", "/get_planning_scene") not in found
    assert not any("panda" in name for _, name in found)


def test_recoveries_of_older_distributions(ports: Callable) -> None:
    found = ports('<node pkg="nav2_recoveries" exec="recoveries_server"><param name="recovery_plugins" value="[spin, wait]"/></node>')
    assert {("in", "/spin"), ("in", "/wait"), ("out", "/cmd_vel")} <= found["/recoveries_server"]
    assert ("in", "/backup") not in found["/recoveries_server"]


def test_a_joint_state_publisher_takes_the_description_from_its_topic(ports: Callable) -> None:
    found = ports(
        '<node pkg="joint_state_publisher" exec="joint_state_publisher"><param name="source_list" value="[gripper/states]"/></node>'
    )
    expected = {("out", "/joint_states"), ("in", "/robot_description"), ("in", "/gripper/states")}
    assert found["/joint_state_publisher"] >= expected
