"""Actions: scopes, conditions, includes, containers, parameters of all nodes."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from ros2_launch_builder import HEAD, composed, described, names, params, problems

from rosarch.extractor.launch.model import ArgumentLeaked


def test_groups_keep_what_they_change(tmp_path: Path) -> None:
    entities = """DeclareLaunchArgument('a', default_value='1'),
      GroupAction([PushRosNamespace('g'), SetLaunchConfiguration('a', '2'), SetRemap('x', 'y'), SetParameter('p', 1), node('in')]),
      GroupAction([SetLaunchConfiguration('a', '3')], scoped=False),
      GroupAction([node('alone', parameters=[{'b': LaunchConfiguration('b')}])], forwarding=False, launch_configurations={'b': 'kept'}),
      node('out', parameters=[{'a': LaunchConfiguration('a')}])"""
    found = described(tmp_path, entities)
    assert names(found) == ["/g/in", "/alone", "/out"]
    assert [(remap.source, remap.target) for remap in found.nodes[0].remaps] == [("x", "y")]
    assert found.nodes[2].remaps == ()
    assert params(found) == {"/g/in/p": 1, "/alone/b": "kept", "/out/a": 3}


@pytest.mark.parametrize(
    ("entities", "expected"),
    [
        ("DeclareLaunchArgument('a', default_value='1'), GroupAction([DeclareLaunchArgument('b', default_value='2')], scoped=False)", "12"),
        # what an included file declares is not known here: nothing is told to be missing
        (
            "DeclareLaunchArgument('a', default_value='1'), IncludeLaunchDescription('/none.launch.py'), SetLaunchConfiguration('b', '2')",
            "12",
        ),
    ],
)
def test_arguments_of_a_description(tmp_path: Path, entities: str, expected: str) -> None:
    lines = f"""ld = LaunchDescription([{entities}])
    ld.add_action(GroupAction([node('n', parameters=[{{'p': [LaunchConfiguration('a'), LaunchConfiguration('b')]}}])], forwarding=False,
      launch_configurations={{one.name: LaunchConfiguration(one.name) for one in ld.get_launch_arguments()}}))
    return ld"""
    found = composed(tmp_path, {"l.launch.py": f"{HEAD}def generate_launch_description():\n    {lines}\n"})
    assert params(found) == {"/n/p": int(expected)}
    assert [problem.kind for problem in found.problems if problem.kind == "configuration"] == []


def test_namespaces(tmp_path: Path) -> None:
    entities = "PushRosNamespace('a'), PushRosNamespace('b'), node('n'), node('m', namespace='c'), node('o', namespace='/abs')"
    assert names(described(tmp_path, entities)) == ["/a/b/n", "/a/b/c/m", "/abs/o"]


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("IfCondition(LaunchConfiguration('yes'))", ["/n"]),
        ("UnlessCondition('1')", []),
        ("IfCondition(PythonExpression([\"'\", LaunchConfiguration('yes'), \"' == 'true' and not \", 'False']))", ["/n"]),
        ("IfCondition(AndSubstitution(LaunchConfiguration('yes'), NotSubstitution('true')))", []),
        ("IfCondition(EqualsSubstitution(LaunchConfiguration('yes'), 'true'))", ["/n"]),
        ("IfCondition(IfElseSubstitution(LaunchConfiguration('yes'), 'false', 'true'))", []),
        ("LaunchConfigurationEquals('yes', 'true')", ["/n"]),
        ("LaunchConfigurationNotEquals('yes', 'true')", []),
        ("IfCondition(EnvironmentVariable('FLAG', default_value='false'))", []),
        ("UnlessCondition(EnvironmentVariable('FLAG'))", ["/n unless $(env FLAG)"]),
        ("IfCondition(OrSubstitution(EnvironmentVariable('FLAG'), 'true'))", ["/n"]),
        ("IfCondition(PythonExpression([\"'\", EnvironmentVariable('FLAG'), \"' == 'x'\"]))", ["/n if $(eval '$(env FLAG)' == 'x')"]),
    ],
)
def test_conditions(tmp_path: Path, condition: str, expected: list[str]) -> None:
    found = described(tmp_path, f"DeclareLaunchArgument('yes', default_value='true'), node('n', condition={condition})")
    assert names(found) == expected


def test_an_include_changes_its_includer(tmp_path: Path) -> None:
    inner = (
        HEAD
        + """def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('x', default_value='0'), DeclareLaunchArgument('mine', default_value='set'),
      node('in', parameters=[{'x': LaunchConfiguration('x'), 'outer': LaunchConfiguration('outer')}])])
