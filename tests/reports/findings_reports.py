"""Reports of findings made by hand, for the tests of each format."""

from __future__ import annotations

from dataclasses import replace

from handmade_findings import CHECKS, FULL, NEAR_MISS, SOURCES, STYLE, finding, read

from rosarch.base.places import Place
from rosarch.extractor.suppressions import Suppression
from rosarch.findings.baseline import Baseline
from rosarch.findings.model import Change, Evidence, Finding
from rosarch.findings.policy import Policy, Reported, apply_policy
from rosarch.reports.findings import Setting

HERE = Setting(read)
BELOW = Setting(read, "ws")
COMMENT = Suppression("base/src/base.cpp", 2, 4, ("style",), "as agreed", 3, 3)
SUPPRESSED = finding(STYLE, "bad style", "base/src/base.cpp")
KNOWN, GONE = finding(NEAR_MISS, "an old one"), finding(NEAR_MISS, "one that was repaired", "b.cpp")
MANIFEST = Place("base/package.xml", 2, 1)
WITH_MANIFEST = Setting({**SOURCES, MANIFEST.path: "<package>\n  <name>base</name>\n</package>\n"}.get, "ws")
EVIL = "a\n::error::x\r\x1b[31m%0A|`<img>`</details>]]>[x](http://e.org) @all #1 {0}\u202e\udcff,:"


def one(found: Finding = FULL) -> Reported:
    return apply_policy([found], Policy(), checks=CHECKS)


def with_fix() -> Reported:
    """A finding with a change in a file and a new line in another, and one whose text is not certain."""
    changes = (Change(Place("base/launch/base.launch", 3, 5), "/ticks", "/odom/ticks"), Change(MANIFEST, "", "<depend>std_msgs</depend>"))
    other = replace(finding(NEAR_MISS), changes=(Change(Place("base/launch/base.launch", 3, 5), "absent", "x"),))
    return apply_policy([replace(FULL, changes=changes), other], Policy(), checks=CHECKS)


def nothing() -> Reported:
    return apply_policy([], Policy(), checks=CHECKS)


def everything() -> Reported:
    """Something new, something suppressed, something the baseline knows, and something that is gone."""
    findings = [FULL, finding(NEAR_MISS, "whole file", line=0, column=0), SUPPRESSED, KNOWN]
    return apply_policy(findings, Policy(), [COMMENT], Baseline.of([KNOWN, GONE]), checks=CHECKS)


def hostile() -> Reported:
    evil = replace(NEAR_MISS, recommendation=EVIL, title=EVIL, help=EVIL, description=EVIL, scenario=EVIL)
    steps = tuple(Evidence(EVIL, Place(EVIL, line, 1)) for line in (2, 3))
    found = Finding(evil, "error", EVIL, steps, (EVIL,), (Change(Place(EVIL, 1, 1), EVIL, EVIL),))
    comment = Suppression("s.cpp", 2, 4, ("near-miss",), EVIL, 3, 3)
    hidden = replace(found, message="hidden", evidence=(Evidence(EVIL, Place("s.cpp", 3, 1)),))
    return apply_policy([found, hidden], Policy(), [comment], Baseline.of([finding(evil, f"gone {EVIL}", EVIL)]), checks=[evil])


EVIL_SETTING = Setting({**SOURCES, EVIL: f"{EVIL}\n```\n"}.get)
