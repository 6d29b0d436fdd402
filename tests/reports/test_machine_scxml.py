"""SCXML: valid, and run by an interpreter as the machine says.

With SCXML_SCHEMA set to the `scxml.xsd` that the W3C publishes, valid by that; else by the part of SCXML that rosarch writes.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import xmlschema
from hypothesis import given, settings
from hypothesis import strategies as st
from machine_documents import DOOR, Document, document
from statemachine.io import load
from test_machine_text import hostile

from rosarch.models.machine.build import StateMachine, build_machine
from rosarch.models.machine.logic import BOOLEAN, Formula, Subject, evaluate, subjects
from rosarch.models.machine.steps import Output
from rosarch.reports.machine_scxml import machine_text

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
DOCKING: Document = json.loads((EXAMPLES / "docking_states/expected/auto_docking/docking.json").read_text())
LAMP: Document = json.loads((EXAMPLES / "docking_states/expected/auto_docking/dock_lamp.json").read_text())

GATE = document(
    variables=[("Gate::mode_", "Mode", "Mode::AUTO"), ("Gate::last_", "Mode", "Mode::AUTO"), ("Gate::stop_", "bool", "false"), ("Gate::goal_", "Goal*", "NULL")],
    transitions=[
        ("Gate::mode_", "remote", None, "static_cast<Mode>(msg->mode)"),
        ("Gate::stop_", "remote", None, "msg->emergency"),
        ("Gate::last_", "periodic", "last_ != mode_", "mode_"),
        ("Gate::mode_", "periodic", "stop_ && mode_ == Mode::REMOTE", "Mode::AUTO"),
        ("Gate::goal_", "goal", "goal_ == NULL && count > 3", "new Goal(*msg)"),
        ("Gate::goal_", "cancel", "goal_", "NULL"),
    ],
    reactive=[("remote", "cmd", "mode_ == Mode::REMOTE"), ("twist", "cmd", "mode_ == Mode::AUTO && msg->x > 0.1"), ("goal", "busy", "goal_ != NULL && stop_"), ("ping", "pong", "!quiet")],
    periodic=[(10.0, ["mode"], "last_ != mode_")],
    ports=["remote", "twist", "goal", "cancel", "ping", "cmd", "busy", "pong", "mode"],
)  # fmt: skip


@cache
def schema() -> xmlschema.XMLSchema:
    return xmlschema.XMLSchema(os.environ.get("SCXML_SCHEMA", Path(__file__).parent / "scxml_subset.xsd"), allow="local")


def machines() -> list[StateMachine]:
    return [build_machine(node, joint=joint) for node in (DOOR, DOCKING, LAMP, GATE, document()) for joint in (False, True)]


@pytest.mark.parametrize("machine", [*machines(), hostile()], ids=lambda machine: machine.component[:8])
def test_valid(machine: StateMachine) -> None:
    assert [error.reason for error in schema().iter_errors(machine_text(machine))] == []


def test_the_schema_refuses_what_is_not_scxml() -> None:
    text = machine_text(build_machine(DOOR))
    assert not schema().is_valid(text.replace('event="in.close"', 'when="in.close"'))
    assert not schema().is_valid(text.replace("<send", "<publish"))


class Running:
    """An interpreter that runs a document, and what the document sends."""

    def __init__(self, machine: StateMachine) -> None:
        listening = '<state id="listener"><transition event="out.*"/></state>\n  </parallel>'
        self.sent: list[str] = []
        self._chart = load(machine_text(machine).replace("  </parallel>", listening), format="scxml")(listeners=[self])

    def on_transition(self, event: object) -> None:
        if str(event).startswith("out."):
            self.sent.append(str(event)[4:])

    def feed(self, event: str, **data: object) -> list[str]:
        """Send an event and return what is sent in return."""
        self.sent.clear()
        self._chart.send(event, **data)
        return list(self.sent)

    def states(self) -> set[str]:
        """The innermost states that the machine is in."""
        return {state.id for state in self._chart.configuration if "." in state.id}


def test_docking() -> None:
    robot = Running(build_machine(DOCKING))
    assert robot.states() == {"state.IDLE"}
    assert (robot.feed("in.periodic"), robot.states()) == ([], {"state.IDLE"})
    assert (robot.feed("in.dock"), robot.states()) == (["state"], {"state.SEARCHING"})
    assert (robot.feed("in.dock"), robot.states()) == ([], {"state.SEARCHING"})
    assert (robot.feed("in.periodic"), robot.states()) == (["cmd_vel"], {"state.SEARCHING"})
    assert (robot.feed("in.beacon", beacon_point_x_range=False), robot.states()) == ([], {"state.SEARCHING"})
    assert (robot.feed("in.beacon", beacon_point_x_range=True), robot.states()) == (["state"], {"state.APPROACHING"})
    assert (robot.feed("in.charging", charging_data=True), robot.states()) == (["cmd_vel"], {"state.DOCKED"})
    assert (robot.feed("in.charging", charging_data=False), robot.states()) == ([], {"state.IDLE"})
    robot.feed("in.dock")
    assert (robot.feed("in.bumper", pressed_data=True), robot.states()) == (["cmd_vel"], {"state.FAILED"})
    assert (robot.feed("in.cancel"), robot.states()) == (["state"], {"state.IDLE"})


def test_regions_see_each_other() -> None:
    gate = Running(build_machine(GATE))
    assert gate.states() == {"mode.AUTO", "last.AUTO", "stop.off", "goal.null"}
    assert gate.feed("in.remote", msg_mode="REMOTE", msg_emergency=True) == ["cmd"]
    assert gate.states() == {"mode.REMOTE", "last.AUTO", "stop.on", "goal.null"}
    assert gate.feed("in.periodic") == ["mode"]
    assert gate.states() == {"mode.AUTO", "last.REMOTE", "stop.on", "goal.null"}


def test_what_is_sent_hangs_on_regions_that_change_at_the_same_time() -> None:
    node = document(
        variables=[("N::a_", "bool", "false"), ("N::b_", "bool", "false")],
        transitions=[("N::a_", "in", None, "!a_"), ("N::b_", "in", None, "msg->b")],
        reactive=[("in", "first", None), ("in", "second", None), ("in", "third", "a_ && b_")],
        ports=["in", "first", "second", "third"],
    )
    for joint in (False, True):
        running = Running(build_machine(node, joint=joint))
        sent = [sorted(running.feed("in.in", msg_b=value)) for value in (True, False, True, True)]
        assert sent == [["first", "second", "third"], ["first", "second"], ["first", "second", "third"], ["first", "second"]]
    node["transitions"][1]["at"] = "n.cpp:90"  # behind the test
    for joint in (False, True):
        running = Running(build_machine(node, joint=joint))
        sent = [sorted(running.feed("in.in", msg_b=value)) for value in (True, True, False)]
        assert sent == [["first", "second"], ["first", "second"], ["first", "second", "third"]]


def test_a_first_value_that_is_not_told_waits_for_an_event() -> None:
    node = document(variables=[("N::mode_", "Mode", None)], transitions=[("N::mode_", "go", "mode_ == Mode::A", "Mode::B")])
    running = Running(build_machine(node))
    assert running.states() == {"mode.undetermined"}
    running.feed("init.mode.A")
    assert running.states() == {"mode.A"}
    running.feed("in.go")
    assert running.states() == {"mode.B"}


def test_names_are_told_where_they_had_to_change() -> None:
    text = machine_text(build_machine(DOCKING))
    assert "<!-- in.dock: ~dock -->" in text
    assert "<!-- _event.data.beacon_point_x_range: beacon->point.x < range_ -->" in text


def legal(subject: Subject, value: str) -> object:
    """A value as data of an event."""
    if value in BOOLEAN:
        return value == "true"
    return None if value == "null" else "something else" if value == "other" else value.strip("'\"")


def field_names(text: str) -> dict[str, str]:
    """The fields of event data by the inputs they stand for, as the comments tell; an input that is not told is its own name."""
    found = {}
    for line in text.splitlines():
        if line.startswith("<!-- _event.data."):
            name, _, meaning = line.removeprefix("<!-- _event.data.").removesuffix(" -->").partition(": ")
            found[meaning] = name
    return found


class Model:
    """The machine's own account of a run."""

    def __init__(self, machine: StateMachine) -> None:
        self.machine = machine
        self.at = [region.initial[0] for region in machine.regions]

    def _values(self) -> dict[str, str]:
        cells = zip(self.machine.regions, self.at, strict=True)
        return {cell.subject.key: value for region, at in cells for cell, value in zip(region.cells, region.states[at], strict=True)}

    def react(self, trigger: str, choices: Mapping[Subject, str]) -> list[str]:
        known = self._values()

        def holds(formula: Formula) -> bool:
            return evaluate(formula, lambda s: known.get(s.key) if s.cell else choices[s]) is True

        sent: list[Output] = []
        following = []
        for region, at in zip(self.machine.regions, self.at, strict=True):
            taken = [t for t in region.transitions if (t.source, t.trigger) == (at, trigger) and holds(t.guard)]
            assert len(taken) <= 1
            following.append(taken[0].target if taken else at)
            sent += taken[0].outputs if taken else ()
        sent += [output for t in self.machine.always if t.trigger == trigger for output in t.outputs]
        self.at = following
        return [output.port for output in sent if holds(output.when)]


