"""A composition as rows of `rules/schema/launch.dl`."""

from __future__ import annotations

import json
import os
import re
from collections import Counter
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.base.files import path_text
from rosarch.extractor.launch.arguments import NodeArguments, node_arguments
from rosarch.extractor.launch.bridges import Bridged, files_of, of_arguments, unread_of_arguments
from rosarch.extractor.launch.model import (
    ActionLeftOut,
    ArgumentDeclared,
    ArgumentLeaked,
    ArgumentUsed,
    ComponentNamed,
    Composition,
    FileMeant,
    FileNamed,
    HomePath,
    Misjoined,
    NodeStart,
    PackageNamed,
    ParamSetting,
    Place,
    ProgramNamed,
    Reference,
    SubstitutionUsed,
    TextTested,
)
from rosarch.extractor.launch.names import canonical, global_namespace, ns_join
from rosarch.extractor.launch.record import plain
from rosarch.extractor.launch.values import Binary, automatic

if TYPE_CHECKING:
    from rosarch.extractor.launch.views import View
    from rosarch.extractor.urdf.plugins import SimulatorPlugin
    from rosarch.extractor.urdf.robots import Robot

Rows = dict[str, set[tuple[Any, ...]]]
_LONG = 4096  # characters of a value; a robot's description is no name of anything
_DOMAIN = "ROS_DOMAIN_ID"


def launch_rows(composition: Composition, root: Path) -> Rows:
    """The rows of a composition; paths below `root` are relative to it."""
    return _Writer(root).write(composition)


_OF_FILES = ("file", "outside", "unreadable", "params-file", "list-without-type")
"""The kinds of problems whose subject is a file."""


