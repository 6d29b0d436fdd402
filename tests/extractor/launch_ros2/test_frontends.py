"""Launch files of ROS 2 in XML and YAML, and which version of ROS a launch file is for."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest
from ros2_launch_builder import HEAD, MANIFEST, composed, names, params, problems, xml

from rosarch.base.limits import Limits
from rosarch.extractor.launch import Files, PackagePath, launch_files, ros_version, top_level

_TENFOLD = [f"x{i}: &x{i} [{', '.join([f'*x{i - 1}'] * 10)}]\n" for i in range(1, 8)]
UNFOLDING = f"x0: &x0 [a]\n{''.join(_TENFOLD)}launch:\n- arg: {{name: a, default: *x7}}\n"


def test_xml(tmp_path: Path) -> None:
    content = """<arg name="a" default="1"><choice value="1"/><choice value="2"/></arg><let name="b" value="$(eval '$(var a) + 1')"/>
<group><push-ros-namespace namespace="g"/><set_remap from="x" to="y"/>
<node pkg="here" exec="run" name="n" args="-d &quot;a b&quot; --ros-args -r c:=d" if="$(var a)">
  <param name="b" value="$(var b)"/><param name="s" value="1" type="str"/><param from="$(find-pkg-share here)/p.yaml"/>
  <param name="deep"><param name="er" value="[1, 2]"/></param><remap from="~/in" to="/out"/><env name="E" value="1"/></node></group>
<include file="$(dirname)/other.xml"><arg name="z" value="$(var b)"/></include>
<node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="">
  <composable_node pkg="here" plugin="here::One" name="one"><param name="p" value="v"/></composable_node></node_container>
<load_composable_node target="/box"><composable_node pkg="here" plugin="here::Two" name="two" unless="true"/></load_composable_node>
<executable cmd="ros2 run here tool"/><node pkg="here" exec="run" name="$(anon x)"/>"""
    other = '<launch><arg name="z"/><node pkg="here" exec="run" name="o"><param name="z" value="$(var z)"/></node></launch>'
    found = xml(tmp_path, content, other_xml=other, p_yaml="/g/n:\n  ros__parameters: {f: 2.5}\n")
    assert problems(found, tmp_path) == []
    assert names(found) == ["/g/n", "/o", "/box", "/one", "/tool", "/$(anon x)"]
    (first, *_rest) = found.nodes
    assert first.args == "-d 'a b'"
    assert [(remap.source, remap.target) for remap in first.remaps] == [("c", "d"), ("x", "y"), ("~in", "/out")]
    assert params(found) == {"/g/n/b": 2, "/g/n/s": "1", "/g/n/f": 2.5, "/g/n/deep.er": [1, 2], "/o/z": 2, "/one/p": "v"}


def test_yaml(tmp_path: Path) -> None:
    text = """launch:
- arg: {name: a, default: 'n'}
- group:
    - push_ros_namespace: {namespace: g}
    - node:
        pkg: here
        exec: run
        name: $(var a)
        param:
          - {name: k, value: 3}
          - {name: list, value: [1, 2]}
        remap:
          - {from: x, to: y}
        if: 'true'
- include:
    file: $(find-pkg-share here)/other.launch.yaml
    arg:
      - {name: z, value: $(var a)}
