"""What targets and interfaces use of other packages, and what they are given."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from rosarch.analysis.systems.builds.uses import Uses, uses
from rosarch.extractor.workspace import discover
from rosarch.extractor.workspace.built import builds

MANIFEST = """<package format="3"><name>walker</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.com">m</maintainer><license>MIT</license><export><build_type>{}</build_type></export></package>
"""
CMAKE = """project(walker)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(tf2_ros REQUIRED)
{}
ament_package()
"""


def found(root: Path, cmake: str, build_type: str = "ament_cmake", **files: str) -> Uses:
    for path, text in {"package.xml": MANIFEST.format(build_type), "CMakeLists.txt": CMAKE.format(cmake), **files}.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    return uses(next(iter(builds(discover(root)))))


def test_headers(tmp_path: Path) -> None:
    node = """#include <rclcpp/rclcpp.hpp>
#include "walker/legs.hpp"
#ifdef WITH_MAP
#include <nav_msgs/msg/path.hpp>
#endif
#include <vector>
#include <elsewhere/part.hpp>
"""
    legs = "#ifndef LEGS\n#define LEGS\n#include <tf2_ros/buffer.h>\n#include <std_msgs/msg/bool.hpp>\n#endif\n"
    cmake = """add_library(gait gait.cpp)
ament_target_dependencies(gait tf2_ros)
add_executable(node node.cpp)
target_link_libraries(node gait rclcpp::rclcpp)"""
    files = {"node.cpp": node, "gait.cpp": "", "include/walker/legs.hpp": legs}
    one = found(tmp_path / "a", cmake, **files)
    assert [(use.path.name, use.line, use.target, use.used) for use in one.includes] == [
        ("node.cpp", 1, "node", "rclcpp"),
        ("legs.hpp", 3, "node", "tf2_ros"),
        ("legs.hpp", 4, "node", "std_msgs"),
    ]
    assert {("node", "tf2_ros"), ("node", "rclcpp"), ("gait", "tf2_ros")} <= one.given
    assert ("gait", "rclcpp") not in one.given
    assert [(target, line) for target, _, line in one.given_at] == [("gait", 6), ("node", 8)]
    assert ("node", "std_msgs") in found(tmp_path / "b", cmake + "\ninclude_directories(${std_msgs_INCLUDE_DIRS})", **files).given
    for number, more in enumerate(("unknown_command()", "ament_auto_package()", "include_directories(/opt/ros)")):
        assert found(tmp_path / str(number), f"{cmake}\n{more}", **files) == Uses()
    assert found(tmp_path / "c", cmake, "catkin", **files) == Uses()


def test_packages_and_interfaces(tmp_path: Path) -> None:
    cmake = """add_executable(node node.cpp)
ament_target_dependencies(node rclcpp std_msgs)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Step.msg"
  DEPENDENCIES std_msgs)"""
    step = "# a foot\ngeometry_msgs/Point[] feet\nstd_msgs/Header header\nfloat32 a\nwalker/Leg leg\n"
    one = found(tmp_path / "a", cmake, **{"node.cpp": "", "msg/Step.msg": step})
    assert [(use.line, use.used) for use in one.asks] == [(6, "rclcpp"), (6, "std_msgs"), (7, "std_msgs")]
    assert one.finds == {"ament_cmake", "rclcpp", "tf2_ros"}
    assert [(use.path.name, use.line, use.used) for use in one.interfaces] == [
        ("Step.msg", 2, "geometry_msgs"),
        ("Step.msg", 3, "std_msgs"),
    ]
    assert one.interfaces_given == {"std_msgs"}
    named = cmake.replace("DEPENDENCIES std_msgs", "DEPENDENCIES std_msgs LIBRARY_NAME steps ADD_LINTER_TESTS")
    assert found(tmp_path / "e", named, **{"node.cpp": "", "msg/Step.msg": step}).interfaces_given == {"std_msgs"}
    catkin = "find_package(catkin REQUIRED)\nadd_message_files(FILES Step.msg)\ngenerate_messages(DEPENDENCIES {})"
    old = found(tmp_path / "c", catkin.format("std_msgs"), "catkin", **{"msg/Step.msg": step})
    assert (old.interfaces_given, old.includes, old.asks) == ({"std_msgs"}, (), ())
    assert [(use.line, use.used) for use in old.interfaces] == [(2, "geometry_msgs"), (3, "std_msgs")]
    assert found(tmp_path / "d", catkin.format("${PACKAGES}"), "catkin", **{"msg/Step.msg": step}) == Uses()
    listed = cmake.replace('"msg/Step.msg"', "${FILES}")
    assert found(tmp_path / "b", listed, **{"node.cpp": "", "msg/Step.msg": step}).interfaces == ()  # nobody knows what is in it
    assert found(tmp_path / "c", 'set(FILES "msg/Step.msg")\n' + listed, **{"node.cpp": "", "msg/Step.msg": step}).interfaces == tuple(
        replace(use, path=tmp_path / "c" / "msg" / "Step.msg") for use in one.interfaces
    )
