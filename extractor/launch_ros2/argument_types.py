"""Arguments that the classes of launch_ros reject, in all versions: their types, and those that must be there.

Sources: launch_ros/actions/node.py, launch_ros/utilities/normalize_remap_rule.py, launch/utilities/type_utils.py and
launch/event_handlers/on_action_event_base.py.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch_ros2.values import MORE, Made

NODES = frozenset({"Node", "LifecycleNode", "ComposableNodeContainer"})
_PROCESSES = NODES | {"ExecuteProcess", "ExecuteLocal"}
_OF_PROCESSES = frozenset({"OnProcessExit", "OnProcessStart", "OnProcessIO", "OnExecutionComplete"})
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
TYPES: dict[str, type] = {"str": str, "int": int, "float": float, "bool": bool}
"""The types that a scalar parameter can be said to have."""
OF_NODES = NODES | {"ComposableNode", "ComposableLifecycleNode"}
"""The classes that describe nodes."""


def refused(kind: str, given: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """The arguments that an object of the class `kind` does not get, or gets with a type that it rejects, and what it asks for."""
    for names in _REQUIRED.get(kind, ()):
        if given.keys().isdisjoint((*names, MORE)):
            yield names[0], f"the argument `{names[0]}` must be given"
    parameters = given.get("parameters")
    if kind in NODES and (isinstance(parameters, (dict, tuple, Made)) or _is_text(parameters)):
        yield "parameters", "parameters must be a list"
    unsure = given.get("condition") is not None  # of what surely starts, the values are looked at then
    if kind in OF_NODES and unsure and isinstance(parameters, list) and any(map(_has_numbers_in_lists, parameters)):
        yield "parameters", "an item of a list within a list must be a text or a substitution"
    if kind == "IncludeLaunchDescription" and isinstance(given.get("launch_arguments"), dict):
        yield "launch_arguments", "launch_arguments must be pairs of names and values, such as the `.items()` of a dictionary"
    if kind in _PROCESSES and _is_text(given.get("respawn")):
        yield "respawn", "respawn must be a Boolean, or a substitution"
    if kind in _OF_PROCESSES and (isinstance(given.get("target_action"), list) or _is_text(given.get("target_action"))):
        yield "target_action", "target_action must be an action, or a function that chooses actions"
    wanted, value = type_name(given.get("value_type")), given.get("value")
    if kind == "ParameterValue" and _is_scalar(value) and not is_of(value, wanted):
        yield "value", f"{value!r} is no {wanted}: only what substitutions come to is converted"
    if kind in OF_NODES and any(not _is_rule(rule) for rule in _rules(given.get("remappings"))):
        yield "remappings", "each of the remappings must be a tuple of two names"


def type_name(kind: Any) -> str:
    """What a type is called that a parameter is said to have; `auto` when it is not said."""
    return kind if isinstance(kind, str) else str(getattr(kind, "__name__", None) or getattr(kind, "name", "auto"))


def is_of(value: Any, name: str) -> bool:
    """Whether launch takes a value that is no substitution for one of this type."""
    return name not in TYPES or isinstance(value, TYPES[name])


def _rules(remappings: Any) -> list[Any]:
    return list(remappings) if isinstance(remappings, (list, tuple, dict)) else []


def _is_rule(rule: Any) -> bool:
    """Whether this may be a pair of names: all that is not known may."""
    return not (isinstance(rule, list) or _is_text(rule) or (isinstance(rule, tuple) and len(rule) != 2))


def _has_numbers_in_lists(parameters: Any) -> bool:
    """Whether a map of parameters has a list of lists of numbers."""
    if not isinstance(parameters, dict):
        return False
    lists = (item for value in parameters.values() if isinstance(value, (list, tuple)) for item in value if isinstance(item, (list, tuple)))
    return any(isinstance(one, (int, float)) for inner in lists for one in inner) or any(map(_has_numbers_in_lists, parameters.values()))


def _is_scalar(value: Any) -> bool:
    return isinstance(value, (int, float)) or _is_text(value)


def _is_text(value: Any) -> bool:
    return isinstance(value, str) and is_known(value)
