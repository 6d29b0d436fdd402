"""What packages install of what launch files name, as rows."""

from __future__ import annotations

from pathlib import Path

from rosarch.analysis.systems.builds.rows import build_rows
from rosarch.datalog import load_declarations
from rosarch.extractor.launch import Files, PackagePath, compose
from rosarch.extractor.manifest import rules_folder
from rosarch.extractor.workspace import discover
from rosarch.extractor.workspace.built import builds

MANIFEST = "<package format='3'><name>{}</name><export><build_type>ament_cmake</build_type></export></package>"
LAUNCH = """
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode

def generate_launch_description():
    share = get_package_share_directory('demo')
    here = os.path.dirname(__file__) if os.path.exists(os.path.join(share, 'config', 'maybe.yaml')) else share
    return LaunchDescription([
        Node(package='demo', executable='tool.py', parameters=[os.path.join(share, 'config', 'a.yaml')]),
        Node(package='demo', executable='gone', arguments=['-d', os.path.join(share, 'b.rviz')], parameters=[{'map': share + '/c.yaml'}]),
        Node(package='kitchen', executable='cook'),
        Node(package='demo', executable='plain.py'),
        Node(package='demo', executable='oven'),
        ComposableNodeContainer(package='rclcpp_components', executable='component_container', name='box', namespace='', composable_node_descriptions=[
            ComposableNode(package='demo', plugin='demo::Part')]),
        Node(package='open', executable='x', arguments=[os.path.join(get_package_share_directory('open'), 'd.yaml')]),
    ])
"""
SETUP = """from setuptools import setup
setup(name='kitchen', packages=['kitchen'], entry_points={'console_scripts': [
    'cook = kitchen.cook:main', 'bake = kitchen.bake:main', 'boil = kitchen.stove.boil:main']})
"""
POINTS = (("cook", "kitchen.cook"), ("bake", "kitchen.bake"), ("boil", "kitchen.stove.boil"))
BESIDE = LAUNCH.replace("share = get_package_share_directory('demo')", "share = os.path.dirname(os.path.dirname(__file__))")


def rows(root: Path, launch: str) -> dict[str, set[tuple[object, ...]]]:
    demo, other = root / "demo", root / "open"
    for folder in (demo / "config", demo / "launch", other):
        folder.mkdir(parents=True, exist_ok=True)
    for folder in (demo, other):
        (folder / "package.xml").write_text(MANIFEST.format(folder.name))
    for name in ("config/a.yaml", "config/maybe.yaml", "tool.py"):
        (demo / name).write_text("{}")
    cmake = (
        "install(PROGRAMS tool.py DESTINATION lib/demo)\ninstall(DIRECTORY config DESTINATION share/demo)\nadd_library(part SHARED part.cpp gone.cpp)\n"
        'rclcpp_components_register_nodes(part "demo::Part")\npluginlib_export_plugin_description_file(base plugins.xml)\n'
        "pluginlib_export_plugin_description_file(base gone.xml)\nament_package()\n"
        "install(FILES plain.py DESTINATION lib/demo)\nfind_package(rclcpp)\nament_target_dependencies(part rclcpp)\n"
        "add_executable(oven oven.cpp)\ninstall(TARGETS oven part LIBRARY DESTINATION lib DESTINATION lib/demo)\n"  # both for the library
    )
    (demo / "CMakeLists.txt").write_text(cmake)
    (demo / "part.cpp").write_text(
        "#include <std_msgs/msg/bool.hpp>\nRCLCPP_COMPONENTS_REGISTER_NODE(demo::Other)\nPLUGINLIB_EXPORT_CLASS(demo::plugins, base::Other)\n"
    )
    for name in ("plugins", "more"):
        text = f'<library path="{name}"><class name="demo/{name}" type="demo::{name}" base_class_type="base::Base"/></library>'
        (demo / f"{name}.xml").write_text(text)
    kitchen = root / "kitchen"
    (kitchen / "kitchen").mkdir(parents=True)
    (kitchen / "package.xml").write_text(MANIFEST.format("kitchen").replace("ament_cmake", "ament_python"))
    (kitchen / "setup.py").write_text(SETUP)
    for name in ("__init__", "cook", "stove/boil"):
        (kitchen / "kitchen" / f"{name}.py").parent.mkdir(exist_ok=True)
        (kitchen / "kitchen" / f"{name}.py").touch()
    (other / "CMakeLists.txt").write_text("install_all()\n")
    (demo / "launch" / "a.launch.py").write_text(launch)
    composition = compose([demo / "launch" / "a.launch.py"], files=Files(PackagePath([root])))
    return build_rows(composition, builds(discover(root)), root)


