"""Nothing outside of the workspace is read, wherever a file of it leads."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from workspace_builder import manifest, package, write

from rosarch.base.boundary import confined, is_inside
from rosarch.base.files import read_file
from rosarch.extractor.pipeline import extract

SOURCE = """\
#include <ros/ros.h>
#include "../../../secret/secret.h"
#include "{secret}/secret.h"
#define MACRO "{secret}/secret.h"
#include MACRO
#include "link.h"
#include "inner.h"
int main() {{ ros::NodeHandle nh; nh.advertise<int>(TOPIC, 1); }}
"""
CMAKE = """\
include_directories({secret})
add_executable(node src/node.cpp)
add_executable(named {secret}/other.cpp)
add_executable(linked src/other.cpp)
file(READ link.txt TEXT)
add_message_files(FILES Link.msg)
"""


@pytest.fixture
def trap(tmp_path: Path) -> Path:
    """A workspace beside a folder of secrets, with everything that could lead there."""
    secret, root = tmp_path / "secret", tmp_path / "ws"
    files = {"secret.h": '#define TOPIC "secret"\nint secret();\n', "other.cpp": "int main() {}\n", "text": "int32 secret\n"}
    write(secret, {**files, "package/package.xml": manifest("outside"), "package/CMakeLists.txt": "project(outside)\n"})
    named = {"secret": str(secret)}
    package(root, "demo", CMAKE.format(**named), {"src/node.cpp": SOURCE.format(**named), "src/inner.h": "", "msg/A.msg": "int32 a\n"})
    for link, target in {"src/link.h": "secret.h", "src/other.cpp": "other.cpp", "link.txt": "text", "msg/Link.msg": "text"}.items():
        os.symlink(secret / target, root / "demo" / link)
    os.symlink(secret / "package", root / "more")
    os.symlink(root / "demo" / "src" / "inner.h", root / "demo" / "src" / "again.h")
    return root


def test_what_leads_out_is_not_read(trap: Path) -> None:
    with extract(trap) as extraction:
        found = [str(problem).replace(f"{trap.parent}/", "") for problem in extraction.diagnostics]
        rows = {component.name: component.rows() for component in extraction.components}
    assert found == [
        "secret/other.cpp:1:1: not analysed: outside of the workspace",
        "ws/demo/CMakeLists.txt:8:1: file: link.txt cannot be read: outside of the workspace",
        "ws/demo/msg/Link.msg:1:1: cannot be read: outside of the workspace",
        "ws/demo/src/other.cpp:1:1: not analysed: outside of the workspace",
        "ws/more:1:1: a link out of the workspace, which is not followed unless its target is in ROS_PACKAGE_PATH",
    ]
    assert sorted(rows) == ["linked", "named", "node"]
    assert [name for _, _, name in rows["node"]["include_missing"]] == ["../../../secret/secret.h"]
    assert "'secret'" not in repr(rows["node"])


@pytest.mark.slow
@pytest.mark.parametrize(
    "include", ['#include "linked/secret.h"', '#define WHERE "linked/secret.h"\n#include WHERE', '#define WHERE "only.h"\n#include WHERE']
)
def test_links_that_only_clang_follows_lead_nowhere(tmp_path: Path, include: str) -> None:
    """A header below a linked folder, and names that macros stand for."""
    write(tmp_path / "secret", {"secret.h": '#define TOPIC "secret"\n'})
    source = f"#include <ros/ros.h>\n{include}\nint main() {{ ros::NodeHandle nh; nh.advertise<int>(TOPIC, 1); }}\n"
    package(tmp_path / "ws", "demo", "add_executable(node src/node.cpp)\n", {"src/node.cpp": source})
    os.symlink(tmp_path / "secret", tmp_path / "ws/demo/src/linked")
    os.symlink(tmp_path / "secret/secret.h", tmp_path / "ws/demo/src/only.h")
    with extract(tmp_path / "ws") as extraction:
        rows = {component.name: component.rows() for component in extraction.components}
    assert "'secret'" not in repr(rows["node"])
    assert rows["node"]["call"]


def test_what_the_package_path_names_is_read(trap: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(trap.parent / "secret"))
    with extract(trap) as extraction:
        assert extraction.diagnostics == []
        rows = {component.name: component.rows() for component in extraction.components}
    assert [rows[name]["source_failed"] for name in ("linked", "named", "node")] == [set(), set(), set()]
    assert rows["node"]["include_missing"] == set()
    assert "'secret'" in repr(rows["node"])


def test_the_inside_is_known_by_real_paths(tmp_path: Path) -> None:
    write(tmp_path, {"ws/a/file": "a", "out/file": "o"})
    os.symlink("ws", tmp_path / "called")
    os.symlink("../out", tmp_path / "ws" / "out")
    os.symlink("a", tmp_path / "ws" / "b")
    assert is_inside("/etc/passwd")
    with confined([tmp_path / "called"]):
        kept = ["called/a/file", "ws/a/file", "ws/b/file", "called/b", "ws"]
        assert [
            name for name in [*kept, "out/file", "ws/out", "ws/out/file", "ws/a/../../out/file", "ws2"] if is_inside(tmp_path / name)
        ] == kept
        assert read_file(tmp_path / "called/a/file") == b"a"
        with pytest.raises(PermissionError, match="outside of the workspace"):
            read_file(tmp_path / "ws/out/file")
        with confined([tmp_path / "out"]):
            assert read_file(tmp_path / "ws/out/file") == b"o"
        assert not is_inside(tmp_path / "ws/out/file")
    assert is_inside(tmp_path / "ws/out/file")