class _Writer:
    """Collects rows. Places become facts of their own where they are named."""

    def __init__(self, root: Path) -> None:
        self.root = os.path.abspath(root)
        self.rows: Rows = {}

    def write(self, composition: Composition) -> Rows:
        nodes = dict(starts(composition))
        views = {view.path: view for view in composition.views}
        bridges = {file.path: file for file in composition.bridges}
        for start, node in nodes.items():
            self.node(start, node)
            for view in (views[word] for word in node_arguments(node).plain if word in views):
                self.view(start, view)
            for entry in (*of_arguments(node), *(entry for path in files_of(node) if path in bridges for entry in bridges[path].entries)):
                self.bridged(start, entry)
            for refused in (one for path in files_of(node) if path in bridges for one in bridges[path].refused):
                self.add("bridge_refused", start, self.place(refused.place), refused.message)
                if refused.meant:
                    self.add("launch_meant", self.place(refused.place), refused.message, refused.written, refused.meant)
            for unread in (*unread_of_arguments(node), *(path for path in files_of(node) if path not in bridges)):
                self.add("bridge_unread", start, self.path(unread))
            if node.first:
                first = next(other for other, one in nodes.items() if one.lines == node.first and one.full_name == node.full_name)
                self.add("started_again", start, first)
        for setting in composition.params:
            self.param(setting)
        for setting in composition.unread:
            self.add("params_unread", setting.name, self.place(setting.place))
        for declared in composition.declared:
            self.declared(declared)
        for include in composition.includes:
            place = include.lines[-1]
            self.add("included", self.place(place), self.path(place.path), self.path(include.file) if include.file else "")
            if include.passes_all:
                self.add("included_with_all", self.place(place))
        for passed in composition.passed:
            self.add("argument_passed", self.place(passed.include), passed.name, passed.value, self.place(passed.place))
        for remap in composition.remaps:
            row = (self.place(remap.place), self.path(remap.place.path), canonical(remap.source), canonical(remap.target))
            self.add("remap_written", *row)
        robots = {setting.robot: None for setting in composition.params if setting.robot}
        numbers = {robot: number for number, robot in enumerate(robots)}
        for setting in composition.params:
            if setting.robot:
                self.add("robot_described", setting.name, f"{numbers[setting.robot]}:0", "whole" if setting.robot.is_whole else "in part")
        for robot, number in numbers.items():
            self.robot(robot, number)
        described = [plugin for setting in composition.params for plugin in setting.plugins]
        for plugin in dict.fromkeys((*described, *(plugin for world in composition.worlds for plugin in world.plugins))):
            self.plugin(plugin)
        for robot, number in numbers.items():
            for plugin in robot.plugins:
                self.add("plugin_of_robot", self.plugin_key(plugin), f"{number}:0")
        for problem in composition.problems:
            effect = "refused" if problem.fatal else "warned"
            subject = self.path(problem.subject) if problem.kind in _OF_FILES else problem.subject
            message = problem.message.replace(self.root + os.sep, "")  # places are shown relative to the workspace: so are paths in texts
            self.add("launch_problem", self.place(problem.place), problem.kind, subject, message, effect)
            if problem.meant is not None:
                self.add("launch_meant", self.place(problem.place), message, *problem.meant)
            if problem.kind == "package":
                self.reference(PackageNamed(problem.subject, None, problem.place))
        for command in composition.commands:
            self.add("commands_run", self.place(command))
        for reference in composition.references:
            self.reference(reference)
        for asked in composition.controllers_asked:
            self.add("controller_asked", self.place(asked.place), asked.name, asked.manager)
        for one in composition.hardware:
            self.add("hardware_interface", one.kind, one.owner, one.name, self.place(one.place))
            self.add("hardware_driver", one.plugin)
            self.add("hardware_driver_at", one.plugin, self.place(one.driver))
        if composition.hardware_unseen:
            self.add("hardware_unseen")
        return self.rows

    def add(self, relation: str, *row: Any) -> None:
        self.rows.setdefault(relation, set()).add(row)

    def path(self, path: str) -> str:
        """`path` relative to the root when it is below it."""
        return path_below(self.root, path)

    def place(self, place: Place) -> str:
        """The key of a place, which becomes a row."""
        key = self.key(place)
        self.add("place", key, self.path(place.path), place.line, place.column)
        return key

    def key(self, place: Place) -> str:
        """The key of a place."""
        return f"{self.path(place.path)}:{place.line}:{place.column}"

    def node(self, start: str, node: NodeStart) -> None:
        """A node, with what its command line says."""
        arguments = node_arguments(node)
        namespace, name = _names(node, arguments)
        self.add("started", start, node.package, node.type)
        self.add("started_name", start, name, namespace)
        self.add("started_version", start, node.ros)
        if node.name is None:
            self.add("started_unnamed", start)
        if node.inside is not None:
            self.add("started_inside", start, node.inside)
        if _DOMAIN in dict(node.environment):
            self.add("started_domain", start, dict(node.environment)[_DOMAIN])
        if node.container is not None:
            self.add("controlled_by" if node.is_controller else "loaded_into", start, node.container)
        for depth, place in enumerate(node.lines):
            self.add("started_at", start, depth, self.place(place))
        for condition in node.conditions:
            self.add("started_if", start, str(condition))
        for remap in node.own_remaps:
            self.add("started_remap", start, canonical(remap.source), canonical(remap.target), self.place(remap.place))
            if remap.only is not None:
                self.add("started_remap_only", start, canonical(remap.source), canonical(remap.target), remap.only)
        for file in node.params_files:
            self.add("params_given", start, self.path(file.path))
            for section in file.sections:
                self.add("params_section", self.path(file.path), section.nodes, section.expression, self.place(section.place))
        here = self.place(node.lines[-1])
        for source, target in arguments.remaps:
            self.add("started_remap", start, canonical(source), canonical(target), here)
        for index, word in enumerate(arguments.plain, 1):
            self.add("started_argument", start, index, word)
        for param, text in arguments.params:
            self.add("param_set", ns_join(name, param), *kind_and_text(automatic(text)), here)

    def param(self, setting: ParamSetting) -> None:
        """A parameter's value."""
        place = self.place(setting.place)
        self.add("param_set", setting.name, *kind_and_text(setting.value), place)
        if isinstance(setting.value, list) and all(isinstance(item, str) for item in setting.value):
            for index, item in enumerate(setting.value):
                self.add("param_item", setting.name, index, item, place)
        for index, item in enumerate(setting.value) if isinstance(setting.value, list) else ():
            for key, text in item.items() if isinstance(item, dict) else ():
                if isinstance(text, str):
                    self.add("param_entry", setting.name, f"{index}/{key}", text, place)
        for condition in setting.conditions:
            self.add("param_set_if", setting.name, str(condition))
        if setting.source:
            self.add("param_source", setting.name, place, self.path(setting.source))

    def robot(self, robot: Robot, number: int) -> None:
        """The elements of a robot description."""
        for index, part in enumerate(robot.parts):
            self.add("robot_element", f"{number}:{index}", f"{number}:{part.within}", part.tag, self.place(part.place))
            for name, text in part.attributes:
                self.add("robot_attribute", f"{number}:{index}", name, text)

    def plugin_key(self, plugin: SimulatorPlugin) -> str:
        """What stands for a plug-in in facts."""
        return f"{self.place(plugin.place)}:{plugin.name}:{plugin.reference or plugin.sensor or ''}"

    def plugin(self, plugin: SimulatorPlugin) -> None:
        """A plug-in of a robot or a world; two of one place differ in their elements."""
        place = self.place(plugin.place)
        key = self.plugin_key(plugin)
        self.add("simulated_plugin", key, library_name(plugin.filename), place)
        self.add("plugin_called", key, plugin.name)
        for element, text in plugin.elements:
            self.add("plugin_element", key, element, text)
        for (element, _), at in zip(plugin.elements, plugin.places, strict=False):
            self.add("plugin_element_at", key, element, self.place(at))

    def view(self, start: str, view: View) -> None:
        """What a viewer shows by its configuration."""
        self.add("view_given", start, self.path(view.path))
        if view.frame is not None:
            self.add("view_frame", start, view.frame[0], self.place(view.at or view.frame[1]))
        for part in view.parts:
            self.add("view_part", start, part.role, part.class_name, self.place(view.at or part.place))
            for topic in part.topics:
                place = self.place(view.at or topic.place)
                port = f"{start}#{self.key(topic.place)}"
                self.add("view_topic", start, port, part.class_name, topic.property)
                self.add("interface_port", start, port, "publisher" if part.role == "tool" else "subscriber", topic.name)
                self.add("interface_port_at", port, place)
                for policy, setting in topic.qualities:
                    self.add("interface_port_quality", port, policy, setting)

    def bridged(self, start: str, entry: Bridged) -> None:
        """What a bridge passes on, as its arguments or its configuration say."""
        place = self.place(entry.place)
        package, _, name = entry.type.partition("/")
        for kind in entry.kinds:
            port = f"{start}#{place}#{entry.name}#{kind}"
            self.add("bridge_port", start, port)
            self.add("interface_port", start, port, kind, entry.name)
            self.add("interface_port_type", port, f"{package}/{name.rpartition('/')[2]}")
            self.add("interface_port_at", port, place)
            if entry.way == "both":
                self.add("interface_port_conditional", port, "the other side has it")

    def declared(self, argument: ArgumentDeclared) -> None:
        """An argument that a launch file declares."""
        given = "value" if argument.value is not None else "default" if argument.default is not None else ""
        text = argument.value if argument.value is not None else argument.default or ""
        self.add("argument_declared", self.path(argument.path), argument.name, given, text, self.place(argument.place))

    def reference(self, named: Reference) -> None:
        """What the text of an element names."""
        place = self.place(named.place)
        match named:
            case FileNamed():
                self.add("file_named", place, named.role, self.path(named.file))
                if named.absent:
                    self.add("file_absent", self.path(named.file))
            case FileMeant():
                self.add("file_meant", place, named.role, self.path(named.file))
                if named.absent:
                    self.add("file_absent", self.path(named.file))
                if named.made:
                    self.add("file_made", self.path(named.file))
                if named.beside is not None:
                    self.add("file_beside", self.path(named.file), self.path(named.beside))
            case TextTested():
                self.add("text_tested", place, named.name)
            case ArgumentLeaked():
                self.add("argument_leaked", place, named.name, named.value, self.place(named.origin))
            case ActionLeftOut():
                self.add("action_left_out", place, named.action, named.name)
            case Misjoined():
                self.add("launch_misjoined", place, named.what)
            case SubstitutionUsed():
                self.add("substitution_used", place, named.name, named.effect)
            case ProgramNamed():
                self.add("program_named", place, named.package, named.type)
                if named.mentioned:
                    self.add("program_mentioned", named.package, named.type)
            case ComponentNamed():
                self.add("component_named", place, named.package, named.plugin)
                if named.mentioned:
                    self.add("component_mentioned", named.package, named.plugin)
            case PackageNamed():
                self.add("package_named", place, named.package)
                if named.folder is not None:
                    inside = f"{os.path.abspath(named.folder)}{os.sep}".startswith(self.root + os.sep)
                    self.add("package_found", named.package, "workspace" if inside else "path")
            case ArgumentUsed():
                self.add("argument_used", place, named.name)
            case HomePath():
                self.add("home_path", place, named.element, named.path)


