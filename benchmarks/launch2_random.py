"""Write random launch files of ROS 2, for comparisons with the real launch.

    benchmarks/launch2_random.py FOLDER [--files N] [--seed N]

FOLDER gets a package with N launch files in turn in XML, YAML and Python, each with one that it includes: arguments,
configurations, groups, namespaces, remappings, parameters of all forms, environment, includes, nodes, containers, timers, conditions
and substitutions; in Python also event handlers and opaque functions. Now and then something is not declared, no Boolean or none of the
choices, which launch rejects.
"""

from __future__ import annotations

import argparse
import json
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

PACKAGE = "random_launch"
MANIFEST = (
    f"<package format='3'><name>{PACKAGE}</name><version>1.0.0</version><export><build_type>ament_cmake</build_type></export></package>\n"
)
PARAMETERS = """/**:
  ros__parameters: {shared: 1, rate: 2.5, flag: yes, text: 1e5}
""" + "".join(
    f"""namea{index}:
  ros__parameters: {{own: [1, 2], deep: {{er: x}}, p: {index}}}
/inner/namea{index}:
  ros__parameters: {{own: inner, rate: 1}}
/*/namei{index}:
  ros__parameters: {{star: 010, rate: 3}}
/**/namea{index + 20}:
  ros__parameters: {{stars: "on", shared: [x]}}
"""
    for index in range(0, 20, 2)
)
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

HERE = os.path.dirname(__file__)
started = {}


def keep(name, action):
    started[name] = action
    return action


