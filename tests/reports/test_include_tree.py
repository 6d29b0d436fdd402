"""The tree of launch files."""

from __future__ import annotations

import json
import shutil
import subprocess

import pytest
from jsonschema import Draft202012Validator
from systems import at, node, small, system

from rosarch.models.system.inclusions import MOST_FILES, LaunchFile, include_tree
from rosarch.models.system.model import Inclusion, SystemModel
from rosarch.reports.include_tree import tree_data, tree_dot, tree_schema, trees_json, trees_text


def included(path: str, line: int, file: str | None, text: str = "") -> Inclusion:
    return Inclusion(at(path, line), text or f"$(find p)/{file}", file)


def twice() -> SystemModel:
    """`arm.launch` is included twice; `gone.launch` is not there."""
    nodes = (
        node("/left/arm", lines=(at("all.launch", 2), at("arm.launch", 10))),
        node("/right/arm", lines=(at("all.launch", 3), at("arm.launch", 10)), conditions=("arg right",)),
        node("/map", lines=(at("all.launch", 12),), origin="unknown"),
    )
    inclusions = (
        included("all.launch", 3, "arm.launch"),
        included("all.launch", 2, "arm.launch"),
        included("arm.launch", 4, "limits.launch"),
        included("all.launch", 9, None, "gone.launch"),
    )
    return system(nodes, launch=("all.launch side:=left",), inclusions=inclusions)


def loop() -> SystemModel:
    return system([], launch=("a.launch",), inclusions=(included("a.launch", 1, "b.launch"), included("b.launch", 2, "a.launch")))


def bomb() -> SystemModel:
    pairs = [(f"{depth}.launch", line, f"{depth + 1}.launch") for depth in range(40) for line in (1, 2)]
    return system([], launch=("0.launch",), inclusions=tuple(included(*pair) for pair in pairs))


def test_text() -> None:
    assert trees_text([twice(), small()]) == (
        "all.launch side:=left\n"
        "├──  2 arm.launch\n"
        "│   ├──  4 limits.launch\n"
        "│   └── 10 /left/arm  (pkg/arm)\n"
        "├──  3 arm.launch\n"
        "│   ├──  4 limits.launch\n"
        "│   └── 10 /right/arm  (pkg/arm)  if arg right\n"
        "├──  9 gone.launch  not there\n"
        "└── 12 /map  (pkg/map)\n"
        "3 launch files, 3 nodes\n"
        "\n"
        "launch/robot.launch\n"
        "├── 3 launch/base.launch\n"
        "│   ├── 4 /base/driver  (base_driver/driver)\n"
        "│   └── 9 /base/odometry  (base_odometry/odometry)\n"
        "├── 5 /planner  (pkg/planner)\n"
        "├── 6 /mission  (pkg/mission)  if arg mission\n"
        "└── 7 /viewer  (other/viewer)\n"
        "2 launch files, 5 nodes\n"
    )


def test_a_file_that_includes_itself() -> None:
    assert trees_text([loop()]) == "a.launch\n└── 1 b.launch\n    └── 2 a.launch  not told again\n2 launch files, 0 nodes\n"


@pytest.mark.slow
def test_a_tree_that_is_too_large() -> None:
    def size(file: LaunchFile) -> int:
        return 1 + sum(map(size, file.includes))

    (root,) = include_tree(bomb())
    assert MOST_FILES <= size(root) <= MOST_FILES + 50
    assert "not told again" in trees_text([bomb()])


def test_json() -> None:
    (data,) = json.loads(trees_json([twice()]))
    (root,) = data["files"]
    assert (data["launch"], root["file"], root["at"]) == (["all.launch side:=left"], "all.launch", None)
    assert [(f["file"], f["text"], f["at"]) for f in root["includes"]] == [
        ("arm.launch", "$(find p)/arm.launch", "all.launch:2"),
        ("arm.launch", "$(find p)/arm.launch", "all.launch:3"),
        (None, "gone.launch", "all.launch:9"),
    ]
    assert root["includes"][1]["nodes"] == [
        {"name": "/right/arm", "package": "pkg", "type": "arm", "conditions": ["arg right"], "at": "arm.launch:10"}
    ]


@pytest.mark.parametrize("model", [twice(), loop(), small(), system([], launch=())], ids=["twice", "loop", "small", "empty"])
def test_json_follows_its_schema(model: SystemModel) -> None:
    Draft202012Validator.check_schema(tree_schema())
    Draft202012Validator(tree_schema()).validate(tree_data(model))


def test_dot() -> None:
    assert tree_dot(twice()).splitlines()[3:] == [
        '  "file:all.launch" [label="all.launch", shape=note];',
        '  "node:/map" [label="/map", shape=ellipse, style="dashed"];',
        '  "file:all.launch" -> "node:/map" [label="12", arrowhead=none];',
        '  "file:all.launch" -> "file:arm.launch" [label="2"];',
        '  "file:all.launch" -> "file:arm.launch" [label="3"];',
        '  "file:all.launch" -> "missing:gone.launch" [label="9"];',
        '  "file:arm.launch" [label="arm.launch", shape=note];',
        '  "node:/left/arm" [label="/left/arm", shape=ellipse];',
        '  "file:arm.launch" -> "node:/left/arm" [label="10", arrowhead=none];',
        '  "file:arm.launch" -> "file:limits.launch" [label="4"];',
        '  "file:limits.launch" [label="limits.launch", shape=note];',
        '  "node:/right/arm" [label="/right/arm", shape=ellipse];',
        '  "file:arm.launch" -> "node:/right/arm" [label="10", arrowhead=none, style=dashed];',
        '  "missing:gone.launch" [label="gone.launch", shape=note, style="dashed", color="#b03a2e"];',
        "}",
    ]


@pytest.mark.skipif(shutil.which("dot") is None, reason="needs Graphviz")
@pytest.mark.parametrize("model", [twice(), loop(), small()], ids=["twice", "loop", "small"])
def test_graphviz_reads_it(model: SystemModel) -> None:
    done = subprocess.run(["dot", "-Tsvg"], input=tree_dot(model), capture_output=True, text=True, check=True, timeout=60)
    assert done.stderr == ""
