"""ROS 2 launch files in YAML, as elements: a list of maps with one key, the element's name; lists within an element are its children."""

from __future__ import annotations

from collections.abc import Iterator

import yaml

from rosarch.extractor.launch.model import Place
from rosarch.extractor.launch.unknowns import cleaned
from rosarch.extractor.launch.yaml_values import Loader, YamlError, constructed, opened, place_of
from rosarch.extractor.launch_ros2.frontend import Entity

MAX_DEPTH = 60


def read_yaml(data: bytes, path: str) -> Entity:
    """The `launch:` of a document.

    Raises:
        YamlError: it is no YAML, or no launch file.
    """
    root = Entity("launch", {}, Place(path, 1))
    with opened(cleaned(data.decode("utf-8", "replace")), Loader) as (loader, node):
        constructed(loader, node)  # bounds what aliases unfold to
        if not isinstance(node, yaml.MappingNode):
            raise YamlError("a launch file in YAML is a map with the key `launch`")
        for key, value in node.value:
            if isinstance(key, yaml.ScalarNode) and key.value == "launch":
                root.children.extend(_Elements(loader, path).of_list(value, 0))
    return root


class _Elements:
    """Makes elements of the nodes of a document."""

    def __init__(self, loader: Loader, path: str) -> None:
        self.loader, self.path = loader, path

    def of_list(self, node: yaml.Node, depth: int) -> Iterator[Entity]:
        """The elements of a list: each is a map with one key."""
        _check_depth(node, depth)
        for item in node.value if isinstance(node, yaml.SequenceNode) else [node]:
            if isinstance(item, yaml.MappingNode):
                for key, value in item.value:
                    if isinstance(key, yaml.ScalarNode):
                        yield self.element(key.value, key.start_mark, value, depth + 1)

    def element(self, name: str, mark: yaml.Mark, node: yaml.Node, depth: int) -> Entity:
        """An element called `name`, which is at `mark`."""
        entity = Entity(name, {}, Place(self.path, mark.line + 1, mark.column + 1), typed=True)
        if isinstance(node, yaml.SequenceNode):
            entity.children.extend(self.of_list(node, depth))
        for key, value in node.value if isinstance(node, yaml.MappingNode) else ():
            if not isinstance(key, yaml.ScalarNode):
                continue
            if key.value == "children" or (name == "launch" and isinstance(value, yaml.SequenceNode)):
                entity.children.extend(self.of_list(value, depth))
            elif isinstance(value, yaml.SequenceNode) and any(isinstance(item, yaml.MappingNode) for item in value.value):
                entity.children.extend(self.named(key.value, value, depth))
            else:
                entity.attributes[key.value] = constructed(self.loader, value)
                entity.at[key.value] = place_of(key, self.path)
        return entity

    def named(self, name: str, node: yaml.SequenceNode, depth: int) -> Iterator[Entity]:
        """`param: [{name: a, value: 1}, ...]`: one element a map."""
        _check_depth(node, depth)
        for item in node.value:
            if isinstance(item, yaml.MappingNode):
                yield self.element(name, item.start_mark, item, depth + 1)


def _check_depth(node: yaml.Node, depth: int) -> None:
    if depth > MAX_DEPTH:
        raise YamlError("nested too deeply", node.start_mark.line + 1, node.start_mark.column + 1)
