"""Small component documents, written by hand, that tests make state machines of."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

Document = dict[str, Any]


def document(
    *,
    variables: Sequence[tuple[str, str, str | None]] = (),
    transitions: Sequence[tuple[str, str | Sequence[str], str | None, str | None]] = (),
    reactive: Sequence[tuple[str, str, str | None]] = (),
    periodic: Sequence[tuple[float | None, Sequence[str], str | None]] = (),
    ports: Sequence[str] = (),
) -> Document:
    """A document: variables as (name, type, initial), transitions as (variable, triggers, guard, value), reactions as (input, output, when).

    Lines are given in the order of the rows: transitions from 10, reactions from 50, loops from 80. Ports are named as they are
    identified.
    """
    return {
        "system": "s", "component": "n", "package": "p", "kind": "node", "node_name": "n", "sources": ["n.cpp"],
        "ports": [{"id": name, "name": name, "kind": "subscriber"} for name in ports],
        "params": [],
        "periodic": [
            {"mechanism": "rate", "hz": hz, "hz_from_param": None, "publishes": list(sent), "at": f"n.cpp:{80 + n}", "conditional": when}
            for n, (hz, sent, when) in enumerate(periodic)
        ],
        "reactive": [
            {"input": input_, "output": output, "at": [f"n.cpp:{50 + n}"], "must": when is None, "when": when}
            for n, (input_, output, when) in enumerate(reactive)
        ],
        "state_variables": [{"name": name, "type": type_, "initial": initial, "at": f"n.h:{n + 1}"} for n, (name, type_, initial) in enumerate(variables)],
        "configuration": [],
        "transitions": [
            {"variable": name, "trigger": [trigger] if isinstance(trigger, str) else list(trigger), "guard": guard, "value": value, "at": f"n.cpp:{10 + n}"}
            for n, (name, trigger, guard, value) in enumerate(transitions)
        ],
    }  # fmt: skip


DOOR = document(
    variables=[("Door::state_", "State", "State::CLOSED"), ("Door::locked_", "bool", "false")],
    transitions=[
        ("Door::state_", "open", "state_ == State::CLOSED && !locked_", "State::OPEN"),
        ("Door::state_", "close", "state_ == State::OPEN", "State::CLOSED"),
        ("Door::locked_", "lock", None, "msg->data"),
    ],
    reactive=[("open", "alarm", "locked_"), ("open", "motor", "state_ == State::CLOSED && !locked_"), ("ping", "pong", None)],
    periodic=[(2.0, ["lamp"], "state_ == State::OPEN")],
    ports=["open", "close", "lock", "ping", "alarm", "motor", "pong", "lamp"],
)
"""A door that opens when it is not locked, lights a lamp while it is open, and answers pings."""