def test_rows(tmp_path: Path) -> None:
    found = rows(tmp_path, LAUNCH.replace("os.path.dirname(__file__)", "share"))
    assert found["package_built_with"] == {("demo", "ament_cmake"), ("open", "ament_cmake"), ("kitchen", "ament_python")}
    assert found["installs_open"] == {("open", "unknown command install_all", "open/CMakeLists.txt:1:1")}
    assert found["file_in_package"] == {
        ("demo/config/a.yaml", "demo", "config/a.yaml"),
        ("demo/b.rviz", "demo", "b.rviz"),
        ("demo/c.yaml", "demo", "c.yaml"),
        ("open/d.yaml", "open", "d.yaml"),
    }
    assert found["path_installed"] == {("demo", "config/a.yaml")}
    assert found["program_copied_plainly"] == {("demo/CMakeLists.txt:8:1", "demo", "plain.py")}
    assert found["program_installed_elsewhere"] == {("demo/CMakeLists.txt:12:1", "demo", "oven", "bin/oven")}
    assert found["program_installed"] == {("demo", "tool.py"), ("demo", "plain.py"), ("kitchen", "cook")}
    assert {row[2:] for row in found["entry_point"]} == {(name, module, "main") for name, module in POINTS}
    assert found["entry_function_absent"] == {("kitchen", "kitchen.cook", "main")}
    assert found["entry_module_absent"] == {("kitchen", "kitchen.bake")}
    assert found["entry_module_left_out"] == {("kitchen", "kitchen.stove.boil", "kitchen.stove")}
    assert found["component_promised"] == {("demo/CMakeLists.txt:4:1", "demo", "part", "demo::Part")}
    assert found["class_registered"] == {("demo", "part", "demo::Other"), ("demo", "part", "demo::plugins")}
    assert found["library_misnamed"] == {("demo/plugins.xml:1:1", "demo", "plugins", "part", "demo::plugins")}
    assert found["plugin_base_described"] == {
        ("demo/CMakeLists.txt:4:1", "demo", "part", "demo::Part", "rclcpp_components"),
        ("demo/plugins.xml:1:1", "demo", "part", "demo::plugins", "base::Base"),
    }
    assert found["plugin_base_registered"] == {("demo", "part", "demo::plugins", "base::Other")}
    assert found["registering_open"] == {("demo", "part")}  # for a source that is not there
    assert found["plugin_exported"] == {("demo/plugins.xml:1:1", "demo", name) for name in ("demo/plugins", "demo::plugins")}
    assert found["plugin_exported_for"] == {("demo/CMakeLists.txt:5:1", "demo", "base", name) for name in ("demo/plugins", "demo::plugins")}
    assert found["plugin_left_out"] == {("demo/CMakeLists.txt:7:1", "demo", "more.xml", name) for name in ("demo/more", "demo::more")}
    assert found["descriptions_open"] == {("demo",)}
    declared = load_declarations(rules_folder() / "schema" / "build.dl")
    assert set(declared) == set(found) - {"place"}
    for name in declared:
        assert {len(row) for row in found[name]} == {len(declared[name].attributes)}, name


def test_files_beside_a_launch_file_that_is_not_where_it_is_installed(tmp_path: Path) -> None:
    assert {file for file, *_ in rows(tmp_path, BESIDE)["file_in_package"]} == set()


