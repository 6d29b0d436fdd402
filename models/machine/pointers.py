"""Pointers and optionals: which texts say that one is null, and which that it is not."""

from __future__ import annotations

import re
from collections.abc import Collection

from rosarch.models.machine.conditions import strip

_OPTIONAL = re.compile(r"(boost::)?optional<")
_POINTER = re.compile(r"\*\s*$|Ptr\b|_ptr\b|::ConstPtr\b")
_ASKED = re.compile(r"(?:\.|->)(?:has_value|is_initialized|get)\(\)$")
_EMPTIED = re.compile(r"^\{\}$|(?:\.|->)reset\((?:nullptr|NULL)?\)$")
_REPLACED = re.compile(r"(?:\.|->)reset\((.+)\)$")
_MOVED = re.compile(r"(?:std::)?move\((.+)\)$")
_PART = re.compile(r"(\w+)(?:\.|->)[\w.]+$")
_OBJECT = re.compile(r"new\b|&|(\w+::)*(make_shared|make_unique|allocate_shared|make_optional)\b")


def may_be_null(type_: str) -> bool:
    """Whether a variable of a type, without `std::`, is a pointer or an optional."""
    return bool(_POINTER.search(type_) or _OPTIONAL.match(type_))


def begins_null(type_: str) -> bool:
    """Whether one to which the source gives nothing is null: smart pointers and optionals are."""
    return "Ptr" in type_ or "_ptr<" in type_ or bool(_OPTIONAL.match(type_))


def asked_object(text: str) -> str:
    """The pointer or optional that a test such as `x.has_value()` is about; other texts as they are."""
    return _ASKED.sub("", text)


def is_nothing(type_: str, value: str) -> bool:
    """Whether what a pointer or an optional is given makes it null."""
    return may_be_null(type_) and bool(_EMPTIED.search(strip(value)))


def is_something(type_: str, value: str, messages: Collection[str]) -> bool:
    """Whether what a pointer or an optional is given is certainly an object; `messages` are what messages are called there."""
    text = strip(value)
    if match := _REPLACED.search(text):
        text = strip(match[1])
    if match := _MOVED.match(text):
        text = strip(match[1])
    if text in messages or _OBJECT.match(text):
        return True
    held = re.search(r"(\w+)>$", type_) if _OPTIONAL.match(type_) else None
    made = held and rf"\*|(\w+::)*{held[1].rstrip('_')}\s*[({{]|.*(\.|->)emplace\("
    return bool(made and (re.match(made, text) or is_field(text, messages)))


def is_field(value: str, messages: Collection[str]) -> bool:
    """Whether a value is a field of one of the `messages`: such is neither a pointer nor an optional, and never None."""
    part = _PART.match(strip(value))
    return part is not None and part[1] in messages