def starts(composition: Composition) -> Iterator[tuple[str, NodeStart]]:
    """The nodes, each with what rows call it, its name or what distinguishes it from others of that name."""
    names: Counter[str] = Counter()
    for node in composition.nodes:
        name = _names(node, node_arguments(node))[1]
        names[name] += 1
        yield name if names[name] == 1 else f"{name}#{names[name]}", node


def _names(node: NodeStart, arguments: NodeArguments) -> tuple[str, str]:
    """Namespace and full name."""
    namespace = canonical(global_namespace(arguments.namespace)) if arguments.namespace else canonical(node.namespace) or "/"
    return namespace, ns_join(namespace, node.name or node.called or "")


@lru_cache(maxsize=4096)
def path_below(root: str, path: str) -> str:
    """`path` relative to the folder when it is below it."""
    full = os.path.abspath(path)
    return path_text(Path(os.path.relpath(full, root))) if full.startswith(root + os.sep) else path_text(Path(full))


_UNKNOWN = re.compile(r"\$\([^()]*\)?")


def kind_and_text(value: Any) -> tuple[str, str]:
    """The kind of a parameter's value and its text, lists and maps as JSON; long texts are cut."""
    if isinstance(value, bool):
        return "bool", "true" if value else "false"
    if isinstance(value, (int, float)):
        return ("int" if isinstance(value, int) else "double"), str(value)
    if value is None:
        return "none", ""
    if isinstance(value, Binary):
        return "binary", ""
    if isinstance(value, (list, dict)):
        return ("list" if isinstance(value, list) else "map"), json.dumps(plain(value))[:_LONG]
    text = str(value)
    return ("unknown" if _UNKNOWN.search(text) else "string"), text[:_LONG]


def library_name(filename: str) -> str:
    """The file of a plug-in's library: simulators add what is missing."""
    name = os.path.basename(filename.strip())
    return f"{'' if name.startswith('lib') else 'lib'}{name}{'' if name.endswith('.so') else '.so'}"


def started(composition: Composition) -> Iterator[tuple[str, str, tuple[str, ...]]]:
    """Package, executable and plain arguments of each node: what is to be analysed to know its interface."""
    for node in composition.nodes:
        yield node.package, node.type, node_arguments(node).plain
