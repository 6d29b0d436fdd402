"""What bridges to another middleware pass on: topics that arguments and configuration files of nodes name.

Source: ros_gz_bridge (parameter_bridge.cpp, bridge_config.cpp): `TOPIC@ROS_TYPE@TYPE` on the command line, with `[` or `]` in the place of
the second `@` for one direction; a list of maps in the file that the parameter `config_file` names. Ignition had other words for some.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import yaml

from rosarch.base.hints import only_candidate
from rosarch.extractor.launch.arguments import node_arguments
from rosarch.extractor.launch.model import LaunchError, NodeStart, Place
from rosarch.extractor.launch.state import State, written_files
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch.yaml_values import Loader, YamlError, opened, place_of

_WORD = re.compile(r"(?P<topic>[^@\[\]\s]+)@(?P<type>\w+(/\w+)?/\w+)(?P<way>[@\[\]])\w[\w.:]*")
_FILE = "config_file"
_WAYS = {
    **{"@": "both", "[": "from", "]": "to"},
    **{"BIDIRECTIONAL": "both", "GZ_TO_ROS": "from", "ROS_TO_GZ": "to", "IGN_TO_ROS": "from", "ROS_TO_IGN": "to"},
}
_TOPICS = ("topic_name", "ros_topic_name", "gz_topic_name", "ign_topic_name")
"""Which entry of a file is the name in ROS: the first that is there."""
_NEEDED = ((*_TOPICS, "service_name"), ("ros_type_name",), ("gz_type_name", "ign_type_name", "gz_req_type_name"))
"""An entry has one key at least of each of these."""
_KEYS = {*_TOPICS, "service_name", "ros_type_name", "gz_type_name", "gz_req_type_name", "gz_rep_type_name", "direction", "lazy"}


@dataclass(frozen=True)
class Bridged:
    """The topic or service `name` of ROS, of `type` (as written), is passed on: `from` the other middleware, `to` it, or `both` ways."""

    name: str
    type: str
    way: str
    place: Place

    @property
    def kinds(self) -> tuple[str, ...]:
        """The ports that the bridge has in ROS."""
        if "/srv/" in self.type:
            return ("service_server",)
        return {"from": ("publisher",), "to": ("subscriber",)}.get(self.way, ("publisher", "subscriber"))


@dataclass(frozen=True)
class Refused:
    """What a bridge says of an entry that it leaves out; the key `meant` may be what was meant by `written`, which is at `place`."""

    message: str
    place: Place
    written: str = ""
    meant: str = ""


@dataclass(frozen=True)
class BridgeFile:
    """A configuration file of a bridge, read."""

    path: str
    entries: tuple[Bridged, ...]
    refused: tuple[Refused, ...]


def of_arguments(node: NodeStart) -> Iterator[Bridged]:
    """What the arguments of a node say, if they are those of a bridge."""
    for word in node_arguments(node).plain:
        if found := _WORD.fullmatch(word):
            yield Bridged(found["topic"], found["type"], _WAYS[found["way"]], node.lines[-1])


def unread_of_arguments(node: NodeStart) -> list[str]:
    """The arguments that may be those of a bridge, and are not known or not understood."""
    return [word for word in node_arguments(node).plain if ("$(" in word or "@" in word) and not _WORD.fullmatch(word)]


def files_of(node: NodeStart) -> list[str]:
    """The configuration files that a node may be given."""
    values = [setting.value for setting in node.own_params if setting.name.rpartition("/")[2] == _FILE]
    return [value for value in values if isinstance(value, str) and value]


def read_files(state: State, nodes: Iterable[NodeStart]) -> tuple[BridgeFile, ...]:
    """The configuration files of bridges; one that cannot be read, or is none, is left out.

    The lines of a file that launch files write are those of the node that is given it.
    """
    found: dict[str, BridgeFile] = {}
    written = written_files(state)
    for path, place in ((path, node.lines[-1]) for node in nodes for path in files_of(node)):
        if path in found or not (path in written or (is_known(path) and state.files.is_file(path))):
            continue
        try:
            entries = _entries(written[path].encode(), path) if path in written else state.files.parsed(path, _entries)
        except (LaunchError, YamlError):
            continue
        if entries is not None:
            if path in written:
                entries = tuple(replace(one, place=place) for one in entries)
            kept = tuple(one for one in entries if isinstance(one, Bridged))
            found[path] = BridgeFile(path, kept, tuple(one for one in entries if isinstance(one, Refused)))
    return tuple(found.values())


def _entries(data: bytes, path: str) -> tuple[Bridged | Refused, ...] | None:
    with opened(data.decode("utf-8", "replace"), Loader) as (_loader, root):
        if not isinstance(root, yaml.SequenceNode) or not all(isinstance(item, yaml.MappingNode) for item in root.value):
            return None
        return tuple(entry for item in root.value for entry in _entry(item, path))


def _entry(item: yaml.MappingNode, path: str) -> Iterator[Bridged | Refused]:
    yield from _refused(item, path)
    texts = {key.value: value for key, value in item.value if isinstance(key, yaml.ScalarNode) and isinstance(value, yaml.ScalarNode)}
    name = next((texts[key] for key in _TOPICS if key in texts), None)
    way = _WAYS.get(texts["direction"].value if "direction" in texts else "BIDIRECTIONAL")
    if name is not None and way is not None and "ros_type_name" in texts:
        yield Bridged(name.value.strip(), texts["ros_type_name"].value.strip(), way, place_of(name, path))


def _refused(item: yaml.MappingNode, path: str) -> Iterator[Refused]:
    keys = {key.value: place_of(key, path) for key, _ in item.value}
    meant = {written: only_candidate(written, _KEYS) or "" for written in keys if written not in _KEYS}
    for needed in (one for one in _NEEDED if keys.keys().isdisjoint(one)):
        message = f"the entry has no {needed[0]}"
        found = ((keys[written], written, key) for written, key in meant.items() if key in needed)
        yield Refused(message, *next(found, (place_of(item, path),)))
    for key, value in item.value:
        if key.value == "direction" and isinstance(value, yaml.ScalarNode) and value.value not in _WAYS:
            yield Refused(f"there is no direction {value.value}", keys["direction"])
