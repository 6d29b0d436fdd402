"""Which of the programs and packages that launch files name the workspace has."""

from __future__ import annotations

from pathlib import Path

from rosarch.analysis.systems.manifests import declared
from rosarch.analysis.systems.workspace import (
    container_homes,
    dependencies,
    fetched,
    first_rows,
    named_by,
    programs_named,
    set_rows,
    shared_rows,
    source_rows,
    words_said,
    workspace_rows,
)
from rosarch.base.places import Place
from rosarch.extractor.launch import Files, PackagePath, compose
from rosarch.library import load
from rosarch.models.component import ComponentModel, Parameter

LAUNCH = """<launch><group if="false">
<node pkg="robot" type="built" name="a"/><node pkg="robot" type="gone" name="b"/>
<node pkg="driver" type="x" name="c"/><node pkg="move_base" type="move_base" name="d"/><node pkg="control" type="x" name="e"/>
<node pkg="off" type="x" name="f"/>
</group></launch>"""


def test_programs_and_packages(tmp_path: Path) -> None:
    folder = tmp_path / "robot"
    folder.mkdir()
    (folder / "package.xml").write_text(
        '<package><name>robot</name><exec_depend version_gte="1">driver</exec_depend><depend>move_base</depend><depend>off</depend></package>'
    )
    (tmp_path / "off").mkdir()
    (tmp_path / "off" / "package.xml").write_text("<package><name>off</name></package>")
    (tmp_path / "off" / "CATKIN_IGNORE").touch()
    (folder / "a.launch").write_text(LAUNCH)
    composition = compose([folder / "a.launch"], files=Files(PackagePath([tmp_path])))
    assert programs_named([composition]) == {("robot", "built"), ("robot", "gone")}
    rows = workspace_rows(dependencies(declared(tmp_path)), [composition], {("robot", "built"), ("robot", "other")}, load().packages)
    assert rows["program_built"] == {("robot", "built"), ("robot", "other")}
    assert rows["package_expected"] == {("driver",), ("move_base",), ("off",)}
    assert rows["package_unknown"] == {("driver",)}


def test_home_folders_of_containers(tmp_path: Path) -> None:
    (tmp_path / "docker").mkdir()
    (tmp_path / "docker/Dockerfile.ros1").write_text("FROM ros\nWORKDIR /home/rosuser/ws\nCOPY a /opt/home/b\n")
    (tmp_path / "compose.yaml").write_text("services:\n  robot:\n    volumes: ['./src:/home/dev/src']\n")
    (tmp_path / "README.md").write_text("cd /home/anna\n")
    assert container_homes(tmp_path) == {"/home/rosuser", "/home/dev"}
    assert workspace_rows(dependencies(()), [], (), (), (), {"/home/dev"})["container_home"] == {("/home/dev",)}


def test_what_lists_of_repositories_bring(tmp_path: Path) -> None:
    (tmp_path / "src" / "deep" / "deeper").mkdir(parents=True)
    (tmp_path / ".gitmodules").write_text('[submodule "lib/driver"]\n\tpath = lib/driver\n\turl = https://example.org/driver.git\n')
    listed = "repositories:\n  nav/costs:\n    type: git\n    url: https://example.org/x\n  'camera':\n    type: git\n"
    (tmp_path / "src" / "all.repos").write_text(listed)
    (tmp_path / "src" / "deep" / ".rosinstall").write_text("- git:\n    local-name: arm\n    uri: x\n- git: {local-name: hand, uri: x}\n")
    (tmp_path / "src" / "deep" / "deeper" / "more.repos").write_text("repositories:\n  far:\n    type: git\n")
    assert fetched(tmp_path) == {"driver", "costs", "camera", "arm", "hand"}
    (tmp_path / "a.launch").write_text('<launch><node pkg="camera" type="x" name="x"/><node pkg="gone" type="x" name="y"/></launch>')
    composition = compose([tmp_path / "a.launch"], files=Files(PackagePath([tmp_path])))
    rows = workspace_rows(dependencies(()), [composition], set(), ("arm",), fetched(tmp_path))
    assert rows["package_expected"] == {("camera",)}
    # a repository may be called after its package
    assert workspace_rows(dependencies(()), [composition], set(), (), {"team_camera-ros2", "cameras"})["package_expected"] == {("camera",)}
    assert rows["package_unknown"] == {("driver",), ("costs",), ("camera",), ("hand",)}  # each may have packages of other names, too


