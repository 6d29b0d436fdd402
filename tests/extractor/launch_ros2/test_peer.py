"""Python launch files of kinds in which the real `ros2 launch` was seen to come to something else."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest
from ros2_launch_builder import HEAD, MANIFEST, composed, described, names, params, problems, xml

from rosarch.extractor.launch import record


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
        ("import other_helper", ["package `other_helper` is not on the package path"]),  # another manifest names it
        ("from nav2_common.launch import RewrittenYaml", ["package `nav2_common` is not on the package path"]),  # no manifest does
        ("import numpy, rclpy, stranger", []),  # what no manifest names may be any module of Python
    ],
)
def test_modules_of_packages_that_are_not_there(tmp_path: Path, statement: str, said: list[str]) -> None:
    manifest = MANIFEST.format("here").replace("<export>", "<exec_depend>helper</exec_depend><depend>rclpy</depend><export>")
    other = MANIFEST.format("other").replace("<export>", "<exec_depend>other_helper</exec_depend><export>")
    files = {"main.launch.py": f"{HEAD}{statement}\n{_ends('')}", "package.xml": manifest, "other/package.xml": other}
    found = composed(tmp_path, files)
    assert [problem.message for problem in found.problems if problem.fatal] == said


def test_names_of_packages_made_from_variables_that_are_not_set(tmp_path: Path) -> None:
    for asked, said in (
        ("kind = os.getenv('KIND')", ["the package `$(kind)_robot` is named by an environment variable that is not set"]),
        ("kind = None", ["package `None_robot` is not on the package path"]),
        ("kind = os.getenv('KIND', 'small')", ["package `small_robot` is not on the package path"]),
    ):
        found = described(tmp_path, "", f"{asked}\nget_package_share_directory(f'{{kind}}_robot')")
        assert [problem.message for problem in found.problems] == said
    main = f"{HEAD}kind = os.getenv('KIND')\nget_package_share_directory(f'{{kind}}_robot')\n{_ends('')}"
    files = {"main.launch.py": main, "package.xml": MANIFEST.format("here"), "none/package.xml": MANIFEST.format("None_robot")}
    assert composed(tmp_path / "none", files).refusal is None


def test_variables_that_are_set_wherever_launch_runs(tmp_path: Path) -> None:
    arguments = "arguments=[EnvironmentVariable('AMENT_PREFIX_PATH'), EnvironmentVariable('HOME')]"
    found = described(tmp_path, f"node('n', {arguments}), UnsetEnvironmentVariable('HOME'), node('m', {arguments})")
    assert found.nodes[0].args == "'$(env AMENT_PREFIX_PATH)' '$(env HOME)'"
    assert [problem.message for problem in found.problems] == ["environment variable `HOME` is not set"]


def test_yaml_is_loaded_without_a_loader_before_jazzy(tmp_path: Path) -> None:
    before = "loaded = yaml.load('{a: 1}')"
    for distribution, said in (("humble", None), ("kilted", "TypeError: load() missing 1 required positional argument: 'Loader'")):
        found = described(tmp_path, "node('n', parameters=[loaded])", before, environment={"ROS_DISTRO": distribution})
        assert (found.refusal.message if found.refusal else None) == said


def test_a_condition_that_asks_a_function(tmp_path: Path) -> None:
    before = "from launch import Condition\ndef asked(context):\n    return LaunchConfiguration('a').perform(context) == '1'"
    given = (
        "DeclareLaunchArgument('a', default_value='1'), node('n', condition=Condition(predicate=asked)), node('m', condition=Condition())"
    )
    assert names(described(tmp_path, given, before)) == ["/n"]
    assert names(described(tmp_path, given, before, {"a": "2"})) == []


def test_a_parameter_whose_name_begins_with_a_slash(tmp_path: Path) -> None:
    found = described(tmp_path, "node('n', parameters=[{'/far/away': 1, 'near': 2}])")
    assert params(found) == {"/n//far/away": 1, "/n/near": 2}


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ("raise RuntimeError('no robot')", "RuntimeError: RuntimeError('no robot')"),
        ("{}['a']", "KeyError: 'a'"),
        ("get_package_share_directory(LaunchConfiguration('p'))", "TypeError: LaunchConfiguration is no name of a package"),
        ("{}.update(None)", "TypeError: 'NoneType' object is not iterable"),
        ("float('fast')", "ValueError: could not convert string to float: 'fast'"),
        ("made()", "TypeError: missing argument `name`"),
        ("Node(package='here')", "Node: the argument `executable` must be given"),
        ("Node(package='here', **elsewhere)", None),
        ("made(**elsewhere)", None),
        (
            "return LaunchDescription([node('n', condition=LaunchConfiguration('p'))])",
            "AttributeError: LaunchConfiguration is no condition: it has no `evaluate`",
        ),
        (
            "return LaunchDescription([node('n', condition=lambda context: True)])",
            "AttributeError: function is no condition: it has no `evaluate`",
        ),
        ("return LaunchDescription([node('n', condition=elsewhere)])", None),
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


@pytest.mark.parametrize(
    ("text", "in_file", "given"),
    [
        ("1e5", 100000.0, 100000.0), ("y", True, True), ("off", False, "off"), ("+5", 5, "+5"), ("010", 8, "010"), ("089", 89.0, 89.0), ("0x1p3", 8.0, 8.0),
        ("0o10", "0o10", "0o10"), ("1_000", "1_000", "1_000"), ("~", "~", "~"), ("inf", float("inf"), float("inf")), ("-.inf", float("-inf"), "-.inf"),
        (".5", 0.5, ".5"), ("1:30", "1:30", "1:30"), ("2020-01-01", "2020-01-01", "2020-01-01"), ("9223372036854775808", 2.0**63, "9223372036854775808"),
        ("!!float 5", 5, "!!float 5"), ("!!str 5", "5", "!!str 5"), ('!!int "5"', "5", '!!int "5"'), ("tRUE", "tRUE", "tRUE"),
    ],
)  # fmt: skip
def test_values_as_nodes_read_them(tmp_path: Path, text: str, in_file: object, given: object) -> None:
    """As rcl of Kilted gave them to a node: by a file, on the command line, and from a map in the launch file."""
    path = "os.path.join(get_package_share_directory('here'), 'p.yaml')"
    entities = f"""node('f', parameters=[{path}]), node('a', arguments=['--ros-args', '-p', {"k:=" + text!r}]), node('d', parameters=[{{'k': {text!r}}}]),
      LoadComposableNodes(target_container='c', composable_node_descriptions=[ComposableNode(package='here', plugin='P', name='c', parameters=[{{'k': {text!r}}}])])"""
    files = {"launch/main.launch.py": HEAD + _ends(entities), "p.yaml": f"/**:\n  ros__parameters:\n    k: {text}\n"}
    found = params(composed(tmp_path, files))
    expected = {"/f/k": in_file, "/a/k": in_file, "/d/k": given, "/c/k": text}
    assert (found, [*map(type, found.values())]) == (expected, [*map(type, expected.values())])


@pytest.mark.parametrize(
    ("value", "process", "loaded"),
    [("'true'", True, "true"), ("5", 5, 5), ("[1, 2]", "(1, 2)", [1, 2]), ("['a']", "('a',)", ["a"]), ("LaunchConfiguration('n')", 12, 12)],
)
def test_parameters_for_all_nodes(tmp_path: Path, value: str, process: object, loaded: object) -> None:
    component = "ComposableNode(package='here', plugin='P', name='c')"
    entities = (
        f"SetParameter('k', {value}), node('n'), LoadComposableNodes(target_container='box', composable_node_descriptions=[{component}])"
    )
    assert params(described(tmp_path, entities, "", {"n": "12"})) == {"/n/k": process, "/c/k": loaded}


def test_wildcards_in_files_for_classes_in_containers(tmp_path: Path) -> None:
    text = "/**:\n  ros__parameters: {a: 1, 1: x}\n/*:\n  ros__parameters: {b: 2}\n/ns/c:\n  ros__parameters: {d: 3}\n/**/c:\n  ros__parameters: {e: 4}\n"
    path = "os.path.join(get_package_share_directory('here'), 'p.yaml')"
    box = f"ComposableNode(package='here', plugin='P', name='c', namespace='ns', parameters=[{path}])"
    entities = (
        f"LoadComposableNodes(target_container='box', composable_node_descriptions=[{box}]), node('c', namespace='ns', parameters=[{path}])"
    )
    loaded = params(composed(tmp_path / "a", {"launch/main.launch.py": HEAD + _ends(entities.partition(", node(")[0]), "p.yaml": text}))
    assert loaded == {"/ns/c/a": 1, "/ns/c/1": "x", "/ns/c/d": 3}
    process = params(
        composed(tmp_path / "b", {"launch/main.launch.py": HEAD + _ends("node(" + entities.partition(", node(")[2]), "p.yaml": text})
    )
    assert process == {"/ns/c/a": 1, "/ns/c/1": "x", "/ns/c/d": 3, "/ns/c/e": 4}


def test_a_module_that_launch_loads_by_its_path(tmp_path: Path) -> None:
    text = (
        HEAD
        + """from launch.launch_description_sources import load_python_launch_file_as_module
