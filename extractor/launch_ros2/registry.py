"""The functions that Python launch files may call, by their full names."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rosarch.extractor.launch_ros2.values import Native

_MODULES = """
__future__ abc ament_index_python ament_index_python.packages ament_index_python.resources collections collections.abc copy dataclasses enum
functools glob itertools json logging math os os.path pathlib platform random re shutil string subprocess sys tempfile textwrap time typing
typing_extensions unittest uuid warnings xacro xml xml.etree xml.etree.ElementTree yaml
"""
KNOWN_MODULES = frozenset(_MODULES.split())
_HELPERS = "clearpath_config controller_manager launch_pal launch_param_builder moveit_configs_utils nav2_common webots_ros2_driver"
HELPER_PACKAGES = frozenset(_HELPERS.split())
"""Packages of distributions whose modules many launch files import."""
NATIVES: dict[str, Native] = {}
CONSTANTS: dict[str, Any] = {"os.sep": "/", "os.pathsep": ":", "os.linesep": "\n"}
"""What modules have that is no function, by its full name."""
_Call = Callable[..., Any]


def native(*names: str) -> Callable[[_Call], _Call]:
    """Register a function under its full names."""

    def register(function: _Call) -> _Call:
        for name in names:
            NATIVES[name] = Native(name, function)
        return function

    return register
