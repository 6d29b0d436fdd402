"""What every rule file keeps to."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import pytest

from rosarch.datalog import RelationDecl, load_declarations
from rosarch.extractor.facts import schema
from rosarch.extractor.manifest import rules_folder
from rosarch.extractor.pipeline import extract
from rosarch.extractor.settings import Settings
from rosarch.rule_programs.lint import lint_rules
from rosarch.rule_programs.sets import component_program, other_variants, system_rules
from rosarch.rule_programs.variants import Decision, decisions

RULES = rules_folder()
EXAMPLES = Path(__file__).parents[2] / "examples"
FILES = sorted(RULES.rglob("*.dl"))
DIRECTIVE = re.compile(r"^\s*\.(input|output|printsize)\s+(\w+)", re.MULTILINE)

# extracted only from sources that no example has: each with the test that fills it
ELSEWHERE = {
    "source_failed": "tests/extractor/test_pipeline.py",
    "macro_undefined": "tests/extractor/cxx/test_undefined_macros.py",
    "awaited": "tests/rules/sources/answers_that_are_awaited.py",
    "source_lost": "tests/extractor/cxx/test_undefined_macros.py",
    "lost_call": "tests/extractor/cxx/test_undefined_macros.py",
    "module_member_absent": "tests/rules/packages/python_members/scripts/stock.py",
    "message_default": "tests/rules/packages/message_defaults/scripts/teller.py",
    "call_misfits": "tests/rules/packages/python_calls/scripts/filler.py",
    # the configuration of a node, which no source has
    **dict.fromkeys(load_declarations(RULES / "schema" / "configuration.dl"), "tests/analysis/test_instances.py"),
}


PROGRAMS = ("component.dl", "flows.dl", "system.dl")
CHECKS = sorted((RULES / "checks").glob("*.dl"))
DECISIONS = decisions()


@lru_cache
def programs() -> list[Mapping[str, RelationDecl]]:
    """The relations of the rules of components and of systems, checks included, with each of the variants."""
    found = [load_declarations([RULES / "component.dl", RULES / "flows.dl"]), load_declarations([RULES / "system.dl", *CHECKS])]
    for rules in other_variants():
        found += [component_program(replace(rules, flows=True)).relations, system_rules(rules).program.relations]
    return found


@lru_cache
def system_schema() -> dict[str, RelationDecl]:
    return dict(load_declarations(RULES / "system_schema.dl"))


def file_of(declaration: RelationDecl) -> str:
    return Path(declaration.location.path).resolve().relative_to(RULES.resolve()).as_posix()


def test_every_file_is_part_of_the_program() -> None:
    included = {path.resolve() for program in PROGRAMS for path in _included(RULES / program)} | {path.resolve() for path in CHECKS}
    included |= {variant.path.resolve() for decision in DECISIONS for variant in decision.variants}
    assert sorted(path.relative_to(RULES).as_posix() for path in FILES if path.resolve() not in included) == []


def _included(path: Path) -> set[Path]:
    found = {path}
    for name in re.findall(r'^\.include "([^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE):
        found |= _included(path.parent / name)
    return found


@pytest.mark.parametrize("decision", DECISIONS, ids=lambda decision: decision.name)
def test_every_decision_is_documented_and_has_two_answers(decision: Decision) -> None:
    assert decision.doc.endswith(".")
    assert decision.find(decision.default.stem) is not None
    assert len(decision.variants) >= 2
    assert [variant.name for variant in decision.variants if not variant.doc.endswith(".")] == []


@pytest.mark.slow
def test_the_rules_keep_to_their_conventions() -> None:
    """Comments, certainty, names, and no relation that is of no use: what `rosarch rules lint` tells of anybody's rules."""
    assert [diagnostic.headline for diagnostic in lint_rules()] == []


# fields at the head of a check that reports print as they stand, in one line
ONE_LINE = re.compile(r"// (help|recommendation|message): ")


def test_no_line_is_longer_than_140() -> None:
    found = [
        f"{path.relative_to(RULES).as_posix()}:{number}"
        for path in FILES
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if len(line) > 140 and not (path in CHECKS and ONE_LINE.match(line))
    ]
    assert found == []


def test_files_of_the_core_are_short() -> None:
    lines = {
        path.relative_to(RULES).as_posix(): len(path.read_text(encoding="utf-8").splitlines()) for path in (RULES / "core").rglob("*.dl")
    }
    assert {name: count for name, count in lines.items() if count >= 300} == {}


def test_the_map_names_every_file() -> None:
    """The README of the rules has a line for each file, whose path is given from `core`, `api` or `system` on, and names no other."""
    named = set(re.findall(r"`([\w/]+\.dl)`", (Path(__file__).parents[2] / "rules" / "README.md").read_text(encoding="utf-8")))
    there = {path.relative_to(RULES / folder).as_posix() for folder in ("core", "api", "system") for path in (RULES / folder).rglob("*.dl")}
    assert sorted(there - named) == []
    assert sorted(name for name in named if name not in there and not (RULES / name).is_file()) == []


