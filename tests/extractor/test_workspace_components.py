from __future__ import annotations

from pathlib import Path

import pytest
from workspace_builder import messages, package, target

from rosarch.extractor.workspace import Diagnostic, closure, components, discover, include_path, without_library
from rosarch.extractor.workspace.plugins import registrations

NODELET_XML = """<library path="lib/libdemo_nodelets">
  <class name="demo/Filter" type="demo::Filter" base_class_type="nodelet::Nodelet"><description>x</description></class>
</library>
"""
EXPORT = '<nodelet plugin="${prefix}/plugins.xml"/>'


def two_packages(root: Path) -> None:
    package(
        root,
        "base",
        "catkin_package(INCLUDE_DIRS include LIBRARIES base_core)\nadd_library(base_core core.cpp)\n"
        "set_target_properties(base_core PROPERTIES OUTPUT_NAME core)\ntarget_link_libraries(base_core helper)\nadd_library(helper STATIC helper.cpp)",
        {"core.cpp": "", "helper.cpp": "", "include/base/core.h": ""},
    )
    package(
        root,
        "app",
        "find_package(catkin REQUIRED COMPONENTS roscpp base)\ninclude_directories(src ${catkin_INCLUDE_DIRS})\n"
        "add_executable(app_node main.cpp)\ntarget_link_libraries(app_node ${catkin_LIBRARIES})",
        {"main.cpp": "", "src/x.h": ""},
        depends=("base",),
    )


def test_closure_and_include_path_through_catkin_variables(tmp_path: Path) -> None:
    two_packages(tmp_path)
    workspace = discover(tmp_path)
    app = workspace.package("app")
    assert app is not None
    node = target(app, "app_node")
    assert [library.name for library in closure(workspace, node)] == ["base_core", "helper"]
    assert include_path(workspace, node) == (tmp_path / "app/src", tmp_path / "base/include")


def test_node_component(tmp_path: Path) -> None:
    two_packages(tmp_path)
    (found,) = components(discover(tmp_path, ["app"]))
    assert (found.name, found.package, found.kind) == ("app_node", "app", "node")
    assert found.sources == (tmp_path / "app/main.cpp",)
    assert found.library_sources == (tmp_path / "base/core.cpp", tmp_path / "base/helper.cpp")
    assert found.include_dirs == (tmp_path / "app/src", tmp_path / "base/include")


@pytest.mark.parametrize("link", ["core", "base_core", "libcore.so", "-lcore", "/x/devel/lib/libcore.so"])
def test_library_names(tmp_path: Path, link: str) -> None:
    two_packages(tmp_path)
    package(tmp_path, "other", f"add_executable(x x.cpp)\ntarget_link_libraries(x {link})", {"x.cpp": ""})
    workspace = discover(tmp_path)
    other = workspace.package("other")
    assert other is not None
    assert [library.name for library in closure(workspace, target(other, "x"))][:1] == ["base_core"]


def test_library_cycle_ends(tmp_path: Path) -> None:
    cmake = (
        "add_library(a STATIC a.cpp)\nadd_library(b STATIC b.cpp)\ntarget_link_libraries(a b)\ntarget_link_libraries(b a)\n"
        "add_executable(x x.cpp $<TARGET_OBJECTS:o>)\nadd_library(o OBJECT o.cpp)\ntarget_link_libraries(x a)"
    )
    package(tmp_path, "demo", cmake, {"a.cpp": "", "b.cpp": "", "x.cpp": "", "o.cpp": ""})
    (found,) = components(discover(tmp_path))
    assert [path.name for path in found.library_sources] == ["o.cpp", "a.cpp", "b.cpp"]


def test_the_nearest_library_of_a_name_counts(tmp_path: Path) -> None:
    package(tmp_path, "a_far", "add_library(util far.cpp)", {"far.cpp": ""})
    package(tmp_path, "near", "add_library(util near.cpp)", {"near.cpp": ""})
    package(tmp_path, "app", "add_executable(x x.cpp)\ntarget_link_libraries(x util)", {"x.cpp": ""}, depends=("near",))
    found = next(one for one in components(discover(tmp_path)) if one.name == "x")
    assert [path.name for path in found.library_sources] == ["near.cpp"]