"""
    )
    main = (
        HEAD
        + """def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('outer', default_value='o'),
      IncludeLaunchDescription(PythonLaunchDescriptionSource([ThisLaunchFileDir(), '/inner.launch.py']),
                               launch_arguments={'x': '5', 'wrong': '1'}.items()),
      node('after', parameters=[{'mine': LaunchConfiguration('mine')}])])
"""
    )
    found = composed(tmp_path, {"main.launch.py": main, "inner.launch.py": inner})
    assert params(found) == {"/in/x": 5, "/in/outer": "o", "/after/mine": "set"}
    assert [str(line).rpartition("/")[2] for line in found.nodes[0].lines] == ["main.launch.py:20", "inner.launch.py:16"]
    assert problems(found, tmp_path) == [
        "main.launch.py:20:7: inner.launch.py neither declares nor uses the argument `wrong` that is passed to it"
    ]


def test_arguments_that_are_wrong(tmp_path: Path) -> None:
    entities = "DeclareLaunchArgument('must'), DeclareLaunchArgument('c', default_value='d', choices=['a', 'b']), node(LaunchConfiguration('never'))"
    found = described(tmp_path, entities)
    assert [problem.partition(": ")[2] for problem in problems(found, tmp_path)] == [
        "argument `must` must be passed, it has no default",
        "argument `c` is `d`, but must be one of a, b",
        "launch configuration `never` is not set",
    ]
    assert names(found) == ["/$(var never)"]


@pytest.mark.parametrize(
    "before",
    [
        "*unseen.ACTIONS",
        "unseen.action()",
        "IncludeLaunchDescription(PythonLaunchDescriptionSource(unseen.path()))",
        "OpaqueFunction(function=unseen.setup)",
    ],
)
def test_what_is_not_seen_may_set_arguments(tmp_path: Path, before: str) -> None:
    entities = (
        "node('n', name=LaunchConfiguration('a')), DeclareLaunchArgument('b'), node('m', condition=LaunchConfigurationEquals('c', 'x'))"
    )
    first = described(tmp_path / "first", f"{entities}, {before}", "import unseen")
    assert [problem.partition(": ")[2] for problem in problems(first, tmp_path)][:2] == [
        "launch configuration `a` is not set",
        "argument `b` must be passed, it has no default",
    ]
    assert names(first) == ["/$(var a)"]
    found = described(tmp_path / "after", f"{before}, {entities}", "import unseen")
    assert not [problem for problem in problems(found, tmp_path) if "is not set" in problem or "must be passed" in problem]
    assert names(found) == ["/$(var a)", "/m if $(var c)"]


@pytest.mark.parametrize(
    ("entities", "expected"),
    [
        # the default of one file, and what one is passed, are left to the next
        ("include('one'), include('two')", ["rate=5 at one.launch.py"]),
        ("include('two', rate='7'), include('two')", ["rate=7 at main.launch.py"]),
        # passed itself, set on purpose, kept within a group, given by an outer file
        ("include('one'), include('two', rate='9')", []),
        ("include('one'), SetLaunchConfiguration('rate', '5'), include('two')", []),
        ("GroupAction([include('one')]), include('two')", []),
        ("GroupAction([include('one'), include('two')], launch_configurations={'rate': '5'})", []),
        ("DeclareLaunchArgument('rate', default_value='3'), include('one'), include('two')", []),
        # perhaps not started, or started later
        ("include('one', condition=IfCondition(EnvironmentVariable('ONE'))), include('two')", []),
        ("TimerAction(period=1.0, actions=[include('one')]), include('two')", []),
        # the same default
        ("include('one'), include('one')", []),
    ],
)
def test_arguments_that_leak(tmp_path: Path, entities: str, expected: list[str]) -> None:
    source = r"IncludeLaunchDescription(PythonLaunchDescriptionSource([ThisLaunchFileDir(), '/\1.launch.py'])"
    entities = re.sub(r"include\('(\w+)'", source, re.sub(r"rate='(\d)'", r"launch_arguments={'rate': '\1'}.items()", entities))
    main = f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{entities}])\n"
    part = f"{HEAD}def generate_launch_description():\n    return LaunchDescription([DeclareLaunchArgument('rate', default_value='%s')])\n"
    files = {"main.launch.py": main, "one.launch.py": part % 5, "two.launch.py": part % 50}
    found = composed(tmp_path, files).references
    assert [f"{one.name}={one.value} at {Path(one.origin.path).name}" for one in found if isinstance(one, ArgumentLeaked)] == expected


def test_includes_that_are_not_there(tmp_path: Path) -> None:
    include = "IncludeLaunchDescription(PythonLaunchDescriptionSource({}))"
    entities = ", ".join(include.format(path) for path in ("[FindPackageShare('gone'), '/launch/x.launch.py']", "'/no/such.launch.py'"))
    found = described(tmp_path, entities)
    assert [include.file for include in found.includes] == [None, None]
    assert found.includes[0].text == "$(find-pkg-share gone)/launch/x.launch.py"
    assert [problem.kind for problem in found.problems] == ["package", "file"]


def test_a_file_that_includes_itself(tmp_path: Path) -> None:
    found = described(tmp_path, "node('n'), IncludeLaunchDescription(PythonLaunchDescriptionSource(__file__))")
    assert len(found.nodes) == 61
    assert [problem.kind for problem in found.problems if problem.kind != "duplicate-node"] == ["cycle"]


def test_gazebo_classic_is_a_node_with_a_world(tmp_path: Path) -> None:
    world = "<sdf><world name='w'><plugin name='states' filename='libgazebo_ros_state.so'/></world></sdf>"
    options = "-s libgazebo_ros_init.so -slibgazebo_ros_factory.so"
    start = f"ExecuteProcess(cmd=['gzserver', os.path.dirname(__file__) + '/w.world', '{options}'], shell=True)"
    folder = tmp_path / "here" / "launch"
    folder.mkdir(parents=True)
    (folder / "w.world").write_text(world)
    found = described(tmp_path, start)
    (node,) = found.nodes
    assert (node.package, node.type, node.full_name, node.ros) == ("gazebo_ros", "gzserver", "/gazebo", 2)
    assert node.args.split()[1:] == ["-s", "libgazebo_ros_init.so", "-slibgazebo_ros_factory.so"]
    assert [plugin.filename for world in found.worlds for plugin in world.plugins] == ["libgazebo_ros_state.so"]


def test_containers(tmp_path: Path) -> None:
    entities = """ComposableNodeContainer(name='box', namespace='b', package='rclcpp_components', executable='component_container',
        composable_node_descriptions=[ComposableNode(package='here', plugin='here::One', name='one', parameters=[{'a': 1}],
                                                     remappings=[('x', 'y')])]),
      PushRosNamespace('ns'),
      LoadComposableNodes(target_container='box', composable_node_descriptions=[
        ComposableNode(package='here', plugin='here::Two', condition=IfCondition('false')), ComposableNode(package='here', plugin='here::Three')]),
      LoadComposableNodes(target_container='/b/box', composable_node_descriptions=[ComposableNode(package='here', plugin='here::Four')])"""
    found = described(tmp_path, entities)
    assert [(node.full_name, node.type, node.name, node.container) for node in found.nodes] == [
        ("/b/box", "component_container", "box", None),
        ("/one", "here::One", "one", "/b/box"),
        ("/ns/Three", "here::Three", None, "/box"),
        ("/ns/Four", "here::Four", None, "/b/box"),
    ]
    assert params(found) == {"/one/a": 1}


def test_files_of_classes_in_containers(tmp_path: Path) -> None:
    main = (
        HEAD
        + """def generate_launch_description():
    path = PathJoinSubstitution([FindPackageShare('here'), 'p.yaml'])
    return LaunchDescription([
        ComposableNodeContainer(name='box', namespace='', package='rclcpp_components', executable='component_container', composable_node_descriptions=[
            ComposableNode(package='here', plugin='here::One', name='one', parameters=[path])]),
        %s])
