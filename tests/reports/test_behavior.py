"""The tables of behaviour, to the letter."""

from __future__ import annotations

import json
from pathlib import Path

from machine_documents import document

from rosarch.reports import behavior, behavior_markdown, behavior_text

EXPECTED = Path(__file__).resolve().parents[2] / "examples/docking_states/expected/auto_docking"

LAMP = """\
auto_docking/dock_lamp  node dock_lamp
  timed loops
    rate  by    sends  source            when
    2 Hz  rate  lamp   dock_lamp.cpp:44  g_alarm || g_charging != g_lit

  state
    variable      type  begins  source
    ::g_charging  bool  false   dock_lamp.cpp:9
    ::g_alarm     bool  false   dock_lamp.cpp:10
    ::g_lit       bool  false   dock_lamp.cpp:11

  transitions
    variable      becomes   on        source            when
    ::g_charging  msg.data  charging  dock_lamp.cpp:15
    ::g_alarm     msg.data  bumper    dock_lamp.cpp:20
    ::g_lit       !g_lit    periodic  dock_lamp.cpp:39  g_alarm || g_charging != g_lit
"""


def test_a_node_with_all_but_reactions() -> None:
    lamp = json.loads((EXPECTED / "dock_lamp.json").read_text())
    assert behavior_text.behaviors_text([lamp]) == LAMP


def test_reactions_and_odd_rows() -> None:
    node = document(
        variables=[("N::x_", "int", None)],
        transitions=[("N::x_", ["a", "periodic"], None, None)],
        reactive=[("a", "b", None), ("a", "b", "x_ >\n 3")],
        periodic=[(None, [], None), (0.5, ["b"], None)],
        ports=["a", "b"],
    )
    node["reactive"][1]["at"] = ["d/n.cpp:51", "d/n.cpp:60", "other.cpp:3"]
    node["periodic"][1]["hz_from_param"] = "~rate"
    node["transitions"][0]["field"] = "y"
    node["one_shot"] = [
        {"after": 3.5, "after_from_param": "~delay", "output": "b", "sent_at": ["n.cpp:5"], "must": True, "at": "n.cpp:9", "when": None}
    ]
    assert behavior_text.behaviors_text([node, document()]) == (
        "p/n  node n\n"
        "  reactions\n"
        "    on                                   sends          source                    when\n"
        "    a                                    b      always  n.cpp:50\n"
        "    a                                    b      may     n.cpp:51 :60 other.cpp:3  x_ > 3\n"
        "    timer, once after 3.5 s from ~delay  b      always  n.cpp:5\n"
        "\n"
        "  timed loops\n"
        "    rate               by    sends    source\n"
        "    ?                  rate  nothing  n.cpp:80\n"
        "    0.5 Hz from ~rate  rate  b        n.cpp:81\n"
        "\n"
        "  state\n"
        "    variable  type  begins  source\n"
        "    N::x_     int   ?       n.h:1\n"
        "\n"
        "  transitions\n"
        "    variable  becomes  on           source\n"
        "    N::x_.y   ?        a, periodic  n.cpp:10\n"
        "\n"
        "p/n  node n\n"
        "  no reactions, no timed loops, no state\n"
    )


def test_what_is_sent_beside_reactions_and_loops_is_said() -> None:
    node = document()
    node["ports"] = [{"id": "p1", "name": "~state"}, {"id": "p2", "name": "map"}]
    node["traits"] = {"sent_by_itself": [["p1"]], "sent_at_start": [["p2", "n.cpp:3:1"], ["p2", "n.cpp:4:1"]]}
    assert behavior.nothing(node) == "no reactions, no timed loops, no state; sends at the start: map; sends at other times: ~state"


def test_nothing_is_seen_of_an_open_component() -> None:
    node = document()
    node["open"] = [{"what": ["ports"], "reason": "the node is handed to Arm, which was not seen", "at": "n.cpp:1"}]
    said = "o reactions, no timed loops, no state, as far as was seen"
    assert behavior_text.behaviors_text([node]).endswith(f"\n  n{said}\n")
    assert behavior_markdown.behaviors_text([node]).endswith(f"\nN{said}.\n")


def test_markdown() -> None:
    node = document(reactive=[("a", "b", "x | y <z> `q`")], ports=["a", "b_c"])
    assert behavior_markdown.behaviors_text([node]) == (
        "## p/n (node n)\n"
        "\n"
        "### Reactions\n"
        "\n"
        "| on | sends |  | source | when |\n"
        "|---|---|---|---|---|\n"
        "| a | b | may | n.cpp:50 | x \\| y \\<z> \\`q\\` |\n"
    )
