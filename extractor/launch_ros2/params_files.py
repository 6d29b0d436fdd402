"""Files of parameters of ROS 2: which nodes they are for, what they set, and what nodes reject of them.

Source: rcl_yaml_param_parser (parse.c): keys are names of nodes, which may be nested as namespaces and have `*` for one part of a name
and `**` for any number; below `ros__parameters` maps are nested with dots. A node that is given a file that it rejects ends at its start.
What is given to classes that are loaded into containers is read by launch_ros (to_parameters_list.py): a file without any section is for
all of them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import yaml

from rosarch.base.patterns import Pattern, PatternError, compiled, encoded
from rosarch.extractor.launch.model import LaunchError, Place
from rosarch.extractor.launch.state import YAML_COST
from rosarch.extractor.launch.yaml_values import KeyLines, RepeatedKeysLoader, YamlError
from rosarch.extractor.launch_ros2.context import Context
from rosarch.extractor.launch_ros2.rcl_values import SCALARS, RclLoader
from rosarch.extractor.launch_ros2.substitutions import perform
from rosarch.extractor.launch_ros2.texts import parsed

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World

_SECTION = "ros__parameters"
_MISSPELT = re.compile(r"_*ros[_-]*param(eter)?s?_*", re.IGNORECASE)
ALL = "/**"
"""The pattern of all nodes."""
_TEXT = "tag:yaml.org,2002:str"
_PARSER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_AROUND = (yaml.StreamStartEvent, yaml.DocumentStartEvent, yaml.DocumentEndEvent, yaml.StreamEndEvent)
_NODES = re.compile(r"/?(?:(?:\*\*?|[A-Za-z_]\w*)/)*(?:\*\*?|[A-Za-z_]\w*)", re.ASCII)
"""What may stand for nodes: their name, with wildcards for parts of it."""


@dataclass(frozen=True)
class Section:
    """What a file says for the nodes that `pattern` names."""

    pattern: str
    values: Mapping[Any, Any]
    keys: tuple[str, ...]


@dataclass(frozen=True)
class Refusal:
    """What of a file a node rejects, at `line`; `meant` is a text there and what was meant by it."""

    message: str
    line: int
    meant: tuple[str, str] | None = None


@dataclass(frozen=True)
class ParamsFile:
    """A file of parameters: its sections, the lines of its keys, what a node rejects; `unknown` is a text that is open as a whole."""

    sections: tuple[Section, ...]
    lines: KeyLines
    refusal: Refusal | None
    unknown: str | None = None


def params_file(world: World, path: str, context: Context | None, *, loaded: bool = False) -> ParamsFile:
    """A file of parameters; with a context, substitutions in its text are performed. For a class that is `loaded`, launch_ros reads it.

    Raises:
        LaunchError: it cannot be read, or is no YAML.
    """
    text = world.source_of(path)
    is_open = world.state.unknowns.is_open
    if context is not None and "$(" in text:
        text = perform(world, parsed(text, Place(path, 1)), context)
    if (text, loaded) not in world.parameter_texts:
        world.state.spend(YAML_COST * len(text))
        try:
            data, lines = world.state.files.yaml(text, RepeatedKeysLoader if loaded else RclLoader)
        except YamlError as error:
            if not is_open(text):
                raise LaunchError("yaml", path, f"invalid YAML at {path}:{error.line}:{error.column}: {error.message}") from None
            data, lines = text, {}  # the parts that are not known may make it YAML
        found = tuple(_sections("", data, ())) if isinstance(data, dict) else ()
        if loaded:
            found = _for_loaded(found, data)
        unknown = data if isinstance(data, str) and is_open(data) else None
        refusal = None if loaded or is_open(text) else refused(text)
        world.parameter_texts[text, loaded] = ParamsFile(found, lines, refusal, unknown)
    return world.parameter_texts[text, loaded]


def _for_loaded(sections: tuple[Section, ...], data: Any) -> tuple[Section, ...]:
    """The sections that launch_ros takes: it knows no wildcard but that for all nodes; a file without any section is for all."""
    if sections:
        return tuple(section for section in sections if section.pattern == ALL or "*" not in section.pattern)
    return (Section(ALL, data, ()),) if isinstance(data, dict) else ()


def _sections(outer: str, data: Mapping[Any, Any], keys: tuple[str, ...]) -> Iterator[Section]:
    for key, value in data.items():
        if key == _SECTION and isinstance(value, dict):
            yield Section(outer or "/**", value, (*keys, key))
        elif isinstance(value, dict) and isinstance(key, str):
            yield from _sections(f"{outer}/{key.strip('/')}", value, (*keys, key))


def chosen(sections: Sequence[Section], name: str | None) -> list[Section]:
    """The sections that are for the node of a name; without a name, all that can be matched.

    Raises:
        LaunchError: the pattern of one cannot.
    """
    found = [(section, matcher(section.pattern)) for section in sections]
    return [section for section, pattern in found if name is None or pattern.fullmatch(name)]


def matches(pattern: str, name: str) -> bool:
    """Whether a key of a file stands for the node of this (absolute) name."""
    return bool(matcher(pattern).fullmatch(name))


def matcher(pattern: str) -> Pattern:
    """The names of nodes that a key of a file stands for.

    Raises:
        LaunchError: it is too long to be matched.
    """
    try:
        return compiled(encoded(expression(pattern)), pattern)
    except PatternError as error:
        raise LaunchError("yaml", pattern, str(error)) from None


def leaves(prefix: str, values: Mapping[Any, Any], keys: tuple[str, ...]) -> Iterator[tuple[str, Any, tuple[str, ...]]]:
    """The parameters of a section: names, values, and the keys that lead to them."""
    for key, value in values.items():
        name = f"{prefix}{key}"
        if isinstance(value, dict):
            yield from leaves(f"{name}.", value, (*keys, str(key)))
        else:
            yield name, value, (*keys, str(key))


def expression(pattern: str) -> str:
    """A key of a file as a regular expression of the names that it stands for."""
    parts = pattern.strip("/").split("/")
    return "".join("(/[^/]+)*" if part == "**" else "/" + re.escape(part).replace(r"\*", "[^/]*") for part in parts)


def likely_name(sections: Sequence[Section], namespace: str, known: tuple[str, ...]) -> str | None:
    """The name of a node that a launch file does not name: that of the one that a file is for; of several, one that is among `known`."""
    last = dict.fromkeys(section.pattern.rpartition("/")[2] for section in sections if "*" not in section.pattern.rpartition("/")[2])
    names = [name for name in last if any(matcher(section.pattern).fullmatch(f"{namespace}/{name}") for section in sections)]
    return names[0] if len(names) == 1 else next((name for name in known if name in names), None)


# -- what nodes reject --------------------------------------------------------------------------------------------------------


class _Refused(Exception):
    """A node does not take the file."""

    def __init__(self, message: str, event: yaml.Event, meant: tuple[str, str] | None = None) -> None:
        super().__init__(message)
        mark = event.start_mark
        self.refusal = Refusal(message, mark.line + 1 if mark else 1, meant)


def refused(text: str) -> Refusal | None:
    """Why a node does not take a file of parameters with this text, as far as that is known; the text is YAML."""
    events = yaml.parse(text, Loader=_PARSER)
    try:
        for event in events:
            if isinstance(event, yaml.MappingStartEvent):
                _nodes(events, "", None)
            elif isinstance(event, yaml.SequenceStartEvent):
                raise _Refused("it is a list", event)
    except _Refused as error:
        return error.refusal
    except yaml.YAMLError:
        return None
    return None


def refused_value(text: str) -> str | None:
    """Why a node does not take a value of its command line, None when it does."""
    events = (event for event in yaml.parse(text, Loader=_PARSER) if not isinstance(event, _AROUND))
    try:
        for event in events:
            if isinstance(event, yaml.MappingStartEvent):
                return "it is a map"
            _value(events, event, "it")
    except _Refused as error:
        return error.refusal.message
    except yaml.YAMLError:
        return "it is no YAML"
    return None if text else "it has no value"


def _nodes(events: Iterator[yaml.Event], space: str, outer: yaml.ScalarEvent | None) -> None:
    """A map of nodes or namespaces, in the namespace `space` below the key `outer`, whose beginning was read."""
    for key, value in _pairs(events):
        if key.value != _SECTION:
            if not isinstance(value, yaml.MappingStartEvent):
                if outer is not None and _MISSPELT.fullmatch(outer.value):
                    raise _Refused(f"`{outer.value}` is written for `{_SECTION}`", outer, (outer.value, _SECTION))
                raise _Refused(f"the value of `{key.value}` stands before `{_SECTION}`", key)
            if not key.value:
                raise _Refused("a name of a node is empty", key)
            _nodes(events, f"{space}{key.value}" if not space or space.endswith("/") else f"{space}/{key.value}", key)
        elif outer is None:
            raise _Refused(f"no name of a node stands before `{_SECTION}`", key)
        elif not _NODES.fullmatch(space):
            raise _Refused(f"`{space}` is no name of nodes", outer)
        elif isinstance(value, yaml.MappingStartEvent):
            _parameters(events)
        elif isinstance(value, yaml.SequenceStartEvent):
            _maps(events, key)
        else:
            raise _Refused(f"`{_SECTION}` is no map", key)


def _maps(events: Iterator[yaml.Event], key: yaml.ScalarEvent) -> None:
    """The rest of a list in the place of the parameters: rcl takes one of maps."""
    for event in events:
        if isinstance(event, yaml.SequenceEndEvent):
            return
        _require_no_alias(event)
        if not isinstance(event, yaml.MappingStartEvent):
            raise _Refused(f"`{_SECTION}` is no map", key)
        _skip(events)


def _parameters(events: Iterator[yaml.Event], inside: bool = False) -> bool:
    """A map of parameters, whose beginning was read; whether it ends with an empty map, which ends those that it is in for rcl."""
    count, ended = 0, False
    for key, value in _pairs(events):
        count += 1
        if not key.value:
            raise _Refused("the name of a parameter is empty", key)
        if ended and not inside:
            raise _Refused(f"`{key.value}` follows an empty map", key)
        ended = isinstance(value, yaml.MappingStartEvent) and _parameters(events, inside=True)
        if not isinstance(value, yaml.MappingStartEvent):
            _value(events, value, f"the parameter `{key.value}`")
    return ended or not count


def _value(events: Iterator[yaml.Event], value: yaml.Event, subject: str) -> None:
    """The value of a parameter, which is no map and whose beginning was read."""
    _require_no_alias(value)
    if isinstance(value, yaml.SequenceStartEvent):
        _list(events, subject)
    elif isinstance(value, yaml.ScalarEvent) and value.value == "" and value.style not in ("'", '"'):
        raise _Refused(f"{subject} has no value", value)


def _list(events: Iterator[yaml.Event], subject: str) -> None:
    """The elements of the list that `subject` is, whose beginning was read: values of one type, or those of the list that it ends with."""
    types: dict[str, None] = {}
    for event in events:
        if isinstance(event, yaml.SequenceEndEvent):
            break
        if isinstance(event, yaml.SequenceStartEvent):
            _list(events, subject)
            if not isinstance(next(events), yaml.SequenceEndEvent):
                raise _Refused(f"{subject} is a list of lists", event)
            break
        if not isinstance(event, yaml.ScalarEvent):
            _require_no_alias(event)
            if len(set(_values_of_map(events))) > 1:  # to rcl they are elements of the list
                raise _Refused(f"{subject} is a list of maps", event)
            continue
        types[_type(event)] = None
        if len(types) > 1:
            raise _Refused(f"the elements of {subject.removeprefix('the parameter ')} are of several types: {' and '.join(types)}", event)


def _type(event: yaml.ScalarEvent) -> str:
    if event.style in ("'", '"') or event.tag == _TEXT:
        return "texts"
    return next((name for name, _, form in SCALARS if form.fullmatch(event.value)), "texts")


def _pairs(events: Iterator[yaml.Event]) -> Iterator[tuple[yaml.ScalarEvent, Any]]:
    """The keys of a map and the events that their values begin with; each value must be read before the next key."""
    for key in events:
        if isinstance(key, yaml.MappingEndEvent):
            return
        _require_no_alias(key)
        if not isinstance(key, yaml.ScalarEvent):
            raise _Refused("a key is no text", key)
        value = next(events)
        _require_no_alias(value)
        yield key, value


def _values_of_map(events: Iterator[yaml.Event]) -> Iterator[str]:
    """The types of the values of a map, whose beginning was read."""
    for _, value in _pairs(events):
        if isinstance(value, yaml.ScalarEvent):
            yield _type(value)
        else:
            _skip(events)


def _skip(events: Iterator[yaml.Event]) -> None:
    """The rest of a map or a list, whose beginning was read."""
    depth = 1
    while depth:
        event = next(events)
        _require_no_alias(event)
        depth += isinstance(event, (yaml.SequenceStartEvent, yaml.MappingStartEvent))
        depth -= isinstance(event, (yaml.SequenceEndEvent, yaml.MappingEndEvent))


def _require_no_alias(event: yaml.Event) -> None:
    if isinstance(event, yaml.AliasEvent):
        raise _Refused(f"rcl reads no aliases: `*{event.anchor}`", event)
