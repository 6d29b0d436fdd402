"""Arguments that the classes of launch_ros reject, in all versions: their types, and those that must be there.

Sources: launch_ros/actions/node.py, launch_ros/utilities/normalize_remap_rule.py.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch_ros2.values import MORE, Made

_NODES = frozenset({"Node", "LifecycleNode", "ComposableNodeContainer"})
_REQUIRED = {  # by any of their names
    "Node": (("executable", "node_executable"),),
    **dict.fromkeys(
        ("LifecycleNode", "ComposableNodeContainer"),
        (("executable", "node_executable"), ("name", "node_name"), ("namespace", "node_namespace")),
    ),
    "ComposableNode": (("package",), ("plugin", "node_plugin")),
}
RENAMED = {"node_executable": "executable", "node_name": "name", "node_namespace": "namespace", "node_plugin": "plugin"}
"""Arguments by the names that they had until Foxy, and their names since Galactic."""
WITH_OLD_NAMES = frozenset({"dashing", "eloquent", "foxy"})
OF_NODES = _NODES | {"ComposableNode", "ComposableLifecycleNode"}
"""The classes that describe nodes."""


def refused(kind: str, given: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """The arguments that an object of the class `kind` does not get, or gets with a type that it rejects, and what it asks for."""
    for names in _REQUIRED.get(kind, ()):
        if given.keys().isdisjoint((*names, MORE)):
            yield names[0], f"the argument `{names[0]}` must be given"
    parameters = given.get("parameters")
    if kind in _NODES and (isinstance(parameters, (dict, tuple, Made)) or _is_text(parameters)):
        yield "parameters", "parameters must be a list"
    if kind == "IncludeLaunchDescription" and isinstance(given.get("launch_arguments"), dict):
        yield "launch_arguments", "launch_arguments must be pairs of names and values, such as the `.items()` of a dictionary"
    if kind in OF_NODES and any(not _is_rule(rule) for rule in _rules(given.get("remappings"))):
        yield "remappings", "each of the remappings must be a tuple of two names"


def _rules(remappings: Any) -> list[Any]:
    return list(remappings) if isinstance(remappings, (list, tuple, dict)) else []


def _is_rule(rule: Any) -> bool:
    """Whether this may be a pair of names: all that is not known may."""
    return not (isinstance(rule, list) or _is_text(rule) or (isinstance(rule, tuple) and len(rule) != 2))


def _is_text(value: Any) -> bool:
    return isinstance(value, str) and is_known(value)
