"""State machines as text and as diagrams, to the letter."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from machine_documents import DOOR, document

from rosarch.models.machine.build import StateMachine, build_machine
from rosarch.reports import machine_dot, machine_mermaid, machine_plantuml, machine_text

TEXT = """\
p/n  node n

state_  n.h:1
  CLOSED | OPEN, begins CLOSED
  CLOSED
    open  -> OPEN  sends motor  n.cpp:10 :51  if !locked_
  OPEN
    close  -> CLOSED              n.cpp:11
    2 Hz   stays      sends lamp  n.cpp:80

locked_  n.h:2
  false | true, begins false
  any state
    lock  -> true   n.cpp:12  if msg->data
    lock  -> false  n.cpp:12  if !msg->data
  true
    open  stays  sends alarm  n.cpp:50

in every state
    ping  sends pong  n.cpp:52
"""

MERMAID = """\
---
title: "p/n"
---
stateDiagram-v2
  state "state_" as r1 {
    state "CLOSED" as r1_0
    state "OPEN" as r1_1
    [*] --> r1_0
    r1_0 --> r1_1 : open [!locked_] sends motor
    r1_1 --> r1_0 : close
    r1_1 : 2 Hz sends lamp
  }
  state "locked_" as r2 {
    state "false" as r2_0
    state "true" as r2_1
    [*] --> r2_0
    r2_0 --> r2_1 : lock [msg-#62;data]
    r2_1 --> r2_0 : lock [!msg-#62;data]
    r2_1 : open sends alarm
  }
  state "in every state" as always
  always : ping sends pong
"""

DOT = """\
digraph "p/n" {
  label="p/n"; labelloc=t; fontname=Helvetica; compound=true;
  node [shape=box, style="rounded", fontname=Helvetica]; edge [fontname=Helvetica, fontsize=10];
  subgraph cluster_r1 {
    label="state_"; style=dotted;
    r1_0 [label="CLOSED"];
    r1_1 [label="OPEN\\n2 Hz sends lamp\\l"];
    r1_start_0 [shape=point]; r1_start_0 -> r1_0;
    r1_0 -> r1_1 [label="open [!locked_] sends motor\\l"];
    r1_1 -> r1_0 [label="close\\l"];
  }
  subgraph cluster_r2 {
    label="locked_"; style=dotted;
    r2_0 [label="false"];
    r2_1 [label="true\\nopen sends alarm\\l"];
    r2_start_0 [shape=point]; r2_start_0 -> r2_0;
    r2_0 -> r2_1 [label="lock [msg->data]\\l"];
    r2_1 -> r2_0 [label="lock [!msg->data]\\l"];
  }
  always [label="in every state\\nping sends pong\\l", style=dashed];
}
"""

PLANTUML = """\
@startuml
title p/n
hide empty description
state "state_" as r1 {
  state "CLOSED" as r1_0
  state "OPEN" as r1_1
  [*] --> r1_0
  r1_0 --> r1_1 : open [!locked_] sends motor
  r1_1 --> r1_0 : close
  r1_1 : 2 Hz sends lamp
}
state "locked_" as r2 {
  state "false" as r2_0
  state "true" as r2_1
  [*] --> r2_0
  r2_0 --> r2_1 : lock [msg-<U+003E>data]
  r2_1 --> r2_0 : lock [!msg-<U+003E>data]
  r2_1 : open sends alarm
}
state "in every state" as always
always : ping sends pong
@enduml
"""


@pytest.mark.parametrize(
    ("writer", "text"),
    [
        (machine_text.machine_text, TEXT),
        (machine_mermaid.machine_text, MERMAID),
        (machine_dot.machine_text, DOT),
        (machine_plantuml.machine_text, PLANTUML),
    ],
)
def test_a_small_machine(writer: Callable[[StateMachine], str], text: str) -> None:
    assert writer(build_machine(DOOR)) == text


JOINT = """\
p/n  node n

set_, sent_  n.h:1 :2
  3 states, begins !set_, !sent_
  any state
    pose, fix  -> set_, !sent_  n.cpp:10 :11
  set_, !sent_
    periodic  -> sent_  sends out  n.cpp:12 :80
  set_, sent_
    fast  -> !sent_  n.cpp:13  if x > 2
  unreachable: !set_, sent_

never happens: n.cpp:14
without finite values: stamp_
"""


def test_variables_that_depend_on_each_other() -> None:
    node = document(
        variables=[("N::set_", "bool", "false"), ("N::sent_", "bool", "false"), ("N::stamp_", "ros::Time", None)],
        transitions=[
            ("N::set_", ["pose", "fix"], None, "true"),
            ("N::sent_", ["pose", "fix"], None, "false"),
            ("N::sent_", "periodic", "set_ && !sent_", "true"),
            ("N::sent_", "fast", "set_ && sent_ && x > 2", "false"),
            ("N::set_", "fast", "sent_ && !set_", "true"),
            ("N::stamp_", "pose", None, "now()"),
        ],
        periodic=[(None, ["out"], "set_ && !sent_")],
    )
    assert machine_text.machine_text(build_machine(node)) == JOINT


WIDE = """\
p/n  node n

on_  n.h:1
  false | true, begins false
  any state
    in  -> true  n.cpp:10
        if condition_number_0 && condition_number_1 && condition_number_2 && condition_number_3 && condition_number_4
        or another_condition_0 && another_condition_1 && another_condition_2 && another_condition_3 && another_condition_4
  false
    on  -> true  n.cpp:11
"""


def test_long_guards_have_lines_of_their_own() -> None:
    guard = " || ".join("(" + " && ".join(f"{name}_{i}" for i in range(5)) + ")" for name in ("condition_number", "another_condition"))
    node = document(
        variables=[("N::on_", "bool", "false")], transitions=[("N::on_", "in", guard, "true"), ("N::on_", "on", "!on_", "true")]
    )
    assert machine_text.machine_text(build_machine(node)) == WIDE


def test_a_value_that_is_not_told_is_one_line() -> None:
    node = document(
        variables=[("N::q_", "std::list<int>", None)],
        transitions=[("N::q_", "in", "!q_.empty()", "q_.pop_front()"), ("N::q_", "on", None, "q_.push_back(1)")],
    )
    lines = machine_text.machine_text(build_machine(node)).splitlines()
    assert lines[2:] == [
        "q_.empty()  n.h:1",
        "  true | false, begins true",
        "  any state",
        "    on  -> false  n.cpp:11",
        "  false",
        "    in  -> true or stays  n.cpp:10",
    ]


def test_nothing_to_tell() -> None:
    machine = build_machine(document())
    assert machine_text.machine_text(machine) == "p/n  node n\n\nno state, no reactions\n"
    assert machine_mermaid.machine_text(machine) == '---\ntitle: "p/n"\n---\nstateDiagram-v2\n'


HOSTILE = 'a"b\\c<d>&\n-->#;{x}%%[*]:~_'


def hostile() -> StateMachine:
    node = document(
        variables=[("N::m_", "std::string", f'"{HOSTILE}'.replace("\n", " ").replace('a"b\\c', "a'b") + '"')],
        transitions=[("N::m_", "t", f'm_ == "x" && {HOSTILE}', '"y<\'>"')],
        reactive=[("t", "o", None)],
    )
    node["ports"] = [{"id": "t", "name": HOSTILE}, {"id": "o", "name": HOSTILE + HOSTILE}]
    node["package"] = node["component"] = node["node_name"] = HOSTILE
    return build_machine(node)


def test_hostile_names_in_mermaid() -> None:
    for line in machine_mermaid.machine_text(hostile()).splitlines()[4:]:
        text = line.partition(" : ")[2] if " : " in line else line.partition('"')[2].rpartition('"')[0]
        assert not set(text.replace("<br/>", "")) & set('"<>{}\\%:'), line
        assert all(code.rstrip().isdigit() for code in [part.split(";")[0] for part in text.split("#")[1:]]), line


def test_hostile_names_in_dot() -> None:
    text = machine_dot.machine_text(hostile())
    outside, escaped, inside = [], False, False
    for character in text:
        if inside and not escaped and character == "\\":
            escaped = True
            continue
        if character == '"' and not escaped:
            inside = not inside
        elif not inside:
            outside.append(character)
        escaped = False
    assert not inside
    assert not set("".join(outside)) & set("<&#%~\\")


def test_hostile_names_in_plantuml() -> None:
    for line in machine_plantuml.machine_text(hostile()).splitlines()[1:-1]:
        text = line.partition(" : ")[2] if " : " in line else line.partition('"')[2].rpartition('"')[0]
        for code in (
            "<U+003C>",
            "<U+003E>",
            "<U+0022>",
            "<U+005C>",
            "<U+0025>",
            "<U+0023>",
            "<U+007B>",
            "<U+007D>",
            "<U+007E>",
            "<U+002D>",
            "\\n",
        ):
            text = text.replace(code, "")
        assert not set(text) & set('"<>{}\\%~#'), line


def test_hostile_names_in_text_stay_on_their_line() -> None:
    text = machine_text.machine_text(hostile())
    assert text.splitlines()[0].startswith('a"b\\c<d>& -->#;{x}%%[*]:~_/a"b')
    assert len(text.splitlines()) == len(text.split("\n")) - 1
