from __future__ import annotations

from pathlib import Path

import pytest
from launch_builder import MANIFEST, composed, params, problems

ROBOT = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="prefix" default="none"/>
<link name="$(arg prefix)_link"/>
<gazebo>
  <plugin name="p" filename="libp.so"><topic>$(arg prefix)/scan</topic></plugin>
</gazebo>
</robot>"""
OLD = '<robot xmlns:xacro="x"><a_link/><macro name="a_link"><link name="old"/></macro></robot>'
XACRO = {"xacro": "", "xacro_py": ""}


@pytest.mark.parametrize(
    "command",
    [
        "xacro $(find here)/robot.urdf prefix:=a",
        "xacro --inorder '$(find here)/robot.urdf' prefix:=a",
        "$(find here)/xacro $(find here)/robot.urdf prefix:=a -q",
        "$(find here)/xacro.py prefix:='a' $(find here)/robot.urdf",
        "rosrun xacro xacro --verbosity 0 $(find here)/robot.urdf prefix:=a",
        "xacro $(find here)/robot.urdf prefix:=$(arg prefix)",
    ],
)
def test_a_robot_description_is_what_xacro_prints(tmp_path: Path, command: str) -> None:
    found = composed(
        tmp_path, f'<arg name="prefix" default="a"/><param name="robot_description" command="{command}"/>', robot_urdf=ROBOT, **XACRO
    )
    (setting,) = found.params
    assert problems(found, tmp_path) == []
    assert setting.value.startswith('<?xml version="1.0" ?>\n<!-- ====')
    assert '\n  <link name="a_link"/>\n' in setting.value
    assert [(plugin.filename, plugin.elements, plugin.place.line) for plugin in setting.plugins] == [("libp.so", (("topic", "a/scan"),), 5)]


@pytest.mark.parametrize("command", ["xacro", "xacro --inorder", "$(find here)/xacro.py"])
def test_a_file_for_an_older_xacro(tmp_path: Path, command: str) -> None:
    document = OLD if command != "xacro --inorder" else OLD.replace("<a_link/>", "").replace("</robot>", "<a_link/></robot>")
    found = composed(tmp_path, f'<param name="d" command="{command} $(find here)/old.urdf"/>', old_urdf=document, **XACRO)
    assert '<link name="old"/>' in str(params(found)["/d"])


def test_a_refusal_of_xacro_leaves_the_parameter_unknown_and_the_rest_goes_on(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        '<param name="d" command="xacro $(find here)/bad.urdf"/>\n<param name="e" value="1"/>',
        bad_urdf='<robot>\n  <link name="${x}"/></robot>',
    )
    assert problems(found, tmp_path) == ["bad.urdf:2:3: ${x}: name 'x' is not defined"]
    assert params(found) == {"/d": f"$(command xacro {tmp_path}/here/bad.urdf)", "/e": 1}
    assert found.refusal is not None
    assert found.refusal.kind == "command"


def test_what_is_unknown_stays_so_in_the_description(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        '<param name="d" command="xacro $(find here)/robot.urdf prefix:=$(env NAME)"/>',
        robot_urdf=ROBOT.replace("</robot>", '<mesh file="$(find meshes)/a.stl"/></robot>'),
    )
    (setting,) = found.params
    assert '<link name="$(env NAME)_link"/>' in setting.value
    assert '<mesh file="$(find meshes)/a.stl"/>' in setting.value
    assert [plugin.elements for plugin in setting.plugins] == [(("topic", "$(env NAME)/scan"),)]
    assert problems(found, tmp_path) == [
        "main.launch:2:1: environment variable `NAME` is not set",
        "robot.urdf:7:1: package `meshes` is not on the package path",
    ]


@pytest.mark.parametrize(
    ("command", "message"),
    [
        ("xacro none.urdf", "command `xacro` would fail: no such file: none.urdf"),
        ("./xacro none.urdf", "command `./xacro` would fail: no such file: ./xacro"),
        ("xacro -o out.urdf robot.urdf", "command `xacro` is not run, what it prints is unknown"),
        ("xacro --deps robot.urdf", "command `xacro` is not run, what it prints is unknown"),
        ("xacro", "command `xacro` is not run, what it prints is unknown"),
    ],
)
def test_commands_that_print_no_description(tmp_path: Path, command: str, message: str) -> None:
    found = composed(tmp_path, f'<param name="d" command="{command}"/>')
    assert problems(found, tmp_path) == [f"main.launch:2:1: {message}"]
    assert params(found) == {"/d": f"$(command {command})"}


@pytest.mark.parametrize("source", ['command="cat $(find here)/plain.urdf"', 'textfile="$(find here)/plain.urdf"'])
def test_plugins_of_a_description_that_is_a_file(tmp_path: Path, source: str) -> None:
    text = '<robot>\n<gazebo reference="l"><plugin name="n" filename="f.so"/></gazebo></robot>'
    found = composed(tmp_path, f'<node pkg="p" type="t" name="n"><param name="d" {source}/></node>', plain_urdf=text)
    (setting,) = found.params
    assert (setting.name, setting.value) == ("/n/d", text)
    assert [(plugin.filename, plugin.reference, plugin.place.line, plugin.place.column) for plugin in setting.plugins] == [
        ("f.so", "l", 2, 23)
    ]


def test_a_description_that_is_broken_is_told(tmp_path: Path) -> None:
    found = composed(tmp_path, '<param name="d" textfile="$(find here)/plain.urdf"/>', plain_urdf="<robot>\n<plugin></robot>")
    assert problems(found, tmp_path) == ["plain.urdf:2:11: broken XML: mismatched tag"]
    assert found.refusal is None
    assert params(found) == {"/d": "<robot>\n<plugin></robot>"}


def test_worlds_that_nodes_and_included_files_are_given(tmp_path: Path) -> None:
    world = '<sdf><world><plugin name="{0}" filename="lib{0}.so"/></world></sdf>'
    found = composed(
        tmp_path,
        '<node pkg="p" type="t" name="n" args="-e ode $(find here)/a.world none.world"/>\n'
        '<include file="$(find gone)/empty.launch"><arg name="world_name" value="$(find here)/b.sdf"/></include>',
        a_world=world.format("a"),
        b_sdf=world.format("b"),
    )
    assert [(Path(w.file).name, w.lines[-1].line, [plugin.filename for plugin in w.plugins]) for w in found.worlds] == [
        ("a.world", 2, ["liba.so"]),
        ("b.sdf", 3, ["libb.so"]),
    ]


def test_an_absent_package_in_a_description_is_an_absent_package(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        '<param name="d" command="xacro $(find here)/robot.urdf"/>',
        robot_urdf='<robot xmlns:xacro="http://ros.org/wiki/xacro">\n  <xacro:include filename="$(find gone)/arm.xacro"/></robot>',
    )
    assert [(problem.kind, problem.subject) for problem in found.problems] == [("package", "gone")]


def test_models_that_worlds_include(tmp_path: Path) -> None:
    include = "<include><uri>{}</uri></include>".format
    plugin = "<plugin name='p' filename='lib{}.so'/>".format
    here, other = tmp_path / "here", tmp_path / "other"
    models = {
        here / "models/cart": f"<sdf><model name='cart'>{plugin('cart')}{include('model://laser')}{include('model://cart')}</model></sdf>",
        here / "models/laser": f"<sdf><model name='laser'><link name='l'>{plugin('laser')}</link></model></sdf>",
        other / "models/laser": f"<sdf><model name='laser'>{plugin('elsewhere')}</model></sdf>",
        other / "models/lamp": f"<sdf><model name='lamp'>{plugin('lamp')}</model></sdf>",
        other / "models/broken": "<sdf>",
    }
    for folder, text in models.items():
        folder.mkdir(parents=True)
        (folder / "model.sdf").write_text(text)
    (other / "package.xml").write_text(MANIFEST.format("other"))
    uris = ["model://sun", "model://cart", "package://other/models/lamp", "model://lamp/model.sdf", "model://broken"]
    world = f"<sdf><world name='w'>{''.join(map(include, uris))}<!-- {include('model://none')} --></world></sdf>"
    found = composed(tmp_path, '<node name="sim" pkg="gazebo_ros" type="gzserver" args="$(find here)/w.world"/>', w_world=world)
    assert [plugin.filename for one in found.worlds for plugin in one.plugins] == ["libcart.so", "liblaser.so", "liblamp.so"]