"""
    )
    files = {"p.yaml": "size: 2\npid: {gains: &g [1, 2], more: *g}\n"}
    alone = composed(tmp_path / "alone", {"main.launch.py": main % "", **files})
    assert params(alone) == {"/one/size": 2, "/one/pid.gains": [1, 2], "/one/pid.more": [1, 2]}
    assert alone.problems == ()
    node = "Node(package='here', executable='two', name='two', parameters=[path])"
    beside = composed(tmp_path / "beside", {"main.launch.py": main % node, **files})
    assert [problem.kind for problem in beside.problems] == ["params-file"]


def test_events_and_timers_start_what_they_hold(tmp_path: Path) -> None:
    before = "first = node('first')"
    entities = """first, TimerAction(period=3.0, actions=[node('timed')]),
      RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[node('next')])),
      RegisterEventHandler(OnProcessExit(target_action=first, on_exit=lambda event, context: [node('called')])),
      RegisterEventHandler(OnShutdown(on_shutdown=[node('never')])),
      ExecuteProcess(cmd=['ros2', 'run', 'here', 'tool', '--ros-args', '-r', '__node:=ran']), ExecuteProcess(cmd=['gz', 'sim'])"""
    assert names(described(tmp_path, entities, before)) == ["/first", "/ran", "/timed", "/called", "/next"]


def test_what_an_event_starts_sees_what_is_set_by_then(tmp_path: Path) -> None:
    before = """first = node('first')
