"""Controllers of ROS 1: what spawners ask for, of which class, in which manager."""

from __future__ import annotations

from pathlib import Path

from launch_builder import composed

YAML = """
arm: {type: position_controllers/JointTrajectoryController, joints: [a]}
state: {type: joint_state_controller/JointStateController}
robot: {base: {type: "diff_drive_controller/DiffDriveController"}, deep: {grip: {type: my_controllers/Grip}}}
"""


def test_spawners(tmp_path: Path) -> None:
    content = """
<rosparam command="load" file="$(find here)/c.yaml"/>
<node name="first" pkg="controller_manager" type="spawner" args="--timeout 3 state --stopped arm unknown arm"/>
<node name="second" pkg="controller_manager" type="spawner" args="--namespace=robot base" if="$(optenv BASE true)"/>
<node name="third" ns="robot" pkg="controller_manager" type="controller_manager" args="spawn deep/grip"/>
<node name="none" pkg="controller_manager" type="controller_manager" args="list arm"/>
<node name="other" pkg="spawners" type="spawner" args="arm"/>
"""
    found = composed(tmp_path, content, c_yaml=YAML)
    assert [(node.full_name, node.package, node.type, node.container) for node in found.controllers] == [
        ("/state", "joint_state_controller", "joint_state_controller/JointStateController", "/controller_manager"),
        ("/arm", "position_controllers", "position_controllers/JointTrajectoryController", "/controller_manager"),
        ("/robot/base", "diff_drive_controller", "diff_drive_controller/DiffDriveController", "/robot/controller_manager"),
        ("/robot/deep/grip", "my_controllers", "my_controllers/Grip", "/robot/controller_manager"),
    ]
    # roslaunch knows nothing of them
    assert len(found.nodes) == 5
    assert len(found.with_controllers().nodes) == 9


def test_what_is_not_known_is_left_out(tmp_path: Path) -> None:
    content = """
<arg name="which"/>
<rosparam command="load" file="$(find here)/c.yaml"/>
<param name="base/type" value="here/One" if="$(arg which)"/>
<param name="base/type" value="here/Two" unless="$(arg which)"/>
<node name="first" pkg="controller_manager" type="spawner" args="$(arg which) base"/>
<node name="second" pkg="controller_manager" type="spawner" args="arm" if="$(arg which)"/>
"""
    found = composed(tmp_path, content, c_yaml=YAML)
    assert [(node.full_name, len(node.conditions)) for node in found.controllers] == [("/arm", 1)]
