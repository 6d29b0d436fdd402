"""`rosarch query`, `explain`, `why-not` and `rules`."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Run = Callable[..., Any]
FAN = """/// `topic` is published by this component and nothing in it reads `topic`. May.
.decl published_only(topic: symbol)
.output published_only
published_only(Topic) :- port([_, "publisher", Topic]), !_reads(Topic), !_ours(Topic).
.decl _reads(topic: symbol)
_reads(Topic) :- port([_, "subscriber", Topic]).
.decl _ours(topic: symbol)
_ours("/rosout").
"""


def test_query(rosarch: Run, workspace: Path) -> None:
    done = rosarch("query", workspace, "port([_, Kind, Name]), port_type([_, Kind, Name], Type)")
    assert (done.code, done.out) == (
        0,
        "Kind       Name     Type\n---------  -------  ---------------\npublisher  chatter  std_msgs/String\n1 row\n",
    )
    done = rosarch("query", workspace, 'port([_, "subscriber", _])')
    assert (done.code, done.out) == (0, "no\n")
    done = rosarch("query", workspace, "port([_, Kind, Name])", "--format", "json")
    assert json.loads(done.out) == [{"package": "talker", "component": "talker", "rows": [{"Kind": "publisher", "Name": "chatter"}]}]


def test_query_of_facts(rosarch: Run, workspace: Path, tmp_path: Path) -> None:
    facts = tmp_path / "facts"
    assert rosarch("extract", workspace, "-o", facts).code == 0
    for folder in (facts, facts / "talker" / "talker"):
        assert rosarch("query", folder, "port([_, Kind, Name])").out.splitlines()[2:] == ["publisher  chatter", "1 row"]
    done = rosarch("query", facts, "port(_)", "--component", "talkr")
    assert (done.code, done.err) == (2, "rosarch: error: no component talkr, did you mean `talker`?\n")
    done = rosarch("query", facts, "port(_)", "--package", "talkr")
    assert (done.code, done.err) == (2, "rosarch: error: no package talkr among these facts, did you mean `talker`?\n")


@pytest.mark.slow
def test_query_of_several_components(rosarch: Run, examples: Path) -> None:
    done = rosarch("query", examples / "mobile_base", 'port([_, "publisher", Name])')
    assert [line for line in done.out.splitlines() if line.startswith("==")] == [
        "== base_driver/base_driver",
        "== base_odometry/odometry_node",
    ]
    one = rosarch("query", examples / "mobile_base", 'port([_, "publisher", Name])', "-c", "odometry_node")
    assert one.out == "Name\n----------------\nodom\n~odometry_status\n2 rows\n"
    assert rosarch("query", examples / "mobile_base", 'port([_, "no kind", Name])').out == "no rows in any component\n"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        (("query", "prt(X)"), "<query>:1:1: unknown relation `prt`, did you mean `port`?\n    prt(X)\n    ^"),
        (("explain", "prt(X)"), "<goal>:1:1: unknown relation `prt`, did you mean `port`?\n    prt(X)\n    ^"),
        (("explain", "port([_, publisher, chater])"), 'there is no row port([_, "publisher", "chater"]), `why-not` shows what is missing'),
    ],
)
def test_errors(rosarch: Run, workspace: Path, arguments: tuple[str, str], error: str) -> None:
    done = rosarch(arguments[0], workspace, arguments[1])
    assert (done.code, done.out, done.err) == (2, "", f"rosarch: error: {error}\n")


def test_profile(rosarch: Run, workspace: Path) -> None:
    done = rosarch("query", workspace, "port([_, _, Name])", "--profile")
    assert done.out == "Name\n-------\nchatter\n1 row\n"
    assert done.err.startswith("== talker/talker\n")
    assert " rules/core/" in done.err
    done = rosarch("query", workspace, "port(_)", "--profile", "--engine", "souffle")
    assert (done.code, done.err) == (2, "rosarch: error: --profile measures the embedded engine; souffle has a profiler of its own\n")


def test_explain(rosarch: Run, workspace: Path) -> None:
    done = rosarch("explain", workspace, "port([_, publisher, chatter])", "--depth", "1")
    lines = done.out.splitlines()
    assert done.code == 0
    assert lines[0].startswith("port([") and " rules/core/ports/ports.dl:" in lines[0]
    assert lines[1].startswith("├─ port_site(") and lines[1].endswith(", ...")
    assert '  talker/talker.cpp:8: ros::Publisher pub = nh.advertise<std_msgs::String>("chatter", 10);' in lines
    assert len(rosarch("explain", workspace, "port([_, publisher, chatter])", "--depth", "0").out) > len(done.out)
    shown = rosarch("explain", workspace, "port([_, publisher, chatter])", "--depth", "1", "--show-rules").out
    assert "│  port([Site, Kind, Name]) :- port_site(" in shown


@pytest.mark.slow
@pytest.mark.parametrize(
    ("goal", "line"),
    [
        (
            "state_variable(auto_docking::Docking::state_)",
            "docking.cpp:60: if (state_ == State::SEARCHING || state_ == State::APPROACHING)",
        ),
        ("transition(_, auto_docking::Docking::state_, _)", "docking.cpp:32: state_ = State::SEARCHING;"),
        ("reacts([_, subscriber, beacon], [_, publisher, ~state], _)", "docking.cpp:107: state_pub_.publish(msg);"),
        ("periodic(_, _, timer)", "docking.cpp:22: timer_ = nh.createTimer(ros::Duration(0.05), &Docking::onTimer, this);"),
        ("reacts_deferred(_, [_, publisher, cmd_vel], _)", "docking.cpp:48: bearing_ = beacon->point.y;"),
    ],
)
def test_behavior_is_explained(rosarch: Run, examples: Path, goal: str, line: str) -> None:
    shown = rosarch("explain", examples / "docking_states", goal, "--component", "docking", "--depth", "0").out
    assert shown.startswith(f"{goal.partition('(')[0]}(")
    assert line in shown.partition("source lines:")[2]


def test_why_not(rosarch: Run, workspace: Path, examples: Path) -> None:
    done = rosarch("why-not", workspace, "port_type(_, sensor_msgs/Image)")
    assert done.code == 0
    assert done.out.startswith('port_type(_, "sensor_msgs/Image") is not there; ')
    assert "\n  no row   " in done.out
    done = rosarch("why-not", examples / "mobile_base", "port(_)")
    assert done.err.endswith("2 components; choose one with --component: base_driver/base_driver, base_odometry/odometry_node\n")


@pytest.mark.slow
def test_rules_of_ones_own(rosarch: Run, workspace: Path, tmp_path: Path) -> None:
    rules = tmp_path / "fan.dl"
    rules.write_text(FAN)
    done = rosarch("rules", "run", workspace, rules)
    assert (done.code, done.out) == (0, "published_only\ntopic\n-------\nchatter\n1 row\n")
    assert rosarch("rules", "run", workspace, rules, "--relation", "_ours").out == "_ours\ntopic\n-------\n/rosout\n1 row\n"
    assert rosarch("query", workspace, "published_only(T)", "--rules", rules).out == "T\n-------\nchatter\n1 row\n"
    assert rosarch("explain", workspace, "published_only(_)", "--rules", rules).out.startswith(f'published_only("chatter")  {rules}:4\n')
    rules.write_text(FAN.replace("port([", "prt([", 1))
    done = rosarch("rules", "run", workspace, rules)
    assert done.code == 2
    assert done.err.splitlines()[0] == f"rosarch: error: {rules}:4:26: unknown relation `prt`, did you mean `port`?"
    rules.write_text(".decl r(x: number)\n")
    done = rosarch("rules", "run", workspace, rules)
    assert done.err == f"rosarch: error: {rules}: nothing to print; add an `.output` directive or name a relation with --relation\n"


def test_rules_test(rosarch: Run, tmp_path: Path) -> None:
    case = tmp_path / "case"
    (case / "facts").mkdir(parents=True)
    (case / "expected").mkdir()
    (case / "program.dl").write_text(".decl e(x: number)\n.input e\n.decl r(x: number)\nr(X) :- e(X), X > 1.\nr(X) :- e(X), X < 0.\n")
    (case / "facts" / "e.facts").write_text("1\n2\n")
    (case / "expected" / "r.csv").write_text("2\n")
    done = rosarch("rules", "test", tmp_path)
    assert (done.code, done.out) == (
        0,
        f"ok       case\ncoverage of {case}/program.dl: 1 of 2 clauses fired (50 %)\nnever fired:\n"
        f"  {case}/program.dl:5: r(X) :- e(X), X < 0.\n1 test, 0 failed\n",
    )
    (case / "expected" / "r.csv").write_text("3\n")
    done = rosarch("rules", "test", tmp_path, "--no-coverage")
    assert done.code == 1
    assert done.out.startswith("FAILED   case\n  r:\n    missing     3\n    unexpected  2\n")
    (tmp_path / "empty").mkdir()
    done = rosarch("rules", "test", tmp_path / "empty")
    assert (
        done.err
        == f"rosarch: error: {tmp_path}/empty: no tests; a test is a source with comments `expect: ...`, or a folder with facts/*.facts and expected/*.csv\n"
    )


def test_rules_doc_and_list(rosarch: Run, tmp_path: Path) -> None:
    done = rosarch("rules", "doc", "-o", tmp_path / "relations.md")
    assert (done.code, done.out) == (0, "")
    text = (tmp_path / "relations.md").read_text(encoding="utf-8")
    assert text.startswith("# Relations\n\n- [rules/schema/")
    assert "\n### port\n\n`port(port: Port)` · output, line " in text
    assert rosarch("rules", "doc").out == text
    done = rosarch("rules", "list", "port_t*")
    assert done.out.startswith("output   port_type(port: Port, type: symbol)  rules/core/ports/port_types.dl:")
    assert rosarch("rules", "list", "zzzz").err == "rosarch: error: no relation zzzz\n"