from launch.utilities.type_utils import get_typed_value
def setup(context):
    library = load_python_launch_file_as_module(os.path.join(get_package_share_directory('here'), 'lib', 'names.py'))
    name, data = getattr(library, 'name_of')(3), {}
    data.update(elsewhere)
    more = {'first': data['first'], 'second': data.get('second'), 'third': 'third' in data}
    return [node(name) if get_typed_value(LaunchConfiguration('on').perform(context), bool) else node('other'), node('m', parameters=[more])]
"""
        + _ends("OpaqueFunction(function=setup)")
    )
    found = composed(
        tmp_path, {"launch/main.launch.py": text, "lib/names.py": "def name_of(number):\n    return f'n{number}'\n"}, {"on": "1"}
    )
    assert names(found) == ["/n3", "/m"]
    assert problems(found, tmp_path) == []
    assert params(found) == {"/m/first": "$(data['first'])", "/m/second": "$(data.get('second'))", "/m/third": "$('third' in data)"}


def test_remappings_of_one_name_are_all_given_and_the_first_holds(tmp_path: Path) -> None:
    found = described(tmp_path, "SetRemap('a', 'x'), node('n', remappings=[('a', 'y'), ('b', 'z')])")
    (node,) = found.nodes
    assert [(remap.source, remap.target) for remap in node.given_remaps] == [("a", "x"), ("a", "y"), ("b", "z")]
    assert [(remap.source, remap.target) for remap in node.own_remaps] == [("a", "x"), ("b", "z")]


def test_a_handler_that_has_nothing_to_start(tmp_path: Path) -> None:
    for started in (True, False):
        first = f"first = node('first', condition=IfCondition('{started}'))"
        found = described(tmp_path / str(started), "first, RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[]))", first)
        assert [problem.message for problem in found.problems] == ["OnProcessExit has nothing to start"] * started


def test_a_package_that_colcon_leaves_out_is_not_there(tmp_path: Path) -> None:
    files = {"../old/package.xml": MANIFEST.format("old"), "../old/COLCON_IGNORE": "", "../old/p.yaml": "/**:\n  ros__parameters: {a: 1}\n"}
    main = HEAD + _ends("node('n', parameters=[PathJoinSubstitution([FindPackageShare('old'), 'p.yaml'])])")
    found = composed(tmp_path, {"main.launch.py": main, **files})
    assert [problem.message for problem in found.problems] == ["package `old` is not built: COLCON_IGNORE leaves it out"]
    assert params(found) == {"/n/a": 1}
    (tmp_path / "z_new").mkdir()
    (tmp_path / "z_new" / "package.xml").write_text(MANIFEST.format("old"))
    assert "no such file" in composed(tmp_path, {"main.launch.py": main, **files}).problems[0].message


@pytest.mark.parametrize(
    ("given", "value"),
    [
        ("{'p': 1}, ALL", 2), ("OWN, ALL", 2), ("ALL, OWN", 1), ("BOTH", 2), ("STAR, ALL", 2), ("ALL, STAR", 3), ("OWN, STAR", 3), ("STAR, OWN", 1),
        ("ALL, TEXT", 2), ("{'p': 1}, {'p': 'x'}", 1), ("{'p': 'x'}, {'p': 1}", 1), ("OWN, TEXT", "x"), ("Parameter('p', 7), {'p': 1}", 1),
        ("{'p': 1}, Parameter('p', 7)", 7), ("OWN, ALL, {'p': 9}", 2), ("ALL, Parameter('p', 'x')", 2),
        ("{'d.p': 1}, DEEP", "x"), ("DEEP, {'d.p': 1}", 1), ("DEEP_2, DEEP", "x"), ("DEEP, DEEP_2", 2.5), ("DEEP_2, FLAT", 2.5),
        ("FLAT_1, DEEP", "x"), ("DEEP, FLAT_1, DEEP_2", 2.5), ("FLAT_1, DEEP, FLAT", "x"), ("DEEP, FLAT_1", 1),
    ],
)  # fmt: skip
def test_what_overrides_what(tmp_path: Path, given: str, value: object) -> None:
    """As rcl of Kilted said: keys of files override each other in the order in which they first came; of several types for a key, the first of its list.

    A nested name is one parameter more than those before, the last of which counts; a flat one is added to the first.
    """
    files = {
        "ALL": "/**:\n  ros__parameters: {p: 2}\n",
        "OWN": "/a/n:\n  ros__parameters: {p: 1}\n",
        "BOTH": "/a/n:\n  ros__parameters: {p: 1}\n/**:\n  ros__parameters: {p: 2}\n",
        "STAR": "/*/n:\n  ros__parameters: {p: 3}\n",
        "TEXT": "/**:\n  ros__parameters: {p: x}\n",
        "DEEP": "/**:\n  ros__parameters: {d: {p: x}}\n",
        "DEEP_2": "/**:\n  ros__parameters: {d: {p: 2.5}}\n",
        "FLAT": "/**:\n  ros__parameters: {d.p: x}\n",
        "FLAT_1": "/**:\n  ros__parameters: {d.p: 1}\n",
    }
    head = (
        HEAD
        + "from launch_ros.descriptions import Parameter\n"
        + "".join(f"{name} = os.path.join(os.path.dirname(__file__), {name!r})\n" for name in files)
    )
    found = composed(tmp_path, {"main.launch.py": head + _ends(f"node('n', namespace='a', parameters=[{given}])"), **files})
    assert [*params(found).values()] == [value]


def test_a_group_adds_to_the_parameters_and_remappings_of_before(tmp_path: Path) -> None:
    """launch copies the map of configurations for a group, not the lists in it."""
    group = "GroupAction([SetParameter('q', 2), SetRemap('c', 'd')])"
    assert params(described(tmp_path / "a", f"{group}, node('n')")) == {}
    found = described(
        tmp_path / "b", f"SetParameter('p', 1), SetRemap('a', 'b'), {group}, node('n'), GroupAction([node('m')], forwarding=False)"
    )
    assert params(found) == {"/n/p": 1, "/n/q": 2}
    assert [(remap.source, remap.target) for remap in found.nodes[0].remaps] == [("a", "b"), ("c", "d")]
    assert found.nodes[1].remaps == ()


@pytest.mark.parametrize("entity", ["- node: {pkg: here, exec: run, name: 1}", "- node: {pkg: here, exec: run, if: true}", "- arg: {name: a, default: 2.5}",
                                    "- timer: {period: 1, children: []}", "- set_use_sim_time: {value: 'true'}"])  # fmt: skip
def test_yaml_has_texts_where_launch_asks_for_texts(tmp_path: Path, entity: str) -> None:
    assert composed(tmp_path, {"main.launch.yaml": f"launch:\n{entity}\n"}).refusal is not None


def test_texts_of_yaml_stay_texts(tmp_path: Path) -> None:
    param = "[{name: a, value: '1'}, {name: b, value: $(var x)}, {name: c, value: 1}]"
    text = f"launch:\n- node: {{pkg: here, exec: run, name: n, param: {param}}}\n- set_parameter: {{name: d, value: '2'}}\n- node: {{pkg: here, exec: run, name: m}}\n"
    found = composed(tmp_path, {"main.launch.yaml": text}, {"x": "1"})
    assert params(found) == {"/n/a": "1", "/n/b": 1, "/n/c": 1, "/m/d": 2}


def test_arguments_of_a_node_stand_first(tmp_path: Path) -> None:
    words = "['--ros-args', '-r', 'a:=first', '-r', '__node:=m', '-p', 'p:=1']"
    found = described(tmp_path, f"SetRemap('a', 'second'), SetParameter('p', 2), node('n', arguments={words}, remappings=[('a', 'third')])")
    (node,) = found.nodes
    assert (node.name, [remap.target for remap in node.given_remaps]) == ("m", ["first", "second", "third"])
    assert params(found) == {"/m/p": 2}


def test_the_namespace_of_launch_is_a_configuration(tmp_path: Path) -> None:
    given = "node('n', arguments=[LaunchConfiguration('ros_namespace', default='none')])"
    found = described(tmp_path, f"{given}, PushRosNamespace('a'), {given}")
    assert [node.args for node in found.nodes] == ["none", "/a"]


def test_use_sim_time_of_launch_is_given_to_no_node(tmp_path: Path) -> None:
    assert params(described(tmp_path / "a", "SetUseSimTime(True), node('n')")) == {}
    assert described(tmp_path / "b", "SetUseSimTime(False)").refusal is not None


def test_nodes_of_one_name_have_their_own_parameters(tmp_path: Path) -> None:
    nodes = "node('n', parameters=[{'p': 1}]), node('n', parameters=[{'q': 2}]), *[Node(package='here', executable='run', parameters=[{'p': i}]) for i in (3, 4)]"
    written = record(described(tmp_path, nodes))
    assert [origin["node"] for origin in written["started_by"]] == ["/n", "/n#2", "/run", "/run#2"]
    assert written["params"] == {"/n/p": 1, "/n#2/q": 2, "/run/p": 3, "/run#2/p": 4}


def test_a_class_without_a_name_has_what_is_for_all(tmp_path: Path) -> None:
    path = "os.path.join(get_package_share_directory('here'), 'p.yaml')"
    box = f"LoadComposableNodes(target_container='box', composable_node_descriptions=[ComposableNode(package='here', plugin='Own', parameters=[{path}])])"
    files = {"launch/main.launch.py": HEAD + _ends(box), "p.yaml": "/**:\n  ros__parameters: {a: 1}\nOwn:\n  ros__parameters: {b: 2}\n"}
    assert params(composed(tmp_path, files)) == {"/Own/a": 1}


def test_words_of_a_command_line_in_xml(tmp_path: Path) -> None:
    """Quotes are read between substitutions; what a substitution comes to is within one word."""
    args = "-a 'u v' $(var p)w $(var q)$(var p) x$(var e) last"
    found = xml(tmp_path / "a", f'<node pkg="here" exec="run" name="n" args="{args}"/>', {"p": "1 2", "q": "3", "e": ""})
    assert shlex.split(found.nodes[0].args) == ["-a", "u v", "1 2w", "31 2", "x", "last"]
    refusal = xml(tmp_path / "b", """<node pkg="here" exec="run" name="n" args="'$(var p) b'"/>""", {"p": "1"}).refusal
    assert refusal is not None
    assert refusal.message == "`'`: no closing quotation"


def test_expressions_with_the_module_math(tmp_path: Path) -> None:
    found = described(
        tmp_path, "node('n', arguments=[PythonExpression(['math.floor(2.7) + floor(1.5)'], ['math']), PythonExpression('math.pi > 3')])"
    )
    assert found.nodes[0].args == "3 True"


def test_filter_keeps_items(tmp_path: Path) -> None:
    names_given = "filter(lambda name: name != 'b', ['a', 'b', 'c'])"
    assert names(described(tmp_path, f"*[node(name) for name in {names_given}], *map(node, filter(None, ['', 'd']))")) == ["/a", "/c", "/d"]


def test_xacro_as_a_module(tmp_path: Path) -> None:
    before = """import xacro
