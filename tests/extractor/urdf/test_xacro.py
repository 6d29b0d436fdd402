from __future__ import annotations

from pathlib import Path

import pytest
from xacro_builder import HEAD, expanded, inner, problems

from rosarch.extractor.launch import Files, PackagePath
from rosarch.extractor.launch.unknowns import Unknowns
from rosarch.extractor.urdf import IN_ORDER, TRADITIONAL, expand, write

P, M = "xacro:property", "xacro:macro"


@pytest.mark.parametrize(
    ("content", "result"),
    [
        # texts and expressions
        (f'<{P} name="a" value="2"/><l x="${{a + 1}} ${{a / 4}}">${{a}}m</l>', '<l x="3 0.5">2m</l>'),
        ('<l a="$${x} $$(y) $x $" b="${\'a\' + \'b\'}"/>', '<l a="${x} $(y) $x $" b="ab"/>'),
        ('<l a="${pi} ${math.floor(2.5)} ${round(2.567, 1)} ${max(1, 2)} ${len([1, 2])}"/>', '<l a="3.141592653589793 2 2.6 2 2"/>'),
        ('<l a="${[2 * i for i in range(3)]} ${dict(a=1)[\'a\']} ${\'A b\'.lower().split()[1]}"/>', '<l a="[0, 2, 4] 1 b"/>'),
        ('<l a="${python.abs(-1)} ${xacro.tokenize(\'a;b c\')[2]} ${xacro.message(\'hi\')}"/>', '<l a="1 c "/>'),
        (f'<{P} name="pi" value="3"/><l a="${{pi}}"/>', '<l a="3"/>'),
        # properties
        (f'<{P} name="a" value="${{b}}"/><{P} name="b" value="1"/><l a="${{a}}"/>', '<l a="1"/>'),
        (f'<{P} name="b" value="1"/><{P} name="a" value="${{b}}" lazy_eval="false"/><{P} name="b" value="2"/><l a="${{a}}"/>', '<l a="1"/>'),
        (f'<{P} name="a" default="1"/><{P} name="a" default="2"/><l a="${{a}}"/>', '<l a="1"/>'),
        (f'<{P} name="a" value="1"/><{P} name="a" remove="true"/><{P} name="a" default="2"/><l a="${{a}}"/>', '<l a="2"/>'),
        (f'<{P} name="a" value="\'x\'"/><{P} name="b" value="1_0"/><{P} name="c" value="true"/><l a="${{a + b}} ${{c}}"/>', '<l a="x1_0 True"/>'),
        (f'<{P} name="b"><x/><y>${{1}}</y></{P}><xacro:insert_block name="b"/><xacro:insert_block name="b"/>', "<x/><y>1</y><x/><y>1</y>"),
        (f'<{P} name="${{\'a\' + \'b\'}}" value="1"/><l a="${{ab}}"/>', '<l a="1"/>'),
        # conditions
        ('<xacro:if value="true"><a/></xacro:if><xacro:unless value="${1 == 1}"><b/></xacro:unless>', "<a/>"),
        ('<xacro:if value="0"><a/></xacro:if><xacro:unless value="0"><b/></xacro:unless>', "<b/>"),
        # macros
        (f'<{M} name="m" params="a b:=2 c:=\'x y\' d:=${{1 + 1}}"><l v="${{a}} ${{b}} ${{c}} ${{d}}"/></{M}><xacro:m a="1"/>', '<l v="1 2 x y 2"/>'),
        (f'<{P} name="a" value="1"/><{M} name="m" params="a:=^ b:=^|7"><l v="${{a}} ${{b}}"/></{M}><xacro:m/>', '<l v="1 7"/>'),
        (f'<{M} name="m" params="*o **p"><xacro:insert_block name="o"/><xacro:insert_block name="p"/></{M}><xacro:m><x a="${{1}}"/><y><z/></y></xacro:m>', '<x a="1"/><z/>'),
        (f'<{M} name="m" params="n"><l n="${{n}}"/><xacro:if value="${{n > 1}}"><xacro:m n="${{n - 1}}"/></xacro:if></{M}><xacro:m n="3"/>', '<l n="3"/><l n="2"/><l n="1"/>'),
        # lists, which calls change where they are
        (f'<{P} name="all" value="${{[5, 6]}}"/><{M} name="m" params="i:=^*"><xacro:if value="${{i}}"><{P} name="o" value="${{i.pop(0)}}"/><l o="${{o}} ${{len(i)}}"/><xacro:m i="${{i}}"/></xacro:if></{M}><xacro:m i="${{all}}"/><l n="${{all}}"/>', '<l o="5 1"/><l o="6 0"/><l n="[]"/>'),
        (f'<{P} name="a" value="${{[1]}}"/><l v="${{a.append(2)}} ${{a.insert(0, 3)}} ${{a.reverse()}} ${{a}}"/>', '<l v="None None None [2, 1, 3]"/>'),
        (f'<{M} name="m" params="v"><l v="${{v}}"/></{M}><xacro:call macro="${{\'m\'}}" v="1"/>', '<l v="1"/>'),
        (f'<{M} name="m"><{P} name="a" value="1" scope="parent"/><{P} name="b" value="2" scope="global"/><{P} name="c" value="3"/></{M}><xacro:m/><{P} name="c" default="4"/><l v="${{a}} ${{b}} ${{c}}"/>', '<l v="1 2 4"/>'),
        (f'<{M} name="m"><{M} name="n"><x/></{M}><xacro:n/></{M}><xacro:m/>', "<x/>"),
        # elements and attributes by name, arguments
        ('<xacro:element xacro:name="${\'a\'}" b="1"><xacro:attribute name="c" value="${2}"/></xacro:element>', '<a b="1" c="2"/>'),
        ('<xacro:arg name="a" default="1"/><xacro:arg name="b" default="2"/><l v="$(arg a) $(arg b) ${xacro.arg(\'a\')}"/>', '<l v="5 2 5"/>'),
        ('<l v="$(env SET) $(optenv UNSET a b) $(eval 1 + 2)"/>', '<l v="1 a b 3"/>'),
        # comments: those before an element of xacro go, others stay, and are evaluated when asked to
        (f'<!-- gone --><{P} name="a" value="1"/><!-- kept ${{a}} --><l/>', "<!-- kept ${a} --><l/>"),
        (f'<{P} name="a" value="1"/><l/><!-- xacro:eval-comments --><!-- ${{a}} --><l/><!-- ${{a}} -->', "<l/><!-- 1 --><l/><!-- ${a} -->"),
        ("<l><![CDATA[${x} <]]></l>", "<l><![CDATA[${x} <]]></l>"),
        ('<l a="&lt;&amp;&quot;">&gt;</l>', '<l a="&lt;&amp;&quot;">&gt;</l>'),
    ],
)  # fmt: skip
def test_evaluation(tmp_path: Path, content: str, result: str) -> None:
    assert inner(tmp_path, content, arguments={"a": "5"}, environment={"SET": "1"}) == result


