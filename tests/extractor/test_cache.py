"""The cache of extracted units: what it finds again, what it must not, and what damage does."""

from __future__ import annotations

import marshal
import os
from pathlib import Path

import pytest

from rosarch.extractor.cache import Cache, extractor_version, hash_of
from rosarch.extractor.pipeline import extract

CMAKE = """
cmake_minimum_required(VERSION 3.0)
project(talker)
find_package(catkin REQUIRED COMPONENTS roscpp)
add_executable(talker talker.cpp)
"""
SOURCE = """
#include <ros/ros.h>
#include "names.h"
#include "absent.h"
#ifndef NAME
#define NAME "first"
#endif
int main(int argc, char** argv) { ros::init(argc, argv, NAME); }
"""


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    root = tmp_path / "workspace"
    root.mkdir()
    (root / "package.xml").write_text("<package><name>talker</name></package>")
    (root / "CMakeLists.txt").write_text(CMAKE)
    (root / "talker.cpp").write_text(SOURCE)
    (root / "names.h").write_text("// none yet\n")
    return root


def facts(root: Path, cache: Cache | None) -> dict[str, set[tuple[object, ...]]]:
    with extract(root, jobs=1, cache=cache) as extraction:
        (component,) = extraction.components
        return {name: set(rows) for name, rows in component.rows().items()}


def entries(cache: Cache) -> list[Path]:
    """Those of units: all but the precompiled declarations."""
    return sorted(path for path in cache.folder.glob("*/*") if path.parent.name + path.name != extractor_version())


def strings(rows: dict[str, set[tuple[object, ...]]]) -> set[object]:
    return {row[2] for row in rows["literal"] if row[1] == "string"}


def test_a_second_run_reads_nothing_and_gives_the_same_facts(workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cache = Cache(tmp_path / "cache")
    first = facts(workspace, cache)
    assert len(entries(cache)) == 1

    def refuse(*_args: object, **_options: object) -> None:
        raise AssertionError("read again")

    monkeypatch.setattr("rosarch.extractor.units.extract_unit", refuse)
    assert facts(workspace, cache) == first == facts(workspace, cache)


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("names.h", '#define NAME "second"\n'),
        ("talker.cpp", SOURCE.replace("NAME", '"second"')),
        ("absent.h", '#undef NAME\n#define NAME "second"\n'),
        ("CMakeLists.txt", CMAKE + 'add_definitions(-DNAME="second")\n'),
    ],
)
def test_a_changed_or_new_file_is_seen(workspace: Path, tmp_path: Path, file: str, text: str) -> None:
    cache = Cache(tmp_path / "cache")
    assert strings(facts(workspace, cache)) == {"first"}
    (workspace / file).write_text(text)
    after = facts(workspace, cache)
    assert strings(after) == {"second"}
    assert after == facts(workspace, None)


def test_a_source_whose_includes_macros_decide_is_not_kept(workspace: Path, tmp_path: Path) -> None:
    (workspace / "talker.cpp").write_text('#define WHICH "names.h"\n#include WHICH\n' + SOURCE)
    cache = Cache(tmp_path / "cache")
    assert strings(facts(workspace, cache)) == {"first"}
    assert entries(cache) == []


@pytest.mark.parametrize("damage", [b"", b"short", None])
def test_a_damaged_entry_is_replaced(workspace: Path, tmp_path: Path, damage: bytes | None) -> None:
    cache = Cache(tmp_path / "cache")
    first = facts(workspace, cache)
    (entry,) = entries(cache)
    whole = entry.read_bytes()
    entry.write_bytes(whole[:-1] + bytes([whole[-1] ^ 1]) if damage is None else damage)
    assert facts(workspace, cache) == first
    assert marshal.loads(entry.read_bytes()[32:]) == marshal.loads(whole[32:])


def test_a_workspace_elsewhere_shares_the_entries(workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cache = Cache(tmp_path / "cache")
    first = facts(workspace, cache)
    elsewhere = workspace.rename(tmp_path / "elsewhere")
    assert facts(elsewhere, cache) == first
    assert len(entries(cache)) == 1


def test_an_unwritable_cache_is_none(workspace: Path, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    assert facts(workspace, Cache(tmp_path / "file" / "cache")) == facts(workspace, None)


def test_the_entries_unused_for_longest_go_first(tmp_path: Path) -> None:
    cache = Cache(tmp_path)
    for age, key in enumerate(("aaaa", "bbbb", "cccc", "dddd")):
        cache.store(key, b"x" * 68)  # 100 bytes with the checksum
        os.utime(tmp_path / key[:2] / key[2:], (1000 + age, 1000 + age))
    assert cache.load("aaaa") == b"x" * 68  # used now
    cache.trim(limit=400)
    assert len(entries(cache)) == 4
    cache.trim(limit=300)
    assert [cache.load(key) is not None for key in ("aaaa", "bbbb", "cccc", "dddd")] == [True, False, False, True]


def test_hashes_tell_apart_where_texts_end() -> None:
    assert len({hash_of(parts) for parts in (["ab", "c"], ["a", "bc"], ["abc"], ["abc", ""], [b"abc", b"", b""])}) == 5
