"""The interfaces of a workspace with those of the middlewares that its packages are written for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic
from rosarch.extractor.messages.classes import MessageClass, message_classes
from rosarch.extractor.messages.headers import header_text
from rosarch.extractor.messages.model import Config, MessageStore
from rosarch.extractor.messages.parameter_library import ParameterHeaders
from rosarch.extractor.messages.ros2 import Ros2Headers, ros2_classes
from rosarch.extractor.messages.store import load_messages
from rosarch.extractor.workspace.model import ROS1, ROS2, Package


@dataclass(frozen=True)
class Interfaces:
    """One store for each middleware, None for one that no package is written for: its common definitions differ."""

    ros1: MessageStore | None
    ros2: MessageStore | None
    _headers: Ros2Headers | None
    _parameters: ParameterHeaders

    @classmethod
    def of(cls, packages: Iterable[Package], root: Path) -> Interfaces:
        """Read what the packages define; a definition may be used by both middlewares."""
        packages = list(packages)
        used = {package.middleware for package in packages}
        ros1 = load_messages(packages) if ROS1 in used or not used else None
        ros2 = load_messages(packages, middleware=ROS2) if ROS2 in used else None
        return cls(ros1, ros2, Ros2Headers(ros2) if ros2 else None, ParameterHeaders.of(packages, root))

    @property
    def _stores(self) -> list[MessageStore]:
        return [store for store in (self.ros1, self.ros2) if store is not None]

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """What was not understood, each once."""
        problems = [problem for store in self._stores for problem in store.diagnostics]
        return tuple(dict.fromkeys([*problems, *self._parameters.diagnostics]))

    def header_text(self, header: str) -> str | None:
        """The text of a generated header by the name that code includes it by."""
        text = header_text(self.ros1, header) if self.ros1 else None
        if text is None and self._headers is not None:
            text = self._headers.text(header)
        return self._parameters.texts.get(header) if text is None else text

    def classes(self) -> list[MessageClass]:
        """The C++ classes that stand for interfaces."""
        return [*(message_classes(self.ros1) if self.ros1 else ()), *(ros2_classes(self.ros2) if self.ros2 else ())]

    def configs(self) -> list[Config]:
        """The configurations of dynamic_reconfigure."""
        return [*(self.ros1.configs.values() if self.ros1 else ())]
