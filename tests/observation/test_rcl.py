"""What rosarch says of names, remapping rules, files of parameters, qualities of service and managed nodes is what rcl makes of them.

`benchmarks/rcl_table.jsonl` has what rcl said; where a Python with rclpy is named by ROSARCH_ROS2_PYTHON, the table is made again first.
"""

from __future__ import annotations

import json
import os
import shlex
import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import pytest
from rcl_table import NODE, REFUSED, TABLE, Case, cases, parameter_words, plain, rule_words

from rosarch.extractor.launch import Composition, Files, PackagePath, compose
from rosarch.extractor.launch.facts import launch_rows
from rosarch.models.system.build import evaluate
from rosarch.models.system.rows import merged
from rosarch.rule_programs.sets import component_program, system_rules

PYTHON = os.environ.get("ROSARCH_ROS2_PYTHON")


@cache
def table() -> tuple[Case, ...]:
    return tuple(json.loads(line) for line in TABLE.read_text(encoding="utf-8").splitlines())


def of(*subjects: str) -> list[Case]:
    return [case for case in table() if case["subject"] in subjects]


def launched(case: Case, folder: Path, words: list[str], executable: str = "run") -> Composition:
    """The node of a case, as a launch file starts it."""
    args = quoteattr(shlex.join(["--ros-args", *words]))
    namespace = quoteattr(case["namespace"])
    file = folder / "main.launch.xml"
    file.write_text(
        f'<launch><node pkg="demo" exec="{executable}" name="{NODE}" namespace={namespace} args={args}/></launch>', encoding="utf-8"
    )
    return compose([file], files=Files(PackagePath([folder]), str(folder)))


OPEN = {
    "~x": "rosarch writes `~x` for `~/x`, whatever follows",
    "program:__node:=m": "the name that the code gives a node is not known where launch files are read",
}
"""What stays apart, and why."""


def told(differences: list[str]) -> None:
    """Fail with one line for each difference."""
    left = [line for line in differences if not any(one in line for one in OPEN)]
    assert not left, "\n".join(left)


# -- names --------------------------------------------------------------------------------------------------------------------


def test_names_are_those_of_rcl(tmp_path: Path) -> None:
    """One component for each case, with a port of that name."""
    started = [launched(case, tmp_path, rule_words(case["rules"]), f"e{number}") for number, case in enumerate(of("name"))]
    refused = {
        f"e{number}"
        for number, composition in enumerate(started)
        if [one for one in composition.problems if one.kind != "list-without-type"]
    }
    rows: dict[str, set[tuple[Any, ...]]] = {name: set() for name in ("interface", "interface_port", "interface_port_at", "place")}
    for number, case in enumerate(of("name")):
        program, place = f"e{number}", f"e{number}.py:1:1"
        rows["interface"].add((program, "demo", program, "node", "source"))
        rows["interface_port"].add((program, f"{program}#p", "publisher" if case["kind"] == "topic" else "service_server", case["name"]))
        rows["interface_port_at"].add((f"{program}#p", place))
        rows["place"].add((place, f"{program}.py", 1, 1))
    together = replace(started[0], nodes=tuple(node for composition in started for node in composition.nodes))
    result = evaluate(system_rules(), merged([rows, launch_rows(together, tmp_path)]), keep=("port_name", "started", "name_not_valid"))
    programs = {start: type_ for start, _, type_ in result.rows("started")}
    named = {programs[port[0]]: name for port, name in result.rows("port_name")}
    invalid = {programs[row[1]] for row in result.rows("name_not_valid")}
    differences = []
    for number, case in enumerate(of("name")):
        program = f"e{number}"
        found = REFUSED if program in refused or program in invalid else named.get(program)
        if found != case["answer"]:
            differences.append(
                f"{case['namespace']} {case['kind']} {' '.join(case['rules'])} | {case['name']}: {found}, rcl: {case['answer']}"
            )
    told(differences)


# -- parameters ---------------------------------------------------------------------------------------------------------------


def test_parameters_are_those_of_rcl(tmp_path: Path) -> None:
    differences = []
    for case in of("parameters"):
        files = []
        for number, content in enumerate(case["files"]):
            (tmp_path / f"{number}.yaml").write_text(content, encoding="utf-8")
            files.append(str(tmp_path / f"{number}.yaml"))
        composition = launched(case, tmp_path, parameter_words(case, files))
        (node,) = composition.nodes
        prefix = f"{node.full_name}/"
        given = sorted((one.name.removeprefix(prefix), plain(one.value)) for one in composition.params if one.value not in (None, []))
        found: Any = dict(given)
        if any(one.kind != "list-without-type" for one in composition.problems):  # that is for rclcpp
            found = REFUSED
        if json.dumps(found) != json.dumps(case["answer"]):
            differences.append(
                f"{case['namespace']} {' '.join(case['files'])} {case['assigned']} {case.get('first', '')}: {found}, rcl: {case['answer']}"
            )
    told(differences)


