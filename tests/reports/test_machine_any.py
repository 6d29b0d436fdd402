"""No document, whatever is in it, makes a machine that a format cannot tell."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from jsonschema import Draft202012Validator
from machine_documents import Document, document
from test_machine_scxml import schema

from rosarch.models.machine.build import build_machine
from rosarch.reports.behavior_markdown import behaviors_text as behavior_markdown
from rosarch.reports.behavior_text import behaviors_text as behavior_text
from rosarch.reports.machine_json import machine_schema
from rosarch.reports.machines import WRITERS, machines_text

PIECES = st.sampled_from(
    ["a_", "b_", "n_", "N::a_", "this->b_", "A", "Mode::B", "true", "false", "NULL", "0", "1", "-1.5", "'x'", '"t"', "msg->x", "f(x)", "q_", ".empty()",
     ".size()", ".x", "(", ")", "!", "&&", "||", "==", "!=", "<", ">=", "++", "+ 1", "=", ",", "?", ":", "\n", "<b>", "&amp;", "--", "]]>", "\\", "\x00", "é"]
)  # fmt: skip
TEXTS = st.one_of(st.none(), st.lists(PIECES, min_size=1, max_size=7).map(" ".join), st.text(max_size=12))
NAMES = st.sampled_from(["N::a_", "N::b_", "N::n_", "::q_", "M::a_", "x", "", "N::n_.y"])
TRIGGERS = st.lists(st.sampled_from(["p1", "p2", "periodic", "main", "?\n"]), min_size=1, max_size=2)
DOCUMENTS = st.builds(
    document,
    variables=st.lists(
        st.tuples(NAMES, st.sampled_from(["bool", "int", "Mode", "T*", "std::vector<int>", "", "shared_ptr<T>"]), TEXTS), max_size=4
    ),
    transitions=st.lists(st.tuples(NAMES, TRIGGERS, TEXTS, TEXTS), max_size=6),
    reactive=st.lists(st.tuples(st.sampled_from(["p1", "p2"]), st.sampled_from(["p3", "p4"]), TEXTS), max_size=3),
    periodic=st.lists(
        st.tuples(st.sampled_from([None, 0.0, 10.0]), st.lists(st.sampled_from(["p3", "p4"]), max_size=2), TEXTS), max_size=2
    ),
    ports=st.just(["p1", "p2", "p3"]),
)


@pytest.mark.slow
@settings(max_examples=150, deadline=None)
@given(DOCUMENTS, st.sampled_from([1, 16]), st.booleans())
def test_every_machine_can_be_told(node: Document, max_states: int, joint: bool) -> None:
    machine = build_machine(node, max_states=max_states, joint=joint)
    for form in WRITERS:
        assert machines_text([machine], form) == machines_text([build_machine(node, max_states=max_states, joint=joint)], form)
    assert [error.reason for error in schema().iter_errors(machines_text([machine], "scxml"))] == []
    Draft202012Validator(machine_schema()).validate(json.loads(machines_text([machine], "json"))[0])
    assert behavior_text([node]).splitlines()[0] == "p/n  node n"
    assert behavior_markdown([node]).splitlines()[0] == "## p/n (node n)"


@pytest.mark.slow
@settings(max_examples=150, deadline=None)
@given(DOCUMENTS)
def test_states_and_transitions_fit_together(node: Document) -> None:
    machine = build_machine(node)
    for region in machine.regions:
        assert len(set(region.states)) == len(region.states)
        assert set(region.initial) <= set(range(len(region.states)))
        reached, waiting = set(region.initial), list(region.initial)
        for state in waiting:
            following = {t.target for t in region.transitions if t.source == state} - reached
            reached |= following
            waiting += following
        assert reached == set(range(len(region.states)))
        assert not set(region.states) & set(region.unreachable)
        for values in region.states:
            assert all(value in cell.subject.values for cell, value in zip(region.cells, values, strict=True))
        for transition in region.transitions:
            after = dict(zip([cell.subject.key for cell in region.cells], region.states[transition.target], strict=True))
            assert dict(transition.assigned).items() <= after.items()
            assert transition.rows
    happening = {row for region in machine.regions for t in region.transitions for row in t.rows if t.visible}
    assert happening.isdisjoint(machine.dead)
