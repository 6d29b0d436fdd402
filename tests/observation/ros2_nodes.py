"""Nodes of rclpy in a package of one test, and a Python that runs them."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

PYTHON = os.environ.get("ROSARCH_ROS2_PYTHON")
needs_ros2 = pytest.mark.skipif(PYTHON is None, reason="ROSARCH_ROS2_PYTHON names no Python with rclpy")

MANIFEST = """<package format="3"><name>{0}</name><version>1.0.0</version><description>d</description><maintainer email="m@x.y">m</maintainer>
<license>BSD</license><depend>rclpy</depend><depend>std_msgs</depend><depend>std_srvs</depend><export><build_type>ament_python</build_type></export></package>
"""
SETUP = """from setuptools import setup
setup(name='{0}', packages=['{0}'], entry_points={{'console_scripts': ['{1} = {0}.{1}:main']}})
"""
LAUNCH = """<launch><node pkg="{0}" exec="{1}" name="{1}"/></launch>
"""


def package(folder: Path, name: str, node: str, source: str) -> Path:
    """A workspace with a package of one node; the launch file beside it starts that."""
    root = folder / "ws"
    module = root / name / name
    module.mkdir(parents=True)
    (root / name / "package.xml").write_text(MANIFEST.format(name))
    (root / name / "setup.py").write_text(SETUP.format(name, node))
    (module / "__init__.py").write_text("")
    (module / f"{node}.py").write_text(source)
    (folder / "main.launch.xml").write_text(LAUNCH.format(name, node))
    return root


def executable(folder: Path, name: str, node: str) -> Path:
    """A program that runs the node of the package that `package` made, as an installed entry point does."""
    program = folder / node
    program.write_text(
        f"#!{PYTHON}\nimport sys\nsys.path.insert(0, {str(folder / 'ws' / name)!r})\nfrom {name}.{node} import main\nmain()\n"
    )
    program.chmod(0o755)
    return program
