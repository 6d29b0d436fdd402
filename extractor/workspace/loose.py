"""Single source files as components, without any package."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from rosarch.base.files import read_file
from rosarch.extractor.workspace.model import EXECUTABLE, SHARED, Package, Program, Target, Workspace
from rosarch.extractor.workspace.plugins import registrations

_ROS2 = re.compile(rb"^[ \t]*#[ \t]*include[ \t]*[<\"]rclcpp", re.MULTILINE)


def loose_workspace(root: Path, sources: Iterable[Path]) -> Workspace:
    """A workspace in which each source below `root` is a package of its own: a library when it registers classes, else a program."""
    packages = tuple(_package(root, source) for source in sources)
    return Workspace(root, packages, selected=frozenset(package.name for package in packages), searched=False)


def _package(root: Path, source: Path) -> Package:
    name = loose_name(root, source)
    if source.suffix == ".py":
        return Package(name, source.parent, source, build_type="", programs=(Program(source.stem, source),))
    kind = SHARED if registrations(source) else EXECUTABLE
    target = Target(source.stem, source.stem, kind, name, source, 1, sources=(source,))
    return Package(name, source.parent, source, build_type="ament_cmake" if is_ros2(source) else "catkin", targets=(target,))


def is_ros2(source: Path) -> bool:
    """Whether a source of C++ is one for ROS 2."""
    try:
        return _ROS2.search(read_file(source)) is not None
    except OSError:
        return False  # reported where it is parsed


def loose_name(root: Path, source: Path) -> str:
    """The name of the package that a single source is."""
    return ".".join(source.relative_to(root).with_suffix("").parts)
