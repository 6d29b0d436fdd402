"""The actions that start something: nodes, containers and the components that are loaded into them."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.descriptions import note_worlds, robot_of_file
from rosarch.extractor.launch.model import (
    ComponentNamed,
    Condition,
    LaunchError,
    NodeStart,
    PackageNamed,
    ParamSetting,
    ParamsGiven,
    ParamsSection,
    Place,
    ProcessSetting,
    ProgramNamed,
    Remap,
)
from rosarch.extractor.launch.names import canonical, ns_join
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch_ros2.actions import carries_out, conditional, joined, require_namespace, require_node_name
from rosarch.extractor.launch_ros2.argument_types import NODES
from rosarch.extractor.launch_ros2.context import Context, Given
from rosarch.extractor.launch_ros2.controllers import asked_by_command, asked_by_spawner
from rosarch.extractor.launch_ros2.expressions import Raised
from rosarch.extractor.launch_ros2.parameters import Read, Setting, Unread, in_order_of_rcl, is_map, params_path, settings
from rosarch.extractor.launch_ros2.params_files import ALL, expression, likely_name, params_file
from rosarch.extractor.launch_ros2.processes import node_programs
from rosarch.extractor.launch_ros2.ros_arguments import prefixed, require_rule, ros_arguments
from rosarch.extractor.launch_ros2.substitutions import perform
from rosarch.extractor.launch_ros2.values import (
    NOTHING,
    ROS_ARGUMENTS,
    Either,
    Instance,
    Made,
    Unknown,
    Written,
    cases,
    class_of,
    in_order,
)

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World
    from rosarch.extractor.urdf.robots import Robot

_KINDS = ("topic", "service")
"""What a remapping rule may be for alone."""
_DESCRIPTIONS = ("robot_description", "robot_description_semantic")
"""Parameters whose values are robot descriptions."""


@carries_out("Node", "LifecycleNode")
def _node(world: World, made: Made, context: Context) -> None:
    if "autostart" in made.arguments:
        world.state.commands.setdefault(world.state.here)
    start_node(world, made, context)
    world.agenda.started(made, context)


@carries_out("ComposableNodeContainer")
def _container(world: World, made: Made, context: Context) -> None:
    container = start_node(world, made, context)
    world.agenda.started(made, context)
    if (described := made.get("composable_node_descriptions")) is not None:
        load(world, described, container.full_name, context)


@carries_out("LoadComposableNodes")
def _load(world: World, made: Made, context: Context) -> None:
    load(world, made.get("composable_node_descriptions"), _target(world, made.get("target_container"), context), context)


def _target(world: World, target: Any, context: Context) -> str:
    """The name of a container, absolute: a relative one is below the root, in whatever namespace launch is."""
    if isinstance(target, Instance):
        target = target.made
    if isinstance(target, Made) and target.kind in NODES:
        namespace = joined(context.namespace, perform(world, target.get("namespace"), context))
        return ns_join(f"{namespace}/", perform(world, target.get("name"), context))
    if isinstance(target, Either):
        return world.as_text(Either(target.condition, _target(world, target.first, context), _target(world, target.second, context)))
    name = perform(world, target, context)
    return canonical(name if name.startswith("/") else f"/{name}")


def start_node(world: World, made: Made, context: Context) -> NodeStart:
    """Start a node as a process."""
    given = ros_arguments(world, _words(world, made, context))
    package = perform(world, made.get("package"), context)
    executable = world.by_names(perform(world, made.get("executable", "node_executable"), context))
    named = made.get("name", "node_name")
    name = None if named is None else perform(world, named, context)
    if name is not None:
        require_node_name(name)
    name = given.name or name
    namespace = joined(context.namespace, perform(world, made.get("namespace", "node_namespace"), context))
    require_namespace(namespace)
    told = given.namespace(name)
    namespace = namespace if told is None else joined("", told)
    remaps = [*given.remaps, *context.remaps, *_remaps(world, made, context)]  # as they stand on the command line
    _refer(world, package, executable, made.place)
    params = [*given.params, *context.params, *_given(made)]
    args = " ".join(map(shlex.quote, given.plain))
    node = _start(world, made, context, (package, executable, name, namespace), remaps, params, args)
    asked_by_spawner(world, node, given.plain)
    return node


def load(world: World, descriptions: Any, container: str, context: Context) -> None:
    """Load components into a container."""
    if isinstance(descriptions, Made):
        raise Raised("TypeError", f"'{class_of(descriptions)}' object is not iterable")
    for one in descriptions if isinstance(descriptions, (list, tuple)) else [descriptions]:
        _load_one(world, one, container, context)


def _load_one(world: World, one: Any, container: str, context: Context) -> None:
    if isinstance(one, Instance):
        one = one.made
    if isinstance(one, Either):
        for condition, item in one.alternatives():
            if context.allows(condition):
                with context.within(condition):
                    (load if isinstance(item, (list, tuple)) else _load_one)(world, item, container, context)
    elif isinstance(one, (list, tuple, type(None))):
        raise Raised("AttributeError", f"'{class_of(one)}' object has no attribute 'condition'")
    elif isinstance(one, Unknown):
        world.interpreter.misunderstood(one.place, f"what is loaded into {world.state.unknowns.render(container)} is not known: {one.text}")
    elif isinstance(one, Made):
        with conditional(world, one.arguments.get("condition"), context) as starts:
            if starts:
                _load_component(world, one, container, context)


def _load_component(world: World, made: Made, container: str, context: Context) -> None:
    given = made.get("parameters")
    if any(isinstance(one, Made) and one.kind == "Parameter" for one in (given if isinstance(given, (list, tuple)) else ())):
        raise Raised("RuntimeError", "invalid evaluated parameters: a component takes no `Parameter`")
    world.here(made.place)
    package, plugin = (perform(world, made.get(*names), context) for names in (("package",), ("plugin", "node_plugin")))
    name = perform(world, made.get("name", "node_name"), context) or None
    namespace = joined(context.namespace, perform(world, made.get("namespace", "node_namespace"), context))
    remaps = [*context.remaps, *_remaps(world, made, context)]
    _refer_to_component(world, package, plugin, made.place)
    _start(world, made, context, (package, plugin, name, namespace), remaps, [*context.params, *_given(made)], "", container)


def _start(
    world: World,
    made: Made,
    context: Context,
    names: tuple[str, str, str | None, str],
    remaps: Iterable[Remap],
    params: Iterable[Given],
    args: str,
    container: str | None = None,
) -> NodeStart:
    package, executable, name, namespace = names
    lines = (*context.lines, made.place)
    params = list(params)
    called = name or _inferred(world, params, namespace, (executable, package), context) or executable.rpartition("::")[2]
    note_worlds(world.state, args.split(), context.lines, context.conditions)
    started = NodeStart(
        package=package,
        type=executable,
        name=name,
        namespace=f"{namespace}/",
        lines=lines,
        remaps=tuple(_for_node(world, remaps, name, context)),
        args=args,
        respawn=made.arguments.get("respawn") is True,
        output=made.arguments["output"] if isinstance(made.arguments.get("output"), str) else None,
        conditions=context.conditions,
        held=context.held,
        ros=2,
        environment=_environment(world, made, context),
        called=called,
        container=container,
    )
    in_namespace = namespace != "" or context.is_in_namespace or made.get("namespace", "node_namespace") is not None
    started = _with_parameters(world, started, params, context, specified=name is not None and in_namespace)
    world.state.add_node(started, fatal=False, anew=context.anew)
    return started


def _environment(world: World, made: Made, context: Context) -> tuple[tuple[str, str], ...]:
    """The variables that a process gets from the launch files; what is loaded gets none of its own."""
    found = {name: value for name, value in context.environment.items() if value is not None}
    given = made.arguments.get("additional_env")
    for name, value in given.items() if isinstance(given, dict) else ():
        variable, text = perform(world, name, context), perform(world, value, context)
        if not isinstance(name, Unknown) and text != world.environment.get(variable):  # not what launch is started with
            found[variable] = text
    return tuple(sorted(found.items()))


def _with_parameters(world: World, started: NodeStart, params: Iterable[Given], context: Context, *, specified: bool) -> NodeStart:
    """The node, whose parameters are set; it keeps what is given to its process, for other nodes that it makes.

    Maps are written for the node alone when its name and namespace are `specified`, else for all of its process.
    """
    kept: list[ProcessSetting] = []
    own_params: list[ParamSetting] = []
    files: dict[str, ParamsGiven] = {}
    loaded = started.container is not None
    own = started.full_name if specified and not loaded else None
    given_all = (replace(given, loaded=loaded, node=given.node or (own if is_map(given.value) else None)) for given in params)
    everything = [found for given in given_all for found in settings(world, given, None, context)]
    for found in everything if loaded else in_order_of_rcl(everything):
        if isinstance(found, Read):
            files[found.path] = _sections(found)
            continue
        setting = _setting(world, found, context)
        if isinstance(found, Setting) and found.source is None and not loaded:
            _require_one_type(world, found)
        if isinstance(found, Unread):
            kept.append(ProcessSetting(ALL, setting, read=False))
            world.state.unread.append(replace(setting, name=started.full_name))
            continue
        kept.append(ProcessSetting(found.nodes, setting))
        # launch_ros looks for a node that it loads by its name: one without has what is for all
        if found.is_for(started.full_name) and (started.name or not loaded or found.nodes == ALL):
            if found.written is not None and not loaded:
                _as_it_is_read(world, found)
            own_params.append(replace(setting, name=f"{started.full_name}/{setting.name}"))
            world.state.set_param(own_params[-1])
    return replace(
        started,
        params_files=tuple(files.values()),
        given=() if started.name else tuple(kept),
        process=() if loaded else tuple(kept),
        own_params=tuple(own_params),
    )


def _require_one_type(world: World, found: Setting) -> None:
    """Report a list that arrives with elements of several types: launch_ros quotes the text `true` and leaves `y` and `1e3` as they are."""
    if isinstance(found.value, list):
        kinds = {type(item) for item in found.value if not (isinstance(item, str) and world.state.unknowns.is_open(item))}
        if len(kinds) > 1:
            message = f"the parameter `{found.name}`: its elements arrive as several types, {found.value}"
            world.state.report(LaunchError("ros-argument", found.name, message), fatal=False, place=found.place)


_SUBSTITUTION = re.compile(r"\$\((?:var|find-pkg-share|find-pkg-prefix|env|arg|eval)\b[^()]*\)")


def _as_it_is_read(world: World, found: Setting) -> None:
    """Report what a node does not make of a value in a file what launch would: a list without elements, a substitution."""
    if found.value == []:
        message = f"the list `{found.name}` is empty: rclcpp finds no type for it"
        world.state.warn("list-without-type", found.source or "", message, place=found.written)
    elif isinstance(found.value, str) and not found.substituted and (literal := _SUBSTITUTION.search(found.value)):
        message = f"`{literal[0]}` is taken as it is written: no `allow_substs` is given with the file"
        world.state.warn("literal", literal[0], message, place=found.written)


def _sections(read: Read) -> ParamsGiven:
    """For whom a file of parameters is."""
    lines = ((section, read.file.lines.get(section.keys[:-1], 1)) for section in read.file.sections)
    return ParamsGiven(read.path, tuple(ParamsSection(one.pattern, expression(one.pattern), Place(read.path, line)) for one, line in lines))


def _setting(world: World, found: Setting | Unread, context: Context) -> ParamSetting:
    """What is set, by the name that the node knows it by."""
    lines = (*context.lines, found.place)
    if isinstance(found, Unread):
        return ParamSetting("", None, lines, context.conditions, found.file)
    conditions = (*context.conditions, *(one for one in found.conditions if one not in context.conditions))
    robot = _robot(world, found.value, is_named_so=found.name in _DESCRIPTIONS) if isinstance(found.value, str) else None
    if found.name == "robot_description" and robot is None:
        world.state.hardware_unseen = True
    return ParamSetting(found.name, found.value, lines, conditions, found.source, found.written, robot)


def _robot(world: World, text: str, *, is_named_so: bool) -> Robot | None:
    """What a robot description says that xacro made, or that is the text of a file and `is_named_so`."""
    if is_named_so and text not in world.described and (path := world.state.files.with_text(text)):
        world.described[text] = robot_of_file(world.state, path, text)
    return world.described.get(text)


def _inferred(world: World, params: list[Given], namespace: str, known: tuple[str, ...], context: Context) -> str | None:
    """The name of a node that the launch file does not name, from the files of parameters that it is given."""
    for given in params:
        if given.name is not None or given.node is not None or isinstance(given.value, (dict, Either, Unknown)):
            continue
        path = params_path(world, given.value, context)
        if world.state.unknowns.is_open(path) and path not in world.written:
            continue
        try:
            name = likely_name(params_file(world, path, None).sections, namespace, known)
        except LaunchError:
            continue  # reported where it is read
        if name is not None:
            return name
    return None


def _for_node(world: World, remaps: Iterable[Remap], name: str | None, context: Context) -> Iterator[Remap]:
    """The remappings of a node: `node:from` is for the node of that name only. One without a name has those for any node."""
    for remap in remaps:
        require_rule(world, remap.source, remap.target, remap.place)
        node, source = prefixed(remap.source)
        if name and ((node and node != name) or source.startswith("__")):
            continue
        conditions = tuple(one for one in remap.conditions if one not in context.conditions)
        only = next((kind for kind in _KINDS if source.startswith(f"ros{kind}://")), None)
        source = source.removeprefix(f"ros{only}://")
        yield Remap(
            canonical(_private(source)), canonical(_private(remap.target)), remap.place, conditions, None if name else node or None, only
        )


def _private(name: str) -> str:
    """`~/x` as ROS 1 writes it."""
    return f"~{name[2:]}" if name.startswith("~/") else name


def _refer(world: World, package: str, executable: str, place: Place) -> None:
    names = _names_in(world, package, place)
    if names is not None and not world.state.unknowns.is_open(executable):
        world.references.append(ProgramNamed(package, executable, os.path.basename(executable) in names, place))


def _refer_to_component(world: World, package: str, plugin: str, place: Place) -> None:
    names = _names_in(world, package, place)
    if names is not None and plugin and not world.state.unknowns.is_open(plugin):
        world.references.append(ComponentNamed(package, plugin, plugin.rpartition("::")[2] in names, place))


def _names_in(world: World, package: str, place: Place) -> frozenset[str] | None:
    """The names that the build files of a package say, which is named at `place`; None when it is not known or there is none."""
    if not package or world.state.unknowns.is_open(package):
        return None
    packages = world.state.files.packages
    folder = packages.find(package)
    if folder is None and world.is_guarded(package):
        return None
    world.references.append(PackageNamed(package, folder, place))
    return None if folder is None else packages.names_in(folder)


def _given(made: Made) -> list[Given]:
    found = made.get("parameters")
    parts = list(_parts([found] if isinstance(found, dict) else found))
    if any(item is None for item, _ in parts):
        raise Raised("TypeError", "'parameters' has None for a file or a map")
    return [Given(item, item.place if isinstance(item, Made) else made.place, conditions) for item, conditions in parts]


def _remaps(world: World, made: Made, context: Context) -> list[Remap]:
    """The remappings of an action, each where it is written: of a list that several actions get, that is one place."""
    remaps: list[Remap] = []
    parts = ((item, (*conditions, *more)) for part, conditions in _parts(made.get("remappings")) for more, item in cases(part))
    for item, conditions in parts:
        if isinstance(item, Unknown):
            world.interpreter.misunderstood(made.place, f"what this node remaps is not known: {world.as_text(item)}")
        elif isinstance(item, (list, tuple)) and len(item) in (2, 3) and not isinstance(item[0], tuple):
            place = item[2] if len(item) == 3 else item.place if isinstance(item, Written) else made.place
            remap = Remap(perform(world, item[0], context), perform(world, item[1], context), place, (*context.conditions, *conditions))
            remaps.append(remap)
            world.state.remaps.append(remap)
    return remaps


def _parts(found: Any) -> Iterator[tuple[Any, tuple[Condition, ...]]]:
    """What is in a list, each with the conditions under which it is this list and no other."""
    return ((item, conditions) for conditions, one in cases(found) for item in _as_list(one))


def _as_list(found: Any) -> list[Any]:
    """The items of a list, or of what stands for one."""
    if isinstance(found, dict):
        return list(found.items())
    if isinstance(found, (set, frozenset)):
        return in_order(found)
    return list(found) if isinstance(found, (list, tuple)) else [] if found is None or found is NOTHING else [found]


def _words(world: World, made: Made, context: Context) -> list[str]:
    if made.command is not None:
        return _words_of(world, _changed_arguments(made.command, made), context)
    words: list[str] = []
    for name in ("arguments", "ros_arguments"):
        found = made.get(name)
        if name == "ros_arguments" and found is not None:
            words.append("--ros-args")
        words.extend(_words_of(world, found, context))
    return words


def _changed_arguments(command: list[Any], node: Made) -> list[Any]:
    """The arguments in a command line that code has changed; what it adds at the end follows what launch_ros adds for ROS."""
    first, *words = command or [None]
    if not (isinstance(first, (list, tuple)) and len(first) == 1 and isinstance(first[0], Made) and first[0].kind == "ExecutableInPackage"):
        return [Unknown("cmd", node.place, "the program of its command line is replaced")]
    at = next((index for index, word in enumerate(words) if isinstance(word, (list, tuple)) and ROS_ARGUMENTS in word), len(words))
    after = words[at + 1 :]
    return [*words[:at], *(["--ros-args", *after] if after else [])]


def _words_of(world: World, found: Any, context: Context) -> list[str]:
    """The words of a command line, or a part of one; in XML and YAML it is one text, where a substitution is within one word."""
    if not (isinstance(found, Made) and found.kind == "Words"):
        if isinstance(found, Made):
            raise Raised("TypeError", f"'{class_of(found)}' object is not iterable")
        for item in found if isinstance(found, (list, tuple)) else ():
            if isinstance(item, (list, tuple)) and any(isinstance(part, (list, tuple)) for part in item):
                raise Raised("TypeError", "Failed to normalize an item of a list within a list, where texts and substitutions are expected")
        # a text is a list of its characters
        return list(found) if isinstance(found, str) and is_known(found) else [perform(world, [item], context) for item in _as_list(found)]
    words: list[list[str]] = []
    word: list[str] = []
    for part in found.arguments["text"]:
        if not isinstance(part, str):
            word.append(perform(world, part, context))
            continue
        tokens = _split(part)
        if word and (not tokens or part[0].isspace()):
            words.append(word)
            word = []
        word += tokens[:1]
        for token in tokens[1:]:
            words.append(word)
            word = [token]
        if word and part[-1].isspace():
            words.append(word)
            word = []
    return ["".join(parts) for parts in (*words, *([word] if word else []))]


def _split(text: str) -> list[str]:
    """The words of a text between substitutions.

    Raises:
        LaunchError: a quote is not closed: none reaches over a substitution.
    """
    try:
        return shlex.split(text)
    except ValueError as error:
        raise LaunchError("arguments", text, f"`{text}`: {str(error).lower()}") from None


def _start_program(world: World, words: Sequence[str], made: Made, context: Context) -> None:
    """Start a program that makes a node, such as Gazebo classic when it loads plug-ins for ROS; of a shell a word may be several."""
    package, executable, name = node_programs()[os.path.basename(words[0])]
    given = ros_arguments(world, [part for word in words[1:] for part in word.split()])
    name = given.name or name
    namespace = joined("", given.namespace(name) or "")
    args = " ".join(map(shlex.quote, given.plain))
    _start(world, made, context, (package, executable, name, namespace), given.remaps, given.params, args)


@carries_out("ExecuteProcess", "ExecuteLocal")
def _process(world: World, made: Made, context: Context) -> None:
    """A program; `ros2 run package executable` is a node."""
    description = made.get("process_description")
    source = description if isinstance(description, Made) else made
    given = (*_words_of(world, source.get("cmd"), context), *_words_of(world, source.get("args"), context))
    words = [*map(world.by_names, given)]
    world.hand(words)
    if len(words) > 3 and os.path.basename(words[0]) == "ros2" and words[1] == "run" and not words[2].startswith("-"):
        node = Made("Node", {"package": words[2], "executable": words[3], "arguments": words[4:]}, made.place)
        start_node(world, node, context.of_commands())
    elif words and os.path.basename(words[0]) in node_programs():
        _start_program(world, words, made, context)
    else:
        world.state.commands.setdefault(world.state.here)
        asked_by_command(world, words, context)
    world.agenda.started(made, context)
