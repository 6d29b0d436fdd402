"""Property files: what they mean, and what is said about mistakes."""

from __future__ import annotations

from pathlib import Path

import pytest
from hand_made import load, system_of

from rosarch.behavior.verification import ltl
from rosarch.behavior.verification.ltl import Happens, InState
from rosarch.behavior.verification.properties import PropertyError, read_properties

SYSTEM = system_of(load(Path(__file__).parent / "systems" / "handshake.yml")["nodes"])


def formula(text: str) -> ltl.Formula:
    (item,) = read_properties(f"p: {text}", "f", SYSTEM)
    return item.formula


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("G client.state_ == IDLE", "always (client.state_ == IDLE)"),
        ("client.state_ != IDLE", "not client.state_ == IDLE"),
        ("sent(/request) -> F sent(/answer)", "sent(/request) implies eventually sent(/answer)"),
        ("sent(/request) U sent(/answer) && true", "(sent(/request) until sent(/answer)) and true"),
        ("true || false && true", "true || (false && true)"),
        ("true -> false -> true", "true -> (false -> true)"),
        ("used(server, /request)", "!(dropped(server, /request) || ignored(server, /request))"),
        ("left(client.state_ == IDLE)", "response(client.state_ == IDLE, client.state_ != IDLE)"),
        ("sent(request)", "sent(/request)"),
        ("received(/server, /request) # a comment", "received(server, /request)"),
    ],
)
def test_spellings_of_one_formula(text: str, same: str) -> None:
    assert formula(text) == formula(same)


def test_atoms_are_resolved() -> None:
    atoms = ltl.atoms(formula("always (client.state_ == WAITING -> sent(client, /request))"))
    assert [type(atom) for atom in atoms] == [InState, Happens]
    assert atoms[0] == InState("/client", "Client::state_", frozenset({"WAITING"}))
    assert isinstance(atoms[1], Happens)
    assert str(atoms[1].event) == "sent(/client, /request)"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("p: cliant.state_ == IDLE", "f:1:4: no node `cliant`, did you mean `client`?"),
        ("p: client.stat_ == IDLE", "f:1:4: /client has no state variable `stat_`, did you mean `state_`?"),
        ("p: client.state_ == IDEL", "f:1:21: `client.state_` is never told apart as `IDEL`, did you mean `IDLE`?"),
        ("p: client.state_", "f:1:4: `client.state_` is no truth value; compare it with one of IDLE, WAITING"),
        ("p: always sent(/requests)", "f:1:16: no topic `/requests`, did you mean `/request`?"),
        ("p: received(server, /answer)", "f:1:13: /server does not receive /answer; /client receives it"),
        ("p: sent(server, /request)", "f:1:9: /server does not send /request; /client sends it"),
        ("p: respons(true, true)", "f:1:4: there is no `respons(...)`, did you mean `response`?"),
        ("p: response(true)", "f:1:4: `response` takes two formulas"),
        ("p: received(server)", "f:1:4: `received` takes a node and a topic"),
        ("p: true and\n", "f:1:12: the formula ends too early"),
        ("p: (true", "f:1:9: the formula ends too early"),
        ("p: true) and", "f:1:8: `)` does not fit here"),
        ("p: true\np: false", "f:2:1: there is a property `p` already, in line 1"),
        ("# nothing\n", "f:1:1: no property; one is written as `name: always (node.variable == VALUE)`"),
    ],
)
def test_mistakes_are_told_with_their_place(text: str, message: str) -> None:
    with pytest.raises(PropertyError) as error:
        read_properties(text, "f", SYSTEM)
    assert str(error.value) == message


def test_all_mistakes_are_told() -> None:
    with pytest.raises(PropertyError) as error:
        read_properties("p: a.b\nq: sent(/c)", "f", SYSTEM)
    assert [line.split(":")[1] for line in str(error.value).split("\n")] == ["1", "2"]


@pytest.mark.parametrize(
    ("text", "safe"),
    [
        ("always sent(/request)", True),
        ("precedence(sent(/request), sent(/answer))", True),
        ("left(sent(/request))", False),
        ("!eventually sent(/request)", True),
    ],
)
def test_what_needs_fairness(text: str, safe: bool) -> None:
    assert ltl.is_safety(formula(text)) is safe


@pytest.mark.parametrize("value", ["2", "CRITICAL", "Monitor::CRITICAL"])
def test_a_constant_is_called_by_its_number_or_its_name(value: str) -> None:
    monitor = {
        "ports": [{"id": "p1", "kind": "subscriber", "name": "/battery", "queue": 1}],
        "state_variables": [{"name": "Monitor::state", "type": "int", "initial": "self.OK", "at": "monitor.py:9"}],
        "transitions": [
            {
                "variable": "Monitor::state",
                "trigger": ["p1"],
                "guard": "self.state == self.OK",
                "value": "self.CRITICAL",
                "at": "monitor.py:20",
            }
        ],
        "traits": {"names_number": [["OK", "0"], ["CRITICAL", "2"]]},
    }
    (item,) = read_properties(f"p: monitor.state == {value}", "f", system_of({"monitor": monitor}))
    assert item.formula == InState("/monitor", "Monitor::state", frozenset({"2"}))


@pytest.mark.parametrize("value", ["'open'", '"open"', "open"])
def test_a_text_may_be_written_without_its_quotes(value: str) -> None:
    door = {
        "ports": [{"id": "p1", "kind": "subscriber", "name": "/call", "queue": 1}],
        "state_variables": [{"name": "Door::state", "type": "str", "initial": "'closed'", "at": "door.py:9"}],
        "transitions": [
            {"variable": "Door::state", "trigger": ["p1"], "guard": "self.state == 'closed'", "value": "'open'", "at": "door.py:20"}
        ],
    }
    (item,) = read_properties(f"p: door.state == {value}", "f", system_of({"door": door}))
    assert item.formula == InState("/door", "Door::state", frozenset({"'open'"}))
