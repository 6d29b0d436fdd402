"""Why systems are as they are: what starts their nodes, and the proofs of rates and chains."""

from __future__ import annotations

from pathlib import Path

import pytest
from rule_cases import case_of, facts_and_program

from rosarch.analysis.systems.reasons import Started, system_reasons
from rosarch.extractor.launch import Composition, Files, PackagePath, compose
from rosarch.models.derivations import Derivations
from rosarch.rule_programs.sets import system_rules

CASES = Path(__file__).parents[1] / "rules" / "systems"
OUTER = """<launch>
  <arg name="sim" default="true"/>
  <group if="$(arg sim)">
    <include file="$(find here)/inner.launch">
      <arg name="speed" value="2.0"/>
    </include>
  </group>
</launch>
"""
INNER = """<launch>
  <arg name="speed"/>
  <arg name="quiet"/>
  <node name="base" pkg="here" type="driver" args="--fast" unless="$(arg quiet)">
    <remap from="cmd_vel" to="/teleop/cmd_vel"/>
    <param name="limit" value="$(arg speed)"/>
    <rosparam command="load" file="$(find here)/base.yaml"/>
  </node>
</launch>
"""
PYTHON = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    sim = LaunchConfiguration('sim')
    node = Node(package='here', executable='driver', name='base', condition=UnlessCondition('false'), parameters=[{'limit': 2.0}])
    return LaunchDescription([
        DeclareLaunchArgument('sim', default_value='true'),
        GroupAction([node], condition=IfCondition(sim)),
    ])
"""


def package(folder: Path, **files: str) -> Path:
    (folder / "here").mkdir()
    (folder / "here" / "package.xml").write_text("<package><name>here</name></package>")
    for name, text in files.items():
        (folder / "here" / name.replace("_", ".", 1)).write_text(text)
    return folder / "here"


def started(composition: Composition, folder: Path) -> list[str]:
    """The steps of the only node, as lines that show what rests on what."""
    found = Started(composition, folder).added_to(Derivations((), {}))
    (root,) = found.roots.values()

    def lines(number: int, indent: str) -> list[str]:
        step = found.steps[number]
        return [f"{indent}{step.text}  {step.at}", *(line for below in step.premises for line in lines(below, f"{indent}  "))]

    return lines(root, "")


def test_what_launch_files_start_and_give_to_a_node(tmp_path: Path) -> None:
    here = package(tmp_path, outer_launch=OUTER, inner_launch=INNER, base_yaml="gains:\n  p: 3\n")
    composition = compose([here / "outer.launch"], files=Files(PackagePath([tmp_path]), str(tmp_path)))
    assert started(composition, tmp_path) == [
        "/base runs here/driver  here/inner.launch:4",
        "  includes here/inner.launch  here/outer.launch:4",
        "    passes speed = 2.0  here/outer.launch:5",
        "  if $(arg sim), which holds  here/outer.launch:3",
        "  unless $(arg quiet), which launch files leave open  here/inner.launch:4",
        "  arguments --fast  here/inner.launch:4",
        "  cmd_vel is called /teleop/cmd_vel  here/inner.launch:5",
        "  ~gains/p = 3, from here/base.yaml  here/base.yaml:2",
        "  ~limit = 2.0  here/inner.launch:6",
    ]


def test_what_python_starts(tmp_path: Path) -> None:
    here = package(tmp_path, main_launch=PYTHON)
    (here / "main.launch").rename(here / "main.launch.py")
    composition = compose([here / "main.launch.py"], files=Files(PackagePath([tmp_path]), str(tmp_path)))
    assert started(composition, tmp_path) == [
        "/base runs here/driver  here/main.launch.py:9",
        "  if LaunchConfiguration(sim), which holds  here/main.launch.py:12",
        "  unless false, which holds  here/main.launch.py:9",
        "  ~limit = 2.0  here/main.launch.py:9",
    ]


def reasons(file: str, name: str, *, chains: bool) -> Derivations:
    """Those of a case of the tests of rules."""
    rules = system_rules()
    facts, _ = facts_and_program(case_of(CASES / file, name))
    rows = {relation: set(found) for relation, found in facts.items()}
    nothing = Started(Composition((), (), (), (), (), ()), Path())
    return system_reasons(rules, rows, rules.program.evaluate(rows, keep="all"), name, nothing, str, chains=chains)


def below(found: Derivations, key: str) -> set[str]:
    """The texts of all steps of a proof."""
    waiting, seen = [found.roots[key]], set()
    while waiting:
        number = waiting.pop()
        if number not in seen:
            seen.add(number)
            waiting += found.steps[number].premises
    return {found.steps[number].text for number in seen}


@pytest.mark.slow
def test_rates_are_proven_down_to_the_clock_that_sets_them_off() -> None:
    found = reasons("topic_rates.dl", "in_a_chain", chains=False)
    assert {key for key in found.roots if key.startswith("topic_low")} == {"topic_low /image", "topic_low /tracks", "topic_low /plan"}
    assert 'interface_loop("camera", "camera.cpp:8", 25, "")' in below(found, "topic_high /found")
    assert 'interface_loop("tracker", "tracker.cpp:8", 10, "")' in below(found, "topic_low /plan")
    assert {str(step.at) for step in found.steps if step.text.startswith("interface_loop(")} == {"camera.cpp:8", "tracker.cpp:8"}
    assert not any(key.startswith("chain_step") for key in found.roots)


@pytest.mark.slow
def test_steps_of_chains_are_proven() -> None:
    found = reasons("chains.dl", "can", chains=True)
    inside = "/filter f_in > /filter f_out"
    assert 'interface_port_flow("filter", "f_in", "f_out", "data", "reactive")' in below(found, f"chain_step {inside}")
    assert f"certain_step {inside}" not in found.roots
    assert "certain_step /sensor s_out > /filter f_in" in found.roots
