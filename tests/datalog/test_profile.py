"""Profiles: rules and relations by time and tuples."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from rosarch.datalog import DatalogError, Program, profile, profile_text


def test_counts(graph: Program, graph_facts: Any) -> None:
    found = profile(graph, graph_facts)
    rules = {Path(r.place).name: r for r in found.rules}
    assert {place: (r.relation, r.rows) for place, r in rules.items()} == {
        "p.dl:8": ("path", 4), "p.dl:9": ("path", 5), "p.dl:11": ("degree", 4), "p.dl:13": ("hub", 1),
    }  # fmt: skip
    assert rules["p.dl:8"].calls == 1
    assert rules["p.dl:9"].calls > 1
    assert {r.relation: (r.rules, r.rows) for r in found.relations} == {"path": (2, 9), "degree": (1, 4), "hub": (1, 1)}
    assert [r.seconds for r in found.rules] == sorted((r.seconds for r in found.rules), reverse=True)
    assert found.result.rows("hub") == [("c", 3)]
    assert found.seconds >= sum(r.seconds for r in found.rules)


def test_evaluations_after_it_are_not_measured(graph: Program, graph_facts: Any) -> None:
    found = profile(graph, graph_facts)
    calls = [r.calls for r in found.rules]
    assert graph.evaluate(graph_facts, keep="all").rows("path") == found.result.rows("path")
    assert [r.calls for r in found.rules] == calls


def test_text(graph: Program, graph_facts: Any) -> None:
    text = profile_text(profile(graph, graph_facts), most=2, shorten=lambda place: Path(place).name)
    lines = [re.sub(r"\d+\.\d+", "T", line) for line in text.splitlines()]
    assert lines[0] == "T ms, T ms of it in 4 rules"
    assert lines[2].split() == ["ms", "rows", "calls", "relation", "rule"]
    assert lines[5] == "... 2 more"
    assert lines[7].split() == ["ms", "rows", "rules", "relation"]


def test_an_error_leaves_the_program_as_it_was(graph: Program) -> None:
    with pytest.raises(DatalogError, match="facts of `edge`: expected 2 columns"):
        profile(graph, {"edge": [("a",)]})
    assert graph.evaluate({}, keep="all").rows("path") == []
