"""What the variants of each decision make of one source: they differ where their comments say so."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

import pytest

from rosarch.datalog import Program
from rosarch.extractor.pipeline import extract
from rosarch.extractor.settings import Settings
from rosarch.rule_programs.sets import component_program, rule_set, system_rules
from rosarch.rule_programs.variants import decisions

HERE = Path(__file__).parent
MANIFEST = (
    '<package format="2"><name>demo</name><version>1.0.0</version><description>d</description>'
    '<maintainer email="a@b.org">a</maintainer><license>BSD</license></package>'
)
INCLUDES = "#include <ros/ros.h>\n#include <std_msgs/Bool.h>\n#include <string>\n"
Facts = Mapping[str, list[tuple[Any, ...]]]

STATE = (
    INCLUDES
    + """
ros::Publisher pub;
bool armed = false;      // named by the condition, set to constants elsewhere
double level = 0;        // compared, set to whatever arrives
int count = 0;           // named by the condition, changed where it is sent only
bool derived() { return level > 3; }
void onArm(const std_msgs::Bool& m) { armed = true; }
void onLevel(const std_msgs::Bool& m) { level = m.data * 2.0; }
void onTick(const ros::TimerEvent&) { if (armed && derived() && ++count < 9) pub.publish(std_msgs::Bool()); }
int main(int argc, char** argv) {
  ros::init(argc, argv, "demo"); ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Bool>("out", 1);
  ros::Subscriber a = nh.subscribe("arm", 1, onArm), b = nh.subscribe("level", 1, onLevel);
  ros::Timer t = nh.createTimer(ros::Duration(1), onTick);
  ros::spin();
}
"""
)
DEPTH = (
    INCLUDES
    + """
ros::Publisher make(ros::NodeHandle& nh, const std::string& side, const std::string& what) { return nh.advertise<std_msgs::Bool>(side + "/" + what, 1); }
ros::Publisher arm(ros::NodeHandle& nh, const std::string& side) { return make(nh, side, side + "_arm"); }
int main(int argc, char** argv) {
  ros::init(argc, argv, "demo"); ros::NodeHandle nh;
  ros::Publisher one = arm(nh, "left"), two = arm(nh, "right"), three = make(nh, "top", "lid");
  ros::spin();
}
"""
)
ALIAS = (
    INCLUDES
    + """
struct Arm { std::string topic; };
struct Side { Arm arm; };
struct Node {
  Arm first, second; Side left, right; ros::NodeHandle nh; ros::Publisher a, b;
  Node() { first.topic = "first"; second.topic = "second"; left.arm.topic = "left"; right.arm.topic = "right"; make(); }
  void make() { a = nh.advertise<std_msgs::Bool>(first.topic, 1); b = nh.advertise<std_msgs::Bool>(left.arm.topic, 1); }
};
int main(int argc, char** argv) { ros::init(argc, argv, "demo"); Node node; ros::spin(); }
"""
)
GUARD = (
    INCLUDES
    + """
