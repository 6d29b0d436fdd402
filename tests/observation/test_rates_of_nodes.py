"""Real nodes send as often as rosarch says that they do."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from nodes import EXAMPLES, build, needs_ros

from rosarch.observation.peer import Heard, MessageType, Peer
from rosarch.observation.private import Start, private_graph
from rosarch.observation.processes import wait_until
from rosarch.observation.statistics import Arrivals

pytestmark = pytest.mark.slow

DRIVE = "delivery_robot/src/delivery_robot/src/drive.cpp"
LAMP = "docking_states/src/auto_docking/src/dock_lamp.cpp"
BOOL = MessageType("std_msgs/Bool", "8b94c1b53db61fb6aed406028ad6332a")
TOPICS = ("/odom", "/battery", "/lamp")


@pytest.fixture(scope="module")
def measured(tmp_path_factory: pytest.TempPathFactory) -> dict[str, float]:
    """Messages a second of two nodes in a private graph, the lamp blinking because a bumper is pressed."""
    drive, lamp = build(tmp_path_factory.mktemp("nodes"), [DRIVE, LAMP])
    with private_graph() as graph, Peer(graph.master.uri, "/meter") as meter:
        graph.start(Start((str(drive),), "/drive"))
        graph.start(Start((str(lamp),), "/dock_lamp"))
        meter.advertise("/bumper", BOOL)
        assert wait_until(lambda: meter.readers("/bumper"), 5)
        meter.publish("/bumper", b"\1")
        time.sleep(0.6)
        arrivals = {topic: Arrivals() for topic in TOPICS}
        for topic, found in arrivals.items():
            meter.subscribe(topic, counted_by(found))
        time.sleep(4.5)
    return {topic: found.hz or 0.0 for topic, found in arrivals.items()}


def counted_by(arrivals: Arrivals) -> Heard:
    return lambda _sender, at, _message: arrivals.add(at)


@needs_ros
@pytest.mark.parametrize(
    ("example", "package", "node"), [("delivery_robot", "delivery_robot", "drive"), ("docking_states", "auto_docking", "dock_lamp")]
)
def test_nodes_send_as_often_as_predicted(
    example: str, package: str, node: str, measured: dict[str, float], rosarch: Callable[..., object], tmp_path: Path
) -> None:
    launch = tmp_path / "one.launch"
    launch.write_text(f'<launch><node pkg="{package}" type="{node}" name="{node}"/></launch>')
    outcome = rosarch("ask", EXAMPLES / example, "rate of *", "--launch", launch, "--format", "json")
    (system,) = json.loads(outcome.out)
    predicted = {rate["topic"]: rate for rate in system["rates"] if rate["topic"] in TOPICS}
    assert predicted
    for topic, rate in predicted.items():
        assert rate["high"] is not None
        assert 0.9 * rate["low"] <= measured[topic] <= 1.1 * rate["high"]
        assert measured[topic] >= 0.9 * rate["high"]  # these nodes send as often as they can
