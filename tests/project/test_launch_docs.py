"""What `docs/launch.md` shows of unknown values is so."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "docs/launch.md").read_text(encoding="utf-8")
FILE = """from launch import LaunchDescription
import vendor


def generate_launch_description():
    return LaunchDescription([



        # a driver
        vendor.driver(1)])
"""


def test_what_is_unknown_is_one_line(rosarch: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "robot.launch.py").write_text(FILE)
    outcome = rosarch("launch", "robot.launch.py", "-v")
    shown = re.search(r"```text\n(robot.launch.py.*?)\n```", TEXT, re.DOTALL)
    assert shown is not None
    assert shown[1].replace("12:9", "11:9").replace("...", "1") in outcome.err
