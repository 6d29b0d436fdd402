from __future__ import annotations

import os
from pathlib import Path

import pytest
from workspace_builder import manifest, messages, package, write

from rosarch.extractor.messages import load_messages
from rosarch.extractor.workspace import discover


def test_missing_folder(tmp_path: Path) -> None:
    workspace = discover(tmp_path / "none")
    assert workspace.packages == ()
    assert messages(workspace, tmp_path) == ["none:1:1: no such folder"]


def test_file_instead_of_folder(tmp_path: Path) -> None:
    write(tmp_path, {"f": ""})
    assert messages(discover(tmp_path / "f"), tmp_path) == ["f:1:1: not a folder"]


def test_folder_without_package(tmp_path: Path) -> None:
    assert messages(discover(tmp_path), tmp_path) == [".:1:1: no package.xml below this folder"]


def test_root_is_a_package(tmp_path: Path) -> None:
    package(tmp_path, "one", "")
    assert [one.name for one in discover(tmp_path / "one").packages] == ["one"]


def test_manifest(tmp_path: Path) -> None:
    package(tmp_path, "one", "", depends=("roscpp", "two"))
    found = discover(tmp_path).packages[0]
    assert (found.version, found.build_type, found.path) == ("1.2.3", "catkin", tmp_path / "one")
    assert found.depends == ("roscpp", "two", "catkin")


@pytest.mark.parametrize(
    ("xml", "message"),
    [
        ("<package>\n  <name>bad</name>\n", "bad/package.xml:3:1: broken XML: no element found"),
        ("<package>\n<name>bad</nam></package>", "bad/package.xml:2:12: broken XML: mismatched tag"),
        ("", "bad/package.xml:1:1: broken XML: no element found"),
        ("<package></package>", "bad/package.xml:1:1: no <name>"),
        ("<other><name>bad</name></other>", "bad/package.xml:1:1: root element is <other>, not <package>"),
        ("<package><name>../../evil</name></package>", "bad/package.xml:1:1: not a package name: '../../evil'"),
        ("<package><name>..&#47;evil</name></package>", "bad/package.xml:1:1: not a package name: '../evil'"),
        ("<package><name>two\nlines</name></package>", "bad/package.xml:1:1: not a package name: 'two\\nlines'"),
    ],
)
def test_broken_manifest_costs_one_package(tmp_path: Path, xml: str, message: str) -> None:
    package(tmp_path, "good", "")
    write(tmp_path, {"bad/package.xml": xml, "bad/CMakeLists.txt": ""})
    workspace = discover(tmp_path)
    assert [one.name for one in workspace.packages] == ["good"]
    assert messages(workspace, tmp_path) == [message]


def test_sloppy_manifest_is_kept(tmp_path: Path) -> None:
    xml = '<package format="2"><name>sloppy</name><depend>roscpp</depend></package>'
    write(tmp_path, {"sloppy/package.xml": xml, "sloppy/CMakeLists.txt": "add_executable(x x.cpp)\n", "sloppy/x.cpp": ""})
    workspace = discover(tmp_path)
    assert [(one.name, one.depends, len(one.targets)) for one in workspace.packages] == [("sloppy", ("roscpp",), 1)]
    assert messages(workspace, tmp_path)[0].startswith("sloppy/package.xml:1:1: not a valid manifest, read leniently: ")


@pytest.mark.parametrize("format_", ["-1", "4", "99999999999999999999"])
def test_formats_to_come_are_read_leniently(tmp_path: Path, format_: str) -> None:
    """catkin_pkg asserts that it knows the format."""
    xml = f"""<package format="{format_}"><name>new</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.orgd">m</maintainer><license>l</license><depend>roscpp</depend></package>"""
    write(tmp_path, {"new/package.xml": xml, "new/CMakeLists.txt": ""})
    workspace = discover(tmp_path)
    assert [(one.name, one.depends) for one in workspace.packages] == [("new", ("roscpp",))]
    assert messages(workspace, tmp_path) == ["new/package.xml:1:1: not a valid manifest, read leniently: its format is not known"]