def test_classes_that_descriptions_promise(tmp_path: Path) -> None:
    demo = tmp_path / "demo"
    demo.mkdir()
    (demo / "package.xml").write_text(MANIFEST.format("demo"))
    text = '<library path="{}">\n<class name="demo/{}" type="demo::{}" base_class_type="base::Base"/></library>'
    for name, library in (("Part", "lib/libpart"), ("Other", "part"), ("Left", "part"), ("Far", "elsewhere")):
        (demo / f"{name}.xml").write_text(text.format(library, name, name))
    exports = "".join(f"pluginlib_export_plugin_description_file(base {name}.xml)\n" for name in ("Part", "Other", "Far"))
    (demo / "CMakeLists.txt").write_text(f"add_library(part SHARED part.cpp)\n{exports}ament_package()\n")
    (demo / "part.cpp").write_text("PLUGINLIB_EXPORT_CLASS(demo::Other, base::Base)\n")
    (demo / "a.launch").write_text("<launch/>")
    found = build_rows(compose([demo / "a.launch"], files=Files(PackagePath([tmp_path]))), builds(discover(tmp_path)), tmp_path)
    assert found["component_promised"] == {
        ("demo/Part.xml:2:1", "demo", "part", "demo::Part"), ("demo/Other.xml:2:1", "demo", "part", "demo::Other")
    }  # fmt: skip
    assert found["class_registered"] == {("demo", "part", "demo::Other")}
    assert found["plugin_base_registered"] == {("demo", "part", "demo::Other", "base::Base")}
    assert found["library_misnamed"] == set()  # nothing registers the class of the library that is elsewhere
    assert found["registering_open"] == set()


def test_a_library_that_may_be_called_so(tmp_path: Path) -> None:
    demo = tmp_path / "demo"
    demo.mkdir()
    (demo / "package.xml").write_text(MANIFEST.format("demo"))
    (demo / "Part.xml").write_text(
        '<library path="lib/libparts"><class name="demo/Part" type="demo::Part" base_class_type="base::Base"/></library>'
    )
    (demo / "part.cpp").write_text("PLUGINLIB_EXPORT_CLASS(demo::Part, base::Base)\n")
    (demo / "a.launch").write_text("<launch/>")
    renamed = "set_target_properties(part PROPERTIES OUTPUT_NAME parts)\n"
    for more, expected in (("", {"part"}), (renamed, set())):
        exports = "pluginlib_export_plugin_description_file(base Part.xml)\n"
        (demo / "CMakeLists.txt").write_text(f"add_library(part SHARED part.cpp)\n{more}{exports}ament_package()\n")
        found = build_rows(compose([demo / "a.launch"], files=Files(PackagePath([tmp_path]))), builds(discover(tmp_path)), tmp_path)
        assert {row[3] for row in found["library_misnamed"]} == expected, more


def test_programs_whose_folder_the_build_says(tmp_path: Path) -> None:
    """What CMAKE_INSTALL_BINDIR and folders that the build makes bring is where programs are looked for."""
    launch = """
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='demo', executable='oven'), Node(package='demo', executable='pan')])
"""
    made = "install(TARGETS pan)\ninstall(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/made/ DESTINATION lib/demo)\n"
    for name, text, elsewhere in (
        ("set", "set(CMAKE_INSTALL_BINDIR lib/demo)\ninstall(TARGETS oven pan)\n", set()),
        ("made", made, set()),
        ("plain", "install(TARGETS pan)\n", {"bin/pan"}),
    ):
        root = tmp_path / name
        (root / "demo").mkdir(parents=True)
        (root / "demo" / "package.xml").write_text(MANIFEST.format("demo"))
        programs = "add_executable(oven oven.cpp)\nadd_executable(pan pan.cpp)\n"
        (root / "demo" / "CMakeLists.txt").write_text(f"project(demo)\n{programs}{text}ament_package()\n")
        (root / "demo" / "oven.cpp").write_text("int main() {}\n")
        (root / "demo" / "pan.cpp").write_text("int main() {}\n")
        (root / "a.launch.py").write_text(launch)
        composition = compose([root / "a.launch.py"], files=Files(PackagePath([root])))
        found = build_rows(composition, builds(discover(root)), root)
        assert {path for *_, path in found["program_installed_elsewhere"]} == elsewhere
