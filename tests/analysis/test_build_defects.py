"""What shows in build files, scripts and interfaces alone that keeps a package from being built or used."""

from __future__ import annotations

from pathlib import Path

from rosarch.analysis.systems.build_defects import defects, of_interfaces
from rosarch.extractor.launch import Files, PackagePath, compose
from rosarch.extractor.launch_ros2.compose import compose_ros2
from rosarch.extractor.workspace import discover
from rosarch.extractor.workspace.built import Built, builds

GROUP = "<member_of_group>rosidl_interface_packages</member_of_group>"
LAUNCH = '<launch><node pkg="{}" exec="{}"/></launch>'


def manifest(name: str, build_type: str, more: str = "") -> str:
    return (
        f'<package format="3"><name>{name}</name><version>1.0.0</version><description>d</description>\n'
        f'<maintainer email="a@example.com">m</maintainer><license>MIT</license><buildtool_depend>{build_type}</buildtool_depend>\n'
        f"{more}<export><build_type>{build_type}</build_type></export></package>\n"
    )


def built(root: Path, name: str, build_type: str, more: str = "", **files: str) -> Built:
    for path, text in {"package.xml": manifest(name, build_type, more), **files}.items():
        (root / name / path).parent.mkdir(parents=True, exist_ok=True)
        (root / name / path).write_text(text, newline="")
    return next(one for one in builds(discover(root)) if one.name == name)


def interfaces(root: Path, listed: str, more: str = GROUP, **files: str) -> list[tuple[str, int, str, str]]:
    cmake = (
        f"project(lamp)\nfind_package(ament_cmake REQUIRED)\nrosidl_generate_interfaces(${{PROJECT_NAME}}\n  {listed})\nament_package()\n"
    )
    one = built(root, "lamp", "ament_cmake", more, **{"CMakeLists.txt": cmake, "msg/Dim.msg": "float32 level  # of light\n", **files})
    return [(each.path.name, each.line, each.kind, each.about) for each in of_interfaces(one)]


def test_interfaces_that_are_generated(tmp_path: Path) -> None:
    message = "# a comment With Words\nuint8 OFF=0\nstring<=10[<=3] names\nstd_msgs/Header header\nfloat64[3] x_1\nint8 n 5\n"
    assert interfaces(tmp_path, '"msg/Dim.msg"\n  "msg/Hue.msg"', **{"msg/Hue.msg": message}) == []


def test_interfaces_that_are_not(tmp_path: Path) -> None:
    assert interfaces(tmp_path / "a", '"msg/Dim.msg"', **{"msg/Hue.msg": "float32 x\n"}) == [
        ("CMakeLists.txt", 3, "interface left out", "lamp/Hue")
    ]
    assert interfaces(tmp_path / "b", '"msg/Dim.msg" "srv/Off.srv"') == [("CMakeLists.txt", 4, "interface file", "srv/Off.srv")]
    assert interfaces(tmp_path / "c", '"msg/Dim.msg"', more="") == [("package.xml", 1, "interface group", "")]
    bad = "float32 maxLevel\nfloat32 a__b\nfloat32 ends_\n"
    assert interfaces(tmp_path / "d", '"msg/Dim.msg"', **{"msg/Dim.msg": bad}) == [
        ("Dim.msg", 1, "field name", "maxLevel"),
        ("Dim.msg", 2, "field name", "a__b"),
        ("Dim.msg", 3, "field name", "ends_"),
    ]
    # a list that is not known leaves nothing out
    assert interfaces(tmp_path / "e", "${FILES}", **{"msg/Hue.msg": "float32 x\n"}) == []


def kinds(root: Path, package: Built, program: str) -> list[tuple[str, str]]:
    launch = root / "main.launch.xml"
    launch.write_text(LAUNCH.format(package.name, program))
    composition = compose_ros2([launch], files=Files(PackagePath([root])))
    return [(each.path.name, each.kind) for _, each in defects(composition, [package])]


def test_scripts(tmp_path: Path) -> None:
    cmake = "project(lamp)\nfind_package(ament_cmake REQUIRED)\ninstall(PROGRAMS a.py b.py c.py DESTINATION lib/lamp)\nament_package()\n"
    files = {"a.py": "#!/usr/bin/env python3\n", "b.py": "#!/usr/bin/env python3\r\nimport os\r\n", "c.py": "import os\n"}
    package = built(tmp_path, "lamp", "ament_cmake", **{"CMakeLists.txt": cmake, **files})
    found = [kinds(tmp_path, package, name) for name in ("a.py", "b.py", "c.py", "d.py")]
    assert found == [[], [("b.py", "carriage return")], [("c.py", "no interpreter")], []]


def test_where_programs_are_installed(tmp_path: Path) -> None:
    setup = "from setuptools import setup\nsetup(name='lamp', packages=['lamp'], entry_points={'console_scripts': ['on = lamp.on:main']})\n"
    here = {"setup.py": setup, "lamp/__init__.py": "", "lamp/on.py": "def main(): pass\n"}
    assert kinds(tmp_path, built(tmp_path, "lamp", "ament_python", **here), "on") == [("setup.py", "programs elsewhere")]
    right = "[develop]\nscript_dir=$base/lib/lamp\n[install]\ninstall_scripts=$base/lib/lamp\n"
    assert kinds(tmp_path, built(tmp_path, "lamp", "ament_python", **here, **{"setup.cfg": right}), "on") == []
    older = right.replace("install_scripts", "install-scripts")
    assert kinds(tmp_path, built(tmp_path, "lamp", "ament_python", **here, **{"setup.cfg": older}), "on") == []
    other = right.replace("lib/lamp", "lib/lamps")
    package = built(tmp_path, "lamp", "ament_python", **here, **{"setup.cfg": other})
    assert kinds(tmp_path, package, "on") == [("setup.cfg", "programs elsewhere")]
    assert kinds(tmp_path, package, "off") == []


def test_launch_files(tmp_path: Path) -> None:
    cmake = "project(lamp)\nfind_package(ament_cmake REQUIRED)\n{}ament_package()\n"
    install = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"
    for text, expected in ((cmake.format(""), ["launch/a.launch.xml"]), (cmake.format(install), [])):
        package = built(tmp_path, "lamp", "ament_cmake", **{"CMakeLists.txt": text, "launch/a.launch.xml": LAUNCH.format("other", "a")})
        composition = compose_ros2([tmp_path / "lamp" / "launch" / "a.launch.xml"], files=Files(PackagePath([tmp_path])))
        assert [each.about for _, each in defects(composition, [package])] == expected
    assert list(defects(compose([tmp_path / "lamp" / "launch" / "a.launch.xml"], files=Files(PackagePath([tmp_path]))), [package])) == []