@pytest.mark.parametrize("marker", ["CATKIN_IGNORE", "COLCON_IGNORE", "AMENT_IGNORE"])
def test_ignore_markers(tmp_path: Path, marker: str) -> None:
    package(tmp_path, "seen", "")
    package(tmp_path / "deep", "hidden", "")
    write(tmp_path, {f"deep/{marker}": ""})
    assert [one.name for one in discover(tmp_path).packages] == ["seen"]
    workspace = discover(tmp_path, ["hidden"])
    assert [one.name for one in workspace.packages] == ["hidden"]
    assert messages(workspace, tmp_path) == ["deep/hidden/package.xml:1:1: package hidden is hidden from the build by an ignore marker"]


def test_packages_below_packages_come_last_and_those_of_tests_and_hidden_folders_not_at_all(tmp_path: Path) -> None:
    package(tmp_path, "outer", "")
    package(tmp_path / "outer", "inner", "")
    package(tmp_path / "outer" / "copy", "zone", "")
    package(tmp_path / "outer" / "test", "fixture", "")
    package(tmp_path / ".hidden", "secret", "")
    package(tmp_path, "zone", "")
    workspace = discover(tmp_path)
    assert [str(one.path.relative_to(tmp_path)) for one in workspace.packages] == ["outer/inner", "outer", "zone"]
    assert messages(workspace, tmp_path) == []


def test_symlink_loop(tmp_path: Path) -> None:
    package(tmp_path, "one", "file(GLOB_RECURSE S *.cpp)\nadd_executable(x ${S})", {"src/a.cpp": ""})
    os.symlink(tmp_path, tmp_path / "again")
    os.symlink(tmp_path / "one", tmp_path / "one" / "src" / "self")
    workspace = discover(tmp_path)
    assert [one.name for one in workspace.packages] == ["one"]
    assert [len(one.sources) for one in workspace.packages[0].targets] == [1]
    assert messages(workspace, tmp_path) == []


def test_links_that_lead_to_themselves(tmp_path: Path) -> None:
    package(tmp_path, "one", "file(GLOB_RECURSE S *.cpp)\nadd_executable(x ${S})", {"src/a.cpp": ""})
    os.symlink("loopb", tmp_path / "loopa")
    os.symlink("loopa", tmp_path / "loopb")
    os.symlink("loop.cpp", tmp_path / "one" / "src" / "loop.cpp")
    workspace = discover(tmp_path)
    assert [len(one.sources) for one in workspace.packages[0].targets] == [1]
    assert messages(workspace, tmp_path) == [
        "loopa:1:1: a link that leads to itself",
        "loopb:1:1: a link that leads to itself",
        "one/CMakeLists.txt:5:1: source of x cannot be read (too many levels of symbolic links): src/loop.cpp",
    ]


def test_a_folder_that_adds_itself(tmp_path: Path) -> None:
    package(
        tmp_path,
        "one",
        "add_executable(x x.cpp)\nadd_subdirectory(sub)",
        {"x.cpp": "", "sub/CMakeLists.txt": "add_subdirectory(up)\nadd_subdirectory(.)"},
    )
    os.symlink("..", tmp_path / "one" / "sub" / "up")
    assert messages(discover(tmp_path), tmp_path) == [
        "one/sub/CMakeLists.txt:1:1: sub-directory up is or contains this one",
        "one/sub/CMakeLists.txt:2:1: sub-directory . is or contains this one",
    ]


