"""Places in files that come with rosarch are shown by where they are in its library, not on this machine."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

LAUNCH = """<launch>
<include file="$(find gazebo_ros)/launch/empty_world.launch"/>
<node pkg="talker" type="talker" name="gazebo"/>
</launch>
"""
SHOWN = "rosarch library: systems/ros1/share/gazebo_ros/launch/empty_world.launch"


def test_evidence_in_the_library(rosarch: Callable, workspace: Path) -> None:
    (workspace / "talker/main.launch").write_text(LAUNCH)
    found = json.loads(rosarch("check", workspace, "--format", "json").out)["findings"]
    (duplicate,) = (finding for finding in found if finding["check"] == "duplicate-node")
    assert SHOWN in {step["file"] for step in duplicate["evidence"]}
    assert f" {SHOWN}:" in rosarch("check", workspace).out
    sarif = json.dumps(json.loads(rosarch("check", workspace, "--format", "sarif").out))
    assert "rosarch library" not in sarif and "file:///" in sarif
