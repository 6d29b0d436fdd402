"""`rosarch verify`: an example, and systems written by hand."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from hand_made import load, system_of

from rosarch.verification import spin, storm

SYSTEMS = Path(__file__).parent.parent / "verification" / "systems"
needs_checker = pytest.mark.skipif(not (spin.is_installed() or storm.is_installed()), reason=f"{spin.HINT}; {storm.HINT}")


@pytest.fixture
def verify(rosarch: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable:
    """Verify properties of a system written by hand."""
    monkeypatch.chdir(tmp_path)

    def run(name: str, properties: str, *words: str):
        Path("p").write_text(properties)
        monkeypatch.setattr("rosarch.cli.verify.load_composed", lambda *_: system_of(load(SYSTEMS / f"{name}.yml")["nodes"]))
        return rosarch("verify", tmp_path, "--properties", "p", *words)

    return run


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


@pytest.mark.parametrize(
    ("language", "files"), [("promela", ["p.pml"]), ("prism", ["p.prism", "p.props"]), ("jani", ["p.jani"])], ids=lambda value: str(value)
)
def test_export_needs_no_checker(verify: Callable, monkeypatch: pytest.MonkeyPatch, language: str, files: list[str]) -> None:
    for checker in (spin, storm):
        monkeypatch.setattr(checker, "is_installed", lambda: False)
    found = verify("ring", "p: left(one.has_)\n", "--export", language, "--output", "out")
    assert found.code == 0, found.err
    assert sorted(path.name for path in Path("out").iterdir()) == files
    assert "one_has" in (Path("out") / files[0]).read_text("utf-8")


def test_without_a_checker(verify: Callable, monkeypatch: pytest.MonkeyPatch) -> None:
    for checker in (spin, storm):
        monkeypatch.setattr(checker, "is_installed", lambda: False)
    assert verify("ring", "p: left(one.has_)\n").err == (
        f"rosarch: error: no model checker is installed; either will do: {spin.HINT}; {storm.HINT}\n"
    )
    assert verify("ring", "p: left(one.has_)\n", "--checker", "storm").err == f"rosarch: error: {storm.HINT}\n"


@pytest.mark.skipif(not storm.is_installed(), reason=storm.HINT)
def test_too_many_states(verify: Callable) -> None:
    found = verify("chain", "p: response(sent(/a), sent(/c))\n", "--checker", "storm", "--time-limit", "0.001")
    assert found.code == 2
    assert found.err.startswith("rosarch: error: p: Storm did not end within 0.001 s; most values have ")


def test_mistakes(verify: Callable) -> None:
    assert verify("ring", "p: left(one.hass_)\n").err == "rosarch: error: p:1:9: /one has no state variable `hass_`, did you mean `has_`?\n"
    assert verify("ring", "p: true\n", "--property", "q").err == "rosarch: error: p: no property q\n"
    assert verify("ring", "p: true\n", "--scenario", "none.yml").err.startswith("rosarch: error: none.yml: cannot be read")
    assert verify("ring", "p: true\nq: false\n", "--export", "jani").err == (
        "rosarch: error: 2 properties; choose one with --property, or write all with --output DIR\n"
    )