ros::Publisher early, nested, otherwise, skipped;
bool ready = false, wanted = false, fine = false, odd = false;
void onIn(const std_msgs::Bool& m) {
  for (int i = 0; i < 3; i += 1) {
    if (odd) continue;
    skipped.publish(m);
  }
  if (fine) { nested.publish(m); } else { otherwise.publish(m); }
  if (!ready) return;
  early.publish(m);
  if (wanted) nested.publish(m);
}
int main(int argc, char** argv) {
  ros::init(argc, argv, "demo"); ros::NodeHandle nh;
  early = nh.advertise<std_msgs::Bool>("early", 1); nested = nh.advertise<std_msgs::Bool>("nested", 1);
  otherwise = nh.advertise<std_msgs::Bool>("otherwise", 1); skipped = nh.advertise<std_msgs::Bool>("skipped", 1);
  ros::Subscriber in = nh.subscribe("in", 1, onIn);
  ros::spin();
}
"""
)
QUERIES = {
    "state-variable": ("state_variable", STATE, lambda variable: variable),
    "context-depth": ("port", DEPTH, lambda port: port[2]),
    "member-alias": ("port", ALIAS, lambda port: port[2]),
    "publish-guard": ("guard_step", GUARD, None),
}
EXPECTED: dict[str, dict[str, list[str]]] = {
    "state-variable": {
        "data-flow": ["armed", "count", "level"],
        "enumerated": ["armed"],
        "rosinfer": ["armed"],
    },
    "context-depth": {
        "call": ["left/left_arm", "left/right_arm", "right/left_arm", "right/right_arm", "top/lid"],
        "none": [f"{side}/{what}" for side in ("left", "right", "top") for what in ("left_arm", "lid", "right_arm")],
        "two-calls": ["left/left_arm", "right/right_arm", "top/lid"],
    },
    "member-alias": {
        "class": ["first", "first", "left", "left", "right", "right", "second", "second"],
        "variable": ["first", "left", "right"],
        "path": ["first", "left"],
    },
    "publish-guard": {
        "control-dependence": ["fine false", "fine true", "i < 3 true", "odd false", "!ready false", "wanted true"],
        "nesting": ["fine false", "fine true", "i < 3 true", "wanted true"],
    },
}
CASES = [(decision, variant) for decision, variants in EXPECTED.items() for variant in variants]


@pytest.fixture(scope="module")
def facts_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Facts]:
    @lru_cache
    def extracted(source: str) -> Facts:
        package = tmp_path_factory.mktemp("ws") / "demo"
        package.mkdir()
        (package / "package.xml").write_text(MANIFEST, encoding="utf-8")
        (package / "CMakeLists.txt").write_text("project(demo)\nadd_executable(demo demo.cpp)\n", encoding="utf-8")
        (package / "demo.cpp").write_text(source, encoding="utf-8")
        with extract(package.parent, settings=Settings(jobs=1)) as extraction:
            return {name: list(rows) for name, rows in extraction.components[0].rows().items()}

    return extracted


def found(program: Program, facts: Facts, decision: str, engine: str = "embedded") -> list[str]:
    relation, _, show = QUERIES[decision]
    if show is not None:
        return sorted(show(value) for (value,) in program.evaluate(facts, engine=engine, keep=[relation]).rows(relation))
    texts = dict(facts["expr_text"])
    rows = program.evaluate(facts, engine=engine, keep=[relation]).rows(relation)
    return sorted({f"{texts[condition]} {sense}" for _, _, condition, sense, _ in rows if condition}, key=lambda text: text.lstrip("!"))


@pytest.mark.slow
@pytest.mark.parametrize(("decision", "variant"), CASES)
def test_variant(facts_of: Callable[[str], Facts], decision: str, variant: str) -> None:
    program = component_program(rule_set(variants={decision: variant}))
    assert found(program, facts_of(QUERIES[decision][1]), decision) == EXPECTED[decision][variant]


@pytest.mark.skipif(shutil.which("souffle") is None, reason="there is no souffle on PATH")
@pytest.mark.parametrize(("decision", "variant"), CASES)
def test_variant_with_souffle(facts_of: Callable[[str], Facts], decision: str, variant: str) -> None:
    program = component_program(rule_set(variants={decision: variant}))
    assert found(program, facts_of(QUERIES[decision][1]), decision, "souffle") == EXPECTED[decision][variant]


# publisher and subscriber of one type, each alone: which names are taken for one
NAMES = {
    "/scan_front": "/scan_frnt",
    "/robot/map": "/map",
    "/camera/left/image": "/camera/right/image",
    "/points2raw": "/points3raw",
    "/odometry": "/odometry_filtered",
    "/cmd_vel": "/joint_states",
}
SIMILAR: dict[tuple[str, ...], list[str]] = {
    ("spelling",): ["/odometry", "/robot/map", "/scan_front"],
    ("exact",): ["/camera/left/image", "/robot/map"],
    ("segments",): ["/camera/left/image", "/robot/map"],
    ("segments", "name-segments=2"): ["/camera/left/image", "/robot/map"],
    ("edits",): ["/points2raw", "/scan_front"],
    ("edits", "name-edits=4"): ["/camera/left/image"],
    ("edits", "name-edits=1"): ["/points2raw", "/scan_front"],
}


def names_program(tmp_path: Path, chosen: tuple[str, ...]) -> Program:
    path = tmp_path / "names.dl"
    rows = [f'name_asked("{number}", "{a}"). name_offered("{number}", "{b}").' for number, (a, b) in enumerate(NAMES.items())]
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")
    options = dict(text.split("=") for text in chosen[1:])
    return system_rules(rule_set([path], {"name-matching": chosen[0]}, options)).program


@pytest.mark.slow
@pytest.mark.parametrize("chosen", SIMILAR, ids=" ".join)
def test_names(tmp_path: Path, chosen: tuple[str, ...]) -> None:
    result = names_program(tmp_path, chosen).evaluate({}, keep=["similar_names"])
    assert sorted({a for a, b, _ in result.rows("similar_names") if NAMES[a] == b}) == SIMILAR[chosen]


@pytest.mark.skipif(shutil.which("souffle") is None, reason="there is no souffle on PATH")
@pytest.mark.parametrize("chosen", SIMILAR, ids=" ".join)
def test_names_with_souffle(tmp_path: Path, chosen: tuple[str, ...]) -> None:
    result = names_program(tmp_path, chosen).evaluate({}, engine="souffle", keep=["similar_names"])
    assert sorted({a for a, b, _ in result.rows("similar_names") if NAMES[a] == b}) == SIMILAR[chosen]


def test_every_variant_has_a_case() -> None:
    tested = {**{name: set(variants) for name, variants in EXPECTED.items()}, "name-matching": {chosen[0] for chosen in SIMILAR}}
    assert {decision.name: {variant.name for variant in decision.variants} for decision in decisions()} == tested
