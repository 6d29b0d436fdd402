"""Classes, iteration and control flow of Python launch files, beside the real launch of ROS 2: all cases were run by it."""

from pathlib import Path

import pytest
from ros2_launch_builder import composed, described, names, params, xml

ENUMERATION = "from enum import Enum\nclass Mode(Enum):\n    SIM = 'sim'\n    REAL = 'real'\n"
FLEET = """class Fleet:
    def __init__(self, count):
        self.count = count
    def __iter__(self):
        for index in range(self.count):
            yield node(f'robot_{index}')
"""
MEMBERS = """class A:
    def __init__(self, name='a'):
        self.known_as = name
    @classmethod
    def other(cls):
        return cls('o')
    @property
    def name(self):
        return self.known_as + '_p'
    def made(self):
        return node(self.name)
"""
GENERATOR = "def made(count):\n    for index in range(count):\n        yield node(f'made_{index}')\n"


def matched(subject: str, cases: str) -> str:
    return f"found = []\nmatch {subject}:\n" + "".join(f"    case {case}\n" for case in cases.split("; "))


@pytest.mark.parametrize(
    ("before", "entities", "started"),
    [
        (ENUMERATION, "*[node(mode.value) for mode in Mode]", ["/sim", "/real"]),
        (ENUMERATION, "node(Mode.SIM.name), node(Mode['REAL'].value), node(Mode('sim').name.lower() + '_b')", ["/SIM", "/real", "/sim_b"]),
        (FLEET, "*Fleet(2)", ["/robot_0", "/robot_1"]),
        (FLEET, "*[one for one in Fleet(2)][1:], *list(Fleet(1))", ["/robot_1", "/robot_0"]),
        (GENERATOR, "next(made(2)), next(iter([node('first'), node('second')]))", ["/made_0", "/first"]),
        ("import functools", "functools.partial(node, namespace='ns')('a')", ["/ns/a"]),
        ("from functools import partial", "partial(Node, package='here', executable='run')(name='a')", ["/a"]),
        ("", "*map(node, ['a', 'b'])", ["/a", "/b"]),
        (matched("'x'", "'y': found = [node('y')]; 'x' | 'z': found = [node('x')]; _: found = [node('other')]"), "*found", ["/x"]),
        (matched("'q'", "'y': found = [node('y')]; _: found = [node('other')]"), "*found", ["/other"]),
        (matched("'q'.upper()", "'Y': pass; found_name if found_name == 'Q': found = [node(found_name)]"), "*found", ["/Q"]),
        (matched("None", "True: pass; None: found = [node('none')]"), "*found", ["/none"]),
        ("import itertools", "*[node('_'.join(each)) for each in itertools.product('ab', 'cd')][1:3]", ["/a_d", "/b_c"]),
        ("try:\n    found = [0][3]\nexcept LookupError:\n    found = node('caught')\n", "found", ["/caught"]),
        (MEMBERS, "A().made(), A.other().made()", ["/a_p", "/o_p"]),
        ("class Own(Action):\n    def execute(self, context):\n        return [node('own')]\n", "Own(condition=UnlessCondition('true')), Own()", ["/own"]),
    ],
)  # fmt: skip
def test_what_starts(tmp_path: Path, before: str, entities: str, started: list[str]) -> None:
    found = described(tmp_path, entities, f"from launch import Action\n{before}")
    assert (names(found), found.problems) == (started, ())


@pytest.mark.parametrize(
    ("before", "value", "expected"),
    [
        ("import math", "math.pi", 3.141592653589793),
        ("from math import tau", "round(tau, 2)", 6.28),
        ("from dataclasses import *\n@dataclass\nclass A:\n    tags: list = field(default_factory=lambda: ['t'])\n", "A().tags", ["t"]),
        ("from dataclasses import *\n@dataclass\nclass A:\n    n: int\n    m: float = field(default=2.5)\n", "[A(1).n, A(1, 2).m]", [1, 2]),
        ("from dataclasses import *\n@dataclass\nclass A:\n    n: int\n    def __post_init__(self):\n        self.n += 1\n", "A(1).n", 2),
        ("from collections import namedtuple\nclass A(namedtuple('A', 'n m')):\n    pass\n", "A(1, 'x').m", "x"),
        ("", "ParameterValue('3')", "3"),
        ("", "ParameterValue('off')", "off"),
    ],
)
def test_values(tmp_path: Path, before: str, value: str, expected: object) -> None:
    found = described(tmp_path, f"node('a', parameters=[{{'p': {value}}}])", before)
    assert (params(found), found.problems) == ({"/a/p": expected}, ())


def test_where_a_map_stands_for_texts_its_names_are_meant(tmp_path: Path) -> None:
    found = described(tmp_path, "node('a', arguments=['-topic', {'robot_description': 'x'}])")
    assert [one.args for one in found.nodes] == ["-topic robot_description"]


def test_a_container_without_components(tmp_path: Path) -> None:
    made = "ComposableNodeContainer(name='c', namespace='', package='here', executable='run', composable_node_descriptions=None)"
    found = described(tmp_path, made)
    assert (names(found), found.problems) == (["/c"], ())


def test_shutdown_is_an_action_also_where_its_event_is_imported(tmp_path: Path) -> None:
    exits = "(a := node('a')), RegisterEventHandler(OnProcessExit(target_action=a, on_exit=[Shutdown(reason='over')]))"
    found = described(tmp_path, exits, "from launch.events import Shutdown as Over")
    assert (names(found), found.problems) == (["/a"], ())


