"""The elements that set something: arg, param, rosparam, remap, env, machine."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any, TypeAlias

from rosarch.extractor.launch.commands import output, words_of
from rosarch.extractor.launch.descriptions import evaluated, robot_of_file
from rosarch.extractor.launch.model import ArgumentDeclared, ArgumentPassed, LaunchError, ParamSetting, Place, Remap
from rosarch.extractor.launch.names import canonical, ns_join
from rosarch.extractor.launch.scope import Scope
from rosarch.extractor.launch.state import YAML_COST, State
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch.values import Binary, convert
from rosarch.extractor.launch.xml_reader import Element
from rosarch.extractor.launch.yaml_values import YamlError, load_yaml
from rosarch.extractor.urdf.command import xacro_call
from rosarch.extractor.urdf.robots import Robot

_SUBSTITUTION = re.compile(r"^[^#\n]*?(\$\((?:arg|env|optenv|eval|anon) [^()\n]*\))", re.MULTILINE)
_VALUES = ("value", "textfile", "binfile", "command")


def arg(state: State, element: Element, scope: Scope, passed: dict[str, str] | None = None) -> None:
    """`<arg>`: declare an argument, or pass one to the file that is included (`passed`).

    Raises:
        LaunchError: it is rejected.
    """
    conditions = state.conditions(element, scope)
    if conditions is None:
        return
    state.check_attributes(element, ("name", "value", "default", "doc"))
    name = state.required(element, "name", scope)
    try:
        value, default, _doc = (state.text(element, key, scope) for key in ("value", "default", "doc"))
    except LaunchError:
        (scope.args if passed is None else passed).setdefault(name, state.unknowns.mark(f"$(arg {name})", scope.filename))  # declared it is
        raise
    if value is not None and default is not None:
        raise LaunchError("arg-value", name, f"argument `{name}` has both a value and a default")
    if passed is None:
        state.declared.append(ArgumentDeclared(scope.filename, name, value, default, state.here))
    elif value is not None or default is not None:
        state.passed.append(ArgumentPassed(name, default or "" if value is None else value, state.include, state.here))
    into = scope.args if passed is None else passed
    if conditions or name in scope.maybe_declared:
        # one of two alternatives: what it is set to depends on the condition, unless it was passed
        if value is not None or (default is not None and (name not in into or name in scope.maybe_declared)):
            into[name] = state.unknowns.mark(f"$(arg {name})", scope.filename, "alternatives")
        scope.declared.add(name)
        scope.maybe_declared[name] = conditions
        return
    scope.declare(name, value, default, into)


def param(state: State, element: Element, scope: Scope, *, private: bool = False) -> None:
    """`<param>`: set a parameter. With `private` (within a node), and for `~names`, it is set below the nodes of the scope.

    Raises:
        LaunchError: it is rejected.
    """
    conditions = state.conditions(element, scope)
    if conditions is None:
        return
    state.check_attributes(element, ("name", "type", *_VALUES))
    kind = (element.attributes.get("type") or "auto").lower().strip()
    texts = {key: state.text(element, key, scope) for key in _VALUES if key in element.attributes}
    if len(texts) != 1:
        raise LaunchError("param", "value", "<param> must have exactly one of value, textfile, binfile and command")
    if "name" not in element.attributes:
        raise LaunchError("attribute", "name", "<param> has no attribute `name`")
    name = state.resolver.resolve(element.attributes["name"].strip(), scope)
    ((source, text),) = texts.items()
    value, robot = _param_value(state, source, text or "", kind)
    setting = ParamSetting(
        name=canonical(name),
        value=value,
        lines=(*scope.lines, state.here),
        conditions=scope.conditions + conditions,
        source=text if source in ("textfile", "binfile") else None,
        robot=robot,
    )
    if private or name.startswith("~"):
        scope.add_private(setting)
    else:
        state.set_param(replace(setting, name=canonical(ns_join(scope.namespace, name))))


_Value: TypeAlias = tuple[Any, Robot | None]  # with what a robot description says


def _param_value(state: State, source: str, text: str, kind: str) -> _Value:
    if source == "value":
        return _converted(text.strip(), kind), None
    if source == "command":
        return _command_value(state, text, kind)
    if state.unknowns.is_open(text):
        return state.unknowns.mark(f"$({source} {state.unknowns.render(text)})", text), None
    try:
        if source == "binfile":
            return Binary(state.files.read(text)), None
        content = state.files.read_text(text)
        state.spend(len(content))
        robot = robot_of_file(state, text, content)
    except LaunchError as error:
        state.report_unread(error)
        return state.unknowns.mark(f"$({source} {text})"), None
    return _converted(content, kind), robot


def _command_value(state: State, command: str, kind: str) -> _Value:
    """What a command prints; it is not run, so most stay unknown."""
    words = words_of(command)
    unknown = state.unknowns.mark(f"$(command {state.unknowns.render(command)})", command)
    robot: Robot | None = None
    try:
        call = xacro_call(words)
        if call and not state.unknowns.is_open(call.file):
            printed, robot = evaluated(state, call)
            return (unknown, None) if printed is None else (_converted(printed, kind), robot)
        if state.unknowns.is_open(command):
            return unknown, None
        printed = output(words, state.files, state.resolver.environment)
        if printed is not None and len(words) == 2 and state.files.is_file(words[1]):
            robot = robot_of_file(state, words[1], printed)
    except LaunchError as error:
        if not error.is_limit:
            raise LaunchError("command", words[0], f"command `{words[0]}` would fail: {error.message}") from None
        printed = None
    if printed is None:
        state.warn("command", words[0], f"command `{words[0]}` is not run, what it prints is unknown")
        return unknown, None
    return _converted(printed, kind), robot


def _converted(text: str, kind: str) -> Any:
    try:
        return load_yaml(text) if kind == "yaml" and is_known(text) else convert(text, kind)
    except ValueError as error:
        raise LaunchError("param-type", kind, str(error)) from None
    except YamlError as error:
        raise LaunchError("yaml", "value", f"invalid YAML at line {error.line}, column {error.column}: {error.message}") from None


def rosparam(state: State, element: Element, scope: Scope) -> None:
    """`<rosparam>`: load parameters from YAML; `dump` and `delete` are only noted.

    Raises:
        LaunchError: it is rejected.
    """
    conditions = state.conditions(element, scope)
    if conditions is None:
        return
    state.check_attributes(element, ("command", "ns", "file", "param", "subst_value"))
    command, namespace, file, name, substitute = (
        state.text(element, key, scope) for key in ("command", "ns", "file", "param", "subst_value")
    )
    substituted = state.flag(substitute, "subst_value")
    name = ns_join(namespace or "", name or "")
    command = command or "load"
    if command not in ("load", "dump", "delete"):
        raise LaunchError("rosparam-command", command, f"<rosparam> has no command `{command}`; it is load, dump or delete")
    full_name = ns_join(scope.namespace, name) if name else scope.namespace
    if command == "delete":
        if file is not None:
            raise LaunchError("rosparam-delete", file, '<rosparam command="delete"> must not have a file')
        state.deleted.append(state.unknowns.render(full_name))
    elif command == "load":
        setting = ParamSetting(full_name, None, (*scope.lines, state.here), scope.conditions + conditions, file or None)
        text = element.text if file is None else _yaml_text(state, file)
        if text is None:
            state.unread.append(replace(setting, name=canonical(full_name)))
        else:
            if not substituted and (found := _SUBSTITUTION.search(text)):
                state.warn("literal", found[1], f'`{found[1]}` is taken as it is written: <rosparam> has no subst_value="true"')
            _load(state, element, state.resolver.resolve(text, scope) if substituted else text, name, setting)


def _yaml_text(state: State, file: str) -> str | None:
    """The text of a YAML file; None, with a report, when it cannot be read."""
    if state.unknowns.is_open(file):
        return None
    try:
        if not (state.files.is_file(file) or state.files.packages.makes(file)):
            raise LaunchError("file", file, f"no such file: {file}")
        return state.files.read_text(file)
    except LaunchError as error:
        state.report_unread(error)
        return None


def _load(state: State, element: Element, text: str, name: str, setting: ParamSetting) -> None:
    """Set what a YAML text says; `name` is empty when parameters go to the scope's namespace."""
    state.spend(YAML_COST * len(text))
    unread = replace(setting, name=canonical(setting.name))
    try:
        data, lines = state.files.yaml(text)
    except YamlError as error:
        if state.unknowns.is_open(text):
            state.unread.append(unread)
            return
        line = error.line if setting.source else element.line + error.line - 1
        path = setting.source or state.here.path
        message = f"invalid YAML at {path}:{line}:{error.column}: {error.message}"
        raise LaunchError("yaml", path, message) from None
    data = {} if data is None else data
    if not name and isinstance(data, str) and state.unknowns.is_open(data):
        state.unread.append(unread)  # it may be a map
        return
    if not name and not isinstance(data, dict):
        raise LaunchError("rosparam-name", "param", "YAML that is not a map needs an attribute `param`")
    first = Place(setting.source, 1) if setting.source else replace(state.here, line=element.line)

    def unfold(name: str, value: Any, keys: tuple[str, ...]) -> None:
        """Set a parameter per scalar and list; maps are namespaces."""
        if isinstance(value, dict):
            for key, item in value.items():
                if not isinstance(key, str):
                    raise LaunchError("yaml-key", str(key), f"the key `{key}` in YAML is not a text, which a parameter's name must be")
                unfold(ns_join(name, key), item, (*keys, key))
        elif name == "/":
            raise LaunchError("rosparam-name", "/", "only a map can be loaded into `/`")
        else:
            line = lines.get(keys)
            written = setting.written if line is None else replace(first, line=first.line + line - 1, column=1)
            state.set_param(replace(setting, name=canonical(name), value=value, written=written))

    unfold(setting.name, data, ())


