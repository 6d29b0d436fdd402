"""Sources of packages that use ROS and belong to no component: no target builds them, nothing installs or imports them."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path

from rosarch.base.files import read_file
from rosarch.extractor.package_names import IGNORE_MARKERS

_USES_ROS = re.compile(
    rb"^[ \t]*(?:#[ \t]*include[ \t]*[<\"](?:ros/ros\.h|rclcpp\w*/)|(?:import|from)[ \t]+(?:rospy|rclpy)\b)", re.MULTILINE
)
_SUFFIXES = (".cpp", ".cc", ".cxx", ".py")
_APART = frozenset({"test", "tests", "launch", "doc", "docs", "build", "devel", "install", "site-packages", "__pycache__"})


def unused_sources(packages: Iterable[Path], used: Collection[Path], suffixes: tuple[str, ...] = _SUFFIXES) -> list[Path]:
    """The sources below the folders of `packages` that use ROS and are not `used`; tests, launch files and ignored folders left out."""
    found = {path.resolve() for path in used}
    sources = (path for package in packages for path in _sources(package, suffixes))
    return sorted({path for path in sources if path.resolve() not in found and uses_ros(path)})


def _sources(package: Path, suffixes: tuple[str, ...]) -> Iterator[Path]:
    for here, folders, names in os.walk(package):
        if not IGNORE_MARKERS.isdisjoint(names):
            folders.clear()
            continue
        folders[:] = [name for name in folders if name not in _APART and not name.startswith(".")]
        yield from (
            Path(here, name) for name in names if name.endswith(suffixes) and name != "setup.py" and not name.endswith(".launch.py")
        )


def uses_ros(path: Path) -> bool:
    """Whether a source or header names a client library of ROS."""
    try:
        return _USES_ROS.search(read_file(path)) is not None
    except OSError:
        return False
