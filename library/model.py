"""What the library knows about a component.

That is the part of a component model that matters to a composed system, and how names are made from what only a launch file or a robot's
description says.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

GENERATED, BY_HAND = "generated", "by hand"


@dataclass(frozen=True)
class Source:
    """Where packages come from, and the distributions of ROS that this revision is for."""

    origin: str
    revision: str
    distributions: tuple[str, ...] = ()


def _given(row: LibraryPort | LibraryParameter) -> dict[str, Any]:
    """The fields that say something; a name that only a launch file gives is `?`."""
    said = {
        key: value for key, value in vars(row).items() if value is not None and (key == "default" or (value is not False and value != {}))
    }
    return {**said, "name": row.name or "?"}


@dataclass(frozen=True)
class LibraryPort:
    """A port; see `docs/library.md`. `name` is None where only an argument or a parameter gives it."""

    kind: str
    name: str | None = None
    type: str | None = None
    from_param: str | None = None
    queue: int | None = None
    latched: bool = False
    via: str = "plain"
    implicit: bool = False
    conditional: str | None = None
    from_arg: int | None = None
    rest: bool = False
    if_arg: Mapping[int, str] = field(default_factory=dict)
    param_pattern: str | None = None
    suffix: str | None = None


@dataclass(frozen=True)
class LibraryParameter:
    """A parameter that is accessed: the one called `name`, or each whose whole name matches `pattern`."""

    name: str | None = None
    op: str = "read"
    type: str | None = None
    default: Any = None
    pattern: str | None = None


@dataclass(frozen=True)
class LibraryComponent:
    """A node, nodelet, plug-in or plug-in of gazebo. `path` is the file that its base was read from.

    `makes` are nodes that it makes as well: their names in its namespace, and the component (`PACKAGE/COMPONENT`) of each. It is of the
    versions of ROS in `ros`, of any where that is empty; its sources are those of the `distributions`.
    """

    package: str
    component: str
    kind: str
    ports: tuple[LibraryPort, ...] = ()
    params: tuple[LibraryParameter, ...] = ()
    node_name: str | None = None
    base: str | None = None
    loads: tuple[str, ...] = ()
    open_ports: bool = False
    open_params: bool = False
    options: tuple[str, ...] | None = None
    elements: Mapping[str, str | None] = field(default_factory=dict)
    namespace_element: str | None = None
    makes: Mapping[str, str] = field(default_factory=dict)
    origin: str = ""
    revision: str = ""
    made: str = BY_HAND
    ros: tuple[int, ...] = ()
    distributions: tuple[str, ...] = ()
    path: Path = Path()

    @property
    def open(self) -> bool:
        """Whether there may be more than is listed."""
        return self.open_ports or self.open_params

    def document(self) -> dict[str, Any]:
        """This component in the form of component models, as far as it is known, and with what only the library has."""
        return {
            "component": self.component,
            "package": self.package,
            "kind": self.kind,
            "node_name": self.node_name,
            "plugin": {"name": self.component, "base": self.base} if self.base else None,
            "loads": list(self.loads),
            "open": self.open,
            "open_ports": self.open_ports,
            "open_params": self.open_params,
            "options": None if self.options is None else list(self.options),
            "elements": dict(self.elements),
            "namespace_element": self.namespace_element,
            "makes": dict(self.makes),
            "ports": [{"id": f"p{number}", **_given(port)} for number, port in enumerate(self.ports, 1)],
            "params": [_given(parameter) for parameter in self.params],
            "origin": self.origin,
            "revision": self.revision,
            "ros": list(self.ros),
            "distributions": list(self.distributions),
            "made": self.made,
        }

    @property
    def title(self) -> str:
        """`package/component`, or the lookup name where that begins with the package."""
        return self.component if self.component.startswith(f"{self.package}/") else f"{self.package}/{self.component}"
