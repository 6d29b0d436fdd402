"""Findings as Markdown."""

from __future__ import annotations

import re

import pytest
from findings_reports import BELOW, EVIL_SETTING, HERE, WITH_MANIFEST, hostile, nothing, one, with_fix
from handmade_findings import CHECKS, finding
from hypothesis import given
from hypothesis import strategies as st
from markdown_it import MarkdownIt

from rosarch.findings.policy import Policy, apply_policy
from rosarch.reports.findings_markdown import LONGEST, findings_text


def test_a_finding() -> None:
    assert findings_text(one(), BELOW) == (
        "### rosarch: 1 finding: 1 error\n"
        "\n"
        "#### `ws/odom/src/odom.cpp`\n"
        "\n"
        "- **error** line 3: /odom reads /ticks as Float32, but /base publishes it as Int32 (`type-mismatch`)\n"
        "  <details><summary>why, and what to do</summary>\n"
        "\n"
        "  `ws/odom/src/odom.cpp:3`: read as Float32\n"
        "\n"
        "  ```\n"
        '    sub_ = nh.subscribe("ticks", 10, &Odom::onTicks, this);\n'
        "              ^~~~~~~~~\n"
        "  ```\n"
        "\n"
        "  `ws/base/launch/base.launch:3`: remapped\n"
        "\n"
        "  ```\n"
        '      <remap from="ticks" to="/ticks"/>\n'
        "      ^~~~~~\n"
        "  ```\n"
        "\n"
        "  `ws/base/src/base.cpp:3`: published as Int32\n"
        "\n"
        "  ```\n"
        '      pub_ = nh.advertise<std_msgs::Int32>("ticks", 1);\n'
        "                ^~~~~~~~~\n"
        "  ```\n"
        "\n"
        "  **Hint:** Use one type, or rename one topic.\n"
        "\n"
        "  In: `base.launch`, `sim.launch`\n"
        "\n"
        "  </details>\n"
    )


def test_findings_of_one_place_are_told_together() -> None:
    findings = [finding(message="a"), finding(message="b <c>"), finding(message="three", line=4)]
    lines = findings_text(apply_policy(findings, Policy(), checks=CHECKS), HERE).splitlines()
    assert [line for line in lines if line.startswith(("- ", "  Also"))] == [
        "- **error** line 3: a (`type-mismatch`)",
        "  Also: b \\<c\\>",
        "- **error** line 4: three (`type-mismatch`)",
    ]


def test_nothing() -> None:
    assert findings_text(nothing(), HERE) == "### rosarch: no findings\n"


def test_one_heading_for_each_file() -> None:
    findings = [finding(line=1), finding(line=2), finding(path="b.cpp"), finding(path="c/`x`.cpp", line=0)]
    text = findings_text(apply_policy(findings, Policy(), checks=CHECKS), HERE)
    assert re.findall(r"^#### .*", text, re.MULTILINE) == ["#### `a.cpp`", "#### `b.cpp`", "#### `` c/`x`.cpp ``"]
    assert text.count("- **error** line 1: m") == text.count("- **error** line 2: m") == text.count("- **error** m") == 1


@pytest.mark.parametrize(
    ("message", "shown"),
    [
        ("a_b *c* [d](e) <f> a|b ~ ! \\", r"a\_b \*c\* \[d\](e) \<f\> a\|b \~ \! " + "\\\\"),
        ("no check is called `a_b`", "no check is called `a_b`"),
        ("one ` alone", r"one \` alone"),
        ("@team #12 GH-3", "@<!-- -->team #<!-- -->12 GH-<!-- -->3"),
        ("https://e.org www.e.org ftp://e", "http<!-- -->s://e.org www<!-- -->.e.org ftp<!-- -->://e"),
        ("a\n# b", r"a\\n#<!-- --> b"),
    ],
)
def test_text_is_no_markup(message: str, shown: str) -> None:
    assert f"- **error** line 3: {shown} (`type-mismatch`)\n" in findings_text(one(finding(message=message)), HERE)


def test_hostile_texts() -> None:
    text = findings_text(hostile(), EVIL_SETTING)
    assert all(line.isprintable() for line in text.split("\n"))
    assert (text.count("<details>"), text.count("\n  </details>")) == (1, 1)
    fences = re.findall(r"^  (`{3,})$", text, re.MULTILINE)
    assert fences == ["```", "```", "````", "```", "````"]  # the fourth is what the source says
    assert {each for each in markup(text) if each[0] != "html_block"} == {("html_inline", "<!-- -->")}


@given(st.text(alphabet="`\\*_[](){}<>!&#@|~-+:/.ab \n", max_size=40))
def test_no_text_is_markup(message: str) -> None:
    text = findings_text(one(finding(message=message)), HERE)
    assert {each for each in markup(text) if each[0] != "html_block"} <= {("html_inline", "<!-- -->")}
    assert len(re.findall("<", "".join(content for kind, content in markup(text) if kind == "html_block"))) == 4


def markup(text: str) -> list[tuple[str, str]]:
    """Everything in a text that is no plain text, code, list or heading."""
    blocks = MarkdownIt("commonmark").parse(text)
    inside = [token for block in blocks for token in block.children or ()]
    return [
        (token.type, token.content)
        for token in (*blocks, *inside)
        if token.type in ("html_block", "html_inline", "link_open", "image", "em_open")
    ]


def test_a_comment_has_room_for_it() -> None:
    findings = [finding(message=f"{number} {'x' * 200}", line=number) for number in range(1000)]
    text = findings_text(apply_policy(findings, Policy(), checks=CHECKS), HERE)
    assert len(text) < LONGEST + 100
    shown = text.count("- **error**")
    assert 50 < shown < 1000
    assert text.endswith(f"\n… and {1000 - shown} more findings.\n")


def test_a_fix() -> None:
    text = findings_text(with_fix(), WITH_MANIFEST)
    assert "  **Fix:** `ws/base/launch/base.launch:3`: `/ticks` becomes `/odom/ticks`\n" in text
    assert "  **Fix:** `ws/base/package.xml:2`: add the line `<depend>std_msgs</depend>` below\n" in text
