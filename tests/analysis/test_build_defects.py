"""What shows in build files, scripts and interfaces alone that keeps a package from being built or used."""

from __future__ import annotations

from pathlib import Path

from rosarch.analysis.systems.builds.defects import defects
from rosarch.analysis.systems.builds.headers import of_own_headers
from rosarch.analysis.systems.builds.interfaces import of_interfaces
from rosarch.analysis.systems.builds.packages import of_build
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
    types = "Header header\nHue hue\nstd_msgs/Header other\nstring<=4[] names\nchar letter\nDim[2] dims\n"
    assert interfaces(tmp_path / "types", '"msg/Dim.msg" "msg/Hue.msg"', **{"msg/Dim.msg": types, "msg/Hue.msg": "time since\n"}) == [
        ("Dim.msg", 1, "field type", "Header"),
        ("Hue.msg", 1, "field type", "time"),
    ]
    names = {"msg/dim_light.msg": "float32 x\n", "srv/off.srv": "---\n"}
    assert interfaces(tmp_path / "names", '"msg/Dim.msg"\n  "msg/dim_light.msg" "srv/off.srv"', **names) == [
        ("CMakeLists.txt", 5, "interface name", "msg/dim_light.msg"),
        ("CMakeLists.txt", 5, "interface name", "srv/off.srv"),
    ]
    # a list that is not known leaves nothing out
    assert interfaces(tmp_path / "e", "${FILES}", **{"msg/Hue.msg": "float32 x\n"}) == []


def test_interfaces_that_variables_list(tmp_path: Path) -> None:
    def found(name: str, cmake: str, **files: str) -> list[tuple[str, int, str, str]]:
        messages = {"msg/Dim.msg": "float32 level\n", "msg/Hue.msg": "float32 level\n"}
        text = f"project(lamp)\nfind_package(ament_cmake REQUIRED)\n{cmake}\nament_package()\n"
        one = built(tmp_path / name, "lamp", "ament_cmake", GROUP, **{"CMakeLists.txt": text, **messages, **files})
        return [(each.path.name, each.line, each.kind, each.about) for each in of_interfaces(one)]

    generated = "rosidl_generate_interfaces(lamp ${listed})"
    assert found("a", f"set(listed\n  msg/Dim.msg\n  msg/Off.msg)\n{generated}") == [
        ("CMakeLists.txt", 5, "interface file", "msg/Off.msg"),
        ("CMakeLists.txt", 6, "interface left out", "lamp/Hue"),
    ]
    assert found("b", f"file(GLOB listed RELATIVE ${{CMAKE_CURRENT_SOURCE_DIR}} msg/*.msg)\n{generated}") == []
    # what a branch that is not taken here would generate is not left out
    other = "if(WITH_COLOUR)\n  rosidl_generate_interfaces(lamp_colour msg/Hue.msg)\nendif()"
    assert found("c", f"rosidl_generate_interfaces(lamp msg/Dim.msg)\n{other}") == []
    assert found("d", "add_subdirectory(msg)", **{"msg/CMakeLists.txt": "rosidl_generate_interfaces(lamp Dim.msg)"}) == [
        ("CMakeLists.txt", 1, "interface left out", "lamp/Hue")
    ]


def test_what_comes_after_catkin_package(tmp_path: Path) -> None:
    def found(name: str, cmake: str, **files: str) -> list[tuple[int, str, str]]:
        text = f"project(lamp)\nfind_package(catkin REQUIRED)\n{cmake}\n"
        one = built(tmp_path / name, "lamp", "catkin", **{"CMakeLists.txt": text, "msg/Dim.msg": "float32 level\n", **files})
        return [(each.line, each.kind, each.about) for each in of_interfaces(one)]

    assert found("a", "add_message_files()\ngenerate_messages()\ncatkin_package()") == []
    late = "catkin_package()\nadd_message_files()\ngenerate_messages()\ngenerate_dynamic_reconfigure_options()\ncatkin_python_setup()"
    assert found("b", late) == [
        (5, "after catkin_package", "generate_messages"),
        (6, "after catkin_package", "generate_dynamic_reconfigure_options"),
    ]
    # in another file, or in one of two branches
    assert found("c", "catkin_package()\nadd_subdirectory(msg)", **{"msg/CMakeLists.txt": "\n\n\ngenerate_messages()"}) == []
    assert found("d", "if(X)\ncatkin_package()\nelse()\ngenerate_messages()\ncatkin_package()\nendif()") == []


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


