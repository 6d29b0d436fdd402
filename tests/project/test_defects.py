"""What the tools before this one got wrong: each file of `defects/` has nodes that show it, and says what is to be found in them.

Guards of several callers are the subject of the behaviour rules, remappings of launch files that of the system rules.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

DEFECTS = Path(__file__).parent / "defects"


def test_the_defects(rosarch: Callable) -> None:
    outcome = rosarch("rules", "test", DEFECTS)
    assert outcome.code == 0, outcome.out
    assert outcome.out.count("\nok ") + 1 == len(list(DEFECTS.iterdir()))


def test_a_bad_file_costs_that_file(rosarch: Callable, workspace: Path) -> None:
    cmake = workspace / "talker/CMakeLists.txt"
    cmake.write_text(cmake.read_text() + "add_executable(broken broken.cpp)\nadd_executable(other other.cpp)\n")
    (workspace / "talker/broken.cpp").write_bytes(b"#include <ros/ros.h>\nint main() { ros::NodeHandle nh; \0\xff }}}} class {\n")
    (workspace / "talker/other.cpp").write_text((workspace / "talker/talker.cpp").read_text().replace("chatter", "other"))
    outcome = rosarch("analyze", workspace, "--format", "json")
    assert outcome.code == 0
    found = {model["component"]: [port["name"] for port in model["ports"]] for model in json.loads(outcome.out)}
    assert (found["talker"], found["other"]) == (["chatter"], ["other"])
    assert "broken.cpp" in outcome.err
