"""What `docs/checks.md` and `docs/ci.md` show is so."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest
import yaml
from handmade_findings import CHECKS, FULL, MISMATCH, SOURCES

from rosarch.base.places import Place
from rosarch.extractor.suppressions import suppressions_in
from rosarch.findings.configuration_reader import read_configuration
from rosarch.findings.model import Evidence
from rosarch.findings.policy import CHOICES, THRESHOLDS, Policy, apply_policy
from rosarch.reports.findings import FORMATS, Setting, report_text

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "docs/checks.md").read_text(encoding="utf-8")
CI = (ROOT / "docs/ci.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```$", TEXT, re.MULTILINE | re.DOTALL)
HOOK = re.findall(r"^```yaml\n(repos:.*?)^```$", CI, re.MULTILINE | re.DOTALL)[0]
IDS = ("topic-type-mismatch", "topic-name-mismatch", "unused-suppression", "suppression-without-reason")


def blocks(language: str) -> list[str]:
    return [body for found, body in BLOCKS if found == language]


def test_the_finding() -> None:
    shown = replace(MISMATCH, id="topic-type-mismatch", recommendation="Use one message type, or rename one of the topics.")
    steps = (
        Evidence("read as std_msgs/Float32", Place("src/odometry/src/odometry.cpp", 3, 13)),
        Evidence("remapped", Place("src/base/launch/base.launch", 3, 5)),
        Evidence("published as std_msgs/Int32", Place("src/base/src/base.cpp", 3, 13)),
    )
    message = "/odometry reads /ticks as std_msgs/Float32, but /base publishes it as std_msgs/Int32"
    found = replace(FULL, check=shown, message=message, evidence=steps, systems=("src/base/launch/base.launch",))
    sources = {
        "src/odometry/src/odometry.cpp": SOURCES["odom/src/odom.cpp"].replace("Odom", "Odometry"),
        "src/base/launch/base.launch": SOURCES["base/launch/base.launch"],
        "src/base/src/base.cpp": SOURCES["base/src/base.cpp"].replace("\t", "  "),
    }
    reported = apply_policy([found], Policy(), checks=CHECKS)
    assert report_text("text", reported, Setting(sources.get)) == blocks("text")[0]


def test_the_configuration() -> None:
    found = read_configuration(blocks("yaml")[0], ".rosarch.yml", IDS)
    fields = ("checks", "fail_on", "ignore_paths", "baseline", "launch", "package_path", "environment", "rates")
    assert all(getattr(found, name) for name in fields)
    assert set(yaml.safe_load(blocks("yaml")[0])) == set(fields)


def test_the_comments() -> None:
    both = ("topic-type-mismatch", "topic-name-mismatch")
    found = {
        path: [(each.checks, each.first, each.last, bool(each.reason)) for each in suppressions_in(path, text)]
        for path, text in (("a.cpp", blocks("cpp")[0]), ("a.launch", blocks("xml")[0]), ("a.yaml", blocks("yaml")[1]))
    }
    assert found == {
        "a.cpp": [(both[:1], 1, 1, True), (both, 4, 4, True)],
        "a.launch": [(both[:1], 2, 3, True)],
        "a.yaml": [(both[:1], 1, 1, True)],
    }


def test_words() -> None:
    assert tuple(re.findall(r"^\| `(\w+)` \|", CI, re.MULTILINE)) == FORMATS
    assert f"`--fail-on {'|'.join(THRESHOLDS)}`" in TEXT
    assert f"# id or pattern: {', '.join(CHOICES[:-1])} or {CHOICES[-1]}" in TEXT
    for identifier in ("unused-suppression", "suppression-without-reason"):
        assert f"`{identifier}`" in TEXT


@pytest.mark.parametrize("block", [*blocks("yaml"), *re.findall(r"^```yaml\n(.*?)^```$", CI, re.MULTILINE | re.DOTALL)])
def test_every_yaml_block_is_yaml(block: str) -> None:
    assert isinstance(yaml.safe_load(block), dict)


def test_the_hook() -> None:
    (hook,) = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text())
    assert yaml.safe_load(HOOK)["repos"][0]["hooks"][0]["id"] == hook["id"]
    assert hook["entry"].split()[:2] == ["rosarch", "check"]
    assert (hook["language"], hook["pass_filenames"]) == ("python", False)
    changed = ["src/a.cpp", "p/CMakeLists.txt", "CMakeLists.txt", "l/a.launch", "package.xml", "c/a.yaml", "c/a.yml", "msg/A.msg"]
    assert [path for path in [*changed, "README.md", "a.cpp.orig", "xCMakeLists.txt", "a.png"] if re.search(hook["files"], path)] == changed