path = os.path.join(get_package_share_directory('here'), 'r.xacro')
document = xacro.parse(open(path))
xacro.process_doc(document, mappings={'w': '3'})
made = [xacro.process_file(path).toxml(), xacro.process_file(path, mappings={'w': '2'}).toprettyxml(indent='  '), document.toxml()]"""
    robot = '<robot xmlns:xacro="http://ros.org/wiki/xacro" name="r"><xacro:arg name="w" default="1"/><link name="l$(arg w)"/></robot>'
    body = "\n".join(f"    {line}" for line in before.splitlines())
    given = "node('n', parameters=[{str(at): one for at, one in enumerate(made)}])"
    text = f"{HEAD}def generate_launch_description():\n{body}\n    return LaunchDescription([{given}])\n"
    found = composed(tmp_path, {"launch/main.launch.py": text, "r.xacro": robot})
    assert ['<link name="l' in str(value) and str(value).partition('<link name="l')[2][0] for value in params(found).values()] == [
        "1",
        "2",
        "3",
    ]
    assert problems(found, tmp_path) == []


NODE = '<node pkg="here" exec="run" name="n"'


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (f"{NODE}><bogus/></node>", "<node> cannot hold <bogus>"),
        (f'{NODE} if="1" unless="0"/>', "<node> has both `if` and `unless`"),
        ('<node pkg="here" exec="run" name="bad name"/>', "`bad name` is no name of a node"),
        ('<node pkg="here" exec="run" name="n" namespace="1st"/>', "`/1st` is no namespace"),
        ('<push_ros_namespace namespace="bad ns"/>', "`/bad ns` is no namespace"),
        ('<node_container pkg="here" exec="run" name="c"/>', "<node_container> has no attribute `namespace`"),
        ('<let name="a" value="$(eval 1 + 1)"/>', "the expression of $(eval) must be quoted when it has spaces"),
        (f'{NODE}><param name="p" value="a: b"/></node>', "`a: b` is neither a scalar nor a list of one type"),
        (f'{NODE}><param name="p" value="null"/></node>', "`null` is neither a scalar nor a list of one type"),
        (f'{NODE}><param name="p" value="[1, a]"/></node>', "`[1, a]` is neither a scalar nor a list of one type"),
    ],
)
def test_what_launch_rejects_of_xml(tmp_path: Path, content: str, said: str) -> None:
    refusal = xml(tmp_path, content).refusal
    assert refusal is not None
    assert refusal.message == said


def test_environment_variables_are_appended_as_said(tmp_path: Path) -> None:
    content = f"""<set_env name="A" value="b"/><append_env name="A" value="c"/><append_env name="A" value="d" prepend="true" separator=";"/>
{NODE} args="$(env A)"/>"""
    assert shlex.split(xml(tmp_path, content).nodes[0].args) == ["d;b:c"]


def test_substitutions_in_a_list_of_yaml(tmp_path: Path) -> None:
    text = "launch:\n- node: {pkg: here, exec: run, name: n, param: [{name: p, value: [$(var x), w]}]}\n"
    assert params(composed(tmp_path, {"main.launch.yaml": text}, {"x": "z"})) == {"/n/p": ["z", "w"]}


def test_parameters_for_all_nodes_are_what_they_were_when_they_were_set(tmp_path: Path) -> None:
    actions = (
        "SetLaunchConfiguration('a', 'one'), SetParameter('p', LaunchConfiguration('a')), SetLaunchConfiguration('a', 'two'), node('n')"
    )
    assert params(described(tmp_path / "b", actions)) == {"/n/p": "one"}
    unset = described(tmp_path / "c", "SetParameter('p', LaunchConfiguration('gone'))")
    assert unset.refusal is not None
    assert unset.refusal.message == "launch configuration `gone` is not set"


def test_a_node_in_the_root_namespace_that_was_pushed_is_named_in_full(tmp_path: Path) -> None:
    """What is given as a map is for it alone then; what is for all nodes came first."""
    file = "os.path.join(os.path.dirname(__file__), 'p.yaml')"
    for pushed, rate in (("PushRosNamespace(''), ", 1), ("", 2)):
        text = _ends(f"SetParameter('q', 0), {pushed}Node(package='here', executable='run', name='n', parameters=[{{'rate': 1}}, {file}])")
        found = composed(tmp_path / str(rate), {"main.launch.py": HEAD + text, "p.yaml": "/**:\n  ros__parameters: {rate: 2}\n"})
        assert params(found) == {"/n/q": 0, "/n/rate": rate}


def test_a_list_that_arrives_as_several_types(tmp_path: Path) -> None:
    """PyYAML writes `y` as it is, which is a Boolean for rcl, and so the node does not start."""
    found = described(tmp_path, "node('n', parameters=[{'axes': ['x', 'y', 'z'], 'flags': ['y', 'n'], 'words': ['true', 'x']}])")
    assert problems(found, tmp_path) == [
        "launch/main.launch.py:16:12: the parameter `axes`: its elements arrive as several types, ['x', True, 'z']"
    ]
    assert found.refusal is None


def test_lists_of_several_types(tmp_path: Path) -> None:
    """As launch_ros said: numbers become doubles, and it stops at others."""
    taken = described(tmp_path / "b", "node('n', parameters=[{'p': [1, 2.5]}])")
    assert params(taken) == {"/n/p": [1.0, 2.5]}
    assert taken.problems == ()
    for values in ("[1, 2.5, True]", "[True, 1]", "['a', 1]", "[True, 'x']"):
        found = described(tmp_path / values, f"node('n', parameters=[{{'p': {values}}}])")
        assert found.refusal is not None
        assert found.refusal.message == "the elements of the parameter `p` are of several types"
