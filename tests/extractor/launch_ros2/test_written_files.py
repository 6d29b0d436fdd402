"""Configuration files that Python launch files write for the nodes that they start."""

from __future__ import annotations

from pathlib import Path

import pytest
from ros2_launch_builder import described

from rosarch.extractor.launch.facts import launch_rows
from rosarch.reports.launch_table import composition_text

_BRIDGED = """import os, tempfile, yaml
def bridge_of(robot):
    entries = [{'ros_topic_name': f'{robot}/scan', 'gz_topic_name': 'scan', 'ros_type_name': 'sensor_msgs/msg/LaserScan',
                'gz_type_name': 'gz.msgs.LaserScan', 'direction': 'GZ_TO_ROS'}]
    path = PATH
    with open(path, 'w') as file:
        yaml.dump(entries, file)
    return path
"""
_BRIDGE = "*[Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=['--ros-args', '-p', f'config_file:={bridge_of(one)}']) for one in 'ab']"


@pytest.mark.parametrize("path", ["f'/tmp/{robot}_bridge.yaml'", "os.path.join(tempfile.gettempdir(), f'{robot}.yaml')"])
def test_what_a_bridge_passes_on(tmp_path: Path, path: str) -> None:
    found = described(tmp_path, _BRIDGE, _BRIDGED.replace("PATH", path))
    rows = launch_rows(found, tmp_path)
    by_node = {(node, port): None for node, port in rows["bridge_port"]}
    names = {name for owner, port, kind, name in rows["interface_port"] if (owner, port) in by_node and kind == "publisher"}
    assert names == {"a/scan", "b/scan"}
    assert "bridge_unread" not in rows
    line = found.nodes[0].lines[-1].line
    assert {place for _, place in rows["interface_port_at"]} == {f"here/launch/main.launch.py:{line}:{found.nodes[0].lines[-1].column}"}
    paths = [line.split("=")[1] for line in composition_text(found, tmp_path).splitlines() if "config_file" in line]
    assert len(paths) == len(set(paths)) == 2


def test_what_is_written_and_not_known_is_not_read(tmp_path: Path) -> None:
    before = _BRIDGED.replace("PATH", "f'/tmp/{robot}.yaml'").replace("yaml.dump(entries, file)", "file.write(unknown_function(robot))")
    rows = launch_rows(described(tmp_path, _BRIDGE, before), tmp_path)
    assert "bridge_port" not in rows
    assert len(rows["bridge_unread"]) == 2


def test_what_a_viewer_shows(tmp_path: Path) -> None:
    text = "Visualization Manager: {Displays: [{Class: rviz_default_plugins/Map, Topic: {Value: /ROBOT/map}}, {Class: rviz_default_plugins/Path, Topic: {Value: /ROBOT/path}}]}"
    before = f"""import os, tempfile
def view_of(robot):
    path = os.path.join(tempfile.gettempdir(), robot + '.rviz')
    with open(path, 'w') as file:
        file.write({text!r}.replace('ROBOT', robot))
    return path
"""
    found = described(tmp_path, "Node(package='rviz2', executable='rviz2', name='rviz2', arguments=['-d', view_of('tb1')])", before)
    rows = launch_rows(found, tmp_path)
    assert {(kind, name) for _, _, kind, name in rows["interface_port"]} == {("subscriber", "/tb1/map"), ("subscriber", "/tb1/path")}
    assert {place.rpartition("/")[2].split(":")[0] for _, place in rows["interface_port_at"]} == {"main.launch.py"}
