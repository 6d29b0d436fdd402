"""Parameters of ROS 2 nodes: values given in launch files, and files of parameters for the nodes whose names these say.

Source: rcl_yaml_param_parser: keys are names of nodes, which may be nested as namespaces and have `*` for one part of a name and `**` for
any number; below `ros__parameters` maps are nested with dots.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.model import Condition, LaunchError, Place
from rosarch.extractor.launch.state import PART_COST, YAML_COST
from rosarch.extractor.launch.yaml_values import KeyLines, Loader, RepeatedKeysLoader, YamlError, load_yaml
from rosarch.extractor.patterns import Pattern, PatternError, compiled, encoded

from .context import Context, Given
from .substitutions import perform
from .texts import parsed
from .values import NOTHING, Either, Instance, Made, Unknown

if TYPE_CHECKING:
    from .world import World

_SECTION = "ros__parameters"


@dataclass(frozen=True)
class Setting:
    """A parameter of a node: its name, with dots, its value, the file it is from and the line there."""

    name: str
    value: Any
    place: Place
    conditions: tuple[Condition, ...] = ()
    source: str | None = None
    written: Place | None = None


@dataclass(frozen=True)
class Unread:
    """A file of parameters that could not be read."""

    file: str
    place: Place


@dataclass(frozen=True)
class Section:
    """What a file says for the nodes that `pattern` names."""

    pattern: str
    values: Mapping[Any, Any]
    keys: tuple[str, ...]


def settings(world: World, given: Given, names: tuple[str, ...], context: Context) -> Iterator[Setting | Unread]:
    """What one entry of a list of parameters sets for a node that has one of these (absolute) names."""
    value = given.value
    if given.name is not None:
        yield from _flat(given.name, evaluated(world, value, context), given)
    elif isinstance(value, Mapping):
        yield from _of_map(world, value, given, context)
    elif isinstance(value, Either):
        for condition, one in value.alternatives():
            if one is not NOTHING:
                yield from settings(world, Given(one, given.place, (*given.conditions, condition)), names, context)
    elif isinstance(value, Made) and value.kind in ("Parameter", "ParameterGroup"):
        yield from _of_parameter(world, "", value, given, context)
    elif isinstance(value, Unknown):
        yield Unread(world.as_text(value), given.place)
    elif value is not None and value is not NOTHING:
        yield from _of_file(world, value, given, names, context)


def _of_map(world: World, value: Mapping[Any, Any], given: Given, context: Context, prefix: str = "") -> Iterator[Setting]:
    for key, item in value.items():
        name = prefix + (key if isinstance(key, str) else perform(world, key, context))
        if isinstance(item, Mapping):
            yield from _of_map(world, item, given, context, f"{name}.")
        elif item is not NOTHING:
            yield Setting(name, evaluated(world, item, context), given.place, given.conditions)


def _of_parameter(world: World, prefix: str, made: Made, given: Given, context: Context) -> Iterator[Setting]:
    name = prefix + perform(world, made.get("name"), context)
    if made.kind == "ParameterGroup":
        for inner in made.arguments["parameters"]:
            yield from _of_parameter(world, f"{name}.", inner, given, context)
    else:
        place = Given(given.value, made.place, given.conditions)
        yield from _flat(name, evaluated(world, made.arguments.get("value"), context), place)


def _flat(name: str, value: Any, given: Given) -> Iterator[Setting]:
    if isinstance(value, dict) and value:
        for key, item in value.items():
            yield from _flat(f"{name}.{key}", item, given)
    else:
        yield Setting(name, value, given.place, given.conditions)


def evaluated(world: World, value: Any, context: Context) -> Any:
    """A value of a parameter: what substitutions come to is read as YAML, unless its type is said."""
    if isinstance(value, Made) and value.kind == "ParameterValue":
        return _typed(world, value, context)
    if isinstance(value, (list, tuple)):
        world.state.spend(PART_COST * len(value))
    if isinstance(value, (Made, Instance)) or (
        isinstance(value, (list, tuple)) and any(isinstance(item, (Made, Instance)) for item in value)
    ):
        if isinstance(value, (list, tuple)) and all(isinstance(item, Made) and item.kind == "ParameterValue" for item in value):
            return [evaluated(world, item, context) for item in value]
        return _read(world, perform(world, value, context))
    if isinstance(value, (list, tuple)):
        return [evaluated(world, item, context) for item in value]
    return world.as_text(value) if isinstance(value, (Unknown, Either)) else value


def _read(world: World, text: str) -> Any:
    found = text if world.state.unknowns.is_open(text) or text in world.described else yaml_value(text)
    return "" if found is None else found


def _typed(world: World, made: Made, context: Context) -> Any:
    value, kind = made.arguments.get("value"), made.arguments.get("value_type")
    if not isinstance(value, (str, list, tuple, Made, Instance, Either, Unknown)):
        return value
    text = perform(world, value, context)
    name = kind if isinstance(kind, str) else getattr(kind, "__name__", None) or getattr(kind, "name", "auto")
    if name in ("str", "string"):
        return text
    found = _read(world, text)
    return float(found) if name in ("float", "double") and isinstance(found, int) and not isinstance(found, bool) else found


def yaml_value(source: str) -> Any:
    """What a text is as YAML; the text itself when it is none."""
    try:
        return load_yaml(source, Loader)
    except YamlError:
        return source


# -- files --------------------------------------------------------------------------------------------------------------------


def _of_file(world: World, value: Any, given: Given, names: tuple[str, ...], context: Context) -> Iterator[Setting | Unread]:
    state = world.state
    substituted = isinstance(value, Made) and value.kind == "ParameterFile" and bool(value.arguments.get("allow_substs"))
    path = perform(world, value, context)
    if path not in world.written and state.unknowns.is_open(path):
        yield Unread(path, given.place)
        return
    world.here(given.place)
    try:
        sections, lines = sections_of(world, path, context if substituted else None)
        wanted = chosen(sections, (given.node,) if given.node is not None else names)
    except LaunchError as error:
        state.report_unread(error)
        yield Unread(path, given.place)
        return
    for section in wanted:
        for name, found, keys in _leaves("", section.values, section.keys):
            line = lines.get(keys)
            written = Place(world.located(path), line) if line and path not in world.written else None
            yield Setting(name, found, given.place, given.conditions, path, written)


def sections_of(world: World, path: str, context: Context | None) -> tuple[list[Section], KeyLines]:
    """The sections of a file of parameters, and the lines of its keys; with a context, substitutions in its text are performed.

    Raises:
        LaunchError: it cannot be read, or is no YAML.
    """
    text = world.source_of(path)
    if context is not None and "$(" in text:
        text = perform(world, parsed(text, Place(path, 1)), context)
    if text not in world.parameter_texts:
        world.state.spend(YAML_COST * len(text))
        try:
            data, lines = world.state.files.yaml(text, RepeatedKeysLoader)
        except YamlError as error:
            raise LaunchError("yaml", path, f"invalid YAML at {path}:{error.line}:{error.column}: {error.message}") from None
        world.parameter_texts[text] = (list(_sections("", data, ())) if isinstance(data, dict) else [], lines)
    return world.parameter_texts[text]


def _sections(outer: str, data: Mapping[Any, Any], keys: tuple[str, ...]) -> Iterator[Section]:
    for key, value in data.items():
        if key == _SECTION and isinstance(value, dict):
            yield Section(outer or "/**", value, (*keys, key))
        elif isinstance(value, dict) and isinstance(key, str):
            yield from _sections(f"{outer}/{key.strip('/')}", value, (*keys, key))


def chosen(sections: list[Section], names: tuple[str, ...]) -> list[Section]:
    """The sections that are for a node; general ones first, which those for its very name override."""
    return [section for section in sections if any(matcher(section.pattern).fullmatch(name) for name in names)]


def matcher(pattern: str) -> Pattern:
    """The names of nodes that a key of a file stands for.

    Raises:
        LaunchError: it is too long to be matched.
    """
    parts = []
    for part in pattern.strip("/").split("/"):
        parts.append(b"(/[^/]+)*" if part == "**" else b"/" + re.escape(encoded(part)).replace(rb"\*", b"[^/]*"))
    try:
        return compiled(b"".join(parts), pattern)
    except PatternError as error:
        raise LaunchError("yaml", pattern, str(error)) from None


def _leaves(prefix: str, values: Mapping[Any, Any], keys: tuple[str, ...]) -> Iterator[tuple[str, Any, tuple[str, ...]]]:
    for key, value in values.items():
        name = f"{prefix}{key}"
        if isinstance(value, dict):
            yield from _leaves(f"{name}.", value, (*keys, str(key)))
        else:
            yield name, value, (*keys, str(key))


def likely_name(sections: list[Section], namespace: str, known: tuple[str, ...]) -> str | None:
    """The name of a node that a launch file does not name: that of the one that a file is for; of several, one that is among `known`."""
    last = dict.fromkeys(section.pattern.rpartition("/")[2] for section in sections if "*" not in section.pattern.rpartition("/")[2])
    names = [name for name in last if any(matcher(section.pattern).fullmatch(f"{namespace}/{name}") for section in sections)]
    return names[0] if len(names) == 1 else next((name for name in known if name in names), None)
