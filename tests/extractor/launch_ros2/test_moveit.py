"""MoveIt's helpers for launch files: which parameters and nodes come of the files of a configuration package."""

from __future__ import annotations

from pathlib import Path

from ros2_launch_builder import MANIFEST, names, params, problems

from rosarch.extractor.launch import Composition, Files, PackagePath, compose

URDF = "<robot name='arm' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arg name='tool' default='none'/><link name='$(arg tool)'/></robot>"
SRDF = "<robot name='arm'><virtual_joint name='v' type='fixed' parent_frame='world' child_link='base'/></robot>"
CONFIG = {
    ".setup_assistant": """
moveit_setup_assistant_config:
  URDF: {package: arm_moveit_config, relative_path: urdf/arm.xacro, xacro_args: "tool:=hand "}
  SRDF: {relative_path: config/named.srdf}
""",
    "urdf/arm.xacro": URDF,
    "config/named.srdf": SRDF,
    "config/kinematics.yaml": "arm: {kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin}",
    "config/joint_limits.yaml": "joint_limits: {one: {max_velocity: 1.0}}",
    "config/pilz_cartesian_limits.yaml": "cartesian_limits: {max_trans_vel: 2.0}",
    "config/ompl_planning.yaml": "planning_plugin: ompl_interface/OMPLPlanner\nplanner_configs: {PRM: {type: geometric::PRM}}",
    "config/pilz_industrial_motion_planner_planning.yaml": "planning_plugin: pilz_industrial_motion_planner/CommandPlanner",
    "config/moveit_controllers.yaml": "moveit_simple_controller_manager: {controller_names: [arm_controller]}",
    "config/ros2_controllers.yaml": "controller_manager: {ros__parameters: {update_rate: 50}}",
}
HEAD = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_param_builder import ParameterBuilder
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import *
"""


def _composed(folder: Path, body: str, **changed: str | None) -> Composition:
    files = {**CONFIG, **{name.replace("__", "/"): text for name, text in changed.items()}}
    config = "MoveItConfigsBuilder('arm').to_moveit_configs()"
    launches = {
        name: f"{HEAD}def generate_launch_description():\n    return generate_{name}_launch({config})\n"
        for name in ("rsp", "move_group", "moveit_rviz", "warehouse_db", "spawn_controllers", "static_virtual_joint_tfs")
    }
    package = folder / "arm_moveit_config"
    (folder / "moveit_configs_utils/default_configs").mkdir(parents=True)
    (folder / "moveit_configs_utils/package.xml").write_text(MANIFEST.format("moveit_configs_utils"))
    (folder / "launch_param_builder").mkdir()
    (folder / "launch_param_builder/package.xml").write_text(MANIFEST.format("launch_param_builder"))
    (folder / "moveit_configs_utils/default_configs/ompl_planning.yaml").write_text("")
    files |= {f"launch/{name}.launch.py": text for name, text in launches.items()}
    files |= {"package.xml": MANIFEST.format("arm_moveit_config"), "launch/main.launch.py": HEAD + body}
    for name, text in files.items():
        if text is not None:
            (package / name).parent.mkdir(parents=True, exist_ok=True)
            (package / name).write_text(text)
    return compose([package / "launch/main.launch.py"], files=Files(PackagePath([folder]), str(folder)))


def _returning(value: str) -> str:
    return f"def generate_launch_description():\n    return {value}\n"


def test_a_demo_starts_what_the_launch_files_of_the_package_start(tmp_path: Path) -> None:
    found = _composed(tmp_path, _returning("generate_demo_launch(MoveItConfigsBuilder('arm').to_moveit_configs())"))
    assert problems(found, tmp_path) == []
    assert names(found) == [
        "/static_transform_publisher0",
        "/robot_state_publisher",
        "/move_group",
        "/rviz2",
        "/controller_manager",
        "/spawner",
        "/spawner",
    ]
    values = params(found)
    assert values["/controller_manager/update_rate"] == 50
    assert "name='hand'" in str(values["/robot_state_publisher/robot_description"]).replace('"', "'")
    assert values["/move_group/robot_description_kinematics.arm.kinematics_solver"] == "kdl_kinematics_plugin/KDLKinematicsPlugin"
    assert values["/move_group/robot_description_planning.joint_limits.one.max_velocity"] == 1.0
    assert values["/move_group/robot_description_planning.cartesian_limits.max_trans_vel"] == 2.0
    assert values["/move_group/planning_pipelines"] == ["ompl", "pilz_industrial_motion_planner"]
    assert values["/move_group/ompl.planner_configs.PRM.type"] == "geometric::PRM"
    assert values["/move_group/default_planning_pipeline"] == "ompl"
    assert values["/move_group/moveit_manage_controllers"] is True
    assert [node.args for node in found.nodes if node.type in ("spawner", "static_transform_publisher")] == [
        "--frame-id world --child-frame-id base",
        "arm_controller",
        "joint_state_broadcaster",
    ]
    # where the launch file asks for it: nobody has the source that is interpreted
    assert {(Path(node.lines[-1].path).name, node.lines[-1].line) for node in found.nodes if node.type == "move_group"} == {
        ("move_group.launch.py", 10)
    }


def test_what_the_steps_are_given_counts(tmp_path: Path) -> None:
    steps = """def generate_launch_description():
    built = MoveItConfigsBuilder('arm', robot_description='model')
    built = built.robot_description(mappings={'tool': LaunchConfiguration('tool')}).planning_pipelines(pipelines=['ompl'])
    built = built.trajectory_execution(file_path='config/more.yaml', moveit_manage_controllers=False)
    built = built.planning_scene_monitor(publish_robot_description=True).joint_limits('config/more.yaml').yaml('config/more.yaml', 'own')
    servo = ParameterBuilder('arm_moveit_config').yaml('config/more.yaml').parameter('rate', 3).path_parameter('file', 'config').to_dict()
    return LaunchDescription([
        DeclareLaunchArgument('tool', default_value='saw'),
        Node(package='here', executable='run', name='n', parameters=[built.to_dict()]),
        Node(package='here', executable='run', name='m', parameters=[servo])])
