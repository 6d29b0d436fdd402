"""What the real launch of ROS 2 Kilted takes where it wants actions, texts and parameters, and what it refuses: all cases were run by it."""

from pathlib import Path

import pytest
from ros2_launch_builder import described, names, params

A, B = "node('a')", "node('b')"


@pytest.mark.parametrize(
    ("entities", "error"),
    [
        (f"{A}, [{B}]", "AttributeError: 'list' object has no attribute 'visit'"),
        (f"{A}, ({B},)", "AttributeError: 'tuple' object has no attribute 'visit'"),
        (f"{A}, None", "AttributeError: 'NoneType' object has no attribute 'visit'"),
        (f"{A}, 'b'", "AttributeError: 'str' object has no attribute 'visit'"),
        (f"{A}, LaunchConfiguration('b')", "AttributeError: 'LaunchConfiguration' object has no attribute 'visit'"),
        (f"{A}, ComposableNode(package='here', plugin='B')", "AttributeError: 'ComposableNode' object has no attribute 'visit'"),
        (f"{A}, Node", "AttributeError: 'type' object has no attribute 'visit'"),
        (f"{A}, GroupAction([[{B}]])", "AttributeError: 'list' object has no attribute 'visit'"),
        (f"{A}, GroupAction({B})", "TypeError: 'Node' object is not iterable"),
        (f"{A}, OpaqueFunction(function=lambda context: [[{B}]])", "AttributeError: 'list' object has no attribute 'visit'"),
        (f"{A}, OpaqueFunction(function=lambda context: {B})", "TypeError: 'Node' object is not iterable"),
        (f"{A}, OpaqueFunction(function=[{B}])", "TypeError: OpaqueFunction expected a callable for 'function', got 'list'"),
        (f"{A}, TimerAction(period=1.0, actions=[[{B}]])", "AttributeError: 'list' object has no attribute 'visit'"),
        (f"{A}, TimerAction(period='soon', actions=[{B}])", "ValueError: could not convert string to float: 'soon'"),
        (f"{A}, TimerAction(period=1, actions=[{B}])", "TypeError: 'int' object is not iterable"),
    ],
)
def test_what_is_no_action(tmp_path: Path, entities: str, error: str) -> None:
    found = described(tmp_path, entities)
    assert [problem.message for problem in found.problems] == [error]
    assert names(found) == ["/a"]


@pytest.mark.parametrize(
    "entities",
    [
        f"{A}, LaunchDescription([{B}])",
        f"{A}, OpaqueFunction(function=lambda context: ({B},))",
        f"{A}, OpaqueFunction(function=lambda context: None), {B}",
        f"{A}, TimerAction(period=1.0, actions=({B},))",
        "(a := node('a')), RegisterEventHandler(OnProcessExit(target_action=a, on_exit=node('b')))",
    ],
)
def test_what_stands_for_actions(tmp_path: Path, entities: str) -> None:
    found = described(tmp_path, entities)
    assert (names(found), found.problems) == (["/a", "/b"], ())


@pytest.mark.parametrize(
    ("action", "kind"),
    [
        ("Node(package='here', executable='run', name='a', arguments=[1])", "int"),
        ("Node(package='here', executable='run', name='a', arguments=[None])", "NoneType"),
        ("Node(package='here', executable='run', name='a', arguments=[Path('x')])", "PosixPath"),
        ("Node(package='here', executable='run', name='a', arguments=LaunchConfiguration('x', default='y'))", "LaunchConfiguration"),
        ("Node(package='here', executable='run', name='a', condition=IfCondition(True))", "bool"),
        ("Node(package='here', executable='run', name='a', remappings=[('x', 1)])", "int"),
        ("Node(package='here', executable='run', name='a', additional_env={'X': 1})", "int"),
        ("DeclareLaunchArgument('x', default_value=True)", "bool"),
        ("DeclareLaunchArgument('x', default_value=Path('x'))", "PosixPath"),
        ("SetEnvironmentVariable('X', 1)", "int"),
        ("LogInfo(msg=3)", "int"),
        ("ExecuteProcess(cmd=['x', 1])", "int"),
        ("ComposableNodeContainer(package='here', executable='run', name='a', namespace='', "
         "composable_node_descriptions=ComposableNode(package='here', plugin='B'))", "ComposableNode"),
    ],
)  # fmt: skip
def test_what_is_no_text_and_no_list(tmp_path: Path, action: str, kind: str) -> None:
    assert [one.message for one in described(tmp_path, action).problems] == [f"TypeError: '{kind}' object is not iterable"]


