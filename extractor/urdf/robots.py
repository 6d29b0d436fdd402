"""Robot descriptions as launch files set them: what a document says of links, joints and groups, and the simulator plugins in it.

Sources: URDF (http://wiki.ros.org/urdf/XML), and SRDF (http://wiki.ros.org/srdf), which has groups of joints for MoveIt.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rosarch.extractor.launch.model import Place
from rosarch.extractor.urdf.document import Element
from rosarch.extractor.urdf.plugins import SimulatorPlugin, plugins

_LEFT_OUT = frozenset({"visual", "collision", "inertial", "gazebo", "disable_collisions", "material"})
"""Elements that say nothing of the tree of links, nor of groups."""
_WITH_TEXT = frozenset({"hardwareInterface"})


@dataclass(frozen=True)
class RobotPart:
    """An element, with its attributes as xacro makes them; `within` is the number of the one that it is in, its own for the root.

    What is between the tags of the interface of a transmission is the attribute `text()`.
    """

    tag: str
    attributes: tuple[tuple[str, str], ...]
    place: Place
    within: int


@dataclass(frozen=True)
class Robot:
    """A document: its elements in order, the first of which is the root, and the simulator plugins in it.

    It is not `whole` when something was left out that is not known.
    """

    parts: tuple[RobotPart, ...]
    plugins: tuple[SimulatorPlugin, ...]
    is_whole: bool = True


def robot(root: Element, *, is_whole: bool = True) -> Robot:
    """What the document with the element `root` says."""
    parts: list[RobotPart] = []
    stack = [(root, 0)]
    while stack:
        element, within = stack.pop()
        number = len(parts)
        attributes = dict(element.attributes)
        if element.tag in _WITH_TEXT:
            attributes["text()"] = element.text().strip()
        parts.append(RobotPart(element.tag, tuple(sorted(attributes.items())), element.place, within))
        stack += [(child, number) for child in reversed(list(_told(element)))]
    return Robot(tuple(parts), plugins(root), is_whole)


def _told(element: Element) -> Iterator[Element]:
    if element.tag == "ros2_control":
        return iter(())
    return (child for child in element.elements() if child.tag not in _LEFT_OUT or (child.tag == "gazebo" and _has_control(child)))


def _has_control(element: Element) -> bool:
    """Whether hardware is described where nobody looks for it."""
    return any(child.tag == "ros2_control" for child in element.elements())
