"""What the sources of a workspace have and nothing runs: told as open, and no port."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

SPARE = """
void spare(ros::NodeHandle& node) {
  ros::Publisher publisher = node.advertise<std_msgs::String>("spare", 1);
}
"""
OLD = """import rospy
from std_msgs.msg import String


class Old:
    def __init__(self):
        self.publisher = rospy.Publisher("old", String, queue_size=1)
"""


def test_code_that_nothing_calls_and_sources_that_nothing_imports(rosarch: Callable, workspace: Path) -> None:
    source = workspace / "talker/talker.cpp"
    lines = source.read_text().count("\n")
    source.write_text(source.read_text() + SPARE)
    (workspace / "talker/old.py").write_text(OLD)
    models = {model["component"]: model for model in json.loads(rosarch("analyze", workspace, "--format", "json").out)}
    assert [port["name"] for port in models["talker"]["ports"]] == ["chatter"]
    assert models["talker"]["open"] == [{"what": ["ports"], "reason": "nothing calls spare", "at": f"talker/talker.cpp:{lines + 3}"}]
    assert (models["old"]["kind"], models["old"]["ports"]) == ("unused", [])
    reason = "nothing builds, imports or starts the source"
    assert models["old"]["open"] == [{"what": ["ports"], "reason": reason, "at": "talker/old.py:7"}]


def test_only_what_runs_is_in_the_table(rosarch: Callable, workspace: Path) -> None:
    (workspace / "talker/old.py").write_text(OLD)
    assert "old" not in rosarch("analyze", workspace).out