def remap(state: State, element: Element, scope: Scope, into: Scope) -> None:
    """`<remap>`: rename for the nodes that follow in `into`.

    Raises:
        LaunchError: it is rejected.
    """
    conditions = state.conditions(element, scope)
    if conditions is None:
        return
    state.check_attributes(element, ("from", "to"))
    source, target = state.required(element, "from", scope), state.required(element, "to", scope)
    written = Remap(source, target, state.here, conditions)
    into.add_remap(written)
    state.remaps.append(written)


def env(state: State, element: Element, scope: Scope) -> None:
    """`<env>`: an environment variable for the nodes that follow.

    Raises:
        LaunchError: it is rejected.
    """
    conditions = state.conditions(element, scope)
    if conditions is None:
        return
    state.check_attributes(element, ("name", "value"))
    name, value = state.required(element, "name", scope), state.required(element, "value", scope)
    if not name:
        raise LaunchError("attribute", "name", "<env> has an empty name")
    scope.environment.append((name, value))


_MACHINE_ATTRIBUTES = ("name", "address", "env-loader", "ssh-port", "user", "password", "default", "timeout")


def machine(state: State, element: Element, scope: Scope) -> None:
    """`<machine>`: a computer that nodes can be started on.

    Raises:
        LaunchError: it is rejected.
    """
    conditions = state.conditions(element, scope)
    if conditions is None:
        return
    old = {name: state.text(element, name, scope) for name in ("ros-root", "ros-package-path", "ros-ip", "ros-hostname")}
    for name in filter(old.get, old):
        raise LaunchError("machine", name, f"<machine> has no attribute `{name}` since ROS Fuerte; use env-loader")
    state.check_attributes(element, _MACHINE_ATTRIBUTES)
    name, address = state.required(element, "name", scope), state.required(element, "address", scope)
    loader, port, user, password, default, timeout = (state.text(element, key, scope) for key in _MACHINE_ATTRIBUTES[2:])
    default = (default or "false").lower()
    if port and not port.strip().isdigit() and is_known(port):
        raise LaunchError("machine", "ssh-port", f"`{port}` is not a port number")
    if default not in ("true", "false", "never"):
        raise LaunchError("machine", "default", f"`{default}` is not true, false or never")
    for child in element.children:
        if child.tag == "env":
            raise LaunchError("machine", "env", "<env> in <machine> is not supported since ROS Fuerte; use env-loader")
        state.ignore(child, element)
    _check_positive(state, timeout, "timeout")
    content = (default != "never", address, loader, int(port or "22") if is_known(port or "") else port, user or None, password, timeout)
    if default == "true":
        state.default_machine = name
    if scope.conditions or conditions:
        return  # one of two alternatives, of which the other may declare it as well
    if state.machines.setdefault(name, content) != content:
        raise LaunchError("machine", name, f"machine `{name}` is declared twice, with different settings")


def _check_positive(state: State, number: str | None, label: str) -> None:
    if number is None or state.unknowns.is_open(number):
        return
    try:
        positive = float(number) > 0
    except ValueError:
        positive = False
    if not positive:
        raise LaunchError("number", label, f"`{number}` is not a positive number, which `{label}` must be")
