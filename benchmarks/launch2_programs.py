"""Launch files of ROS 2 that are programs of Python, at random: what `launch2_random.py` cannot write as a list of actions.

`launch2_pieces.txt` has the pieces that they are made of, which append to `found`. In a piece `[[a || b]]` is one of several, `$word` a
name that only this piece has, and `$node`, `$text`, `$value` and the like are expressions that are made up.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from pathlib import Path

PIECES = (Path(__file__).parent / "launch2_pieces.txt").read_text(encoding="utf-8").strip().split("\n\n")
HEAD = """import functools, itertools, json, math, os, sys
from collections import namedtuple
from dataclasses import dataclass, field
from enum import Enum
from functools import partial
from pathlib import Path
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import Action, LaunchDescription, LaunchDescriptionSource, Substitution
from launch.actions import *
from launch.conditions import *
from launch.event_handlers import *
from launch.launch_description_sources import *
from launch.substitutions import *
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions
from launch_ros.actions import *
from launch_ros.descriptions import ComposableNode, ParameterValue
from launch_ros.substitutions import FindPackageShare
sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from helpers import *

SHARE = get_package_share_directory('random_launch')


"""
HELPERS = """from launch.actions import GroupAction
from launch_ros.actions import Node, PushRosNamespace

DEFAULTS = {"rate": 5, "frame": "base"}


def helped(name, *, rate=1.5, more=None, **kwargs):
    given = dict(DEFAULTS, rate=rate)
    given.update(more or {})
    return Node(package="random_launch", executable="helped", name=name, parameters=[given], **kwargs)


def within(namespace, *actions):
    return GroupAction([PushRosNamespace(namespace), *actions])


class Fleet:
    def __init__(self, prefix, count=2):
        self.prefix, self.count = prefix, count

    def __iter__(self):
        for index in range(self.count):
            yield helped(f"{self.prefix}_{index}", rate=index)

    @property
    def names(self):
        return [f"{self.prefix}_{index}" for index in range(self.count)]

    @classmethod
    def single(cls, prefix):
        return cls(prefix, 1)

    @staticmethod
    def suffixed(text, suffix="_s"):
        return text + suffix
