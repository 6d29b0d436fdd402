"""`rosarch show graph`, `rosarch show includes` and `rosarch export acme`, over systems written by hand."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from systems import small

from rosarch.analysis.systems.analysis import SystemAnalysis
from rosarch.cli.systems import SystemInputs

SYSTEMS = (small(), replace(small(), name="arm/sim.launch", nodes=small().nodes[:1], connectors=()))
Result = tuple[int, str, str]


@pytest.fixture
def command(rosarch: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Result]:
    """Run a command line where the workspace has `SYSTEMS`, or those that `--launch` names."""
    monkeypatch.chdir(tmp_path)

    def load(inputs: SystemInputs, _configuration: object) -> SystemAnalysis:
        assert inputs.folder == Path("ws")
        return SystemAnalysis(tuple(s for s in SYSTEMS if not inputs.launches or s.name in inputs.launches), (), (), ())

    monkeypatch.setattr("rosarch.cli.delivery.load_systems", load)

    def invoke(*words: str) -> Result:
        outcome = rosarch(*words)
        return outcome.code, outcome.out, outcome.err

    return invoke


def names(out: str) -> set[str]:
    return {node["name"] for graph in json.loads(out) for node in graph["nodes"]}


@pytest.mark.parametrize(
    ("form", "begin"),
    [
        ("dot", 'digraph "robot" {\n'),
        ("mermaid", '---\ntitle: "robot"\n---\nflowchart LR\n'),
        ("graphml", "<?xml version="),
        ("json", "[\n"),
    ],
)
def test_formats(form: str, begin: str, command: Callable[..., Result]) -> None:
    code, out, err = command("show", "graph", "ws", "--launch", "robot", "--format", form)
    assert (code, out[: len(begin)], err) == (0, begin, "")


def test_json_has_all_systems(command: Callable[..., Result]) -> None:
    assert [graph["system"] for graph in json.loads(command("show", "graph", "ws", "--format", "json")[1])] == ["robot", "arm/sim.launch"]


def test_a_drawing_is_of_one_system(command: Callable[..., Result]) -> None:
    for words, form in ((("show", "graph"), "dot"), (("export", "acme"), "acme"), (("show", "includes", "--format", "dot"), "dot")):
        assert command(*words, "ws") == (
            2,
            "",
            f"rosarch: error: ws: 2 systems; choose one for {form} with --launch, or write all with --output DIR: robot, arm/sim.launch\n",
        )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "files"),
    [
        (("show", "graph", "--format", "graphml"), {"robot.graphml", "arm_sim.launch.graphml"}),
        (("show", "graph", "--format", "json"), {"robot.json", "arm_sim.launch.json"}),
        (("show", "includes"), {"robot.txt", "arm_sim.launch.txt"}),
        (("export", "acme"), {"robot.acme", "arm_sim.launch.acme"}),
    ],
)
def test_a_file_for_each_system(words: tuple[str, ...], files: set[str], command: Callable[..., Result], tmp_path: Path) -> None:
    assert command(*words, "ws", "-o", "out") == (0, "", "")
    assert {path.name for path in (tmp_path / "out").iterdir()} == files
    assert all(path.stat().st_size > 100 for path in (tmp_path / "out").iterdir())


@pytest.mark.parametrize(
    ("words", "nodes"),
    [
        (("--node", "/base/*", "--exclude", "*odometry"), {"/base/driver"}),
        (("--namespace", "base"), {"/base/driver", "/base/odometry"}),
        (("--package", "other", "--package", "base_driver"), {"/viewer", "/base/driver"}),
        (("--focus", "mission"), {"/mission", "/planner", "/base/driver"}),
        (("--focus", "mission", "--hops", "0"), {"/mission"}),
        (("--collapse", "namespace", "--node", "/base/*"), {"/base"}),
    ],
)
def test_what_is_shown(words: tuple[str, ...], nodes: set[str], command: Callable[..., Result]) -> None:
    assert names(command("show", "graph", "ws", "--launch", "robot", "--format", "json", *words)[1]) == nodes


@pytest.mark.parametrize(
    ("words", "connectors"),
    [
        (("--kind", "tf"), {"/tf"}),
        (("--kind", "service", "--kind", "action"), {"/base/reset", "/plan"}),
        (("--name", "/o*"), {"/odom"}),
        (("--name", "/plan*", "--implicit"), {"/plan", "/plan/status"}),
        (("--name", "/b*", "--no-leaves"), {"/base/ticks", "/base/reset"}),
        (("--nodes-only",), set()),
    ],
)
def test_which_connectors_are_shown(words: tuple[str, ...], connectors: set[str], command: Callable[..., Result]) -> None:
    (graph,) = json.loads(command("show", "graph", "ws", "--launch", "robot", "--format", "json", *words)[1])
    assert {name for connector in graph["connectors"] for name in connector["names"]} == connectors


def test_groups_ports_and_legend(command: Callable[..., Result]) -> None:
    plain = command("show", "graph", "ws", "--launch", "robot", "--no-legend")[1]
    assert "subgraph" not in plain and "<TABLE" not in plain and 'label="/cmd_vel"' in plain
    full = command("show", "graph", "ws", "--launch", "robot", "--group", "namespace", "--ports")[1]
    assert "subgraph" in full and "<TABLE" in full and 'label="/cmd_vel\\ngeometry_msgs/Twist"' in full


def test_an_unknown_node_in_focus(command: Callable[..., Result]) -> None:
    assert command("show", "graph", "ws", "--focus", "/planer") == (2, "", "rosarch: error: no node /planer, did you mean `/planner`?\n")


def test_a_node_in_focus_need_not_be_in_every_system(command: Callable[..., Result]) -> None:
    assert names(command("show", "graph", "ws", "--focus", "viewer", "--format", "json")[1]) == {"/viewer"}


def test_svg_without_graphviz(command: Callable[..., Result], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert command("show", "graph", "ws", "--launch", "robot", "--format", "svg") == (
        2,
        "",
        "rosarch: error: robot: SVG needs Graphviz: there is no `dot` on PATH; the formats dot and mermaid need no installation\n",
    )


def test_includes(command: Callable[..., Result]) -> None:
    code, out, _ = command("show", "includes", "ws", "--launch", "robot")
    assert (code, out.splitlines()[:2]) == (0, ["launch/robot.launch", "├── 3 launch/base.launch"])
    assert [system["system"] for system in json.loads(command("show", "includes", "ws", "--format", "json")[1])] == [
        "robot",
        "arm/sim.launch",
    ]
    assert command("show", "includes", "ws", "--launch", "robot", "--format", "dot")[1].startswith('digraph "robot" {\n')


def test_graphml_is_xml(command: Callable[..., Result]) -> None:
    root = ElementTree.fromstring(command("show", "graph", "ws", "--launch", "robot", "--format", "graphml")[1].encode())
    assert root.tag == "{http://graphml.graphdrawing.org/xmlns}graphml"


def test_acme(command: Callable[..., Result]) -> None:
    assert command("export", "acme", "ws", "--launch", "robot")[1].startswith("import families/ROSFam.acme;\nsystem robot : ROSFam")