"""
    other = "launch:\n- arg: {name: z}\n- node: {pkg: here, exec: run, name: o, param: [{name: z, value: $(var z)}]}\n"
    found = composed(tmp_path, {"main.launch.yaml": text, "other.launch.yaml": other})
    assert problems(found, tmp_path) == []
    assert names(found) == ["/g/n", "/o"]
    assert [(remap.source, remap.target) for remap in found.nodes[0].remaps] == [("x", "y")]
    assert params(found) == {"/g/n/k": 3, "/g/n/list": [1, 2], "/o/z": False}  # rcl reads n as no


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ('<node pkg="here"/>', "main.launch.xml:2:1: <node> has no attribute `exec`"),
        ('<arg name="a" default="1" descrption="x"/>', "main.launch.xml:2:1: <arg> cannot have the attribute `descrption`"),
        (
            '<group><node pkg="p" exec="e"><param nam="a" name="a" value="1"/></node></group>',
            "main.launch.xml:2:31: <param> cannot have the attribute `nam`",
        ),
        ('<node exec="$(var x" pkg="p"/>', "main.launch.xml:2:1: `$(` is not closed: $(var x"),
        ('<node exec="$(nope x)" pkg="p"/>', "main.launch.xml:2:1: unknown substitution $(nope)"),
        ('<thing exec="1"/>', "main.launch.xml:2:1: unknown element <thing> in <launch>"),
        ('<let name="a" value="$(eval \'1 +\')"/>', "main.launch.xml:2:1: the expression `1 +` fails: invalid syntax"),
        ('<group if="maybe"><let name="a" value="1"/></group>', "main.launch.xml:2:1: if: `maybe` is not true or false"),
        ('<let name="a" value="1"><', "main.launch.xml:2:26: broken XML: not well-formed (invalid token)"),
    ],
)
def test_bad_xml(tmp_path: Path, content: str, said: str) -> None:
    assert problems(xml(tmp_path, content), tmp_path) == [said]


@pytest.mark.parametrize(
    ("content", "meant"),
    [
        ('<arg name="a" default="1" descrption="x"/>', ("descrption", "description")),
        ('<arg name="a" defalt="1" default="2"/>', None),  # it has that
        ('<arg name="a" default="1" colour="2"/>', None),
        ('<nod pkg="p" exec="e"/>', ("nod", "node")),
        ('<nod pkg="p" exec="e"></nod>', ("nod", "node")),
        ('<grup><node pkg="p" exec="e"/></grup>', None),  # its end tag would have to be changed, too
    ],
)
def test_what_was_meant(tmp_path: Path, content: str, meant: tuple[str, str] | None) -> None:
    (problem,) = xml(tmp_path, content).problems
    assert problem.meant == meant


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("launch: [", "main.launch.yaml:1:10: while parsing a flow node expected the node content, but found '<stream end>'"),
        ("- a", "main.launch.yaml:1:1: a launch file in YAML is a map with the key `launch`"),
        ("launch:\n- nope: {}\n", "main.launch.yaml:2:3: unknown element <nope> in <launch>"),
        ("launch:\n- arg:\n    name: a\n    default: b\n    defalt: b\n", "main.launch.yaml:5:5: <arg> cannot have the attribute `defalt`"),
        (
            "launch:\n- node:\n    pkg: here\n    exec: run\n    parameters:\n      - a.yaml\n",
            "main.launch.yaml:5:5: <node> cannot have the attribute `parameters`",
        ),
        (
            "launch:\n- node:\n    pkg: here\n    exec: run\n    parameters:\n      - {name: a, value: 1}\n",
            "main.launch.yaml:6:9: <node> cannot hold <parameters>",
        ),
        ("launch:\n- arg: {name: a, default: 2000-99-99}\n", "main.launch.yaml:1:1: month must be in 1..12"),
        ("launch:\n- arg: {name: a, default: !own x}\n", "main.launch.yaml:2:27: could not determine a constructor for the tag '!own'"),
        ("launch:\n- group: &a [group: *a]\n", "main.launch.yaml:1:1: a value that contains itself"),
        (UNFOLDING, "main.launch.yaml:1:1: more than 1000000 values when aliases are unfolded"),
    ],
)
def test_bad_yaml(tmp_path: Path, text: str, said: str) -> None:
    assert problems(composed(tmp_path, {"main.launch.yaml": text}), tmp_path) == [said]


def test_yaml_cannot_pose_as_an_unknown(tmp_path: Path) -> None:
    text = 'launch:\n- node: {pkg: here, exec: run, args: "n\\U00100000"}\n'
    assert composed(tmp_path, {"main.launch.yaml": text}).nodes[0].args == "'n\ufffd'"


@pytest.mark.parametrize(
    ("name", "text", "version"),
    [
        ("a.launch.py", "", 2),
        ("a.launch.yaml", "", 2),
        ("a.launch", '<launch><node pkg="p" type="t" name="n"/></launch>', 1),
        ("a.launch", '<launch><node pkg="p" exec="t" name="n"/></launch>', 2),
        ("a.launch.xml", '<launch><arg name="a" default="$(find p)/x"/></launch>', 1),
        ("a.launch.xml", '<launch><include file="x"/></launch>', 2),
        ("none.launch", "", 2),
    ],
)
def test_the_version_of_ros(tmp_path: Path, name: str, text: str, version: int) -> None:
    (tmp_path / "package.xml").write_text(MANIFEST.format("here"))
    if text or name.endswith((".py", ".yaml")):
        (tmp_path / name).write_text(text)
    assert ros_version(tmp_path / name) == version


def test_a_launch_file_with_words_of_both_versions_is_for_that_of_its_package(tmp_path: Path) -> None:
    text = '<launch><node pkg="p" type="a" name="a"/><node pkg="p" exec="b" name="b"/></launch>'
    (tmp_path / "main.launch").write_text(text)
    found = []
    for tool in ("catkin", "ament_cmake", ""):
        (tmp_path / "package.xml").write_text(f"<package><name>p</name><buildtool_depend>{tool}</buildtool_depend></package>")
        found.append(ros_version(tmp_path / "main.launch"))
    assert found == [1, 2, 2]


def test_files_that_no_other_includes(tmp_path: Path) -> None:
    main = (
        HEAD
        + "def generate_launch_description():\n    path = os.path.join(get_package_share_directory('here'), 'launch', 'part.launch.py')\n"
    )
    main += (
        "    return LaunchDescription([IncludeLaunchDescription(PythonLaunchDescriptionSource(path), condition=IfCondition('false'))])\n"
    )
    empty = "def generate_launch_description():\n    return None\n"
    files = {"launch/main_launch.py": main, "launch/part.launch.py": empty, "launch/test_x_launch.py": empty, "test/y_launch.py": empty}
    composed(tmp_path, {**files, "launch/no_launch.py": "x = 1\n", "launch/z.launch.xml": "<launch/>", "util.py": empty})
    found = [path.replace(f"{tmp_path}/here/", "") for path in launch_files(tmp_path)]
    assert found == ["launch/main_launch.py", "launch/part.launch.py", "launch/z.launch.xml"]
    top = top_level(launch_files(tmp_path), Files(PackagePath([tmp_path])))
    assert [path.rpartition("/")[2] for path in top] == ["main_launch.py", "z.launch.xml"]


NODES = HEAD + "def generate_launch_description():\n    return LaunchDescription([Node(package='here', executable='{}')])\n"


def test_how_many_processes_compose_does_not_matter(tmp_path: Path) -> None:
    files = {f"launch/{name}.launch.py": NODES.format(name) for name in "abcd"}
    composed(tmp_path, {**files, "launch/e.launch.xml": '<launch><node pkg="here" exec="e"/></launch>'})
    alone, together = (top_level(launch_files(tmp_path), Files(PackagePath([tmp_path])), jobs=jobs) for jobs in (1, 3))
    assert list(alone.items()) == list(together.items())
    assert [node.type for composition in together.values() for node in composition.nodes] == ["a", "b", "c", "d", "e"]


def test_a_launch_file_that_takes_too_long_is_left_out(tmp_path: Path, limits: Limits) -> None:
    limits.evaluation = 0.5
    forever = (
        HEAD + "def generate_launch_description():\n    for i in range(10000):\n        for j in range(10000):\n            k = [i, j]\n"
    )
    composed(tmp_path, {"launch/b.launch.py": NODES.format("b"), "launch/a.launch.py": forever})
    top = top_level(launch_files(tmp_path), Files(PackagePath([tmp_path])), jobs=2)
    assert [problem.message for composition in top.values() for problem in composition.problems] == ["left out: not done after 0.5 s"]
    assert [node.type for composition in top.values() for node in composition.nodes] == ["b"]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["a.launch.py", "a.launch.yaml"])
def test_a_long_line_is_read_in_linear_time(tmp_path: Path, name: str, at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    files = {
        f"launch/{name}": f"# {'x' * 1_000_000}\n# generate_launch_description of b.launch.py.\nlaunch: 1\n",
        "launch/b.launch.py": NODES.format("b"),
    }
    composed(tmp_path, files)
    with at_most(5):
        top = top_level(launch_files(tmp_path), Files(PackagePath([tmp_path])))
    assert [path.rpartition("/")[2] for path in top] == [name]


def test_an_argument_may_be_used_in_a_file_of_parameters_that_is_not_known(tmp_path: Path) -> None:
    inner = '<launch><arg name="file"/><node pkg="here" exec="run" name="n"><param from="$(var file)" allow_substs="true"/></node></launch>'
    passed = '<arg name="file" value="$(var given)"/><arg name="locked" value="true"/>'
    found = xml(tmp_path, f'<arg name="given"/><include file="$(dirname)/inner.launch.xml">{passed}</include>', inner_launch_xml=inner)
    assert [problem.kind for problem in found.problems] == ["argument"]


def test_the_environment_of_nodes(tmp_path: Path) -> None:
    """What is set for all that follows, and for a node alone; what leaves its group is as it was."""
    found = xml(
        tmp_path,
        '<group><set_env name="ROS_DOMAIN_ID" value="3"/><node pkg="p" exec="a"/><node pkg="p" exec="b"><env name="ROS_DOMAIN_ID" value="7"/></node></group>'
        '<node pkg="p" exec="c"/>',
    )
    assert {node.type: node.environment for node in found.nodes} == {
        "a": (("ROS_DOMAIN_ID", "3"),),
        "b": (("ROS_DOMAIN_ID", "7"),),
        "c": (),
    }
