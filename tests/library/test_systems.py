"""The files of packages that ship with the library."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml

from rosarch.extractor.underlay import Underlay
from rosarch.library import prefixes
from tests.extractor.workspace_builder import write
from tests.library.test_files import MANIFEST

PACKAGES = Underlay(libraries=prefixes()).packages
DATA = {".json", ".launch", ".xml", ".urdf", ".xacro", ".sdf", ".world", ".model", ".yaml", ".yml", ".rviz", ".msg", ".srv", ".action"}


def test_each_package_says_where_it_is_from() -> None:
    assert PACKAGES.keys() >= {"nav2_bringup", "slam_toolbox", "robot_localization", "ros_gz_sim", "gazebo_ros", "rplidar_ros"}
    for prefix, ros in prefixes():
        for folder in Path(prefix, "share").iterdir():
            origin = yaml.safe_load((folder / "origin.yaml").read_text())
            assert (origin["package"], origin["ros"]) == (folder.name, ros)
            assert all(origin[key] for key in ("origin", "revision", "licence", "distributions")), folder
            kinds = {path.suffix for path in folder.rglob("*") if path.is_file()}
            assert kinds <= DATA, folder


@pytest.mark.slow
def test_a_workspace_alone_includes_navigation(tmp_path: Path, rosarch: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    launch = '<launch><include file="$(find-pkg-share nav2_bringup)/launch/navigation_launch.py"/></launch>\n'
    write(Path("ws"), {"package.xml": MANIFEST.format("robot"), "launch/main.launch.xml": launch, "CMakeLists.txt": "project(robot)\n"})
    [system] = json.loads(rosarch("show", "graph", "ws", "--format", "json").out)
    nodes = {node["name"]: node["origin"] for node in system["nodes"]}
    servers = {"controller_server", "smoother_server", "planner_server", "behavior_server", "bt_navigator", "waypoint_follower"}
    made = {f"{each}_costmap/{each}_costmap" for each in ("local", "global")}
    made |= {f"bt_navigator_navigate_{each}_rclcpp_node" for each in ("to_pose", "through_poses")}
    programs = {*servers, "velocity_smoother", "lifecycle_manager_navigation"}
    assert nodes == dict.fromkeys({f"/{name}" for name in programs | made}, "library")
    assert "/cmd_vel_nav" in {name for connector in system["connectors"] for name in connector["names"]}
