"""A live graph of ROS 2, seen through rclpy, beside the model of its nodes."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from ros2_nodes import PYTHON, executable, needs_ros2, package

from rosarch.observation.domain import Participant, environment, free_domain, python_with_ros
from rosarch.observation.processes import Process, wait_until
from rosarch.observation.rpc import CallError

pytestmark = pytest.mark.slow

MOTOR = """import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32
from std_srvs.srv import SetBool
from action_msgs.srv import CancelGoal


class Motor(Node):
    def __init__(self):
        super().__init__('motor')
        self.declare_parameter('limit', 2.0)
        self.pub = self.create_publisher(Float32, '~/current', 10)
        self.sub = self.create_subscription(Float32, 'speed', self.on_speed, 10)
        self.srv = self.create_service(SetBool, 'enable', self.on_enable)
        self.other = self.create_client(SetBool, '/brake/enable')
        HIDDEN

    def on_speed(self, message):
        self.pub.publish(message)

    def on_enable(self, request, response):
        response.success = request.data
        return response


def main():
    rclpy.init()
    rclpy.spin(Motor())
"""
HIDDEN = "self.more = [getattr(self, name)(Float32, 'torque', 10) for name in ['create_publisher']]"


def compared(rosarch: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, hidden: str) -> tuple[int, dict]:
    package(tmp_path, "arm", "motor", MOTOR.replace("HIDDEN", "pass"))
    module = tmp_path / "ws" / "arm" / "arm" / "motor.py"
    with free_domain() as domain:
        for name, value in environment(domain).items():
            monkeypatch.setenv(name, value)
        module.write_text(MOTOR.replace("HIDDEN", hidden))
        program = executable(tmp_path, "arm", "motor")
        with (
            Process([str(program)], tmp_path, tmp_path / "log", environment(domain)),
            Participant(str(PYTHON), domain, private=True) as other,
        ):
            assert wait_until(lambda: "/motor" in other.ask("graph", parameters=False)["nodes"], 10)
            module.write_text(MOTOR.replace("HIDDEN", "pass"))
            outcome = rosarch("compare", tmp_path / "ws", "--launch", tmp_path / "main.launch.xml", "--domain", domain, "--format", "json")
    return outcome.code, json.loads(outcome.out)


@needs_ros2
def test_a_graph_is_as_the_model_says(rosarch: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    code, found = compared(rosarch, tmp_path, monkeypatch, "pass")
    assert code == 0
    assert [(each["kind"], each["name"], each["outcome"]) for each in found["elements"]] == [
        ("node", "/motor", "confirmed"),
        ("parameter", "/motor/limit", "confirmed"),
        ("publisher", "/motor/current", "confirmed"),
        ("service_client", "/brake/enable", "confirmed"),
        ("service_server", "/enable", "confirmed"),
        ("subscriber", "/speed", "confirmed"),
        ("topic", "/motor/current", "confirmed"),
        ("topic", "/speed", "confirmed"),
    ]


@needs_ros2
def test_what_the_model_does_not_have_is_missed(rosarch: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    _, found = compared(rosarch, tmp_path, monkeypatch, "self.create_publisher(Float32, 'torque', 10)")
    apart = [(each["kind"], each["name"], each["outcome"]) for each in found["elements"] if each["outcome"] != "confirmed"]
    assert apart == [("publisher", "/torque", "missed"), ("topic", "/torque", "missed")]
    assert [each["check"] for each in found["contradictions"]] == ["observed-port-unknown"]


@needs_ros2
def test_an_empty_domain(rosarch: Callable, tmp_path: Path) -> None:
    package(tmp_path, "arm", "motor", MOTOR.replace("HIDDEN", "pass"))
    with free_domain() as domain:
        outcome = rosarch("compare", tmp_path / "ws", "--launch", tmp_path / "main.launch.xml", "--domain", domain)
    assert outcome.code == 0
    assert [line.split()[:3] for line in outcome.out.splitlines() if line.strip().startswith("node")][:1] == [["node", "1", "0"]]


def test_no_python_has_rclpy(rosarch: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package(tmp_path, "arm", "motor", MOTOR.replace("HIDDEN", "pass"))
    monkeypatch.setenv("ROSARCH_ROS2_PYTHON", "/bin/false")
    outcome = rosarch("observe", tmp_path / "ws", "--launch", tmp_path / "main.launch.xml", "--domain", 3)
    assert outcome.code == 2
    told = "/bin/false, which ROSARCH_ROS2_PYTHON names, has no rclpy: source ROS 2, or let ROSARCH_ROS2_PYTHON name a Python that has it"
    assert outcome.err.splitlines()[-1] == f"rosarch: error: {told}"


@needs_ros2
def test_a_request_that_cannot_be_answered() -> None:
    with free_domain() as domain, Participant(python_with_ros(), domain, private=True) as participant:
        with pytest.raises(CallError, match="no_such"):
            participant.ask("advertise", topic="/x", type="no_such/msg/X")
        assert participant.ask("graph")["nodes"] == []
