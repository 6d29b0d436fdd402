"""Fixes: where changes are in texts, and files with them carried out."""

from __future__ import annotations

import os
import time
from dataclasses import replace
from pathlib import Path

import pytest
from handmade_findings import finding

from rosarch.base.places import Place
from rosarch.findings.fixes import carried_out, edit_for, edits_of, region_of, repairs, unified, write
from rosarch.findings.model import Change, Finding

XML = '<launch>\n  <include file="c.launch">\n    <arg name="frme"/>\n  </include>\n  <node pkg="a" nme="b"\n        type="t"/> <!-- t -->\n</launch>\n'
PYTHON = "def f():\n    x = Node(\n        package='a',  # 'b'\n        plugin='b:C', name='d')\n    y = Node(plugin='b:C')\n"
MANIFEST = "<package>\n  <name>a</name>\n\t<depend>b</depend> <!-- c -->\n  <depend>\n   d</depend>\n</package>\n"


def changed(text: str, line: int, written: str, meant: str, *, column: int = 1, path: str = "a.launch") -> str | None:
    """The text with a change; None where it is not certain."""
    edit = edit_for(Change(Place(path, line, column), written, meant), text)
    return None if edit is None else carried_out([edit], text)


def having(*changes: Change) -> Finding:
    return replace(finding(), changes=changes)


@pytest.mark.parametrize(
    ("path", "text", "line", "column", "written", "meant", "before", "after"),
    [
        ("a.launch", XML, 5, 3, "nme", "name", 'nme="b"', 'name="b"'),
        ("a.launch", XML, 5, 3, "t", "u", 'type="t"', 'type="u"'),  # on another line of the tag
        ("a.launch", XML, 2, 3, "frme", "frame", '"frme"', '"frame"'),  # in the element
        ("a.launch.py", PYTHON, 2, 9, "b:C", "b::C", "plugin='b:C', name", "plugin='b::C', name"),
        ("a.yaml", "a:\n  b: {ros_parameters: 1}\n", 2, 1, "ros_parameters", "ros__parameters", "ros_p", "ros__p"),
        ("CMakeLists.txt", 'register(a\n  "b")\nregister(b "b")\n', 1, 1, "b", "c::b", '  "b"', '  "c::b"'),
        ("package.xml", MANIFEST, 3, 1, "", "<depend>e</depend>", "<!-- c -->\n", "<!-- c -->\n\t<depend>e</depend>\n"),
        ("package.xml", MANIFEST.replace("\n", "\r\n"), 2, 1, "", "<depend>e</depend>", "</name>\r\n", "</name>\r\n  <depend>e</depend>\r\n"),
    ],
)  # fmt: skip
def test_changes(path: str, text: str, line: int, column: int, written: str, meant: str, before: str, after: str) -> None:
    assert changed(text, line, written, meant, column=column, path=path) == text.replace(before, after)


@pytest.mark.parametrize(
    ("path", "text", "line", "written", "meant"),
    [
        ("a.launch", XML, 5, "frme", "frame"),  # in another element
        ("a.launch", XML, 9, "nme", "name"),
        ("a.launch", '<node pkg="a" type="a"/>', 1, "a", "b"),  # twice
        ("a.launch", '<node type="a_b"/>', 1, "a", "c"),  # part of a word
        ("a.launch", '<node type="a"/>', 1, "a", 'b" output="screen'),  # more than a text
        ("a.launch", '<node type="a', 1, "a", "b"),  # no tag
        ("a.py", "f(x,\n  'a'", 1, "a", "b"),  # the call does not end
        ("a.py", 'f("""a""")', 1, "a", "b"),
        ("package.xml", MANIFEST, 5, "", "<depend>e</depend>"),  # no element by itself
        ("package.xml", MANIFEST, 2, "", "<depend>e\n</depend>"),
        ("package.xml", "<package>\n  <name>a</name>\n  <depend>e</depend>\n</package>", 2, "", "<depend>e</depend>"),  # it is so already
        ("package.xml", "<name>a</name>", 1, "", "<depend>e</depend>"),
    ],
)
def test_what_is_not_certain(path: str, text: str, line: int, written: str, meant: str) -> None:
    assert changed(text, line, written, meant, path=path) is None


