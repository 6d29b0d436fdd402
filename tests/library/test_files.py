"""Files of packages in a library: what others include, as data, found and read like what is installed."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml

from rosarch.extractor.launch import Composition, Files, PackagePath, compose
from rosarch.extractor.underlay import Underlay
from rosarch.library import prefixes
from tests.extractor.ros2_launch_builder import HEAD
from tests.extractor.workspace_builder import write

MANIFEST = """<package format="3"><name>{}</name><version>1.2.3</version><description>d</description><maintainer email="a@b.org">a</maintainer>
<license>Apache-2.0</license><depend>other</depend><export><build_type>ament_cmake</build_type></export></package>"""
LAUNCH = f"""# a comment
{HEAD}
from nav2_common.launch import RewrittenYaml

class Declared(DeclareLaunchArgument):
    pass

def late(context, package):
    kind = LaunchConfiguration("kind").perform(context)
    nodes = [Node(package=package, executable="fast" if kind == "fast" else "slow", name=[kind, "_node"])]
    if kind in ["fast", "both"]:
        nodes.append(Node(package=package, executable="second"))
    return nodes

def generate_launch_description():
    share = get_package_share_directory("base")
    elsewhere = os.path.join(get_package_share_directory("other"), "x.launch.py")
    rewritten = RewrittenYaml(LaunchConfiguration("params"), param_rewrites={{"speed": LaunchConfiguration("speed")}}, convert_types=True)
    return LaunchDescription([
        DeclareLaunchArgument("params", default_value=os.path.join(share, "config", "base.yaml"), description="what it is for"),
        DeclareLaunchArgument("speed", default_value=os.environ["SPEED"]),
        DeclareLaunchArgument("other", default_value="false", choices=["true", "false"]),
        GroupAction([
            PushRosNamespace("robot"),
            Node(package="base", executable="drive", name="drive", parameters=[rewritten, {{"list": [1, 2.5]}}], remappings={{("a", "b"), ("c", "d")}}),
        ], condition=UnlessCondition(LaunchConfiguration("other"))),
        IncludeLaunchDescription(PythonLaunchDescriptionSource(elsewhere), condition=IfCondition(LaunchConfiguration("other"))),
        Declared("kind", default_value="none"),
        OpaqueFunction(function=late, args=["base"], condition=UnlessCondition(LaunchConfiguration("other"))),
    ])
"""
FILES = {
    "package.xml": MANIFEST.format("base"),
    "CMakeLists.txt": "project(base)\n",
    "launch/base.launch.py": LAUNCH,
    "launch/more.launch.xml": '<launch>\n  <!-- a comment -->\n  <include file="$(find-pkg-share base)/launch/base.launch.py"/>\n</launch>\n',
    "launch/made.launch.py.in": "from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription([])  # @X@\n",
    "launch/wrong.launch.py": "def generate_launch_description(): return 1\n",
    "config/base.yaml": "# a comment\n/**:\n  ros__parameters: {speed: 1.0, frame: base}\n",
    "msg/Level.msg": '# a comment\nint32 value  # the value\nstring NAME = "a # b"\n',
    "urdf/base.xacro": '<robot xmlns:xacro="http://ros.org/wiki/xacro" name="r"><!-- a comment --><xacro:property name="x" value="1"/></robot>\n',
    "src/drive.cpp": "// code\n",
    "scripts/tool.py": "import rclpy\n",
    "test/test.launch.py": LAUNCH,
    "maps/map.yaml": "image: map.png\n",
}


@pytest.fixture
def library(tmp_path: Path, rosarch: Callable, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of a library of one package, beside the workspace `robot` that uses it."""
    monkeypatch.chdir(tmp_path)
    write(tmp_path / "src/base", FILES)
    options = ("--origin", "https://example.com/base.git", "--revision", "1.2", "--distribution", "humble", "--files", "-o", "library")
    done = rosarch("library", "build", "src", *options, "-v")
    assert done.code == 0, done.err
    assert "wrong.launch.py:1:1: left out: generate_launch_description returns no description" in done.err
    return tmp_path / "library"


def test_what_is_kept_is_data_and_says_where_it_is_from(library: Path) -> None:
    share = library / "ros2/share/base"
    kept = {path.relative_to(share).as_posix() for path in share.rglob("*") if path.is_file()}
    launch = {"launch/base.launch.py.json", "launch/made.launch.py.json", "launch/more.launch.xml"}
    assert kept == {"package.xml", "origin.yaml", *launch, "config/base.yaml", "msg/Level.msg", "urdf/base.xacro"}
    texts = [(share / name).read_text() for name in kept]
    assert not any(word in text for text in texts for word in ("a comment", "def ", "import", "what it is for", str(library.parent)))
    assert yaml.safe_load((share / "origin.yaml").read_text()) == {
        **{"package": "base", "version": "1.2.3", "licence": ["Apache-2.0"], "ros": 2},
        **{"origin": "https://example.com/base.git", "revision": "1.2", "distributions": ["humble"]},
    }
    assert (share / "msg/Level.msg").read_text() == 'int32 value\nstring NAME = "a # b"\n'
    assert "http://www.ros.org/wiki/xacro" in (share / "urdf/base.xacro").read_text()