def inputs(machine: StateMachine) -> list[Subject]:
    every = [t for region in machine.regions for t in region.transitions] + list(machine.always)
    formulas = [formula for t in every for formula in (t.guard, *(output.when for output in t.outputs))]
    return sorted({s for formula in formulas for s in subjects(formula) if not s.cell}, key=lambda s: s.key)


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(st.data(), st.sampled_from([(DOOR, False), (DOCKING, False), (LAMP, False), (LAMP, True), (GATE, False), (GATE, True)]))
def test_the_interpreter_does_what_the_machine_says(data: Any, case: tuple[Document, bool]) -> None:
    machine = build_machine(case[0], joint=case[1])
    names, running, model = field_names(machine_text(machine)), Running(machine), Model(machine)
    asked = inputs(machine)
    seen: dict[tuple[int, ...], set[str]] = {tuple(model.at): running.states()}
    for _ in range(12):
        trigger = data.draw(st.sampled_from(machine.triggers))
        choices = {subject: data.draw(st.sampled_from(subject.values)) for subject in asked}
        event = "in." + (trigger.label.strip("~/") if trigger.id in machine.ports else trigger.id)
        sent = running.feed(event, **{names.get(s.text, s.text): legal(s, value) for s, value in choices.items()})
        expected = model.react(trigger.id, choices)
        assert sorted(sent) == sorted(machine.ports[port].strip("~/") for port in expected)
        assert len(running.states()) == len(machine.regions)
        assert seen.setdefault(tuple(model.at), running.states()) == running.states()
    assert len({frozenset(states) for states in seen.values()}) == len(seen)
