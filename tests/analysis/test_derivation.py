"""Components from the same sources, and the configurations of one: derived together, and each costs itself alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.analysis import derivation
from rosarch.analysis.components import Analysis, Wanted, analyze
from rosarch.analysis.derivation import Extracted, Task, tasks_of
from rosarch.analysis.method import Method
from rosarch.extractor.pipeline import extract
from rosarch.extractor.settings import Settings
from rosarch.models.component import Relations
from rosarch.models.node_configuration import NodeConfiguration

CMAKE = """cmake_minimum_required(VERSION 3.8)
project(tools)
find_package(rclcpp_components REQUIRED)
add_library(tools SHARED tools.cpp)
rclcpp_components_register_nodes(tools "tools::Left" "tools::Right")
"""
SOURCE = """#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/bool.hpp"
namespace tools {
struct Left : rclcpp::Node {
  explicit Left(const rclcpp::NodeOptions & options) : Node("left", options) {
    if (declare_parameter("on", true)) pub_ = create_publisher<std_msgs::msg::Bool>("left", 1);
  }
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr pub_;
};
struct Right : rclcpp::Node {
  explicit Right(const rclcpp::NodeOptions & options) : Node("right", options) {
    pub_ = create_publisher<std_msgs::msg::Bool>("right", 1);
  }
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr pub_;
};
}
"""
OFF = NodeConfiguration("left", values=(("on", "false"),))
BAD = NodeConfiguration("bad")


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    (tmp_path / "package.xml").write_text(
        '<package format="3"><name>tools</name><depend>rclcpp</depend><export><build_type>ament_cmake</build_type></export></package>'
    )
    (tmp_path / "CMakeLists.txt").write_text(CMAKE)
    (tmp_path / "tools.cpp").write_text(SOURCE)
    return tmp_path


def first(component: Extracted) -> list[NodeConfiguration | None]:
    return [None, OFF, BAD] if component.name == "Left" else [None]


def analysis(root: Path, wanted: Wanted) -> Analysis:
    return analyze(root, method=Method(sources=Settings(jobs=1)), wanted=wanted)


def ports(found: Analysis) -> dict[str, list[str]]:
    return {
        f"{model.component} {model.configuration}".strip(): sorted(port.name for port in model.ports if not port.implicit)
        for model in found.models
    }


def test_components_of_the_same_sources_are_one_task(workspace: Path) -> None:
    with extract(workspace) as found:
        tasks = tasks_of([(one, None) for one in found.components], follows=False)
        assert [[component.name for component, _ in task.parts] for task in tasks] == [["Left", "Right"]]
        assert [task.jobs for task in tasks[0].divided()] == [[job] for job in tasks[0].jobs]


def test_what_they_share_is_not_mixed(workspace: Path) -> None:
    assert ports(analysis(workspace, Wanted(first=first))) == {
        "Left": ["left"],
        f"Left {BAD.key}": ["left"],
        f"Left {OFF.key}": [],
        "Right": ["right"],
    }


def test_a_configuration_that_fails_costs_itself_alone(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real = derivation.configured_rows

    def failing(derive: derivation.Derive, component: object, configuration: NodeConfiguration) -> Relations:
        if configuration == BAD:
            raise ValueError("bad")
        return real(derive, component, configuration)  # type: ignore[arg-type]

    monkeypatch.setattr(derivation, "configured_rows", failing)
    found = analysis(workspace, Wanted(first=first, after=lambda _: ()))
    assert ports(found) == {"Left": ["left"], f"Left {OFF.key}": [], "Right": ["right"]}
    assert [one.message.partition(",")[0] for one in found.diagnostics if "not analysed" in one.message] == [
        "tools/Left not analysed: error (ValueError: bad"
    ]


def test_what_follows_from_models_comes_with_them(workspace: Path) -> None:
    found = analysis(workspace, Wanted(after=lambda models: [OFF] if models[0].component == "Left" else []))
    assert ports(found) == {"Left": ["left"], f"Left {OFF.key}": [], "Right": ["right"]}


def test_a_task_of_one_configuration_is_not_divided(workspace: Path) -> None:
    with extract(workspace) as found:
        one = found.components[0]
        assert Task(((one, (None,)),), follows=False).is_one
        assert not Task(((one, (None,)),), follows=True).is_one