def test_launch_files_of_samples(tmp_path: Path) -> None:
    cmake = "project(lamp)\nfind_package(ament_cmake REQUIRED)\ninstall(FILES launch/a.launch.xml DESTINATION share/lamp/launch)\nament_package()\n"
    shown = {
        f"{folder}/{name}.launch.xml": LAUNCH.format("other", name)
        for folder, name in (("launch", "a"), ("sample", "b"), ("launch/c", "c"))
    }
    package = built(tmp_path, "lamp", "ament_cmake", **{"CMakeLists.txt": cmake, **shown})
    files = Files(PackagePath([tmp_path]))
    found = [each.about for path in shown for _, each in defects(compose_ros2([tmp_path / "lamp" / path], files=files), [package])]
    assert found == ["launch/c/c.launch.xml"]


def test_interfaces_of_ros1(tmp_path: Path) -> None:
    def found(name: str, calls: str, **files: str) -> list[tuple[int, str, str]]:
        cmake = f"project(lamp)\nfind_package(catkin REQUIRED COMPONENTS message_generation)\n{calls}\ncatkin_package()\n"
        messages = {"msg/Dim.msg": "float32 level\n", "msg/Hue.msg": "float32 level\n", "srv/Off.srv": "---\n"}
        one = built(tmp_path / name, "lamp", "catkin", **{"CMakeLists.txt": cmake, **messages, **files})
        return [(each.line, each.kind, each.about) for each in of_interfaces(one)]

    listed = "add_message_files(\n  FILES Dim.msg)\ngenerate_messages(DEPENDENCIES std_msgs)"
    assert found("a", listed) == [(3, "interface left out", "lamp/Hue")]
    assert found("b", "add_message_files()\nadd_service_files(FILES Off.srv)\ngenerate_messages()") == []
    assert found("c", "add_message_files(FILES Dim.msg Hue.msg)") == [(3, "interfaces not made", "")]
    assert found("d", "add_message_files(FILES ${ALL})\ngenerate_messages()") == []
    assert found("e", "add_message_files(FILES Dim.msg)\nadd_message_files(FILES Hue.msg)\ngenerate_messages()") == []
    assert found("f", "somebody_generates()\nadd_message_files(FILES Dim.msg)") == []
    assert found("g", "") == []


COMPONENTS = """project({})
find_package(rclcpp_components REQUIRED)
add_library(focus SHARED focus.cpp)
add_library(zoom SHARED zoom.cpp)
rclcpp_components_register_nodes(focus "lens::Focus")
rclcpp_components_register_nodes(zoom "lens::Zoom")
install(TARGETS zoom DESTINATION lib)
{}
ament_package()
"""
REGISTERS = "RCLCPP_COMPONENTS_REGISTER_NODE(lens::{})\n"


def build(root: Path, cmake: str, build_type: str = "ament_cmake", name: str = "lens", **files: str) -> list[tuple[str, int, str, str]]:
    sources = {"focus.cpp": REGISTERS.format("Focus"), "zoom.cpp": REGISTERS.format("Zoom")}
    one = built(root, name, build_type, **{"CMakeLists.txt": cmake, **sources, **files})
    return [(each.path.name, each.line, each.kind, each.about) for each in of_build(one)]


def test_libraries_that_are_not_installed(tmp_path: Path) -> None:
    cmake = COMPONENTS.format("lens", "")
    assert build(tmp_path / "a", cmake) == [("CMakeLists.txt", 3, "library left out", "focus")]
    assert build(tmp_path / "b", COMPONENTS.format("lens", "install(TARGETS focus EXPORT all LIBRARY DESTINATION lib)")) == []
    assert build(tmp_path / "c", COMPONENTS.format("lens", "install_somehow(focus)")) == []  # it may do that
    assert build(tmp_path / "d", cmake, "catkin") == []  # found where they are built
    auto = cmake.replace("add_library", "ament_auto_add_library").replace("ament_package", "ament_auto_package")
    assert build(tmp_path / "e", auto.replace("install(TARGETS zoom DESTINATION lib)\n", "")) == []


