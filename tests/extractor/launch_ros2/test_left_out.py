"""Actions that Python launch files make and give to nobody."""

from __future__ import annotations

import ast

import pytest

from rosarch.extractor.launch_ros2.left_out import left_out

FILE = """
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    {}
    return LaunchDescription([other])
"""


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        ("a = Node(package='x', executable='y')", [("Node", "a")]),
        ("if other:\n        a = launch.actions.ExecuteProcess(cmd=['x'])", [("ExecuteProcess", "a")]),
        ("a = DeclareLaunchArgument('x')\n    a = DeclareLaunchArgument('y')", [("DeclareLaunchArgument", "a")] * 2),
        ("Node(package='x', executable='y')", [("Node", "")]),
        ("other = Node(package='x', executable='y')", []),
        ("a = Node(package='x', executable='y')\n    other = [a]", []),
        ("a = Node(package='x', executable='y')\n    # other.append(a)", []),
        ("a = Node(package='x', executable='y')\n    other = list(locals().values())", []),
        ("global a\n    a = Node(package='x', executable='y')", []),
        ("a = Node(package='x', executable='y')\n    def inner():\n        return [a]", []),
        ("a = Node()\n    other = RegisterEventHandler(OnProcessExit(target_action=a, on_exit=[b]))", [("Node", "a")]),
        ("a = Node()\n    other = RegisterEventHandler(launch.event_handlers.OnProcessStart(a, on_start=[b]))", [("Node", "a")]),
        ("a = Node()\n    other = RegisterEventHandler(OnProcessExit(target_action=b, on_exit=[a]))", []),
        ("a = Node()\n    other = [a, RegisterEventHandler(OnProcessExit(target_action=a, on_exit=[b]))]", []),
        ("a = LaunchConfiguration('x')", []),
        ("a = b = Node(package='x', executable='y')", []),
        ("ld.add_action(Node(package='x', executable='y'))", []),
        ("def inner():\n        a = Node(package='x', executable='y')\n    inner()", [("Node", "a")]),
    ],
)
def test_actions(code: str, expected: list[tuple[str, str]]) -> None:
    text = FILE.format(code)
    found = list(left_out(ast.parse(text), text, "a.launch.py"))
    assert [(one.action, one.name) for one in found] == expected
    assert all(one.place.line >= 6 for one in found)


def test_files_that_describe_no_launch() -> None:
    text = FILE.format("a = Node()").replace("LaunchDescription", "Description")
    assert list(left_out(ast.parse(text), text, "a.py")) == []