def test_regions_and_all_or_none() -> None:
    two = having(Change(Place("a", 1, 1), "b", "c"), Change(Place("a", 2, 1), "d", "e"))
    text = "b\nx d\n"
    assert [region_of(text, edit) for _, text, edit in edits_of(two, {"a": text}.get)] == [(1, 1, 1, 2), (2, 3, 2, 4)]
    assert edits_of(two, {"a": "b\nx\n"}.get) == ()
    assert edits_of(two, {}.get) == ()


def test_one_text_that_would_become_several() -> None:
    at = Place("a", 1, 1)
    assert having(Change(at, "b", "c"), Change(at, "b", "d")).fix == ()
    both = Change(at, "", "<a>c</a>"), Change(at, "", "<a>d</a>")
    assert having(*both).fix == both


def test_the_rest_stays_byte_for_byte(tmp_path: Path) -> None:
    before = b'<?xml version="1.0" encoding="latin-1"?>\r\n<node nme="caf\xe9"/>\n<!-- \xff -->\r\n</launch>'
    (tmp_path / "a.launch").write_bytes(before)
    os.chmod(tmp_path / "a.launch", 0o640)
    found = having(Change(Place("a.launch", 2, 1), "nme", "name"))
    (made,), left = repairs([found, found], tmp_path, time.time_ns())
    assert (left, made.count, made.before, made.after) == ([], 1, before, before.replace(b"nme", b"name"))
    write(made, tmp_path)
    assert (tmp_path / "a.launch").read_bytes() == made.after
    assert os.stat(tmp_path / "a.launch").st_mode & 0o777 == 0o640
    assert [path.name for path in tmp_path.iterdir()] == ["a.launch"]
    with pytest.raises(OSError, match="it has changed since it was read"):
        write(made, tmp_path)


def test_a_patch(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_bytes(b"a: b\r\nc: d")
    (made,), _ = repairs([having(Change(Place("a.yaml", 2, 1), "d", "e"))], tmp_path, time.time_ns())
    assert "".join(unified([made])) == (
        "--- a/a.yaml\n+++ b/a.yaml\n@@ -1,2 +1,2 @@\n a: b\r\n-c: d\n\\ No newline at end of file\n+c: e\n\\ No newline at end of file\n"
    )


def test_files_that_are_left_alone(tmp_path: Path) -> None:
    ws = tmp_path / "ws"
    ws.mkdir()
    for path in (tmp_path / "outside.yaml", ws / "late.yaml", ws / "other.yaml", ws / "inside.yaml"):
        path.write_text("a: b\n")
    (ws / "other.yaml").write_text("a: c\n")
    (ws / "link.yaml").symlink_to(tmp_path / "outside.yaml")
    since = time.time_ns()
    os.utime(ws / "late.yaml", ns=(since + 1, since + 1))
    paths = ("link.yaml", "../outside.yaml", str(tmp_path / "outside.yaml"), "late.yaml", "other.yaml", "absent.yaml", "inside.yaml")
    made, left = repairs([having(Change(Place(path, 1, 1), "b", "c")) for path in paths], ws, since)
    assert [repair.path for repair in made] == ["inside.yaml"]
    assert {each.change.place.path: each.why for each in left} == {
        "link.yaml": "it is outside of the workspace",
        "../outside.yaml": "it is outside of the workspace",
        str(tmp_path / "outside.yaml"): "it is outside of the workspace",
        "late.yaml": "it has changed since it was read",
        "other.yaml": "the text that is to be changed is not certain",
        "absent.yaml": "No such file or directory",
    }


def test_of_two_changes_that_overlap_the_first_is_made(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text("b c d\n")
    at = Place("a.yaml", 1, 1)
    (made,), _ = repairs([having(Change(at, "b c", "x")), having(Change(at, "c d", "y"))], tmp_path, time.time_ns())
    assert (made.after, made.count) == (b"x d\n", 1)
