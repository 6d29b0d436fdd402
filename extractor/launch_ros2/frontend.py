"""Elements of XML and YAML launch files, as actions (launch.frontend and the parsers of launch_ros)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.base.hints import only_candidate
from rosarch.extractor.launch.model import LaunchError, Place
from rosarch.extractor.launch_ros2.argument_types import TYPES, WITH_OLD_NAMES, is_of
from rosarch.extractor.launch_ros2.parameters import converted, yaml_value
from rosarch.extractor.launch_ros2.texts import parsed
from rosarch.extractor.launch_ros2.values import Made

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World


@dataclass(eq=False)
class Entity:
    """An element: its name, attributes and children, and where it is. Those of YAML are `typed`: numbers are no texts; keys are `at`."""

    name: str
    attributes: dict[str, Any]
    place: Place
    children: list[Entity] = field(default_factory=list)
    typed: bool = False
    at: dict[str, Place] = field(default_factory=dict)

    def named(self, *names: str) -> list[Entity]:
        """The children of these names."""
        return [child for child in self.children if child.name in names]


Maker = Callable[["World", Entity], "Made | None"]
MAKERS: dict[str, Maker] = {}
ATTRIBUTES = {
    words[0]: frozenset((*words[1:], "if", "unless"))
    for line in (Path(__file__).parent / "attributes.txt").read_text(encoding="utf-8").splitlines()
    if (words := line.split())[0] != "#"
}
"""The elements of which all attributes are known, with these."""
_OF_NODES = ("param", "remap", "env")
_CHILDREN = {
    "arg": ("choice",),
    "composable_node": ("param", "remap", "extra_arg"),
    "executable": ("env",),
    "include": ("arg", "let"),
    "load_composable_node": ("composable_node",),
    "node": _OF_NODES,
    "node_container": (*_OF_NODES, "composable_node"),
    "param": ("param",),
}
"""The elements that hold no actions, with those that they may hold."""


def element(*names: str) -> Callable[[Maker], Maker]:
    """Register the function for elements of these names."""

    def register(function: Maker) -> Maker:
        for name in names:
            MAKERS[name] = function
            MAKERS[name.replace("_", "-")] = function
        return function

    return register


def actions_of(world: World, parent: Entity) -> list[Made]:
    """The actions of the children of an element."""
    return list(_actions(world, parent.children, parent.name))


def _actions(world: World, children: list[Entity], inside: str) -> Iterator[Made]:
    for child in children:
        world.here(child.place)
        maker = MAKERS.get(child.name)
        if maker is None:
            meant = None if child.children else only_candidate(child.name, MAKERS)
            message = f"unknown element <{child.name}> in <{inside}>"
            world.state.report(LaunchError("unknown-element", child.name, message, (child.name, meant) if meant else None))
            continue
        _report_unexpected(world, child)
        try:
            made = maker(world, child)
            if made is not None:
                made.arguments["condition"] = _condition(child)
        except LaunchError as error:
            world.state.report(error)
            continue
        if made is not None:
            yield made


def _report_unexpected(world: World, child: Entity) -> None:
    """Report the attributes and elements that an element cannot have: launch reads no file with one."""
    known = ATTRIBUTES.get(child.name.replace("-", "_"), child.attributes.keys())
    allowed = _CHILDREN.get(child.name)
    for name, value in child.attributes.items():
        is_list = isinstance(value, (list, dict))  # of YAML: perhaps one of children, which is empty
        if name not in known and not (is_list and (allowed is None or name in allowed)):
            meant = only_candidate(name, set(known) - set(child.attributes))
            error = LaunchError("attribute", name, f"<{child.name}> cannot have the attribute `{name}`", (name, meant) if meant else None)
            world.state.report(error, place=child.at.get(name, child.place))
    for inner in child.children:
        if allowed is not None and inner.name not in allowed:
            problem = LaunchError("unknown-element", inner.name, f"<{child.name}> cannot hold <{inner.name}>")
            world.state.report(problem, place=inner.place)
        if child.name != "group":  # whose children are actions
            _report_unexpected(world, inner)


def _condition(child: Entity) -> Made | None:
    if {"if", "unless"} <= child.attributes.keys():
        raise LaunchError("condition", "if unless", f"<{child.name}> has both `if` and `unless`")
    for attribute, kind in (("if", "IfCondition"), ("unless", "UnlessCondition")):
        if attribute in child.attributes:
            return Made(kind, {"predicate_expression": text(child, attribute)}, child.place)
    return None


def text(child: Entity, name: str) -> Any:
    """The substitutions of an attribute; None when it is not there."""
    return parsed(raw(child, name), child.place) if name in child.attributes else None


def required(child: Entity, *names: str) -> Any:
    """The substitutions of an attribute that must be there, under one of its names.

    Raises:
        LaunchError: it is not there.
    """
    for name in names:
        if name in child.attributes:
            return text(child, name)
    raise LaunchError("attribute", names[0], f"<{child.name}> has no attribute `{names[0]}`")


def made(child: Entity, kind: str, **arguments: Any) -> Made:
    """An action, without the arguments that are not there."""
    return Made(kind, {name: value for name, value in arguments.items() if value is not None}, child.place)


def flag(child: Entity, name: str, default: bool) -> bool:
    """A Boolean attribute."""
    found = child.attributes.get(name)
    return default if found is None else found if isinstance(found, bool) else str(found).strip().lower() in ("true", "1")


def raw(child: Entity, name: str) -> str:
    """The text of an attribute that must be there, as it is written."""
    if name not in child.attributes:
        raise LaunchError("attribute", name, f"<{child.name}> has no attribute `{name}`")
    found = child.attributes[name]
    if not isinstance(found, str):
        raise LaunchError("attribute", name, f"the attribute `{name}` of <{child.name}> must be a text")
    return found


@element("arg")
def _arg(_world: World, child: Entity) -> Made:
    choices = [text(choice, "value") for choice in child.named("choice")]
    return made(child, "DeclareLaunchArgument", name=raw(child, "name"), default_value=text(child, "default"), choices=choices or None)


@element("let", "set_launch_configuration")
def _let(_world: World, child: Entity) -> Made:
    return made(child, "SetLaunchConfiguration", name=required(child, "name"), value=required(child, "value"))


@element("include")
def _include(_world: World, child: Entity) -> Made:
    passed = [(required(one, "name"), required(one, "value")) for one in child.named("arg", "let")]
    return made(child, "IncludeLaunchDescription", launch_description_source=required(child, "file"), launch_arguments=passed)


@element("group")
def _group(world: World, child: Entity) -> Made:
    inner = Entity(child.name, {}, child.place, [one for one in child.children if one.name != "keep"])
    kept = {raw(one, "name"): required(one, "value") for one in child.named("keep")}
    scoped, forwarding = flag(child, "scoped", True), flag(child, "forwarding", True)
    return made(child, "GroupAction", actions=actions_of(world, inner), scoped=scoped, forwarding=forwarding, launch_configurations=kept)


@element("push_ros_namespace")
def _namespace(_world: World, child: Entity) -> Made:
    return made(child, "PushRosNamespace", namespace=required(child, "namespace"))


@element("set_remap")
def _remap(_world: World, child: Entity) -> Made:
    return made(child, "SetRemap", src=required(child, "from"), dst=required(child, "to"))


@element("set_parameter")
def _set_parameter(_world: World, child: Entity) -> Made:
    value = Made("ParameterValue", {"value": required(child, "value"), "value_type": "auto"}, child.place)
    return made(child, "SetParameter", name=required(child, "name"), value=value)


@element("set_use_sim_time")
def _sim_time(_world: World, child: Entity) -> Made:
    return made(child, "SetUseSimTime", value=required(child, "value"))


@element("set_parameters_from_file")
def _from_file(_world: World, child: Entity) -> Made:
    return made(child, "SetParametersFromFile", filename=required(child, "filename"), node_name=text(child, "node"))


@element("set_env", "env", "append_env")
def _environment(_world: World, child: Entity) -> Made:
    given = {"name": required(child, "name"), "value": required(child, "value")}
    if not child.name.startswith("append"):
        return made(child, "SetEnvironmentVariable", **given)
    return made(child, "AppendEnvironmentVariable", **given, prepend=flag(child, "prepend", False), separator=text(child, "separator"))


@element("unset_env")
def _unset_env(_world: World, child: Entity) -> Made:
    return made(child, "UnsetEnvironmentVariable", name=required(child, "name"))


@element("unset", "unset_launch_configuration")
def _unset(_world: World, child: Entity) -> Made:
    return made(child, "UnsetLaunchConfiguration", name=required(child, "name"))


@element("reset")
def _reset(_world: World, child: Entity) -> Made:
    return made(
        child, "ResetLaunchConfigurations", launch_configurations={raw(one, "name"): required(one, "value") for one in child.named("keep")}
    )


@element("timer", "ros_timer")
def _timer(world: World, child: Entity) -> Made:
    found = child.attributes.get("period")
    period = str(found) if isinstance(found, float) else required(child, "period")
    return made(child, "TimerAction", period=period, actions=actions_of(world, child))


@element("for_each")
def _for_each(world: World, child: Entity) -> Made:
    return made(child, "ForEach", input_values=required(child, "values"), actions=actions_of(world, child))


@element("for")
def _for(world: World, child: Entity) -> Made:
    return made(child, "ForLoop", length=required(child, "len"), name=raw(child, "name"), actions=actions_of(world, child))


@element("executable")
def _executable(_world: World, child: Entity) -> Made:
    _require_process(child)
    return made(child, "ExecuteProcess", cmd=_words(child, "cmd"), args=_words(child, "args"))


@element("log", "log_info", "log_debug", "log_warning", "log_error")
def _log(_world: World, child: Entity) -> Made:
    return made(child, "LogInfo", msg=required(child, "message"))


@element("set_ros_log_dir")
def _log_folder(_world: World, child: Entity) -> Made:
    return made(child, "SetROSLogDir", new_log_dir=required(child, "new_log_dir"))


@element("shutdown")
def _shutdown(_world: World, child: Entity) -> Made:
    return made(child, "Shutdown", reason=text(child, "reason"))


@element("test", "lifecycle_transition")
def _silent(_world: World, child: Entity) -> Made:
    return made(child, "LogInfo")


_PLAIN = {
    "reset_env": "ResetEnvironment", "push_env": "PushEnvironment", "pop_env": "PopEnvironment",
    "push_launch_configurations": "PushLaunchConfigurations", "pop_launch_configurations": "PopLaunchConfigurations",
}  # fmt: skip


@element(*_PLAIN)
def _plain(_world: World, child: Entity) -> Made:
    return made(child, _PLAIN[child.name.replace("-", "_")])


_SECONDS = ("respawn_delay", "sigkill_timeout", "sigterm_timeout")


def _require_process(child: Entity) -> None:
    """Require of the attributes of a process what launch does.

    Raises:
        LaunchError: `on_exit` says something else than `shutdown`, or a time is none.
    """
    if child.attributes.get("on_exit", "shutdown") != "shutdown":
        raise LaunchError("attribute", "on_exit", f"the attribute `on_exit` of <{child.name}> must be `shutdown`")
    for name in _SECONDS:
        found = child.attributes.get(name)
        if found is not None and not _is_time(found, typed=child.typed):
            raise LaunchError("attribute", name, f"the attribute `{name}` of <{child.name}> must be a number that is not negative")


def _is_time(found: Any, *, typed: bool) -> bool:
    """Whether an attribute is a time; in YAML it must be written with a point."""
    if typed:
        return isinstance(found, float) and found >= 0
    try:
        return float(found) >= 0
    except ValueError:
        return False


@element("node", "lifecycle_node")
def _node(world: World, child: Entity) -> Made:
    _require_name(world, child)
    kind = "LifecycleNode" if child.name.startswith("lifecycle") else "Node"
    return made(child, kind, executable=required(child, "exec"), package=text(child, "pkg"), **_of_node(child))


def _require_name(world: World, child: Entity) -> None:
    if "node-name" in child.attributes and world.environment.get("ROS_DISTRO") not in WITH_OLD_NAMES:
        raise LaunchError("attribute", "node-name", f"<{child.name}> has no attribute `node-name`: since Galactic it is `name`")


def _of_node(child: Entity) -> dict[str, Any]:
    _require_process(child)
    return {
        "name": text(child, "name"),
        "namespace": text(child, "namespace"),
        "parameters": [_param(one) for one in child.named("param")],
        "remappings": [(required(one, "from"), required(one, "to"), one.place) for one in child.named("remap")],
        "arguments": _words(child, "args"),
        "ros_arguments": _words(child, "ros_args"),
        "additional_env": {raw(one, "name"): required(one, "value") for one in child.named("env")},
        "output": text(child, "output"),
        "respawn": flag(child, "respawn", False),
    }


def _words(child: Entity, name: str) -> Any:
    found = text(child, name)
    return None if found is None else Made("Words", {"text": found}, child.place)


@element("node_container")
def _container(world: World, child: Entity) -> Made:
    _require_name(world, child)
    required(child, "name")
    required(child, "namespace")
    return made(child, "ComposableNodeContainer", executable=required(child, "exec"), package=required(child, "pkg"),
                composable_node_descriptions=_composable(child), **_of_node(child))  # fmt: skip


@element("load_composable_node", "load_composable_nodes")
def _load(_world: World, child: Entity) -> Made:
    return made(child, "LoadComposableNodes", target_container=required(child, "target"), composable_node_descriptions=_composable(child))


def _composable(parent: Entity) -> list[Made]:
    found = []
    for child in parent.named("composable_node"):
        one = made(child, "ComposableNode", package=required(child, "pkg"), plugin=required(child, "plugin"), **_of_node(child))
        required(child, "name")
        one.arguments["condition"] = _condition(child)
        found.append(one)
    return found


def _param(child: Entity) -> Made:
    """`<param name value>`, one that holds others, or `<param from>`."""
    if "from" in child.attributes:
        return made(child, "ParameterFile", param_file=text(child, "from"), allow_substs=flag(child, "allow_substs", False))
    inner = child.named("param")
    if inner:
        return made(child, "ParameterGroup", name=required(child, "name"), parameters=[_param(one) for one in inner])
    return made(child, "ParameterEntry", name=required(child, "name"), value=value_of(child))


_KINDS = frozenset({"auto", "yaml", *TYPES, *(f"list_of_{name}" for name in TYPES)})


def value_of(child: Entity) -> Any:
    """The value of a parameter: a text that is read as YAML once it is known, unless its type is said."""
    found = child.attributes.get("value")
    kind = child.attributes.get("type", "auto")
    if found is None:
        raise LaunchError("attribute", "value", f"<{child.name}> has no attribute `value`")
    if kind not in _KINDS:
        raise LaunchError("attribute", "type", f"`{kind}` is no type of parameters: these are {', '.join(sorted(_KINDS))}")
    if isinstance(found, list):
        substituted = any("$(" in one for one in found if isinstance(one, str))
        return [_item(one, kind, child) for one in found] if substituted else found
    if not isinstance(found, str) or (child.typed and "$(" not in found):
        if not isinstance(found, dict) and not is_of(found, kind):
            raise LaunchError("parameter", str(found), f"{found!r} is no {kind}")
        return found
    separator = child.attributes.get("value-sep")
    if separator:
        return [_typed(part, kind, child) for part in found.split(separator)]
    if kind == "auto" and not child.typed and found and yaml_value(found) is None:  # also one that begins a comment
        raise LaunchError("parameter", found, f"`{found}` is neither a scalar nor a list of one type")
    if kind in TYPES and kind != "str" and "$(" not in found:
        return converted(found, TYPES[kind])  # as the file is read, whether or not the node is started
    return _typed(found, kind, child)


def _item(found: Any, kind: str, child: Entity) -> Any:
    """An item of a list of YAML, some of which have substitutions."""
    if isinstance(found, str):
        return _typed(found, kind if "$(" in found else "str", child)
    return Made("ParameterValue", {"value": found}, child.place)


def _typed(found: str, kind: str, child: Entity) -> Any:
    return Made("ParameterValue", {"value": parsed(found, child.place), "value_type": kind}, child.place)
