"""Relations that no model holds: frames, plug-ins that are loaded, tasks that report, parameters of configurations."""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest

from tests.examples.test_examples import EXAMPLES

pytestmark = pytest.mark.slow

QUERIES = [
    ("frame_tree", "localizer", "frame_lookup(_, End, Frame)", {("source", "base_link"), ("target", "odom")}),
    ("frame_tree", "localizer", "frame_broadcast(_, End, Frame)", {("parent", "map"), ("child", "odom")}),
    (
        "frame_tree",
        "docking",
        "frame_broadcast(_, End, Frame)",
        {("parent", "base_link"), ("child", "laser"), ("parent", "map"), ("child", "dock")},
    ),
    ("workbench", "host", "plugin_load(_, Name)", {("workbench/Drill",), ("workbench/Counter",)}),
    (
        "field_camera",
        "camera_driver",
        "reconfigure_parameter(_, Name, Kind, Default)",
        {("~exposure", "double", "0.01"), ("~gain", "int", "0")},
    ),
]


@pytest.mark.parametrize(("example", "component", "query", "expected"), QUERIES)
def test_relation(example: str, component: str, query: str, expected: set[tuple[str, ...]], rosarch: Callable) -> None:
    outcome = rosarch("query", EXAMPLES / example, query, "--component", component, "--format", "json")
    (answer,) = json.loads(outcome.out)
    assert {tuple(value for key, value in row.items() if key != "F") for row in answer["rows"]} == expected
