"""ROS interfaces as plain data: messages, services, actions, dynamic_reconfigure configurations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic

PRIMITIVES = frozenset(
    {
        "bool", "byte", "char", "float32", "float64", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64",
        "string", "wstring", "time", "duration",
    }
)  # fmt: skip
UNBOUNDED = -1


@dataclass(frozen=True, slots=True)
class Field:
    """A field. `type` is a primitive or `pkg/Name`; `array` is None, `UNBOUNDED` or a length; `type_exists`: its type is defined."""

    name: str
    type: str
    array: int | None = None
    default: str | None = None
    type_exists: bool = True
    line: int = 0
    column: int = 0


@dataclass(frozen=True, slots=True)
class Constant:
    """A constant with its value as written."""

    name: str
    type: str
    value: str


@dataclass(frozen=True, slots=True)
class Message:
    """A message type `pkg/Name`. `role` is `message`, or its part in a service (`request`, `response`) or action."""

    name: str
    fields: tuple[Field, ...] = ()
    constants: tuple[Constant, ...] = ()
    path: Path | None = None
    role: str = "message"
    owner: str | None = None


@dataclass(frozen=True, slots=True)
class Service:
    """A service type; request and response are message types of the store."""

    name: str
    path: Path | None = None

    @property
    def request(self) -> str:
        """The request's message type."""
        return f"{self.name}Request"

    @property
    def response(self) -> str:
        """The response's message type."""
        return f"{self.name}Response"


@dataclass(frozen=True, slots=True)
class Action:
    """An action type; its seven messages are in the store."""

    name: str
    path: Path | None = None


@dataclass(frozen=True, slots=True)
class ConfigParameter:
    """A parameter of a `.cfg` file. `default`, `minimum`, `maximum` are Python text, None when absent or not constant."""

    name: str
    type: str
    default: str | None = None
    minimum: str | None = None
    maximum: str | None = None
    description: str = ""
    line: int = 0


@dataclass(frozen=True, slots=True)
class ConfigConstant:
    """A constant of an enumeration in a `.cfg` file."""

    name: str
    type: str
    value: str


@dataclass(frozen=True, slots=True)
class Config:
    """A dynamic_reconfigure configuration `pkg/Name`; the C++ class is `pkg::NameConfig`."""

    name: str
    path: Path
    parameters: tuple[ConfigParameter, ...] = ()
    constants: tuple[ConfigConstant, ...] = ()


@dataclass(frozen=True, eq=False)
class MessageStore:
    """All known interfaces by `pkg/Name`."""

    messages: Mapping[str, Message] = field(default_factory=dict)
    services: Mapping[str, Service] = field(default_factory=dict)
    actions: Mapping[str, Action] = field(default_factory=dict)
    configs: Mapping[str, Config] = field(default_factory=dict)
    diagnostics: tuple[Diagnostic, ...] = ()
