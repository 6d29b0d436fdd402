"""`rosarch verify`: an example, and systems written by hand."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest
from hand_made import load, system_of

from rosarch.behavior.composition.inputs import Inputs
from rosarch.behavior.verification import spin, storm
from rosarch.behavior.verification.check import Limits
from rosarch.behavior.verification.check import verify as verify_all
from rosarch.behavior.verification.properties import read_properties

SYSTEMS = Path(__file__).parent.parent / "behavior" / "verification" / "systems"
needs_checker = pytest.mark.skipif(not (spin.is_installed() or storm.is_installed()), reason=f"{spin.HINT}; {storm.HINT}")


@pytest.fixture
def verify(rosarch: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable:
    """Verify properties of a system written by hand."""
    monkeypatch.chdir(tmp_path)

    def run(name: str, properties: str, *words: str):
        Path("p").write_text(properties)
        monkeypatch.setattr("rosarch.cli.commands.verify.load_composed", lambda *_: system_of(load(SYSTEMS / f"{name}.yml")["nodes"]))
        return rosarch("verify", tmp_path, "--properties", "p", *words)

    return run


@pytest.fixture
def no_checker(monkeypatch: pytest.MonkeyPatch) -> None:
    """No model checker is installed."""
    for checker in (spin, storm):
        monkeypatch.setattr(checker, "is_installed", lambda: False)


@pytest.mark.slow
@needs_checker
def test_an_example(rosarch: Callable, examples: Path) -> None:
    folder = examples / "patrol_robot"
    words = ["verify", folder, "--launch", "src/patrol_bringup/launch/robot.launch", "--properties", folder / "patrol.properties"]
    found = rosarch(*words, "--format", "json")
    assert found.code == 1, found.err
    verdicts = {item["property"]: item["verdict"] for item in json.loads(found.out)["properties"]}
    assert verdicts == {
        "still_first": "holds",
        "enabled_by_button": "holds",
        "limited": "holds",
        "odometry": "holds",
        "stops": "possibly violated",
    }


@pytest.mark.slow
@needs_checker
def test_states_of_a_node_and_its_loop(rosarch: Callable, examples: Path, tmp_path: Path) -> None:
    """Searching for the dock ends only when something comes; the lamp is lit by a message on /charging that says so."""
    shutil.copytree(examples / "docking_states" / "src", tmp_path / "ws" / "src")
    (tmp_path / "ws" / "dock.launch").write_text(
        '<launch><node pkg="auto_docking" type="docking" name="docking"/><node pkg="auto_docking" type="dock_lamp" name="lamp"/></launch>'
    )
    (tmp_path / "p").write_text(
        "asked: precedence(received(docking, /docking/dock), docking.state_ == SEARCHING)\n"
        "ends: left(docking.state_ == SEARCHING)\n"
        "in_order: precedence(docking.state_ == APPROACHING, docking.state_ == DOCKED)\n"
        "dark: precedence(received(lamp, /charging) or received(lamp, /bumper), lamp.g_lit)\n"
        "lit: absence(sent(/lamp))\n"
    )
    found = rosarch("verify", tmp_path / "ws", "--properties", tmp_path / "p", "--format", "json")
    rows = {item["property"]: item for item in json.loads(found.out)["properties"]}
    expected = {"asked": "holds", "ends": "violated", "in_order": "holds", "dark": "holds", "lit": "violated"}
    assert {name: row["verdict"] for name, row in rows.items()} == expected
    steps = rows["lit"]["counterexample"]["stem"]
    assert [step["cause"] for step in steps if step["changes"]] == ["receives /charging", "2 Hz loop"]
    assert steps[0]["inputs"] == ["msg.data"]


@pytest.mark.slow
@needs_checker
def test_a_counterexample_tells_steps_and_lines(verify: Callable) -> None:
    found = verify("deaf_server", "comes_back: left(client.waiting_)\nsilent: absence(sent(/answer))\n")
    assert found.code == 1
    assert "\n".join(found.out.split("\n")[:-2]) == (
        "by hand\n\n"
        "comes_back: violated\n  left(client.waiting_)\n"
        "  begins with client.waiting_ false, server.ready_ false\n"
        "  1. /client receives /start: client.waiting_ false -> true, sends /request  [client.cpp:5, client.cpp:6]\n"
        "  2. /server receives /request  [server.cpp:8]\n"
        "  then again and again:\n"
        "  3. nothing happens\n\n"
        "silent: holds\n  absence(sent(/answer))\n"
    )


@needs_checker
def test_a_counterexample_as_a_sequence_diagram(verify: Callable) -> None:
    found = verify("relay", "never: absence(sent(/b))\n", "--format", "mermaid")
    assert found.out == (
        '---\ntitle: "never: violated"\n---\nsequenceDiagram\n  participant n0 as environment\n  participant n1 as /relay\n'
        "  n0->>n1: /a\n  n1->>n1: /b\n"
    )


@needs_checker
def test_all_hold(verify: Callable) -> None:
    assert verify("relay", "both: always (sent(/b) <-> received(relay, /a))\n").code == 0


@pytest.mark.usefixtures("no_checker")
@pytest.mark.parametrize(
    ("language", "files"), [("promela", ["p.pml"]), ("prism", ["p.prism", "p.props"]), ("jani", ["p.jani"])], ids=lambda value: str(value)
)
def test_export_needs_no_checker(verify: Callable, language: str, files: list[str]) -> None:
    found = verify("ring", "p: left(one.has_)\n", "--export", language, "--output", "out")
    assert found.code == 0, found.err
    assert sorted(path.name for path in Path("out").iterdir()) == files
    assert "one_has" in (Path("out") / files[0]).read_text("utf-8")


@pytest.mark.usefixtures("no_checker")
def test_without_a_checker(verify: Callable) -> None:
    assert verify("ring", "p: left(one.has_)\n").err == (
        f"rosarch: error: no model checker is installed; either will do: {spin.HINT}; {storm.HINT}\n"
    )
    assert verify("ring", "p: left(one.has_)\n", "--checker", "storm").err == f"rosarch: error: {storm.HINT}\n"


@pytest.mark.skipif(not storm.is_installed(), reason=storm.HINT)
def test_too_many_states(verify: Callable) -> None:
    found = verify("chain", "p: response(sent(/a), sent(/c))\n", "--checker", "storm", "--time-limit", "0.001")
    assert found.code == 1
    assert "p: undecided" in found.out
    assert "  note: Storm did not end within 0.001 s; most values have " in found.out


@pytest.mark.slow
@pytest.mark.parametrize("checker", [spin, storm], ids=["spin", "storm"])
def test_too_little_memory(checker: ModuleType) -> None:
    if not checker.is_installed():
        pytest.skip(checker.HINT)
    switches = range(16)
    node = {
        "ports": [{"id": f"p{i}", "kind": "subscriber", "name": f"/t{i}", "queue": 1} for i in switches],
        "state_variables": [{"name": f"Panel::s{i}", "type": "bool", "initial": "false", "at": "panel.h:1"} for i in switches],
        "transitions": [{"variable": f"Panel::s{i}", "trigger": [f"p{i}"], "value": f"!s{i}", "at": "panel.cpp:1"} for i in switches],
    }
    system = system_of({"panel": node})
    text = f"p: absence({' and '.join(f'panel.s{i} and sent(/t{i})' for i in switches)})\nq: true\n"
    held = bytearray(256 << 20)  # what this process has does not count
    found = verify_all(system, read_properties(text, "f", system), Inputs(), checker.__name__.rsplit(".")[-1], limits=Limits(memory=200))
    assert [one.verdict for one in found] == ["undecided", "holds"]
    assert re.match(r"(SPIN|Storm) gave up.*; most values have panel\.s0 \(2\), ", found[0].notes[-1])
    assert not any(held)


def test_mistakes(verify: Callable) -> None:
    assert verify("ring", "p: left(one.hass_)\n").err == "rosarch: error: p:1:9: /one has no state variable `hass_`, did you mean `has_`?\n"
    assert verify("ring", "p: true\n", "--property", "q").err == "rosarch: error: p: no property q\n"
    assert verify("ring", "p: true\n", "--scenario", "none.yml").err.startswith("rosarch: error: none.yml: cannot be read")
    assert verify("ring", "p: true\nq: false\n", "--export", "jani").err == (
        "rosarch: error: 2 properties; choose one with --property, or write all with --output DIR\n"
    )