def args(name): return Node(package='here', executable='run', name=name, arguments=[LaunchConfiguration('a')])"""
    entities = """DeclareLaunchArgument('a', default_value='1'), GroupAction([PushRosNamespace('inner'), SetLaunchConfiguration('a', '2'), first,
          RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[args('next')])), TimerAction(period=1.0, actions=[args('timed')])]),
          SetLaunchConfiguration('a', '3'), SetRemap('x', 'y')"""
    found = described(tmp_path, entities, before)
    assert [(node.full_name, node.args, len(node.remaps)) for node in found.nodes] == [
        ("/inner/first", "", 0), ("/timed", "3", 1), ("/next", "3", 1)
    ]  # fmt: skip


def test_what_waits_for_a_process_follows_it_alone(tmp_path: Path) -> None:
    before = """from launch.event_handlers import OnExecutionComplete, OnProcessStart
first, never = node('first'), node('never', condition=IfCondition('false'))
unsure = node('unsure', condition=IfCondition(EnvironmentVariable('U')))
opaque, early = OpaqueFunction(function=lambda context: None), OpaqueFunction(function=lambda context: None)"""
    entities = """RegisterEventHandler(OnExecutionComplete(target_action=opaque, on_completion=[node('done')])), first, never, unsure, opaque, early,
          RegisterEventHandler(OnProcessStart(target_action=first, on_start=[node('started')])),
          RegisterEventHandler(OnProcessStart(target_action=never, on_start=[node('no')])),
          RegisterEventHandler(OnProcessExit(target_action=unsure, on_exit=[node('perhaps')])),
          RegisterEventHandler(OnExecutionComplete(target_action=early, on_completion=[node('late')])),
          RegisterEventHandler(OnProcessExit(target_action=lambda action: action is first, on_exit=[node('matched')])),
          RegisterEventHandler(OnProcessExit(on_exit=[node('any')]), condition=IfCondition('false'))"""
    assert names(described(tmp_path, entities, before)) == [
        "/first", "/unsure if $(env U)", "/started", "/done", "/matched", "/perhaps if $(env U)"
    ]  # fmt: skip


def test_loops_of_launch(tmp_path: Path) -> None:
    before = "def each(name='', pose={}):\n    return [node(name, parameters=[pose])]"
    entities = "ForEach('{name: a, pose: {x: 1.5}};{name: b}', function=each), ForLoop('2', function=lambda i: [node(f'n{i}')])"
    found = described(tmp_path, entities, before)
    assert names(found) == ["/a", "/b", "/n0", "/n1"]
    assert params(found) == {"/a/x": 1.5}


def test_parameters_for_all_nodes(tmp_path: Path) -> None:
    main = (
        HEAD
        + """def generate_launch_description():
    path = PathJoinSubstitution([FindPackageShare('here'), 'p.yaml'])
    return LaunchDescription([SetUseSimTime(True), SetParametersFromFile(path), SetParameter('s', value='text'),
      node('n', namespace='a', parameters=[{'own': ParameterValue(TextSubstitution(text='1'), value_type=str), 'all': 3}])])
