"""Controllers: what spawners and commands ask for, of which class, in which manager, with which parameters."""

from __future__ import annotations

from pathlib import Path

import pytest
from ros2_launch_builder import HEAD, composed

from rosarch.extractor.launch import Files, PackagePath, compose
from rosarch.extractor.launch.model import Composition

PARAMS = """
controller_manager:
  ros__parameters:
    update_rate: 30
    use_sim_time: true
    wheels: {type: diff_drive_controller/DiffDriveController}
    joints: {type: "my_controllers::Joints"}
    other: {params_file: PACKAGE/more.yaml}
wheels:
  ros__parameters: {publish_rate: 50.0}
"""
MORE = "other:\n  ros__parameters: {type: other_controllers/Other, gain: 2}\n"
MANAGER = """Node(package='controller_manager', executable='ros2_control_node', parameters=[os.path.dirname(__file__) + '/params.yaml'],
    remappings=[('/wheels/cmd_vel', '/cmd_vel')])"""


def _composed(folder: Path, entities: str, **files: str) -> Composition:
    text = f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{entities}])\n"
    package = str(folder / "here")
    others = {"params.yaml": PARAMS, "more.yaml": MORE, **{name.replace("_", "."): text for name, text in files.items()}}
    return composed(folder, {"main.launch.py": text, **{name: one.replace("PACKAGE", package) for name, one in others.items()}})


def _controllers(found: Composition) -> list[tuple[str, str, str, str | None]]:
    return [(node.full_name, node.package, node.type, node.container) for node in found.controllers]


def test_spawners(tmp_path: Path) -> None:
    spawn = "Node(package='controller_manager', executable='spawner', arguments=['joints', '-c', '/controller_manager', 'wheels', '--inactive'])"
    found = _composed(tmp_path, f"{MANAGER}, {spawn}")
    assert _controllers(found) == [
        ("/joints", "my_controllers", "my_controllers::Joints", "/controller_manager"),
        ("/wheels", "diff_drive_controller", "diff_drive_controller/DiffDriveController", "/controller_manager"),
    ]
    # launch knows nothing of them
    assert [node.type for node in found.nodes] == ["ros2_control_node", "spawner"]
    assert found.nodes[1].full_name == "/spawner"
    whole = found.with_controllers()
    assert whole.nodes[1].full_name == "/spawner_joints"
    assert [node.type for node in whole.nodes[2:]] == ["my_controllers::Joints", "diff_drive_controller/DiffDriveController"]
    values = {setting.name: setting.value for setting in whole.params}
    assert values["/wheels/publish_rate"] == 50.0
    assert values["/wheels/use_sim_time"] is True
    assert "/joints/publish_rate" not in values
    wheels = whole.nodes[3]
    assert [(remap.source, remap.target) for remap in wheels.own_remaps] == [("/wheels/cmd_vel", "/cmd_vel")]


