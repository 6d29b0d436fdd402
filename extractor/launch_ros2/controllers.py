"""Controllers that controller managers load when they are asked to: each is a node, in the manager's process.

A spawner, or `ros2 control load_controller`, asks for them by name. The parameter `NAME.type` of the manager says which class a controller
is; its parameters are what the manager's process is given for it. A simulator's plug-in makes a manager, too, as a robot's description has
it. Source: ros2_control (controller_manager.cpp, spawner.py, ros2controlcli), gz_ros2_control and gazebo_ros2_control, Humble to Rolling.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from rosarch.extractor.launch.model import (
    Condition,
    ControllerAsked,
    LaunchError,
    NodeStart,
    ParamSetting,
    ParamsGiven,
    Place,
    ProcessSetting,
    Remap,
    exclusive,
)
from rosarch.extractor.launch.names import canonical, ns_join
from rosarch.extractor.launch_ros2.context import Context, Given
from rosarch.extractor.launch_ros2.parameters import Setting, Unread, settings
from rosarch.extractor.launch_ros2.params_files import ALL, matches

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World

_PACKAGE, _MANAGER = "controller_manager", "ros2_control_node"
_MANAGERS = frozenset({(_PACKAGE, _MANAGER), ("ur_robot_driver", "ur_ros2_control_node")})
"""Programs whose node is called like the package where no launch file names it."""
_SPAWNERS = ("spawner", "spawner.py")
_LOAD = ["ros2", "control", "load_controller"]
_WITH_VALUE = re.compile(
    r"-[cnpt]|--(controller-manager|namespace|param-file|controller-type|controller-ros-args|set-state|spin-time|[\w-]*timeout)"
)
"""Options that a word follows which is no controller."""
_SIMULATED = re.compile(r"(lib)?(gz|ign|gazebo)_ros2_control(-system)?(\.so)?")


@dataclass(frozen=True)
class Asked:
    """The manager called `manager` (absolute) is asked for controllers, at the last of `lines`.

    `options` are those of the command line; `process` is what a spawner is given, `files` are the files of it.
    """

    manager: str
    controllers: tuple[str, ...]
    options: tuple[tuple[str, str], ...]
    lines: tuple[Place, ...]
    conditions: tuple[Condition, ...]
    held: tuple[Condition, ...]
    process: tuple[ProcessSetting, ...] = ()
    files: tuple[ParamsGiven, ...] = ()

    def is_known(self, world: World, managers: Iterable[NodeStart], context: Context) -> bool:
        """Whether all names are known, and all files that it and the managers are given were read."""
        files = self.values("-p", "--param-file")
        if any(map(world.state.unknowns.is_open, (self.manager, *self.controllers, *files))):
            return False
        if not all(map(world.state.files.is_file, files)):  # to read one that is missing would report it where no manager needs it
            return False
        process = (*self.process, *(one for manager in managers for one in manager.process))
        return all(one.read for one in (*process, *_of_files(world, files, self.lines, context)))

    def values(self, *names: str) -> list[str]:
        """What is given for an option, which has several names."""
        return [value for name, value in self.options if name in names]


def asked_by_spawner(world: World, node: NodeStart, words: Sequence[str]) -> None:
    """Note what a node asks for, if it is a spawner; one that no launch file gives a name calls itself after its first controller."""
    if node.package == _PACKAGE and node.type in _SPAWNERS:
        names, options, manager = _read(words, node.namespace)
        if node.name is None and names:
            world.state.nodes[world.state.nodes.index(node)] = replace(node, calls_itself=f"spawner_{names[0]}")
        world.controllers.append(Asked(manager, names, options, node.lines, node.conditions, node.held, node.process, node.params_files))


def asked_by_command(world: World, words: Sequence[str], context: Context) -> None:
    """Note what a command asks for, if it loads controllers; of a shell it may be one text."""
    words = [part for word in words for part in word.split()]
    if words[: len(_LOAD)] == _LOAD:
        names, options, manager = _read(words[len(_LOAD) :], "/")
        world.controllers.append(Asked(manager, names, options, (*context.lines, world.state.here), context.conditions, context.held))


def _read(words: Sequence[str], namespace: str) -> tuple[tuple[str, ...], tuple[tuple[str, str], ...], str]:
    """The names and options of a command line, and the manager that it is for."""
    names: list[str] = []
    options: list[tuple[str, str]] = []
    rest = list(words)
    while rest:
        word, joined, value = rest.pop(0).partition("=")
        if _WITH_VALUE.fullmatch(word) and (joined or rest):
            options.append((word, value if joined else rest.pop(0)))
        elif not word.startswith("-"):
            names.append(word)
    space = next((value for name, value in options if name in ("-n", "--namespace")), namespace).strip("/")
    named = next((value for name, value in options if name in ("-c", "--controller-manager")), _PACKAGE)
    return tuple(names), tuple(options), canonical(ns_join(f"/{space}/" if space else "/", named))


def controllers(world: World, context: Context) -> Iterator[NodeStart]:
    """The controllers that are loaded, and the managers that simulators make; those of which the class is not known are left out."""
    if not world.controllers:
        return
    asked_for = {asked.manager for asked in world.controllers}
    managers = [node for node in map(_by_its_own_name, world.state.nodes) if node.full_name in asked_for]
    made: dict[str, NodeStart] = {}
    for one in _simulated(world, context):  # others than the simulator may have the description, too, with arguments of their own
        made.setdefault(one.full_name, one)
    simulated = [one for name, one in made.items() if name not in {node.full_name for node in managers}]
    yield from simulated
    found: dict[tuple[str, tuple[Condition, ...]], NodeStart] = {}
    for asked in world.controllers:
        able = [one for one in (*managers, *simulated) if one.full_name == asked.manager]
        if not asked.conditions and asked.is_known(world, able, context):
            place = asked.lines[-1]
            world.state.controllers_asked += [ControllerAsked(name, asked.manager, place) for name in asked.controllers]
        for manager in (one for one in able if not exclusive(one.conditions, asked.conditions)):
            for name in asked.controllers:
                for node in _controller(world, name, manager, asked, context):
                    found.setdefault((node.full_name, node.conditions), node)
    yield from found.values()


def _by_its_own_name(node: NodeStart) -> NodeStart:
    """A manager that no launch file gives a name has that of its code."""
    return replace(node, called=_PACKAGE) if node.name is None and (node.package, node.type) in _MANAGERS else node


def _controller(world: World, name: str, manager: NodeStart, asked: Asked, context: Context) -> Iterator[NodeStart]:
    own = replace(manager, name=name, called=name)
    files = [*asked.values("-p", "--param-file"), *_texts(manager, f"{name}.params_file")]
    process = (*manager.process, *_of_files(world, files, asked.lines, context))
    types = [*asked.values("-t", "--controller-type"), *_texts(manager, f"{name}.type"), *_texts(replace(own, process=process), "type")]
    if not types:  # Rolling gives on what spawners are given
        process = (*process, *asked.process)
        types = _texts(replace(own, process=process), "type")
    if len(set(types)) != 1 or any(map(world.state.unknowns.is_open, (name, *types))):
        return
    given = {one.setting.name: one.setting for one in process if one.read and matches(one.nodes, own.full_name)}
    clock = [one.setting for one in manager.process if one.setting.name == "use_sim_time" and matches(one.nodes, manager.full_name)]
    params = {**{setting.name: setting for setting in clock}, **given}  # the manager gives its clock on
    yield NodeStart(
        package=_package_of(world, types[0]),
        type=types[0],
        name=name,
        namespace=manager.namespace,
        lines=asked.lines,
        remaps=(*_rules(asked), *manager.remaps),
        conditions=tuple(dict.fromkeys((*manager.conditions, *asked.conditions))),
        held=tuple(dict.fromkeys((*manager.held, *asked.held))),
        ros=2,
        environment=manager.environment,
        called=name,
        container=manager.full_name,
        is_controller=True,
        params_files=(*manager.params_files, *asked.files),
        own_params=tuple(replace(setting, name=f"{own.full_name}/{setting.name}") for setting in params.values()),
    )


def _package_of(world: World, controller: str) -> str:
    """The package of a class: most names begin with it."""
    first = re.split(r"/|::", controller)[0]
    packages = world.state.files.packages
    return first if packages.find(first) else packages.describing(controller) or first


def _texts(node: NodeStart, name: str) -> list[str]:
    """The text that a parameter of a node is: the last that is set for it, if nothing is open about it."""
    found = [one.setting for one in node.process if one.read and one.setting.name == name and matches(one.nodes, node.full_name)]
    always = found and set(found[-1].conditions) <= set(node.conditions)
    return [found[-1].value] if always and isinstance(found[-1].value, str) else []


def _rules(asked: Asked) -> Iterator[Remap]:
    """The remappings of `--controller-ros-args`."""
    for text in asked.values("--controller-ros-args"):
        for rule in re.findall(r"(?:-r|--remap)\s+(\S+)", text):
            source, assigned, target = rule.partition(":=")
            if assigned:
                yield Remap(source.replace("~/", "~"), target, asked.lines[-1])


def _of_files(world: World, files: Sequence[str], lines: tuple[Place, ...], context: Context) -> Iterator[ProcessSetting]:
    """What files of parameters set for nodes; of one that cannot be read that is not known."""
    for file in files:
        try:
            for found in settings(world, Given(file, lines[-1]), None, context):
                if isinstance(found, Setting):
                    matches(found.nodes, "/")  # may be too long
                    setting = ParamSetting(
                        found.name, found.value, (*lines[:-1], found.place), found.conditions, found.source, found.written
                    )
                    yield ProcessSetting(found.nodes, setting)
                elif isinstance(found, Unread):
                    yield _unread(file, lines)
        except LaunchError:
            yield _unread(file, lines)


def _unread(file: str, lines: tuple[Place, ...]) -> ProcessSetting:
    return ProcessSetting(ALL, ParamSetting("", None, lines, source=file), read=False)


def _simulated(world: World, context: Context) -> Iterator[NodeStart]:
    """The managers that plug-ins of simulators make, as descriptions of robots and worlds have them."""
    described = [plugin for robot in world.described.values() if robot for plugin in robot.plugins]
    worlds = [plugin for one in world.state.worlds.values() for plugin in one.plugins]
    for plugin in dict.fromkeys((*described, *worlds)):
        if not _SIMULATED.fullmatch(plugin.filename.rpartition("/")[2]):
            continue
        elements = dict(plugin.elements)
        files = [text.strip() for name, text in plugin.elements if name == "parameters"]
        rules = [
            text.strip().partition(":=") for name, text in plugin.elements if name in ("ros/remapping", "ros/argument") and ":=" in text
        ]
        name = elements.get("controller_manager_name", elements.get("controller_manager_node_name", _PACKAGE))
        space = elements.get("ros/namespace", elements.get("namespace", "")).strip("/")
        node = NodeStart(
            package=_PACKAGE,
            type=_MANAGER,
            name=name,
            namespace=f"/{space}/" if space else "/",
            lines=(plugin.place,),
            remaps=tuple(Remap(source.replace("~/", "~"), target, plugin.place) for source, _, target in rules),
            ros=2,
            called=name,
        )
        process = tuple(_of_files(world, files, (plugin.place,), context))
        own = tuple(
            replace(one.setting, name=f"{node.full_name}/{one.setting.name}")
            for one in process
            if one.read and matches(one.nodes, node.full_name)
        )
        yield replace(node, process=process, own_params=own)
