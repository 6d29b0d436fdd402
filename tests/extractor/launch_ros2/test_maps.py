"""Maps that something unknown is added to, and values that no parameter has."""

from __future__ import annotations

from pathlib import Path

import pytest
from ros2_launch_builder import HEAD, composed, described, params, problems

UNKNOWN = "from elsewhere import get\nmore = get()\n"


def _nodes(folder: Path, before: str, entities: str) -> tuple[dict[str, object], list[str]]:
    """The parameters that are known, and what is not."""
    text = f"{HEAD}{UNKNOWN}{before}\ndef generate_launch_description():\n    return LaunchDescription([{entities}])\n"
    found = composed(folder, {"launch/main.launch.py": text})
    return params(found), [f"{setting.name} {setting.source}" for setting in found.unread]


@pytest.mark.parametrize(
    ("before", "given", "known"),
    [
        ("", "{**more, 'b': 1}", {"/n/b": 1}),
        ("", "{'b': 1, **more}", {"/n/b": "$(b of get())"}),
        ("given = {}\ngiven.update(more)\ngiven['b'] = 1", "given", {"/n/b": 1}),
        ("given = {'b': 1, 'c': 2}\ngiven.update(more, c=3)", "given", {"/n/b": "$(b of get())", "/n/c": 3}),
        ("", "dict(more, b=1)", {"/n/b": 1}),
        ("given = {**more}", "{'a': 0, **given, 'b': 1}", {"/n/a": "$(a of get())", "/n/b": 1}),
        ("", "{'deep': {**more, 'b': 1}}", {"/n/deep.b": 1}),
    ],
)
def test_parameters_of_a_map_that_is_known_in_part(tmp_path: Path, before: str, given: str, known: dict[str, object]) -> None:
    assert _nodes(tmp_path, before, f"node('n', parameters=[{given}])") == (known, ["/n $(get())"])


def test_a_map_whose_other_keys_are_not_known_may_have_any(tmp_path: Path) -> None:
    found = described(
        tmp_path, "*([node('n')] if 'k' in {**more, 'c': 2} else []), *([node('m')] if 'c' in {**more, 'c': 2} else [])", UNKNOWN
    )
    assert [(node.name, [condition.text for condition in node.conditions]) for node in found.nodes] == [
        ("n", ["'k' in {**more, 'c': 2}"]),
        ("m", []),
    ]


def test_entries_that_one_of_two_maps_adds(tmp_path: Path) -> None:
    found = described(tmp_path, "node('n', parameters=[{'a': 0, **({'a': 1, 'b': 2, 'c': 4} if more else {'b': 3})}])", UNKNOWN)
    given = [(setting.name, setting.value, [str(one) for one in setting.conditions]) for setting in found.nodes[0].own_params]
    assert given == [("/n/a", "$(more ? 1 : 0)", []), ("/n/b", "$(more ? 2 : 3)", []), ("/n/c", 4, ["if more"])]


def test_a_map_that_gets_more_in_a_branch(tmp_path: Path) -> None:
    before = f"{UNKNOWN}given = {{'a': 1}}\nif more:\n    given['b'] = 2\n    given['deep'] = {{'er': 3}}"
    found = described(tmp_path, "node('n', parameters=[given])", before)
    given = [(setting.name, setting.value, [str(one) for one in setting.conditions]) for setting in found.nodes[0].own_params]
    assert given == [("/n/a", 1, []), ("/n/b", 2, ["if more"]), ("/n/deep.er", 3, ["if more"])]


def test_a_list_of_parameters_or_remappings_that_is_one_of_two(tmp_path: Path) -> None:
    entities = "node('n', parameters=[{'a': 1}] if more else [], remappings=[('a', 'b'), ('c', 'd')] if more else [('a', 'x')])"
    found = described(tmp_path, entities, UNKNOWN)
    (node,) = found.nodes
    assert [(setting.name, [str(one) for one in setting.conditions]) for setting in node.own_params] == [("/n/a", ["if more"])]
    assert [(one.source, one.target, [str(each) for each in one.conditions]) for one in node.remaps] == [
        ("a", "b", ["if more"]),
        ("c", "d", ["if more"]),
        ("a", "x", ["unless more"]),
    ]