def test_lists_of_yaml_are_new_ones_each_time(tmp_path: Path) -> None:
    content = f"""<{P} name="all" value="${{xacro.load_yaml('c.yaml')}}"/><l v="${{all.entries.pop(0)}} ${{len(all.entries)}}"/>"""
    assert inner(tmp_path, content, c_yaml="entries: [5, 6]") == '<l v="5 2"/>'


def test_includes_are_relative_to_the_file_and_may_have_a_namespace(tmp_path: Path) -> None:
    content = (
        '<xacro:include filename="part.xacro" ns="p"/><xacro:include filename="$(find here)/more*.xacro"/><xacro:p.m/><l v="${p.a} ${b}"/>'
    )
    part = 'ROBOT<xacro:property name="a" value="1"/><xacro:macro name="m"><x a="${a}"/></xacro:macro><y/></robot>'
    more = 'ROBOT<xacro:property name="b" value="2"/></robot>'
    assert inner(tmp_path, content, part_xacro=part, more1_xacro=more) == '<y/><x a="1"/><l v="1 2"/>'


def test_an_optional_include_may_be_absent(tmp_path: Path) -> None:
    assert inner(tmp_path, '<xacro:include filename="none.xacro" optional="true"/><l/>') == "<l/>"
    assert inner(tmp_path, '<xacro:include filename="none.xacro"/><l/>') == "robot.xacro:1:52: no such file: none.xacro"


