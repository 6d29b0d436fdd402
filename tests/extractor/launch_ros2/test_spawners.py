"""Spawners of ros2_control: the controllers that they ask for are nodes."""

from __future__ import annotations

from pathlib import Path

import pytest
from ros2_launch_builder import described, names, params, problems

from rosarch.extractor.launch import Composition

MANAGER = "Node(package='controller_manager', executable='ros2_control_node', namespace='arm', parameters=['FILE'])"
CONTROLLERS = """/**/controller_manager: {ros__parameters: {lift: {type: lifts/Lift}}}
/arm/grip: {ros__parameters: {type: grips/Grip, joints: [a, b]}}
/**/sway: {ros__parameters: {type: sways/Sway, speed: 2}}
"""


def spawner(*words: str, more: str = "namespace='arm'") -> str:
    return f"Node(package='controller_manager', executable='spawner', arguments={list(words)}, {more})"


def launched(tmp_path: Path, *entities: str) -> Composition:
    file = tmp_path / "controllers.yaml"
    file.write_text(CONTROLLERS)
    return described(tmp_path, ", ".join(entities).replace("FILE", str(file)))


def kinds(found: Composition) -> dict[str, tuple[str, str]]:
    return {node.full_name: (node.package, node.type) for node in found.nodes if node.package not in ("controller_manager",)}


def test_controllers_are_nodes_beside_their_manager(tmp_path: Path) -> None:
    found = launched(tmp_path, MANAGER, spawner("lift", "grip", "--param-file", "FILE"))
    assert names(found) == ["/arm/controller_manager", "/arm/spawner_lift", "/arm/lift", "/arm/grip"]
    assert kinds(found) == {"/arm/lift": ("lifts", "lifts/Lift"), "/arm/grip": ("grips", "grips/Grip")}
    assert params(found)["/arm/grip/joints"] == ["a", "b"]


def test_what_the_manager_is_given_is_for_controllers_too(tmp_path: Path) -> None:
    found = launched(tmp_path, MANAGER, spawner("sway", "-c", "/arm/controller_manager", more="name='starts'"))
    assert names(found)[1:] == ["/starts", "/arm/sway"]
    assert params(found)["/arm/sway/speed"] == 2


def test_a_manager_without_a_file(tmp_path: Path) -> None:
    manager = "Node(package='controller_manager', executable='ros2_control_node', parameters=[{'lift.type': 'lifts/Lift'}])"
    assert kinds(launched(tmp_path, manager, spawner("lift", more=""))) == {"/lift": ("lifts", "lifts/Lift")}


def test_options_of_single_controllers(tmp_path: Path) -> None:
    words = ("--controller", "grip", "-p", "FILE", "--controller", "lift", "--controller-ros-args", "-r ~/command:=/lift")
    found = launched(tmp_path, MANAGER, spawner(*words))
    (lift,) = (node for node in found.nodes if node.name == "lift")
    assert [(remap.source, remap.target) for remap in lift.remaps] == [("~command", "/lift")]
    assert kinds(found)["/arm/grip"] == ("grips", "grips/Grip")


@pytest.mark.parametrize("option", ["-t", "--controller-type"])
def test_the_class_as_an_option(tmp_path: Path, option: str) -> None:
    found = launched(tmp_path, spawner("other", option, "others/Other", "--switch-timeout", "3", "--inactive", more=""))
    assert kinds(found) == {"/other": ("others", "others/Other")}


def test_a_class_that_nothing_says(tmp_path: Path) -> None:
    found = launched(tmp_path, MANAGER, spawner("nobody"))
    assert kinds(found) == {}
    assert any("the class of the controller nobody is not known" in text for text in problems(found, tmp_path))
