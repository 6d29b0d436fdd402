"""Python launch files of kinds in which the real `ros2 launch` was seen to come to something else."""

from __future__ import annotations

from pathlib import Path

import pytest
from ros2_launch_builder import HEAD, MANIFEST, composed, described, names, params, problems


def _ends(text: str) -> str:
    return f"def generate_launch_description():\n    return LaunchDescription([{text}])\n"


def test_objects_are_of_the_classes_that_theirs_are_derived_from(tmp_path: Path) -> None:
    before = """from launch import Action, LaunchDescriptionEntity
class Joined(Substitution):
    def __init__(self, *parts):
        self.__parts = parts
    def perform(self, context):
        return ''.join(part.perform(context) if isinstance(part, Substitution) else str(part) for part in self.__parts)
class Twice(Joined):
    pass
one = node('one')
kinds = [isinstance(one, ExecuteProcess), isinstance(one, (str, LaunchDescriptionEntity)), isinstance(one, Substitution),
         isinstance(Twice(), Joined), isinstance(Joined(), Twice), isinstance(Twice(), Action)]"""
    given = "node(Joined('n_', LaunchConfiguration('a'))), node(Twice('m_', Joined(1, LaunchConfiguration('a')))), node('k', arguments=[str(kinds), str(isinstance(one, elsewhere))])"
    found = described(tmp_path, f"DeclareLaunchArgument('a', default_value='x'), {given}", before)
    assert names(found) == ["/n_x", "/m_1x", "/k"]
    assert found.nodes[2].args == "'[True, True, False, True, False, False]' '$(isinstance(one, elsewhere))'"


def test_a_set_of_remappings(tmp_path: Path) -> None:
    found = described(tmp_path, "node('n', remappings={('b', 'x'),\n ('a', 'y'), ('c', LaunchConfiguration('z'))}),", "", {"z": "1"})
    assert [(remap.source, remap.target) for remap in found.nodes[0].remaps] == [("b", "x"), ("a", "y"), ("c", "1")]


def test_a_text_joined_and_a_condition_evaluated(tmp_path: Path) -> None:
    setup = """def setup(context):
    name = ''.join(LaunchConfiguration('a').perform(context))
    held = IfCondition(PythonExpression(["'", name, "' == 'x'"]))._predicate_func(context)
    return [node(name if held else 'other')]
"""
    found = composed(tmp_path, {"main.launch.py": HEAD + setup + _ends("OpaqueFunction(function=setup)")}, {"a": "x"})
    assert names(found) == ["/x"]


def test_the_environment_of_launch_is_set_by_python(tmp_path: Path) -> None:
    before = """os.environ['A'] = 'a'
os.environ.setdefault('B', 'b')
os.environ.update({'C': 'c'}, D='d')
os.environ.setdefault('A', 'no')
here = 'A' in os.environ and os.getenv('B') + os.environ['C'] + os.environ.pop('D')"""
    args = "EnvironmentVariable('A'), EnvironmentVariable('B'), here, EnvironmentVariable('D', default_value='gone')"
    assert described(tmp_path, f"node('n', arguments=[{args}])", before).nodes[0].args == "a b bcd gone"


def test_decorators_of_the_launch_file(tmp_path: Path) -> None:
    text = (
        HEAD
        + """import functools
def declares(*names):
    def decorator(made):
        @functools.wraps(made)
        def wrapper():
            setup = lambda context: [made(**{name: LaunchConfiguration(name).perform(context) for name in names})]
            return LaunchDescription([*[DeclareLaunchArgument(name, default_value=name) for name in names], OpaqueFunction(function=setup)])
        return wrapper
    return decorator

@declares('a', 'b')
def generate_launch_description(a, b):
    return node(a + b)
"""
    )
    assert names(composed(tmp_path, {"main.launch.py": text})) == ["/ab"]


@pytest.mark.parametrize(
    ("entity", "refused"),
    [
        ("node('n', parameters=['/nowhere/p.yaml', {'a': 1}])", False),
        ("node('n', parameters=[ParameterFile('/nowhere/p.yaml', allow_substs=True)])", True),
        ("SetParametersFromFile('/nowhere/p.yaml'), node('n')", True),
        ("LoadComposableNodes(target_container='c', composable_node_descriptions=[ComposableNode(package='here', plugin='P', name='n', parameters=['/nowhere/p.yaml'])])", True),
    ],
)  # fmt: skip
def test_a_file_of_parameters_that_is_not_there(tmp_path: Path, entity: str, refused: bool) -> None:
    found = described(tmp_path, entity)
    assert ["no such file" in problem for problem in problems(found, tmp_path)] == [True]
    assert (found.refusal is not None) is refused


