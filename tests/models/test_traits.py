"""What components are told to be for the sake of systems: each `traits/*.cpp` says in `// expect:` comments all of it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from node_package import node_model

from rosarch.models.component import ComponentModel
from rosarch.models.traits import TRAITS

HERE = Path(__file__).parent / "traits"
COUNTS = (
    "answers_most",
    "round_sends",
    "round_always",
    "round_of_each",
    "sent_untimed",
    "sent_otherwise",
    "sent_by_itself",
    "synchronised",
    "answers_surely",
    "in_callback",
    "continues_with",
    "done_at_once",
    "gives_way",
    "gives_way_otherwise",
    "runs_any_method",
    "answers_least",
    "round_least",
    "names_message",
    "unsteady_name",
    "gives_another",
)  # `tests/rules/sources/flows_*.cpp` and `answers_*.cpp` have them
MODES = (
    "begins_in",
    "moves_on",
    "moves_freely",
    "asks_for",
    "ignores",
    "answers_in",
    "waits_for",
    "provides_after",
    "sends_in_burst",
)  # and `tests/rules/packages/` these
LIVES = ("unsteady", "unheard", "held_up", "may_be_missed", "perhaps_always")  # `lives/*.cpp` has these
NODES = sorted(HERE.glob("*.cpp"))
LIVING = sorted((HERE.parent / "lives").glob("*.cpp"))


def lines(model: ComponentModel, *, lives: bool = False) -> list[str]:
    """The traits of one group, one line each: ports by name, places by line."""
    ports = {port.id: port.name for port in model.ports}

    def shown(kind: str, value: Any) -> str:
        return ports[value] if kind == "port" else str(value.line) if kind == "place" else value

    asked = LIVES if lives else set(TRAITS) - {*COUNTS, *MODES, *LIVES}
    return sorted(" ".join([t.name, *map(shown, TRAITS[t.name], t.values)]) for t in model.traits if t.name in asked)


@pytest.mark.parametrize("node", LIVING, ids=lambda node: node.stem)
def test_what_goes_on_and_in_which_order_is_as_expected(node: Path, tmp_path: Path) -> None:
    source = node.read_text(encoding="utf-8")
    model = node_model(tmp_path, source)
    assert lines(model, lives=True) == sorted(re.findall(r"^// expect: (.*)$", source, re.MULTILINE))


@pytest.mark.parametrize("node", NODES, ids=lambda node: node.stem)
def test_traits_are_as_expected(node: Path, tmp_path: Path) -> None:
    source = node.read_text(encoding="utf-8")
    model = node_model(tmp_path, source)
    assert lines(model) == sorted(re.findall(r"^// expect: (.*)$", source, re.MULTILINE))
    assert ("// expect:" in source) != node.stem.endswith("_not")
