"""What the texts of launch files name, whatever conditions say."""

from __future__ import annotations

from pathlib import Path

from launch_builder import MANIFEST, composed

from rosarch.extractor.launch.facts import launch_rows
from rosarch.extractor.launch.model import ArgumentUsed, FileNamed, HomePath, PackageNamed, ProgramNamed


def test_files_of_branches_that_are_left_out(tmp_path: Path) -> None:
    composition = composed(
        tmp_path,
        '<rosparam file="$(find here)/old.yaml" if="false"/><rosparam file="$(find here)/there.yaml"/>'
        '<rosparam command="dump" file="$(find here)/written.yaml"/>'
        '<include file="$(dirname)/other.launch" unless="true"/><include file="$(find here)/$(arg x).launch" if="false"/>'
        '<param name="urdf" command="cat \'$(find here)/a b.urdf\' $(find here)/robot.urdf" if="false"/>'
        '<node pkg="here" type="n" name="n" args="--map $(find here)/map.yaml" if="false"/>',
        there_yaml="a: 1",
    )
    found = [(named.role, Path(named.file).name, named.absent) for named in composition.references if isinstance(named, FileNamed)]
    assert found == [
        ("rosparam", "old.yaml", True),
        ("rosparam", "there.yaml", False),
        ("include", "other.launch", True),
        ("command", "a", True),
        ("command", "robot.urdf", True),
        ("value", "map.yaml", True),
    ]


def test_a_path_is_one_with_its_spaces(tmp_path: Path) -> None:
    composition = composed(
        tmp_path,
        '<rosparam file=" $(find here)/way points.yaml"/><node pkg="here" type="n" name="n" args="-o /home/anna/$(arg log name)_1 -a"/>',
    )
    assert {Path(named.file).name for named in composition.references if isinstance(named, FileNamed)} == {"way points.yaml"}
    assert [named.path for named in composition.references if isinstance(named, HomePath)] == ["/home/anna/$(arg log name)_1"]


def test_a_template_stands_for_the_file_that_the_build_makes_of_it(tmp_path: Path) -> None:
    composition = composed(tmp_path, '<include file="$(find here)/made.launch" if="false"/>', made_launch_in="<launch/>")
    assert [named.absent for named in composition.references if isinstance(named, FileNamed)] == [False]


def test_files_that_commands_of_the_build_make(tmp_path: Path) -> None:
    (tmp_path / "here").mkdir()
    (tmp_path / "here" / "CMakeLists.txt").write_text(
        'project(here)\nconfigure_file(in/a.in ${PROJECT_SOURCE_DIR}/urdf/made.xacro @ONLY)\nfile(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/made.yaml "a: $(b)")\n'
        "xacro_add_files(robot.urdf.xacro INSTALL DESTINATION urdf)\nfile(COPY gone.yaml DESTINATION x)\n"
        "set(ARM ${CMAKE_CURRENT_BINARY_DIR}/urdf/arm.urdf)\nadd_custom_command(OUTPUT ${ARM} COMMAND xacro ${IN} -o ${ARM})\n"
        "foreach(side left right)\nadd_custom_command(OUTPUT ${out}/${side}_leg.urdf COMMAND xacro leg.xacro)\nendforeach()\n"
    )
    names = ("urdf/made.xacro", "made.yaml", "robot.urdf", "urdf/arm.urdf", "left_leg.urdf", "gone.yaml", "urdf/head.urdf")
    composition = composed(tmp_path, "".join(f'<rosparam command="load" file="$(find here)/{name}"/>' for name in names))
    assert [named.absent for named in composition.references if isinstance(named, FileNamed)] == [False] * 5 + [True] * 2
    assert [(problem.kind, problem.fatal) for problem in composition.problems] == [("made", False)] * 5 + [("file", True)] * 2


def test_programs_and_packages(tmp_path: Path) -> None:
    for name in ("elsewhere", "here"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(MANIFEST.format(name))
    (tmp_path / "here" / "CMakeLists.txt").write_text(
        "project(here)\nadd_executable(built a.cpp)  # was: renamed\nadd_executable(${PROJECT_NAME}_node b.cpp)"
    )
    composition = composed(
        tmp_path,
        '<group if="false"><node pkg="here" type="built" name="a"/><node pkg="here" type="renamed" name="b"/>'
        '<node pkg="here" type="run.py" name="c"/><node pkg="gone" type="x" name="d"/><node pkg="here" type="here_node" name="f"/><node pkg="here" type="$(arg t)" name="e"/></group>',
        run_py="",
    )
    programs = [(named.type, named.mentioned) for named in composition.references if isinstance(named, ProgramNamed)]
    assert programs == [("built", True), ("renamed", False), ("run.py", True), ("here_node", True)]
    packages = {(named.package, named.folder) for named in composition.references if isinstance(named, PackageNamed)}
    assert packages == {("here", str(tmp_path / "here")), ("gone", None)}


def test_arguments(tmp_path: Path) -> None:
    composition = composed(
        tmp_path, '<group if="false"><param name="a" value="$(arg b)$(arg c)"/><param name="d" value="$(eval arg(\'e\'))"/></group>'
    )
    assert [named.name for named in composition.references if isinstance(named, ArgumentUsed)] == ["b", "c", "e"]


def test_home_paths(tmp_path: Path) -> None:
    composition = composed(
        tmp_path,
        '<!-- /home/anna/old --><arg name="a" default="/home/anna/map.yaml" doc="/home/anna"/><param name="~/x" value="~/image"/>'
        '<param name="y" value="see file:/Users/bob/a b"/><param name="z" value="~/maps/a.yaml"/>'
        '<param name="w" value="$(env HOME)/x /somewhere/home/x/y /home/$(env USER)/z"/><machine name="m" address="h" env-loader="/home/r/env.sh"/>'
        '<arg name="c" default="$(optenv ROS_HOME ~/.ros)/map.yaml $(optenv MAPS /home/anna/maps)"/>',
    )
    found = [(named.element, named.attribute, named.path) for named in composition.references if isinstance(named, HomePath)]
    assert found == [
        ("arg", "default", "/home/anna/map.yaml"),
        ("param", "value", "/Users/bob/a"),
        ("param", "value", "~/maps/a.yaml"),
        ("machine", "env-loader", "/home/r/env.sh"),
    ]


def test_rows(tmp_path: Path) -> None:
    composition = composed(
        tmp_path,
        '<node pkg="here" type="n" name="n" args="$(find here)/no.yaml $(arg a) $(find gone)"/><arg name="b" default="/home/anna/x"/>',
    )
    rows = launch_rows(composition, tmp_path)
    at = "here/main.launch:2:1"
    assert rows["file_named"] == {(at, "value", "here/no.yaml")}
    assert rows["file_absent"] == {("here/no.yaml",)}
    assert rows["program_named"] == {(at, "here", "n")}
    assert "program_mentioned" not in rows
    assert rows["package_named"] == {(at, "here"), (at, "gone")}
    assert rows["package_found"] == {("here", "workspace")}
    assert rows["argument_used"] == {(at, "a")}
    assert {row[1:] for row in rows["home_path"]} == {("arg", "/home/anna/x")}


def test_an_include_that_passes_all(tmp_path: Path) -> None:
    composition = composed(
        tmp_path,
        '<include file="$(dirname)/a.launch" pass_all_args="true"/>\n<include file="$(dirname)/a.launch"/>',
        a_launch="<launch/>",
    )
    assert launch_rows(composition, tmp_path)["included_with_all"] == {("here/main.launch:2:1",)}
