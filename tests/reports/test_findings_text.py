"""Findings for people."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest
from findings_reports import BELOW, EVIL_SETTING, HERE, MANIFEST, WITH_MANIFEST, everything, hostile, nothing, one, with_fix
from handmade_findings import CHECKS, FULL, MISMATCH, STYLE, finding
from systems import node, small, system

from rosarch.analysis.systems.check_result import scope_of
from rosarch.base.places import Place
from rosarch.findings.model import Change, Evidence
from rosarch.findings.policy import Policy, apply_policy
from rosarch.reports.excerpts import WIDEST, Excerpts
from rosarch.reports.findings import Setting, scope_text
from rosarch.reports.findings_text import findings_text


def test_a_finding() -> None:
    assert findings_text(one(), HERE) == (
        "odom/src/odom.cpp:3:13: error: /odom reads /ticks as Float32, but /base publishes it as Int32  [type-mismatch]\n"
        '  3 |   sub_ = nh.subscribe("ticks", 10, &Odom::onTicks, this);\n'
        "    |             ^~~~~~~~~ read as Float32\n"
        "  base/launch/base.launch:3: remapped\n"
        '  3 |     <remap from="ticks" to="/ticks"/>\n'
        "    |     ^~~~~~\n"
        "  base/src/base.cpp:3: published as Int32\n"
        '  3 |     pub_ = nh.advertise<std_msgs::Int32>("ticks", 1);\n'
        "    |               ^~~~~~~~~\n"
        "  hint: Use one type, or rename one topic.\n"
        "  in: base.launch, sim.launch\n"
        "\n"
        "1 finding: 1 error\n"
    )


def test_a_fix() -> None:
    text = findings_text(with_fix(), WITH_MANIFEST)
    assert [line for line in text.splitlines() if line.startswith("  fix: ")] == [
        "  fix: ws/base/launch/base.launch:3: `/ticks` becomes `/odom/ticks`",
        "  fix: ws/base/package.xml:2: add the line `<depend>std_msgs</depend>` below",
    ]


def test_lines_to_add_at_one_place_are_told_together() -> None:
    lines = [Change(MANIFEST, "", f"<depend>{name}</depend>") for name in ("std_msgs", "tf2")]
    found = [replace(FULL, message=one.meant, changes=(one,)) for one in lines]
    text = findings_text(apply_policy(found, Policy(), checks=CHECKS), WITH_MANIFEST)
    assert [line for line in text.splitlines() if line.startswith("  fix: ")] == [
        "  fix: ws/base/package.xml:2: add the lines `<depend>std_msgs</depend>`, `<depend>tf2</depend>` below"
    ]


def test_all_kinds() -> None:
    lines = findings_text(everything(), HERE).splitlines()
    assert lines[0] == "a.cpp: warning: whole file  [near-miss]"
    assert lines[-1] == "2 findings: 1 error, 1 warning; 1 suppressed; 1 known from the baseline; 1 of the baseline gone"
    assert not any("bad style" in line or "an old one" in line for line in lines)


def test_nothing() -> None:
    assert findings_text(nothing(), HERE) == "no findings\n"


def test_paths_begin_where_the_reader_stands() -> None:
    text = findings_text(one(), BELOW)
    assert re.findall(r"^\s*(\S+?):3\b", text, re.MULTILINE) == [
        "ws/odom/src/odom.cpp",
        "ws/base/launch/base.launch",
        "ws/base/src/base.cpp",
    ]
    assert findings_text(one(finding(path="/opt/ros/a.h")), BELOW).startswith("/opt/ros/a.h:3:1: error: m")


def test_a_file_that_cannot_be_read() -> None:
    assert findings_text(one(), Setting()).splitlines()[:3] == [
        "odom/src/odom.cpp:3:13: error: /odom reads /ticks as Float32, but /base publishes it as Int32  [type-mismatch]",
        "  read as Float32",
        "  base/launch/base.launch:3: remapped",
    ]


def test_a_line_is_shown_once() -> None:
    again = replace(FULL, evidence=(FULL.evidence[0], replace(FULL.evidence[0], text="here again")))
    assert findings_text(one(again), HERE).splitlines()[3:5] == [
        "  odom/src/odom.cpp:3: here again",
        "  hint: Use one type, or rename one topic.",
    ]


def test_what_repeats_is_said_once() -> None:
    first, second, third = (replace(FULL, message=message, evidence=FULL.evidence[:1]) for message in "abc")
    third = replace(third, evidence=(Evidence("", Place("odom/src/odom.cpp", 4, 1)),))
    other = replace(first, message="d", check=STYLE)
    reported = apply_policy([first, second, third, other], Policy(), checks=CHECKS)
    assert findings_text(reported, HERE) == (
        "odom/src/odom.cpp:3:13: error: d  [style]\n"
        '  3 |   sub_ = nh.subscribe("ticks", 10, &Odom::onTicks, this);\n'
        "    |             ^~~~~~~~~ read as Float32\n"
        "  hint: Use one type, or rename one topic.\n"
        "  in: base.launch, sim.launch\n"
        "\n"
        "odom/src/odom.cpp:3:13: error: a  [type-mismatch]\n"
        "  also: b\n"
        "  hint: Use one type, or rename one topic.\n"
        "  in: base.launch, sim.launch\n"
        "\n"
        "odom/src/odom.cpp:4:1: error: c  [type-mismatch]\n"
        "  4 | }\n"
        "    | ^\n"
        "  in: base.launch, sim.launch\n"
        "\n"
        "4 findings: 4 errors\n"
    )


def test_of_many_findings_at_one_place_the_first_are_told() -> None:
    many = [replace(FULL, message=f"m{number}", systems=(f"{number}.launch",)) for number in range(8)]
    lines = findings_text(apply_policy(many, Policy(), checks=CHECKS), HERE).splitlines()
    assert [line for line in lines if line.startswith(("  also", "  in"))] == [
        *(f"  also: {text}" for text in ("m1", "m2", "m3", "m4", "3 more")),
        "  in: 0.launch, 1.launch, 2.launch, 3.launch, 4 more",
    ]


def test_notes_are_shown_when_they_are_asked_for_or_make_the_run_fail() -> None:
    brief = replace(HERE, notes=False)
    findings = [finding(STYLE, "bad style"), FULL]
    reported = apply_policy(findings, Policy(), checks=CHECKS)
    assert "note: bad style  [style]" in findings_text(reported, HERE)
    assert "bad style" not in findings_text(reported, brief)
    assert findings_text(reported, brief).splitlines()[-1] == "2 findings: 1 error, 1 note; -v shows the notes"
    assert findings_text(one(finding(STYLE)), brief) == "1 finding: 1 note; -v shows the notes\n"
    failing = apply_policy(findings, Policy(fail_on="note"), checks=CHECKS)
    assert findings_text(failing, brief).splitlines()[-1] == "2 findings: 1 error, 1 note"


def test_how_much_was_checked() -> None:
    assert findings_text(nothing(), replace(HERE, scope=scope_text(scope_of([small(), system([node("/a")])])))) == (
        "no findings\nchecked 2 systems with 6 nodes, 1 of them without a model\n"
    )
    assert scope_text(scope_of([system([node("/a")])])) == "checked 1 system with 1 node"


def test_numbers_are_aligned() -> None:
    steps = (Evidence("", Place("a.cpp", 9, 1)), Evidence("b", Place("a.cpp", 100, 1)))
    text = findings_text(one(replace(FULL, evidence=steps)), Setting({"a.cpp": "f();\n" * 100}.get))
    assert [line for line in text.splitlines() if "|" in line] == ["    9 | f();", "      | ^", "  100 | f();", "      | ^"]


def test_colour_on_terminals(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.setenv("COLUMNS", "40")
    coloured = findings_text(one(), replace(HERE, terminal=True))
    assert "\x1b[1;31merror: \x1b[0m" in coloured
    assert re.sub(r"\x1b\[[\d;]*m", "", coloured) == findings_text(one(), HERE)
    monkeypatch.setenv("NO_COLOR", "1")
    plain = findings_text(one(), replace(HERE, terminal=True))
    assert not re.search(r"\x1b\[[\d;]*3[1-7]m", plain)


def test_hostile_text_stays_on_its_line() -> None:
    text = findings_text(hostile(), EVIL_SETTING)
    assert all(line.isprintable() for line in text.split("\n"))
    assert [line for line in text.split("\n") if line.startswith("::error")] == []
    assert findings_text(hostile(), replace(EVIL_SETTING, terminal=True)).count("\x1b[31m") == 0


@pytest.mark.parametrize(
    ("line", "column", "text", "underline"),
    [
        ("abc def", 1, "abc def", "^~~"),
        ("abc def", 5, "abc def", "    ^~~"),
        ("\t\tf(x);", 3, "        f(x);", "        ^"),
        ("  f(x);", 1, "  f(x);", "  ^~~~~"),  # no token there: all of it
        ("  f(x);", 99, "  f(x);", "  ^~~~~"),
        ("  f(x);", 0, "  f(x);", "  ^~~~~"),
        ('f("a b", 1)', 3, 'f("a b", 1)', "  ^~~~~"),
        ("車輪 f()", 4, "車輪 f()", "     ^"),
        ("topic: /a/b.c: x", 8, "topic: /a/b.c: x", "       ^~~~~~"),
        ("a\x1b[31mb c", 9, "a\\x1b[31mb c", "           ^"),
        ("  </node>", 3, "  </node>", "  ^~~~~~"),
    ],
)
def test_excerpts(line: str, column: int, text: str, underline: str) -> None:
    excerpt = Excerpts({"f": f"x\n{line}\n"}.get).at(Place("f", 2, column))
    assert excerpt is not None
    assert (excerpt.text, excerpt.underline) == (text, underline)


@pytest.mark.parametrize("column", [2, 50, 2002, 3990, 4001])
def test_long_lines_are_cut_around_the_mark(column: int) -> None:
    line = "".join("x" if number % 10 else " " for number in range(4000)) + "end"
    excerpt = Excerpts({"f": line}.get).at(Place("f", 1, column))
    assert excerpt is not None
    assert len(excerpt.text) <= WIDEST + 2
    assert set(excerpt.text[excerpt.before : excerpt.before + excerpt.marked]) <= set("xend ")
    assert excerpt.text.startswith("…") == (column > 100)
    assert excerpt.text.endswith("…") == (column < 3900)


@pytest.mark.parametrize("line", [0, 2, 4, -1])
def test_no_excerpt(line: int) -> None:
    assert Excerpts({"f": "x\n \nx"}.get).at(Place("f", line, 1)) is None
    assert Excerpts({}.get).at(Place("f", 1, 1)) is None


def test_lines_are_those_of_the_compiler() -> None:
    excerpt = Excerpts({"f": "a\x0cb\u2028c\nsecond"}.get).at(Place("f", 2, 1))
    assert excerpt is not None
    assert excerpt.text == "second"


def test_recommendation_may_be_empty() -> None:
    bare = finding(replace(MISMATCH, recommendation=""))
    assert findings_text(one(bare), HERE) == "a.cpp:3:1: error: m  [type-mismatch]\n\n1 finding: 1 error\n"


@pytest.mark.parametrize(
    ("number", "shown"), [(1, "s0"), (5, "s0, s1, s2, s3, s4"), (6, "s0, s1, s2, s3, 2 more"), (60, "s0, s1, s2, s3, 56 more")]
)
def test_of_many_systems_some_are_named(number: int, shown: str) -> None:
    found = replace(finding(), systems=tuple(f"s{each}" for each in range(number)))
    assert findings_text(one(found), HERE).splitlines()[-3] == f"  in: {shown}"