def test_sources_that_do_not_exist(tmp_path: Path) -> None:
    more = """add_executable(knob knbo.cpp)
install(TARGETS focus DESTINATION lib)
install(DIRECTORY launch params
  DESTINATION share/lens)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/made.yaml p.yaml empty/q.yaml DESTINATION share/lens)
install(DIRECTORY meshes absent/ DESTINATION share/lens OPTIONAL)
install(DIRECTORY meshes DESTINATION share/lens)
install(FILES robot.dae DESTINATION share/lens)
if(BUILD_TESTING)
  install(FILES tested.yaml DESTINATION share/lens)
endif()
"""
    found = [
        ("CMakeLists.txt", 8, "target source", "knbo.cpp"),
        ("CMakeLists.txt", 10, "install source", "params"),
        ("CMakeLists.txt", 12, "install source", "p.yaml"),
    ]
    (tmp_path / "a" / "lens" / "empty").mkdir(parents=True)
    assert build(tmp_path / "a", COMPONENTS.format("lens", more), **{"launch/a.launch": "<launch/>"}) == found
    assert build(tmp_path / "b", COMPONENTS.format("lens", more + 'execute_process(COMMAND "make")')) == []  # that may make them
    assert build(tmp_path / "c", COMPONENTS.format("lens", more), "catkin") == []
    setup = """from setuptools import setup
setup(name='lens', packages=[], data_files=[
    ('share/lens', ['package.xml', 'gone.yaml'])])
"""
    one = built(tmp_path / "d", "lens", "ament_python", **{"setup.py": setup})
    assert [(each.path.name, each.line, each.kind, each.about) for each in of_build(one)] == [
        ("setup.py", 3, "install source", "gone.yaml")
    ]


def test_targets_of_interfaces(tmp_path: Path) -> None:
    made = "project(lamp)\nfind_package(rosidl_default_generators)\nrosidl_generate_interfaces({} msg/Dim.msg)\nadd_{}\nament_package()\n"
    files = {"msg/Dim.msg": "float32 level\n", "src/lamp.cpp": "int main() {}\n"}

    def of_lamp(name: str, target: str, command: str) -> list[tuple[int, str, str]]:
        one = built(tmp_path / name, "lamp", "ament_cmake", GROUP, **{"CMakeLists.txt": made.format(target, command), **files})
        return [(each.line, each.kind, each.about) for each in of_build(one)]

    assert of_lamp("a", "${PROJECT_NAME}", "executable(lamp src/lamp.cpp)") == [(4, "target twice", "lamp")]
    assert of_lamp("b", "lamp", "library(${PROJECT_NAME} src/lamp.cpp)") == [(4, "target twice", "lamp")]
    assert of_lamp("c", "lamp_interfaces", "executable(lamp src/lamp.cpp)") == []
    assert of_lamp("d", "lamp", "executable(lamp_node src/lamp.cpp)") == []
    assert of_lamp("e", "lamp", "library(lamp SHARED IMPORTED)") == []
    assert of_lamp("f", "${UNKNOWN}", "executable(lamp src/lamp.cpp)") == []


def test_names_and_build_types(tmp_path: Path) -> None:
    all_installed = "install(TARGETS focus DESTINATION lib)"
    assert build(tmp_path / "a", "# project(other)\n" + COMPONENTS.format("lenses", all_installed)) == [
        ("CMakeLists.txt", 2, "project name", "lenses")
    ]
    assert build(tmp_path / "b", COMPONENTS.format("${NAME}", all_installed)) == []
    assert build(tmp_path / "b2", "set(NAME lenses)\n" + COMPONENTS.format("${NAME}", all_installed)) == [
        ("CMakeLists.txt", 2, "project name", "lenses")
    ]
    for number, build_type in enumerate(("ament_cmake", "ament_python", "catkin")):
        one = built(tmp_path / str(number), "lens", build_type)
        found = [(each.line, each.kind, each.about) for each in of_build(one)]
        assert found == {
            "ament_cmake": [(3, "build file", "CMakeLists.txt")],
            "ament_python": [(3, "build file", "setup.py")],
            "catkin": [],
        }[build_type]  # fmt: skip


