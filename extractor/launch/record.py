"""The record of a composition: what roslaunch has in its memory after loading, as JSON values."""

from __future__ import annotations

from typing import Any

from rosarch.extractor.launch.model import Composition, NodeStart, ParamSetting, Place, exclusive
from rosarch.extractor.launch.values import Binary


def record(composition: Composition) -> dict[str, Any]:
    """The composition as JSON values.

    `nodes` and `params` are those of roslaunch, texts with unknown parts as the source writes them. `started_by` has the launch lines
    and unknown conditions of each node, in the order of `nodes`. A parameter that has several values because a condition is unknown has the
    last one in `params` and all of them in `alternatives`. In ROS 2, where nodes of one name are there side by side, each with its own
    parameters, the second one of a name is `name#2` in `started_by` and `params`. `not_read` are the files that would add to this but are
    not there or not known. `refused` is what roslaunch would stop at, `problems` are all.
    """
    keys = _keys(composition)
    result: dict[str, Any] = {
        "nodes": [_node(node) for node in composition.nodes],
        "params": _params(composition, keys),
        "tests": len(composition.tests),
        "started_by": [_origin(node, key) for node, key in zip(composition.nodes, keys, strict=True)],
        "problems": [str(problem) for problem in composition.problems],
    }
    conditional = [setting for setting in composition.params if setting.conditions]
    if conditional:
        names = {setting.name for setting in conditional}
        result["alternatives"] = [_alternative(setting) for setting in composition.params if setting.name in names]
    missing = [
        *({"include": include.text, "lines": _lines(include.lines)} for include in composition.includes if include.file is None),
        *({"rosparam": setting.source, "namespace": setting.name, "lines": _lines(setting.lines)} for setting in composition.unread),
    ]
    if missing:
        result["not_read"] = missing
    if composition.refusal:
        result["refused"] = str(composition.refusal)
    return result


def _node(node: NodeStart) -> dict[str, Any]:
    container = {} if node.container is None else {"container": node.container}
    return {
        "package": node.package,
        "type": node.type,
        "name": node.name,
        "namespace": node.namespace,
        "remap": [[remap.source, remap.target] for remap in node.given_remaps],
        "args": node.args,
        "respawn": node.respawn,
        "required": node.required,
        "machine": node.machine,
        "output": node.output,
        "launch_prefix": node.launch_prefix,
        **container,
    }


def _keys(composition: Composition) -> list[str]:
    """What the nodes are called, with a number after the name of another one that may be there, too."""
    before: dict[str, list[NodeStart]] = {}
    found = []
    for node in composition.nodes:
        others = before.setdefault(node.full_name, [])
        number = 1 + sum(not exclusive(node.conditions, other.conditions) for other in others)
        found.append(node.full_name if number == 1 or node.ros == 1 else f"{node.full_name}#{number}")
        others.append(node)
    return found


def _params(composition: Composition, keys: list[str]) -> dict[str, Any]:
    """The parameters; of nodes of one name each has its own."""
    found = {setting.name: plain(setting.value) for setting in composition.params}
    several = {node.full_name for node, key in zip(composition.nodes, keys, strict=True) if key != node.full_name}
    alike = [(node, key) for node, key in zip(composition.nodes, keys, strict=True) if node.full_name in several]
    for node, _ in alike:
        for setting in node.own_params:
            found.pop(setting.name, None)
    for node, key in alike:
        found.update({key + setting.name[len(node.full_name) :]: plain(setting.value) for setting in node.own_params})
    return found


def _origin(node: NodeStart, key: str) -> dict[str, Any]:
    origin: dict[str, Any] = {"node": key, "lines": _lines(node.lines)}
    if node.conditions:
        origin["conditions"] = [str(condition) for condition in node.conditions]
    return origin


def _lines(lines: tuple[Place, ...]) -> list[str]:
    return [str(place) for place in lines]


def _alternative(setting: ParamSetting) -> dict[str, Any]:
    return {
        "param": setting.name,
        "value": plain(setting.value),
        "conditions": [str(condition) for condition in setting.conditions],
        "line": str(setting.lines[-1]),
    }


def plain(value: Any) -> Any:
    """A parameter's value as the record has it: bytes as Latin-1 text, and what JSON does not have as text."""
    return "None" if value is None else _json(value)


def _json(value: Any) -> Any:
    if isinstance(value, Binary):
        return value.decode("latin-1")
    if isinstance(value, dict):
        return {str(key): _json(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_json(item) for item in value]
    return value if value is None or isinstance(value, (str, int, float, bool)) else str(value)