"""
DATA = "nodes:\n  first: {rate: 1, frame: odom}\n  second: {list: [1, 2], deep: {er: on}}\nlist: [3, 4.5]\n"
WORDS = ("x", "robot", "true", "0", "0.5", "1e5", "007", "a.b", "True", "off", "yes", "", "a b")
VALUES = ("1", "2.5", "True", "-4", "'text'", "'1'", "[1, 2]", "['x', 'y']", "(0.5, 1.0)", "ParameterValue('3')", "2 ** 4")
_SLOT = re.compile(r"\$(node|text|value|truth|condition|component|asked|included)")


class Program:
    """One launch file."""

    def __init__(self, rng: random.Random, included: str) -> None:
        self.rng, self.included = rng, included
        self.arguments = [f"a{index}" for index in range(rng.randint(1, 3))]
        self.number = 0

    def one(self, *choices: str) -> str:
        return self.rng.choice(choices)

    def name(self, word: str) -> str:
        self.number += 1
        return f"{word}{self.number}"

    def asked(self) -> str:
        return repr("undeclared" if self.rng.random() < 0.005 else self.rng.choice(self.arguments))

    def text(self, depth: int = 0) -> str:
        """An expression of a text or a substitution."""
        word, asked = repr(self.rng.choice(WORDS)), f"LaunchConfiguration({self.asked()})"
        if depth > 1 or self.rng.random() < 0.5:
            return self.one(word, asked, f"TextSubstitution(text={word})")
        inner, other = self.text(depth + 1), self.text(depth + 1)
        return self.one(
            f"PathJoinSubstitution([{inner}, 'p', {other}])",
            f"PythonExpression([\"'\", {asked}, \"' + 'z'\"])",
            f'PythonExpression(["len(\'", {asked}, "\') * 2"])',
            f"EnvironmentVariable('A', default_value={word})",
            f"IfElseSubstitution({self.truth(depth + 1)}, if_value={inner}, else_value={other})",
            f"LaunchConfiguration('perhaps', default={inner})",
            f"Command(['echo ', {asked}, ' there'])",
            f"AnySubstitution({self.truth(depth + 1)}, {self.truth(depth + 1)})",
        )

    def truth(self, depth: int = 0) -> str:
        """An expression that comes to a Boolean."""
        asked, word = f"LaunchConfiguration({self.asked()})", repr(self.rng.choice(WORDS))
        if depth > 1:
            return repr(self.one("true", "false", "1", "0", "True"))
        return self.one(
            f"EqualsSubstitution({asked}, {word})",
            f"NotEqualsSubstitution({asked}, {word})",
            f"NotSubstitution({self.truth(depth + 1)})",
            f"AndSubstitution({self.truth(depth + 1)}, {self.truth(depth + 1)})",
            f"PythonExpression([\"'\", {asked}, \"' == 'x'\"])",
        )

    def condition(self) -> str:
        """The end of a call: a condition, now and then."""
        if self.rng.random() < 0.75:
            return ""
        return f", condition={self.one('If', 'Unless')}Condition({self.truth()})"

    def value(self) -> str:
        """The value of a parameter."""
        typed = f"ParameterValue({self.text()}, value_type=str)"
        return self.one(self.one(*VALUES), self.text(), typed, f"[LaunchConfiguration({self.asked()}), 'x']", f"{{'in': {self.text(2)}}}")

    def parameters(self) -> str:
        made = f"{{'p': {self.value()}, 'q': {self.value()}}}"
        return self.one("[]", f"[{made}]", f"[{made}, os.path.join(SHARE, 'parameters.yaml')]", "[Path(SHARE) / 'parameters.yaml']")

    def given(self) -> str:
        """What nodes and components have."""
        found = f", parameters={self.parameters()}"
        if self.rng.random() < 0.3:
            found += f", remappings={self.one(repr([('in', '/there')]), 'list(dict(a=chr(98)).items())', 'zip([chr(97)], [chr(98)])')}"
        return found + (f", namespace={self.one('ns', '/abs/ns', '', 'deep/er')!r}" if self.rng.random() < 0.3 else "")

    def node(self) -> str:
        more = self.one("", "", f", arguments=[{self.text()}, '--flag']", ", ros_arguments=['--log-level', 'debug']", ", respawn=True")
        return f"Node(package='random_launch', executable='e', name={self.name('node')!r}{self.given()}{more}{self.condition()})"

    def component(self) -> str:
        more = self.one("", ", extra_arguments=[{'use_intra_process_comms': True}]")
        return f"ComposableNode(package='random_launch', plugin='A', name={self.name('part')!r}{self.given()}{more}{self.condition()})"

    def piece(self) -> str:
        """A piece with its slots filled."""
        text, word = self.rng.choice(PIECES), self.name("w")
        choice = re.compile(r"\[\[((?:(?!\]\]).)*? \|\| .*?)\]\](?!\])", re.S)
        text = choice.sub(lambda match: self.rng.choice(match[1].split(" || ")).strip(" "), text)
        text = text.replace("$word", word).replace("$$", "on_start" if "OnProcessStart(" in text else "on_exit")
        slots: dict[str, Callable[[], str]] = {"included": lambda: repr(self.included)}
        return _SLOT.sub(lambda match: (slots.get(match[1]) or getattr(self, match[1]))(), text)

    def text_of(self) -> str:
        """The whole file."""
        declared = ", ".join(f"DeclareLaunchArgument({each!r}, default_value={self.rng.choice(WORDS)!r})" for each in self.arguments)
        lines = [line for _ in range(self.rng.randint(2, 4)) for line in self.piece().splitlines()]
        body = "".join(f"    {line}\n" for line in lines)
        ending = self.one("LaunchDescription(found)", "LaunchDescription([OpaqueFunction(function=lambda context: found)])")
        return f"{HEAD}def generate_launch_description():\n    found = [{declared}]\n{body}    return {ending}\n"