"""
    )
    yaml = "/**:\n  ros__parameters: {all: 1, any: 2}\na/n:\n  ros__parameters: {exact: 3}\na:\n  m: {ros__parameters: {no: 4}}\n/*/n:\n  ros__parameters: {star: 5}\n/*:\n  ros__parameters: {no: 6}\n"
    found = composed(tmp_path, {"main.launch.py": main, "p.yaml": yaml})
    own = {"all": 3, "any": 2, "exact": 3, "star": 5, "s": "text", "own": "1"}
    assert params(found) == {f"/a/n/{name}": value for name, value in own.items()}
    written = {setting.name: setting.written for setting in found.params}
    assert (written["/a/n/exact"], written["/a/n/s"]) != (None, None)
    assert str(written["/a/n/exact"]).endswith("here/p.yaml:4")


def test_a_file_for_one_node_tells_its_name(tmp_path: Path) -> None:
    main = (
        HEAD
        + """def generate_launch_description():
    path = os.path.join(get_package_share_directory('here'), 'config', 'p.yaml')
    return LaunchDescription([Node(package='here', executable='run', parameters=[path]), node('other', parameters=['/no/such.yaml'])])
"""
    )
    found = composed(tmp_path, {"main.launch.py": main, "other/config/p.yaml": "driver:\n  ros__parameters: {port: x}\n"})
    assert [(node.name, node.called) for node in found.nodes] == [(None, "driver"), ("other", "other")]
    assert params(found) == {"/driver/port": "x"}
    assert [(setting.name, setting.source) for setting in found.unread] == [("/other", "/no/such.yaml")]


def test_two_nodes_of_one_name(tmp_path: Path) -> None:
    found = described(tmp_path, "node('n'), node('n'), Node(package='here', executable='run'), Node(package='here', executable='run')")
    assert [problem.kind for problem in found.problems] == ["duplicate-node"]
    assert found.refusal is None


K = "LaunchConfiguration('k')"


@pytest.mark.parametrize(
    ("one", "other", "duplicate"),
    [
        ("LaunchConfigurationEquals('k', 'x')", "LaunchConfigurationEquals('k', 'y')", False),
        ("LaunchConfigurationEquals('k', 'x')", "LaunchConfigurationNotEquals('k', 'y')", True),
        (f"IfCondition({K})", f"UnlessCondition({K})", False),
        (f"IfCondition({K})", "UnlessCondition(LaunchConfiguration('other'))", True),
        (f"IfCondition(PythonExpression([\"'\", {K}, \"' == 'x'\"]))", f"IfCondition(EqualsSubstitution({K}, 'y'))", False),
        (f"IfCondition(PythonExpression([{K}, ' and ', LaunchConfiguration('other')]))", f"UnlessCondition({K})", False),
        (f"IfCondition(AndSubstitution({K}, 'true'))", f"IfCondition(NotSubstitution({K}))", False),
        (f"IfCondition(OrSubstitution({K}, LaunchConfiguration('other')))", f"UnlessCondition({K})", True),
    ],
)
def test_alternatives(tmp_path: Path, one: str, other: str, duplicate: bool) -> None:
    declared = "DeclareLaunchArgument('k'), DeclareLaunchArgument('other')"
    found = described(tmp_path, f"{declared}, node('n', condition={one}), node('n', condition={other})")
    assert ("duplicate-node" in [problem.kind for problem in found.problems]) is duplicate


@pytest.mark.parametrize(
    ("one", "other", "duplicate"),
    [
        ("k == 'x'", "k == 'y'", False),
        ("k == 'x'", "k in ('x', 'y')", True),
        ("k != 'x' and k != 'y'", "k in ['x', 'y']", False),
        ("k.startswith('x')", "k.startswith('y')", False),
        ("flag(k)", "not flag(k)", False),
    ],
)
def test_alternatives_of_python(tmp_path: Path, one: str, other: str, duplicate: bool) -> None:
    text = f"""{HEAD}
def flag(value):
    return True if value == 'x' else False

