"""Parameters of ROS 2 nodes: values given in launch files, and files of parameters for the nodes whose names these say."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from rosarch.base.diagnostics import shortened
from rosarch.extractor.launch.model import Condition, LaunchError, Place
from rosarch.extractor.launch.state import PART_COST
from rosarch.extractor.launch.yaml_values import Loader, YamlError, load_yaml
from rosarch.extractor.launch_ros2.argument_types import TYPES, type_name
from rosarch.extractor.launch_ros2.context import Context, Given
from rosarch.extractor.launch_ros2.params_files import ALL, ParamsFile, chosen, leaves, matches, params_file
from rosarch.extractor.launch_ros2.rcl_values import shown, written
from rosarch.extractor.launch_ros2.substitutions import perform
from rosarch.extractor.launch_ros2.values import NOTHING, Either, Instance, Made, PathText, Unknown

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World


@dataclass(frozen=True)
class Setting:
    """A parameter of the nodes that match `nodes`: its name, with dots, its value, the file it is from and the line there.

    With `substituted`, launch has replaced the substitutions in that file; `nested`: there, its name is that of a map and of a key in it.
    """

    name: str
    value: Any
    place: Place
    conditions: tuple[Condition, ...] = ()
    source: str | None = None
    written: Place | None = None
    nodes: str = ALL
    substituted: bool = False
    nested: bool = False

    def is_for(self, node: str) -> bool:
        """Whether the node of this (absolute) name gets it."""
        return matches(self.nodes, node)


@dataclass(frozen=True)
class Unread:
    """A file of parameters that could not be read."""

    file: str
    place: Place


@dataclass(frozen=True)
class Read:
    """A file of parameters that was read, whomever it is for; `path` is where it is in the sources."""

    path: str
    file: ParamsFile


_MAPS = ("ParameterEntry", "ParameterGroup")
"""What the elements of XML and YAML are that give a parameter: as in Python, maps."""


def is_map(value: Any) -> bool:
    """Whether a node is given a map, for which launch_ros writes a file."""
    return isinstance(value, Mapping) or (isinstance(value, Made) and value.kind in _MAPS)


def in_order_of_rcl(found: Iterable[Setting | Unread | Read]) -> Iterator[Setting | Unread | Read]:
    """What a process is given, in the order in which rcl has it override each other: all for one key, in the place of the first."""
    groups: dict[str, list[Setting | Unread | Read]] = {}
    for one in found:
        groups.setdefault(one.nodes if isinstance(one, Setting) else "", []).append(one)
    for group in groups.values():
        for entry in _entries(group):
            yield from sorted(entry, key=_rank, reverse=True)


def _entries(group: Iterable[Setting | Unread | Read]) -> list[list[Setting | Unread | Read]]:
    """The parameters that rcl keeps for one key: the last of a name counts, and of its values that of the first type in rcl's list.

    A value goes to the first parameter of its name, which keeps one of each type, unless it is nested: then it is one more parameter.
    """
    entries: list[list[Setting | Unread | Read]] = []
    first: dict[str, list[Setting | Unread | Read]] = {}
    for one in group:
        if isinstance(one, Setting) and not one.nested and one.name in first:
            first[one.name].append(one)
            continue
        entries.append([one])
        if isinstance(one, Setting):
            first.setdefault(one.name, entries[-1])
    return entries


def _rank(found: Setting | Unread | Read) -> int:
    """The place of a value's type in rcl's list; the first for what has no value."""
    value = found.value if isinstance(found, Setting) else None
    several = isinstance(value, list)
    kind = type(value[0]) if several and value else type(value)
    return (_TYPES.index(kind) if kind in _TYPES else len(_TYPES)) + len(_TYPES) * several


_TYPES = (bool, int, float, str)


def settings(world: World, given: Given, name: str | None, context: Context) -> Iterator[Setting | Unread | Read]:
    """What one entry of a list of parameters sets for the node of this (absolute) name; without a name, for any node."""
    value = given.value
    if given.name is not None:
        shared = given.shared and not given.loaded
        found = _flat(given.name, shown(evaluated(world, value, context)) if shared else evaluated(world, value, context), given)
        yield from (replace(setting, nodes=given.node or ALL) for setting in found)
    elif isinstance(value, Mapping):
        yield from _of_map(world, value, given, context)
    elif isinstance(value, Either):
        for condition, one in value.alternatives():
            if one is not NOTHING:
                yield from settings(world, Given(one, given.place, (*given.conditions, condition)), name, context)
    elif isinstance(value, Made) and value.kind in ("Parameter", *_MAPS):
        yield from _of_parameter(world, "", value, given, context)
    elif isinstance(value, Unknown):
        yield Unread(world.as_text(value), given.place)
    elif value is not None and value is not NOTHING:
        yield from _of_file(world, value, given, name, context)


def _of_map(world: World, value: Mapping[Any, Any], given: Given, context: Context, prefix: str = "") -> Iterator[Setting | Unread]:
    for key, item in value.items():
        if isinstance(key, Unknown):
            yield Unread(world.as_text(key), given.place)
            continue
        name = prefix + (key if isinstance(key, str) else perform(world, key, context))
        for conditions, one in _cases(item):
            case = replace(given, conditions=(*given.conditions, *conditions))
            if isinstance(one, Mapping):
                yield from _of_map(world, one, case, context, f"{name}.")
            elif one is not NOTHING:
                arriving = _arriving(evaluated(world, _taken(world, name, one), context), case)
                at = world.read_at(value, key)
                yield Setting(name, arriving, case.place, case.conditions, written=at, nodes=case.node or ALL)


def _cases(item: Any) -> Iterator[tuple[tuple[Condition, ...], Any]]:
    """What an entry of a map is, and when, if it may be a map itself or may not be there."""
    if isinstance(item, Either) and not _is_one_value(item):
        for condition, one in item.alternatives():
            yield from (((condition, *more), case) for more, case in _cases(one))
    else:
        yield (), item


def _is_one_value(item: Any) -> bool:
    if isinstance(item, Either):
        return _is_one_value(item.first) and _is_one_value(item.second)
    return item is not NOTHING and not isinstance(item, Mapping)


_PLAIN = (bool, int, float, str)


def _taken(world: World, name: str, value: Any) -> Any:
    """A value as launch_ros takes it: whole numbers among doubles of a list become doubles.

    Raises:
        LaunchError: it is of no type that parameters have, or a list whose elements are of other several types.
    """
    if value is None and world.interpreter.unset:
        raise LaunchError("env", name, f"the parameter `{name}` is None: an environment variable that the launch file asks for is not set")
    if value is None or isinstance(value, (PathText, set)):
        shown = "None" if value is None else "a path of pathlib" if isinstance(value, PathText) else "a set"
        raise LaunchError("parameter", name, f"the parameter `{name}` is {shown}, which launch does not take for a value")
    if isinstance(value, (list, tuple)) and not value:
        raise LaunchError("parameter", name, f"the parameter `{name}` is an empty list, for which launch knows no type")
    if not isinstance(value, (list, tuple)) or not all(type(item) in _PLAIN for item in value):
        return value
    kinds = {type(item) for item in value}
    if kinds == {int, float}:
        return [float(item) for item in value]
    if len(kinds) > 1:
        raise LaunchError("parameter", name, f"the elements of the parameter `{name}` are of several types")
    return value


def _arriving(value: Any, given: Given) -> Any:
    """A value as a node gets it: by a file that is written for it, unless it is loaded."""
    return value if given.loaded else written(value)


def _of_parameter(world: World, prefix: str, made: Made, given: Given, context: Context) -> Iterator[Setting]:
    name = prefix + perform(world, made.get("name"), context)
    if made.kind == "ParameterGroup":
        for inner in made.arguments["parameters"]:
            yield from _of_parameter(world, f"{name}.", inner, given, context)
    else:
        value = _arriving(evaluated(world, made.arguments.get("value"), context), given)
        yield from _flat(name, value, Given(given.value, made.place, given.conditions, node=given.node))


def _flat(name: str, value: Any, given: Given) -> Iterator[Setting]:
    if isinstance(value, dict) and value:
        for key, item in value.items():
            yield from _flat(f"{name}.{key}", item, given)
    else:
        yield Setting(name, value, given.place, given.conditions, nodes=given.node or ALL)


def evaluated(world: World, value: Any, context: Context) -> Any:
    """A value of a parameter: what substitutions come to is read as YAML, unless its type is said."""
    if isinstance(value, Made) and value.kind == "ParameterValue":
        return _typed(world, value, context)
    if isinstance(value, (list, tuple)):
        world.state.spend(PART_COST * len(value))
    if isinstance(value, (list, tuple)):
        return _evaluated_list(world, value, context)
    if isinstance(value, (Made, Instance)):
        return _read(world, perform(world, value, context))
    return world.as_text(value) if isinstance(value, (Unknown, Either)) else value


def _evaluated_list(world: World, items: Sequence[Any], context: Context) -> Any:
    """A list of values, each of which may be a list of substitutions; or one such list, where there are no others."""
    has_substitutions = any(isinstance(item, (Made, Instance)) for item in items)
    if items and all(isinstance(item, Made) and item.kind == "ParameterValue" for item in items):
        return [evaluated(world, item, context) for item in items]
    if has_substitutions and not any(isinstance(item, (*_NUMBERS, list, tuple)) for item in items):
        return _read(world, perform(world, items, context))
    if has_substitutions or any(isinstance(item, (list, tuple)) for item in items):
        found = [item if isinstance(item, _NUMBERS) else _read(world, perform(world, item, context)) for item in items]
    else:
        found = [evaluated(world, item, context) for item in items]
    if not _is_of_one_type(world, found):
        raise LaunchError("parameter", str(found), f"the elements of `{found}` are of several types")
    return found


_NUMBERS = (bool, int, float)


def _is_of_one_type(world: World, found: list[Any]) -> bool:
    return _is_value([item for item in found if not (isinstance(item, str) and world.state.unknowns.is_open(item))])


def _read(world: World, text: str) -> Any:
    """What launch_ros makes of a text that substitutions come to.

    Raises:
        LaunchError: it is no YAML, as the description of a robot with `: ` in a comment, or is a map.
    """
    if not text or world.state.unknowns.is_open(text):
        return text
    shown = shortened(text)
    try:
        found = load_yaml(text, Loader)
    except YamlError as error:
        message = (
            f"`{shown}` is no YAML, which launch takes it for without a ParameterValue of type str: {error.message}, line {error.line}"
        )
        raise LaunchError("parameter", shown, message) from None
    if not _is_value(found) or found == []:
        raise LaunchError("parameter", shown, f"`{shown}` is neither a scalar nor a list of one type")
    if isinstance(found, str) and text in world.described:
        world.described[found] = world.described[text]
    return found


def _typed(world: World, made: Made, context: Context) -> Any:
    value, kind = made.arguments.get("value"), made.arguments.get("value_type")
    if not isinstance(value, (str, list, tuple, Made, Instance, Either, Unknown)):
        return value
    if kind is None and isinstance(value, str):
        return value
    if kind is None and isinstance(value, (list, tuple)) and all(isinstance(item, _PLAIN) for item in value):
        return list(value)
    text, name = perform(world, value, context), type_name(kind)
    if name == "str" or world.state.unknowns.is_open(text):
        return text
    if name in TYPES:
        return converted(text, TYPES[name])
    of = TYPES.get(name.removeprefix("list_of_"))
    if of is None:
        return _read(world, text)
    found = yaml_value(text)
    if not (isinstance(found, list) and all(isinstance(item, of) for item in found)):
        raise LaunchError("parameter", text, f"`{text}` is no list of {of.__name__}")
    return found


def converted(text: str, kind: type) -> Any:
    """A text as a number or Boolean.

    Raises:
        LaunchError: it is none.
    """
    with suppress(ValueError):
        found = yaml_value({"1": "true", "0": "false"}.get(text, text)) if kind is bool else kind(text)
        if isinstance(found, kind):
            return found
    raise LaunchError("parameter", text, f"`{text}` is no {kind.__name__}")


def _is_value(found: Any) -> bool:
    """Whether launch takes what a text is as YAML: a scalar, or scalars of one type."""
    kinds = {type(item) for item in found} if isinstance(found, list) else {type(found)}
    return len(kinds) <= 1 and kinds <= {bool, int, float, str}


def yaml_value(source: str) -> Any:
    """What a text is as YAML; the text itself when it is none."""
    try:
        return load_yaml(source, Loader)
    except YamlError:
        return source


# -- files --------------------------------------------------------------------------------------------------------------------


def params_path(world: World, value: Any, context: Context) -> str:
    """Where the file of parameters is that a node is given: launch_ros takes paths of pathlib there, too."""
    return value.text if isinstance(value, PathText) else perform(world, value, context)


def _of_file(world: World, value: Any, given: Given, name: str | None, context: Context) -> Iterator[Setting | Unread | Read]:
    state = world.state
    substituted = isinstance(value, Made) and value.kind == "ParameterFile" and bool(value.arguments.get("allow_substs"))
    path = params_path(world, value, context)
    if not path:  # launch_ros goes on without a file
        return
    if path not in world.written and state.unknowns.is_open(path):
        yield Unread(path, given.place)
        return
    world.here(given.place)
    try:
        file = params_file(world, path, context if substituted else None, loaded=given.loaded)
        wanted = chosen(file.sections, given.node or name)
    except LaunchError as error:
        # a node is started without a file that is not there; what reads files itself ends launch
        missing = error.kind == "file" and not (given.loaded or substituted or given.shared)
        state.report(error, fatal=not (missing or error.is_limit))
        yield Unread(path, given.place)
        return
    if file.unknown is not None:
        yield Unread(file.unknown, given.place)
        return
    shown = None if path in world.written else world.located(path)
    if shown is not None:
        if file.refusal is not None:
            problem = LaunchError("params-file", path, file.refusal.message, file.refusal.meant)
            state.report(problem, fatal=False, place=Place(shown, file.refusal.line))
        if given.node is None:
            yield Read(shown, file)
    for section in wanted:
        for local, found, keys in leaves("", section.values, section.keys):
            line = file.lines.get(keys)
            written = Place(shown, line) if line and shown is not None else None
            nested = len(keys) > len(section.keys) + 1
            yield Setting(
                local, found, given.place, given.conditions, path, written, ALL if given.node else section.pattern, substituted, nested
            )
