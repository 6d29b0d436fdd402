"""C++ headers as the ROS 2 generators would write them (rosidl_generator_cpp), for a parser that sees no generated files.

The structs are plain, not templates; a struct is called `Name_`, so that a field may be called like its message.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable

from rosarch.extractor.messages.classes import MessageClass
from rosarch.extractor.messages.headers import integer_value
from rosarch.extractor.messages.model import PRIMITIVES, UNBOUNDED, Constant, Field, Message, MessageStore

PRELUDE = "rosarch/message_prelude.hpp"
_CXX = {
    "byte": "unsigned char", "char": "uint8_t", "float32": "float", "float64": "double", "string": "std::string",
    "wstring": "std::u16string", "bool": "bool", "time": "::builtin_interfaces::msg::Time_",
    "duration": "::builtin_interfaces::msg::Duration_",
}  # fmt: skip
_HEADER = re.compile(r"([a-z][a-z0-9_]*)/(msg|srv|action)/(?:detail/)?([a-z][a-z0-9_]*?)(?:__[a-z]\w*)?\.hpp")
PARTS = {"srv": ("Request", "Response"), "action": ("Goal", "Result", "Feedback")}
_OWNER = {"request": "srv", "response": "srv", "goal": "action", "result": "action", "feedback": "action"}


def snake_case(name: str) -> str:
    """The name of the header of an interface, as rosidl makes it."""
    name = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    return re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name).lower()


def interface_of(header: str) -> tuple[str, str, str] | None:
    """Package, folder and snake-case name of the interface that a header of this name declares, or a part of whose code it is."""
    match = _HEADER.fullmatch(header)
    return (match[1], match[2], match[3]) if match else None


def main_header(package: str, folder: str, snake: str) -> str:
    """The name of the header that declares an interface."""
    return f"{package}/{folder}/{snake}.hpp"


def forwarding_text(header: str) -> str:
    """The text of a header that only includes another one."""
    return f"#pragma once\n#include <{header}>\n"


class Ros2Headers:
    """The headers of a store's interfaces, by the names that code includes them by."""

    def __init__(self, store: MessageStore) -> None:
        self.store = store
        folders: tuple[tuple[str, Iterable[str]], ...] = (
            ("msg", (message.name for message in store.messages.values() if message.role == "message")),
            ("srv", store.services),
            ("action", store.actions),
        )
        self._interfaces = {(package, folder, snake_case(short)): name for folder, names in folders for name in names
                            for package, _, short in [name.partition("/")]}  # fmt: skip

    def text(self, header: str) -> str | None:
        """The text of a header such as `std_msgs/msg/string.hpp`; None when no interface is called so."""
        interface = interface_of(header)
        name = self._interfaces.get(interface) if interface else None
        if interface is None or name is None:
            return None
        if header != main_header(*interface):
            return forwarding_text(main_header(*interface))
        folder = interface[1]
        if folder == "msg":
            return self._page(name, folder, [self.store.messages[name]])
        return self._page(name, folder, [self.store.messages[name + part] for part in PARTS[folder]])

    def _page(self, name: str, folder: str, messages: list[Message]) -> str:
        package, _, short = name.partition("/")
        used = dict.fromkeys(_builtin(field.type) for message in messages for field in message.fields if field.type not in _PLAIN)
        includes = [PRELUDE, *(_header_of(type_) for type_ in used if type_ in self.store.messages and type_ != name)]
        body = [line for message in messages for line in self._struct(message)]
        if folder != "msg":
            typedefs = [f"  typedef {short}_{part} {part};" for part in PARTS[folder]]
            body += [f"struct {short} {{", *typedefs, f"  ROSARCH_{'SERVICE' if folder == 'srv' else 'ACTION'}({short})", "};"]
        lines = ["#pragma once", *(f"#include <{header}>" for header in includes), "", f"namespace {package} {{ namespace {folder} {{"]
        return "\n".join([*lines, *body, "}}", ""])

    def _struct(self, message: Message) -> list[str]:
        alias = _short_class(message)
        struct = f"{alias}_"
        lines = [f"struct {struct} {{", f"  ROSARCH_MESSAGE({struct})", *(f"  {_constant(constant)}" for constant in message.constants)]
        for field in message.fields:
            cxx = self._field_type(field)
            lines += [f"  typedef {cxx} _{field.name}_type;", f"  _{field.name}_type {field.name};"] if cxx else []
        return [*lines, "};", f"typedef {struct} {alias};"]

    def _field_type(self, field: Field) -> str | None:
        if field.type in PRIMITIVES:
            item = _CXX.get(field.type, f"{field.type}_t")
        elif field.type in self.store.messages:
            item = f"::{cxx_class(self.store.messages[field.type])}"
        else:
            return None
        if field.array is None:
            return item
        return f"std::vector<{item}>" if field.array == UNBOUNDED else f"std::array<{item}, {field.array}>"


_PLAIN = PRIMITIVES - {"time", "duration"}


def _builtin(type_: str) -> str:
    return {"time": "builtin_interfaces/Time", "duration": "builtin_interfaces/Duration"}.get(type_, type_)


def _header_of(type_: str) -> str:
    package, _, short = type_.partition("/")
    return main_header(package, "msg", snake_case(short))


def _short_class(message: Message) -> str:
    """The unqualified name of a message's class: `Name`, or `Name_Request` of a part."""
    short = message.name.partition("/")[2]
    if message.role not in _OWNER:
        return short
    part = message.role.capitalize()
    return f"{short.removesuffix(part)}_{part}"


def cxx_class(message: Message) -> str:
    """The qualified name of the struct of a message."""
    package = message.name.partition("/")[0]
    return f"{package}::{_OWNER.get(message.role, 'msg')}::{_short_class(message)}_"


def ros2_classes(store: MessageStore) -> list[MessageClass]:
    """All classes of a store, sorted by name."""
    result = [
        MessageClass(cxx_class(message), message.name, "message", message.role, message.owner)
        for message in store.messages.values()
        if message.role == "message" or message.role in _OWNER
    ]
    for folder, kind, names in (("srv", "service", store.services), ("action", "action", store.actions)):
        for name in names:
            package, _, short = name.partition("/")
            result.append(MessageClass(f"{package}::{folder}::{short}", name, kind, kind))
    return sorted(result, key=lambda found: found.cxx_class)


def _constant(constant: Constant) -> str:
    if constant.type == "string":
        text = constant.value[1:-1] if constant.value[:1] in ("'", '"') and constant.value[:1] == constant.value[-1:] else constant.value
        return f"inline static const std::string {constant.name} = {json.dumps(text)};"
    if constant.type in ("wstring", "float32", "float64"):
        return f"static const {_CXX[constant.type]} {constant.name};"
    kind = _CXX.get(constant.type, f"{constant.type}_t")
    return f"static constexpr {kind} {constant.name} = {integer_value(constant)};"
