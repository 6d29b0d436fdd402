"""The cache of extracted units: what it finds again, what it must not, and what damage does."""

from __future__ import annotations

import marshal
import os
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosarch.base.cache import Cache, hash_of
from rosarch.extractor.pipeline import extract
from rosarch.extractor.settings import Settings
from rosarch.extractor.version import extractor_version

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
    """The facts of the only component; none are known, so that the index of units and the entries of all of them are used."""
    with extract(root, settings=Settings(jobs=1, cache=cache), is_cached=lambda _component: False) as extraction:
        (component,) = extraction.components
        return {name: set(rows) for name, rows in component.rows().items()}


def entries(cache: Cache) -> list[Path]:
    """Those of units: all but the precompiled declarations and what is kept of whole stages, which is pickled."""
    others = sorted(path for path in cache.folder.glob("*/*") if path.parent.name + path.name != extractor_version())
    return [path for path in others if path.read_bytes()[32:33] != b"\x80"]


def strings(rows: dict[str, set[tuple[object, ...]]]) -> set[object]:
    return {row[2] for row in rows["literal"] if row[1] == "string"}


def test_a_second_run_reads_nothing_and_gives_the_same_facts(workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cache = Cache(tmp_path / "cache")
    first = facts(workspace, cache)
    assert len(entries(cache)) == 1

    def refuse(*_args: object, **_options: object) -> None:
        raise AssertionError("read again")

    monkeypatch.setattr("rosarch.extractor.cxx.units.extract_unit", refuse)
    assert facts(workspace, cache) == first == facts(workspace, cache)


@pytest.mark.slow
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


@pytest.mark.slow
def test_a_source_whose_includes_macros_decide_is_not_kept(workspace: Path, tmp_path: Path) -> None:
    (workspace / "talker.cpp").write_text('#define WHICH "names.h"\n#include WHICH\n' + SOURCE)
    cache = Cache(tmp_path / "cache")
    assert strings(facts(workspace, cache)) == {"first"}
    assert entries(cache) == []
    assert key(workspace, cache) is None
    (workspace / "names.h").write_text('#define NAME "second"\n')
    assert strings(facts(workspace, cache)) == {"second"}


@pytest.mark.slow
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


def key(root: Path, cache: Cache, packages: list[str] | None = None, **options: Any) -> str | None:
    """The key of the facts of the only component, which are known when they have one."""
    settings = Settings(jobs=1, cache=cache, **options)
    with extract(root, packages, settings, is_cached=lambda component: component.key is not None) as extraction:
        (component,) = extraction.components
        return component.key


@pytest.mark.slow
def test_what_is_known_is_not_looked_at(workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cache = Cache(tmp_path / "cache")
    first = key(workspace, cache)
    assert first is not None
    for entry in entries(cache):
        entry.unlink()

    def refuse(*_args: object, **_options: object) -> None:
        raise AssertionError("looked at again")

    with monkeypatch.context() as patch:
        patch.setattr("rosarch.extractor.units.run_tasks", refuse)
        assert key(workspace, cache) == first
        (workspace / "names.h").write_text("// some\n")
        with pytest.raises(AssertionError, match="looked at again"):
            key(workspace, cache)
    assert key(workspace, cache) not in (first, None)
    (workspace / "names.h").write_text("// none yet\n")
    assert key(workspace, cache) == first
    assert facts(workspace, cache) == facts(workspace, None)  # though the entry was gone


def test_each_question_has_an_index(workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cache = Cache(tmp_path / "cache")
    questions: list[dict[str, Any]] = [{}, {"packages": ["talker"]}, {"defines": {"NAME": "7"}}]
    first = [key(workspace, cache, **options) for options in questions]
    monkeypatch.setattr("rosarch.extractor.units.run_tasks", lambda *_args, **_options: pytest.fail("looked at again"))
    assert [key(workspace, cache, **options) for options in questions] == first


@pytest.mark.slow
@pytest.mark.parametrize("content", [b"", b"short", ()])
def test_a_damaged_index_is_replaced(workspace: Path, tmp_path: Path, content: object) -> None:
    cache = Cache(tmp_path / "cache")
    first = key(workspace, cache)
    (index,) = [path for path in cache.folder.glob("*/*") if b"UnitFile" in path.read_bytes()]
    name, whole = index.parent.name + index.name, len(index.read_bytes())
    index.write_bytes(content) if isinstance(content, bytes) else cache.store_value(name, content)
    assert key(workspace, cache) == first
    assert len(index.read_bytes()) == whole


@pytest.mark.slow
def test_another_message_with_the_name_of_a_header(workspace: Path, tmp_path: Path) -> None:
    """What is generated is no file of the workspace, but it rests on some."""
    (workspace / "CMakeLists.txt").write_text(f"{CMAKE}find_package(message_generation)\nadd_message_files(FILES Level.msg)\n")
    (workspace / "msg").mkdir()
    (workspace / "msg" / "Level.msg").write_text("int32 low\n")
    (workspace / "talker.cpp").write_text(f'#include "talker/Level.h"\n{SOURCE}talker::Level level; int n = level.high;\n')
    cache = Cache(tmp_path / "cache")
    first = facts(workspace, cache)
    (workspace / "msg" / "Level.msg").write_text("int32 high\n")
    assert first != facts(workspace, cache) == facts(workspace, None)


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


TWO = CMAKE.replace("talker.cpp)", "talker.cpp other.cpp third.cpp)")


@pytest.fixture
def sources_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], list[str]]:
    """The names of the sources that were extracted since it was last asked."""
    from rosarch.extractor.cxx import units

    log, real = tmp_path / "log", units.extract_unit

    def logged(unit, *arguments, **options):  # type: ignore[no-untyped-def]
        with log.open("a") as file:
            file.write(f"{unit.source.name}\n")
        return real(unit, *arguments, **options)

    monkeypatch.setattr(units, "extract_unit", logged)

    def read() -> list[str]:
        names = sorted(log.read_text().split()) if log.exists() else []
        log.unlink(missing_ok=True)
        return names

    return read


@pytest.mark.slow
def test_one_change_reads_what_depends_on_it(workspace: Path, tmp_path: Path, sources_read: Callable[[], list[str]]) -> None:
    cache = Cache(tmp_path / "cache")
    (workspace / "CMakeLists.txt").write_text(TWO)
    (workspace / "other.cpp").write_text('#include "names.h"\nvoid other() { help(2); }\n')
    (workspace / "third.cpp").write_text("int third;\n")
    for file, text, read in (
        ("names.h", "inline int help(int x) { return x + 1; }\n", ["other.cpp", "talker.cpp", "third.cpp"]),
        ("other.cpp", '#include "names.h"\nvoid other() { help(3); }\n', ["other.cpp"]),
        ("names.h", "inline int help(int x) { return x + 2; }\n", ["other.cpp", "talker.cpp"]),
        ("third.cpp", "int third = 3;\n", ["third.cpp"]),
    ):
        (workspace / file).write_text(text)
        after = facts(workspace, cache)
        assert sources_read() == read
        assert after == facts(workspace, None)
        sources_read()


def test_headers_that_are_gone_are_read_again(workspace: Path, tmp_path: Path, sources_read: Callable[[], list[str]]) -> None:
    cache = Cache(tmp_path / "cache")
    (workspace / "names.h").write_text("inline int help(int x) { return x + 1; }\n")
    first = facts(workspace, cache)
    found = {entry: marshal.loads(marshal.loads(entry.read_bytes()[32:])[1])[0] for entry in entries(cache)}
    (header,) = [entry for entry, rows in found.items() if "source_file" not in rows]
    header.unlink()
    sources_read()
    assert facts(workspace, cache) == first
    assert sources_read() == ["talker.cpp"]
    assert header.is_file()


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_random_edits(workspace: Path, tmp_path: Path, seed: int) -> None:
    choose = random.Random(seed)
    cache = Cache(tmp_path / "cache")
    (workspace / "CMakeLists.txt").write_text(TWO)
    headers = [
        "struct Base { int value = %d; };\n", "#define LEVEL %d\n", "#pragma once\ninline int help(int x) { return x + %d; }\n",
        '#include "inner.h"\nstruct Part { int part() { return inner(%d); } };\n', "%d is no declaration\n", "#ifdef LEVEL\nint level = %d;\n#endif\n",
    ]  # fmt: skip
    includes = ['#include "names.h"\n', '#include "inner.h"\n', "#define LEVEL 7\n", '#include "absent.h"\n', ""]
    for name in ("inner.h", "other.cpp", "third.cpp"):
        (workspace / name).write_text("int inner(int x);\n")
    for _ in range(6):
        name = choose.choice(["names.h", "inner.h", "absent.h", "other.cpp", "third.cpp"])
        if name.endswith(".h"):
            text = "".join(choose.choice(headers) % choose.randrange(9) for _ in range(2))
        else:
            text = (
                "".join(choose.sample(includes, 3))
                + f"void {name[:5]}() {{ help(LEVEL); Part p; p.part(); int n = {choose.randrange(9)}; }}\n"
            )
        (workspace / name).write_text(text)
        assert facts(workspace, cache) == facts(workspace, None)