def test_yaml_with_units(tmp_path: Path) -> None:
    content = '<xacro:property name="y" value="${xacro.load_yaml(\'a.yaml\')}"/><l v="${y.arms[0].length} ${y[\'angle\']} ${y.arms[1]}"/>'
    assert inner(tmp_path, content, a_yaml="arms: [{length: !inches 2}, x]\nangle: !degrees 180\n") == '<l v="0.0508 3.141592653589793 x"/>'


def test_namespaces_of_included_files_are_declared(tmp_path: Path) -> None:
    part = '<robot xmlns:sensor="http://s" xmlns:xacro="x"><sensor:camera/></robot>'
    expansion = expanded(tmp_path, '<xacro:include filename="part.xacro"/>', part_xacro=part)
    assert expansion.document is not None
    assert expansion.document.root.attributes == {"xmlns:sensor": "http://s"}


def test_elements_keep_the_place_they_are_written_at(tmp_path: Path) -> None:
    part = "ROBOT\n<xacro:macro name='m'>\n  <l/></xacro:macro></robot>"
    expansion = expanded(tmp_path, '<xacro:include filename="part.xacro"/><xacro:m/>', part_xacro=part)
    assert expansion.document is not None
    places = [element.place for element in expansion.document.root.elements()]
    assert [(Path(place.path).name, place.line, place.column) for place in places] == [("part.xacro", 3, 3)]
    assert [Path(file).name for file in expansion.files] == ["robot.xacro", "part.xacro"]


def test_the_text_is_laid_out_as_xacro_does(tmp_path: Path) -> None:
    expansion = expanded(tmp_path, '\n<link name="l">\n <visual/> text</link><!-- c -->\n')
    assert expansion.document is not None
    assert write(expansion.document, "a.xacro").splitlines() == [
        '<?xml version="1.0" ?>',
        f"<!-- {'=' * 83} -->",
        "<!-- |    This document was autogenerated by xacro from a.xacro                        | -->",
        "<!-- |    EDITING THIS FILE BY HAND IS NOT RECOMMENDED                                 | -->",
        f"<!-- {'=' * 83} -->",
        "<robot>",
        '  <link name="l">',
        "    <visual/>",
        "     text",
        "  </link>",
        "  <!-- c -->",
        "</robot>",
        "",
    ]


OLD = '<m a="1"/><macro name="m" params="a"><l v="${a} ${b}"/></macro><property name="b" value="true"/><if value="0.0"><x/></if>'


def test_the_old_order_collects_definitions_first_and_needs_no_prefix(tmp_path: Path) -> None:
    assert inner(tmp_path, OLD, dialect=TRADITIONAL) == '<l v="1 true"/>'
    assert inner(tmp_path, OLD, dialect=IN_ORDER).startswith('<m a="1"/>')
    assert (
        inner(tmp_path, '<include filename="p.xacro"/><m/>', dialect=TRADITIONAL, p_xacro="ROBOT<macro name='m'><l/></macro></robot>")
        == "<l/>"
    )
    assert (
        inner(tmp_path, '<include filename="p"><uri>u</uri></include>', dialect=TRADITIONAL)
        == '<include filename="p"><uri>u</uri></include>'
    )


def test_tags_of_an_older_xacro_are_told(tmp_path: Path) -> None:
    assert expanded(tmp_path, "<property name='a' value='1'/>").bare_tags
    assert expanded(tmp_path, "<xacro:macro name='m'/><m/>").bare_tags
    assert not expanded(tmp_path, "<include><uri>u</uri></include><m/>").bare_tags


