"""Experiments with real nodes of rclpy: what they do is confirmed, and where they do something else the model is refuted."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from ros2_nodes import executable, needs_ros2, package

pytestmark = pytest.mark.slow

LAMP = """import os
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float32, String
from std_srvs.srv import SetBool


class Lamp(Node):
    def __init__(self):
        super().__init__('lamp')
        self.declare_parameter('limit', 2.5)
        self.limit = self.get_parameter('limit').value
        self.on = False
        self.light = self.create_publisher(Bool, 'light', 10)
        self.alarm = self.create_publisher(String, '~/alarm', 10)
        self.create_subscription(Float32, 'voltage', self.on_voltage, 10)
        self.create_service(SetBool, 'switch', self.on_switch)
        self.create_timer(0.1, self.on_timer)

    def on_switch(self, request, response):
        self.on = request.data
        response.success = True
        return response

    def on_voltage(self, message):
        if message.data > self.limit:
            self.alarm.publish(String(data='too high'))

    def on_timer(self):
        if self.on:
            self.light.publish(Bool(data=True))


def main():
    rclpy.init()
    rclpy.spin(Lamp())


if __name__ == '__main__':
    main()
"""


def probed(rosarch: Callable, tmp_path: Path, run: str, model: str = LAMP, *more: object) -> tuple[int, dict]:
    """What becomes of the model of one source when the program is another one."""
    package(tmp_path, "light", "lamp", model)
    other = tmp_path / "run"
    package(other, "light", "lamp", run)
    program = executable(other, "light", "lamp")
    command = ("probe", tmp_path / "ws", "lamp", "--executable", program, "--trials", 2, "--format", "json", *more)
    outcome = rosarch(*command)
    return outcome.code, json.loads(outcome.out)


def told(found: dict) -> dict[str, tuple[str, str]]:
    return {f"{each['kind']} {each['at'].rpartition(':')[2]}": (each["verdict"], each.get("reason") or "") for each in found["verdicts"]}


@needs_ros2
def test_what_the_node_does_is_confirmed(rosarch: Callable, tmp_path: Path) -> None:
    code, found = probed(rosarch, tmp_path, LAMP)
    assert (code, found["node"]) == (0, "/lamp")
    assert {verdict for verdict, _ in told(found).values()} == {"confirmed"}, found["verdicts"]
    (rate,) = found["rates"]
    assert rate["measured"] == pytest.approx(rate["predicted"], rel=0.1)


@needs_ros2
def test_what_the_node_does_otherwise_is_refuted(rosarch: Callable, tmp_path: Path) -> None:
    code, found = probed(rosarch, tmp_path, LAMP.replace("> self.limit", "> 1000"))
    assert code == 1
    assert [key for key, (verdict, _) in told(found).items() if verdict == "refuted"] == ["reactive 27"]


WRONG = {
    "crashes": ("        self.on = request.data\n", "        os.abort()\n", "it was killed by SIGABRT"),
    "hangs": ("        self.on = request.data\n", "        import time; time.sleep(1000)\n", "/switch does not answer"),
    "does not start": (
        "        super().__init__('lamp')\n",
        "        raise ValueError('no lamp')\n",
        "/lamp exited with 1: ValueError: no lamp",
    ),
}


@needs_ros2
@pytest.mark.parametrize("how", WRONG)
def test_a_node_that_ends_or_hangs_costs_its_experiments(how: str, rosarch: Callable, tmp_path: Path) -> None:
    old, new, reason = WRONG[how]
    _, found = probed(rosarch, tmp_path, LAMP.replace(old, new), LAMP, "--time-limit", 8)
    reasons = {why for verdict, why in told(found).values() if verdict == "not reached"}
    assert any(reason in why for why in reasons), reasons
    assert not any("\n" in why for why in reasons)
    assert strays(tmp_path) == []


FLOOD = """        self.create_timer(0.0001, lambda: [self.light.publish(Bool()) for _ in range(20)])
        print('x' * 1000000)
"""
FORKS = """        for _ in range(20):
            if os.fork() == 0:
                os.setsid()
                import time
                time.sleep(1000)
"""


@needs_ros2
@pytest.mark.parametrize("more", [FLOOD, FORKS], ids=["flood", "forks"])
def test_a_node_that_floods_or_forks_is_ended_with_all_it_started(more: str, rosarch: Callable, tmp_path: Path) -> None:
    anchor = "        self.on = False\n" if "fork" in more else "        self.create_timer(0.1, self.on_timer)\n"
    _, found = probed(rosarch, tmp_path, LAMP.replace(anchor, anchor + more), LAMP, "--time-limit", 8)
    assert found["verdicts"]
    assert strays(tmp_path) == []


def strays(path: Path) -> list[str]:
    """Processes that run a program below a folder."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            words = (folder / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if any(word.startswith(str(path / "run").encode()) for word in words):
            found.append(folder.name)
    return found
