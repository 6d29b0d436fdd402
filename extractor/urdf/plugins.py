"""The simulator plugins that a URDF or SDF document loads."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rosarch.extractor.launch.model import Place
from rosarch.extractor.urdf.document import Element


@dataclass(frozen=True)
class SimulatorPlugin:
    """A `<plugin>`.

    `reference` is the link or joint that it is for: that of `<gazebo reference="...">`, or the SDF link it is in. `sensor` is the sensor it
    is in. `elements` are the elements in it that have no others in them, with their texts, in order; the name of a nested one is its path
    (`ros/namespace`); `places` says where they are. `place` is where the plugin is written, be it in the macro of an included file.
    """

    filename: str
    name: str
    reference: str | None
    sensor: str | None
    elements: tuple[tuple[str, str], ...]
    place: Place
    places: tuple[Place, ...] = ()


def plugins(root: Element) -> tuple[SimulatorPlugin, ...]:
    """The plugins in a document, in order."""
    return tuple(_below(root, None, None))


def _below(element: Element, reference: str | None, sensor: str | None) -> Iterator[SimulatorPlugin]:
    if element.tag == "plugin":
        filename, called = (element.attributes.get(name, "") for name in ("filename", "name"))
        leaves = list(_leaves(element, ""))
        elements, places = tuple((name, text) for name, text, _ in leaves), tuple(place for _, _, place in leaves)
        yield SimulatorPlugin(filename, called, reference, sensor, elements, element.place, places)
        return
    if element.tag == "gazebo":
        reference = element.attributes.get("reference")
    elif element.tag == "link":
        reference = element.attributes.get("name")
    elif element.tag == "sensor":
        sensor = element.attributes.get("name")
    for child in element.elements():
        yield from _below(child, reference, sensor)


def _leaves(element: Element, path: str) -> Iterator[tuple[str, str, Place]]:
    for child in element.elements():
        name = path + child.tag
        if next(child.elements(), None) is None:
            yield name, child.text().strip(), child.place
        else:
            yield from _leaves(child, f"{name}/")
