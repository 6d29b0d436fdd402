"""The nodes of processes, with what a command line says for each of them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from ros2_launch_builder import HEAD, composed

from rosarch.analysis.systems.processes import with_inner, with_nodes
from rosarch.base.places import Place
from rosarch.extractor.launch import Composition
from rosarch.extractor.urdf.hardware import HardwareInterface
from rosarch.models.component import ComponentModel, Port
from rosarch.models.traits import Trait

FILE = """\
/**: {ros__parameters: {common: 1}}
left: {ros__parameters: {side: l}}
/arm/left: {ros__parameters: {side: far}}
arm: {right: {ros__parameters: {side: r}}}
run: {ros__parameters: {side: program}}
"""
TWO = ("left", "right")


def nodes_of(folder: Path, arguments: str, *called: str | None, model: ComponentModel | None = None) -> Composition:
    """What a launch file starts with these arguments of `Node`, where the code of the program calls its nodes so."""
    text = f"def generate_launch_description():\n    return LaunchDescription([Node(package='here', executable='run', {arguments})])\n"
    found = composed(folder, {"main.launch.py": f"{HEAD}FILE = os.path.dirname(__file__) + '/p.yaml'\n\n{text}", "p.yaml": FILE})
    several = "run" if len(called) > 1 else None
    models = [ComponentModel("ws", name or "run", "here", "node", name, (), (), (), executable=several) for name in called]
    return with_nodes(found, {("here", "run"): [model] if model else models})


def set_by(found: Composition) -> dict[str, object]:
    return {setting.name: setting.value for setting in found.params}


def test_values_of_a_process_are_for_all_its_nodes(tmp_path: Path) -> None:
    found = nodes_of(tmp_path, "parameters=[{'side': 1}], ros_arguments=['-p', 'rate:=2', '-p', 'right:only:=3']", *TWO)
    assert [node.full_name for node in found.nodes] == ["/left", "/right"]
    expected = {"/left/side": 1, "/left/rate": 2, "/right/side": 1, "/right/rate": 2, "/right/only": 3}
    assert set_by(found) == expected


def test_sections_are_for_the_nodes_that_the_code_calls_so(tmp_path: Path) -> None:
    found = nodes_of(tmp_path, "parameters=[FILE]", *TWO)
    assert set_by(found) == {"/left/common": 1, "/left/side": "l", "/right/common": 1}
    below = nodes_of(tmp_path, "namespace='arm', parameters=[FILE]", *TWO)
    assert set_by(below) == {"/arm/left/common": 1, "/arm/left/side": "far", "/arm/right/common": 1, "/arm/right/side": "r"}


def test_a_program_with_one_node_is_called_as_its_code_says(tmp_path: Path) -> None:
    found = nodes_of(tmp_path, "parameters=[FILE]", "left")
    assert [(node.full_name, node.type) for node in found.nodes] == [("/left", "run")]
    assert set_by(found) == {"/left/common": 1, "/left/side": "l"}


def test_a_program_of_which_only_the_name_of_its_node_is_known(tmp_path: Path) -> None:
    found = with_nodes(nodes_of(tmp_path, "parameters=[FILE]"), {}, {("here", "run"): "left"})
    assert [node.full_name for node in found.nodes] == ["/left"]
    assert set_by(found) == {"/left/common": 1, "/left/side": "l"}
    named = with_nodes(nodes_of(tmp_path, "name='run', parameters=[FILE]"), {}, {("here", "run"): "left"})
    assert [node.full_name for node in named.nodes] == ["/run"]


def test_a_name_that_a_launch_file_gives_is_that_of_all_nodes(tmp_path: Path) -> None:
    found = nodes_of(tmp_path, "name='run', parameters=[FILE], remappings=[('left:a', 'b')]", *TWO)
    assert [(node.full_name, node.type, node.own_remaps) for node in found.nodes] == [("/run", "left", ()), ("/run", "right", ())]
    assert set_by(found) == {"/run/common": 1, "/run/side": "program"}


def test_a_prefix_tells_which_node_a_rule_is_for(tmp_path: Path) -> None:
    arguments = "remappings=[('left:a', 'b'), ('a', 'c')], arguments=['--ros-args', '-r', 'right:__node:=other']"
    found = nodes_of(tmp_path, arguments, *TWO)
    names = {node.full_name: [(remap.source, remap.target) for remap in node.own_remaps] for node in found.nodes}
    assert names == {"/left": [("a", "b")], "/other": [("a", "c")]}


def test_sections_that_may_be_for_a_node_of_unknown_name(tmp_path: Path) -> None:
    found = nodes_of(tmp_path, "parameters=[FILE]", None)
    assert [node.full_name for node in found.nodes] == ["/run"]
    assert {setting.name for setting in found.unread} == {"/run"}
    assert set_by(found)["/run/common"] == 1


def test_a_namespace_of_the_code_counts_where_no_launch_file_gives_one(tmp_path: Path) -> None:
    place = Place("run.py", 3, 9)
    model = ComponentModel("ws", "run", "here", "node", "left", (), (), (), traits=(Trait("node_namespace", (place, "arm")),))
    own = nodes_of(tmp_path, "parameters=[FILE]", model=model)
    assert [node.full_name for node in own.nodes] == ["/arm/left"]
    assert set_by(own) == {"/arm/left/common": 1, "/arm/left/side": "far"}
    named = nodes_of(tmp_path, "name='run', parameters=[{'rate': 2}]", model=model)
    assert ([node.full_name for node in named.nodes], set_by(named)) == (["/arm/run"], {"/arm/run/rate": 2})
    given = nodes_of(tmp_path, "namespace='leg', parameters=[FILE]", model=model)
    assert [node.full_name for node in given.nodes] == ["/leg/left"]
    two = replace(model, traits=(*model.traits, Trait("node_namespace", (place, "leg"))))
    assert [node.full_name for node in nodes_of(tmp_path, "parameters=[FILE]", model=two).nodes] == ["/left"]


def test_a_node_that_a_program_of_the_library_makes_has_what_is_set_last(tmp_path: Path) -> None:
    found = nodes_of(tmp_path, "name='host', namespace='arm', parameters=[{'common': 0}, FILE]", "host")
    whole, components = with_inner(found, {("here", "run"): {"left": "elsewhere/part"}})
    assert [(node.full_name, node.inside) for node in whole.nodes] == [("/arm/host", None), ("/arm/left", "/arm/")]
    assert components == {1: "elsewhere/part"}
    own = [(setting.name, setting.value) for setting in whole.params if setting.name.startswith("/arm/left/")]
    assert own == [("/arm/left/common", 1), ("/arm/left/side", "far")]


CONTROLLED = """\
def generate_launch_description():
    manager = Node(package='controller_manager', executable='ros2_control_node', NAMEDparameters=[FILE], remappings=[('a', 'b')])
    return LaunchDescription([manager, Node(package='controller_manager', executable='spawner', arguments=['wheels'])])
"""
PORT = Port("p1", "publisher", "~battery", None, "std_msgs/Float32", 1, False, None, "plain", Place("d.cpp", 1, 1))
WHEELS = "controller_manager: {ros__parameters: {wheels: {type: here/Wheels}}}"


@pytest.mark.parametrize(
    ("named", "port", "expected"),
    [("", True, ["/driver"]), ("", False, []), ("name='controller_manager', ", True, [])],
)
def test_a_driver_of_hardware_makes_its_node_in_the_process_of_the_manager(
    tmp_path: Path, named: str, port: bool, expected: list[str]
) -> None:
    before = f"{HEAD}FILE = os.path.dirname(__file__) + '/p.yaml'\n\n"
    found = composed(tmp_path, {"main.launch.py": before + CONTROLLED.replace("NAMED", named), "p.yaml": WHEELS}).with_controllers()
    driver = HardwareInterface("state", "wheel", "position", "here/Driver", Place("r.urdf", 1, 1), Place("r.urdf", 1, 1))
    ports = (PORT,) if port else ()
    model = ComponentModel("ws", "Driver", "here", "plugin", "driver", (), ports, ())
    found = with_nodes(
        replace(found, hardware=(driver,)),
        {("here", "here/Driver"): [model]},
        {("controller_manager", "ros2_control_node"): "controller_manager"},
    )
    made = [node for node in found.nodes if node.type == "here/Driver"]
    assert [node.full_name for node in made] == expected
    assert all((node.container, node.is_controller, len(node.remaps)) == ("/controller_manager", True, 1) for node in made)