def test_folders_and_files_without_permission(tmp_path: Path) -> None:
    package(tmp_path, "one", "file(GLOB S secret/*.cpp)\nadd_executable(y secret/a.cpp)\n", {"secret/a.cpp": ""})
    package(tmp_path, "two", "add_executable(x x.cpp)\n", {"x.cpp": ""})
    package(tmp_path / "closed", "three", "")
    for path in ("one/secret", "two/CMakeLists.txt", "closed"):
        (tmp_path / path).chmod(0)
    if os.access(tmp_path / "closed", os.R_OK):
        pytest.skip("root may read everything")
    try:
        found = messages(discover(tmp_path), tmp_path)
    finally:
        for path in ("one/secret", "two/CMakeLists.txt", "closed"):
            (tmp_path / path).chmod(0o755)
    assert found == [
        "closed:1:1: cannot be read: permission denied",
        "one/CMakeLists.txt:4:1: file: secret cannot be read: permission denied",
        "one/CMakeLists.txt:5:1: source of y cannot be read (permission denied): secret/a.cpp",
        "two/CMakeLists.txt:1:1: cannot be read: permission denied",
    ]


def test_duplicate_package(tmp_path: Path) -> None:
    package(tmp_path / "a", "one", "")
    package(tmp_path / "b", "one", "")
    workspace = discover(tmp_path)
    assert [one.path for one in workspace.packages] == [tmp_path / "a" / "one"]
    assert messages(workspace, tmp_path) == ["b/one/package.xml:1:1: package one is also in a/one/package.xml, which counts"]


def test_only_what_is_needed_is_evaluated(tmp_path: Path) -> None:
    package(tmp_path, "app", "find_package(found_only)\nadd_executable(x x.cpp)", {"x.cpp": ""}, depends=("base",))
    package(tmp_path, "base", "", depends=("deeper",))
    package(tmp_path, "deeper", "")
    package(tmp_path, "found_only", "")
    package(tmp_path, "unrelated", "foo()")
    workspace = discover(tmp_path, ["app"])
    assert [one.name for one in workspace.packages] == ["app", "base", "deeper", "found_only"]
    assert workspace.selected == {"app"}
    assert workspace.diagnostics == ()


def test_unknown_package_gets_a_hint(tmp_path: Path) -> None:
    package(tmp_path, "driver", "")
    assert messages(discover(tmp_path, ["drver"]), tmp_path) == [".:1:1: no package drver below this folder, did you mean `driver`?"]


def test_dependency_cycle_ends(tmp_path: Path) -> None:
    package(tmp_path, "a", "find_package(b)\ncatkin_package(CATKIN_DEPENDS b)", depends=("b",))
    package(tmp_path, "b", "find_package(a)\ncatkin_package(CATKIN_DEPENDS a)", depends=("a",))
    assert len(discover(tmp_path).packages) == 2


def test_missing_cmakelists(tmp_path: Path) -> None:
    write(tmp_path, {"one/package.xml": manifest("one"), "meta/package.xml": manifest("meta", export="<metapackage/>")})
    assert messages(discover(tmp_path), tmp_path) == ["one/package.xml:1:1: package one has no CMakeLists.txt"]


def test_conditional_dependencies_follow_the_distribution(tmp_path: Path) -> None:
    both = '<depend condition="$ROS_VERSION == 1">roscpp</depend><depend condition="$ROS_VERSION == 2">rclcpp</depend>'
    xml = manifest("one").replace('format="2"', 'format="3"').replace("  <export>", f"  {both}<export>")
    write(tmp_path, {"one/package.xml": xml, "one/CMakeLists.txt": ""})
    assert discover(tmp_path).packages[0].depends == ("roscpp", "catkin")
    assert discover(tmp_path, ros_distro="humble").packages[0].depends == ("rclcpp", "catkin")


