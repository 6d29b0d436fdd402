"""What packages install of what launch files name, as rows."""

from __future__ import annotations

from pathlib import Path

from rosarch.datalog import load_declarations
from rosarch.extractor.launch import Files, PackagePath, compose
from rosarch.extractor.manifest import rules_folder
from rosarch.extractor.workspace import discover
from rosarch.extractor.workspace.built import builds
from rosarch.models.system.builds import build_rows

MANIFEST = "<package format='3'><name>{}</name><export><build_type>ament_cmake</build_type></export></package>"
LAUNCH = """
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    share = get_package_share_directory('demo')
    here = os.path.dirname(__file__) if os.path.exists(os.path.join(share, 'config', 'maybe.yaml')) else share
    return LaunchDescription([
        Node(package='demo', executable='tool.py', parameters=[os.path.join(share, 'config', 'a.yaml')]),
        Node(package='demo', executable='gone', arguments=['-d', os.path.join(share, 'b.rviz')], parameters=[{'map': share + '/c.yaml'}]),
        Node(package='open', executable='x', arguments=[os.path.join(get_package_share_directory('open'), 'd.yaml')]),
    ])
"""
BESIDE = LAUNCH.replace("share = get_package_share_directory('demo')", "share = os.path.dirname(os.path.dirname(__file__))")


def rows(root: Path, launch: str) -> dict[str, set[tuple[object, ...]]]:
    demo, other = root / "demo", root / "open"
    for folder in (demo / "config", demo / "launch", other):
        folder.mkdir(parents=True, exist_ok=True)
    for folder in (demo, other):
        (folder / "package.xml").write_text(MANIFEST.format(folder.name))
    for name in ("config/a.yaml", "config/maybe.yaml", "tool.py"):
        (demo / name).write_text("{}")
    (demo / "CMakeLists.txt").write_text(
        "install(PROGRAMS tool.py DESTINATION lib/demo)\ninstall(DIRECTORY config DESTINATION share/demo)\n"
    )
    (other / "CMakeLists.txt").write_text("install_all()\n")
    (demo / "launch" / "a.launch.py").write_text(launch)
    composition = compose([demo / "launch" / "a.launch.py"], files=Files(PackagePath([root])))
    return build_rows(composition, builds(discover(root)), root)


def test_rows(tmp_path: Path) -> None:
    found = rows(tmp_path, LAUNCH.replace("os.path.dirname(__file__)", "share"))
    assert found["package_built_with"] == {("demo", "ament_cmake"), ("open", "ament_cmake")}
    assert found["installs_open"] == {("open", "unknown command install_all", "open/CMakeLists.txt:1:1")}
    assert found["file_in_package"] == {
        ("demo/config/a.yaml", "demo", "config/a.yaml"),
        ("demo/b.rviz", "demo", "b.rviz"),
        ("demo/c.yaml", "demo", "c.yaml"),
        ("open/d.yaml", "open", "d.yaml"),
    }
    assert found["path_installed"] == {("demo", "config/a.yaml")}
    assert found["program_installed"] == {("demo", "tool.py")}
    declared = load_declarations(rules_folder() / "schema" / "build.dl")
    assert set(declared) == set(found) - {"place"}
    for name in declared:
        assert {len(row) for row in found[name]} == {len(declared[name].attributes)}, name


def test_files_beside_a_launch_file_that_is_not_where_it_is_installed(tmp_path: Path) -> None:
    assert {file for file, *_ in rows(tmp_path, BESIDE)["file_in_package"]} == set()