"""
WORDS = ("x", "robot", "true", "false", "1", "0", "0.5", "y", "1e5", "007", "a.b", "-3", "True", "off")
VARIABLES = ("A", "B", "C")


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


class Writer:
    """Makes the actions of one launch file, whose arguments begin with `prefix`. `declared` are those that are there by then."""

    def __init__(self, rng: random.Random, prefix: str, included: str | None, *, python: bool) -> None:
        self.rng, self.prefix, self.included, self.python = rng, prefix, included, python
        self.declared: list[str] = []
        self.nodes = 0
        self.names = [f"name{prefix}{index}" for index in range(40)]
        rng.shuffle(self.names)

    def file(self) -> list[Action]:
        """All actions of a file."""
        found = [self.argument(f"{self.prefix}{index}") for index in range(self.rng.randint(1, 3))]
        return [*found, *self.actions(self.rng.randint(2, 5), 0)]

    def often(self, percent: float) -> bool:
        return self.rng.random() * 100 < percent

    # -- texts

    def word(self) -> Text:
        return [Part("text", text=self.rng.choice(WORDS))]

    def text(self, depth: int = 0) -> Text:
        """Any text."""
        found = self.word() if self.often(45) else [self.part(depth)]
        between = "/" if found[0].kind in ("find", "dirname") else self.rng.choice(("_", "/", "s"))  # a path ends there
        return [*found, Part("text", text=between), self.part(2)] if self.often(15) else found

    def part(self, depth: int) -> Part:
        kinds = ["var"] * 4 + ["env", "env_default", "find", "dirname", "eval", "command"] + (["if"] if depth < 2 else [])
        kind = self.rng.choice(kinds)
        if kind == "var" and self.declared:
            return self.variable()
        if kind == "env":
            return Part("env", [[Part("text", text="ROS_DISTRO")]])
        if kind == "env_default":
            return Part("env", [[Part("text", text=self.rng.choice(VARIABLES))], self.word()])
        if kind == "eval":
            return self.expression()
        if kind == "command":
            return Part("command", [[Part("text", text=f"echo {self.rng.choice(WORDS)}")]])
        if kind == "if":
            return Part("if", [self.truth(depth + 1), self.word(), self.word()])
        return Part(kind if kind in ("find", "dirname") else "text", text="word")

    def variable(self) -> Part:
        name = "undeclared" if self.often(1) else self.rng.choice(self.declared)
        return Part("var", [[Part("text", text=name)]])

    def expression(self) -> Part:
        left = [self.variable()] if self.declared and self.often(70) else self.word()
        operation = self.rng.choice((" == ", " != ", " + ", " in "))
        right = self.word()
        quote = Part("text", text="'")
        return Part("eval", [[quote, *left, quote, Part("text", text=operation), quote, *right, quote]])

    def truth(self, depth: int = 0) -> Text:
        """A text that is a Boolean, nearly always."""
        kind = self.rng.choice(("plain", "plain", "not", "and", "or", "equals", "not-equals", "eval"))
        if kind == "not" and depth < 2:
            return [Part("not", [self.truth(depth + 1)])]
        if kind in ("and", "or") and depth < 2:
            return [Part(kind, [self.truth(depth + 1), self.truth(depth + 1)])]
        if kind in ("equals", "not-equals"):
            return [Part(kind, [[self.variable()] if self.declared else self.word(), self.word()])]
        if kind == "eval" and self.declared:
            quote, name = Part("text", text="'"), self.variable()
            return [Part("eval", [[quote, name, quote, Part("text", text=self.rng.choice((" == ", " != "))), quote, *self.word(), quote]])]
        return [Part("text", text="maybe" if self.often(1) else self.rng.choice(("true", "false", "1", "0", "True", "FALSE")))]

    def condition(self) -> tuple[str, Text] | None:
        return (self.rng.choice(("if", "unless")), self.truth()) if self.often(25) else None

    # -- actions

    def actions(self, count: int, depth: int) -> list[Action]:
        return [self.action(depth) for _ in range(count)]

    def action(self, depth: int) -> Action:
        kinds = (
            ["node"] * 5 + ["let"] * 2 + ["namespace", "remap", "parameter", "sim_time", "from_file", "set_env", "append_env", "unset_env"]
        )
        kinds += ["container", "load", "executable"]
        if depth < 2:
            kinds += ["group"] * 4 + ["timer", "include"] + (["event", "opaque"] if self.python else [])
        made: Action = getattr(self, self.rng.choice(kinds))(depth)
        made.condition = self.condition()
        return made

    def argument(self, name: str) -> Action:
        default = self.text() if self.often(30) else self.word()
        choices = ["x", "robot", *(part.text for part in default if part.text and self.often(90))] if self.often(5) else None
        self.declared.append(name)
        return Action("arg", {"name": name, "default": default, "choices": choices})

    def let(self, _depth: int) -> Action:
        name = self.rng.choice([*self.declared, "fresh"])
        made = Action("let", {"name": name, "value": self.text()})
        if name not in self.declared and self.often(30):
            self.declared.append(name)  # though what sets it may be conditional
        return made

    def group(self, depth: int) -> Action:
        keep = [(name, self.word()) for name in self.rng.sample(self.declared, min(len(self.declared), self.rng.randint(0, 2)))]
        attributes = {
            "scoped": self.rng.choice((True, True, True, False, None)),
            "forwarding": self.rng.choice((True, True, True, None, None, False)),
            "keep": [(name, value) for name, value in keep if self.often(40)],
        }
        known = list(self.declared)
        if attributes["scoped"] is not False and attributes["forwarding"] is False:
            self.declared = [name for name, _ in attributes["keep"]]
        inner = self.actions(self.rng.randint(1, 4), depth + 1)
        self.declared = known
        return Action("group", attributes, inner)

    def namespace(self, _depth: int) -> Action:
        return Action("push_ros_namespace", {"namespace": [Part("text", text=self.rng.choice(("inner", "/outer", "a/b", "")))]})

    def remap(self, _depth: int) -> Action:
        return Action("set_remap", dict(zip(("from", "to"), self.renaming(), strict=True)))

    def renaming(self) -> tuple[Text, Text]:
        source = self.rng.choice(("in", "/in", "~/in", "out", "ns/out"))
        target = self.rng.choice(("here", "/there", "~/own"))
        return [Part("text", text=source)], [Part("text", text=target)]

    def parameter(self, _depth: int) -> Action:
        return Action("set_parameter", {"name": self.rng.choice(("p", "q", "deep.p")), "value": self.text()})

    def sim_time(self, _depth: int) -> Action:
        return Action("set_use_sim_time", {"value": self.rng.choice(("true", "false"))})

    def from_file(self, _depth: int) -> Action:
        return Action("set_parameters_from_file", {"filename": self.in_package("parameters.yaml")})

    def in_package(self, name: str) -> Text:
        return [Part(self.rng.choice(("find", "dirname"))), Part("text", text="/" + name)]

    def set_env(self, _depth: int) -> Action:
        return Action("set_env", {"name": self.rng.choice(VARIABLES), "value": self.text()})

    def append_env(self, _depth: int) -> Action:
        return Action(
            "append_env", {"name": self.rng.choice(VARIABLES), "value": self.word(), "prepend": self.rng.choice((True, False, None))}
        )

    def unset_env(self, _depth: int) -> Action:
        return Action("unset_env", {"name": self.rng.choice(VARIABLES)})

    def include(self, depth: int) -> Action:
        if self.included is None:
            return self.node(depth)
        passed = [(f"i{index}", self.text()) for index in range(3) if self.often(50)]
        return Action("include", {"file": self.in_package(self.included), "arguments": passed})

    def timer(self, depth: int) -> Action:
        return Action("timer", {"period": self.rng.choice((0.5, 1.0, 2.0))}, self.actions(self.rng.randint(1, 2), depth + 1))

    def executable(self, _depth: int) -> Action:
        return Action("executable", {"cmd": [Part("text", text="run "), *self.text(2)]})

    def event(self, depth: int) -> Action:
        target = f"node{self.rng.randrange(self.nodes)}" if self.nodes else None
        kind = self.rng.choice(("OnProcessStart", "OnProcessExit"))
        return Action("event", {"kind": kind, "target": target}, self.actions(self.rng.randint(1, 2), depth + 2))

    def opaque(self, depth: int) -> Action:
        return Action(
            "opaque", {"asked": self.rng.choice(self.declared) if self.declared else None}, self.actions(self.rng.randint(1, 2), depth + 1)
        )

    # -- nodes

    def node(self, _depth: int) -> Action:
        name = f"node{self.nodes}"
        self.nodes += 1
        arguments = [self.rng.choice((["--flag"], ["-x", "1"], ["--ros-args", "-p", "arg:=2", "--"], ["--ros-args", "-r", "a:=b"]))]
        program = f"program_{self.prefix}{self.nodes}"
        attributes = {**self.of_node(75), "exec": program, "key": name, "args": arguments[0] if self.often(20) else None}
        return Action("node", attributes)

    def of_node(self, named: float) -> dict[str, Any]:
        return {
            "name": [Part("text", text=self.names.pop())] if self.often(named) else None,
            "namespace": [Part("text", text=self.rng.choice(("inner", "/outer", "deep/er", "", "/")))] if self.often(30) else None,
            "params": [self.given() for _ in range(self.rng.choice((0, 0, 1, 2, 3)))],
            "remaps": [self.renaming() for _ in range(self.rng.choice((0, 0, 1, 2)))],
        }

    def given(self) -> Action:
        """A parameter of a node."""
        kind = self.rng.choice(("value", "value", "value", "number", "list", "file", "group", "typed"))
        name = self.rng.choice(("p", "rate", "shared", "list", "deep.er"))
        if kind == "file":
            return Action("file", {"path": self.in_package("parameters.yaml"), "substitutions": self.rng.choice((True, False, None))})
        if kind == "group":
            return Action("param", {"name": name}, [self.given_value("a"), self.given_value("b")])
        if kind == "number":
            return Action("param", {"name": name, "plain": self.rng.choice((1, 2.5, True, -4, 1e10))})
        if kind == "list":
            return Action("param", {"name": name, "plain": self.rng.choice(([1, 2], ["x", "y z"], [True, False], [0.5, 1.0]))})
        if kind == "typed":
            return Action("param", {"name": name, "value": self.word(), "type": "str"})
        return self.given_value(name)

    def given_value(self, name: str) -> Action:
        return Action("param", {"name": name, "value": self.text()})

    def components(self) -> list[Action]:
        found = []
        for _ in range(self.rng.randint(1, 3)):
            found.append(
                Action("composable_node", {**self.of_node(97), "plugin": f"random_launch::Class{len(found)}"}, condition=self.condition())
            )
        return found

    def container(self, _depth: int) -> Action:
        attributes = {**self.of_node(100), "exec": "component_container", "key": f"node{self.nodes}"}
        self.nodes += 1
        return Action("node_container", {**attributes, "namespace": attributes["namespace"] or [Part("text", text="")]}, self.components())

    def load(self, _depth: int) -> Action:
        return Action("load_composable_node", {"target": [Part("text", text=self.rng.choice(("/first", "second")))]}, self.components())


# -- as text of the front ends


def as_text(text: Text, *, inside: bool = False) -> str:
    """A text with `$(...)`; `inside` another one, where spaces end an argument."""
    return "".join(_part_text(part, inside) for part in text)


def _part_text(part: Part, inside: bool) -> str:
    if part.kind == "text":
        return part.text
    if part.kind == "find":
        return f"$(find-pkg-share {PACKAGE})"
    if part.kind == "dirname":
        return "$(dirname)"
    if part.kind in ("eval", "command"):
        quote = "`" if inside else '"'
        return f"$({part.kind} {quote}{as_text(part.arguments[0])}{quote})".replace("`", '"')
    return f"$({part.kind} {' '.join(as_text(argument, inside=True) for argument in part.arguments)})"


def attributes_of(action: Action) -> dict[str, Any]:
    """The attributes of an element; texts, Booleans, numbers and lists."""
    found: dict[str, Any] = {}
    for name, value in action.attributes.items():
        if name in ("keep", "arguments", "params", "remaps", "choices", "key", "plain", "path", "substitutions") or value is None:
            continue
        if name == "args":
            found["args"] = " ".join(value)
        else:
            found[name] = as_text(value) if isinstance(value, list) and all(isinstance(part, Part) for part in value) else value
    if action.name in ("node", "node_container", "composable_node"):
        found["pkg"] = PACKAGE
    if "plain" in action.attributes:
        found["value"] = action.attributes["plain"]
    if action.condition is not None:
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
    "eval": "PythonExpression", "command": "Command",
}  # fmt: skip


def as_python(text: Text) -> str:
    """A text as an expression."""
    parts = [_part_python(part) for part in text]
    return parts[0] if len(parts) == 1 else f"[{', '.join(parts)}]"


def _part_python(part: Part) -> str:
    if part.kind == "text":
        return repr(part.text)
    if part.kind == "find":
        return f"FindPackageShare({PACKAGE!r})"
    if part.kind == "dirname":
        return "HERE"
    arguments = [as_python(argument) for argument in part.arguments]
    if part.kind == "env" and len(arguments) > 1:
        arguments[1] = f"default_value={arguments[1]}"
    return f"{_CLASSES[part.kind]}({', '.join(arguments)})"


def python_action(action: Action) -> str:
    """An action as an expression."""
    made = _PYTHON[action.name](action)
    if action.condition is None:
        return made
    condition = f"{'If' if action.condition[0] == 'if' else 'Unless'}Condition({as_python(action.condition[1])})"
    return (
        made.removesuffix(")") + f", condition={condition})"
        if made.startswith("keep(") is False
        else made[:-2] + f", condition={condition}))"
    )


def _listed(actions: list[Action]) -> str:
    return f"[{', '.join(map(python_action, actions))}]"


def _pairs(pairs: list[tuple[str, Text]]) -> str:
    return f"[{', '.join(f'({name!r}, {as_python(value)})' for name, value in pairs)}]"


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
    if "plain" in value:
        return f"{name!r}: {value['plain']!r}"
    return (
        f"{name!r}: ParameterValue({as_python(value['value'])}, value_type=str)"
        if "type" in value
        else f"{name!r}: {as_python(value['value'])}"
    )


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
    handler += f"{'on_exit' if action.attributes['kind'].endswith('Exit') else 'on_start'}={_listed(action.children)})"
    return f"RegisterEventHandler({handler})"


def _opaque(action: Action) -> str:
    asked = action.attributes["asked"]
    inner = f"lambda context: {_listed(action.children)}"
    if asked is not None:
        inner += f" if LaunchConfiguration({asked!r}, default='').perform(context) != 'x' else []"
    return f"OpaqueFunction(function={inner})"


_PYTHON: dict[str, Callable[[Action], str]] = {
    "arg": lambda one: _call(
        "DeclareLaunchArgument", name=repr(one.attributes["name"]), default_value=as_python(one.attributes["default"]),
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
    "set_parameter": lambda one: f"SetParameter({one.attributes['name']!r}, {as_python(one.attributes['value'])})",
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
    "executable": lambda one: f"ExecuteProcess(cmd=[{as_python(one.attributes['cmd'])}])",
    "event": _event,
    "opaque": _opaque,
    "node": lambda one: _kept(one, _python_node(
        one, "Node", executable=repr(one.attributes["exec"]), arguments=repr(one.attributes["args"]) if one.attributes["args"] else None
    )),
    "composable_node": lambda one: _python_node(one, "ComposableNode", plugin=repr(one.attributes["plugin"])),
    "node_container": lambda one: _kept(one, _python_node(
        one, "ComposableNodeContainer", executable="'component_container'", composable_node_descriptions=_listed(one.children)
    )),
    "load_composable_node": lambda one: _call(
        "LoadComposableNodes", target_container=as_python(one.attributes["target"]), composable_node_descriptions=_listed(one.children)
    ),
}  # fmt: skip


def write(folder: Path, files: int, seed: int) -> None:
    """Write the package."""
    folder = folder / PACKAGE
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.xml").write_text(MANIFEST)
    (folder / "parameters.yaml").write_text(PARAMETERS)
    for index in range(files):
        for name, prefix, included in ((f"part{index}", "i", None), (f"random{index}", "a", f"part{index}")):
            rng = random.Random(f"{seed}/{name}")
            kinds = {"xml": ".launch.xml", "yaml": ".launch.yaml", "py": ".launch.py"}
            kind = rng.choice(tuple(kinds)) if included is None else tuple(kinds)[index % 3]
            if included is not None:
                found = next(path.name for path in folder.glob(f"{included}.*"))
                included = found
            actions = Writer(rng, prefix, included, python=kind == "py").file()
            (folder / f"{name}{kinds[kind] if included else kinds[kind].replace('.launch', '.part')}").write_text(_text(kind, actions))


def _text(kind: str, actions: list[Action]) -> str:
    if kind == "xml":
        return f"<launch>\n{as_xml(actions)}</launch>\n"
    if kind == "yaml":
        return json.dumps({"launch": as_yaml(actions)}, indent=1) + "\n"
    entities = ",\n        ".join(map(python_action, actions))
    return f"{HEAD}def generate_launch_description():\n    return LaunchDescription([\n        {entities},\n    ])\n"


def main() -> None:
    """Write launch files."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--files", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    write(options.folder, options.files, options.seed)


if __name__ == "__main__":
    main()