INNER = """DeclareLaunchArgument('given', default_value='1'), DeclareLaunchArgument('must'), GroupAction([DeclareLaunchArgument('in_group')]),
  DeclareLaunchArgument('perhaps', condition=IfCondition('false')), TimerAction(period=1.0, actions=[DeclareLaunchArgument('later')])"""


def test_an_include_must_pass_what_has_no_default_though_it_is_set(tmp_path: Path) -> None:
    def include(passed: str) -> str:
        return f"IncludeLaunchDescription(os.path.join(os.path.dirname(__file__), 'inner.launch.py'), launch_arguments={passed})"

    outer = "SetLaunchConfiguration('must', '1'), SetLaunchConfiguration('in_group', '1'), SetLaunchConfiguration('later', '1')"
    for passed, said in (("{'must': 'x'}.items()", ["in_group"]), ("[('must', 'x'), ('in_group', 'y')]", [])):
        main = HEAD + _ends(f"{outer}, {include(passed)}")
        found = composed(tmp_path / str(len(said)), {"main.launch.py": main, "inner.launch.py": HEAD + _ends(INNER)})
        assert [problem.subject for problem in found.problems if problem.kind == "argument"] == said


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        ("from helper.launch import thing", ["package `helper` is not on the package path"]),
        ("import helper", ["package `helper` is not on the package path"]),
        ("try:\n    import helper\nexcept ImportError:\n    helper = None", []),
        ("import numpy, rclpy, stranger", []),  # what the manifest does not name may be any module of Python
    ],
)
def test_modules_of_packages_that_are_not_there(tmp_path: Path, statement: str, said: list[str]) -> None:
    manifest = MANIFEST.format("here").replace("<export>", "<exec_depend>helper</exec_depend><depend>rclpy</depend><export>")
    found = composed(tmp_path, {"main.launch.py": f"{HEAD}{statement}\n{_ends('')}", "package.xml": manifest})
    assert [problem.message for problem in found.problems if problem.fatal] == said


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ("raise RuntimeError('no robot')", "RuntimeError: RuntimeError('no robot')"),
        ("{}['a']", "KeyError: 'a'"),
        ("{}.update(None)", "TypeError: 'NoneType' object is not iterable"),
        ("float('fast')", "ValueError: could not convert string to float: 'fast'"),
        ("made()", "TypeError: missing argument `name`"),
        ("Node(package='here')", "Node: the argument `executable` must be given"),
        ("Node(package='here', **elsewhere)", None),
        ("made(**elsewhere)", None),
        ("os.path.join('a', wrong='b')", None),  # which arguments Python's functions have is not known here
    ],
)
def test_exceptions_of_python_end_launch(tmp_path: Path, body: str, said: str | None) -> None:
    text = f"{HEAD}def made(name):\n    return name\ndef generate_launch_description():\n    {body}\n    return LaunchDescription([])\n"
    refusal = composed(tmp_path, {"main.launch.py": text}).refusal
    assert (refusal.message if refusal else None) == said


@pytest.mark.parametrize(
    ("command", "given", "said"),
    [
        ("['cat ', PathJoinSubstitution([FindPackageShare('here'), 'x.txt'])]", "some text", None),
        ("'echo a \"b  c\"'", "a b  c\n", None),
        ("'cat /nowhere/x.txt'", None, "no such file: /nowhere/x.txt"),
        ("'xacro /nowhere/x.xacro'", None, "command `xacro` would fail: no such file: /nowhere/x.xacro"),
        ("'echo \"'", None, 'command `echo "`: no closing quotation'),
        ("'unknown tool'", "$(command unknown tool)", None),
    ],
)
def test_commands_that_fail_and_that_print(tmp_path: Path, command: str, given: str | None, said: str | None) -> None:
    main = HEAD + _ends(f"node('n', parameters=[{{'text': ParameterValue(Command({command}), value_type=str)}}])")
    found = composed(tmp_path, {"main.launch.py": main, "x.txt": "some text"})
    assert (found.refusal.message if found.refusal else None) == said
    assert said is not None or params(found) == {"/n/text": given}
