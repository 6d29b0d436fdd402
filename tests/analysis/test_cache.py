"""The cache of component models: what it finds again, what it must not, and what damage does."""

from __future__ import annotations

import json
import pickle
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from multiprocessing import get_context
from pathlib import Path

import pytest

from rosarch.analysis.cache import ModelCache
from rosarch.analysis.components import analyze
from rosarch.analysis.method import Method
from rosarch.base.cache import Cache
from rosarch.extractor.settings import Settings
from rosarch.models.component import ComponentModel, to_json

CMAKE = """
cmake_minimum_required(VERSION 3.0)
project(talker)
find_package(catkin REQUIRED COMPONENTS roscpp)
add_executable(talker talker.cpp)
add_executable(other other.cpp)
"""
SOURCE = """
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include "names.h"
void onLevel(const std_msgs::Int32& message) { if (message.data > 3) ROS_INFO("high"); }
int main(int argc, char** argv) {
  ros::init(argc, argv, "talker");
  ros::NodeHandle node;
  ros::Publisher out = node.advertise<std_msgs::Int32>(NAME, 1);
  ros::Subscriber in = node.subscribe("level", 1, onLevel);
  for (ros::Rate rate(10); ros::ok(); rate.sleep()) out.publish(std_msgs::Int32());
}
"""


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    root = tmp_path / "workspace"
    root.mkdir()
    (root / "package.xml").write_text("<package><name>talker</name></package>")
    (root / "CMakeLists.txt").write_text(CMAKE)
    (root / "talker.cpp").write_text(SOURCE)
    (root / "other.cpp").write_text(SOURCE)
    (root / "names.h").write_text('#define NAME "count"\n')
    return root


def documents(root: Path, cache: Cache | None) -> str:
    return json.dumps([to_json(model) for model in analyze(root, method=Method(sources=Settings(jobs=1, cache=cache))).models])


@pytest.fixture
def evaluated(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The components that rules were evaluated for."""
    found: list[str] = []
    real = ModelCache.store

    def store(self: ModelCache, component: str, facts: str | None, model: ComponentModel) -> None:
        found.append(component)
        real(self, component, facts, model)

    monkeypatch.setattr(ModelCache, "store", store)
    return found


@pytest.mark.slow
def test_a_second_run_evaluates_nothing_and_gives_the_same_models(workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cache = Cache(tmp_path / "cache")
    first = documents(workspace, cache)
    assert '"name": "count"' in first

    def refuse() -> None:
        raise AssertionError("evaluated again")

    monkeypatch.setattr("rosarch.analysis.components.model_program", refuse)
    assert documents(workspace, cache) == first
    monkeypatch.undo()
    assert documents(workspace, None) == first


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "components"),
    [
        (lambda root: (root / "talker.cpp").write_text(SOURCE.replace('"level"', '"height"')), ["talker/talker"]),
        (lambda root: (root / "names.h").write_text('#define NAME "total"\n'), ["talker/other", "talker/talker"]),
        (lambda root: (root / "CMakeLists.txt").write_text(CMAKE.replace("(other other", "(third other")), ["talker/third"]),
    ],
)
def test_what_has_changed_is_evaluated_again(
    workspace: Path, tmp_path: Path, evaluated: list[str], change: Callable[[Path], object], components: list[str]
) -> None:
    cache = Cache(tmp_path / "cache")
    first = documents(workspace, cache)
    assert sorted(evaluated) == ["talker/other", "talker/talker"]
    evaluated.clear()
    change(workspace)
    after = documents(workspace, cache)
    assert sorted(evaluated) == components
    assert after == documents(workspace, None) != first


@pytest.mark.slow
def test_other_rules_have_other_entries(workspace: Path, tmp_path: Path, evaluated: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    cache = Cache(tmp_path / "cache")
    first = documents(workspace, cache)
    monkeypatch.setattr("rosarch.analysis.cache.models_version", lambda: "changed")
    assert documents(workspace, cache) == first
    assert sorted(evaluated) == ["talker/other"] * 2 + ["talker/talker"] * 2


@pytest.mark.slow
def test_a_source_whose_includes_macros_decide_is_not_kept(workspace: Path, tmp_path: Path) -> None:
    (workspace / "talker.cpp").write_text('#define WHICH "names.h"\n#include WHICH\n' + SOURCE)
    cache = Cache(tmp_path / "cache")
    documents(workspace, cache)
    (workspace / "names.h").write_text('#define NAME "total"\n')
    assert documents(workspace, cache) == documents(workspace, None)


@pytest.mark.slow
@pytest.mark.parametrize("damage", [b"", b"no pickle", pickle.dumps("no model"), b"cno.such.module\nThing\n."])
def test_a_damaged_entry_is_replaced(tmp_path: Path, workspace: Path, damage: bytes) -> None:
    cache = Cache(tmp_path / "cache")
    first = documents(workspace, cache)
    before = {path: path.read_bytes() for path in cache.folder.glob("*/*")}
    models = [path for path, data in before.items() if b"ComponentModel" in data]
    assert len(models) == 2
    for number, path in enumerate(models):
        if number:
            path.write_bytes(damage)  # without its checksum
        else:
            cache.store(path.parent.name + path.name, damage)
    assert documents(workspace, cache) == first
    assert {path: path.read_bytes() for path in models} == {path: before[path] for path in models}


@pytest.mark.slow
def test_runs_at_the_same_time(workspace: Path, tmp_path: Path) -> None:
    cache = Cache(tmp_path / "cache")
    with ProcessPoolExecutor(3, mp_context=get_context("spawn")) as pool:
        found = set(pool.map(partial(documents, workspace), [cache] * 3))
    assert found == {documents(workspace, None)}
    assert not list(cache.folder.glob("*/*.tmp"))
