"""Configuration files of viewers that nodes are given: their displays, tools and panels, and the topics that these name.

Source: the files of rviz (http://wiki.ros.org/rviz/UserGuide), where ROS 2 puts the topic's name and its quality of service into a map.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import yaml

from rosarch.extractor.launch.arguments import node_arguments
from rosarch.extractor.launch.model import LaunchError, NodeStart, Place
from rosarch.extractor.launch.state import State, written_files
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch.yaml_values import Loader, YamlError, opened, place_of

_ENDING = ".rviz"
_POLICIES = {"Durability Policy": "durability", "Reliability Policy": "reliability"}


@dataclass(frozen=True)
class ViewTopic:
    """The topic `name` that the part's `property` names, with the policies of its quality of service."""

    property: str
    name: str
    qualities: tuple[tuple[str, str], ...]
    place: Place


@dataclass(frozen=True)
class ViewPart:
    """A display, tool or panel (its `role`) that is enabled, of the class that the file names."""

    role: str
    class_name: str
    topics: tuple[ViewTopic, ...]
    place: Place


@dataclass(frozen=True)
class View:
    """A configuration file; all is shown in the `frame` that it names. One that launch files write is `at` the node that gets it."""

    path: str
    parts: tuple[ViewPart, ...]
    frame: tuple[str, Place] | None
    at: Place | None = None


def views_of(state: State, nodes: Iterable[NodeStart]) -> tuple[View, ...]:
    """The configuration files that the arguments of nodes name; one that cannot be read is left out."""
    found: dict[str, View] = {}
    written = written_files(state)
    for path, place in ((word, node.lines[-1]) for node in nodes for word in node_arguments(node).plain):
        if path in found or not (path in written or (path.endswith(_ENDING) and is_known(path) and state.files.is_file(path))):
            continue
        try:
            if path in written:
                found[path] = replace(_view(written[path].encode(), path), at=place)
            else:
                found[path] = state.files.parsed(path, _view)
        except (LaunchError, YamlError):
            continue
    return tuple(found.values())


def _view(data: bytes, path: str) -> View:
    with opened(data.decode("utf-8", "replace"), Loader) as (_loader, root):
        top = _entries(root)
        manager = _entries(top.get("Visualization Manager"))
        listed = (("panel", top.get("Panels")), ("display", manager.get("Displays")), ("tool", manager.get("Tools")))
        frame = _entries(manager.get("Global Options")).get("Fixed Frame")
        named = (_text(frame), place_of(frame, path)) if frame is not None else None
        return View(path, tuple(part for role, items in listed for part in _listed(role, items, path)), named)


def _listed(role: str, items: yaml.Node | None, path: str) -> Iterator[ViewPart]:
    for item in items.value if isinstance(items, yaml.SequenceNode) else ():
        entries = _entries(item)
        if _text(entries.get("Enabled")) == "false":
            continue
        class_name = entries.get("Class")
        if class_name is not None:
            yield ViewPart(role, _text(class_name), tuple(_topics(item, path)), place_of(class_name, path))
        yield from _listed(role, entries.get("Displays"), path)  # those of a group


def _topics(item: yaml.Node, path: str) -> Iterator[ViewTopic]:
    for property_, value in _entries(item).items():
        if property_.endswith("Topic"):
            inner = _entries(value)
            named = inner.get("Value", value)
            if name := _text(named):
                qualities = [(policy, _text(inner[key]).lower().replace(" ", "_")) for key, policy in _POLICIES.items() if key in inner]
                yield ViewTopic(property_, name, tuple(qualities), place_of(named, path))


def _entries(node: yaml.Node | None) -> dict[str, yaml.Node]:
    pairs = node.value if isinstance(node, yaml.MappingNode) else ()
    return {key.value: value for key, value in pairs if isinstance(key, yaml.ScalarNode)}


def _text(node: yaml.Node | None) -> str:
    return str(node.value).strip() if isinstance(node, yaml.ScalarNode) else ""
