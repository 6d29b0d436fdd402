"""`.rosarch.yml`: what it says, and what is said about what is wrong with it."""

from __future__ import annotations

import pytest
import yaml

from rosarch.base.places import Place
from rosarch.base.plain_yaml import LONGEST
from rosarch.findings.configuration import Configuration, LaunchChoice
from rosarch.findings.configuration_reader import ConfigurationError, read_configuration

KNOWN = ("topic-type-mismatch", "near-miss-topic", "unused-suppression")


def read(text: str) -> Configuration:
    return read_configuration(text, "ws/.rosarch.yml", KNOWN)


def test_everything() -> None:
    assert read(
        """# what the team agreed on
checks:
  topic-type-mismatch: error
  "near-*": ignore
fail_on: note
ignore_paths: [third_party, "**/test"]
baseline: .rosarch-baseline.json
launch:
  - bringup/launch/robot.launch
  - files: [a.launch, b.launch]
    arguments:
      sim: [true, false]
      world:
      rate: 010.50
package_path:
  - src
  - ../underlay
environment: {ROBOT: r2, ROS_HOSTNAME: , N: 0x10}
"""
    ) == Configuration(
        checks=(("topic-type-mismatch", "error"), ("near-*", "ignore")),
        fail_on="note",
        ignore_paths=("third_party", "**/test"),
        baseline=".rosarch-baseline.json",
        launch=(
            LaunchChoice(("bringup/launch/robot.launch",), (), Place("ws/.rosarch.yml", 9, 5)),
            LaunchChoice(
                ("a.launch", "b.launch"),
                (("sim", ("true", "false")), ("world", ("",)), ("rate", ("010.50",))),
                Place("ws/.rosarch.yml", 10, 5),
            ),
        ),
        package_path=("src", "../underlay"),
        environment=(("ROBOT", "r2"), ("ROS_HOSTNAME", ""), ("N", "0x10")),
    )


@pytest.mark.parametrize("text", ["", "# nothing\n", "---\n", "checks:\nlaunch:\nenvironment:\n", "checks: {}\nlaunch: []\n"])
def test_nothing(text: str) -> None:
    assert read(text) == Configuration()


def test_one_path_needs_no_list() -> None:
    assert read("package_path: src\nignore_paths: x/y").package_path == ("src",)


@pytest.mark.parametrize(
    ("text", "messages"),
    [
        ("check: {}", ["1:1: unknown setting `check`, did you mean `checks`?"]),
        (
            "wibble: 1",
            ["1:1: unknown setting `wibble`, there are checks, fail_on, ignore_paths, baseline, launch, package_path, environment, rates"],
        ),
        ("checks:\n  topic-type-mismach: error", ["2:3: unknown check `topic-type-mismach`, did you mean `topic-type-mismatch`?"]),
        ("checks: {'x-*': error}", ["1:10: no check matches `x-*`"]),
        ("checks: {near-miss-topic: warn}", ["1:27: `warn` is none of error, warning, note, ignore, did you mean `warning`?"]),
        ("checks: {near-miss-topic: }", ["1:26: a text is expected here, not nothing"]),
        ("checks: [near-miss-topic]", ["1:9: a map is expected here, not a list"]),
        ("checks: {[a]: error}", ["1:10: a text is expected here, not a list"]),
        ("fail_on: always", ["1:10: `always` is none of error, warning, note, never"]),
        ("fail_on: {a: b}", ["1:10: a text is expected here, not a map"]),
        ("fail_on: note\nfail_on: error", ["2:1: `fail_on` stands here for the second time, first in line 1"]),
        ("ignore_paths: [a, [b]]", ["1:19: a text is expected here, not a list"]),
        ("launch: a.launch", ["1:9: a list is expected here, not a text"]),
        ("launch: [{arguments: {a: b}}]", ["1:10: a launch entry without `files`"]),
        (
            "launch: [{file: a}]",
            ["1:11: unknown key of a launch entry `file`, did you mean `files`?", "1:10: a launch entry without `files`"],
        ),
        ("launch: [[a]]", ["1:10: a map is expected here, not a list"]),
        ("launch: [{files: a, arguments: {b: {c: d}}}]", ["1:36: a text is expected here, not a map"]),
        ("environment: [A]", ["1:14: a map is expected here, not a list"]),
        ("- checks", ["1:1: a map is expected here, not a list"]),
        ("text", ["1:1: a map is expected here, not a text"]),
        ("fail_on: x\nbaseline: [1]", ["1:10: `x` is none of error, warning, note, never", "2:11: a text is expected here, not a list"]),
    ],
)
def test_what_is_wrong_is_told_with_its_place(text: str, messages: list[str]) -> None:
    with pytest.raises(ConfigurationError) as caught:
        read(text)
    assert str(caught.value).splitlines() == [f"ws/.rosarch.yml:{message}" for message in messages]


BOMB = "a: &a [x, x]\n" + "".join(f"{chr(c + 1)}: &{chr(c + 1)} [*{chr(c)}, *{chr(c)}]\n" for c in range(ord("a"), ord("z")))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            "fail_on: !!python/object/apply:os.system [ls]",
            "1:10: a tag, `tag:yaml.org,2002:python/object/apply:os.system`: only plain values are allowed",
        ),
        ("fail_on: !!str note", "1:10: a tag, `tag:yaml.org,2002:str`: only plain values are allowed"),
        (BOMB, "2:8: an alias, `*a`: write the value out"),
        ("checks: &c\n  near-miss-topic: error\n  more: *c", "3:9: an alias, `*c`: write the value out"),
        ("fail_on: [a", "1:12: while parsing a flow sequence expected ',' or ']', but got '<stream end>'"),
        ("a: b: c", "1:5: mapping values are not allowed here"),
        ("fail_on: a\n--- \nfail_on: b", "2:1: expected a single document in the stream but found another document"),
        ("[" * 50_000, "1:201: brackets nested more than 200 deep"),
        ("a" * (LONGEST + 1), f"1:1: more than {LONGEST} characters"),
    ],
    ids=range(9),
)
def test_hostile_texts(text: str, message: str) -> None:
    with pytest.raises(ConfigurationError) as caught:
        read(text)
    assert str(caught.value) == f"ws/.rosarch.yml:{message}"


def test_control_characters_are_refused() -> None:
    with pytest.raises(ConfigurationError, match=r"^ws/\.rosarch\.yml:1:1: unacceptable character #x001b: [^\n]*$"):
        read("fail_on: \x1b")


def test_anchors_without_alias_are_harmless() -> None:
    assert yaml.safe_load("fail_on: &a note") == {"fail_on": "note"}
    assert read("fail_on: &a note").fail_on == "note"
