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