@pytest.mark.parametrize(
    ("asking", "expected"),
    [
        ("Node(package='controller_manager', executable='spawner', arguments=['other'])", ["/other other_controllers/Other"]),
        (
            "ExecuteProcess(cmd=['ros2', 'control', 'load_controller', '--set-state', 'active', 'wheels'])",
            ["/wheels diff_drive_controller/DiffDriveController"],
        ),
        (
            "ExecuteProcess(cmd=['ros2 control load_controller wheels --set-state active'], shell=True)",
            ["/wheels diff_drive_controller/DiffDriveController"],
        ),
        (
            "Node(package='controller_manager', executable='spawner', arguments=['new', '-t', 'a/B', '--controller-manager-timeout', '5'])",
            ["/new a/B"],
        ),
        (
            "Node(package='controller_manager', executable='spawner', arguments=['late', '--param-file', os.path.dirname(__file__) + '/late.yaml'])",
            ["/late c/D"],
        ),
        # twice the same
        (
            "*[Node(package='controller_manager', executable='spawner', arguments=['wheels']) for i in range(2)]",
            ["/wheels diff_drive_controller/DiffDriveController"],
        ),
        # of no known class, of a manager that nobody starts, of another namespace, of a name that only a user gives
        ("Node(package='controller_manager', executable='spawner', arguments=['unheard_of'])", []),
        ("Node(package='controller_manager', executable='spawner', arguments=['wheels', '-c', '/arm/controller_manager'])", []),
        ("Node(package='controller_manager', executable='spawner', namespace='arm', arguments=['wheels'])", []),
        ("Node(package='controller_manager', executable='spawner', arguments=[LaunchConfiguration('which')])", []),
        ("Node(package='elsewhere', executable='spawner', arguments=['wheels'])", []),
        ("ExecuteProcess(cmd=['ros2', 'control', 'list_controllers', 'wheels'])", []),
    ],
)
def test_what_is_asked_for(tmp_path: Path, asking: str, expected: list[str]) -> None:
    late = "late:\n  ros__parameters: {type: c/D}\n"
    found = _composed(tmp_path, f"{MANAGER}, {asking}", late_yaml=late)
    assert [f"{node.full_name} {node.type}" for node in found.controllers] == expected


def test_the_rules_of_one_controller(tmp_path: Path) -> None:
    spawn = """Node(package='controller_manager', executable='spawner',
      arguments=['wheels', '--controller-ros-args', '-r ~/odom:=/odom --remap ~/other:=other'])"""
    wheels = _composed(tmp_path, f"{MANAGER}, {spawn}").controllers[0]
    rules = [(remap.source, remap.target) for remap in wheels.own_remaps]
    assert rules == [("~odom", "/odom"), ("~other", "other"), ("/wheels/cmd_vel", "/cmd_vel")]


def test_conditions(tmp_path: Path) -> None:
    manager = MANAGER.removesuffix(")") + ", condition=IfCondition(Command('decide')))"
    spawn = "Node(package='controller_manager', executable='spawner', arguments=['wheels'], condition={}(Command('decide')))"
    with_it = _composed(tmp_path, f"{manager}, {spawn.format('IfCondition')}")
    assert [{str(each) for each in node.conditions} for node in with_it.controllers] == [{"if $(command decide)"}]
    without = _composed(tmp_path, f"{manager}, {spawn.format('UnlessCondition')}")
    assert without.controllers == ()


def test_managers_that_simulators_make(tmp_path: Path) -> None:
    robot = """<robot name="r"><link name="base"/><gazebo><plugin filename="libgz_ros2_control-system.so" name="control">
      <parameters>PACKAGE/params.yaml</parameters>
      <ros><remapping>/wheels/cmd_vel:=/cmd_vel</remapping></ros></plugin></gazebo></robot>"""
    entities = """Node(package='robot_state_publisher', executable='robot_state_publisher',
      parameters=[{'robot_description': Command(['xacro ', os.path.dirname(__file__) + '/r.urdf'])}]),
      Node(package='controller_manager', executable='spawner', arguments=['wheels'])"""
    found = _composed(tmp_path, entities, r_urdf=robot)
    assert [(node.full_name, node.type) for node in found.controllers] == [
        ("/controller_manager", "ros2_control_node"),
        ("/wheels", "diff_drive_controller/DiffDriveController"),
    ]
    values = {setting.name: setting.value for setting in found.with_controllers().params}
    assert (values["/controller_manager/update_rate"], values["/wheels/publish_rate"]) == (30, 50.0)
    assert [remap.target for remap in found.controllers[1].own_remaps] == ["/cmd_vel"]