def start(context):
    k = LaunchConfiguration('k').perform(context)
    found = []
    if {one}:
        found.append(node('n'))
    if {other}:
        found.append(node('n'))
    return found

def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('k'), OpaqueFunction(function=start)])
"""
    found = composed(tmp_path, {"main.launch.py": text})
    assert ("duplicate-node" in [problem.kind for problem in found.problems]) is duplicate


def test_keywords_that_no_version_has(tmp_path: Path) -> None:
    found = described(tmp_path, "DeclareLaunchArgument('a', defaultValue='1', default_value='2'), node('n', param=[])")
    assert [one.split(": ", 1)[1] for one in problems(found, tmp_path)] == [
        "DeclareLaunchArgument has no argument `defaultValue`", "Node has no argument `param`",
    ]  # fmt: skip


@pytest.mark.parametrize(("distribution", "expected"), [("foxy", []), ("humble", ["executable"]), (None, ["executable"])])
def test_keywords_of_old_versions(tmp_path: Path, distribution: str | None, expected: list[str]) -> None:
    environment = {"ROS_DISTRO": distribution} if distribution else {}
    found = described(tmp_path, "Node(package='here', node_executable='run')", environment=environment)
    assert [meant for problem in found.problems if (meant := (problem.meant or ("", ""))[1])] == expected
    assert all("since Galactic it is `executable`" in problem.message for problem in found.problems)
    assert [node.type for node in found.nodes] == ["run"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("parameters={'rate': 1.0}", "Node: parameters must be a list"),
        ("parameters='a.yaml'", "Node: parameters must be a list"),
        ("parameters=LaunchConfiguration('parameters')", "Node: parameters must be a list"),
        ("parameters=[{'rate': 1.0}], remappings=[('a', 'b')]", None),
        ("remappings=('a', 'b')", "Node: each of the remappings must be a tuple of two names"),
        ("remappings=[['a', 'b']]", "Node: each of the remappings must be a tuple of two names"),
        ("remappings=[('a', 'b', 'c')]", "Node: each of the remappings must be a tuple of two names"),
        ("remappings={'a': 'b'}", "Node: each of the remappings must be a tuple of two names"),
        ("remappings={('a', 'b')}", None),
    ],
)
def test_arguments_of_types_that_are_refused(tmp_path: Path, arguments: str, message: str | None) -> None:
    found = described(tmp_path, f"DeclareLaunchArgument('parameters', default_value='x'), node('n', {arguments})")
    assert [problem.message for problem in found.problems if problem.kind == "type"] == ([] if message is None else [message])


def test_arguments_of_an_include_that_are_no_pairs(tmp_path: Path) -> None:
    found = described(tmp_path, "IncludeLaunchDescription('x.launch.py', launch_arguments={'rate': '1'})")
    assert [problem.message for problem in found.problems if problem.kind == "type"] == [
        "IncludeLaunchDescription: launch_arguments must be pairs of names and values, such as the `.items()` of a dictionary"
    ]


@pytest.mark.parametrize(
    ("actions", "kinds"),
    [
        ("node('a'), PushRosNamespace('x')", ["PushRosNamespace"]),
        ("node('a'), SetParameter('p', 1), SetRemap('a', 'b')", ["SetParameter", "SetRemap"]),
        ("PushRosNamespace('x'), node('a')", []),
        ("node('a'), PushRosNamespace('x'), node('b')", []),
        ("PushRosNamespace('x')", []),
        ("node('a'), *others", []),
    ],
)
def test_what_holds_for_nothing_in_its_group(tmp_path: Path, actions: str, kinds: list[str]) -> None:
    found = described(tmp_path, f"GroupAction([{actions}])", "others = unknown()")
    assert [problem.subject for problem in found.problems if problem.kind == "idle"] == kinds
    flat = described(tmp_path / "flat", f"GroupAction([{actions}], scoped=False)", "others = unknown()")
    assert not [problem for problem in flat.problems if problem.kind == "idle"]


@pytest.mark.parametrize(("value", "kind"), [("1", "int"), ("True", "bool"), ("'1'", ""), ("['a', '1']", "")])
def test_an_argument_of_an_include_that_is_no_text(tmp_path: Path, value: str, kind: str) -> None:
    (tmp_path / "x.launch.py").write_text(
        "from launch import LaunchDescription\ndef generate_launch_description(): return LaunchDescription([])\n"
    )
    found = described(tmp_path, f"IncludeLaunchDescription('{tmp_path}/x.launch.py', launch_arguments={{'rate': {value}}}.items())")
    message = f"TypeError: '{kind}' object is not iterable: the launch argument `rate` must be a text or substitutions"
    assert [problem.message for problem in found.problems if problem.kind != "unused"] == ([message] if kind else [])


@pytest.mark.parametrize("target", ["'n'", "[node('n')]", "node('n')", "lambda action: True"])
def test_events_of_processes_are_of_actions(tmp_path: Path, target: str) -> None:
    handler = f"RegisterEventHandler(OnProcessExit(target_action={target}, on_exit=[node('then')]))"
    found = described(tmp_path, handler)
    message = "OnProcessExit: target_action must be an action, or a function that chooses actions"
    assert [problem.message for problem in found.problems if problem.kind == "type"] == ([] if target[0] in "nl" else [message])


def test_a_launch_file_that_returns_nothing(tmp_path: Path) -> None:
    found = composed(tmp_path, {"main.launch.py": "def generate_launch_description():\n    return_later = []\n"})
    assert [problem.message for problem in found.problems] == ["generate_launch_description of main.launch.py returns nothing"]


def test_a_description_that_two_nodes_get(tmp_path: Path) -> None:
    entities = """*[node(name, parameters=[{'robot': Command(['xacro ', os.path.dirname(__file__) + '/r.urdf',
      ' config:=', os.path.dirname(__file__) + '/config.yaml'])}]) for name in ('a', 'b')]"""
    robot = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="config" default=""/></robot>'
    text = f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{entities}])\n"
    found = params(composed(tmp_path, {"main.launch.py": text, "r.urdf": robot, "config.yaml": "a: 1\n"}))
    assert "<robot" in str(found["/a/robot"])
    assert found["/b/robot"] == found["/a/robot"]


def test_a_source_of_another_format(tmp_path: Path) -> None:
    inner = {"launch/inner.launch.xml": "<launch/>"}
    for source, told in (("Python", True), ("launch_yaml.YAML", True), ("launch_xml.XML", False), ("Any", False)):
        module, _, name = source.rpartition(".")
        imported = f"from {module}.launch_description_sources import *\n" if module else ""
        text = f"IncludeLaunchDescription({name}LaunchDescriptionSource([ThisLaunchFileDir(), '/inner.launch.xml']))"
        body = f"{HEAD}{imported}def generate_launch_description():\n    return LaunchDescription([{text}])\n"
        found = [problem.message for problem in composed(tmp_path, {"launch/main.launch.py": body, **inner}).problems]
        refused = f"{name}LaunchDescriptionSource does not read inner.launch.xml: use AnyLaunchDescriptionSource"
        assert (refused in found) == told


@pytest.mark.parametrize(
    "command",
    [
        "Command(['ros2 run xacro xacro ', robot, ' link:=base'])",
        "subprocess.run(['xacro', robot, 'link:=base'], capture_output=True, text=True, check=True).stdout",
        "subprocess.run(['xacro', robot, 'link:=base'], stdout=subprocess.PIPE).stdout.decode('utf-8')",
        "subprocess.check_output(['xacro', Path(robot), 'link:=base']).decode()",
        "subprocess.check_output('xacro ' + robot + ' link:=base', shell=True, encoding='utf-8')",
        "subprocess.getoutput(f'xacro {robot} link:=base')",
        "os.popen(f'xacro {robot} link:=base').read()",
    ],
)
def test_a_description_that_a_program_prints(tmp_path: Path, command: str) -> None:
    robot = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="link" default=""/>
      <link name="$(arg link)"/></robot>"""
    entities = f"node('a', parameters=[{{'robot_description': {command}}}])"
    text = (
        f"{HEAD}import subprocess\ndef generate_launch_description():\n    robot = os.path.dirname(__file__) + '/r.urdf'\n"
        f"    return LaunchDescription([{entities}])\n"
    )
    found = composed(tmp_path, {"main.launch.py": text, "r.urdf": robot})
    assert '<link name="base"/>' in str(params(found)["/a/robot_description"])
    assert not found.problems


