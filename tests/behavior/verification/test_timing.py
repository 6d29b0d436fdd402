"""Whether a run hangs on how fast clocks run beside each other."""

from __future__ import annotations

import pytest

from rosarch.behavior.composition.model import Command, Model, Variable
from rosarch.behavior.verification.timing import clocks_compared

ON, OFF = "on", "off"
SWITCH = Variable(("/node", "switch"), "node.switch", (ON, OFF), (OFF,))
IDLE = Command("/node", "idles", ((0, frozenset({OFF})),), clock="fast")
START = Command("/other", "starts", (), given=((0, ON),), clock="slow")
STOP = Command("/other", "stops", (), given=((0, OFF),), clock="slow")


@pytest.mark.parametrize(
    ("taken", "repeated", "clocks"),
    [
        ([0], [0], set()),
        ([0, 2], [0, 2], set()),
        ([0], [], {"fast", "slow"}),
        ([0, 1, 2], [0, 1, 2], {"fast", "slow"}),
    ],
    ids=["nothing_changes", "given_what_it_is", "once", "changes_meanwhile"],
)
def test_idle_rounds_come_at_any_time_where_nothing_changes(taken: list[int], repeated: list[int], clocks: set[str]) -> None:
    model = Model("system", (SWITCH,), (), (IDLE, START, STOP), (), ())
    assert clocks_compared(model, taken, repeated) == clocks