@pytest.mark.parametrize(
    ("build", "of"),
    [
        ("find_package(catkin REQUIRED)\ncatkin_package()", ("catkin", ("roscpp", "catkin"))),
        ("find_package(ament_cmake REQUIRED)\nament_package()", ("ament_cmake", ("rclcpp", "ament_cmake"))),
        (
            "if($ENV{ROS_VERSION} EQUAL 1)\n  catkin_package()\nelse()\n  ament_package()\nendif()",
            ("ament_cmake", ("rclcpp", "ament_cmake")),
        ),
    ],
)
def test_a_manifest_for_both_versions_is_for_that_of_its_build_file(tmp_path: Path, build: str, of: tuple[str, tuple[str, ...]]) -> None:
    def either(tag: str, first: str, second: str) -> str:
        return f'<{tag} condition="$ROS_VERSION == 1">{first}</{tag}><{tag} condition="$ROS_VERSION == 2">{second}</{tag}>'

    depends = either("depend", "roscpp", "rclcpp") + either("buildtool_depend", "catkin", "ament_cmake")
    xml = f"""<package format="3"><name>one</name><version>1.0.0</version><description>d</description><license>l</license>
<maintainer email="a@b.org">a</maintainer>{depends}<export>{either("build_type", "catkin", "ament_cmake")}</export></package>"""
    write(tmp_path, {"one/package.xml": xml, "one/CMakeLists.txt": f"project(one)\n{build}\n"})
    write(
        tmp_path, {"two/package.xml": xml.replace("one", "two").replace("1.0.0", "no version"), "two/CMakeLists.txt": build}
    )  # read leniently
    assert [(found.build_type, found.depends) for found in discover(tmp_path).packages] == [of, of]


def test_what_an_environment_variable_brings_is_built(tmp_path: Path) -> None:
    arm = "if( $ENV{HAS_ARM} )\n  add_executable(arm arm.cpp)\nendif()\nif(DEFINED ENV{HAS_EYE})\n  add_executable(eye eye.cpp)\nendif()\n"
    other = "if($ENV{REAL})\n  add_executable(real real.cpp)\nelse()\n  add_executable(mock mock.cpp)\nendif()\n"
    known = 'set(ENV{OFF} 0)\nif($ENV{OFF})\n  add_executable(never never.cpp)\nendif()\nif("$ENV{KIND}" STREQUAL "b")\n  add_executable(b b.cpp)\nendif()'
    package(tmp_path, "one", arm + other + known, {f"{name}.cpp": "" for name in ("arm", "eye", "real", "mock", "never", "b")})
    workspace = discover(tmp_path)
    assert [found.name for found in workspace.packages[0].targets] == ["arm", "eye", "mock"]
    assert messages(workspace, tmp_path) == []


def test_order_does_not_depend_on_the_file_system(tmp_path: Path) -> None:
    for name in ("c", "a", "b"):
        package(tmp_path, name, "add_executable(z x.cpp)\nadd_executable(y x.cpp)", {"x.cpp": ""})
    workspace = discover(tmp_path)
    assert [one.name for one in workspace.packages] == ["a", "b", "c"]
    assert [one.name for one in workspace.packages[0].targets] == ["z", "y"]


def test_pipes_do_not_block(tmp_path: Path) -> None:
    package(
        tmp_path,
        "one",
        "add_message_files(FILES A.msg)\nfile(READ pipe x)\n",
        {"msg/B.msg": ""},
        export='<nodelet plugin="${prefix}/plugins.xml"/>',
    )
    (tmp_path / "two").mkdir()
    for name in ("one/msg/A.msg", "one/pipe", "one/plugins.xml", "two/package.xml"):
        os.mkfifo(tmp_path / name)
    workspace = discover(tmp_path)
    assert messages(workspace, tmp_path) == [
        "one/CMakeLists.txt:4:1: no file A.msg in msg",
        "one/CMakeLists.txt:5:1: file: pipe cannot be read: not a regular file",
        "one/plugins.xml:1:1: cannot be read: not a regular file",
        "two/package.xml:1:1: cannot be read: not a regular file",
    ]
    found = [str(problem) for problem in load_messages(workspace.packages, with_common=False).diagnostics]
    assert found == [f"{tmp_path}/one/msg/A.msg:1:1: cannot be read: not a regular file"]
