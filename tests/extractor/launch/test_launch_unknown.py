"""What cannot be known stays in the texts, conditions on it give both alternatives, and the rest goes on."""

from __future__ import annotations

from pathlib import Path

import pytest
from launch_builder import composed, params, problems

from rosarch.extractor.launch import record


def conditions(thing: object) -> list[str]:
    return [str(condition) for condition in thing.conditions]  # type: ignore[attr-defined]


def test_unset_environment_variable(tmp_path: Path) -> None:
    found = composed(tmp_path, '<node pkg="$(env WHO)_driver" type="t" name="n" ns="$(env WHO)"/><param name="p" value="$(env WHO)/x"/>')
    assert [(node.package, node.full_name) for node in found.nodes] == [("$(env WHO)_driver", "/$(env WHO)/n")]
    assert params(found) == {"/p": "$(env WHO)/x"}
    assert problems(found, tmp_path) == [
        "main.launch:2:1: environment variable `WHO` is not set",
        "main.launch:2:66: environment variable `WHO` is not set",
    ]


def test_missing_package(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        '<include file="$(find gone)/launch/a.launch"/>\n<rosparam file="$(find gone)/p.yaml" ns="n"/>\n<param name="x" command="$(find xacro)/xacro a b"/>\n<node pkg="p" type="t" name="n"/>',
    )
    assert [node.full_name for node in found.nodes] == ["/n"]
    assert [(include.text, include.file) for include in found.includes] == [("$(find gone)/launch/a.launch", None)]
    assert [(setting.name, setting.source) for setting in found.unread] == [("/n", "$(find gone)/p.yaml")]
    assert params(found) == {"/x": "$(command $(find xacro)/xacro a b)"}
    assert problems(found, tmp_path) == [
        "main.launch:2:1: package `gone` is not on the package path",
        "main.launch:3:1: package `gone` is not on the package path",
        "main.launch:4:1: package `xacro` is not on the package path",
    ]
    assert [entry for entry in record(found)["not_read"]] == [
        {"include": "$(find gone)/launch/a.launch", "lines": [f"{tmp_path}/here/main.launch:2"]},
        {"rosparam": "$(find gone)/p.yaml", "namespace": "/n", "lines": [f"{tmp_path}/here/main.launch:3"]},
    ]


def test_condition_on_missing_argument_gives_both(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        """<arg name="sim"/>
        <node pkg="p" type="fake" name="driver" if="$(arg sim)"/>
        <node pkg="p" type="real" name="driver" unless="$(arg sim)"/>
        <node pkg="p" type="t" name="always"/>""",
    )
    assert [(node.type, conditions(node)) for node in found.nodes] == [
        ("fake", ["if $(arg sim)"]),
        ("real", ["unless $(arg sim)"]),
        ("t", []),
    ]
    assert problems(found, tmp_path) == ["main.launch:3:9: argument `sim` must be passed, it has no value"]
    assert [entry.get("conditions") for entry in record(found)["started_by"]] == [["if $(arg sim)"], ["unless $(arg sim)"], None]


def test_same_names_are_refused_unless_conditions_exclude(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        '<arg name="a"/><arg name="b"/>\n<node pkg="p" type="t" name="n" if="$(arg a)"/>\n<node pkg="p" type="t" name="n" if="$(arg b)"/>',
    )
    assert [problem.kind for problem in found.problems] == ["arg", "arg", "duplicate-node"]
    assert found.problems[-1].message == f"a second node `/n`, the first is at {tmp_path}/here/main.launch:3"


@pytest.mark.parametrize(
    ("one", "other", "named"),
    [
        ("if=\"$(eval a == 'x')\"", "if=\"$(eval a == 'y')\"", ["arg"]),
        ("if=\"$(eval a == 'x')\"", "if=\"$(eval a in ['y', 'z'])\"", ["arg"]),
        ("if=\"$(eval a in ['x', 'y'])\"", "if=\"$(eval a in ['y', 'z'])\"", ["arg", "duplicate-node"]),
        ('if="$(eval a and not b)"', 'if="$(arg b)"', ["arg", "arg"]),
        ('if="$(eval a or b)"', 'if="$(arg b)"', ["arg", "arg", "duplicate-node"]),
        ("unless=\"$(eval a == 'x')\"", "if=\"$(eval arg('a') == 'x')\"", ["arg"]),
        ("if=\"$(eval a.startswith('x'))\"", "if=\"$(eval a.startswith('y'))\"", ["arg"]),  # perhaps
        ("", 'if="$(arg a)"', ["arg", "duplicate-node"]),
    ],
)
def test_alternatives(tmp_path: Path, one: str, other: str, named: list[str]) -> None:
    nodes = "\n".join(f'<group {condition}><node pkg="p" type="t" name="n"/></group>' for condition in (one, other))
    assert [problem.kind for problem in composed(tmp_path, f'<arg name="a"/><arg name="b"/>{nodes}').problems] == named


def test_nested_conditions_are_decided_once(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        """<arg name="a"/><arg name="b"/>
        <group if="$(arg a)">
          <node pkg="p" type="t" name="one" if="$(arg a)"/>
          <node pkg="p" type="t" name="never" unless="$(arg a)"/>
          <group unless="$(eval b == 'x')"><node pkg="p" type="t" name="two"/></group>
        </group>""",
    )
    assert [(node.name, conditions(node)) for node in found.nodes] == [
        ("one", ["if $(arg a)"]),
        ("two", ["if $(arg a)", "unless $(eval b == 'x')"]),
    ]


