"""Files of the input that lead elsewhere, or whose names mean something: what is outside is not shown, names are told whole."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest

SECRET = "the-secret-line"
STARTED = '<launch><node name="t" pkg="talker" type="talker"/></launch>\n'


READERS = [("check", "-v"), ("check", "--format", "sarif"), ("report", "--no-proofs", "-o", "page.html")]


@pytest.mark.slow
def test_no_report_shows_what_a_link_out_of_the_workspace_leads_to(
    rosarch: Callable, workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    secret, other = tmp_path / "secret", tmp_path / "other"
    package = workspace / "talker"
    for path, names in ((secret, ("t.launch", "more.cpp", "msg/Talk.msg", "p.yaml", "here/package.xml")), (other, ("alone.launch",))):
        path.write_text(f"{SECRET}\n" * 9)
        for name in names:
            (package / name).parent.mkdir(exist_ok=True)
            (package / name).symlink_to(path)
    (package / "main.launch").write_text(
        f'<launch><include file="$(dirname)/t.launch"/><include file="{secret}"/><rosparam file="$(dirname)/p.yaml"/>'
        '<node name="t" pkg="talker" type="talker"/></launch>\n'
    )
    for words in READERS:
        done = rosarch(words[0], workspace, *words[1:])
        assert done.code in (0, 1), (words, done.err)
        page = (tmp_path / "page.html").read_text() if words[0] == "report" else ""
        assert SECRET not in done.out + done.err + page, words
    assert (tmp_path / "page.html").stat().st_size
    assert "alone.launch cannot be read: outside of the workspace" in rosarch("check", workspace).out


@pytest.mark.slow
def test_a_node_with_a_source_that_cannot_be_read_may_have_more_than_is_seen(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    package = workspace / "talker"
    (package / "CMakeLists.txt").write_text("project(talker)\nadd_executable(talker talker.cpp more.cpp)\n")
    (package / "t.launch").write_text(
        '<launch><node name="t" pkg="talker" type="talker"><param name="unread" value="1"/><remap from="unmade" to="x"/></node></launch>\n'
    )
    ignored = {"parameter-not-read", "remap-without-effect"}
    (package / "more.cpp").write_text("void more() {}\n")
    assert _checks(rosarch, workspace) & ignored == ignored
    (package / "more.cpp").rename(tmp_path / "more.cpp")
    (package / "more.cpp").symlink_to(tmp_path / "more.cpp")
    assert _checks(rosarch, workspace) & ignored == set()


def _checks(rosarch: Callable, workspace: Path) -> set[str]:
    """The checks that find something."""
    return {finding["check"] for finding in json.loads(rosarch("check", workspace, "--format", "json").out)["findings"]}


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["with  spaces 'and \"quotes", "with\na line break", os.fsdecode(b"not \xff\xfe UTF-8"), "-dash", "$(arg x) ${y}", "#%&"]
)
def test_names_that_mean_something(rosarch: Callable, workspace: Path, tmp_path: Path, name: str) -> None:
    folder = workspace.rename(tmp_path / name)
    (folder / "talker" / f"{name}.launch").write_text(STARTED)
    (folder / "talker" / f"{name}.cpp").write_text("int main() {}\n")
    shown = name.replace("\n", r"\n").replace("\udcff\udcfe", r"\xff\xfe")
    done = rosarch("check", folder, "-v")
    assert "/t is started" in done.out
    assert f"in: talker/{shown}.launch" in done.out.splitlines()[-4]
    (folder / "talker" / f"{name}.launch").write_text("<launch>")
    done = rosarch("check", folder, "-v")
    assert f"{shown}.launch:1:9: broken XML: no element found" in done.err
    assert done.code == 1


def test_files_that_are_too_large_are_not_read(
    rosarch: Callable, workspace: Path, at_most: Callable[[float], AbstractContextManager[None]]
) -> None:
    package = workspace / "talker"
    (package / "launch").mkdir()
    (package / "launch" / "main.launch").write_text(
        STARTED.replace("</launch>", '<rosparam file="$(dirname)/p.yaml"/><include file="$(dirname)/other.launch"/></launch>')
    )
    sizes = {
        "launch/p.yaml": 32, "launch/other.launch": 32, "msg/Talk.msg": 4, "setup.py": 4, "../here/package.xml": 4, "there/CMakeLists.txt": 32,
    }  # fmt: skip
    for name, size in sizes.items():
        (package / name).parent.mkdir(exist_ok=True)
        (package / name).touch()
        os.truncate(package / name, (size << 20) + 1)
    with (package / "CMakeLists.txt").open("a") as file:
        file.write("catkin_python_setup()\nadd_message_files(FILES Talk.msg)\nadd_subdirectory(there)\n")
    with at_most(5):
        done = rosarch("check", workspace, "-v")
    lines = [line.replace(f"{workspace.parent}/", "") for line in done.err.splitlines()]
    assert [line for line in lines if line.startswith("  ")] == [
        "  ws/talker/launch/main.launch:1:52: ws/talker/launch/p.yaml has more than 32 MiB and is not read",
        "  ws/talker/launch/main.launch:1:88: ws/talker/launch/other.launch has more than 32 MiB and is not read",
        "  ws/talker/setup.py:1:1: not read: larger than 4 MiB",
        "  ws/here/package.xml:1:1: cannot be read: larger than 4 MiB",
        "  ws/talker/msg/Talk.msg:1:1: cannot be read: larger than 4 MiB",
        "  ws/talker/there/CMakeLists.txt:1:1: cannot be read: larger than 32 MiB",
    ]
    assert (done.code, done.out.splitlines()[-1]) == (0, "checked 1 system with 1 node")