def test_descriptions_of_plugins(tmp_path: Path) -> None:
    cmake = "project(lens)\npluginlib_export_plugin_description_file(glass a.xml)\npluginlib_export_plugin_description_file(glass b.xml)\n"
    one = built(tmp_path / "a", "lens", "ament_cmake", **{"CMakeLists.txt": cmake, "a.xml": "<library path='a'>\n<class>\n</library>"})
    found = [(each.path.name, each.line, each.kind, each.about) for each in of_build(one)]
    assert [each for each in found if each[2].startswith("description")] == [
        ("a.xml", 3, "description broken", "a.xml"),
        ("CMakeLists.txt", 3, "description absent", "b.xml"),
    ]
    export = '<export><glass plugin="${prefix}/gone.xml"/></export>'
    ros1 = built(tmp_path / "b", "lens", "catkin", export, **{"CMakeLists.txt": "project(lens)\n"})
    assert [(each.path.name, each.kind, each.about) for each in of_build(ros1)] == [("package.xml", "description absent", "gone.xml")]
    ros2 = built(tmp_path / "c", "lens", "ament_cmake", export, **{"CMakeLists.txt": "project(lens)\n"})
    assert [each for each in of_build(ros2) if each.kind.startswith("description")] == []  # only CMake exports there


def test_scripts_in_python_2(tmp_path: Path) -> None:
    for ros, first, expected in ((2, "python", [("knob.py", 2)]), (1, "python3", [("knob.py", 2)]), (1, "python", [])):
        root = tmp_path / f"{ros}{first}"
        built(
            root,
            "light",
            "ament_cmake",
            **{"scripts/knob.py": f"#!/usr/bin/env {first}\nprint 'on'\n", "CMakeLists.txt": "project(light)\n"},
        )
        suffix = ".launch.xml" if ros == 2 else ".launch"
        node = '<node pkg="light" exec="knob.py"/>' if ros == 2 else '<node pkg="light" type="knob.py" name="knob"/>'
        (root / f"a{suffix}").write_text(f"<launch>{node}</launch>")
        run = compose_ros2 if ros == 2 else compose
        composition = run([root / f"a{suffix}"], files=Files(PackagePath([root])))
        assert [(one.path.name, one.line) for _, one in defects(composition, builds(discover(root))) if one.kind == "python 2"] == expected


def test_packages_that_are_not_registered(tmp_path: Path) -> None:
    installed = COMPONENTS.format("lens", "install(TARGETS focus DESTINATION lib)").replace("ament_package()", "")
    assert build(tmp_path / "a", installed) == [("CMakeLists.txt", 1, "not registered", "")]
    assert build(tmp_path / "b", installed + "include(finish.cmake)\n", **{"finish.cmake": ""})[:1] == [
        ("CMakeLists.txt", 1, "not registered", "")
    ]
    assert build(tmp_path / "c", installed + "finish_package()\n") == []  # it may do that
    assert build(tmp_path / "d", installed + "if(WHOLE)\n  ament_package()\nendif()\n") == []
    assert build(tmp_path / "e", installed + "# ament_package()\n") == [("CMakeLists.txt", 1, "not registered", "")]


def headers(root: Path, cmake: str, source: str, build_type: str, **files: str) -> list[tuple[str, int, str, str]]:
    one = built(root, "level", build_type, **{"CMakeLists.txt": cmake, "node.cpp": source, **files})
    return [(each.path.name, each.line, each.kind, each.about) for each in of_own_headers(one)]