def test_alternatives_of_a_parameter(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        """<arg name="a"/>
        <param name="p" value="0"/>
        <param name="p" value="1" if="$(arg a)"/>
        <param name="p" value="2" unless="$(arg a)"/>
        <param name="q" value="1" if="$(arg a)"/><param name="q" value="3"/>""",
    )
    assert [(setting.name, setting.value, conditions(setting)) for setting in found.params] == [
        ("/p", 0, []),
        ("/p", 1, ["if $(arg a)"]),
        ("/p", 2, ["unless $(arg a)"]),
        ("/q", 3, []),
    ]
    assert [(entry["value"], entry["conditions"]) for entry in record(found)["alternatives"]] == [
        (0, []),
        (1, ["if $(arg a)"]),
        (2, ["unless $(arg a)"]),
    ]


def test_argument_set_in_one_alternative_only(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        """<arg name="a"/>
        <arg name="b" value="1" if="$(arg a)"/>
        <arg name="b" value="2" unless="$(arg a)"/>
        <param name="p" value="$(arg b)"/>
        <param name="q" value="1" if="$(eval b == 1)"/>""",
    )
    assert [(setting.name, setting.value, conditions(setting)) for setting in found.params] == [
        ("/p", "$(arg b)", []),
        ("/q", 1, ["if $(eval b == 1)"]),
    ]
    assert [problem.kind for problem in found.problems] == ["arg"]


def test_conditional_remaps_keep_the_one_before(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        """<arg name="a"/><remap from="x" to="y"/><remap from="x" to="z" if="$(arg a)"/>
        <node pkg="p" type="t" name="n"/>
        <node pkg="p" type="t" name="m"><remap from="x" to="w"/></node>""",
    )
    assert [[(remap.target, conditions(remap)) for remap in node.remaps] for node in found.nodes] == [
        [("y", []), ("z", ["if $(arg a)"])],
        [("w", [])],
    ]


def test_conditional_include_marks_what_it_starts(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        '<arg name="a"/><include if="$(arg a)" file="$(find here)/other.launch"/>',
        other_launch='<launch><node pkg="p" type="t" name="n"><param name="p" value="1"/></node></launch>',
    )
    assert conditions(found.nodes[0]) == ["if $(arg a)"]
    assert conditions(found.params[0]) == ["if $(arg a)"]
    assert conditions(found.includes[0]) == ["if $(arg a)"]


def test_problems_within_an_alternative_are_no_refusal_by_themselves(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        '<param name="p" command="convert a" if="$(eval open(1))"/><node pkg="p" type="t" name="n" if="$(eval open(1))" output="x"/>',
    )
    assert found.refusal is None
    assert [(problem.kind, problem.fatal) for problem in found.problems] == [
        ("eval-unsupported", False),
        ("command", False),
        ("eval-unsupported", False),
        ("node", True),
    ]


def test_launch_lines_lead_from_the_file_given_to_the_node(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        '\n<group><include file="$(find here)/one.launch"/></group>',
        one_launch='<launch>\n<include file="$(dirname)/two.launch"/></launch>',
        two_launch='<launch>\n\n<node pkg="p" type="t" name="n"/></launch>',
    )
    here = f"{tmp_path}/here"
    assert [str(place) for place in found.nodes[0].lines] == [f"{here}/main.launch:3", f"{here}/one.launch:2", f"{here}/two.launch:3"]
    assert [include.file for include in found.includes] == [f"{here}/one.launch", f"{here}/two.launch"]


def test_eval_with_unknown_parts(tmp_path: Path) -> None:
    found = composed(
        tmp_path,
        """<param name="joined" value="$(eval env('A') + '/x')"/>
        <param name="compared" value="$(eval env('A') == 'x')"/>
        <param name="chosen" value="$(eval 'a' if optenv('A', 'x') == 'x' else env('A'))"/>
        <param name="method" value="$(eval env('A').lower())"/>
        <param name="listed" value="$(eval [env('A')])"/>""",
    )
    assert params(found) == {
        "/joined": "$(env A)/x",
        "/compared": "$(eval env('A') == 'x')",
        "/chosen": "a",
        "/method": "$(eval env('A').lower())",
        "/listed": "$(eval [env('A')])",
    }


def test_input_cannot_pose_as_an_unknown(tmp_path: Path) -> None:
    mark = "\U00100000"
    found = composed(
        tmp_path,
        f"""<param name="real" value="$(env A)"/><param name="text" value="{mark}"/><param name="entity" value="&#x100000;"/>
        <param name="file" textfile="$(find here)/a.txt"/><param name="argument" value="$(arg given)"/><param name="set" value="$(env SET)"/>
        <param name="eval" value="$(eval chr(1048576) + '\\U00100000' + '%c' % 1048576 + '{{:c}}'.format(1048576))"/>
        <rosparam>{{yaml: "\\U00100000"}}</rosparam>""",
        {"given": mark},
        {"SET": mark},
        a_txt=mark,
    )
    assert params(found) == {
        "/real": "$(env A)",
        **{f"/{name}": "\ufffd" for name in ("text", "entity", "file", "argument", "set", "yaml")},
        "/eval": "\ufffd" * 4,
    }


def test_a_machine_in_both_of_two_alternatives(tmp_path: Path) -> None:
    machine = '<group {}="$(env ROBOT)"><machine name="m" address="{}"/></group>'
    composition = composed(tmp_path, machine.format("if", "a") + machine.format("unless", "b"))
    assert {problem.kind for problem in composition.problems} == {"env"}


@pytest.mark.parametrize("text", ["$(arg a)", "b: 1\n$(arg a)"])
def test_yaml_of_an_argument_may_be_a_map(tmp_path: Path, text: str) -> None:
    found = composed(tmp_path, f'<arg name="a"/><node pkg="p" type="t" name="n"><rosparam subst_value="true">{text}</rosparam></node>')
    assert [problem.kind for problem in found.problems] == ["arg"]
    assert [setting.name for setting in found.unread] == ["/n"]
