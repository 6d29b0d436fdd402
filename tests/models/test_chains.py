"""Steps of chains: how long something waits."""

from __future__ import annotations

import pytest

from rosarch.models.system.chains import PortShown, Step

HERE = PortShown("/in", "subscriber", "/node", None)


@pytest.mark.parametrize(
    ("kind", "certain", "filters", "waits", "expected"),
    [
        ("reactive", False, ("C::ready",), (), True),
        ("kept", True, (), (), False),
        ("deferred", True, (), ((0.1, "sending"),), True),
        ("deferred", True, (), (), False),
        ("deferred", False, ("C::goal",), ((0.1, "sending"),), True),  # what was kept decides by itself
        ("deferred", False, ("C::goal", "C::last"), ((0.1, "sending"),), False),  # something else may hold it back in any round
    ],
)
def test_waits_are_bounded(
    kind: str, certain: bool, filters: tuple[str, ...], waits: tuple[tuple[float, str], ...], expected: bool
) -> None:
    step = Step(HERE, HERE, kind, "data", certain, variables=("C::goal",), filters=filters, waits=waits)
    assert step.bounded == expected
