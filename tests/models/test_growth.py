"""What is derived of a system grows as the system does: with its nodes and connections, not with their squares."""

from __future__ import annotations

from pathlib import Path

import pytest
from check_speed import make_workspace

from rosarch.analysis.method import PLAIN
from rosarch.cli.systems import SystemInputs, load_shared_facts
from rosarch.models.system.build import evaluate
from rosarch.rule_programs.sets import system_rules

BUS = 6
"""Nodes that share a topic."""


def derived(folder: Path, nodes: int) -> dict[str, int]:
    """The rows of every relation for a system of so many nodes of one component."""
    make_workspace(folder, nodes, 1, BUS)
    shared, (launch,) = load_shared_facts(SystemInputs(folder, PLAIN))
    rules = system_rules()
    result = evaluate(rules, shared.rows(launch), keep=list(rules.program.relations))
    return {name: result.count(name) for name in result.names()}


@pytest.mark.slow
def test_rows_grow_as_nodes_do(tmp_path: Path) -> None:
    small, large = derived(tmp_path / "small", 3 * BUS), derived(tmp_path / "large", 6 * BUS)
    assert large["connected"] == 2 * small["connected"] >= 2 * 3 * BUS * BUS
    assert large["joins_connector"] == 2 * small["joins_connector"]
    assert {name: (small[name], large[name]) for name in large if large[name] > 2 * small[name] + 2 * BUS} == {}
