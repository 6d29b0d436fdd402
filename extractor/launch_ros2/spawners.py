"""Controllers of ros2_control: a spawner's command line says which ones a controller manager loads, each as a node of its own.

Source: controller_manager (spawner.py, controller_manager.cpp). The class of a controller is its own parameter `type` in a file that the
spawner is given, or the manager's parameter `<controller>.type`; spawners of ROS 2 Humble have it as an option. A controller is in the
namespace of its manager, and gets the files of the spawner; until ROS 2 Jazzy also what the manager's process is given for it.
"""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from rosarch.extractor.launch.arguments import node_arguments
from rosarch.extractor.launch.model import NodeStart, ParamSetting
from rosarch.extractor.launch.names import ns_join
from rosarch.extractor.launch_ros2.context import Context, Given
from rosarch.extractor.launch_ros2.params_files import matches
from rosarch.extractor.launch_ros2.ros_arguments import ros_arguments
from rosarch.extractor.launch_ros2.starts import for_node, with_parameters

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World

_SPAWNERS = {("controller_manager", "spawner"), ("controller_manager", "spawner.py")}
_MANAGERS = {("controller_manager", "ros2_control_node")}
_OPTIONS: Mapping[str, str] = {
    "-c": "manager", "--controller-manager": "manager", "-p": "file", "--param-file": "file", "-t": "class", "--controller-type": "class",
    "--controller-ros-args": "arguments", "--controller": "controller", "-n": "", "--namespace": "", "--controller-manager-timeout": "",
    "--switch-timeout": "", "--service-call-timeout": "",
}  # fmt: skip
"""Options that have a value, and what it is for."""


@dataclass
class _Asked:
    """What a spawner says of controllers: of those that are named after it, or of all."""

    files: list[str] = field(default_factory=list)
    arguments: list[str] = field(default_factory=list)
    type: str | None = None


@dataclass(frozen=True)
class Controller:
    """A controller that a spawner asks for, and what its node is given; `type` is None where the spawner does not say it."""

    name: str
    type: str | None
    params: tuple[Given, ...]
    arguments: tuple[str, ...]


def controllers(spawner: NodeStart) -> tuple[str, tuple[Controller, ...]]:
    """The (absolute) name of the manager that a spawner asks, and the controllers that it asks for; none when it is no spawner."""
    if (spawner.package, spawner.type) not in _SPAWNERS:
        return "", ()
    manager, general, own, names = "controller_manager", _Asked(), dict[str, _Asked](), list[str]()
    for option, value in _options(node_arguments(spawner).words):
        asked = own[names[-1]] if own else general
        if option == "manager":
            manager = value
        elif option == "controller":
            names.append(value)
            own[value] = _Asked()
        elif option == "file":
            asked.files.append(value)
        elif option == "class":
            asked.type = value
        elif option == "arguments":
            asked.arguments += shlex.split(value)
        elif option == "name":
            names.append(value)
    found = []
    for name in dict.fromkeys(names):
        both = (general, own.get(name, _Asked()))
        files = [Given(file, spawner.lines[-1]) for asked in both for file in asked.files]
        words = tuple(word for asked in both for word in asked.arguments)
        found.append(Controller(name, general.type, tuple(files), words))
    return manager if manager.startswith("/") else ns_join(spawner.namespace, manager), tuple(found)


def _options(words: tuple[str, ...]) -> Iterator[tuple[str, str]]:
    """What the words of a command line say: what it is for, and its value."""
    rest = list(words)
    while rest:
        word, equals, value = rest.pop(0).partition("=") if rest[0].startswith("--") else (rest.pop(0), "", "")
        if word in _OPTIONS:
            given = value if equals else rest.pop(0) if rest else ""
            yield _OPTIONS[word], given
        elif not word.startswith("-"):
            yield "name", word


def load_controllers(world: World) -> None:
    """Start the controllers that spawners ask for, as far as their classes are known; a spawner is called after its first one."""
    for number, spawner in list(enumerate(world.state.nodes)):
        name, found = controllers(spawner)
        if found and spawner.name is None:
            world.state.nodes[number] = replace(spawner, name=f"spawner_{found[0].name}")
        manager = next((node for node in world.state.nodes if _is_called(node, name)), None)
        context = Context(spawner.lines[0].path, lines=spawner.lines, conditions=spawner.conditions, held=spawner.held)
        for controller in found:
            if not world.state.unknowns.is_open(name + controller.name):
                _load(world, name, manager, controller, context)


def _load(world: World, name: str, manager: NodeStart | None, controller: Controller, context: Context) -> None:
    place = context.lines[-1]
    given = ros_arguments(world, ["--ros-args", *controller.arguments])
    started = NodeStart(
        "", "", controller.name, f"{name.rpartition('/')[0]}/", context.lines,
        tuple(for_node(world, given.remaps, controller.name, context)),
        conditions=context.conditions, held=context.held, ros=2, called=controller.name,
    )  # fmt: skip
    for setting in _for(manager, started.full_name):
        world.state.set_param(replace(setting, name=f"{started.full_name}/{setting.name}"))
    started = with_parameters(world, started, [*controller.params, *given.params], context, specified=True)
    own = world.state.params.get(f"{started.full_name}/type", [])
    told = [setting for setting in _for(manager, name) if setting.name == f"{controller.name}.type"][-1:]
    class_ = controller.type or _text(world, own) or _text(world, told)
    if class_ is None:
        world.interpreter.misunderstood(place, f"the class of the controller {controller.name} is not known")
    else:
        world.state.add_node(replace(started, package=class_.partition("/")[0], type=class_), fatal=False)


def _is_called(node: NodeStart, name: str) -> bool:
    """Whether a node is called so, as far as launch files say: managers have their name by their code."""
    manages = (node.package, node.type) in _MANAGERS and node.name is None
    return f"{node.namespace}controller_manager" == name if manages else node.full_name == name


def _for(manager: NodeStart | None, name: str) -> list[ParamSetting]:
    """What a manager's process is given for the node of this name."""
    return [one.setting for one in (manager.process if manager else ()) if one.read and matches(one.nodes, name)]


def _text(world: World, found: Sequence[ParamSetting]) -> str | None:
    """What a parameter is set to, when that is one text."""
    value = found[0].value if len(found) == 1 else None
    return value if isinstance(value, str) and not world.state.unknowns.is_open(value) else None