def test_what_depends_on_something_absent_stays_unknown(tmp_path: Path) -> None:
    content = (
        '<mesh f="$(find gone)/a.stl"/>\n<xacro:property name="size" value="$(env UNSET)"/>\n<m s="${size}" t="${2 * size}"/>\n'
        '<xacro:if value="${size == 1}"><maybe/></xacro:if>'
    )
    result = '<mesh f="$(find gone)/a.stl"/><m s="$(env UNSET)" t="${2 * size}"/><maybe/>'
    assert inner(tmp_path, content) == result
    assert problems(expanded(tmp_path, content), tmp_path) == [
        "robot.xacro:1:52: package `gone` is not on the package path",
        "robot.xacro:3:1: environment variable `UNSET` is not set",
    ]


def test_without_a_file_what_it_defines_is_unknown_and_the_rest_is_evaluated(tmp_path: Path) -> None:
    content = '<xacro:include filename="$(find gone)/a.xacro"/><xacro:gone_macro a="1"/><l v="${gone_property}"/>'
    assert inner(tmp_path, content) == '<l v="${gone_property}"/>'
    assert problems(expanded(tmp_path, content), tmp_path) == ["robot.xacro:1:52: package `gone` is not on the package path"]


def test_a_file_that_is_made_is_unknown(tmp_path: Path) -> None:
    content = '<xacro:property name="size" value="${xacro.load_yaml(\'made.yaml\')[\'size\']}"/><xacro:include filename="made.xacro"/><l v="${size}"/>'
    (tmp_path / "here").mkdir()
    (tmp_path / "here/made.yaml.in").touch()
    (tmp_path / "here/made.xacro.in").touch()
    assert inner(tmp_path, content) == """<l v="${xacro.load_yaml('made.yaml')['size']}"/>"""


def test_a_macro_that_calls_itself_under_an_unknown_condition_ends(tmp_path: Path) -> None:
    content = (
        '<xacro:macro name="chain" params="n"><l v="${n}"/><xacro:if value="${n &lt; gone}"><xacro:chain n="${n + 1}"/></xacro:if></xacro:macro>'
        '<xacro:property name="gone" value="$(env UNSET)"/><xacro:chain n="1"/><xacro:chain n="5"/>'
    )
    assert inner(tmp_path, content) == '<l v="1"/><l v="5"/>'


def test_unknown_arguments_flow_through(tmp_path: Path) -> None:
    unknowns = Unknowns()
    mark = unknowns.mark("$(env ROBOT)")
    expansion = expanded(tmp_path, '<l name="$(arg prefix)_link"/>', {"prefix": mark}, unknowns=unknowns)
    assert expansion.document is not None
    assert unknowns.render(next(expansion.document.root.elements()).attributes["name"]) == "$(env ROBOT)_link"


@pytest.mark.parametrize("installed", [True, False])
def test_files_of_packages_that_are_installed_come_from_elsewhere_in_their_sources(tmp_path: Path, installed: bool) -> None:
    package = tmp_path / "here"
    (package / "bringup" / "config").mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>here</name></package>")
    (package / "bringup" / "config" / "a.yaml").write_text("ticks: 3")
    (package / "bringup" / "part.xacro").write_text(f"{HEAD}<part/></robot>")
    texts = "<xacro:include filename='$(find here)/urdf/part.xacro'/><l v=\"${xacro.load_yaml('$(find here)/config/a.yaml')['ticks']}\"/>"
    (package / "robot.xacro").write_text(f"{HEAD}{texts}</robot>")
    expansion = expand(f"{package}/robot.xacro", files=Files(PackagePath([tmp_path])), installed=installed)
    assert [problem.kind for problem in expansion.problems] == ([] if installed else ["xacro"])
    assert [path for path, _ in expansion.meant] == ([f"{package}/urdf/part.xacro"] if installed else [])
    assert expansion.document is None or "".join(write(expansion.document, "robot.xacro").split()).endswith('<part/><lv="3"/></robot>')