@pytest.mark.parametrize(
    "xml",
    [
        NODELET_XML,
        f"<class_libraries>{NODELET_XML}</class_libraries>",
        '<?xml version="1.0"?>\n<library path="lib/libother"/>' + NODELET_XML,
        NODELET_XML.replace("lib/libdemo_nodelets", "demo_nodelets"),
    ],
)
def test_nodelet_from_description(tmp_path: Path, xml: str) -> None:
    files = {"plugins.xml": xml, "n.cpp": "", "h.cpp": ""}
    cmake = "add_library(demo_nodelets n.cpp)\nadd_library(helper h.cpp)\ntarget_link_libraries(demo_nodelets helper)"
    package(tmp_path, "demo", cmake, files, export=EXPORT)
    (found,) = components(discover(tmp_path))
    assert (found.name, found.kind, found.entry_class, found.plugin_name) == ("Filter", "nodelet", "demo::Filter", "demo/Filter")
    assert [path.name for path in (*found.sources, *found.library_sources)] == ["n.cpp", "h.cpp"]


def test_plugin_from_macro_and_description(tmp_path: Path) -> None:
    code = (
        "// PLUGINLIB_EXPORT_CLASS(no::One, x)\n#include <pluginlib/class_list_macros.h>\n"
        "PLUGINLIB_EXPORT_CLASS(demo::Layer,\n  costmap_2d::Layer)\nPLUGINLIB_DECLARE_CLASS(demo, Old, demo::Old, nodelet::Nodelet);\n"
    )
    xml = '<library path="lib/libother"><class type="demo::Layer" base_class_type="costmap_2d::Layer"/></library>'
    files = {"plugins.xml": xml, "n.cpp": code}
    package(tmp_path, "demo", "add_library(demo_nodelets n.cpp)", files, export='<costmap_2d plugin="${prefix}/plugins.xml"/>')
    found = components(discover(tmp_path))
    assert [(one.name, one.kind, one.base_class, len(one.sources)) for one in found] == [
        ("Old", "nodelet", "nodelet::Nodelet", 1),
        ("Layer", "plugin", "costmap_2d::Layer", 1),
    ]


def test_brackets_in_the_values_of_a_plugin_description(tmp_path: Path) -> None:
    xml = '<library path="lib/libother"><class type="demo::Layer" base_class_type="filters::FilterBase<sensor_msgs::LaserScan>"/></library>'
    package(tmp_path, "demo", "add_library(other o.cpp)", {"o.cpp": "", "p.xml": xml}, export='<filters plugin="${prefix}/p.xml"/>')
    assert [one.base_class for one in components(discover(tmp_path))] == ["filters::FilterBase<sensor_msgs::LaserScan>"]


def test_name_of_a_plugin_that_is_an_instance_of_a_template(tmp_path: Path) -> None:
    code = "PLUGINLIB_EXPORT_CLASS(demo::Filter<demo::msg::Scan>, demo::Base)\n"
    package(tmp_path, "demo", "add_library(demo_filters n.cpp)", {"n.cpp": code})
    assert [(one.name, one.entry_class) for one in components(discover(tmp_path))] == [
        ("Filter<demo::msg::Scan>", "demo::Filter<demo::msg::Scan>")
    ]


def test_registration_lines(tmp_path: Path) -> None:
    path = tmp_path / "n.cpp"
    path.write_text("/* a\n b */\nPLUGINLIB_EXPORT_CLASS( ::a::B , nodelet::Nodelet )\n")
    assert [(one.cxx_class, one.base, one.line) for one in registrations(path)] == [("a::B", "nodelet::Nodelet", 3)]


def test_plugins_of_simulators_are_known_by_their_library(tmp_path: Path) -> None:
    code = (
        "namespace sea {\nGZ_REGISTER_MODEL_PLUGIN(Boat);\n}\n"
        'GZ_ADD_PLUGIN(\n  sea::Whale,\n  gz::sim::System,\n  sea::Whale::ISystemConfigure)\nGZ_ADD_PLUGIN_ALIAS(sea::Whale, "whale")\n'
        "IGNITION_ADD_PLUGIN(sea::Crab, ignition::gazebo::System)\n"
    )
    package(tmp_path, "demo", "add_library(sea n.cpp)", {"n.cpp": code})
    found = components(discover(tmp_path))
    assert [(one.name, one.kind, one.plugin_name, one.base_class) for one in found] == [
        ("Boat", "gazebo_plugin", "libsea.so", "gazebo::ModelPlugin"),
        ("Crab", "gazebo_plugin", "libsea.so", "ignition::gazebo::System"),
        ("Whale", "gazebo_plugin", "libsea.so", "gz::sim::System"),
    ]