def test_what_a_program_prints_that_is_not_known(tmp_path: Path) -> None:
    entities = "node('a', parameters=[{'host': subprocess.check_output(['hostname', '-I'], text=True)}])"
    text = f"{HEAD}import subprocess\ndef generate_launch_description():\n    return LaunchDescription([{entities}])\n"
    assert params(composed(tmp_path, {"main.launch.py": text})) == {"/a/host": "$(subprocess.check_output(['hostname', '-I'], text=True))"}


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("<!-- a: b -->", "is no YAML, which launch takes it for without a ParameterValue of type str: mapping values are not allowed here, line 2"),
        ("<!-- # -->\n<link/>", "is no YAML, which launch takes it for without a ParameterValue of type str: "),
        ("\t<link/>", "is no YAML, which launch takes it for without a ParameterValue of type str: "),
        ("<link/> # the last line", None),
    ],
)  # fmt: skip
def test_a_description_is_read_as_yaml(tmp_path: Path, text: str, told: str | None) -> None:
    """As the real launch does it with what `Command` prints, unless the value is said to be a text."""
    described = "Command(['cat ', os.path.dirname(__file__) + '/r.urdf'])"
    for value, fails in ((described, told), (f"ParameterValue({described}, value_type=str)", None)):
        body = f"return LaunchDescription([node('a', parameters=[{{'robot_description': {value}}}])])"
        files = {"main.launch.py": f"{HEAD}def generate_launch_description():\n    {body}\n", "r.urdf": f'<robot name="r">\n{text}\n'}
        found = composed(tmp_path, files)
        assert [fails in problem.message for problem in found.problems if fails] == [True] * bool(fails)
        assert bool(found.nodes) == (fails is None)