def test_a_description_starts_what_its_launch_file_starts(library: Path) -> None:
    def composed(path: PackagePath, **arguments: str) -> Composition:
        folder = Path(path.packages["base"])
        file = Files(path).located(str(folder / "launch/base.launch.py"))
        return compose([file], arguments, files=Files(path), environment={"SPEED": "2.5"})

    def starts(found: Composition) -> list[tuple[object, ...]]:
        return [(node.full_name, node.package, node.type, [(r.source, r.target) for r in node.remaps]) for node in found.nodes]

    library_path = PackagePath([], Underlay(libraries=prefixes([library])))
    sources_path = PackagePath([library.parent / "src"])
    for arguments, late in (
        ({"speed": "3.5"}, [("/none_node", "slow")]),
        ({"kind": "fast"}, [("/fast_node", "fast"), ("/second", "second")]),
        ({"kind": "both", "speed": "1"}, [("/both_node", "slow"), ("/second", "second")]),
        ({"other": "true"}, []),
    ):
        sources, described = composed(sources_path, **arguments), composed(library_path, **arguments)
        drive = [("/robot/drive", "base", "drive", [("a", "b"), ("c", "d")])] if late else []
        assert starts(described) == starts(sources) == drive + [(name, "base", program, []) for name, program in late], arguments
        settings = [(one.name, one.value) for one in described.params]
        assert settings == [(one.name, one.value) for one in sources.params]
        assert (("/robot/drive/speed", float(arguments.get("speed", 2.5))) in settings) == bool(late)
        assert not any(problem.kind == "python" for problem in (*described.problems, *sources.problems))
        assert not any(node.conditions for node in described.nodes)
        assert [include.text for include in described.includes] == ([] if late else ["$(find-pkg-share other)/x.launch.py"])


def test_a_workspace_includes_what_the_library_has(library: Path, rosarch: Callable) -> None:
    include = '<launch><include file="$(find-pkg-share base)/launch/more.launch.xml"/></launch>\n'
    write(Path("robot"), {"package.xml": MANIFEST.format("robot"), "launch/main.launch.xml": include, "CMakeLists.txt": "project(robot)\n"})

    def nodes(*options: str) -> list[str]:
        done = rosarch("show", "graph", "robot", "--format", "json", *options)
        return [node["name"] for system in json.loads(done.out) for node in system["nodes"]]

    assert nodes("--library", "library") == ["/none_node", "/robot/drive"]
    assert nodes() == []
    done = rosarch("check", "robot", "--library", "library", "--format", "json")
    found = json.loads(done.out)
    assert "underlay" not in found
    assert not any(str(library) in finding["file"] for finding in found["findings"])
    write(Path("robot"), {"package.xml": MANIFEST.format("robot").replace("ament_cmake", "catkin")})
    write(Path("robot"), {"launch/main.launch.xml": include.replace("find-pkg-share", "find")})
    assert nodes("--library", "library") == []  # what is for ROS 2 is not for ROS 1


def test_nothing_is_said_of_what_another_revision_may_have(library: Path, rosarch: Callable) -> None:
    include = """<launch>
  <include file="$(find-pkg-share base)/launch/base.launch.py"><arg name="speed" value="1"/><arg name="of_another" value="1"/></include>
  <include file="$(find-pkg-share base)/launch/of_another.launch.py"/>
  <node pkg="base" exec="of_another"/>
</launch>
"""
    files = {"package.xml": MANIFEST.format("robot").replace("other", "base"), "launch/main.launch.xml": include}
    write(Path("robot"), {**files, "CMakeLists.txt": "project(robot)\n"})

    def found(*options: str) -> set[str]:
        return {finding["check"] for finding in json.loads(rosarch("check", "robot", "--format", "json", *options).out)["findings"]}

    assert found("--library", "library") == set()
    assert found("--package-path", "src") == {"argument-without-use"}


def test_what_is_no_description_is_rejected(tmp_path: Path) -> None:
    path = PackagePath([tmp_path])
    write(tmp_path / "base", {"package.xml": MANIFEST.format("base")})
    for text in ("", "[]", "{", '{"launch_description": {"is": "Exit", "line": 1}}', '{"launch_description": ' + "[" * 100_000):
        write(tmp_path / "base", {"launch/x.launch.py.json": text})
        found = compose([str(tmp_path / "base/launch/x.launch.py.json")], {}, files=Files(path), environment={})
        assert [problem.message for problem in found.problems] == ["x.launch.py.json is no description of a launch"], text[:50]
