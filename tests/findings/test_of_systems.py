"""From rows of checks to findings: messages, the chain of evidence, and what becomes of several systems."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from handmade_findings import MISMATCH

from rosarch.analysis.systems.analysis import _together
from rosarch.base.places import Place
from rosarch.datalog import Program, load_program
from rosarch.findings.model import Change, Evidence, Finding
from rosarch.findings.of_systems import findings
from rosarch.rule_programs.checks import CheckError, evidence_of, require_places, shown_as

CHECK = replace(
    MISMATCH,
    message="{port} sends {topic} to {many} nodes",
    evidence=(("port", ""), ("other", "told of {topic}"), ("other", "")),
    relation="found",
    columns=(("port", "NodePort"), ("other", "NodePort"), ("topic", "symbol"), ("many", "number")),
)
RULES = """
.type NodePort <: symbol
.type Place <: symbol
.decl found(port: NodePort, other: NodePort, topic: symbol, many: number)
found("a", "b", "/t", 2). found("c", "b", "/u", 1).
.decl evidence_of_node_port(port: NodePort, step: number, text: symbol, place: Place)
evidence_of_node_port("a", 1, "then", "y"). evidence_of_node_port("a", 0, "first", "x"). evidence_of_node_port("b", 0, "other", "z").
.decl shown_as_node_port(port: NodePort, text: symbol)
shown_as_node_port("a", "the port a").
"""
PLACES = {"x": Place("x.cpp", 1, 1), "y": Place("y.launch", 2, 1), "z": Place("z.cpp", 3, 1)}


def program(folder: Path) -> Program:
    (folder / "rules.dl").write_text(RULES)
    return load_program(folder / "rules.dl")


def test_names_of_the_relations_for_a_type() -> None:
    assert (evidence_of("NodePort"), shown_as("Start"), evidence_of("PortModel")) == (
        "evidence_of_node_port", "shown_as_start", "evidence_of_port_model",
    )  # fmt: skip


def test_fixes(tmp_path: Path) -> None:
    """Rows of the fix belong to the rows of the check that have the same values in the columns that both have."""
    rules = RULES + (
        ".decl found_fix(port: NodePort, topic: symbol, at: Place, written: symbol, meant: symbol)\n"
        'found_fix("a", "/t", "y", "u", "v"). found_fix("a", "/t", "x", "", "w"). found_fix("a", "/u", "x", "s", "t"). found_fix("c", "/t", "x", "s", "t").'
    )
    (tmp_path / "rules.dl").write_text(rules)
    check = replace(CHECK, fix_columns=("port", "topic", "at", "written", "meant"))
    first, second = findings([check], load_program(tmp_path / "rules.dl").evaluate({}, keep="all"), PLACES, "robot.launch")
    assert first.changes == (Change(PLACES["x"], "", "w"), Change(PLACES["y"], "u", "v"))
    assert second.changes == ()
    assert _together([first, replace(first, changes=first.changes[:1], systems=("a.launch",))]) == (
        replace(first, systems=("a.launch", "robot.launch")),
    )


def test_messages_and_evidence(tmp_path: Path) -> None:
    first, second = findings([CHECK], program(tmp_path).evaluate({}, keep="all"), PLACES, "robot.launch")
    assert first == Finding(
        CHECK,
        "error",
        "the port a sends /t to 2 nodes",
        (
            Evidence("first", Place("x.cpp", 1, 1)),
            Evidence("then", Place("y.launch", 2, 1)),
            Evidence("told of /t", Place("z.cpp", 3, 1)),
            Evidence("other", Place("z.cpp", 3, 1)),
        ),
        ("robot.launch",),
    )
    assert (second.message, second.place) == ("c sends /u to 1 nodes", Place("z.cpp", 3, 1))


def test_a_check_must_have_a_place(tmp_path: Path) -> None:
    require_places([CHECK], program(tmp_path).relations)
    with pytest.raises(CheckError) as caught:
        require_places([replace(CHECK, evidence=(("port", ""), ("topic", "")), path="found.dl")], program(tmp_path).relations)
    assert str(caught.value) == "found.dl:1:1: no relation `evidence_of_symbol` tells the place of the column `topic`"


def test_a_finding_of_several_systems_is_one() -> None:
    def finding_of(message: str, system: str, line: int = 1) -> Finding:
        return Finding(CHECK, "error", message, (Evidence("", Place("a.cpp", line, 1)),), (system,))

    merged = _together([finding_of("m", "b"), finding_of("n", "b"), finding_of("m", "a"), finding_of("m", "a", 2)])
    assert [(each.message, each.place.line, each.systems) for each in merged] == [("m", 1, ("a", "b")), ("n", 1, ("b",)), ("m", 2, ("a",))]


def test_a_finding_of_several_nodes_by_one_line_is_one() -> None:
    def finding_of(node: str, says: str = "is late", line: int = 1) -> Finding:
        place = Place("a.cpp", line, 1)
        return Finding(CHECK, "error", f"{node} {says}", (Evidence("", place),), ("s",), (), node, f" {says}")

    merged = _together([finding_of("/b"), finding_of("/a"), finding_of("/c"), finding_of("/a", "waits"), finding_of("/b", line=2)])
    assert [(each.message, each.place.line) for each in merged] == [("/a is late (also: /b, /c)", 1), ("/a waits", 1), ("/b is late", 2)]


def test_a_finding_of_several_configurations_of_one_node_is_one() -> None:
    def finding_of(line: int, system: str, node: str = "/a", path: str = "a.cpp") -> Finding:
        return Finding(CHECK, "error", f"{node} is late", (Evidence("", Place(path, line, 1)),), (system,), (), node, " is late")

    merged = _together([finding_of(2, "s"), finding_of(1, "t"), finding_of(1, "t", path="b.cpp"), finding_of(1, "s", "/b", "b.cpp")])
    assert [(each.message, str(each.place), each.systems) for each in merged] == [
        ("/a is late", "a.cpp:1", ("s", "t")),
        ("/a is late (also: /b)", "b.cpp:1", ("s", "t")),
    ]
    assert [each.place.line for each in merged[0].evidence] == [1, 2]
    # two lines of one system are two faults, as are those of findings that are about no node
    assert len(_together([finding_of(2, "s"), finding_of(1, "s"), finding_of(1, "t")])) == 2
    assert len(_together([replace(finding_of(2, "s"), node="", fault=""), replace(finding_of(1, "t"), node="", fault="")])) == 2