@pytest.mark.parametrize(
    "added", ["[*(two if more else one)]", "[] + (two if more else one)", "(two if more else one) + []", "grown", "longer"]
)
def test_a_list_that_is_one_of_two_is_added_to_another(tmp_path: Path, added: str) -> None:
    before = f"{UNKNOWN}one, two = [('a', 'x')], [('a', 'b'), ('c', 'd')]\ngrown = []\ngrown.extend(two if more else one)\nlonger = []\nlonger += two if more else one"
    (node,) = described(tmp_path, f"node('n', remappings={added})", before).nodes
    remaps = [(one.source, one.target, [str(each) for each in one.conditions]) for one in node.remaps]
    assert remaps == [("a", "b", ["if more"]), ("c", "d", ["if more"]), ("a", "x", ["unless more"])]


@pytest.mark.parametrize("asked", ["len([*more, 1])", "[*more, 'a', 'b'][1]", "'a' if [*more] else 'b'"])
def test_how_many_items_a_list_has_is_not_known(tmp_path: Path, asked: str) -> None:
    found = described(tmp_path, f"node('n', parameters=[{{'p': {asked}}}])", UNKNOWN)
    assert "$(" in str(params(found)["/n/p"])


def test_a_list_is_no_key(tmp_path: Path) -> None:
    found = described(tmp_path, "node('n')", "given = {}\ngiven[[1]] = 2")
    assert problems(found, tmp_path)[0] == "launch/main.launch.py:20:5: TypeError: unhashable type: 'list'"


def test_remappings_that_are_not_known_are_told(tmp_path: Path) -> None:
    found = described(tmp_path, "node('n', remappings=[*more, ('a', 'b')])", UNKNOWN)
    assert problems(found, tmp_path) == ["launch/main.launch.py:16:12: what this node remaps is not known: $(each of more)"]


def test_the_environment_as_a_map(tmp_path: Path) -> None:
    before = "first = dict(os.environ)\nsecond = os.environ.copy()\nthird = {**os.environ, 'A': 'x'}\nfirst['B'] = 'b'"
    entities = "node('n', additional_env=first), node('m', parameters=[{'p': second['A'] + third['A'], 'q': second['GONE']}])"
    found = described(tmp_path, entities, before, environment={"A": "a"})
    assert {node.name: node.environment for node in found.nodes} == {"n": (("B", "b"),), "m": ()}
    assert params(found) == {"/m/p": "ax", "/m/q": "$(second['GONE'])"}
    assert problems(found, tmp_path) == []


@pytest.mark.parametrize(
    ("value", "told"),
    [
        ("None", "the parameter `p` is None, which launch does not take for a value"),
        ("Path('/a')", "the parameter `p` is a path of pathlib, which launch does not take for a value"),
        ("{1}", "the parameter `p` is a set, which launch does not take for a value"),
        ("os.getenv('GONE')", "the parameter `p` is None: an environment variable that the launch file asks for is not set"),
    ],
)
def test_a_value_that_no_parameter_has_ends_launch(tmp_path: Path, value: str, told: str) -> None:
    found = described(tmp_path, f"node('n', parameters=[{{'p': {value}}}])")
    assert found.refusal is not None and found.refusal.message == told


def test_a_command_that_is_evaluated_writes_nothing(tmp_path: Path) -> None:
    """As it is known what xacro does with its arguments, a path among them is no file that another command may have written."""
    entities = """*[node(name, parameters=[{'robot': Command(['xacro ', os.path.dirname(__file__) + '/r.urdf', ' folder:=/', ' ns:=/robot'])}])
      for name in ('a', 'b')], ExecuteProcess(cmd=['write', '/x']),
      node('c', parameters=[{'robot': Command(['xacro ', os.path.dirname(__file__) + '/r.urdf', ' folder:=/', ' ns:=/arm'])}])"""
    robot = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="ns" default=""/></robot>'
    text = f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{entities}])\n"
    found = params(composed(tmp_path, {"main.launch.py": text, "r.urdf": robot}))
    assert ["<robot" in str(found[f"/{name}/robot"]) for name in "abc"] == [True, True, True]
