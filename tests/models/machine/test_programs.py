"""Machines against the execution of the callbacks that they are made from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine_documents import document

from rosarch.models.machine.build import StateMachine, build_machine
from rosarch.models.machine.logic import Formula, evaluate

VALUES = {"a_": ("false", "true"), "b_": ("false", "true"), "m_": ("A", "B", "C")}
INPUTS = ("msg->x", "msg->y")
Values = Mapping[str, str]


@dataclass(frozen=True)
class Assign:
    """`variable = value`, the value a constant, an input or another variable of the same kind."""

    variable: str
    value: str


@dataclass(frozen=True)
class Send:
    """A publish."""

    port: str


@dataclass(frozen=True)
class If:
    """`if (condition) ... else ...`."""

    condition: str
    yes: Body
    no: Body


Body = tuple["Assign | Send | If", ...]

FLAGS = st.sampled_from(["a_", "b_"])
ASSIGNS = st.one_of(
    st.builds(Assign, FLAGS, st.sampled_from(["true", "false", *INPUTS, "!a_", "b_"])),
    st.builds(Assign, st.just("m_"), st.sampled_from(["Mode::A", "Mode::B", "Mode::C"])),
)
LEAVES = st.lists(st.one_of(ASSIGNS, st.builds(Send, st.sampled_from(["p", "q"]))), max_size=3).map(tuple)
CONDITIONS = st.sampled_from(["a_", "!b_", "a_ == b_", "a_ && msg->x", "m_ == Mode::A", "m_ != Mode::B", "msg->x", "!(msg->y || b_)"])
TREES = st.recursive(LEAVES, lambda inner: st.builds(If, CONDITIONS, inner, inner).map(lambda tree: (tree,)), max_leaves=5)
BODIES = st.tuples(st.lists(ASSIGNS, max_size=2).map(tuple), TREES).map(lambda parts: parts[0] + parts[1])


def holds(text: str, values: Values) -> bool:
    words = {"&&": "and", "||": "or", "!": " not "}
    for sign, word in words.items():
        text = text.replace(f"{sign}=", "\0").replace(sign, f" {word} ").replace("\0", "!=")
    names = {name: value == "true" if value in ("true", "false") else value for name, value in values.items()}
    for name in sorted(names, key=len, reverse=True):
        text = text.replace(name, f"v[{name!r}]")
    for mode in VALUES["m_"]:
        text = text.replace(f"Mode::{mode}", repr(mode))
    return bool(eval(text.strip(), {"v": names, "true": True, "false": False}))


def run(body: Body, values: dict[str, str], sent: list[str]) -> None:
    for statement in body:
        if isinstance(statement, Send):
            sent.append(statement.port)
        elif isinstance(statement, If):
            run(statement.yes if holds(statement.condition, values) else statement.no, values, sent)
        elif statement.variable == "m_":
            values["m_"] = statement.value[-1]
        else:
            values[statement.variable] = str(holds(statement.value, values)).lower()


def statements(body: Body, guard: tuple[str, ...] = ()) -> Iterator[tuple[str | None, Assign | Send]]:
    for statement in body:
        if isinstance(statement, If):
            yield from statements(statement.yes, (*guard, f"({statement.condition})"))
            yield from statements(statement.no, (*guard, f"!({statement.condition})"))
        else:
            yield " && ".join(guard) or None, statement


def component(bodies: Mapping[str, Body]) -> dict[str, Any]:
    """The document of a node with these callbacks."""
    found = document(variables=[("N::a_", "bool", "false"), ("N::b_", "bool", "true"), ("N::m_", "Mode", "Mode::A")])
    line = 0
    for trigger, body in bodies.items():
        for guard, statement in statements(body):
            line += 1
            place = f"n.cpp:{line}"
            if isinstance(statement, Assign):
                found["transitions"].append(
                    {"variable": f"N::{statement.variable}", "trigger": [trigger], "guard": guard, "value": statement.value, "at": place}
                )
            else:
                found["reactive"].append({"input": trigger, "output": statement.port, "at": [place], "must": guard is None, "when": guard})
    return found


def react(machine: StateMachine, at: list[int], trigger: str, inputs: Values) -> tuple[list[int], set[str]]:
    known = {
        cell.subject.key: value
        for region, state in zip(machine.regions, at, strict=True)
        for cell, value in zip(region.cells, region.states[state], strict=True)
    }

    def true(formula: Formula) -> bool:
        return evaluate(formula, lambda s: known[s.key] if s.cell else inputs.get(s.text) or str(holds(s.text, inputs)).lower()) is True

    sent: set[str] = set()
    following = []
    for region, state in zip(machine.regions, at, strict=True):
        taken = [t for t in region.transitions if (t.source, t.trigger) == (state, trigger) and true(t.guard)]
        assert len(taken) <= 1, taken
        following += [t.target for t in taken] or [state]
        sent |= {output.port for t in taken for output in t.outputs if true(output.when)}
    sent |= {output.port for t in machine.always if t.trigger == trigger for output in t.outputs if true(output.when)}
    return following, sent


@pytest.mark.slow
@settings(max_examples=200, deadline=None)
@given(
    st.fixed_dictionaries({"t": BODIES, "u": BODIES}),
    st.booleans(),
    st.lists(
        st.tuples(st.sampled_from("tu"), st.fixed_dictionaries({name: st.sampled_from(["true", "false"]) for name in INPUTS})), max_size=8
    ),
)
def test_a_machine_does_what_the_callbacks_do(bodies: Mapping[str, Body], joint: bool, events: list[tuple[str, Values]]) -> None:
    machine = build_machine(component(bodies), joint=joint)
    values = {"a_": "false", "b_": "true", "m_": "A"}
    at = [region.initial[0] for region in machine.regions]
    for trigger, inputs in events:
        sent: list[str] = []
        before = values  # what is never assigned is no state, but an input that stays as it is
        executed = {**values, **inputs}
        run(bodies[trigger], executed, sent)
        values = {name: executed[name] for name in VALUES}
        at, told = react(machine, at, trigger, {**before, **inputs})
        assert told == set(sent)
        for region, state in zip(machine.regions, at, strict=True):
            for cell, value in zip(region.cells, region.states[state], strict=True):
                assert value == values[cell.subject.text], (trigger, inputs, cell.subject.text)
