"""The nodes of a process: what their code calls them where no launch file does, and what of a command line is for which of them.

Source: rcl. A name, a namespace, parameters and remappings of a command line are for all nodes of the process, unless a prefix (`node:`) or
the section of a file says for which; launch_ros passes a name only where a launch file gives one.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

from rosarch.extractor.launch.model import Composition, NodeStart, ParamSetting
from rosarch.extractor.launch.names import canonical
from rosarch.extractor.launch.scope import settle
from rosarch.extractor.launch_ros2.params_files import ALL, matches
from rosarch.models.component import ComponentModel


def with_nodes(
    composition: Composition,
    models: Mapping[tuple[str, str], Sequence[ComponentModel]],
    names: Mapping[tuple[str, str], str] = MappingProxyType({}),
) -> Composition:
    """The composition, in which a process starts the nodes that it makes, by the names that these have then.

    `models` are those of the nodes of each program or class, by package and by the name that launch files know it by; `names` those that
    other programs give their node.
    """
    nodes: list[NodeStart] = []
    changed: list[tuple[NodeStart, list[_Made]]] = []
    moved: dict[str, str] = {}
    for start in composition.nodes:
        program = (start.package, start.type)
        made = [_made(start, model) for model in models.get(program, ())]
        if not made and program in names:
            made = [_called(start, names[program])]
        nodes += [one.node for one in made] or [start]
        if start.given and made:
            changed.append((start, made))
        elif len(made) == 1 and made[0].node.namespace != start.namespace:
            moved[f"{start.full_name}/"] = f"{made[0].node.full_name}/"
    nodes += _of_drivers(composition, nodes, models)
    composition = replace(composition, params=tuple(_moved(setting, moved) for setting in composition.params))
    return _with_settings(replace(composition, nodes=tuple(nodes)), changed)


def _of_drivers(
    composition: Composition, nodes: Sequence[NodeStart], models: Mapping[tuple[str, str], Sequence[ComponentModel]]
) -> Iterator[NodeStart]:
    """The nodes that drivers of hardware make in the process of the manager that loads them, where one alone is started.

    Source: ros2_control (resource_manager.cpp). Misses: drivers beside several managers, and beside one that a launch file names: all nodes
    of its process get that name.
    """
    managers = {node.container for node in nodes if node.is_controller}
    there = [node for node in nodes if node.full_name in managers]
    if len(there) != 1 or there[0].name is not None:
        return
    manager = replace(there[0], args="", given=(), params_files=(), own_params=(), first=(), calls_itself=None)
    for plugin in dict.fromkeys(one.plugin for one in composition.hardware):
        found = [(package, model) for (package, type_), made in models.items() if type_ == plugin for model in made]
        if len(found) == 1 and found[0][1].node_name and found[0][1].ports:
            package, name = found[0][0], found[0][1].node_name
            yield replace(manager, package=package, type=plugin, called=name, container=manager.full_name, is_controller=True)


def with_inner(composition: Composition, made: Mapping[tuple[str, str], Mapping[str, str]]) -> tuple[Composition, Mapping[int, str]]:
    """The composition with the nodes that programs of the library make in their processes, and the component of each, by its index.

    `made` are their names in the namespaces of the nodes that make them, each with its component (`PACKAGE/COMPONENT`), by package and name
    of the program or class.
    """
    nodes = list(composition.nodes)
    components: dict[int, str] = {}
    params: list[ParamSetting] = []
    for start in composition.nodes:
        for path, component in made.get((start.package, start.type), {}).items():
            space, _, name = f"{start.namespace}{path}".rpartition("/")
            node = replace(start, name=name, called=name, namespace=f"{space}/", inside=start.namespace)
            node = replace(node, container=None, first=(), given=(), own_params=())
            components[len(nodes)] = component
            nodes.append(node)
            given = process_settings(composition, start, node.full_name)
            params += [replace(setting, name=f"{node.full_name}/{name}") for name, setting in given.items()]
    return replace(composition, nodes=tuple(nodes), params=(*composition.params, *params)), components


def process_settings(composition: Composition, node: NodeStart, name: str) -> dict[str, ParamSetting]:
    """What the process of a node sets for another one of its nodes, by its full name: for each parameter what is set last.

    The process is that of its container, if that is started here.
    """
    process = node
    if node.container is not None:
        process = next((each for each in composition.nodes if each.full_name == node.container), node)
    return {one.setting.name: one.setting for one in process.process if one.read and matches(one.nodes, name)}


@dataclass(frozen=True)
class _Made:
    """A node of a process; it is `named` when its name is known."""

    node: NodeStart
    named: bool

    def settings(self) -> Iterator[ParamSetting]:
        """What is set for it, in order."""
        for one in self.node.given:
            if one.read and matches(one.nodes, self.node.full_name):
                yield replace(one.setting, name=canonical(f"{self.node.full_name}/{one.setting.name}"))

    def unread(self) -> Iterator[ParamSetting]:
        """What may be set for it, too."""
        for one in self.node.given:
            if not one.read or not (self.named or one.nodes == ALL):
                yield replace(one.setting, name=self.node.full_name)


def _made(start: NodeStart, model: ComponentModel) -> _Made:
    """The node of a process that a model is of."""
    if model.executable:
        start = replace(start, type=model.component)
    return _called(_in_namespace(start, model), model.node_name)


def _called(start: NodeStart, name: str | None) -> _Made:
    """The node of a process that its code calls `name`."""
    if start.name is not None or start.called is None:
        return _Made(start, named=True)
    return _Made(start, named=False) if name is None else _Made(replace(start, called=_renamed(start, name)), named=True)


def _in_namespace(start: NodeStart, model: ComponentModel) -> NodeStart:
    """The node in the namespace that its code says, where no launch file starts it in another."""
    said = {str(trait.values[1]) for trait in model.traits if trait.name == "node_namespace"}
    if start.ros == 1 or start.namespace != "/" or len(said) != 1:
        return start
    return replace(start, namespace=f"{canonical('/' + said.pop())}/")


def _moved(setting: ParamSetting, moved: Mapping[str, str]) -> ParamSetting:
    """What is set for a node that a launch file gives a name only, in the namespace that the node is in."""
    for old, new in moved.items():
        if setting.name.startswith(old):
            return replace(setting, name=new + setting.name.removeprefix(old))
    return setting


def _renamed(start: NodeStart, name: str) -> str:
    """What a node becomes by a rule for the node that its code calls `name`."""
    return next((remap.target for remap in start.remaps if remap.source == "__node" and remap.node == name), name)


def _with_settings(composition: Composition, changed: Sequence[tuple[NodeStart, list[_Made]]]) -> Composition:
    """The composition, in which what was set for processes by the names that they may have is set for their nodes."""
    guesses = [_Made(start, named=True) for start, _ in changed]
    guessed = {(setting.name, setting.lines) for one in guesses for setting in (*one.settings(), *one.unread())}
    params: dict[str, list[ParamSetting]] = {}
    for setting in composition.params:
        if (setting.name, setting.lines) not in guessed:
            params.setdefault(setting.name, []).append(setting)
    nodes = [one for _, made in changed for one in made]
    for setting in (setting for one in nodes for setting in one.settings()):
        settle(params, setting)
    unread = [setting for setting in composition.unread if (setting.name, setting.lines) not in guessed]
    unread += [setting for one in nodes for setting in one.unread()]
    return replace(composition, params=tuple(itertools.chain.from_iterable(params.values())), unread=tuple(unread))
