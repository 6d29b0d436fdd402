"""Launch files that no other includes, and the meaning of a node's `args`."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.extractor.launch import Files, NodeStart, PackagePath, Place, Remap, compose, launch_files, top_level
from rosarch.extractor.launch.arguments import NodeArguments, node_arguments


def test_top_level(tmp_path: Path) -> None:
    texts = {
        "main.launch": '<launch><include file="$(find p)/used.launch"/><include file="$(find p)/off.launch" if="false"/></launch>',
        "used.launch": '<launch><include file="$(dirname)/parts/inner.launch.xml"/></launch>',
        "off.launch": "<launch/>",
        "parts/inner.launch.xml": "<launch/>",
        "parts/front_laser.launch": "<launch/>",
        "parts/deep/front_laser.launch": "<launch/>",
        "choose.launch": '<launch><arg name="side"/><include file="$(find p)/parts/$(arg side)_laser.launch"/></launch>',
        "anything.launch": '<launch><arg name="file"/><include file="$(arg file)"/><include file="$(dirname)/anything.launch" if="false"/></launch>',
        "broken.launch": "<launch>",
        ".hidden/x.launch": "<launch/>",
        "off/inner/y.launch": "<launch/>",
        "off/CATKIN_IGNORE": "",
        "shelved/y.launch": "<launch/>",
        "shelved/COLCON_IGNORE": "",
        "left/inner/y.launch": "<launch/>",
        "left/AMENT_IGNORE": "",
    }
    for name, text in {**texts, "package.xml": "<package><name>p</name></package>"}.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    found = top_level(launch_files(tmp_path), Files(PackagePath([tmp_path])), {})
    assert [path.removeprefix(f"{tmp_path}/") for path in found] == [
        "anything.launch",
        "broken.launch",
        "choose.launch",
        "main.launch",
        "parts/deep/front_laser.launch",
    ]


def test_launch_files_of_ros_2_may_be_called_anything(tmp_path: Path) -> None:
    node = '<launch><node pkg="a" exec="b"/></launch>'
    texts = {
        "p/launch/race.xml": node,
        "p/launch/track/drive.py": "def generate_launch_description(): ...",
        "p/launch/tools.py": "import os",
        "p/launch/model.xml": "<robot/>",
        "p/launch/part.xml": '<launch><node pkg="a" type="b" name="b"/></launch>',
        "p/config/race.xml": node,
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    found = [path.removeprefix(f"{tmp_path}/") for path in launch_files(tmp_path)]
    assert found == ["p/launch/race.xml", "p/launch/track/drive.py"]


@pytest.mark.parametrize(
    ("manifest", "expected"),
    [
        (
            "<buildtool_depend>ament_cmake</buildtool_depend>",
            ["l.launch:2:1: written for ROS 1 (`type`), in a package for ROS 2: `ros2 launch` rejects it"],
        ),
        ("<buildtool_depend>ament_cmake</buildtool_depend><buildtool_depend>catkin</buildtool_depend>", []),
        ("<buildtool_depend>catkin</buildtool_depend>", []),
    ],
)
def test_a_launch_file_of_ros_1_that_a_package_of_ros_2_has_left(tmp_path: Path, manifest: str, expected: list[str]) -> None:
    (tmp_path / "package.xml").write_text(f"<package><name>p</name>{manifest}</package>")
    (tmp_path / "l.launch").write_text('<launch>\n<node pkg="a" type="b" name="n"/></launch>')
    found = compose([tmp_path / "l.launch"], files=Files(PackagePath([tmp_path])))
    assert [str(problem).removeprefix(f"{tmp_path}/") for problem in found.problems] == expected
    assert [node.name for node in found.nodes] == ([] if expected else ["n"])


def test_words_of_ros_1_in_several_lines_are_one_problem(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name><buildtool_depend>ament_cmake</buildtool_depend></package>")
    nodes = [f'<node pkg="a" {how}="b" name="{how}"/>' for how in ("exec", "type")]
    files = Files(PackagePath([tmp_path]))
    (tmp_path / "once.launch").write_text("\n".join(["<launch>", *nodes, "</launch>"]))
    once = compose([tmp_path / "once.launch"], files=files).problems
    assert [problem.subject for problem in once] == ["type", "exec"]
    (tmp_path / "more.launch").write_text("\n".join(["<launch>", *nodes, '<arg name="x" default="$(find p)"/>', "</launch>"]))
    assert [str(problem).removeprefix(f"{tmp_path}/") for problem in compose([tmp_path / "more.launch"], files=files).problems] == [
        "more.launch:3:1: `type`, `find` of ROS 1 in a launch file for ROS 2, in 2 lines: `ros2 launch` rejects it"
    ]


def test_launch_files_that_a_package_has_left_are_one_problem(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name><buildtool_depend>ament_cmake</buildtool_depend></package>")
    for name in ("a.launch", "b.launch", "deep/c.launch", "inner/d.launch"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text('<launch>\n<node pkg="a" type="b" name="n"/></launch>')
    (tmp_path / "inner" / "package.xml").write_text("<package><name>q</name><buildtool_depend>ament_cmake</buildtool_depend></package>")
    (tmp_path / "new.launch").write_text('<launch>\n<node pkg="a" exec="b" name="n"/></launch>')
    files = Files(PackagePath([tmp_path]))
    found = [compose([tmp_path / name], files=files).problems for name in ("a.launch", "b.launch", "deep/c.launch")]
    assert found[0] == found[1] == found[2]
    assert [str(problem).removeprefix(f"{tmp_path}/") for problem in found[0]] == [
        "a.launch:2:1: written for ROS 1 (`type`), in a package for ROS 2, like 2 others of the package (b.launch, c.launch): "
        "`ros2 launch` rejects it"
    ]


def test_launch_files_among_the_tests_of_a_package_are_not_started(tmp_path: Path) -> None:
    for name in ("p/package.xml", "p/test/a.launch", "p/launch/b.launch", "tests/q/package.xml", "tests/q/launch/c.launch"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("<launch/>")
    found = [path.removeprefix(f"{tmp_path}/") for path in launch_files(tmp_path)]
    assert found == ["p/launch/b.launch", "tests/q/launch/c.launch"]


def test_what_eclipse_starts_is_no_launch_file(tmp_path: Path) -> None:
    head = '<?xml version="1.0" encoding="UTF-8" standalone="no"?>\n'
    (tmp_path / "firmware Debug.launch").write_text(
        head + '<launchConfiguration type="debug">\n<stringAttribute key="a" value="b"/>\n</launchConfiguration>\n'
    )
    (tmp_path / "robot.launch").write_text(head + "<!-- not <launchConfiguration -->\n<launch/>\n")
    (tmp_path / "broken.launch").write_text("<lunch/>")
    (tmp_path / "remarks.launch").write_text("<!-- a --> <!-- b -->\n" * 5000 + "<launch/>\n")  # in time that grows as the text does
    assert [Path(path).name for path in launch_files(tmp_path)] == ["broken.launch", "remarks.launch", "robot.launch"]


def test_templates_are_no_launch_files_yet(tmp_path: Path) -> None:
    texts = {
        "p/launch/real.launch": "<launch><rosparam>{a: [ON_OFF, {b: 1}]}</rosparam></launch>",
        "p/launch/made.launch": '<launch><node pkg="[ROBOT]_moveit" type="t" name="n"/></launch>',
        "p/launch/jinja.launch": "<launch>{% if sim %}<group>{% endif %}</launch>",
        "p/launch/broken.launch": "<launch>",
        "p/templates/launch/part.launch": "<launch/>",
        "p/skeleton/{{name}}/x.launch": "<launch/>",
        "templates/q/launch/real.launch": "<launch/>",
    }
    for name, text in {**texts, "p/package.xml": "", "templates/q/package.xml": ""}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    found = [path.removeprefix(f"{tmp_path}/") for path in launch_files(tmp_path)]
    assert found == ["p/launch/broken.launch", "p/launch/real.launch", "templates/q/launch/real.launch"]


def test_files_that_include_each_other_are_started_from_the_first(tmp_path: Path) -> None:
    includes = {
        "above": ["ring_b"],
        "one": ["two"],
        "ring_a": ["ring_b"],
        "ring_b": ["ring_a", "used"],
        "two": ["one", "three"],
        "self": ["self"],
    }
    for name in (*includes, "three", "used"):
        lines = [f'<include file="$(dirname)/{other}.launch"/>' for other in includes.get(name, ())]
        (tmp_path / f"{name}.launch").write_text(f"<launch>{''.join(lines)}</launch>")
    found = top_level(launch_files(tmp_path), Files(PackagePath([tmp_path])), {})
    assert [Path(path).stem for path in found] == ["above", "one", "self"]


def started(args: str, *remaps: tuple[str, str]) -> NodeStart:
    place = Place("a.launch", 1)
    return NodeStart("p", "t", "n", "/", (place,), tuple(Remap(source, target, place) for source, target in remaps), args)


@pytest.mark.parametrize(
    ("node", "expected"),
    [
        (started(""), NodeArguments((), (), (), ())),
        (started("load p/Filter manager"), NodeArguments(("load", "p/Filter", "manager"), ("load", "p/Filter", "manager"), (), ())),
        (
            started("--rate 10 a:=b _p:=1 __name:=other __ns:=/left c:='d e'"),
            NodeArguments(
                ("--rate", "10", "a:=b", "_p:=1", "__name:=other", "__ns:=/left", "c:=d e"),
                ("--rate", "10"),
                (("a", "b"), ("c", "d e")),
                (("p", "1"),),
                "/left",
            ),
        ),
        (started("a:=b a:=c x:=y", ("x", "z")), NodeArguments(("a:=b", "a:=c", "x:=y"), (), (("a", "c"),), ())),
        (started("open 'quote"), NodeArguments(("open 'quote",), ("open 'quote",), (), ())),
        (started(":=a"), NodeArguments((":=a",), (":=a",), (), ())),
    ],
)
def test_node_arguments(node: NodeStart, expected: NodeArguments) -> None:
    assert node_arguments(node) == expected
