"""Messages made to satisfy conditions: which value a field needs, and the bytes of a message that has it."""

from __future__ import annotations

import re
import struct
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from rosarch.composition.inputs import content_path
from rosarch.extractor.messages import Field, MessageStore
from rosarch.models.machine.logic import BOOLEAN, OTHER, Subject

Values = Mapping[str, float | str]
"""The value of each field that matters, by its path: `header.frame_id`."""

_FORMATS = {
    "bool": "?", "byte": "b", "char": "B", "float32": "f", "float64": "d", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H",
    "int32": "i", "uint32": "I", "int64": "q", "uint64": "Q",
}  # fmt: skip
_COMPARED = re.compile(r"(.+?)\s*(<=|(?<!-)>=|==|!=|<|(?<!-)>)\s*(.+)")
_DEEPEST = 20


class ContentError(Exception):
    """A message that cannot be made; the text says why."""


def needed(subject: Subject, value: str, members: Collection[str], known: Mapping[str, float]) -> Values | None:
    """The fields of a message that make a condition's `subject` have this `value`; None when it is not about the message.

    `members` are the component's own names, `known` those of which the number is known.
    """
    path = content_path(subject.text, members)
    if path is not None and re.fullmatch(r"[\w.]+", path):
        if subject.values == BOOLEAN:
            return {path: float(value == "true")}
        number = _number(value, known)
        if value == OTHER:
            taken = {_number(each, known) for each in subject.values}
            return {path: next(float(free) for free in range(100, 200) if free not in taken)}
        return None if number is None else {path: number}
    match = _COMPARED.fullmatch(subject.text)
    if match is None or subject.values != BOOLEAN:
        return None
    return _compared((match[1], match[2], match[3]), value == "true", members, known)


def _compared(parts: tuple[str, str, str], holds: bool, members: Collection[str], known: Mapping[str, float]) -> Values | None:
    """The field of a comparison with a number, on one side or the other."""
    left, sign, right = parts
    for operand, bound, own in ((left, right, sign), (right, left, _TURNED.get(sign, sign))):
        path, number = content_path(operand, members), _number(bound, known)
        if path is not None and re.fullmatch(r"[\w.]+", path) and number is not None:
            return {path: _beside(number, own, holds)}
    return None


_TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}
_OPPOSITE = {"<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "=="}


def _beside(number: float, sign: str, holds: bool) -> float:
    """A number for which the comparison holds, or does not."""
    return {"<": -1.0, ">": 1.0, "!=": 1.0}.get(sign if holds else _OPPOSITE[sign], 0.0) + number


def _number(text: str, known: Mapping[str, float]) -> float | None:
    if text in BOOLEAN:
        return float(text == "true")
    try:
        return float(text.rstrip("fFlLuU"))
    except ValueError:
        return known.get(text.rsplit("::", 1)[-1])


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
    if field.array is not None:
        if field.array < 0:
            yield struct.pack("<I", 0)
            return
        for number in range(field.array):
            yield from _single(store, field.type, f"{path}[{number}]", values, depth)
        return
    yield from _single(store, field.type, path, values, depth)


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