# -- qualities of service -----------------------------------------------------------------------------------------------------

SHORT = {"services_default": "services", "action_status_default": "action_status"}


@cache
def profiles() -> dict[str, dict[str, str]]:
    """What the rules say of each profile."""
    result = component_program().evaluate({}, keep=("rmw_profile", "rmw_depth"))
    found: dict[str, dict[str, str]] = {}
    for profile, policy, setting in result.rows("rmw_profile"):
        found.setdefault(profile, {})[policy] = setting
    for profile, depth in result.rows("rmw_depth"):
        found[profile]["depth"] = depth
    return found


def settings(given: dict[str, str]) -> dict[str, str]:
    """The policies of a port of the table: reliable and volatile unless it says otherwise; a time that is not limited is none."""
    if "profile" in given:
        name = given["profile"]
        return {
            policy: setting for policy, setting in profiles()[SHORT.get(name, name)].items() if setting != "infinite" and policy != "depth"
        }
    given = {policy: setting for policy, setting in given.items() if setting != "infinite"}
    return {"reliability": "reliable", "durability": "volatile", "liveliness": "automatic", **given}


def test_qualities_meet_as_rcl_says() -> None:
    rows: dict[str, set[tuple[Any, ...]]] = {}
    for number, case in enumerate(of("qualities")):
        for kind, given in (("publisher", case["offered"]), ("subscriber", case["requested"])):
            node, port = f"/{kind}{number}", f"{kind}{number}#p"
            own = {
                "started": (node, "demo", f"{kind}{number}"), "started_name": (node, node, "/"), "started_version": (node, 2),
                "interface": (f"{kind}{number}", "demo", f"{kind}{number}", "node", "source"),
                "interface_port": (f"{kind}{number}", port, kind, f"/t{number}"), "interface_port_type": (port, "std_msgs/Bool"),
            }  # fmt: skip
            for relation, row in own.items():
                rows.setdefault(relation, set()).add(row)
            for policy, setting in settings(given).items():
                rows.setdefault("interface_port_quality", set()).add((port, policy, setting))
    result = evaluate(system_rules(), rows, keep=("incompatible_qos", "connected"))
    assert len(list(result.rows("connected"))) == len(of("qualities"))
    apart = {int(topic.removeprefix("/t")) for _, _, topic, *_ in result.rows("incompatible_qos")}
    told([
        f"{case['offered']} {case['requested']}: {'error' if number in apart else 'ok'}, rcl: {case['answer']}"
        for number, case in enumerate(of("qualities"))
        if (number in apart) != (case["answer"] == "error")
    ])  # fmt: skip


def test_profiles_are_those_of_rcl() -> None:
    for case in of("profile"):
        found = profiles()[SHORT.get(case["profile"], case["profile"])]
        expected = {policy: str(setting) for policy, setting in case["answer"].items() if setting != 0}  # the middleware says how many
        assert {policy: found.get(policy, "system_default") for policy in expected} == expected, case["profile"]


# -- managed nodes ------------------------------------------------------------------------------------------------------------


def test_transitions_and_ports_of_managed_nodes_are_known() -> None:
    result = component_program().evaluate({}, keep=("api_transition", "api_hidden_port", "api_managed_node"))
    known = {function.rpartition("::")[2] for (function,) in result.rows("api_transition")}
    assert {callback for case in of("life") if case["answer"] != REFUSED for callback in case["answer"]["ran"]} <= known
    (case,) = of("ports of a managed node")
    managed = {function for (function,) in result.rows("api_managed_node")}
    for constructor in managed:
        own = {(kind, name, type_) for function, kind, name, type_ in result.rows("api_hidden_port") if function == constructor}
        for kind, ports in case["answer"].items():
            for name, type_ in ports:
                package, _, leaf = type_.split("/")
                assert (kind, name.replace("/managed/", "~"), f"{package}/{leaf}") in own, (constructor, name)


# -- the real one -------------------------------------------------------------------------------------------------------------


def test_the_table_has_all_cases() -> None:
    assert [{key: value for key, value in case.items() if key != "answer"} for case in table()] == json.loads(json.dumps(cases()))


@pytest.mark.slow
@pytest.mark.skipif(PYTHON is None, reason="ROSARCH_ROS2_PYTHON names no Python with rclpy")
def test_the_table_is_what_rcl_says(tmp_path: Path) -> None:
    out = tmp_path / "table.jsonl"
    subprocess.run([str(PYTHON), str(TABLE.with_suffix(".py")), "--out", str(out)], check=True, timeout=300, stderr=subprocess.DEVNULL)
    assert out.read_text(encoding="utf-8") == TABLE.read_text(encoding="utf-8")
