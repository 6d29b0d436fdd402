"""`rosarch doctor`: what it says of a healthy workspace and of a broken one."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

HEALTHY = "1 component, 1 source, 0 of them with a compile command\nnothing is missing\n"
BROKEN = """\
1 component, 1 source, 0 of them with a compile command
missing headers: 1, replaced by stand-ins that accept every use
  vendor/board.h  in 1 file
  -> add the package to the workspace, or build with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON, which tells where headers are installed
compile-commands: 1
  build/compile_commands.json:1:1: not read: Expecting value
  -> build again with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON, or remove the file
ports with unknown name: 1
  talker/talker.cpp:9  talker/talker: publisher ?  not a constant: argv[1]
  -> nothing, when the name is only known at run time; else `rosarch why-not DIR 'value(...)'` tells which rule is missing
"""


@pytest.mark.slow
def test_a_healthy_workspace(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(workspace)
    outcome = rosarch("doctor", workspace)
    assert (outcome.code, outcome.out, outcome.err) == (0, HEALTHY, "")


def test_a_broken_workspace(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(workspace)
    source = workspace / "talker/talker.cpp"
    source.write_text("#include <vendor/board.h>\n" + source.read_text().replace('"chatter"', "argv[1]"))
    (workspace / "build").mkdir()
    (workspace / "build/compile_commands.json").write_text("nonsense")
    outcome = rosarch("doctor", workspace)
    assert (outcome.code, outcome.out, outcome.err) == (0, BROKEN, "")


def test_what_the_parser_does_not_see(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(workspace)
    source = workspace / "talker/talker.cpp"
    source.write_text("DECLARE(int, level)\ntypedef int T;\nint T::f() {\n  return 1;\n}\n" + source.read_text())
    assert (
        "macros that no header defines: 1, left out where they are used\n"
        "  DECLARE  talker/talker.cpp:1\n"
        "  -> add the package that defines them to the workspace: what they declare or do is not known\n"
        "functions that the parser lost: 1\n"
        "  talker/talker.cpp:3-5  'T' (aka 'int') is not a class, namespace, or enumeration\n"
        "  -> nothing of them is in the model; a header that is missing, or a bracket that does not match, is the usual cause\n"
    ) in rosarch("doctor", workspace).out


def test_sources_of_no_component(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(workspace)
    for name in ("old/once.cpp", "test/tested.cpp", "hidden/left.cpp"):
        (workspace / "talker" / name).parent.mkdir()
        (workspace / "talker" / name).write_text("#include <ros/ros.h>\n")
    (workspace / "talker/hidden/CATKIN_IGNORE").touch()
    (workspace / "talker/plain.cpp").write_text("int one();\n")
    (workspace / "talker/module.py").write_text("import rospy\n")
    assert (
        "sources that use ROS and belong to no component: 2\n  talker/module.py\n  talker/old/once.cpp\n"
        "  -> no target builds them, nothing installs or imports them, or their library is in no program: what they make is in no model\n"
    ) in rosarch("doctor", workspace).out


@pytest.mark.slow
def test_a_source_that_fails_is_a_finding(rosarch: Callable, workspace: Path) -> None:
    endless = "template <int N, int M> struct Tree { Tree<N - 1, 2 * M> left; Tree<N - 1, 2 * M + 1> right; };\nTree<40, 0> tree;\n"
    source = workspace / "talker/talker.cpp"
    source.write_text(endless + source.read_text())
    outcome = rosarch("doctor", workspace, "--timeout", "1")
    assert outcome.code == 1
    assert "not analysed: time limit" in outcome.out
    assert "  -> raise --timeout for time limits; a source that crashes the parser costs that source only\n" in outcome.out


def test_a_package_that_counts_as_installed_is_named(rosarch: Callable, workspace: Path) -> None:
    package = workspace / "roscpp"
    package.mkdir()
    manifest = (workspace / "talker/package.xml").read_text()
    (package / "package.xml").write_text(manifest.replace("<name>talker<", "<name>roscpp<"))
    (package / "CMakeLists.txt").write_text("project(roscpp)\nfind_package(catkin)\ncatkin_package()\n")
    assert "known to rosarch, sources in the workspace not read: roscpp\n" in rosarch("doctor", workspace).out


def test_no_folder(rosarch: Callable, tmp_path: Path) -> None:
    outcome = rosarch("doctor", tmp_path / "none")
    assert (outcome.code, outcome.out, outcome.err) == (2, "", f"rosarch: error: {tmp_path}/none: no such folder\n")
