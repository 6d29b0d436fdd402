"""`rosarch show behavior` and `rosarch show machine`."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

EMPTY = {
    "text": "talker/talker  node talker\n\nno state, no reactions\n",
    "mermaid": '---\ntitle: "talker/talker"\n---\nstateDiagram-v2\n',
    "plantuml": "@startuml\ntitle talker/talker\nhide empty description\n@enduml\n",
}


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("form", EMPTY)
def test_a_node_without_behaviour(form: str, rosarch: Callable, workspace: Path) -> None:
    outcome = rosarch("show", "machine", "ws", "talker", "--format", form)
    assert (outcome.code, outcome.out, outcome.err) == (0, EMPTY[form], "")


@pytest.mark.parametrize(("form", "begin"), [("dot", 'digraph "talker/talker" {\n'), ("scxml", '<?xml version="1.0" encoding="UTF-8"?>\n')])
def test_other_formats(form: str, begin: str, rosarch: Callable, workspace: Path) -> None:
    assert rosarch("show", "machine", "ws", "--format", form).out.startswith(begin)


def test_machines_as_json(rosarch: Callable, workspace: Path) -> None:
    (machine,) = json.loads(rosarch("show", "machine", "ws", "--format", "json").out)
    assert (machine["package"], machine["component"], machine["regions"]) == ("talker", "talker", [])


def test_a_diagram_is_of_one_node(rosarch: Callable, examples: Path) -> None:
    outcome = rosarch("show", "machine", examples / "mobile_base", "--format", "dot")
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err == (
        f"rosarch: error: {examples / 'mobile_base'}: 2 components; choose one for dot: base_driver/base_driver, base_odometry/odometry_node\n"
    )


def test_unknown_node(rosarch: Callable, workspace: Path) -> None:
    assert rosarch("show", "machine", "ws", "talkr").err == "rosarch: error: no node or nodelet talkr, did you mean `talker`?\n"


def test_behavior_of_a_node_without_any(rosarch: Callable, workspace: Path) -> None:
    assert rosarch("show", "behavior", "ws").out == "talker/talker  node talker\n  no reactions, no timed loops, no state\n"
    assert (
        rosarch("show", "behavior", "ws", "--format", "markdown").out
        == "## talker/talker (node talker)\n\nNo reactions, no timed loops, no state.\n"
    )


def test_behavior_as_json(rosarch: Callable, workspace: Path) -> None:
    (model,) = json.loads(rosarch("show", "behavior", "ws", "--format", "json").out)
    assert list(model) == [
        "system", "component", "package", "kind", "middleware", "node_name", "ports",
        "periodic", "reactive", "state_variables", "configuration", "transitions", "reactive_deferred", "one_shot", "open",
    ]  # fmt: skip


@pytest.mark.slow
def test_one_node_is_read_alone(rosarch: Callable, examples: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from rosarch.analysis import components as analysis

    read: list[list[str]] = []
    evaluate = analysis._evaluate

    def recording(system: str, components: list, *rest: object) -> object:
        read.append([component.name for component in components])
        return evaluate(system, components, *rest)

    monkeypatch.setattr(analysis, "_evaluate", recording)
    alone = rosarch("show", "ports", examples / "mobile_base", "base_odometry/odometry_node", "--no-cache", "--format", "json")
    assert read == [["odometry_node"]]
    assert alone == rosarch("show", "ports", examples / "mobile_base", "odometry_node", "--no-cache", "--format", "json")
    assert len(read[1]) == 2
    unknown = rosarch("show", "ports", examples / "mobile_base", "base_odometry/odometry_nod", "--no-cache")
    assert unknown.err == "rosarch: error: no node or nodelet base_odometry/odometry_nod, did you mean `base_odometry/odometry_node`?\n"
