"""From launch files to a `Composition`: groups, includes, and what goes on when something is rejected.

The steps and their order are those of roslaunch.xmlloader, so that the first problem is the one roslaunch stops at. Here composition goes
on: an element that is rejected costs that element, a value that is absent stays unknown.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from rosarch.base.xml_reader import XmlError
from rosarch.extractor.launch import elements, nodes
from rosarch.extractor.launch.bridges import read_files
from rosarch.extractor.launch.controllers import controllers_of_spawners
from rosarch.extractor.launch.descriptions import note_worlds
from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.meant import files_meant, meshes_meant, parts_meant
from rosarch.extractor.launch.model import (
    ArgumentDeclared,
    Composition,
    Condition,
    Include,
    LaunchError,
    NodeStart,
    ParamSetting,
    Place,
    Reference,
    Remap,
)
from rosarch.extractor.launch.names import global_namespace
from rosarch.extractor.launch.scope import Scope
from rosarch.extractor.launch.state import Exhausted, Handler, State
from rosarch.extractor.launch.unknowns import cleaned
from rosarch.extractor.launch.views import views_of
from rosarch.extractor.launch.xml_reader import Element, read_launch
from rosarch.extractor.urdf.plugins import SimulatorPlugin
from rosarch.extractor.urdf.robots import Robot

MAX_INCLUDE_DEPTH = 60
MAX_INCLUDES = 20_000


def compose(
    launch_files: Sequence[Path | str],
    arguments: Mapping[str, str] | None = None,
    *,
    files: Files,
    environment: Mapping[str, str] | None = None,
    namespace: str | None = None,
) -> Composition:
    """What roslaunch would make of `launch_files`, loaded one after the other.

    Args:
        launch_files: the files given to roslaunch.
        arguments: values of their arguments (`name:=value` of the command line).
        files: reads files and knows the packages.
        environment: the environment variables that `$(env)` and `$(optenv)` see.
        namespace: `__ns:=` of the command line; otherwise `ROS_NAMESPACE` counts.
    """
    variables = environment or {}
    state = State(files, variables)
    root = global_namespace(namespace if namespace is not None else variables.get("ROS_NAMESPACE") or "/")
    values = {name: cleaned(value) for name, value in (arguments or {}).items()}
    files.allow_named(values)
    for path in launch_files:
        _Composer(state).top(str(path), Scope(namespace=root, filename=str(path), args=dict(values)))
    composition = finished(state, itertools.chain.from_iterable(map(files.references, state.read)))
    return replace(composition, references=tuple(dict.fromkeys((*composition.references, *files_meant(composition, files.packages)))))


class _Composer:
    """Processes one launch file given, with all that it includes."""

    def __init__(self, state: State) -> None:
        self.state = state
        self.stack: list[tuple[str, str, frozenset[tuple[str, str]]]] = []
        self.handlers: dict[str, Handler] = {
            "arg": elements.arg,
            "group": self.group,
            "node": nodes.node,
            "test": nodes.test,
            "param": elements.param,
            "remap": lambda state, element, scope: elements.remap(state, element, scope, scope),
            "machine": elements.machine,
            "rosparam": elements.rosparam,
            "include": self.include,
            "env": elements.env,
            "master": lambda state, element, scope: state.warn("master", "master", "<master> is ignored"),
        }

    def top(self, path: str, scope: Scope) -> None:
        """Compose a file that was given."""
        state = self.state
        state.here, state.scope = Place(path, 1), scope
        state.files.allow_beside(path)
        try:
            launch = self.parse(path)
            if launch is not None:
                self.enter_file(path, launch, scope)
        except (Exhausted, RecursionError) as error:
            reason = str(error) if isinstance(error, Exhausted) else "elements and includes nested too deeply, the rest is left out"
            state.report(LaunchError("size", path, reason))

    def parse(self, path: str) -> Element | None:
        """The `<launch>` of a file; None, with a report, when it cannot be read."""
        try:
            launch = self.state.files.parsed(path, read_launch)
        except LaunchError as error:
            self.state.report_unread(error)
            return None
        except XmlError as error:
            self.state.report(LaunchError("xml", path, error.message), place=Place(path, error.line, error.column))
            return None
        self.state.read.setdefault(path)
        return launch

    def enter_file(self, path: str, launch: Element, scope: Scope) -> None:
        """Compose the content of a file, unless that would never end."""
        key = (self.state.files.real(path), scope.namespace, frozenset(scope.args.items()))
        if key in self.stack:
            raise LaunchError("cycle", path, f"{path} includes itself")
        if len(self.stack) >= MAX_INCLUDE_DEPTH:
            raise LaunchError("cycle", path, f"includes nested more than {MAX_INCLUDE_DEPTH} deep")
        self.stack.append(key)
        try:
            self.check_launch(path, launch, scope)
            if launch.attributes.get("deprecated"):
                self.state.warn("deprecated", path, f"{path} is deprecated: {launch.attributes['deprecated']}")
            self.content(launch, scope)
        finally:
            self.stack.pop()

    def check_launch(self, path: str, launch: Element, scope: Scope) -> None:
        """Report an `if` of `<launch>` itself: roslaunch evaluates it, without arguments, but leaves nothing out."""
        self.state.here = Place(path, launch.line, launch.column)
        if any("$" in launch.attributes.get(name, "") for name in ("if", "unless")):
            self.state.report(LaunchError("condition", "launch", "a condition of <launch> must not have substitution arguments"))
            return
        try:
            self.state.conditions(launch, scope)
        except LaunchError as error:
            self.state.report(error)

    def content(self, parent: Element, scope: Scope) -> None:
        """Compose the children of a `<launch>` or `<group>`."""
        for element in parent.children:
            self.state.enter(element, scope)
            handler = self.handlers.get(element.tag)
            try:
                if handler is None:
                    self.state.ignore(element, parent)
                else:
                    handler(self.state, element, scope)
            except LaunchError as error:
                self.state.report(error)

    def group(self, state: State, element: Element, scope: Scope) -> None:
        """`<group>`: a scope of its own."""
        conditions = state.conditions(element, scope)
        if conditions is None:
            return
        state.check_attributes(element, ("ns", "clear_params"))
        inner = nodes.namespace_of(state, element, scope, conditions)
        inner.private = list(inner.private)
        self.content(element, inner)

    def include(self, state: State, element: Element, scope: Scope) -> None:
        """`<include>`: another launch file, with the arguments it is passed."""
        conditions = state.conditions(element, scope)
        if conditions is None:
            return
        state.check_attributes(element, ("file", "ns", "clear_params", "pass_all_args"))
        path = state.required(element, "file", scope)
        if len(state.includes) >= MAX_INCLUDES:
            raise Exhausted(f"more than {MAX_INCLUDES} includes, the rest is left out")
        inner, here = self.passed(element, scope, conditions), state.here
        inner.filename, inner.lines = path, (*scope.lines, here)
        launch = None if state.unknowns.is_open(path) else self.parse(path)
        state.includes.append(Include(path, path if launch else None, inner.lines, inner.conditions, inner.passes_all))
        if launch is None:
            return
        names = list(inner.args)
        self.enter_file(path, launch, inner)
        state.at(element, scope, conditions)
        unused = [name for name in names if name not in inner.declared]
        if unused and not inner.passes_all:
            raise LaunchError("unused-args", ", ".join(unused), f"{path} does not declare what is passed to it: {', '.join(unused)}")

    def passed(self, element: Element, scope: Scope, conditions: tuple[Condition, ...]) -> Scope:
        """The scope for an included file, with the arguments that are passed to it."""
        state = self.state
        passes_all = state.flag(state.text(element, "pass_all_args", scope), "pass_all_args")
        inner = nodes.namespace_of(state, element, scope, conditions)
        passed = dict(scope.args) if passes_all else {}
        inner.declared, inner.passes_all = set(passed), passes_all
        state.include = state.here
        for child in element.children:
            state.enter(child, inner)
            try:
                if child.tag.lower() == "arg":
                    elements.arg(state, child, inner, passed)
                elif child.tag.lower() == "env":
                    elements.env(state, child, inner)
                else:
                    state.ignore(child, element)
            except LaunchError as error:
                state.report(error)
        state.at(element, scope, conditions)
        for name in sorted(inner.declared - set(passed)):
            state.report(LaunchError("arg-without-value", name, f"argument `{name}` is passed without a value"))
        note_worlds(state, passed.values(), scope.lines, scope.conditions)
        inner.args, inner.declared, inner.maybe_declared, inner.anonymous = passed, set(), {}, {}
        return inner


def finished(state: State, references: Iterable[Reference]) -> Composition:
    """The result, with unknown parts of texts as the source writes them."""
    shown = state.unknowns.render
    nodes = tuple(_rendered_node(node, state) for node in state.nodes)
    params = tuple(_rendered_param(setting, state) for settings in state.params.values() for setting in settings)
    return Composition(
        nodes=nodes,
        tests=tuple(_rendered_node(node, state) for node in state.tests),
        controllers=(*(_rendered_node(node, state) for node in state.controllers), *controllers_of_spawners(nodes, params)),
        controllers_asked=tuple(state.controllers_asked),
        hardware=tuple(state.hardware),
        hardware_unseen=state.hardware_unseen,
        params=params,
        includes=tuple(replace(include, text=shown(include.text)) for include in state.includes),
        problems=tuple(state.problems),
        files=tuple(state.read),
        cleared=tuple(dict.fromkeys(state.cleared)),
        deleted=tuple(dict.fromkeys(state.deleted)),
        unread=tuple(_rendered_param(setting, state) for setting in state.unread),
        declared=tuple(_rendered_declaration(argument, state) for argument in state.declared),
        passed=tuple(replace(argument, name=shown(argument.name), value=shown(argument.value)) for argument in state.passed),
        remaps=tuple(_rendered_remap(remap, state) for remap in state.remaps),
        worlds=tuple(state.worlds.values()),
        views=views_of(state, nodes),
        bridges=read_files(state, nodes),
        commands=tuple(state.commands),
        references=(*references, *meshes_meant(state.meshes, state.files.packages), *parts_meant(state.parts, state.files.packages)),
    )


def _shown(text: str | None, state: State) -> str | None:
    return None if text is None else state.unknowns.render(text)


def _rendered_declaration(argument: ArgumentDeclared, state: State) -> ArgumentDeclared:
    shown = state.unknowns.render
    value, default = _shown(argument.value, state), _shown(argument.default, state)
    return replace(argument, path=shown(argument.path), name=shown(argument.name), value=value, default=default)


def _rendered_remap(remap: Remap, state: State) -> Remap:
    shown = state.unknowns.render
    return replace(remap, source=shown(remap.source), target=shown(remap.target), node=_shown(remap.node, state))


def _rendered_param(setting: ParamSetting, state: State) -> ParamSetting:
    shown = state.unknowns.render
    source = None if setting.source is None else shown(setting.source)
    robot = setting.robot and _rendered_robot(setting.robot, state)
    return replace(setting, name=shown(setting.name), value=_rendered(setting.value, state), source=source, robot=robot)


def _rendered_robot(robot: Robot, state: State) -> Robot:
    shown = state.unknowns.render
    parts = tuple(replace(part, attributes=tuple((name, shown(text)) for name, text in part.attributes)) for part in robot.parts)
    return replace(robot, parts=parts, plugins=tuple(_rendered_plugin(plugin, state) for plugin in robot.plugins))


def _rendered_plugin(plugin: SimulatorPlugin, state: State) -> SimulatorPlugin:
    shown = state.unknowns.render
    return replace(
        plugin,
        filename=shown(plugin.filename),
        name=shown(plugin.name),
        reference=None if plugin.reference is None else shown(plugin.reference),
        sensor=None if plugin.sensor is None else shown(plugin.sensor),
        elements=tuple((name, shown(text)) for name, text in plugin.elements),
    )


def _rendered(value: Any, state: State) -> Any:
    if isinstance(value, str):
        return state.unknowns.render(value)
    if isinstance(value, list):
        return [_rendered(item, state) for item in value]
    if isinstance(value, dict):
        return {_rendered(key, state): _rendered(item, state) for key, item in value.items()}
    return value


def _rendered_node(node: NodeStart, state: State) -> NodeStart:
    shown = state.unknowns.render

    return replace(
        node,
        package=shown(node.package),
        type=shown(node.type),
        namespace=shown(node.namespace),
        args=shown(node.args),
        remaps=tuple(_rendered_remap(remap, state) for remap in node.remaps),
        environment=tuple((shown(name), shown(value)) for name, value in node.environment),
        name=_shown(node.name, state),
        machine=_shown(node.machine, state),
        output=_shown(node.output, state),
        cwd=_shown(node.cwd, state),
        launch_prefix=_shown(node.launch_prefix, state),
        test_name=_shown(node.test_name, state),
        called=_shown(node.called, state),
        container=_shown(node.container, state),
        own_params=tuple(_rendered_param(one, state) for one in node.own_params),
        given=tuple(replace(one, nodes=shown(one.nodes), setting=_rendered_param(one.setting, state)) for one in node.given),
    )