def test_inputs_are_the_schema() -> None:
    found = {
        (path.relative_to(RULES).parts[0], name)
        for path in FILES
        for kind, name in DIRECTIVE.findall(path.read_text(encoding="utf-8"))
        if kind == "input"
    }
    assert {folder for folder, _ in found} == {"schema"}
    assert {name for _, name in found} == set(schema()) | set(system_schema())
    assert set(schema()).isdisjoint(system_schema())


def test_outputs_are_in_one_file() -> None:
    found = {
        path.relative_to(RULES).as_posix()
        for path in FILES
        for kind, _ in DIRECTIVE.findall(path.read_text(encoding="utf-8"))
        if kind != "input"
    }
    assert found == {"export.dl", "flows.dl", "system/export.dl"}


@pytest.mark.slow
@pytest.mark.parametrize("name", [path.relative_to(RULES).as_posix() for path in FILES])
def test_private_relations_stay_in_their_file(name: str) -> None:
    code = re.sub(r'//[^\n]*|"(?:\\.|[^"\\])*"', "", (RULES / name).read_text(encoding="utf-8"))
    used = set(re.findall(r"(?<![\w.])(_[a-z]\w*)\(", code))
    assert {relation for relation in used if name not in owners().get(relation, {name})} == set()


@lru_cache
def owners() -> dict[str, set[str]]:
    """The files that declare a private relation: one in each program at most."""
    found: dict[str, set[str]] = {}
    for program in programs():
        for relation, declaration in program.items():
            if relation.startswith("_"):
                found.setdefault(relation, set()).add(file_of(declaration))
    return found


def test_the_core_names_no_ros_library() -> None:
    """What roscpp calls things is said in api/ only."""
    for path in sorted((RULES / "core").rglob("*.dl")):
        code = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
        assert re.findall(r'"[^"\n]*\b(?:ros|roscpp|tf|tf2_ros|nodelet|actionlib|std|boost)::[^"\n]*"', code) == [], path.name


SNIPPETS = """
#include <ros/ros.h>
#include <gone/missing.h>
enum Mode { ON = 1 };
template <class T> struct Box { T value_; virtual void set(T t) { value_ = t; } void take(const typename T::ConstPtr&); int size() { return T::size(); } };
struct Base { virtual void run() {} };
struct IntBox : Box<int> {};
template <class T> struct Made { static T* own(int); }; template <class T> T* made(T t) { return Made<T>::own(t); }
struct Node : Base {
  int count_ = 0; Box<int> box_; Node(int n = 3) : count_(n) {} void run() override { count_ += 1; box_.set(ON); } int one(int);
};
[[clang::annotate("marked")]] void fill(int, double) {}
void (*global)(int, double) = &fill;
int main(int argc, char** argv) {
  Node node; Base* base = &node; base->run(); base->missing(argc);
  for (int value : {1, 2}) { switch (value) { case 1: global(value, 2.5); break; default: return 1; } }
  auto callback = [&argc](int x) { return x + argc; };
  ros::NodeHandle nh; nh.param<int>("p", argc, 3); nh.publish(undeclared);
  { ros::Subscriber inner = nh.subscribe("inner", 1, callback); }
#if 0
#endif
  int many = node.one(made(1), 2, 3); callback(static_cast<int>(1.5)); auto text = undeclared("x");
  return 0;
}
"""


SCRIPT = """#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

class Echo:
    def __init__(self):
        rospy.Subscriber('text', String, self.on_text)

    def on_text(self, text):
        undeclared(*text, how=1)

Echo()
"""


@pytest.mark.slow
def test_every_relation_of_the_schema_is_filled(tmp_path: Path) -> None:
    package = tmp_path / "src" / "demo"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(
        '<package format="2"><name>demo</name><version>1.0.0</version><description>d</description>'
        '<maintainer email="a@b.org">a</maintainer><license>BSD</license></package>',
        encoding="utf-8",
    )
    (package / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.0)\nproject(demo)\nadd_executable(demo demo.cpp)\n", encoding="utf-8"
    )
    (package / "demo.cpp").write_text(SNIPPETS, encoding="utf-8")
    (package / "echo.py").write_text(SCRIPT, encoding="utf-8")
    filled: set[str] = set()
    for root in (tmp_path / "src", EXAMPLES / "nodelet_filter", EXAMPLES / "services_and_actions"):
        with extract(root, settings=Settings(jobs=1)) as extraction:
            for component in extraction.components:
                filled |= {relation for relation, rows in component.rows().items() if rows}
    assert sorted(set(schema()) - filled - set(ELSEWHERE)) == []
    assert filled <= set(schema())