def test_plugins_that_a_header_of_the_package_registers(tmp_path: Path) -> None:
    headers = {"include/demo/boat.h": "GZ_REGISTER_MODEL_PLUGIN(Boat)\n", "src/crab.hh": "GZ_REGISTER_WORLD_PLUGIN(Crab)\n"}
    sources = {"src/boat.cc": '#include "demo/boat.h"\n#include <ros/ros.h>\n', "src/crab.cc": '#include "crab.hh"\n', "src/fish.cc": ""}
    cmake = "add_library(boat src/boat.cc)\nadd_library(crab src/crab.cc)\nadd_library(fish src/fish.cc)"
    package(tmp_path, "demo", cmake, headers | sources)
    found = components(discover(tmp_path))
    assert [(one.name, one.kind, one.plugin_name) for one in found] == [
        ("Boat", "gazebo_plugin", "libboat.so"),
        ("Crab", "gazebo_plugin", "libcrab.so"),
    ]


@pytest.mark.parametrize(
    ("files", "message"),
    [
        ({}, "demo/package.xml:1:1: plug-in description plugins.xml for nodelet does not exist"),
        ({"plugins.xml": "<library>\n<class></library>"}, "demo/plugins.xml:2:10: broken XML: mismatched tag"),
    ],
)
def test_plugin_description_trouble(tmp_path: Path, files: dict[str, str], message: str) -> None:
    package(tmp_path, "demo", "", files, export=EXPORT)
    assert messages(discover(tmp_path), tmp_path) == [message]


def test_executables_of_tests_are_no_components(tmp_path: Path) -> None:
    package(tmp_path, "demo", "catkin_add_gtest(t t.cpp)\nadd_executable(x x.cpp)", {"t.cpp": "", "x.cpp": ""})
    assert [one.name for one in components(discover(tmp_path))] == ["x"]


def test_config_extras_run_in_the_packages_that_find_them(tmp_path: Path) -> None:
    extra = {"cmake/flags.cmake": "macro(node name)\nadd_executable(${name} ${ARGN})\nendmacro()\n"}
    package(tmp_path, "flags", "catkin_package(CFG_EXTRAS flags.cmake)", extra)
    package(tmp_path, "app", "find_package(flags REQUIRED)\nnode(x x.cpp)", {"x.cpp": ""})
    assert [one.name for one in components(discover(tmp_path))] == ["x"]


def test_ament(tmp_path: Path) -> None:
    cmake = (
        "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()\n"
        "ament_auto_add_library(demo_lib SHARED DIRECTORY src)\n"
        'rclcpp_components_register_node(demo_lib PLUGIN "demo::Talker" EXECUTABLE talker_node)\nament_auto_package()'
    )
    package(tmp_path, "demo", cmake, {"src/talker.cpp": "", "include/demo/talker.hpp": ""}, export="<build_type>ament_cmake</build_type>")
    found = components(discover(tmp_path))
    assert [(one.name, one.kind, one.entry_class) for one in found] == [
        ("talker_node", "component", "demo::Talker"),
    ]
    assert [path.name for path in found[0].sources] == ["talker.cpp"]
    assert found[0].include_dirs == (tmp_path / "demo/include",)


def test_ament_auto_links_the_earlier_libraries_of_the_package_and_what_it_found(tmp_path: Path) -> None:
    ament = "<build_type>ament_cmake</build_type>"
    package(tmp_path, "core", "ament_auto_add_library(core core.cpp)\nament_auto_package()", {"core.cpp": ""}, export=ament)
    cmake = (
        "ament_auto_add_library(base SHARED base.cpp)\nament_auto_add_library(derived SHARED derived.cpp)\n"
        "ament_auto_add_executable(x x.cpp)\nament_auto_add_executable(alone NO_TARGET_LINK_LIBRARIES x.cpp)\n"
        "ament_auto_add_library(headers INTERFACE)\nament_auto_add_library(later SHARED later.cpp)\n"
    )
    files = {f"{name}.cpp": "" for name in ("base", "derived", "x", "later")}
    package(tmp_path, "demo", cmake, files, depends=("core",), export=ament)
    workspace = discover(tmp_path)
    demo = workspace.package("demo")
    assert demo is not None
    linked = {name: {one.name for one in closure(workspace, target(demo, name))} for name in ("base", "derived", "x", "alone", "headers")}
    assert linked == {
        "base": {"core"}, "derived": {"base", "core"}, "x": {"base", "derived", "core"}, "alone": {"core"},
        "headers": {"base", "derived", "core"},
    }  # fmt: skip
    assert messages(workspace, tmp_path) == []


