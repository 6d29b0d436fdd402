"""The interfaces of hardware that a robot description exports: what controllers of ros2_control command and read.

Source: the ros2_control tags of a URDF document (https://control.ros.org/rolling/doc/getting_started/getting_started.html).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rosarch.extractor.launch.model import Place
from rosarch.extractor.urdf.document import Element

_OWNERS = ("joint", "sensor", "gpio")
_KINDS = {"command_interface": "command", "state_interface": "state"}


@dataclass(frozen=True)
class HardwareInterface:
    """The interface `name` of the joint, sensor or gpio `owner`, which can be commanded or read (`kind`: command, state).

    `plugin` is the class that drives the hardware, named at `driver`.
    """

    kind: str
    owner: str
    name: str
    plugin: str
    place: Place
    driver: Place


def hardware(root: Element) -> Iterator[HardwareInterface]:
    """The interfaces that the `<ros2_control>` tags of a document export, in order."""
    for element in root.elements():
        if element.tag == "ros2_control":
            drivers = (one for part in element.elements() if part.tag == "hardware" for one in part.elements() if one.tag == "plugin")
            plugin, driver = next(((one.text().strip(), one.place) for one in drivers), ("", element.place))
            for owner in (one for one in element.elements() if one.tag in _OWNERS):
                for one in (each for each in owner.elements() if each.tag in _KINDS):
                    name, interface = (each.attributes.get("name", "") for each in (owner, one))
                    yield HardwareInterface(_KINDS[one.tag], name, interface, plugin, one.place, driver)
        else:
            yield from hardware(element)
