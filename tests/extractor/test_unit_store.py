"""Files of units: what many units have of one function is kept and read as one."""

from __future__ import annotations

import random
from pathlib import Path

from rosarch.extractor.unit_store import UnitRows, UnitStore

FUNCTION = "shared@common.hpp:1:1"
EXPRESSIONS = [f"common.hpp:{line}:1:use" for line in range(2, 40)]


def _unit(own: str, order: random.Random) -> dict[str, list[tuple[str | int, ...]]]:
    """The rows of a unit with a function of a header, in any order."""
    expressions = order.sample(EXPRESSIONS, len(EXPRESSIONS))
    return {
        "function": [(FUNCTION, "function"), (own, "function")],
        "expr_function": [*((each, FUNCTION) for each in expressions), (f"{own}:3:1:use", own)],
        "variable_use": [(each, "counter") for each in expressions],
        "function_use": [(f"{own}:3:1:use", FUNCTION)],
        "program_entry": [(own,)],
    }


def test_a_function_that_units_share_is_unpacked_once(tmp_path: Path) -> None:
    store = UnitStore(tmp_path, None)
    for number in range(4):
        store.keep(f"unit{number}", ((), ()), _unit(f"main@{number}.cpp:1:1", random.Random(number)))
    rows = UnitRows([store.path(f"unit{number}") for number in range(4)])
    found = rows.of({})
    assert {row for row in found["expr_function"] if row[1] == FUNCTION} == {(each, FUNCTION) for each in EXPRESSIONS}
    assert len(found["expr_function"]) == len(EXPRESSIONS) + 4
    assert len(rows._packed[FUNCTION]) == 1