def test_a_description_with_several_arguments_makes_one_manager(tmp_path: Path) -> None:
    robot = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="file" default="params.yaml"/><link name="base"/>
      <gazebo><plugin filename="libgz_ros2_control-system.so" name="control"><parameters>PACKAGE/$(arg file)</parameters></plugin></gazebo></robot>"""
    described = "{{'robot_description': Command(['xacro ', os.path.dirname(__file__) + '/r.urdf{}'])}}"
    entities = f"""Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{described.format("")}]),
      Node(package='planning', executable='planner', parameters=[{described.format(" file:=none.yaml")}]),
      Node(package='controller_manager', executable='spawner', arguments=['wheels'])"""
    found = _composed(tmp_path, entities, r_urdf=robot)
    assert [node.full_name for node in found.controllers] == ["/controller_manager", "/wheels"]


def test_a_class_that_is_called_otherwise_than_its_package(tmp_path: Path) -> None:
    description = '<library path="l"><class name="special/Grip" type="special::Grip" base_class_type="controller_interface::C"/></library>'
    spawn = "Node(package='controller_manager', executable='spawner', arguments=['grip', '-t', 'special/Grip'])"
    found = _composed(tmp_path, f"{MANAGER}, {spawn}", plugins_xml=description)
    assert [(node.package, node.type) for node in found.controllers] == [("here", "special/Grip")]


def test_what_spawners_are_given(tmp_path: Path) -> None:
    spawn = """Node(package='controller_manager', executable='spawner', arguments=['late'],
      parameters=[os.path.dirname(__file__) + '/late.yaml'])"""
    found = _composed(tmp_path, f"{MANAGER}, {spawn}", late_yaml="late:\n  ros__parameters: {type: c/D, gain: 3}\n")
    assert [(node.type, node.own_params[-1].name) for node in found.controllers] == [("c/D", "/late/gain")]
    assert [Path(file.path).name for file in found.controllers[0].params_files] == ["params.yaml", "late.yaml"]


def test_spawners_keep_their_parameters(tmp_path: Path) -> None:
    spawn = "*[Node(package='controller_manager', executable='spawner', arguments=[name], parameters=[{'n': name}]) for name in ('joints', 'wheels')]"
    found = _composed(tmp_path, f"{MANAGER}, {spawn}")
    values = {setting.name: setting.value for setting in found.with_controllers().params if setting.name.endswith("/n")}
    assert values == {"/spawner_joints/n": "joints", "/spawner_wheels/n": "wheels"}


def test_launch_files_together(tmp_path: Path) -> None:
    spawn = "Node(package='controller_manager', executable='spawner', arguments=['wheels'])"
    _composed(tmp_path, spawn)
    package = tmp_path / "here"
    (package / "main.launch.py").rename(package / "spawn.launch.py")
    _composed(tmp_path, MANAGER)
    (package / "old.launch").write_text('<launch><node pkg="here" type="run" name="old"/></launch>')
    (package / "package.xml").write_text("<package><name>here</name></package>")
    paths = [package / name for name in ("spawn.launch.py", "main.launch.py", "old.launch")]
    found = compose(paths, files=Files(PackagePath([tmp_path]), str(tmp_path)))
    assert [node.full_name for node in found.controllers] == ["/wheels"]
    assert [node.full_name for node in found.nodes] == ["/spawner", "/controller_manager", "/old"]
    assert found.hardware_unseen is False


def test_what_is_asked_for_where_a_file_was_not_read(tmp_path: Path) -> None:
    spawn = "Node(package='controller_manager', executable='spawner', arguments=['other_one'{}])"
    known = _composed(tmp_path, f"{MANAGER}, {spawn.format('')}")
    assert [(one.name, one.manager) for one in known.controllers_asked] == [("other_one", "/controller_manager")]
    file = ", '--param-file', os.path.dirname(__file__) + '/broken.yaml'"
    broken = _composed(tmp_path, f"{MANAGER}, {spawn.format(file)}", broken_yaml="a: [\n")
    assert broken.controllers_asked == ()
    manager = MANAGER.replace("parameters=[", "parameters=['/gone.yaml', ")
    assert _composed(tmp_path, f"{manager}, {spawn.format('')}").controllers_asked == ()
