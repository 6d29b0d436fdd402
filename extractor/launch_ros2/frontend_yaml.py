"""ROS 2 launch files in YAML, as elements: a list of maps with one key, the element's name; lists within an element are its children."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import yaml

from rosarch.extractor.launch.model import Place
from rosarch.extractor.launch.unknowns import cleaned
from rosarch.extractor.launch.yaml_values import Loader
from rosarch.extractor.xml_reader import XmlError

from .frontend import Entity

MAX_DEPTH = 60


def read_yaml(data: bytes, path: str) -> Entity:
    """The `launch:` of a document.

    Raises:
        XmlError: it is no YAML, or no launch file.
    """
    try:
        loader = Loader(cleaned(data.decode("utf-8", "replace")))
        try:
            node = loader.get_single_node()
        finally:
            loader.dispose()
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        raise XmlError(
            " ".join(filter(None, (error.context, error.problem))), mark.line + 1 if mark else 1, mark.column + 1 if mark else 1
        ) from None
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise XmlError(" ".join(str(error).split()) or "nested too deeply", 1, 1) from None
    if not isinstance(node, yaml.MappingNode):
        raise XmlError("a launch file in YAML is a map with the key `launch`", 1, 1)
    root = Entity("launch", {}, Place(path, 1))
    for key, value in node.value:
        if isinstance(key, yaml.ScalarNode) and key.value == "launch":
            root.children.extend(_elements(value, path, 0))
    return root


def _elements(node: yaml.Node, path: str, depth: int) -> Iterator[Entity]:
    """The elements of a list: each is a map with one key."""
    if depth > MAX_DEPTH:
        raise XmlError("nested too deeply", node.start_mark.line + 1, node.start_mark.column + 1)
    for item in node.value if isinstance(node, yaml.SequenceNode) else [node]:
        if isinstance(item, yaml.MappingNode):
            for key, value in item.value:
                if isinstance(key, yaml.ScalarNode):
                    yield _element(key, value, path, depth + 1)


def _element(key: yaml.ScalarNode, node: yaml.Node, path: str, depth: int) -> Entity:
    entity = Entity(key.value, {}, Place(path, key.start_mark.line + 1, key.start_mark.column + 1))
    if isinstance(node, yaml.SequenceNode):
        entity.children.extend(_elements(node, path, depth))
    for name, value in node.value if isinstance(node, yaml.MappingNode) else ():
        if not isinstance(name, yaml.ScalarNode):
            continue
        if name.value == "children" or (entity.name == "launch" and isinstance(value, yaml.SequenceNode)):
            entity.children.extend(_elements(value, path, depth))
        elif isinstance(value, yaml.SequenceNode) and any(isinstance(item, yaml.MappingNode) for item in value.value):
            entity.children.extend(_items(name, value, path, depth))
        else:
            entity.attributes[name.value] = _plain(value)
    return entity


def _items(name: yaml.ScalarNode, node: yaml.SequenceNode, path: str, depth: int) -> Iterator[Entity]:
    """`param: [{name: a, value: 1}, ...]`: one element a map."""
    if depth > MAX_DEPTH:
        raise XmlError("nested too deeply", node.start_mark.line + 1, node.start_mark.column + 1)
    for item in node.value:
        if isinstance(item, yaml.MappingNode):
            place = yaml.ScalarNode("", name.value, item.start_mark, item.end_mark)
            yield _element(place, item, path, depth + 1)


def _plain(node: yaml.Node) -> Any:
    loader = Loader("")
    try:
        return loader.construct_object(node, deep=True)
    finally:
        loader.dispose()
