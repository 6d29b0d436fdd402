"""What the real launch 3.7.1 and launch_ros 0.28.0 made of the same files: substitutions, scopes, and types of parameters."""

from __future__ import annotations

from pathlib import Path

import pytest
from ros2_launch_builder import composed, described, params, problems, xml


def _refused(found: object) -> str:
    refusal = getattr(found, "refusal", None)
    return "" if refusal is None else refusal.message


def test_where_a_program_is_differs_from_machine_to_machine(tmp_path: Path) -> None:
    content = """<node pkg="here" exec="run" name="n"><param name="p" value="$(find-exec sh)/x"/>
      <param name="q" value="$(command '$(find-exec echo) 1')"/></node>
      <executable cmd="$(find-exec ros2) run here $(find-exec sh)"/>"""
    found = xml(tmp_path, content)
    assert params(found) == {"/n/p": "$(find-exec sh)/x", "/n/q": 1}
    assert [node.type for node in found.nodes] == ["run", "sh"]


def test_a_parameter_that_was_given_to_all_nodes(tmp_path: Path) -> None:
    entities = """SetParameter('p', True), SetParameter('p', 2), SetParameter('l', [1, 2]),
      *[node(f'n{at}', arguments=[one]) for at, one in enumerate((Given('p'), Given('l'), Given('q', default='d'), Given('q', default=3)))]"""
    found = described(tmp_path, entities, "from launch_ros.substitutions import Parameter as Given")
    assert [node.args for node in found.nodes] == ["True", "'(1, 2)'", "d", "3"]
    text = '<node pkg="here" exec="run" name="n"><param name="p" value="$(param q{})"/></node>'
    assert params(xml(tmp_path, text.format(" d"))) == {"/n/p": "d"}
    assert _refused(xml(tmp_path, text.format(""))) == "the parameter `q` is given to no node before"


def test_a_parameter_that_was_given_under_a_condition(tmp_path: Path) -> None:
    content = """<set_parameter name="p" value="1" if="$(command decide)"/>
      <node pkg="here" exec="run" name="n" args="$(param p 2)"/>"""
    assert [node.args for node in xml(tmp_path, content).nodes] == ["'$(param p)'"]


@pytest.mark.parametrize("name", ["any", "all"])
def test_substitutions_that_front_ends_cannot_make(tmp_path: Path, name: str) -> None:
    told = f"$({name} ...) fails in launch files in XML and YAML: use `and` and `or`"
    assert _refused(xml(tmp_path, f'<log message="$({name} true)"/>')) == told
    python = described(tmp_path, f"node('n', condition=IfCondition({name.capitalize()}Substitution('true', 'false')))")
    assert (_refused(python), len(python.nodes)) == ("", name == "any")


@pytest.mark.parametrize("content", ['<log message="$(var gone)"/>', '<set_ros_log_dir new_log_dir="$(var gone)"/>'])
def test_a_text_that_is_only_told_must_be_known(tmp_path: Path, content: str) -> None:
    assert _refused(xml(tmp_path, content)) == "launch configuration `gone` is not set"


def test_what_is_pushed_is_put_back(tmp_path: Path) -> None:
    entities = """SetLaunchConfiguration('a', '1'), PushLaunchConfigurations(), SetLaunchConfiguration('a', '2'), PushROSNamespace('ns'),
      node('n', arguments=[LaunchConfiguration('a')]), PopLaunchConfigurations(), node('m', arguments=[LaunchConfiguration('a')]),
      SetEnvironmentVariable('E', 'x'), PushEnvironment(), SetEnvironmentVariable('E', 'y'), node('o'), PopEnvironment(), node('p')"""
    found = described(tmp_path, entities)
    assert [(node.full_name, node.args, node.environment) for node in found.nodes] == [
        ("/ns/n", "2", ()),
        ("/m", "1", ()),
        ("/o", "", (("E", "y"),)),
        ("/p", "", (("E", "x"),)),
    ]


