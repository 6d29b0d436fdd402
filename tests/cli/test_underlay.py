"""What is installed beneath a workspace is read like what is in it; findings lie in the workspace."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from rosarch.extractor.underlay import VARIABLES, environment_underlay
from tests.extractor.workspace_builder import write

MANIFEST = """<package format="3"><name>{name}</name><version>1.0.0</version><description>d</description>
<maintainer email="m@example.com">m</maintainer><license>BSD</license><buildtool_depend>ament_cmake</buildtool_depend>
{depends}<export><build_type>ament_cmake</build_type></export></package>
"""
INDEX = "share/ament_index/resource_index"
SITE = "lib/python3.10/site-packages"
SCAN = """import rclpy
from rclpy.node import Node
from level_msgs.msg import Level
from lidar_driver.names import TOPIC

class Scan(Node):
    def __init__(self):
        super().__init__("scan")
        self.out = self.create_publisher(Level, TOPIC, 10)

def main():
    rclpy.init()
    rclpy.spin(Scan())
"""
WATCHER = """#include <rclcpp/rclcpp.hpp>
#include <level_msgs/msg/level.hpp>
#include <lidar_driver/base.hpp>
class Watcher : public lidar_driver::Base {
 public:
  Watcher() : Base("watcher") {
    in_ = create_subscription<level_msgs::msg::Level>("level", 10, [](level_msgs::msg::Level::SharedPtr) {});
  }
  rclcpp::Subscription<level_msgs::msg::Level>::SharedPtr in_;
};
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Watcher>());
}
"""
BASE = """#include <rclcpp/rclcpp.hpp>
#include <level_msgs/msg/level.hpp>
namespace lidar_driver {
class Base : public rclcpp::Node {
 public:
  explicit Base(const std::string& name) : Node(name) { alive_ = create_publisher<level_msgs::msg::Level>("alive", 1); }
  rclcpp::Publisher<level_msgs::msg::Level>::SharedPtr alive_;
};
}
"""
LIDAR_LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node
from lidar_driver.names import PROGRAM
def generate_launch_description():
    return LaunchDescription([
        Node(package="lidar_driver", executable=PROGRAM, name="scan"),
        Node(package="lidar_driver", executable="filter", name="filter"),
    ])
"""
MAIN_LAUNCH = """<launch>
  <include file="$(find-pkg-share lidar_driver)/launch/lidar.launch.py"/>
  <node pkg="robot" exec="watcher" name="watcher"/>
</launch>
"""


def installed(prefix: Path, files: Mapping[str, str | bytes] | None = None) -> None:
    """Packages as build tools install them: a driver, with a program in Python and one that is compiled, and messages."""
    write(
        prefix,
        {
            "setup.sh": "exit 1\n",
            "share/lidar_driver/package.xml": MANIFEST.format(name="lidar_driver", depends="<depend>level_msgs</depend>"),
            "share/lidar_driver/launch/lidar.launch.py": LIDAR_LAUNCH,
            "share/level_msgs/package.xml": MANIFEST.format(name="level_msgs", depends=""),
            "share/level_msgs/msg/Level.msg": "int32 value\n",
            "lib/lidar_driver/scan": "#!/usr/bin/python3\nimport sys\nsys.exit(load_entry_point('lidar-driver==1', 'console_scripts', 'scan')())\n",
            "lib/lidar_driver/filter": b"\x7fELF\x00\x00",
            f"{SITE}/lidar_driver-1.0.0-py3.10.egg-info/entry_points.txt": "[console_scripts]\nscan = lidar_driver.node:main\n",
            f"{SITE}/lidar_driver/__init__.py": "",
            f"{SITE}/lidar_driver/node.py": SCAN,
            f"{SITE}/lidar_driver/names.py": "TOPIC = 'level'\nPROGRAM = 'scan'\n",
            "include/lidar_driver/lidar_driver/base.hpp": BASE,
            **(files or {}),
        },
    )