def test_the_first_file_that_names_a_package_that_is_not_there(tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot" / "package.xml").write_text("<package><name>robot</name></package>")
    for name, package in (("b", "gone"), ("a", "gone"), ("c", "other"), ("d", "robot")):
        (tmp_path / "robot" / f"{name}.launch").write_text(f'<launch><node pkg="{package}" type="x" name="x"/></launch>')
    compositions = [compose([tmp_path / "robot" / f"{name}.launch"], files=Files(PackagePath([tmp_path]))) for name in "bacd"]
    first = first_rows(compositions, tmp_path)
    assert first["package_first_named"] == {("gone", "robot/a.launch"), ("other", "robot/c.launch")}
    assert first["package_absent_somewhere"] == {("gone",), ("other",)}
    named = {("gone", "robot/a.launch"), ("gone", "robot/b.launch"), ("other", "robot/c.launch"), ("robot", "robot/d.launch")}
    assert first["package_named_somewhere"] == named
    assert named_by(compositions[0], first)["package_first_named"] == {("gone", "robot/a.launch")}


def test_words_of_sources(tmp_path: Path) -> None:
    source = tmp_path / "robot" / "src" / "a.cpp"
    source.parent.mkdir(parents=True)
    (tmp_path / "robot" / "package.xml").write_text("<package><name>robot</name></package>")
    source.write_text('nh.param("gains/speed", x); // "old"\n/* "older"\n */ "a\\"b//" rate')
    (tmp_path / "robot" / "a.launch").write_text(
        "<launch>" + "".join(f'<param name="{name}" value="1"/>' for name in ("a/speed", "old", "older", "rate", "speed/x")) + "</launch>"
    )
    composition = compose([tmp_path / "robot" / "a.launch"], files=Files(PackagePath([tmp_path])))
    model = ComponentModel("robot", "driver", "robot", "node", None, ("robot/src/a.cpp",), (), ())
    said = words_said(tmp_path, [model])
    assert source_rows(composition, ["robot/driver", "other/driver"], said) == {"source_says": {("robot/driver", "speed")}}
    assert source_rows(composition, ["other/driver"], said) == {"source_says": set()}
    (tmp_path / "robot" / "script").write_text('#!/usr/bin/env python3\nread("new")')
    scripted = ComponentModel("robot", "script", "robot", "node", None, ("robot/script",), (), ())
    assert words_said(tmp_path, [scripted])["robot/script"] - said["robot/driver"] == {"new"}


def test_parameters_of_absolute_names(tmp_path: Path) -> None:
    (tmp_path / "a.launch").write_text(
        "<launch>" + "".join(f'<param name="{name}" value="1"/>' for name in ("base/rate", "base/gains/p/x", "unread")) + "</launch>"
    )
    composition = compose([tmp_path / "a.launch"], files=Files(PackagePath([tmp_path])))
    accesses = [("/base/rate", "read"), ("/base/gains", "read"), ("/base/mass", "read"), ("/unread", "write"), ("~rate", "read")]
    parameters = tuple(Parameter(name, op, None, None, Place("a.cpp", 1, 1)) for name, op in accesses)
    model = ComponentModel("robot", "driver", "robot", "node", None, ("a.cpp",), (), parameters)
    assert shared_rows([model]) == {
        "read_absolutely": {(name, "robot/driver") for name in ("/base/rate", "/base/gains", "/base/mass")},
        "port_anywhere": set(),
    }
    assert set_rows([composition], [model]) == {"set_somewhere": {("/base/rate",), ("/base/gains",)}}
