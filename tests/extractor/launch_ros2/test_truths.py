"""Where Python launch files take configurations for their values."""

from __future__ import annotations

import ast

import pytest

from rosarch.extractor.launch.model import SubstitutionUsed, TextTested
from rosarch.extractor.launch_ros2.truths import truths

FILE = """
from launch.substitutions import LaunchConfiguration
import launch
outer = LaunchConfiguration('outer')

def setup(context, given, twice=None):
    mode = launch.substitutions.LaunchConfiguration('mode', default='a')
    text = mode.perform(context)
    twice = LaunchConfiguration('twice')
    twice = 'x'
    {}
"""


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        ("if text: pass", "text mode"),
        ("if not mode.perform(context): pass", "text mode"),
        ("if given and text: pass", "text mode"),
        ("x = 1 if text else 2", "text mode"),
        ("x = bool(text)", "text mode"),
        ("x = [a for a in given if text]", "text mode"),
        ("if text == True: pass", "mode is a text and equals no other value"),
        ("if mode: pass", "mode counts as true"),
        ("if outer: pass", "outer counts as true"),
        ("if mode == 'a': pass", "mode equals no value"),
        ("if 'a' != LaunchConfiguration('other'): pass", "other equals no value"),
        ("def inner():\n        if mode: pass", "mode counts as true"),
        ("x = f'robot_{mode}'", "mode is written as the object that it is, not as its value"),
        ("x = str(mode)", "mode is written as the object that it is, not as its value"),
        ("x = 'robot_' + mode", "mode cannot be joined with a text: TypeError"),
        ("x = os.path.join('/tmp', mode)", "mode is no path: TypeError"),
        ("x = os.path.join(FindPackageShare('light'), 'config')", "FindPackageShare is no path: TypeError"),
        ("x = PathJoinSubstitution([FindPackageShare('light'), 'config'])", ""),
        ("x = Node(condition=mode)", "mode is no condition: IfCondition makes one of it"),
        ("x = Node(condition=IfCondition(mode))", ""),
        ("x = LaunchConfigurationEquals(mode, 'a')", "mode is not the name of a configuration: LaunchConfigurationEquals never holds"),
        (
            "x = Node(condition=conditions.LaunchConfigurationNotEquals(LaunchConfiguration('x'), ''))",
            "x is not the name of a configuration: LaunchConfigurationNotEquals always holds",
        ),
        ("x = LaunchConfigurationEquals('mode', mode)", ""),
        ("x = Node(condition=given)", ""),
        ("x = Check(condition=mode)", ""),
        ("x = f'robot_{text}'", ""),
        ("x = [mode] + given", ""),
        ("print(f'robot_{mode}')", ""),
        ("x = text or 'a'", ""),
        ("if text == 'a': pass", ""),
        ("if mode is None: pass", ""),
        ("if mode == given: pass", ""),
        ("if twice: pass", ""),
        ("if given: pass", ""),
        ("if not given:\n        given = LaunchConfiguration('given')", ""),
        ("if text.lower() == 'true': pass", ""),
        ("def inner(mode):\n        if mode: pass", ""),
    ],
)
def test_what_is_taken_for_a_value(code: str, expected: str) -> None:
    found = list(truths(ast.parse(FILE.format(code)), "a.launch.py"))
    shown = [f"text {one.name}" if isinstance(one, TextTested) else f"{one.name} {one.effect}" for one in found]
    assert shown == ([expected] if expected else [])
    assert all(isinstance(one, (TextTested, SubstitutionUsed)) and one.place.line > 1 for one in found)