def test_headers_of_own_interfaces(tmp_path: Path) -> None:
    cmake = """project(level)
find_package(ament_cmake REQUIRED)
rosidl_generate_interfaces(level msg/Height.msg)
add_executable(node node.cpp)
ament_package()
"""
    source, files = '#include "level/msg/height.hpp"\n', {"msg/Height.msg": "float32 height\n"}
    assert headers(tmp_path / "a", cmake, source, "ament_cmake", **files) == [("CMakeLists.txt", 4, "own interfaces", "node")]
    linked = 'rosidl_get_typesupport_target(made level rosidl_typesupport_cpp)\ntarget_link_libraries(node "${made}")\n'
    assert headers(tmp_path / "b", cmake + linked, source, "ament_cmake", **files) == []
    assert headers(tmp_path / "c", cmake, '#include "other/msg/height.hpp"\n', "ament_cmake", **files) == []
    assert headers(tmp_path / "d", cmake + "unknown_command(node)\n", source, "ament_cmake", **files) == []


def test_headers_that_catkin_makes(tmp_path: Path) -> None:
    cmake = """project(level)
find_package(catkin REQUIRED COMPONENTS roscpp message_generation dynamic_reconfigure)
add_message_files(FILES Height.msg)
generate_messages()
generate_dynamic_reconfigure_options(cfg/Level.cfg)
catkin_package()
add_executable(node node.cpp)
"""
    files = {"msg/Height.msg": "float32 height\n", "cfg/Level.cfg": 'gen.generate(PACKAGE, "level", "Level")\n'}
    source = "#include <level/Height.h>\n#include <level/LevelConfig.h>\n"
    late = ("CMakeLists.txt", 7, "interfaces later", "node")
    assert headers(tmp_path / "a", cmake, source, "catkin", **files) == [late]
    first = cmake + "add_dependencies(node ${${PROJECT_NAME}_EXPORTED_TARGETS})\n"
    assert headers(tmp_path / "b", first, source, "catkin", **files) == []
    other = ("node.cpp", 2, "configuration not made", "level/LevelConfig.h")
    assert headers(tmp_path / "c", first, source, "catkin", **{**files, "cfg/Level.cfg": 'gen.generate(PACKAGE, "level", "Levels")'}) == [
        other
    ]
    own = {**files, "include/level/LevelConfig.h": "", "cfg/Level.cfg": ""}
    assert headers(tmp_path / "d", first, source, "catkin", **own) == []


def test_modules_of_the_package(tmp_path: Path) -> None:
    script = "#!/usr/bin/env python3\nfrom lamp.light import on\n"
    cmake = "project(lamp)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
    files = {"scripts/on.py": script, "scripts/lamp.py": script, "src/lamp/__init__.py": "", "CMakeLists.txt": cmake}
    package = built(tmp_path, "lamp", "catkin", **files)
    launch = tmp_path / "main.launch"

    def kinds_of(package: Built, program: str) -> list[tuple[int, str, str]]:
        launch.write_text(f'<launch><node pkg="lamp" type="{program}" name="n"/></launch>')
        composition = compose([launch], files=Files(PackagePath([tmp_path])))
        return [(each.line, each.kind, each.about) for _, each in defects(composition, [package])]

    assert kinds_of(package, "on.py") == [(2, "modules not set up", "lamp")]
    assert kinds_of(package, "lamp.py") == [(2, "hides its package", "lamp.py")]
    set_up = built(
        tmp_path, "lamp", "catkin", **{**files, "CMakeLists.txt": cmake.replace("catkin_package", "catkin_python_setup()\ncatkin_package")}
    )
    assert kinds_of(set_up, "on.py") == []
    made = "#!/usr/bin/env python3\nfrom lamp.cfg import LampConfig\nfrom lamp.srv import *\n"  # what the build generates is on the path
    package = built(tmp_path, "lamp", "catkin", **{**files, "scripts/on.py": made})
    assert kinds_of(package, "on.py") == []
    package = built(tmp_path, "lamp", "catkin", **{**files, "scripts/on.py": f"{made}import lamp.light\n"})
    assert kinds_of(package, "on.py") == [(4, "modules not set up", "lamp")]
