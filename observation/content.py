"""Messages made to satisfy conditions: which value a field needs, and the bytes of a message that has it."""

from __future__ import annotations

import re
import struct
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from rosarch.base.logic import Not
from rosarch.behavior.composition.components import content_path
from rosarch.extractor.messages import Field, MessageStore
from rosarch.extractor.messages.model import UNBOUNDED
from rosarch.models.machine.conditions import MIRRORED, Comparison, number, parse_condition
from rosarch.models.machine.logic import BOOLEAN, OTHER, Subject

Values = Mapping[str, float | str]
"""The value of each field that matters, by its path: `header.frame_id`."""

_FORMATS = {
    "bool": "?", "byte": "b", "char": "B", "float32": "f", "float64": "d", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H",
    "int32": "i", "uint32": "I", "int64": "q", "uint64": "Q",
}  # fmt: skip
_BESIDE = {"<": (-1.0, 0.0), ">": (1.0, 0.0), "<=": (0.0, 1.0), ">=": (0.0, -1.0), "==": (0.0, 1.0)}
"""What is added to a number so that a comparison with it holds, and so that it does not."""
_DEEPEST = 20


class ContentError(Exception):
    """A message that cannot be made; the text says why."""


def needed(subject: Subject, value: str, members: Collection[str], known: Mapping[str, float]) -> Values | None:
    """The fields of a message that make a condition's `subject` have this `value`; None when it is not about the message.

    `members` are the component's own names, `known` those of which the number is known.
    """
    path = _field_path(subject.text, members)
    if path is not None:
        if subject.values == BOOLEAN:
            return {path: float(value == "true")}
        if value == OTHER:
            taken = {_number(each, known) for each in subject.values}
            return {path: next(float(free) for free in range(100, 200) if free not in taken)}
        wanted = _number(value, known)
        return None if wanted is None else {path: wanted}
    condition, holds = parse_condition(subject.text), value == "true"
    if isinstance(condition, Not):
        condition, holds = condition.inner, not holds
    if not isinstance(condition, Comparison) or subject.values != BOOLEAN:
        return None
    return _compared(condition, holds, members, known)


def _compared(condition: Comparison, holds: bool, members: Collection[str], known: Mapping[str, float]) -> Values | None:
    """The field of a comparison with a number, on one side or the other."""
    left, sign, right = condition.left, condition.op, condition.right
    for operand, op, other in ((left, sign, right), (right, MIRRORED.get(sign, sign), left)):
        path, bound = _field_path(operand, members), _number(other, known)
        if path is not None and bound is not None:
            return {path: bound + _BESIDE[op][0 if holds else 1]}
    return None


def _field_path(text: str, members: Collection[str]) -> str | None:
    """The field that a text names, if it is one of the message itself and no element of a list."""
    path = content_path(text, members)
    return path if path is not None and re.fullmatch(r"[\w.]+", path) else None


def _number(text: str, known: Mapping[str, float]) -> float | None:
    if text in BOOLEAN:
        return float(text == "true")
    literal = number(text)
    return known.get(text.removeprefix("self.").rsplit("::", 1)[-1]) if literal is None else literal


def encoded(store: MessageStore, type_: str, values: Values) -> bytes:
    """A message of ROS 1 with these values, and zeros and empty texts elsewhere.

    Raises:
        ContentError: the type is not known, or has no such field.
    """
    left = dict(values)
    data = b"".join(_message(store, type_, "", left, 0))
    if left:
        raise ContentError(f"{type_} has no field {', '.join(sorted(left))}")
    return data


def _message(store: MessageStore, type_: str, above: str, values: dict[str, float | str], depth: int) -> Iterator[bytes]:
    message = store.messages.get(type_)
    if message is None or depth > _DEEPEST:
        raise ContentError(f"{type_} has no definition")
    for field in message.fields:
        yield from _field(store, field, f"{above}{field.name}", values, depth)


def _field(store: MessageStore, field: Field, path: str, values: dict[str, float | str], depth: int) -> Iterator[bytes]:
    if field.array is None:
        yield from _single(store, field.type, path, values, depth)
    elif field.array == UNBOUNDED:
        yield struct.pack("<I", 0)
    else:
        for index in range(field.array):
            yield from _single(store, field.type, f"{path}[{index}]", values, depth)


def _single(store: MessageStore, type_: str, path: str, values: dict[str, float | str], depth: int) -> Iterator[bytes]:
    if type_ in ("time", "duration"):
        yield bytes(8)
    elif type_ == "string":
        text = str(values.pop(path, "")).encode()
        yield struct.pack("<I", len(text)) + text
    elif type_ in _FORMATS:
        yield _packed(type_, values.pop(path, 0))
    else:
        yield from _message(store, type_, f"{path}.", values, depth + 1)


def _packed(type_: str, value: Any) -> bytes:
    whole = _FORMATS[type_] not in "fd"
    try:
        return struct.pack(f"<{_FORMATS[type_]}", int(value) if whole else float(value))
    except (struct.error, ValueError) as error:
        raise ContentError(f"{value} is no {type_}: {error}") from None