def test_a_command_that_runs_a_node_gets_nothing_that_is_for_all_nodes(tmp_path: Path) -> None:
    entities = """PushROSNamespace('ns'), SetRemap('a', 'b'), SetParameter('p', 1), SetEnvironmentVariable('E', 'x'),
      ExecuteProcess(cmd=['ros2', 'run', 'here', 'tool', '--ros-args', '-r', '__node:=n']), ExecuteProcess(cmd=['ros2', 'run', '--prefix', 'gdb', 'here', 'tool'])"""
    (node,) = described(tmp_path, entities).nodes
    assert (node.full_name, node.remaps, node.own_params, node.environment) == ("/n", (), (), (("E", "x"),))


@pytest.mark.parametrize("name", ["LaunchConfigurations", "Environment"])
def test_nothing_was_pushed(tmp_path: Path, name: str) -> None:
    assert _refused(described(tmp_path, f"Pop{name}()")) == f"Pop{name}: nothing was pushed before"


def test_the_environment_is_reset_in_xml(tmp_path: Path) -> None:
    found = xml(tmp_path, '<set_env name="E" value="x"/><reset_env/><node pkg="here" exec="run" name="n"/>')
    assert [node.environment for node in found.nodes] == [()]


@pytest.mark.parametrize(
    ("value", "kind", "expected"),
    [
        ("007", "int", 7),
        ("010", "int", 10),
        ("1", "float", 1.0),
        ("1", "bool", True),
        ("no", "bool", False),
        ("1e5", "str", 100000.0),  # as rcl reads what launch_ros writes
        ("[1, 2]", "list_of_int", [1, 2]),
        ("[1, 2]", "yaml", [1, 2]),
        ("2.5", "int", "`2.5` is no int"),
        ("x", "float", "`x` is no float"),
        ("2", "bool", "`2` is no bool"),
        ("[1, x]", "list_of_int", "`[1, x]` is no list of int"),
        (
            "1",
            "double",
            "`double` is no type of parameters: these are"
            " auto, bool, float, int, list_of_bool, list_of_float, list_of_int, list_of_str, str, yaml",
        ),
    ],
)
def test_the_type_of_a_parameter_in_xml(tmp_path: Path, value: str, kind: str, expected: object) -> None:
    for text in (value, f"$(var x '{value}')"):
        found = xml(tmp_path, f'<node pkg="here" exec="run" name="n"><param name="p" value="{text}" type="{kind}"/></node>')
        assert (_refused(found) or params(found)["/n/p"]) == expected


def test_a_value_of_another_type_where_no_node_starts(tmp_path: Path) -> None:
    """launch converts it as it reads the file."""
    found = xml(tmp_path, '<node pkg="here" exec="run" if="false"><param name="p" value="x" type="float"/></node>')
    assert _refused(found) == "`x` is no float"


@pytest.mark.parametrize(
    ("value", "kind", "told"),
    [
        ("'1'", "int", "'1' is no int"),
        ("1", "float", "1 is no float"),
        ("1", "str", "1 is no str"),
        ("1", "int", ""),
        ("true", "bool", ""),
        ("x", "str", ""),
    ],
)
def test_the_type_of_a_parameter_in_yaml(tmp_path: Path, value: str, kind: str, told: str) -> None:
    node = f"{{pkg: here, exec: run, name: n, param: [{{name: p, value: {value}, type: {kind}}}]}}"
    assert _refused(composed(tmp_path, {"main.launch.yaml": f"launch:\n- node: {node}\n"})) == told


@pytest.mark.parametrize(
    ("value", "kind", "told"),
    [
        ("'1'", "int", "ParameterValue: '1' is no int: only what substitutions come to is converted"),
        ("1", "float", "ParameterValue: 1 is no float: only what substitutions come to is converted"),
        ("True", "int", ""),
        ("TextSubstitution(text='1')", "int", ""),
    ],
)
def test_the_type_of_a_parameter_in_python(tmp_path: Path, value: str, kind: str, told: str) -> None:
    found = described(tmp_path, f"node('n', parameters=[{{'p': ParameterValue({value}, value_type={kind})}}])")
    assert _refused(found) == told
    assert problems(found, tmp_path) == ([f"launch/main.launch.py:20:59: {told}"] if told else [])