@pytest.mark.parametrize(
    ("made", "message"),
    [
        ("Node('b', package='here', executable='run')", "Node.__init__() takes 1 positional argument but 2 were given"),
        ("LogInfo('b', 'c')", "LogInfo.__init__() takes 1 positional argument but 3 were given"),
        ("SetRemap('b', 'c', 'd')", "SetRemap.__init__() takes 3 positional arguments but 4 were given"),
        ("node(LaunchConfiguration('b', 'c'))", "LaunchConfiguration.__init__() takes 2 positional arguments but 3 were given"),
        ("node('b', condition=IfCondition('true', 'c'))", "IfCondition.__init__() takes 2 positional arguments but 3 were given"),
        ("TimerAction(1.0, [node('b')])", "TimerAction.__init__() takes 1 positional argument but 3 were given"),
        (
            "node('b', condition=IfCondition('false'), parameters=[{'p': [[1], [2]]}])",
            "Node: an item of a list within a list must be a text or a substitution",
        ),
    ],
)
def test_what_constructors_reject(tmp_path: Path, made: str, message: str) -> None:
    assert message in [
        problem.message.removeprefix("TypeError: ") for problem in described(tmp_path, f"{A}, {made}").problems if problem.fatal
    ]


def test_a_truth_value_is_passed_to_an_included_file(tmp_path: Path) -> None:
    included = "IncludeLaunchDescription(LaunchDescription([]), launch_arguments={'x': 'true'}.items())"
    assert not described(tmp_path / "text", included).problems
    for value, kind in (("True", "bool"), ("None", "NoneType"), ("Path('y')", "PosixPath")):
        passed = f"IncludeLaunchDescription(PythonLaunchDescriptionSource('/gone'), launch_arguments={{'x': {value}}}.items())"
        messages = [one.message for one in described(tmp_path / kind, passed).problems]
        assert messages == [f"TypeError: '{kind}' object is not iterable: the launch argument `x` must be a text or substitutions"]


def test_equality_is_of_the_texts_of_values(tmp_path: Path) -> None:
    same = "EqualsSubstitution(LaunchConfiguration('x', default='true'), True)"
    found = described(tmp_path, f"Node(package='here', executable='run', name='a', condition=IfCondition({same}))")
    assert (names(found), found.problems) == (["/a"], ())


@pytest.mark.parametrize(("default", "expected"), [("True", True), ("3", 3), ("Path('x')", "x"), ("['a', 1]", "a1")])
def test_a_default_of_a_configuration_may_be_anything(tmp_path: Path, default: str, expected: object) -> None:
    found = described(tmp_path, f"node('a', parameters=[{{'p': LaunchConfiguration('x', default={default})}}])")
    assert (params(found), found.problems) == ({"/a/p": expected}, ())


def test_a_text_of_arguments_is_a_list_of_its_characters(tmp_path: Path) -> None:
    assert described(tmp_path, "Node(package='here', executable='run', arguments='-x')").nodes[0].args == "- x"


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        ("[LaunchConfiguration('x', default='3'), 1]", [3, 1]),
        ("[LaunchConfiguration('x', default='3'), 'b']", "3b"),
        ("[['a', 'b'], ['c']]", ["ab", "c"]),
        ("ParameterValue(['1', '2'])", ["1", "2"]),
        ("ParameterValue([1, 2])", [1, 2]),
        ("[]", None),
        ("[[1, 2], [3]]", None),
        ("[{'q': 1}]", None),
    ],
)
def test_lists_as_parameters(tmp_path: Path, value: str, expected: object) -> None:
    found = described(tmp_path, f"node('a', parameters=[{{'p': {value}}}])")
    assert params(found) == ({} if expected is None else {"/a/p": expected})
    assert len(found.problems) == (expected is None)


def test_a_file_of_parameters_that_is_none(tmp_path: Path) -> None:
    assert [one.kind for one in described(tmp_path, "node('a', parameters=[None])").problems] == ["python"]
    assert not described(tmp_path / "path", "node('a', parameters=[Path('/gone.yaml')])").nodes[0].own_params


def test_all_that_a_module_brings(tmp_path: Path) -> None:
    body = "from launch_ros.descriptions import *\nvalue = ParameterValue('1', value_type=str)"
    assert params(described(tmp_path, "node('a', parameters=[{'p': value}])", body)) == {"/a/p": "1"}