def test_catkin_simple_links_what_the_manifest_depends_on(tmp_path: Path) -> None:
    head = "find_package(catkin_simple REQUIRED)\ncatkin_simple(ALL_DEPS_REQUIRED)\n"
    core = f"{head}cs_add_library(core core.cpp)\ncs_add_library(inner NO_AUTO_EXPORT inner.cpp)\ncs_install()\ncs_export()"
    package(tmp_path, "core", core, {"core.cpp": "", "inner.cpp": "", "include/core/core.h": ""})
    package(tmp_path, "between", f"{head}cs_export()", depends=("core",))
    app = f"{head}cs_add_executable(x x.cpp)\ncs_add_executable(y NO_AUTO_LINK x.cpp)\ncs_install_scripts(s.py)\ncs_export()"
    files = {"x.cpp": "", "s.py": "import rospy\nrospy.spin()\n", "msg/A.msg": "", "cfg/A.cfg": ""}
    package(tmp_path, "app", app, files, depends=("between", "message_generation", "dynamic_reconfigure"))
    workspace = discover(tmp_path)
    found = workspace.package("app")
    assert found is not None
    assert [path.name for path in (*found.message_files, *found.cfg_files)] == ["A.msg", "A.cfg"]
    assert {one.name: [path.name for path in one.library_sources] for one in components(workspace, None)} == {
        "x": ["core.cpp"], "y": [], "s": [],
    }  # fmt: skip
    assert tmp_path / "core/include" in target(found, "x").include_dirs
    assert messages(workspace, tmp_path) == []


def test_names_of_the_input_name_one_file(tmp_path: Path) -> None:
    cmake = "add_executable(x x.cpp)\nset_target_properties(x PROPERTIES OUTPUT_NAME ../../../evil)\nadd_executable(y x.cpp)\nset_target_properties(y PROPERTIES OUTPUT_NAME /tmp/y2)\n"
    package(tmp_path, "demo", cmake, {"x.cpp": ""})
    assert [one.name for one in components(discover(tmp_path))] == ["evil", "y2"]


def test_components_of_one_name_are_told_apart(tmp_path: Path) -> None:
    cmake = (
        "add_executable(x x.cpp)\nadd_executable(y x.cpp)\nset_target_properties(x y PROPERTIES OUTPUT_NAME go)\nadd_executable(go_2 x.cpp)\n"
        "add_library(demo_nodelets n.cpp)\n"
    )
    xml = NODELET_XML.replace("</library>", '<class name="b/Filter" type="b::Filter" base_class_type="nodelet::Nodelet"/></library>')
    package(tmp_path, "demo", cmake, {"x.cpp": "", "n.cpp": "", "plugins.xml": xml}, export=EXPORT)
    problems: list[Diagnostic] = []
    found = components(discover(tmp_path), problems)
    assert [(one.name, one.entry_class or (one.target and one.target.name)) for one in found] == [
        ("go", "x"), ("go_3", "y"), ("go_2", "go_2"), ("Filter", "b::Filter"), ("Filter_2", "demo::Filter"),
    ]  # fmt: skip
    assert [str(problem).replace(f"{tmp_path}/", "") for problem in problems] == [
        "demo/CMakeLists.txt:5:1: demo has another component go; that of target y is called go_3",
        "demo/CMakeLists.txt:8:1: demo has another component Filter; that of demo::Filter is called Filter_2",
    ]


def test_a_described_nodelet_without_a_library_is_reported(tmp_path: Path) -> None:
    package(tmp_path, "demo", "", {"plugins.xml": NODELET_XML}, export=EXPORT)
    (problem,) = without_library(discover(tmp_path))
    assert str(problem) == f"{tmp_path}/demo/plugins.xml:2:1: no target builds lib/libdemo_nodelets of demo::Filter"


def test_a_described_nodelet_with_its_library_is_not_reported(tmp_path: Path) -> None:
    package(tmp_path, "demo", "add_library(demo_nodelets f.cpp)", {"plugins.xml": NODELET_XML, "f.cpp": ""}, export=EXPORT)
    assert without_library(discover(tmp_path)) == ()


def test_a_package_that_rosarch_knows_counts_as_installed(tmp_path: Path) -> None:
    package(
        tmp_path,
        "roscpp",
        "catkin_package(INCLUDE_DIRS include LIBRARIES roscpp)\nadd_library(roscpp a.cpp)",
        {"a.cpp": "", "include/ros/ros.h": ""},
    )
    package(
        tmp_path, "app", "add_executable(app m.cpp)\ntarget_link_libraries(app ${catkin_LIBRARIES})", {"m.cpp": ""}, depends=("roscpp",)
    )
    workspace = discover(tmp_path)
    (app,) = (component for component in components(workspace) if component.name == "app")
    assert app.library_sources == ()
    assert tmp_path / "roscpp/include" not in app.include_dirs


