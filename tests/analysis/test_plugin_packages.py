"""Plug-ins in a package that no launch file names and no package needs: a loader asks for them."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import analyze_systems
from rosarch.analysis.systems.launches import given
from rosarch.analysis.systems.requests import LaunchEnvironment, parse_request
from rosarch.extractor.settings import Settings

MANIFEST = """<package format="3"><name>{}</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.com">m</maintainer><license>MIT</license><depend>rclcpp</depend><depend>pluginlib</depend>
<export><build_type>ament_cmake</build_type></export></package>
"""
AXLE = """cmake_minimum_required(VERSION 3.8)
project(axle)
find_package(rclcpp REQUIRED)
find_package(pluginlib REQUIRED)
add_executable(axle axle.cpp)
ament_target_dependencies(axle rclcpp pluginlib)
install(TARGETS axle DESTINATION lib/axle)
install(FILES main.launch.xml DESTINATION share/axle)
ament_package()
"""
WORM = """cmake_minimum_required(VERSION 3.8)
project(worm)
find_package(pluginlib REQUIRED)
add_library(worm SHARED worm.cpp)
ament_target_dependencies(worm pluginlib)
install(TARGETS worm LIBRARY DESTINATION lib)
pluginlib_export_plugin_description_file({} plugins.xml)
ament_package()
"""
DESCRIPTION = """<library path="worm">
<class name="worm::Worm" type="worm::Worm" base_class_type="axle::Gear"/>
</library>
"""
LOADER = """#include <pluginlib/class_loader.hpp>
#include <rclcpp/rclcpp.hpp>
namespace axle { class Gear { public: virtual ~Gear() = default; }; }
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("axle");
  pluginlib::ClassLoader<axle::Gear> loader("axle", "axle::Gear");
  auto gear = loader.createSharedInstance("worm::Worm");
  rclcpp::spin(node);
}
"""
CLASS = "namespace axle { class Gear { public: virtual ~Gear() = default; }; }\nnamespace worm { class Worm : public axle::Gear {}; }\n"
MACRO = "#include <pluginlib/class_list_macros.hpp>\nPLUGINLIB_EXPORT_CLASS(worm::Worm, axle::Gear)\n"
LAUNCH = '<launch><node pkg="axle" exec="axle"/></launch>'


def findings(root: Path, files: dict[str, str]) -> list[tuple[str, str]]:
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    where = LaunchEnvironment(root, (root,), {})
    found = analyze_systems(root, given([parse_request("axle/main.launch.xml")], where), Method(sources=Settings(jobs=1))).findings
    return sorted((finding.check.id, str(finding.place)) for finding in found if finding.severity != "note")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("host", "macro", "expected"),
    [
        ("axle", MACRO, []),
        ("axle", "", [("class-not-registered", "worm/plugins.xml:2")]),
        ("pluginlib", MACRO, [("plugin-misdescribed", "worm/CMakeLists.txt:7")]),
    ],
)
def test_its_description_and_its_code(tmp_path: Path, host: str, macro: str, expected: list[tuple[str, str]]) -> None:
    files = {
        "axle/package.xml": MANIFEST.format("axle"), "axle/CMakeLists.txt": AXLE, "axle/axle.cpp": LOADER, "axle/main.launch.xml": LAUNCH,
        "worm/package.xml": MANIFEST.format("worm"), "worm/CMakeLists.txt": WORM.format(host), "worm/plugins.xml": DESCRIPTION,
        "worm/worm.cpp": CLASS + macro,
    }  # fmt: skip
    assert findings(tmp_path, files) == expected
