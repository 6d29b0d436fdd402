"""Findings as commands of GitHub workflows."""

from __future__ import annotations

import re

from findings_reports import BELOW, EVIL_SETTING, HERE, everything, hostile, nothing, one
from handmade_findings import STYLE, finding

from rosarch.reports.findings_github import findings_text


def test_an_error() -> None:
    assert findings_text(one(), BELOW) == (
        "::error file=ws/odom/src/odom.cpp,line=3,col=13,title=Topic published and read with different types (type-mismatch)::"
        "/odom reads /ticks as Float32, but /base publishes it as Int32"
        "%0Aws/base/launch/base.launch:3: remapped%0Aws/base/src/base.cpp:3: published as Int32%0Ahint: Use one type, or rename one topic.\n"
    )


def test_severities() -> None:
    assert [line.split(" ")[0] for line in findings_text(everything(), HERE).splitlines()] == ["::warning", "::error"]
    assert findings_text(one(finding(STYLE)), HERE).startswith("::notice file=a.cpp,line=3,col=1,")


def test_a_whole_file() -> None:
    assert findings_text(one(finding(line=0, column=0)), HERE).startswith("::error file=a.cpp,title=")


def test_nothing() -> None:
    assert findings_text(nothing(), HERE) == ""


def test_no_command_can_be_smuggled_in() -> None:
    (line,) = findings_text(hostile(), EVIL_SETTING).split("\n")[:-1]
    properties, message = re.fullmatch(r"::error ((?:[a-z]+=[^,:]*,?)+)::(.*)", line).groups()
    assert [part.partition("=")[0] for part in properties.split(",")] == ["file", "line", "col", "title"]
    assert message.startswith("a\\n::error::x\\r\\x1b[31m%250A|")
    assert line.isprintable()