"""
    found = _composed(tmp_path, steps, **{"config/more.yaml": "some: 1"})
    assert problems(found, tmp_path) == []
    values = params(found)
    assert "saw" in str(values["/n/model"])
    assert values["/n/planning_pipelines"] == ["ompl"]
    assert values["/n/some"] == values["/n/own.some"] == values["/n/model_planning.some"] == values["/m/some"] == 1
    assert (values["/n/moveit_manage_controllers"], values["/n/publish_robot_description"]) == (False, True)
    assert (values["/m/rate"], values["/m/file"]) == (3, f"{tmp_path}/arm_moveit_config/config")
    assert "/n/moveit_simple_controller_manager.controller_names" not in values
    assert not any("cartesian_limits" in name for name in values)


def test_a_file_that_the_package_lacks(tmp_path: Path) -> None:
    body = _returning("generate_move_group_launch(MoveItConfigsBuilder('arm').to_moveit_configs())")
    found = _composed(tmp_path, body, **{"config/joint_limits.yaml": None})
    assert [str(problem).partition(": ")[2].replace(str(tmp_path), "") for problem in found.problems] == [
        "no such file: /arm_moveit_config/config/joint_limits.yaml"
    ]
    assert names(found) == ["/move_group"]


def test_controllers_that_moveit_cannot_choose_between(tmp_path: Path) -> None:
    body = _returning("generate_move_group_launch(MoveItConfigsBuilder('arm').to_moveit_configs())")
    found = _composed(tmp_path, body, **{"config/moveit_controllers.yaml": None, "config/other_controllers.yaml": "{}"})
    assert any("unable to guess" in str(problem) for problem in found.problems)


def test_xml_that_a_launch_file_reads(tmp_path: Path) -> None:
    body = """import os
import xml.etree.ElementTree as ET
def generate_launch_description():
    root = ET.parse(os.path.join(os.path.dirname(__file__), '../config/named.srdf')).getroot()
    inner = ET.fromstring('<a><b><c k="1">text</c></b><c k="2"/></a>')
    found = [one.get('k', 'none') for one in inner.findall('b/c')] + [one.attrib['k'] for one in inner.iter('c')]
    found += [inner.find('b/c').text, str(inner.find('d') is None), *[one.tag for one in inner], str(len(inner.findall('.//c')))]
    return LaunchDescription([Node(package='here', executable='run', name=root.get('name'), parameters=[{'found': found}])])
"""
    found = _composed(tmp_path, body)
    assert params(found) == {"/arm/found": ["1", "1", "2", "text", "True", "b", "c", "2"]}
    broken = _composed(tmp_path / "other", "import xml.etree.ElementTree as ET\n" + _returning("ET.fromstring('<a>')"))
    assert any("ParseError" in str(problem) for problem in broken.problems)


def test_what_a_helper_misses_is_told_where_the_launch_file_asks_for_it(tmp_path: Path) -> None:
    (tmp_path / "bare").mkdir()
    (tmp_path / "bare/package.xml").write_text(MANIFEST.format("bare"))
    config = "    config = MoveItConfigsBuilder('arm', package_name='bare').to_moveit_configs()\n"
    found = _composed(tmp_path, f"def generate_launch_description():\n{config}    return generate_rsp_launch(config)\n")
    places = {str(problem).replace(str(tmp_path), "").partition(": ")[0] for problem in found.problems}
    assert places == {"/arm_moveit_config/launch/main.launch.py:10:14"}