def test_a_handler_that_handles_once(tmp_path: Path) -> None:
    handler = "RegisterEventHandler(OnProcessStart(on_start=[node('after')], handle_once=True))"
    found = described(tmp_path, f"{handler}, node('a'), node('b')", "from launch.event_handlers import OnProcessStart")
    assert names(found) == ["/a", "/b", "/after"]


@pytest.mark.parametrize("kind", ["node('a', respawn='false')", "ExecuteProcess(cmd=['x'], respawn='true')"])
def test_respawn_takes_no_text(tmp_path: Path, kind: str) -> None:
    found = described(tmp_path, kind)
    assert [problem.message.partition(": ")[2] for problem in found.problems] == ["respawn must be a Boolean, or a substitution"]


def test_the_command_line_is_that_of_launch(tmp_path: Path) -> None:
    before = "import sys\ngiven = dict(word.split(':=') for word in sys.argv if ':=' in word)"
    entities = "*[node(name, parameters=[{'value': value}]) for name, value in given.items()]"
    assert names(described(tmp_path, entities, before)) == []
    assert params(described(tmp_path, entities, before, {"a": "x"})) == {"/a/value": "x"}


def test_what_is_described_in_place_gets_arguments(tmp_path: Path) -> None:
    inner = "LaunchDescription([node('a', parameters=[{'p': LaunchConfiguration('given')}])])"
    for source in (inner, f"LaunchDescriptionSource({inner})"):
        found = described(
            tmp_path, f"IncludeLaunchDescription({source}, launch_arguments={{'given': 'x'}}.items())", "from launch import *"
        )
        assert (params(found), found.problems) == ({"/a/p": "x"}, ())


EXITS = "handler = OnProcessExit(target_action=first, on_exit=[node('after')])"


@pytest.mark.parametrize(
    ("entities", "started", "errors"),
    [
        ("first, RegisterEventHandler(handler)", ["/first", "/after"], []),
        ("first, RegisterEventHandler(handler), UnregisterEventHandler(handler)", ["/first"], []),
        ("first, UnregisterEventHandler(handler)", ["/first"], ["ValueError: OnProcessExit is not registered"]),
    ],
)
def test_handlers_that_are_taken_back(tmp_path: Path, entities: str, started: list[str], errors: list[str]) -> None:
    found = described(tmp_path, entities, f"first = node('first')\n{EXITS}")
    assert (names(found), [problem.message for problem in found.problems]) == (started, errors)


def test_a_component_takes_no_object_for_one_parameter(tmp_path: Path) -> None:
    one = "ComposableNode(package='here', plugin='A', name='a', parameters=[Parameter('p', 'x')])"
    found = described(
        tmp_path,
        f"LoadComposableNodes(target_container='c', composable_node_descriptions=[{one}])",
        "from launch_ros.descriptions import Parameter",
    )
    assert [problem.message for problem in found.problems] == [
        "RuntimeError: invalid evaluated parameters: a component takes no `Parameter`"
    ]


def test_lists_within_lists_are_no_words(tmp_path: Path) -> None:
    found = described(tmp_path, "ExecuteProcess(cmd=[['echo ', ['a', 'b']]], shell=True)")
    assert [problem.message.partition(":")[0] for problem in found.problems] == ["TypeError"]


@pytest.mark.parametrize(
    ("attributes", "error"),
    [
        ('on_exit="restart"', "the attribute `on_exit` of <node> must be `shutdown`"),
        ('respawn_delay="soon"', "the attribute `respawn_delay` of <node> must be a number that is not negative"),
        ('sigterm_timeout="-2.0"', "the attribute `sigterm_timeout` of <node> must be a number that is not negative"),
        ('node-name="old"', "<node> has no attribute `node-name`: since Galactic it is `name`"),
        ('on_exit="shutdown" respawn_delay="2" sigkill_timeout="0.5"', None),
    ],
)
def test_attributes_of_processes(tmp_path: Path, attributes: str, error: str | None) -> None:
    found = xml(tmp_path, f'<node pkg="here" exec="run" name="a" {attributes}/>')
    assert [problem.message for problem in found.problems] == ([] if error is None else [error])


@pytest.mark.parametrize(("delay", "refused"), [("2", True), ('"2"', True), ("-2.0", True), ("2.0", False)])
def test_times_in_yaml_are_written_with_a_point(tmp_path: Path, delay: str, refused: bool) -> None:
    text = f"launch:\n- node: {{pkg: here, exec: run, name: a, respawn_delay: {delay}}}\n"
    assert bool(composed(tmp_path, {"main.launch.yaml": text}).problems) is refused


@pytest.mark.parametrize("value", ["null", "~", "#no $(var a)"])
def test_a_parameter_that_is_none_in_yaml(tmp_path: Path, value: str) -> None:
    found = xml(tmp_path, f'<arg name="a" default="b"/><node pkg="here" exec="run" name="a"><param name="p" value="{value}"/></node>')
    assert [problem.message for problem in found.problems] == [f"`{value}` is neither a scalar nor a list of one type"]


@pytest.mark.parametrize(("base", "errors"), [("object", ["TypeError: A() takes no arguments"]), ("Unseen", [])])
def test_a_class_that_takes_no_arguments(tmp_path: Path, base: str, errors: list[str]) -> None:
    before = f"from unseen import Unseen\nclass A({base}):\n    def made(self):\n        return node('a')\n"
    found = described(tmp_path, "A('x').made()", before)
    assert [problem.message for problem in found.problems if problem.kind == "python" and problem.fatal] == errors
