"""ROS 2 launch files of one test, in a package of their own."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from rosarch.extractor.launch import Composition, Files, PackagePath, compose

MANIFEST = "<package><name>{}</name><version>1.2.3</version><export><build_type>ament_cmake</build_type></export></package>"
HEAD = """import os, yaml, tempfile
from pathlib import Path
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription, Substitution
from launch.actions import *
from launch.conditions import IfCondition, UnlessCondition, LaunchConfigurationEquals, LaunchConfigurationNotEquals
from launch.event_handlers import OnProcessExit, OnShutdown
from launch.launch_description_sources import PythonLaunchDescriptionSource, AnyLaunchDescriptionSource
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import ComposableNode, ParameterFile, ParameterValue
from launch_ros.substitutions import FindPackageShare
from launch.utilities import perform_substitutions

def node(name, **more):
    return Node(package='here', executable='run', name=name, **more)

"""


def composed(
    folder: Path,
    files: Mapping[str, str],
    arguments: Mapping[str, str] | None = None,
    environment: Mapping[str, str] | None = None,
) -> Composition:
    """Compose the first of `files`, which are in package `here`."""
    package = folder / "here"
    for name, text in {"package.xml": MANIFEST.format("here"), **files}.items():
        path = package / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    first = package / next(iter(files))
    return compose([first], arguments, files=Files(PackagePath([folder]), str(folder)), environment=environment or {})


def described(
    folder: Path, entities: str, before: str = "", arguments: Mapping[str, str] | None = None, environment: Mapping[str, str] | None = None
) -> Composition:
    """Compose a `launch.py` whose launch description has `entities`; `before` are statements before it, or whole functions."""
    body = "\n".join(f"    {line}" for line in before.splitlines())
    text = f"{HEAD}def generate_launch_description():\n{body}\n    return LaunchDescription([{entities}])\n"
    return composed(folder, {"launch/main.launch.py": text}, arguments, environment)


def xml(folder: Path, content: str, arguments: Mapping[str, str] | None = None, **others: str) -> Composition:
    """Compose a launch file in XML; `others` are files beside it, `_` in names for `.`."""
    files = {"main.launch.xml": f"<launch>\n{content}\n</launch>\n", **{name.replace("_", "."): text for name, text in others.items()}}
    return composed(folder, files, arguments)


def params(composition: Composition) -> dict[str, object]:
    """The values of all parameters."""
    return {setting.name: setting.value for setting in composition.params}


def names(composition: Composition) -> list[str]:
    """The full names of the nodes, each with the conditions that are not known."""
    return [" ".join([node.full_name, *map(str, node.conditions)]) for node in composition.nodes]


def problems(composition: Composition, folder: Path) -> list[str]:
    """The problems, with places relative to the package."""
    return [str(problem).replace(f"{folder}/here/", "") for problem in composition.problems]
