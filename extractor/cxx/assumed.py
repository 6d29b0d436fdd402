"""Messages, services and actions of which only the name is known: that of the header that a source includes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from rosarch.extractor.messages.ros2 import PARTS, forwarding_text, interface_of, main_header, snake_case

_ROS1 = re.compile(r"([a-z][a-z0-9_]*)/([A-Z]\w*)\.h")
_ABBREVIATION = 4
_KINDS = {"msg": "message", "srv": "service", "action": "action"}


def assumed_text(header: str) -> str:
    """What replaces an absent header; empty when its name is not that of an interface."""
    if match := _ROS1.fullmatch(header):
        return _ros1_text(*match.groups())
    if interface := interface_of(header):
        package, folder, snake = interface
        if header != main_header(*interface):
            return forwarding_text(main_header(*interface))
        return _ros2_text(package, folder, _names(snake))
    return ""


def assumed_classes(header: str) -> list[tuple[str, str, str]]:
    """The C++ classes that an absent header is taken to declare, each with the kind and name of its interface."""
    if match := _ROS1.fullmatch(header):
        package, name = match.groups()
        return [(f"{package}::{name}_", "message", f"{package}/{name}")]
    if interface := interface_of(header):
        package, folder, snake = interface
        return [class_ for name in _names(snake) for class_ in _ros2_classes(package, folder, name)]
    return []


def _ros2_classes(package: str, folder: str, name: str) -> list[tuple[str, str, str]]:
    """The classes of one interface."""
    scope, type_ = f"{package}::{folder}::{name}", f"{package}/{name}"
    if folder == "msg":
        return [(f"{scope}_", "message", type_)]
    parts = [(f"{scope}_{part}_", part.lower(), type_) for part in PARTS[folder]]
    return [(scope, _KINDS[folder], type_), *parts]


def assumed_struct(path: Sequence[str]) -> tuple[str, str] | None:
    """The header and the struct in it that a qualified name means, if it is that of an interface of which only the name is known."""
    if len(path) == 2 and path[1][:1].isupper():
        name = path[1].rstrip("_")
        return f"{path[0]}/{name}.h", f"{name}_"
    if len(path) == 3 and path[1] in _KINDS and path[2][:1].isupper():
        struct = path[2].rstrip("_")
        name = struct.partition("_")[0]
        return main_header(path[0], path[1], snake_case(name)), f"{struct}_"
    return None


def _names(snake: str) -> list[str]:
    """The names that an interface with such a header may have, the likeliest first: the one that the code uses is right."""
    abbreviations = [part for part in snake.split("_") if 1 < len(part) <= _ABBREVIATION]
    return list(dict.fromkeys(_camel_case(snake, upper) for upper in ("", *abbreviations)))


def _camel_case(snake: str, upper: str) -> str:
    """The name that most interfaces with such a header have, with the part `upper` in capitals."""
    return "".join(part.upper() if part == upper else part[:1].upper() + part[1:] for part in snake.split("_"))


def _ros1_text(package: str, name: str) -> str:
    """A message, service or configuration."""
    return (
        "#pragma once\n#include <ros/message_prelude.h>\n"
        f"namespace {package} {{\nstruct {name}_ {{\n"
        f"  typedef boost::shared_ptr<{name}_> Ptr;\n  typedef boost::shared_ptr<{name}_ const> ConstPtr;\n"
        f"  typedef {name}_ Request;\n  typedef {name}_ Response;\n  int request;\n  int response;\n}};\n"
        f"typedef {name}_ {name};\ntypedef boost::shared_ptr<{name}_> {name}Ptr;\n"
        f"typedef boost::shared_ptr<{name}_ const> {name}ConstPtr;\n}}\n"
    )


def _ros2_text(package: str, folder: str, names: Iterable[str]) -> str:
    body = "\n".join(_ros2_struct(folder, name) for name in names)
    return f"#pragma once\n#include <rosarch/message_prelude.hpp>\nnamespace {package} {{ namespace {folder} {{\n{body}\n}}}}\n"


def _ros2_struct(folder: str, name: str) -> str:
    """A message, service or action."""
    parts = PARTS.get(folder, ())
    structs = [
        f"struct {part}_ {{\n  ROSARCH_MESSAGE({part}_)\n}};\ntypedef {part}_ {part};"
        for part in ([f"{name}_{part}" for part in parts] or [name])
    ]
    if parts:
        members = [f"  typedef {name}_{part} {part};" for part in parts]
        structs.append("\n".join([f"struct {name} {{", *members, f"  ROSARCH_{_KINDS[folder].upper()}({name})", "};"]))
    return "\n".join(structs)
