"""Headers that several units include: whose facts are kept apart, and whose are not."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.recover import Names
from rosarch.extractor.cxx.shared import SharedHeaders
from rosarch.extractor.cxx.translation_unit import CompileUnit, extract_unit

Rows = Mapping[str, set[tuple[str | int, ...]]]

HEADER = """
#pragma once
#include "base.h"
struct Wheel : Base {
  double speed = 1.5;
  void turn(double by) { if (by > 0) speed += scaled(by); }
};
"""
BASE = "#pragma once\nstruct Base { double scaled(double x) { return 2 * x; } };\n"
SOURCE = '#include "wheel.h"\nvoid run(Wheel& wheel) { wheel.turn(0.5); wheel.scaled(1); }\n'


class Kept:
    """A store in memory."""

    def __init__(self) -> None:
        self.rows: dict[str, Rows] = {}
        self.names: dict[str, Names] = {}

    def load(self, key: str) -> Names | None:
        return self.names.get(key)

    def store(self, key: str, names: Names, rows: Rows) -> None:
        assert key not in self.rows
        self.names[key], self.rows[key] = names, rows


@pytest.fixture
def read(tmp_path: Path, prelude: Path) -> Callable[..., tuple[Rows, dict[str, str]]]:
    """Extract a source with a store; its own rows, and the keys of the headers that it leaves to the store."""
    root = tmp_path / "src"
    root.mkdir()

    def read_one(name: str, kept: Kept | None, definitions: tuple[str, ...] = (), **files: str) -> tuple[Rows, dict[str, str]]:
        for path, text in files.items():
            (root / path.replace("_", ".")).write_text(text)
        finder = HeaderFinder(root, tmp_path / "scratch", lambda _name: None)
        unit = CompileUnit(root / name, definitions=definitions)
        shared = SharedHeaders(unit.source, unit.folders, (unit.language, *definitions), finder, kept) if kept else None
        rows = extract_unit(unit, root, finder, prelude, heal=True, headers=shared)
        return rows, {Path(path).name: key for path, key in shared.keys.items()} if shared else {}

    return read_one


def united(own: Rows, keys: Mapping[str, str], kept: Kept) -> dict[str, set[tuple[str | int, ...]]]:
    parts = [own, *(kept.rows[key] for key in keys.values())]
    return {
        name: rows for name in {name for part in parts for name in part} if (rows := {row for part in parts for row in part.get(name, ())})
    }


def test_a_header_is_read_once_and_nothing_is_lost(read: Callable) -> None:
    kept = Kept()
    files = {"wheel_h": HEADER, "base_h": BASE, "a_cpp": SOURCE, "b_cpp": SOURCE.replace("run", "walk")}
    first, keys = read("a.cpp", kept, **files)
    second, again = read("b.cpp", kept)
    assert keys == again
    assert sorted(keys) == ["base.h", "wheel.h"]
    for name, own in (("a.cpp", first), ("b.cpp", second)):
        assert not {row for row in own["function_defined"] if "wheel.h" in str(row[0])}
        assert united(own, keys, kept) == {relation: rows for relation, rows in read(name, None)[0].items() if rows}


def test_recovered_calls_find_what_headers_declare(read: Callable) -> None:
    kept = Kept()
    source = '#include "wheel.h"\nvoid run(Wheel& wheel) { absent::there(wheel.turn(1), unknown); }\n'
    own, keys = read("a.cpp", kept, wheel_h=HEADER, base_h=BASE, a_cpp=source)
    plain, _ = read("a.cpp", None)
    assert keys
    assert united(own, keys, kept) == {relation: rows for relation, rows in plain.items() if rows}
    assert "turn" in {row[1] for row in own["call"]}


@pytest.mark.parametrize(
    ("header", "before"),
    [
        ("void f() { undeclared(1); }", ""),
        ("inline int f() { return from_source(); }", "int from_source();"),
        ("inline int f() { return NUMBER; }", "#define NUMBER 3"),
        ("struct S : Other {};", "struct Other {};"),
        ("int known(int x);", "int known(int x);"),
        ('#define INNER "base.h"\n#include INNER\nvoid f();', ""),
    ],
)
def test_what_does_not_stand_alone_stays_with_the_unit(read: Callable, header: str, before: str) -> None:
    kept = Kept()
    _, keys = read("a.cpp", kept, lone_h=header, base_h=BASE, a_cpp=f'{before}\n#include "lone.h"\n')
    assert "lone.h" not in keys


def test_conditions_tell_headers_apart(read: Callable) -> None:
    kept = Kept()
    header = "#pragma once\n#ifdef FAST\nconst int speed = 2;\n#else\nconst int speed = 1;\n#endif\n"
    _, slow = read("a.cpp", kept, speed_h=header, a_cpp='#include "speed.h"\n')
    _, fast = read("a.cpp", kept, ("FAST",))
    own, none = read("b.cpp", kept, b_cpp='#define FAST\n#include "speed.h"\n')
    literals = {key: {row[2] for row in rows["literal"]} for key, rows in kept.rows.items()}
    assert literals == {slow["speed.h"]: {"1"}, fast["speed.h"]: {"2"}}
    assert ({row[2] for row in own["literal"]}, none) == ({"2"}, {})


def test_a_change_of_what_is_included_is_another_header(read: Callable) -> None:
    kept = Kept()
    _, keys = read("a.cpp", kept, wheel_h=HEADER, base_h=BASE, a_cpp=SOURCE)
    _, changed = read("a.cpp", kept, base_h=BASE.replace("2", "3"))
    assert all(keys[name] != changed[name] for name in ("wheel.h", "base.h"))


def test_a_definition_that_the_header_does_not_include_is_not_seen(read: Callable) -> None:
    files = {
        "h_h": "#pragma once\nclass Later;\nstruct Holder { Later* later; };\n",
        "def_h": "#pragma once\nstruct Base {};\nclass Later : public Base {};\n",
        "a_cpp": '#include "h.h"\n#include "def.h"\n',
        "b_cpp": '#include "h.h"\n',
    }
    found: dict[str, list[Rows]] = defaultdict(list)
    for source in ("a.cpp", "b.cpp"):
        kept = Kept()
        _, keys = read(source, kept, **files)
        found[keys["h.h"]].append({relation: rows for relation, rows in kept.rows[keys["h.h"]].items() if rows})
    ((first, second),) = found.values()
    assert first == second
    assert "class_base" not in first
