"""From a workspace to the facts of its components."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

import pytest
from workspace_builder import package, write

from rosarch.base.cache import Cache
from rosarch.extractor.cxx.unit import file_key
from rosarch.extractor.manifest import read_manifest
from rosarch.extractor.pipeline import ComponentFacts, Extraction, extract
from rosarch.extractor.settings import Settings

LIBRARY = '#include "common/helper.h"\nvoid help(int x) { help_more(x); }\n'
HEADER = "#pragma once\nvoid help(int x);\ninline void help_more(int x) { if (x > 0) help(x - 1); }\n"
NODE = '#include <ros/ros.h>\n#include <std_msgs/Bool.h>\n#include "common/helper.h"\nint main(int argc, char** argv) { ros::NodeHandle nh; help(LEVEL); auto p = nh.advertise<std_msgs::Bool>("out", 1); }\n'


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """Two packages: a library with a node, and a package whose two nodes use it."""
    src = tmp_path / "src"
    package(
        src, "common",
        "catkin_package(INCLUDE_DIRS include LIBRARIES helper)\ninclude_directories(include)\nadd_library(helper src/helper.cpp)\nadd_executable(self src/self.cpp)\ntarget_link_libraries(self helper)\nadd_definitions(-DLEVEL=1)\n",
        {"src/helper.cpp": LIBRARY, "include/common/helper.h": HEADER, "src/self.cpp": NODE},
    )  # fmt: skip
    package(
        src, "robot",
        "find_package(catkin REQUIRED COMPONENTS common)\ninclude_directories(${catkin_INCLUDE_DIRS})\nadd_definitions(-DLEVEL=2)\n"
        "add_executable(left left.cpp)\ntarget_link_libraries(left ${catkin_LIBRARIES})\nadd_executable(right right.cpp extra.cpp)\ntarget_link_libraries(right helper)\n",
        {"left.cpp": NODE, "right.cpp": NODE, "extra.cpp": "int extra;\n"}, depends=("common",),
    )  # fmt: skip
    return src


def component(extraction: Extraction, name: str) -> ComponentFacts:
    (found,) = [component for component in extraction.components if component.name == name]
    return found


def rows(root: Path, packages: list[str] | None = None, *, jobs: int) -> dict[str, dict[str, set[tuple[str | int, ...]]]]:
    with extract(root, packages, Settings(jobs)) as extraction:
        return {
            component.name: {name: set(found) for name, found in component.rows().items() if found} for component in extraction.components
        }


def test_components_and_their_sources(root: Path) -> None:
    with extract(root, settings=Settings(jobs=1)) as extraction:
        assert [(c.package, c.name, c.kind, c.sources) for c in extraction.components] == [
            ("common", "self", "node", ("common/src/self.cpp",)),
            ("robot", "left", "node", ("robot/left.cpp",)),
            ("robot", "right", "node", ("robot/right.cpp", "robot/extra.cpp")),
        ]
        right = component(extraction, "right").rows()
        assert set(right["component"]) == {("right", "robot", "node")}
        assert set(right["component_source"]) == {
            (file_key("robot/right.cpp"), "own"), (file_key("robot/extra.cpp"), "own"), (file_key("common/src/helper.cpp"), "library"),
        }  # fmt: skip
        assert extraction.diagnostics == []


def test_a_class_with_a_program_of_its_own_is_started_as_that(tmp_path: Path) -> None:
    cmake = 'add_library(parts parts.cpp)\nrclcpp_components_register_nodes(parts "demo::Part")\nadd_executable(Part main.cpp)\n'
    package(tmp_path, "demo", cmake, {"parts.cpp": "int x;\n", "main.cpp": "int main() {}\n"})
    with extract(tmp_path) as extraction:
        named = {each.kind: each.own["component_executable"] for each in extraction.components}
    assert named["component"] == {("Part",)}
    assert named["node"] == set()


def test_a_shared_library_is_part_of_each_component(root: Path) -> None:
    found = rows(root, jobs=1)
    for name in ("self", "left", "right"):
        defined = {str(function).partition("@")[0] for (function,) in found[name]["function_defined"]}
        assert defined == {"main", "help", "help_more"}
        paths = {path for _, path in found[name]["source_file"]}
        assert {"common/src/helper.cpp", "common/include/common/helper.h"} <= paths
    assert all(
        found["left"][relation] >= {row for row in found["right"][relation] if "helper" in str(row)}
        for relation in ("call", "location", "function")
    )


def test_definitions_of_the_package_are_used(root: Path) -> None:
    found = rows(root, jobs=1)
    arguments = {
        name: [value for expr, kind, value in found[name]["literal"] if kind == "integer" and ":4:" in str(expr)]
        for name in ("self", "left")
    }
    assert "1" in arguments["self"]
    assert "2" in arguments["left"]


def test_message_classes_are_those_that_are_named(root: Path) -> None:
    found = rows(root, jobs=1)
    types = {type_ for _, _, type_ in found["left"]["message_class"]}
    assert "std_msgs/Bool" in types
    assert len(types) < 20


def test_only_the_packages_that_were_asked_for(root: Path) -> None:
    assert sorted(rows(root, packages=["common"], jobs=1)) == ["self"]


@pytest.mark.slow
def test_the_number_of_workers_changes_nothing(root: Path) -> None:
    assert rows(root, jobs=1) == rows(root, jobs=2) == rows(root, jobs=4)


@pytest.mark.slow
def test_written_facts_are_the_same_bytes(root: Path, tmp_path: Path) -> None:
    texts = []
    for jobs in (1, 2):
        out = tmp_path / f"facts{jobs}"
        with extract(root, settings=Settings(jobs=jobs)) as extraction:
            extraction.write(out)
        texts.append({path.relative_to(out).as_posix(): path.read_bytes() for path in sorted(out.rglob("*")) if path.is_file()})
    assert texts[0] == texts[1]
    assert {"manifest.json", "robot/left/call.facts", "robot/right/source_failed.facts"} <= set(texts[0])
    manifest = read_manifest(tmp_path / "facts1")
    assert [(entry.package, entry.component, entry.folder) for entry in manifest.entries] == [
        ("common", "self", "common/self"),
        ("robot", "left", "robot/left"),
        ("robot", "right", "robot/right"),
    ]


def test_a_folder_that_was_moved_gives_the_same_facts(root: Path, tmp_path: Path) -> None:
    before = rows(root, jobs=1)
    root.rename(tmp_path / "elsewhere")
    assert rows(tmp_path / "elsewhere", jobs=1) == before


def test_one_unreadable_source_costs_itself(root: Path) -> None:
    """A source that is there for CMake but cannot be opened."""
    broken = root / "robot/extra.cpp"
    broken.unlink()
    broken.mkdir()
    with extract(root, settings=Settings(jobs=1)) as extraction:
        assert [component.name for component in extraction.components] == ["self", "left", "right"]
        right = component(extraction, "right").rows()
        assert "main" in {name for _, name in right["function_name"]}
        lines = [str(diagnostic) for diagnostic in extraction.diagnostics if "extra.cpp" in str(diagnostic)]
        assert len(lines) == 1
        assert "\n" not in lines[0]


def test_a_crash_in_one_source_costs_itself(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from rosarch.extractor.cxx import units

    real = units.extract_unit

    def crash_on_extra(unit, *arguments, **options):  # type: ignore[no-untyped-def]
        if unit.source.name == "extra.cpp":
            os._exit(7)
        return real(unit, *arguments, **options)

    monkeypatch.setattr(units, "extract_unit", crash_on_extra)
    with extract(root, settings=Settings(jobs=1)) as extraction:
        right, left = component(extraction, "right").rows(), component(extraction, "left").rows()
        assert set(right["source_failed"]) == {(file_key("robot/extra.cpp"), "crash")}
        assert "main" in {name for _, name in right["function_name"]}
        assert not left.get("source_failed")
        lines = [str(diagnostic).replace(f"{root}/", "") for diagnostic in extraction.diagnostics]
        assert lines == ["robot/extra.cpp:1:1: not analysed: crash (the worker process ended with code 7)"]


def test_an_error_in_one_source_is_one_line(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from rosarch.extractor.cxx import units

    def fail(unit, *_arguments, **_options):  # type: ignore[no-untyped-def]
        raise ValueError("broken")

    monkeypatch.setattr(units, "extract_unit", fail)
    with extract(root, packages=["common"], settings=Settings(jobs=1)) as extraction:
        lines = [str(diagnostic).replace(f"{root}/", "") for diagnostic in extraction.diagnostics]
        assert [line.partition(", in ")[0] for line in lines] == [
            f"common/src/{name}:1:1: not analysed: error (ValueError: broken" for name in ("helper.cpp", "self.cpp")
        ]
        assert all("\n" not in line for line in lines)


BAD_SOURCES = {
    "empty": b"",
    "not UTF-8": b"// caf\xe9\nint x;\n",
    "includes itself": b'#include "extra.cpp"\nint y;\n',
    "binary": bytes(range(256)),
}


@pytest.mark.slow
@pytest.mark.parametrize("case", BAD_SOURCES)
def test_a_bad_source_stops_nothing(root: Path, case: str) -> None:
    write(root, {"robot/extra.cpp": BAD_SOURCES[case]})
    found = rows(root, packages=["robot"], jobs=1)
    assert "main" in {name for _, name in found["right"]["function_name"]}
    assert found["left"]["call"] == {row for row in found["left"]["call"]}


@pytest.mark.slow
@pytest.mark.parametrize("case", BAD_SOURCES)
def test_a_bad_source_is_reported(root: Path, case: str) -> None:
    write(root, {"robot/extra.cpp": BAD_SOURCES[case]})
    with extract(root, packages=["robot"], settings=Settings(jobs=1)) as extraction:
        lines = [str(diagnostic).replace(f"{root}/", "") for diagnostic in extraction.diagnostics]
    column = 7 if case == "not UTF-8" else 1
    assert len([line for line in lines if line.startswith(f"robot/extra.cpp:1:{column}: ")]) == 1


LOSING = {
    "void f() {\n": "2:10: code from here on may be missing: expected '}'",
    "void f() {}\n}\n": "2:1: code from here on may be missing: extraneous closing brace ('}')",
    "/* int x;\n": "1:1: code from here on may be missing: unterminated /* comment",
    "#if 1\n": "1:2: code from here on may be missing: unterminated conditional directive",
    'auto s = R"x(a)";\n': '1:10: code from here on may be missing: raw string missing terminating delimiter )x"',
    "void f() "
    + "{" * 3000
    + "}" * 3000: "1:2058: code from here on may be missing: bracket nesting level exceeded maximum of 2048, and 2048 more such errors",
}


@pytest.mark.slow
@pytest.mark.parametrize("text", LOSING)
def test_errors_that_lose_code_are_told(root: Path, tmp_path: Path, text: str) -> None:
    write(root, {"robot/extra.cpp": text + "int last;"})
    cache = Cache(tmp_path / "cache")
    for _run in range(2):  # the second time from the cache
        with extract(root, packages=["robot"], settings=Settings(jobs=1, cache=cache)) as extraction:
            lines = [str(diagnostic).replace(f"{root}/", "") for diagnostic in extraction.diagnostics]
        assert [line for line in lines] == [f"robot/extra.cpp:{LOSING[text]}"]


def test_harmless_errors_are_not_told(root: Path) -> None:
    write(
        root,
        {"robot/extra.cpp": "#include <QtGui/QFoo.h>\nNS_BEGIN(x)\nclass A : Q::B { Q_OBJECT; void f(Mat m) { m.bar(); } };\nNS_END\n"},
    )
    with extract(root, packages=["robot"], settings=Settings(jobs=1)) as extraction:
        assert extraction.diagnostics == []


def test_progress_counts_the_sources(root: Path) -> None:
    seen: list[tuple[str, int, int]] = []
    with extract(root, settings=Settings(jobs=1, progress=lambda *step: seen.append(step))):
        pass
    total = seen[-1][2]
    assert seen == [("sources", number, total) for number in range(1, total + 1)]


def test_temporary_files_go(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(scratch))
    with extract(root, settings=Settings(jobs=1)):
        assert list(scratch.iterdir()) != []
    assert list(scratch.iterdir()) == []
    assert sorted(path.name for path in root.iterdir()) == ["common", "robot"]


def test_an_empty_folder_has_no_components(tmp_path: Path) -> None:
    with extract(tmp_path, settings=Settings(jobs=1)) as extraction:
        assert extraction.components == ()


def test_an_extraction_that_is_interrupted_leaves_no_temporary_files(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_arguments: object) -> None:
        assert list(temporary.iterdir())
        raise KeyboardInterrupt

    (temporary := tmp_path / "temporary").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(temporary))
    monkeypatch.setattr("rosarch.extractor.pipeline.Sources.read", interrupted)
    with pytest.raises(KeyboardInterrupt) as caught:
        extract(root)
    assert list(temporary.iterdir()) == [], caught  # whose traceback keeps what is not closed
