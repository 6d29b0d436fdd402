"""A package with one node, for tests that look at the model of a single source."""

from __future__ import annotations

from pathlib import Path

from rosarch.analysis.components import analyze
from rosarch.analysis.method import Method
from rosarch.extractor.settings import Settings
from rosarch.models.component import ComponentModel

ROS1 = ("catkin", "roscpp", "std_msgs", "std_srvs")
ROS2 = ("ament_cmake", "rclcpp", "std_msgs")


def node_model(folder: Path, source: str, needs: tuple[str, ...] = ROS1) -> ComponentModel:
    """The model of the node that `source` is; of what its package `needs` the first is the build tool."""
    found = "".join(f"find_package({name} REQUIRED)\n" for name in needs)
    files = {
        "node.cpp": source,
        "CMakeLists.txt": f"cmake_minimum_required(VERSION 3.8)\nproject(node)\n{found}add_executable(node node.cpp)\n",
        "package.xml": f"""<package format="2"><name>node</name><version>0.0.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>l</license><buildtool_depend>{needs[0]}</buildtool_depend></package>
""",
    }
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    (model,) = analyze(folder, method=Method(sources=Settings(jobs=1))).models
    return model
