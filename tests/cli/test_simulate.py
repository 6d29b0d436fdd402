"""`rosarch simulate`: an example, in all formats."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable
from pathlib import Path

import pytest


@pytest.fixture
def simulate(rosarch: Callable, examples: Path) -> Callable:
    folder = examples / "patrol_robot"
    launch = ("--launch", "src/patrol_bringup/launch/robot.launch")
    return lambda *words: rosarch("simulate", folder, *launch, "--scenario", folder / "patrol_run.yml", *words)


@pytest.mark.slow
def test_the_patrol_drives_between_two_buttons(simulate: Callable) -> None:
    """Enabled by the service at 2 s, disabled at 8 s: meanwhile each of the 20 odometry messages a second is answered with a command."""
    found = simulate("--format", "json")
    assert found.code == 0, found.err
    document = json.loads(found.out)
    rate = {row["topic"]: row for row in document["rates"]}
    assert abs(rate["/odom"]["number"] - 200) <= 1
    assert abs(rate["/patrol/cmd_vel"]["number"] - 120) <= 2
    assert abs(rate["/cmd_vel"]["number"] - 120) <= 2
    assert [event["time"] for event in document["events"] if event["kind"] == "changed"] == pytest.approx([2.002, 8.002])
    delay = next(row for row in document["latencies"] if (row["from"], row["to"]) == ("/odom", "/cmd_vel"))
    assert 0.003 - 1e-9 <= delay["least"] <= delay["most"] <= 0.011


def test_figures_and_traces(simulate: Callable) -> None:
    text = simulate("--seed", "5").out
    assert text.startswith("src/patrol_bringup/launch/robot.launch: 10 s, seed 5, ")
    assert [line for line in text.split("\n") if line and line[0].isalpha() and ":" not in line] == [
        "rates",
        "queues",
        "latencies (ms)",
        "load",
    ]
    rows = list(csv.DictReader(io.StringIO(simulate("--format", "csv").out)))
    assert [float(row["time"]) for row in rows] == sorted(float(row["time"]) for row in rows)
    assert {row["kind"] for row in rows} == {"sent", "received", "changed"}


def test_diagrams(simulate: Callable) -> None:
    sequence = simulate("--format", "sequence", "--duration", "2.1").out
    assert "sequenceDiagram\n" in sequence
    assert "->>" in sequence
    assert simulate("--format", "timeline", "--duration", "1").out.startswith("gantt\n  title src/patrol_bringup/launch/robot.launch\n")


@pytest.mark.slow
def test_rules_of_ones_own_count(simulate: Callable, tmp_path: Path) -> None:
    hints = tmp_path / "hints.dl"
    hints.write_text('hint_rate("src/patrol_robot/src/base_driver.cpp", 33, "50").\n')
    found = simulate("--rules", hints, "--format", "json")
    assert found.code == 0, found.err
    rate = {row["topic"]: row["number"] for row in json.loads(found.out)["rates"]}
    assert abs(rate["/odom"] - 500) <= 1
