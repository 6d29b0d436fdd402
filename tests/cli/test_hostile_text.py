"""Names of the input in reports: they never move the cursor, turn text around, or become markup."""

from __future__ import annotations

import json
import unicodedata
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

import pytest

BAD = "x\x1b[31m<script>|`::error::%0A&\u202e\u009b\"q'</title>"
"""A name that means something to terminals, Markdown, HTML, XML and build servers."""
SOURCE = """\
#include <ros/ros.h>
#include <std_msgs/String.h>
enum State {{ WAITING, MOVING }};
State state_ = WAITING;
void onText(const std_msgs::String::ConstPtr& text) {{ if (text->data == "{bad}") state_ = MOVING; }}
int main(int argc, char** argv)
{{
  ros::init(argc, argv, "talker");
  ros::NodeHandle nh;
  std::string name;
  ros::param::param<std::string>("~{bad}", name, "{bad}");
  ros::Subscriber sub = nh.subscribe("{bad}", 1, onText);
  ros::Publisher pub = nh.advertise<std_msgs::String>("/p{bad}", 10);
  ros::spin();
}}
"""
READERS = [
    ("check",), ("check", "-v"), ("check", "--format", "markdown"), ("check", "--format", "github"), ("check", "--format", "junit"),
    ("analyze",), ("doctor",), ("show", "ports", "--format", "markdown"), ("show", "behavior"), ("show", "behavior", "--format", "markdown"),
    *(("show", "machine", "--format", form) for form in ("text", "dot", "mermaid", "plantuml", "scxml")),
    *(("show", "graph", "--format", form) for form in ("dot", "mermaid", "graphml")),
    ("check", "--format", "json"), ("check", "--format", "sarif"), ("analyze", "--format", "json"), ("show", "machine", "--format", "json"),
    ("show", "graph", "--format", "json"), ("query", "port(_)", "--format", "json"),
    ("launch",), ("query", "port(_)"), ("explain", "port(_)"),
]  # fmt: skip


@pytest.fixture
def hostile(workspace: Path) -> Path:
    text = BAD.replace("\\", "\\\\").replace('"', '\\"')
    (workspace / "talker" / "talker.cpp").write_text(SOURCE.format(bad=text))
    name = quoteattr("".join(c for c in BAD if c.isprintable() or c == "\u202e"))
    (workspace / "talker" / "t.launch").write_text(
        f'<launch><node name="t" pkg="talker" type="talker"><remap from={name} to="/z"/><param name="k" value={name}/></node>'
        f"<node name={name} pkg={name} type={name}/><include file={name}/></launch>\n"
    )
    return workspace


@pytest.mark.slow
def test_reports_show_names_as_escapes(rosarch: Callable, hostile: Path) -> None:
    for words in READERS:
        at = 1 + (words[0] == "show")
        done = rosarch(*words[:at], hostile, *words[at:])
        assert done.code in (0, 1), (words, done.err)
        for text in (done.out, done.err):
            odd = {character for character in text if unicodedata.category(character) in ("Cc", "Cf") and character not in "\n\t"}
            assert not odd, words
        if words[-1] in ("junit", "graphml", "scxml"):
            ElementTree.fromstring(done.out)
        if words[-1] in ("json", "sarif"):
            json.loads(done.out)
        if words[-1] == "github":
            assert all(line.startswith("::") for line in done.out.splitlines() if "script" in line)
    assert "``" in rosarch("show", "ports", hostile, "--format", "markdown").out
