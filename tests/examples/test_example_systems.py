"""The systems of the example workspaces: what is wrong with them and what is connected, as it was written by hand.

`expected/findings.txt` has all errors and warnings; the other files there are a system each: its name, then its connectors that have two sides.
"""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.slow

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
NAMES = sorted(path.parents[1].name for path in EXAMPLES.glob("*/expected/findings.txt"))
SYSTEMS = sorted(path for path in EXAMPLES.glob("*/expected/*.txt") if path.name != "findings.txt")


def lines(path: Path) -> list[str]:
    return path.read_text(encoding="utf-8").splitlines()


@pytest.mark.parametrize("name", NAMES)
def test_findings(name: str, rosarch: Callable) -> None:
    outcome = rosarch("check", EXAMPLES / name, "--format", "json")
    found = [finding for finding in json.loads(outcome.out)["findings"] if finding["severity"] != "note"]
    told = [f"{place(finding)}: {finding['severity']}: {finding['message']}  [{finding['check']}]" for finding in found]
    expected = lines(EXAMPLES / name / "expected" / "findings.txt")
    assert sorted(told) == sorted(expected)
    assert outcome.code == bool(expected)


def place(finding: dict[str, Any]) -> str:
    return f"{finding['file']}:{finding['line']}"


@pytest.mark.parametrize("path", SYSTEMS, ids=lambda path: f"{path.parents[1].name}/{path.stem}")
def test_connectors(path: Path, rosarch: Callable) -> None:
    system, *expected = lines(path)
    outcome = rosarch("show", "graph", path.parents[1], "--launch", system, "--no-leaves", "--format", "json")
    (graph,) = json.loads(outcome.out)
    assert (outcome.code, graph["system"]) == (0, system)
    assert connectors(graph) == expected


def connectors(graph: dict[str, Any]) -> list[str]:
    """A line for each connector: who sends or calls, and who receives or serves."""
    names = {node["id"]: node["name"] for node in graph["nodes"]}
    into, out = defaultdict(set), defaultdict(set)
    for edge in graph["edges"]:
        into[edge["target"]].add(names.get(edge["source"]))
        out[edge["source"]].add(names.get(edge["target"]))
    return sorted(
        f"{each['kind']} {', '.join(each['names'])}: {', '.join(sorted(into[each['id']]))} -> {', '.join(sorted(out[each['id']]))}"
        for each in graph["connectors"]
        if each["kind"] != "tf"
    )


def test_what_a_configuration_decides_is_no_condition(rosarch: Callable) -> None:
    launch = "src/rover_bringup/launch/rover.launch.py simulation:=true"
    (graph,) = json.loads(rosarch("show", "graph", EXAMPLES / "field_rover", "--launch", launch, "--format", "json").out)
    conditional = {(edge["source"], edge["target"]): edge["conditional"] for edge in graph["edges"]}
    assert conditional["topic:/wheels/cmd_vel_unstamped", "node:/wheels"] is False  # use_stamped_vel is false
    assert ("topic:/wheels/cmd_vel", "node:/wheels") not in conditional
    assert conditional["topic:/joint_states", "node:/robot_state_publisher"] is True  # its source has a condition
