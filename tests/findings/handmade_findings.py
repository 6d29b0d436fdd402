"""Findings made by hand, for tests of what becomes of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from rosarch.base.places import Place
from rosarch.findings.model import Evidence, Finding
from rosarch.findings.suppressions import UNUSED_SUPPRESSION
from rosarch.rule_programs.checks import Check

SOURCES = {
    "odom/src/odom.cpp": 'void Odom::start()\n{\n  sub_ = nh.subscribe("ticks", 10, &Odom::onTicks, this);\n}\n',
    "base/src/base.cpp": 'void Base::start()\n{\n\tpub_ = nh.advertise<std_msgs::Int32>("ticks", 1);\n}\n',
    "base/launch/base.launch": '<launch>\n  <node name="base" pkg="base" type="base">\n    <remap from="ticks" to="/ticks"/>\n  </node>\n</launch>\n',
}
read: Callable[[str], str | None] = SOURCES.get


def check(identifier: str, impact: str = "high", confidence: str = "high") -> Check:
    return replace(
        UNUSED_SUPPRESSION,  # what a check has beyond these fields does not matter here
        id=identifier,
        title="Topic published and read with different types",
        help="Publisher and subscriber disagree on the type.",
        impact=impact,
        confidence=confidence,
        description="The connection is dropped.",
        scenario='  nh.advertise<A>("t", 1);\n    nh.subscribe<B>("t", 1, cb);  // {}',
        recommendation="Use one type,\nor rename one topic.",
    )


MISMATCH, NEAR_MISS, STYLE = check("type-mismatch"), check("near-miss", "high", "medium"), check("style", "low", "high")
CHECKS = (STYLE, MISMATCH, NEAR_MISS)

READ = Evidence("read as Float32", Place("odom/src/odom.cpp", 3, 13))
STEPS = (
    READ,
    Evidence("remapped", Place("base/launch/base.launch", 3, 5)),
    Evidence("published as Int32", Place("base/src/base.cpp", 3, 12)),
)
FULL = Finding(MISMATCH, "error", "/odom reads /ticks as Float32, but /base publishes it as Int32", STEPS, ("base.launch", "sim.launch"))


def finding(of: Check = MISMATCH, message: str = "m", path: str = "a.cpp", line: int = 3, column: int = 1) -> Finding:
    return Finding(of, of.severity, message, (Evidence("", Place(path, line, column)),))
