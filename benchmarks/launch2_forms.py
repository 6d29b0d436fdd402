"""Launch files as XML, YAML and Python: what `launch2_random.py` makes up, written."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any
from xml.sax.saxutils import quoteattr

PACKAGE = "random_launch"
HEAD = """import os
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import *
from launch.event_handlers import *
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import ComposableNode, Parameter, ParameterFile, ParameterValue
from launch_ros.substitutions import FindPackageShare
from launch_ros.substitutions import Parameter as ParameterOf

HERE = os.path.dirname(__file__)
started = {}


def keep(name, action):
    started[name] = action
    return action


"""


@dataclass
class Part:
    """A substitution, or a text: its kind, its arguments."""

    kind: str
    arguments: list[list[Part]] = field(default_factory=list)
    text: str = ""


Text = list[Part]


@dataclass
class Action:
    """An action or a part of one: the name of its element, its attributes and what is within it."""

    name: str
    attributes: dict[str, Any] = field(default_factory=dict)
    children: list[Action] = field(default_factory=list)
    condition: tuple[str, Text] | None = None


def written(kind: str, actions: list[Action]) -> str:
    """A launch file with these actions: in XML, YAML or Python."""
    if kind == "xml":
        return f"<launch>\n{as_xml(actions)}</launch>\n"
    if kind == "yaml":
        return json.dumps({"launch": as_yaml(actions)}, indent=1) + "\n"
    entities = ",\n        ".join(map(python_action, actions))
    return f"{HEAD}def generate_launch_description():\n    return LaunchDescription([\n        {entities},\n    ])\n"


# -- as text of the front ends


def as_text(text: Text, *, inside: bool = False) -> str:
    """A text with `$(...)`; `inside` another one, where spaces end an argument."""
    return "".join(_part_text(part, inside) for part in text)


def _part_text(part: Part, inside: bool) -> str:
    if part.kind == "text":
        return part.text
    if part.kind == "find":
        return f"$(find-pkg-share {PACKAGE})"
    if part.kind in ("dirname", "filename"):
        return f"$({part.kind})"
    if part.kind in ("eval", "command"):
        quote = "`" if inside else '"'
        more = "".join(f" {as_text(argument)}" for argument in part.arguments[1:])
        return f"$({part.kind} {quote}{as_text(part.arguments[0])}{quote}{more})".replace("`", '"')
    return f"$({part.kind} {' '.join(as_text(argument, inside=True) for argument in part.arguments)})"


def attributes_of(action: Action) -> dict[str, Any]:
    """The attributes of an element; texts, Booleans, numbers and lists."""
    found: dict[str, Any] = {}
    for name, value in action.attributes.items():
        if name in ("keep", "arguments", "params", "remaps", "choices", "key", "plain", "path", "substitutions") or value is None:
            continue
        if name == "args":
            found["args"] = " ".join(map(as_text, value))
        else:
            found[name] = as_text(value) if isinstance(value, list) and all(isinstance(part, Part) for part in value) else value
    if action.name in ("node", "node_container", "composable_node"):
        found["pkg"] = PACKAGE
    if "plain" in action.attributes:
        found["value"] = action.attributes["plain"]
    if action.condition is not None and action.condition[0] in ("if", "unless"):
        found[action.condition[0]] = as_text(action.condition[1])
    return found


def inner_of(action: Action) -> Iterator[tuple[str, dict[str, Any], list[Action]]]:
    """The elements within an element that are no actions."""
    given = action.attributes
    for name, value in given.get("keep") or ():
        yield "keep", {"name": name, "value": as_text(value)}, []
    for name, value in given.get("arguments") or ():
        yield "arg", {"name": name, "value": as_text(value)}, []
    for choice in given.get("choices") or ():
        yield "choice", {"value": choice}, []
    for source, target in given.get("remaps") or ():
        yield "remap", {"from": as_text(source), "to": as_text(target)}, []
    for one in given.get("params") or ():
        if one.name == "file":
            more = {} if one.attributes["substitutions"] is None else {"allow_substs": one.attributes["substitutions"]}
            yield "param", {"from": as_text(one.attributes["path"]), **more}, []
        else:
            yield "param", attributes_of(one), one.children


def as_xml(actions: list[Action], indent: str = "  ") -> str:
    """Elements of XML."""
    return "".join(_element(action.name, attributes_of(action), [*inner_of(action)], action.children, indent) for action in actions)


def _element(
    name: str, attributes: dict[str, Any], inner: list[tuple[str, dict[str, Any], list[Action]]], children: list[Action], indent: str
) -> str:
    written = "".join(f" {key}={quoteattr(_xml_value(value))}" for key, value in attributes.items() if not isinstance(value, list))
    for key, value in attributes.items():
        if isinstance(value, list):  # of plain values
            written += f' {key}={quoteattr(";".join(map(_xml_value, value)))} value-sep=";"'
    deeper = indent + "  "
    body = "".join(_element(tag, given, [], below, deeper) for tag, given, below in inner) + as_xml(children, deeper)
    return f"{indent}<{name}{written}>\n{body}{indent}</{name}>\n" if body else f"{indent}<{name}{written}/>\n"


def _xml_value(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def as_yaml(actions: list[Action]) -> list[dict[str, Any]]:
    """Elements of YAML."""
    return [{action.name: _map(action)} for action in actions]


def _map(action: Action) -> dict[str, Any]:
    found = attributes_of(action)
    for name, attributes, below in inner_of(action):
        found.setdefault(name, []).append({**attributes, **({"param": [_map(one) for one in below]} if below else {})})
    if action.name in ("node_container", "load_composable_node"):
        found["composable_node"] = [_map(one) for one in action.children]
    elif action.children:
        found["children"] = as_yaml(action.children)
    return found


# -- as Python

_CLASSES = {
    "var": "LaunchConfiguration", "env": "EnvironmentVariable", "not": "NotSubstitution", "and": "AndSubstitution", "or": "OrSubstitution",
    "equals": "EqualsSubstitution", "not-equals": "NotEqualsSubstitution", "if": "IfElseSubstitution",
    "eval": "PythonExpression", "command": "Command", "all": "AllSubstitution", "any": "AnySubstitution", "file-content": "FileContent",
    "find-exec": "FindExecutable", "param": "ParameterOf",
}  # fmt: skip


_KEYWORDS = {
    "env": ("", "default_value="),
    "var": ("", "default="),
    "param": ("", "default="),
    "eval": ("", "python_modules="),
    "find-exec": ("name=",),
}


def as_python(text: Text) -> str:
    """A text as an expression."""
    parts = [_part_python(part) for part in text]
    return parts[0] if len(parts) == 1 else f"[{', '.join(parts)}]"


def _part_python(part: Part) -> str:
    if part.kind == "text":
        return repr(part.text)
    if part.kind == "find":
        return f"FindPackageShare({PACKAGE!r})"
    if part.kind in ("dirname", "filename"):
        return "HERE" if part.kind == "dirname" else "ThisLaunchFile()"
    arguments = [as_python(argument) for argument in part.arguments]
    if part.kind in _KEYWORDS:
        arguments = [f"{keyword}{argument}" for keyword, argument in zip(_KEYWORDS[part.kind], arguments, strict=False)]
    return f"{_CLASSES[part.kind]}({', '.join(arguments)})"


def python_action(action: Action) -> str:
    """An action as an expression."""
    made = _PYTHON[action.name](action)
    if action.condition is None:
        return made
    kind, text = action.condition
    if kind in ("if", "unless"):
        condition = f"{kind.capitalize()}Condition({as_python(text)})"
    else:
        asked, wanted = text
        name = "LaunchConfigurationEquals" if kind == "equals" else "LaunchConfigurationNotEquals"
        condition = f"{name}({as_python(asked.arguments[0])}, {as_python([wanted])})"
    closing = "))" if made.startswith("keep(") else ")"
    call = made.removesuffix(closing)
    return f"{call}{'' if call.endswith('(') else ', '}condition={condition}{closing}"


def _listed(actions: list[Action]) -> str:
    return f"[{', '.join(map(python_action, actions))}]"


def _pairs(pairs: list[tuple[str, Text]]) -> str:
    return f"[{', '.join(f'({name!r}, {as_python(value)})' for name, value in pairs)}]"


def _between(kind: str, action: Action) -> str:
    return f"GroupAction([Push{kind}(), *{_listed(action.children)}, Pop{kind}()], scoped=False)"


def _words(action: Action) -> str | None:
    words = action.attributes["args"]
    return f"[{', '.join(map(as_python, words))}]" if words else None


def _call(kind: str, **arguments: str | None) -> str:
    return f"{kind}({', '.join(f'{name}={value}' for name, value in arguments.items() if value is not None)})"


def _optional(value: Text | None) -> str | None:
    return None if value is None else as_python(value)


def _given(given: Action) -> str:
    if given.name == "file":
        allow = given.attributes["substitutions"]
        path = as_python(given.attributes["path"])
        return f"ParameterFile({path}, allow_substs={allow})" if allow is not None else path
    return f"{{{_entry(given)}}}"


def _entry(given: Action) -> str:
    name, value = given.attributes["name"], given.attributes
    if given.children:
        return f"{name!r}: {{{', '.join(map(_entry, given.children))}}}"
    return f"{name!r}: ParameterValue({_value(given)}, value_type={value['type']})" if "type" in value else f"{name!r}: {_value(given)}"


def _value(action: Action) -> str:
    given = action.attributes
    return repr(given["plain"]) if "plain" in given else as_python(given["value"])


def _python_node(action: Action, kind: str, **more: str | None) -> str:
    given = action.attributes
    params = f"[{', '.join(map(_given, given['params']))}]" if given["params"] else None
    remaps = (
        f"[{', '.join(f'({as_python(source)}, {as_python(target)})' for source, target in given['remaps'])}]" if given["remaps"] else None
    )
    return _call(
        kind,
        package=repr(PACKAGE),
        name=_optional(given["name"]),
        namespace=_optional(given["namespace"]),
        parameters=params,
        remappings=remaps,
        **more,
    )


def _kept(action: Action, made: str) -> str:
    return f"keep({action.attributes['key']!r}, {made})"


def _event(action: Action) -> str:
    handler = f"{action.attributes['kind']}(target_action=started.get({action.attributes['target']!r}) or (lambda action: False), "
    given = {"OnProcessExit": "on_exit", "OnProcessStart": "on_start", "OnExecutionComplete": "on_completion"}[action.attributes["kind"]]
    handler += f"{given}={_listed(action.children)})"
    return f"RegisterEventHandler({handler})"


def _opaque(action: Action) -> str:
    asked = action.attributes["asked"]
    inner = f"lambda context: {_listed(action.children)}"
    if asked is not None:
        inner += f" if LaunchConfiguration({asked!r}, default='').perform(context) != 'x' else []"
    return f"OpaqueFunction(function={inner})"


_PYTHON: dict[str, Callable[[Action], str]] = {
    "arg": lambda one: _call(
        "DeclareLaunchArgument", name=repr(one.attributes["name"]), default_value=_optional(one.attributes["default"]),
        choices=repr(one.attributes["choices"]) if one.attributes["choices"] else None,
    ),
    "let": lambda one: f"SetLaunchConfiguration({one.attributes['name']!r}, {as_python(one.attributes['value'])})",
    "group": lambda one: _call(
        "GroupAction", actions=_listed(one.children),
        scoped=None if one.attributes["scoped"] is None else str(one.attributes["scoped"]),
        forwarding=None if one.attributes["forwarding"] is None else str(one.attributes["forwarding"]),
        launch_configurations=f"dict({_pairs(one.attributes['keep'])})" if one.attributes["keep"] else None,
    ),
    "push_ros_namespace": lambda one: f"PushRosNamespace({as_python(one.attributes['namespace'])})",
    "set_remap": lambda one: f"SetRemap({as_python(one.attributes['from'])}, {as_python(one.attributes['to'])})",
    "set_parameter": lambda one: f"SetParameter({one.attributes['name']!r}, {_value(one)})",
    "set_use_sim_time": lambda one: f"SetUseSimTime({one.attributes['value'].capitalize()})",
    "set_parameters_from_file": lambda one: f"SetParametersFromFile({as_python(one.attributes['filename'])})",
    "set_env": lambda one: f"SetEnvironmentVariable({one.attributes['name']!r}, {as_python(one.attributes['value'])})",
    "append_env": lambda one: _call(
        "AppendEnvironmentVariable", name=repr(one.attributes["name"]), value=as_python(one.attributes["value"]),
        prepend=None if one.attributes["prepend"] is None else str(one.attributes["prepend"]),
    ),
    "unset_env": lambda one: f"UnsetEnvironmentVariable({one.attributes['name']!r})",
    "include": lambda one: _call(
        "IncludeLaunchDescription", launch_description_source=f"AnyLaunchDescriptionSource({as_python(one.attributes['file'])})",
        launch_arguments=_pairs(one.attributes["arguments"]),
    ),
    "timer": lambda one: f"TimerAction(period={one.attributes['period']}, actions={_listed(one.children)})",
    "ros_timer": lambda one: f"ROSTimer(period={one.attributes['period']}, actions={_listed(one.children)})",
    "log": lambda one: f"LogInfo(msg={as_python(one.attributes['message'])})",
    "reset": lambda one: f"ResetLaunchConfigurations(dict({_pairs(one.attributes['keep'])}))",
    "reset_env": lambda one: "ResetEnvironment()",
    "set_ros_log_dir": lambda one: f"SetROSLogDir({as_python(one.attributes['new_log_dir'])})",
    "shutdown": lambda one: f"Shutdown(reason={as_python(one.attributes['reason'])})",
    "unset": lambda one: f"UnsetLaunchConfiguration({one.attributes['name']!r})",
    "configurations": lambda one: _between("LaunchConfigurations", one),
    "environments": lambda one: _between("Environment", one),
    "executable": lambda one: f"ExecuteProcess(cmd=[{as_python(one.attributes['cmd'])}])",
    "event": _event,
    "opaque": _opaque,
    "node": lambda one: _kept(one, _python_node(
        one, "Node", executable=repr(one.attributes["exec"]), arguments=_words(one)
    )),
    "lifecycle_node": lambda one: _kept(one, _python_node(
        one, "LifecycleNode", executable=repr(one.attributes["exec"]), arguments=_words(one),
        autostart=None if one.attributes["autostart"] is None else str(one.attributes["autostart"]),
    )),
    "composable_node": lambda one: _python_node(one, "ComposableNode", plugin=repr(one.attributes["plugin"])),
    "node_container": lambda one: _kept(one, _python_node(
        one, "ComposableNodeContainer", executable="'component_container'", composable_node_descriptions=_listed(one.children)
    )),
    "load_composable_node": lambda one: _call(
        "LoadComposableNodes", target_container=as_python(one.attributes["target"]), composable_node_descriptions=_listed(one.children)
    ),
}  # fmt: skip