def test_a_package_that_rosarch_knows_for_another_ros_is_read(tmp_path: Path) -> None:
    cmake = "add_library(controller_manager a.cpp)\nadd_executable(x m.cpp)\ntarget_link_libraries(x controller_manager)"
    export = "<build_type>ament_cmake</build_type>"
    package(tmp_path, "controller_manager", cmake, {"a.cpp": "", "m.cpp": ""}, export=export)
    assert [[path.name for path in one.library_sources] for one in components(discover(tmp_path))] == [["a.cpp"]]


def test_libraries_of_an_export_set(tmp_path: Path) -> None:
    ament = "<build_type>ament_cmake</build_type>"
    base = (
        "add_library(core SHARED core.cpp)\nadd_library(inner inner.cpp)\n"
        "ament_export_targets(export_base HAS_LIBRARY_TARGET)\ninstall(TARGETS core EXPORT export_base LIBRARY DESTINATION lib)\nament_package()"
    )
    package(tmp_path, "base", base, {"core.cpp": "", "inner.cpp": ""}, export=ament)
    cmake = "find_package(base REQUIRED)\nadd_executable(x x.cpp)\nament_target_dependencies(x PUBLIC base)\nament_package()"
    package(tmp_path, "demo", cmake, {"x.cpp": ""}, export=ament)
    (found,) = components(discover(tmp_path))
    assert [path.name for path in found.library_sources] == ["core.cpp"]


def test_libraries_that_nothing_runs(tmp_path: Path) -> None:
    uses, cmake = "#include <ros/ros.h>\n", "add_library(apart apart.cpp)\nadd_library(used used.cpp)\nadd_library(plain plain.cpp)\n"
    files = {"apart.cpp": uses, "used.cpp": uses, "plain.cpp": "", "node.cpp": uses}
    package(tmp_path, "demo", f"{cmake}add_executable(node node.cpp)\ntarget_link_libraries(node used)", files)
    module = "import rospy\n"
    setup = "from setuptools import setup\nsetup(name='api', packages=['api'])\n"
    modules = {
        f"api/{name}.py": text for name, text in {"__init__": "", "user": f"import api.low\n{module}", "low": module, "none": ""}.items()
    }
    package(tmp_path, "api", "", {"setup.py": setup, **modules}, export="<build_type>ament_python</build_type>")
    found = components(discover(tmp_path))
    assert [(one.package, one.name, one.kind) for one in found] == [
        ("api", "api.user", "library"),
        ("demo", "apart", "library"),
        ("demo", "node", "node"),
    ]
    # another package may run what is asked for
    package(tmp_path, "above", "", {}, depends=("demo",))
    assert [one.name for one in components(discover(tmp_path, ["above"]))] == []


def test_sources_of_no_component_are_components_where_they_are_asked_for(tmp_path: Path) -> None:
    package(
        tmp_path,
        "demo",
        "add_executable(main main.cpp)",
        {
            "main.cpp": "#include <ros/ros.h>\n",
            "old/once.cpp": "#include <ros/ros.h>\n",
            "src/by_header.cpp": '#include "demo/by_header.h"\n',
            "include/demo/by_header.h": "#include <ros/ros.h>\n",
            "src/plain.cpp": "int one();\n",
            "test/tested.cpp": "#include <ros/ros.h>\n",
            "nodes/tool.py": "import rospy\nimport helper\n",
            "nodes/helper.py": "import rospy\n",
            "hidden/CATKIN_IGNORE": "",
            "hidden/left.cpp": "#include <ros/ros.h>\n",
            "ring/one.py": "import rospy\nimport two\n",
            "ring/two.py": "import rospy\nimport one\n",
        },
    )
    (tmp_path / "tools").mkdir()
    (tmp_path / "tools/look.py").write_text("import rclpy\n")
    workspace = discover(tmp_path)
    assert [one.name for one in components(workspace)] == ["main"]
    unused = [(one.package, one.name) for one in components(workspace, unused=True) if one.kind == "unused"]
    assert unused == [
        ("demo", "hidden.left"),
        ("demo", "nodes.tool"),
        ("demo", "old.once"),
        ("demo", "ring.one"),
        ("demo", "src.by_header"),
        ("tools.look", "tools.look"),
    ]
