"""What components are told to be for the sake of systems: each `traits/*.cpp` says in `// expect:` comments all of it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from rosarch.analysis.components import analyze
from rosarch.analysis.method import Method
from rosarch.extractor.settings import Settings
from rosarch.models.component import ComponentModel
from rosarch.models.traits import TRAITS

HERE = Path(__file__).parent / "traits"
COUNTS = (
    "answers_most",
    "round_sends",
    "round_always",
    "sent_untimed",
    "sent_otherwise",
    "synchronised",
    "answers_surely",
    "answers_least",
    "round_least",
    "names_message",
    "unsteady_name",
)  # `tests/rules/sources/flows_*.cpp` and `answers_*.cpp` have them
MODES = (
    "begins_in",
    "moves_on",
    "moves_freely",
    "asks_for",
    "ignores",
    "answers_in",
    "waits_for",
    "provides_after",
    "sends_in_burst",
)  # and `tests/rules/packages/` these
LIVES = ("unsteady", "unheard", "held_up", "out_of_line", "several_orders", "perhaps_always")  # `lives/*.cpp` has these
NODES = sorted(HERE.glob("*.cpp"))
LIVING = sorted((HERE.parent / "lives").glob("*.cpp"))

CMAKE = """cmake_minimum_required(VERSION 2.8.3)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs std_srvs)
catkin_package()
add_executable(node node.cpp)
"""
PACKAGE = """<package><name>node</name><version>0.0.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>l</license><buildtool_depend>catkin</buildtool_depend></package>
"""


def lines(model: ComponentModel, *, lives: bool = False) -> list[str]:
    """The traits of one group, one line each: ports by name, places by line."""
    ports = {port.id: port.name for port in model.ports}

    def shown(kind: str, value: Any) -> str:
        return ports[value] if kind == "port" else str(value.line) if kind == "place" else value

    asked = LIVES if lives else set(TRAITS) - {*COUNTS, *MODES, *LIVES}
    return sorted(" ".join([t.name, *map(shown, TRAITS[t.name], t.values)]) for t in model.traits if t.name in asked)


@pytest.mark.parametrize("node", LIVING, ids=lambda node: node.stem)
def test_what_goes_on_and_in_which_order_is_as_expected(node: Path, tmp_path: Path) -> None:
    source = node.read_text(encoding="utf-8")
    for name, text in (("node.cpp", source), ("CMakeLists.txt", CMAKE), ("package.xml", PACKAGE)):
        (tmp_path / name).write_text(text, encoding="utf-8")
    (model,) = analyze(tmp_path, method=Method(sources=Settings(jobs=1))).models
    assert lines(model, lives=True) == sorted(re.findall(r"^// expect: (.*)$", source, re.MULTILINE))


@pytest.mark.parametrize("node", NODES, ids=lambda node: node.stem)
def test_traits_are_as_expected(node: Path, tmp_path: Path) -> None:
    source = node.read_text(encoding="utf-8")
    for name, text in (("node.cpp", source), ("CMakeLists.txt", CMAKE), ("package.xml", PACKAGE)):
        (tmp_path / name).write_text(text, encoding="utf-8")
    (model,) = analyze(tmp_path, method=Method(sources=Settings(jobs=1))).models
    assert lines(model) == sorted(re.findall(r"^// expect: (.*)$", source, re.MULTILINE))
    assert ("// expect:" in source) != node.stem.endswith("_not")