@pytest.mark.parametrize(
    "text", ["a: b", "a: b: c", "[1, a]", "null", "2020-01-01", "[[1], [2]]", '"a', "[]", "@a", "*a", "# a", "a\\n---\\nb"]
)
def test_texts_that_launch_takes_for_no_parameter(tmp_path: Path, text: str) -> None:
    """All of them the real launch refused."""
    found = described(tmp_path, f"node('a', parameters=[{{'p': [TextSubstitution(text='{text}')]}}])")
    assert [problem.kind for problem in found.problems] == ["parameter"]
    assert not found.nodes


def test_texts_of_several_types_in_a_list(tmp_path: Path) -> None:
    found = described(tmp_path, "node('a', parameters=[{'p': [[TextSubstitution(text='1')], [TextSubstitution(text='b')]]}])")
    assert [problem.message for problem in found.problems] == ["the elements of `[1, 'b']` are of several types"]


def test_what_xacro_prints_in_ros_2_ends_with_its_last_line(tmp_path: Path) -> None:
    """That of ROS 1 prints an empty line more."""
    text = "ParameterValue(Command(['xacro ', os.path.dirname(__file__), '/r.urdf']), value_type=str)"
    body = f"return LaunchDescription([node('a', parameters=[{{'p': {text}}}])])"
    found = composed(tmp_path, {"main.launch.py": f"{HEAD}def generate_launch_description():\n    {body}\n", "r.urdf": '<robot name="r"/>'})
    assert str(params(found)["/a/p"]).endswith(' -->\n<robot name="r"/>\n')


def test_a_process_that_is_a_node_of_its_own(tmp_path: Path) -> None:
    found = described(tmp_path, "ExecuteProcess(cmd=['rviz2', '-d', 'x.rviz', '--ros-args', '-r', '__ns:=/robot', '-r', 'tf:=/tf'])")
    [node] = found.nodes
    assert (node.package, node.type, node.full_name, node.args, len(node.remaps)) == ("rviz2", "rviz2", "/robot/rviz2", "-d x.rviz", 1)


def test_a_variable_that_may_have_no_value_shows_nothing_of_its_own(tmp_path: Path) -> None:
    before = "import sys\nfor word in sys.argv:\n    if word.startswith('n:='):\n        number = int(word.split(':=')[1])"
    (name,) = names(described(tmp_path, "node('r', namespace=['robot_', str(number)])", before))
    assert name.startswith("/robot_$(")
    assert " object at " not in name
