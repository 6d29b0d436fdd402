"""Nodes of `examples/` built against the ROS 1 of the machine, without catkin."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


def has_ros() -> bool:
    """Whether C++ nodes of ROS 1 can be built and run here."""
    if not (shutil.which("g++") and shutil.which("pkg-config")):
        return False
    return all(subprocess.run(["pkg-config", "--exists", name], check=False).returncode == 0 for name in ("roscpp", "nav_msgs", "std_srvs"))


needs_ros = pytest.mark.skipif(not has_ros(), reason="there is no ROS 1 to build nodes against")


def build(folder: Path, sources: list[str], *includes: str) -> list[Path]:
    """The executables of sources of `examples/`, one each, built side by side."""
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", "roscpp"], check=True, capture_output=True, text=True).stdout.split()
    programs = [folder / Path(source).stem for source in sources]
    include = [f"-I{EXAMPLES / each}" for each in includes]
    started = [
        subprocess.Popen(["g++", "-O0", *include, "-o", str(program), str(EXAMPLES / source), *flags])
        for program, source in zip(programs, sources, strict=True)
    ]
    assert [process.wait(120) for process in started] == [0] * len(sources)
    return programs
