"""ROS 2 launch files in XML, as elements."""

from __future__ import annotations

from rosarch.extractor.launch.model import Place
from rosarch.extractor.launch.xml_reader import Element, read_launch
from rosarch.extractor.launch_ros2.frontend import Entity


def read_xml(data: bytes, path: str) -> Entity:
    """The `<launch>` of a document.

    Raises:
        XmlError: the document is malformed.
    """
    return _entity(read_launch(data, path), path)


def _entity(element: Element, path: str) -> Entity:
    children = [_entity(child, path) for child in element.children]
    return Entity(element.tag, dict(element.attributes), Place(path, element.line, element.column), children)