@pytest.fixture
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A workspace `ws` below the current folder, beside the prefix `opt`."""
    needs = "".join(f"<depend>{name}</depend>" for name in ("rclcpp", "level_msgs", "lidar_driver"))
    write(
        tmp_path / "ws/robot",
        {
            "package.xml": MANIFEST.format(name="robot", depends=needs),
            "CMakeLists.txt": "project(robot)\nfind_package(ament_cmake REQUIRED)\nfind_package(rclcpp REQUIRED)\n"
            "find_package(level_msgs REQUIRED)\nfind_package(lidar_driver REQUIRED)\nadd_executable(watcher watcher.cpp)\n"
            "ament_target_dependencies(watcher rclcpp level_msgs lidar_driver)\ninstall(TARGETS watcher DESTINATION lib/robot)\n"
            "install(DIRECTORY launch DESTINATION share/robot)\nament_package()\n",
            "watcher.cpp": WATCHER,
            "launch/main.launch.xml": MAIN_LAUNCH,
        },
    )
    installed(tmp_path / "opt")
    monkeypatch.chdir(tmp_path)
    return tmp_path / "ws/robot"


def graph(rosarch: Callable, *options: str) -> tuple[dict[str, str], set[str]]:
    """The nodes of the only system with the origins of their models, and what connects them."""
    done = rosarch("show", "graph", "ws", "--format", "json", *options)
    assert done.code == 0, done.err
    [system] = json.loads(done.out)
    types = {one["id"]: f"{one['names'][0]} {' '.join(one['types'])}" for one in system["connectors"]}
    edges = {f"{types.get(one['source'], one['source'])} > {types.get(one['target'], one['target'])}" for one in system["edges"]}
    return {node["name"]: node["origin"] for node in system["nodes"]}, edges


UNDERLAY = ("--underlay", "opt")
WHOLE = {"/scan": "source", "/filter": "unknown", "/watcher": "source"}
CONNECTED = {"node:/scan > /level level_msgs/Level", "/level level_msgs/Level > node:/watcher"}
ALIVE = "node:/watcher > /alive level_msgs/Level"
ALONE = {"/watcher": "source"}, {"/level level_msgs/Level > node:/watcher"}


def test_what_is_installed_is_composed_with_the_workspace(rosarch: Callable, robot: Path) -> None:
    nodes, edges = graph(rosarch, *UNDERLAY)
    assert nodes == WHOLE
    assert edges >= CONNECTED | {ALIVE}  # the second is made by the constructor of a base class in an installed header
    assert graph(rosarch) == graph(rosarch, "--no-underlay") == ALONE
    done = rosarch("check", "ws", *UNDERLAY)
    assert (done.code, done.out.splitlines()[-1].partition("; ")[2]) == (0, f"with 2 packages installed below {Path('opt').absolute()}")
    assert json.loads(rosarch("check", "ws", *UNDERLAY, "--format", "json").out)["underlay"] == {
        "prefixes": [str(Path("opt").absolute())],
        "packages": 2,
    }
    assert "installed" not in rosarch("check", "ws").out
    assert "lidar_driver/scan" in rosarch("launch", robot / "launch/main.launch.xml", *UNDERLAY).out


@pytest.mark.parametrize("variable", VARIABLES)
def test_the_environment_names_prefixes(rosarch: Callable, robot: Path, monkeypatch: pytest.MonkeyPatch, variable: str) -> None:
    below = "opt/share" if variable == "ROS_PACKAGE_PATH" else "opt"
    monkeypatch.setenv(variable, f"/nowhere{os.pathsep}{Path(below).absolute()}{os.pathsep}relative")
    assert graph(rosarch)[0] == WHOLE
    assert graph(rosarch, "--no-underlay") == ALONE


def test_a_distribution_is_found_where_it_is_usual(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosarch.extractor.underlay.DISTRIBUTIONS", str(tmp_path))
    installed(tmp_path / "humble")
    assert environment_underlay({}).prefixes == (f"{tmp_path}/humble",)
    installed(tmp_path / "jazzy")
    assert environment_underlay({}).prefixes == ()  # which one is not said
    assert environment_underlay({"ROS_DISTRO": "jazzy"}).prefixes == (f"{tmp_path}/jazzy",)


def test_a_prefix_for_each_package(rosarch: Callable, robot: Path) -> None:
    write(Path("opt/lidar_driver"), {"share/lidar_driver/package.xml": ""})
    shutil.rmtree("opt/lidar_driver")
    for package in ("lidar_driver", "level_msgs"):
        Path("each", package, "share").mkdir(parents=True)
        Path("opt/share", package).rename(Path("each", package, "share", package))
    for part in ("lib", "include"):
        Path("opt", part).rename(Path("each/lidar_driver", part))
    nodes, edges = graph(rosarch, "--underlay", "each")
    assert nodes == WHOLE
    assert edges >= CONNECTED | {ALIVE}


def test_a_package_of_the_workspace_hides_an_installed_one(rosarch: Callable, robot: Path) -> None:
    write(
        robot.parent / "lidar_driver",
        {
            "package.xml": MANIFEST.format(name="lidar_driver", depends=""),
            "CMakeLists.txt": "project(lidar_driver)\ninstall(DIRECTORY launch DESTINATION share/lidar_driver)\n",
            "launch/lidar.launch.py": LIDAR_LAUNCH.replace('"filter"', '"other"').replace("=PROGRAM", '="scan"'),
        },
    )
    nodes, edges = graph(rosarch, *UNDERLAY)
    assert nodes == {"/scan": "unknown", "/other": "unknown", "/watcher": "source"}
    assert ALIVE not in edges


def test_an_installed_package_hides_what_the_library_says(rosarch: Callable, robot: Path) -> None:
    ports = [{"kind": "publisher", "name": "filtered", "type": "level_msgs/Level"}]
    known = [{"component": name, "kind": "node", "ports": ports} for name in ("scan", "filter", "absent")]
    library = {"package": "lidar_driver", "origin": "o", "revision": "1", "ros": [2], "made": "by hand", "components": known}
    launch = LIDAR_LAUNCH.replace("    ])", '        Node(package="lidar_driver", executable="absent", name="absent"),\n    ])')
    write(Path(), {"library/l.json": json.dumps(library), "opt/share/lidar_driver/launch/lidar.launch.py": launch})
    nodes, edges = graph(rosarch, *UNDERLAY, "--library", "library")
    assert nodes == {"/scan": "source", "/filter": "library", "/absent": "unknown", "/watcher": "source"}
    assert "node:/filter > /filtered level_msgs/Level" in edges
    assert "node:/scan > /filtered level_msgs/Level" not in edges


def test_findings_lie_in_the_workspace(rosarch: Callable, robot: Path) -> None:
    write(
        robot,
        {
            "watcher.cpp": WATCHER.replace("level_msgs::msg::Level", "std_msgs::msg::Bool")
            .replace("level_msgs", "std_msgs")
            .replace("/level.", "/bool.")
        },
    )
    [finding] = json.loads(rosarch("check", "ws", *UNDERLAY, "--format", "json").out)["findings"]
    assert (finding["check"], finding["file"]) == ("topic-type-mismatch", "robot/watcher.cpp")
    shown = {step["file"] for step in finding["evidence"]}
    assert f"{Path(f'opt/{SITE}').absolute()}/lidar_driver/node.py" in shown
    write(robot, {"watcher.cpp": WATCHER})
    write(Path("opt", SITE), {"lidar_driver/node.py": SCAN.replace("rclpy.init()", "rclpy.init()\n    Scan().absent()")})
    assert json.loads(rosarch("check", "ws", *UNDERLAY, "--format", "json").out)["findings"] == []


def change(file: str, old: str, new: str) -> Callable[[], object]:
    return lambda: Path("opt", file).write_text(Path("opt", file).read_text().replace(old, new))


CHANGES = {
    "launch file": change("share/lidar_driver/launch/lidar.launch.py", 'name="filter"', 'name="sieve"'),
    "module": change(f"{SITE}/lidar_driver/names.py", "level", "height"),
    "entry point": change(f"{SITE}/lidar_driver-1.0.0-py3.10.egg-info/entry_points.txt", "main", "other"),
    "header": change("include/lidar_driver/lidar_driver/base.hpp", '"alive"', '"living"'),
    "message": lambda: Path("opt/share/level_msgs/msg/Level.msg").unlink(),
    "program that is gone": lambda: Path("opt/lib/lidar_driver/scan").unlink(),
    "package that is gone": lambda: shutil.rmtree("opt/share/lidar_driver"),
    "module that was missing": lambda: Path("opt", SITE, "lidar_driver/late.py").write_text("LATE = 'late'\n"),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_a_change_of_what_is_installed(rosarch: Callable, robot: Path, change: Callable[[], object]) -> None:
    more = SCAN.replace("class Scan", "from lidar_driver.late import LATE\n\nclass Scan")
    more = more.replace("TOPIC, 10)", "TOPIC, 10)\n        self.more = self.create_publisher(Level, LATE, 10)")
    write(Path("opt", SITE), {"lidar_driver/node.py": more})

    def answers(*options: str) -> list[str]:
        return [rosarch("check", "ws", "-v", *options).out, *(rosarch("show", "graph", "ws", *UNDERLAY, *options).out,)]

    before = answers(*UNDERLAY)
    assert before == answers(*UNDERLAY)
    change()
    after = answers(*UNDERLAY)
    assert after == answers(*UNDERLAY, "--no-cache")
    assert after != before or change is CHANGES["message"]


@pytest.mark.slow
def test_a_hostile_prefix_is_harmless(rosarch: Callable, robot: Path, tmp_path: Path) -> None:
    secret = tmp_path / "secret"
    write(Path("opt"), {"share/lidar_driver/launch/lidar.launch.py": LIDAR_LAUNCH.replace("=PROGRAM", '="scan"')})
    write(
        secret, {"package.xml": MANIFEST.format(name="secret", depends=""), "key.msg": "int32 the_secret\n", "key.py": "the_secret = 1\n"}
    )
    top = Path("opt/share")
    (top / "loop").symlink_to("loop")
    (top / "again").symlink_to(".")
    (top / "secret").symlink_to(secret)
    (top / "level_msgs/msg/Secret.msg").symlink_to(secret / "key.msg")
    (top / "level_msgs/srv").symlink_to("..")
    (Path("opt", SITE) / "lidar_driver/names.py").unlink()
    (Path("opt", SITE) / "lidar_driver/names.py").symlink_to(secret / "key.py")
    for name in ("share/lidar_driver/launch/pipe.launch.py", "lib/lidar_driver/pipe", "include/lidar_driver/lidar_driver/pipe.hpp"):
        os.mkfifo(Path("opt", name))
    write(
        Path("opt"),
        {
            "share/broken/package.xml": "<package><name>broken</name>",
            "share/other/package.xml": MANIFEST.format(name="..", depends=""),
            f"{INDEX}/rclcpp_components/lidar_driver": "../../../../etc/passwd;" * 1000,
            f"{INDEX}/rviz__pluginlib__plugin/lidar_driver": "../../../secret/package.xml\nshare/lidar_driver/absent.xml\n",
            "share/level_msgs/msg/Bytes.msg": b"\xff\xfe\x00" * 100,
            f"{SITE}/lidar_driver-2.dist-info/entry_points.txt": "no section\n[console_scripts]\n= x\n",
        },
    )
    os.truncate(os.open("opt/share/level_msgs/msg/Large.msg", os.O_CREAT | os.O_WRONLY), 1 << 40)
    launch = MAIN_LAUNCH.replace("</launch>", '<include file="$(find-pkg-share lidar_driver)/launch/pipe.launch.py"/></launch>')
    write(robot, {"launch/main.launch.xml": launch, "watcher.cpp": "#include <lidar_driver/pipe.hpp>\n" + WATCHER})
    done = rosarch("check", "ws", *UNDERLAY, "-v")
    assert done.code in (0, 1), done.err
    assert "the_secret" not in done.out + done.err
    assert "pipe.launch.py is not a regular file" in done.err
    assert graph(rosarch, *UNDERLAY)[0] == {"/scan": "source", "/filter": "unknown", "/watcher": "source"}


def test_what_options_are_refused(rosarch: Callable, robot: Path) -> None:
    assert rosarch("check", "ws", "--underlay", "ws").err == (
        "rosarch: error: --underlay ws: no package is installed there: no share/NAME/package.xml\n"
    )
    assert rosarch("check", "ws", *UNDERLAY, "--no-underlay").err == (
        "rosarch: error: --underlay and --no-underlay contradict each other\n"
    )
