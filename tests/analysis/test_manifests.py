"""What manifests declare, and what files of packages show that they need."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.analysis.systems.manifests import Declared, declared, manifest_rows
from rosarch.extractor.launch import Files, PackagePath, compose


def package(root: Path, name: str, manifest: str = "", **files: str) -> Path:
    folder = root / name
    for path, text in {"package.xml": f"<package>\n<name>{folder.name}</name>\n{manifest}</package>", **files}.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    return folder


def needs(found: tuple[Declared, ...], name: str) -> set[tuple[str, str, int]]:
    return {(need.name, need.how, need.line) for one in found if one.name == name for need in one.needs}


def test_imports(tmp_path: Path) -> None:
    source = (
        '"""\nimport text\n"""\nimport os\nimport robot.arm\nimport beside\nfrom nav_msgs.msg import Odometry\nfrom nav_msgs.msg import Path\n'
        "import tf as t  # frames\nimport json, cv2\nfrom .near import x\nfrom rospy import init_node\ntry:\n    import optional\nexcept ImportError:\n    pass\n"
    )
    package(tmp_path, "robot", "<depend>rospy</depend>", **{"scripts/a.py": source, "scripts/beside.py": "", "test/b.py": "import tested"})
    package(tmp_path, "robot/inner", **{"c.py": "import of_inner"})
    found = declared(tmp_path)
    assert needs(found, "robot") == {("nav_msgs", "interfaces", 7), ("tf", "code", 9)}
    assert needs(found, "inner") == {("of_inner", "code", 1)}


def test_of_two_packages_of_one_name_the_first_counts(tmp_path: Path) -> None:
    package(tmp_path, "a/robot", "<depend>rospy</depend>")
    package(tmp_path, "b/robot", "<depend>rclpy</depend>")
    assert [(one.name, one.depends) for one in declared(tmp_path)] == [("robot", frozenset({"rospy"}))]


def test_what_keeps_packages_from_being_built(tmp_path: Path) -> None:
    """A manifest that is no XML, a name that two packages of one workspace have; not one of two workspaces, or below another package."""
    package(tmp_path, "src/a/robot")
    package(tmp_path, "src/b/robot")
    package(tmp_path, "src/b/robot/inner/robot")
    package(tmp_path, "one/src/lamp")
    package(tmp_path, "two/src/lamp")
    package(tmp_path, "src/c/bulb", "<buildtool_depend>catkin</buildtool_depend>")
    package(tmp_path, "src/d/bulb", "<buildtool_depend>ament_cmake</buildtool_depend>")
    package(tmp_path, "src/broken", "<depend>rospy</depends>\n")
    found = {one.name: one.flaws for one in declared(tmp_path)}
    assert found == {
        "robot": ((2, "name twice", "src/b/robot"),),
        "lamp": (),
        "bulb": (),
        "broken": ((3, "manifest broken", "broken XML: mismatched tag"),),
    }


def test_headers(tmp_path: Path) -> None:
    header = (
        "#ifndef ROBOT_H\n#define ROBOT_H\n#include <map>\n#include <nav_msgs/msg/path.hpp>\n# include <robot/robot.h>\n"
        "#ifdef WITH_LAMP\n#include <lamp/lamp.h>\n#endif\n#include <driver/driver.h>\n#endif\n"
    )
    package(
        tmp_path, "robot", **{"include/robot/robot.h": header, "src/a.cpp": "#if X\n#include <off/off.h>\n#endif\n#include <on/on.h>\n"}
    )
    assert needs(declared(tmp_path), "robot") == {("nav_msgs", "header", 4), ("driver", "header", 9), ("on", "header", 4)}


@pytest.mark.parametrize(
    ("cmake", "expected"),
    [
        ("add_executable(b src/b.cpp)", {"b"}),
        ("set(names b)\nadd_executable(b src/${names}.cpp)", {"a", "b"}),
        ("file(GLOB all src/*.cpp)", {"a", "b"}),
        ("aux_source_directory(src all)", {"a", "b"}),
        ("foreach(one a b)\nadd_part(${one})\nendforeach()", {"a", "b"}),
        ("", {"a", "b"}),
    ],
)
def test_sources_that_nothing_builds(tmp_path: Path, cmake: str, expected: set[str]) -> None:
    package(tmp_path, "robot", **{f"src/{name}.cpp": f"#include <for_{name}/x.h>\n" for name in "ab"}, **{"CMakeLists.txt": cmake})
    assert needs(declared(tmp_path), "robot") == {(f"for_{name}", "header", 1) for name in expected}


def test_rows(tmp_path: Path) -> None:
    model = '<mesh filename="package://meshes/a.dae"/> <!-- package://old/b.dae -->\n$(find driver)'
    launch = '<launch><include file="$(find driver)/a.launch"/></launch>'
    package(
        tmp_path, "robot", "<exec_depend>lamp</exec_depend>\n<test_depend>gtest</test_depend>\n", **{"a.urdf": model, "a.launch": launch}
    )
    package(tmp_path, "meshes", "<depend>far</depend>")
    package(
        tmp_path, "driver", **{"a.launch": "<launch/>", "a.cpp": "#include <nowhere/a.h>\n#include <known/a.h>\n#include <x_msgs/A.h>\n"}
    )
    package(tmp_path, "lamp", "<depend>bulb</depend>\n")
    package(tmp_path, "bulb", "<!-- <depend>off</depend> -->\n<depend>lamp</depend>\n")
    composition = compose([tmp_path / "robot" / "a.launch"], files=Files(PackagePath([tmp_path])))
    rows = manifest_rows(composition, declared(tmp_path), tmp_path, {"known"})
    assert rows["launch_file_of"] == {("robot/a.launch", "robot")}
    assert rows["package_manifest"] == {("robot", "robot/package.xml:4:1"), ("driver", "driver/package.xml:2:1")}
    assert rows["package_needs"] == {
        ("robot/a.urdf:1:1", "robot", "meshes", "file"),
        ("robot/a.urdf:2:1", "robot", "driver", "file"),
        ("driver/a.cpp:2:1", "driver", "known", "header"),
        ("driver/a.cpp:3:1", "driver", "x_msgs", "header"),
    }
    assert rows["package_known"] == {("meshes",), ("driver",), ("known",), ("lamp",)}
    assert rows["package_depends"] == {("robot", "lamp"), ("robot", "gtest"), ("lamp", "bulb"), ("bulb", "lamp"), ("meshes", "far")}
    assert rows["package_after"] == {("robot", "lamp", "robot/package.xml:3:1")}
    assert rows["package_unordered"] == {
        ("bulb", "lamp", "bulb/package.xml:4:1", 0),
        ("lamp", "bulb", "lamp/package.xml:3:1", 1),
        ("robot", "lamp", "robot/package.xml:3:1", 2),
    }


def test_formats_and_kinds(tmp_path: Path) -> None:
    """The kinds of dependencies, each with the last line of it; a manifest without a format has the first one."""
    launch = '<launch><include file="$(find driver)/a.launch"/></launch>'
    package(tmp_path, "robot", "<depend>a</depend>\n<depend>b</depend>\n<test_depend>c</test_depend>\n", **{"a.launch": launch})
    folder = package(tmp_path, "other", "", **{"a.launch": launch})
    (folder / "package.xml").write_text("<package xmlns:x='y'\n format = '3'>\n<name>other</name></package>")
    composition = compose([tmp_path / name / "a.launch" for name in ("robot", "other")], files=Files(PackagePath([tmp_path])))
    rows = manifest_rows(composition, declared(tmp_path), tmp_path, set())
    assert rows["manifest_format"] == {("robot", 1), ("other", 3)}
    assert rows["manifest_kind"] == {("robot", "depend", "robot/package.xml:4:1"), ("robot", "test_depend", "robot/package.xml:5:1")}


def test_metapackages(tmp_path: Path) -> None:
    launch = '<launch><node pkg="x" type="x" name="x"/></launch>'
    package(tmp_path, "robot", "<run_depend>arm</run_depend>\n<run_depend>lamp</run_depend>\n", **{"a.launch": launch})
    package(tmp_path, "arm", "<run_depend>lamp</run_depend><export>\n<metapackage/></export>\n")
    package(tmp_path, "lamp", "<!-- <export><metapackage/></export> -->\n")
    composition = compose([tmp_path / "robot" / "a.launch"], files=Files(PackagePath([tmp_path])))
    assert manifest_rows(composition, declared(tmp_path), tmp_path, ())["package_is_meta"] == {("arm",)}


def test_what_stands_in_a_comment_only_is_set_aside(tmp_path: Path) -> None:
    node = '<launch><node pkg="store" type="a" name="a"/></launch>'
    package(tmp_path, "robot", "<depend>lamp</depend>\n<!-- <depend>lamp</depend> <run_depend>store</run_depend> -->", **{"a.launch": node})
    composition = compose([tmp_path / "robot" / "a.launch"], files=Files(PackagePath([tmp_path])))
    assert manifest_rows(composition, declared(tmp_path), tmp_path, ())["package_set_aside"] == {("robot", "store")}


def test_the_folder_may_be_named_from_where_one_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = package(tmp_path, "robot")
    monkeypatch.chdir(tmp_path)
    assert [one.folder for one in declared(Path())] == [str(folder)]


def test_a_package_that_is_not_built_needs_nothing(tmp_path: Path) -> None:
    package(tmp_path, "robot", **{"a.py": "import tf\n", "COLCON_IGNORE": ""})
    package(tmp_path, "arm", **{"a.py": "import tf\n"})
    found = declared(tmp_path)
    assert (needs(found, "robot"), needs(found, "arm")) == (set(), {("tf", "code", 1)})


def test_a_manifest_that_cannot_be_read(tmp_path: Path) -> None:
    package(tmp_path, "robot").joinpath("package.xml").write_bytes(b"\xff<package>")
    assert declared(tmp_path) == ()
