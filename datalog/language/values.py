"""Records and algebraic data types as text, in souffle's notation: `[1, nil]`, `$Circle(2)`.

Values may be nested a million deep, a linked list is; nothing here recurses.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from rosarch.datalog.language.domain import domain
from rosarch.datalog.language.types import Types

_SHOWN = 40  # characters of a wrong text that a message repeats


class ValueError_(ValueError):
    """A cell that does not hold a value of its type; the message says why."""


def excerpt(text: str) -> str:
    """A text, cut where it is too long for a message."""
    return text if len(text) <= _SHOWN else text[:_SHOWN] + "..."


def show_value(value: Any) -> str:
    """A value as a record; branches of algebraic data types need their type (`ValueWriter`)."""
    parts: list[str] = []
    work: list[tuple[Any, bool]] = [(value, False)]
    while work:
        item, literal = work.pop()
        if literal:
            parts.append(item)
        elif item is None:
            parts.append("nil")
        elif isinstance(item, tuple):
            parts.append("[")
            work.append(("]", True))
            for index in range(len(item) - 1, -1, -1):
                work.append((item[index], False))
                if index:
                    work.append((", ", True))
        else:
            parts.append(show_float(item) if isinstance(item, float) else str(item))
    return "".join(parts)


def symbols(value: Any) -> Iterator[str]:
    """All texts in a value or row, in order."""
    work = [value]
    while work:
        item = work.pop()
        if isinstance(item, str):
            yield item
        elif isinstance(item, tuple):
            work.extend(reversed(item))


def show_float(value: float, bits: int = 32) -> str:
    """A float with the significant digits that identify it in the number domain: nine, or seventeen for 64 bits."""
    return domain(bits).show_float(value)


class ValueWriter:
    """Writes values by their declared types."""

    def __init__(self, types: Types, *, quoted: bool = False) -> None:
        self.types = types
        self.numbers = domain(types.bits)
        self.quoted = quoted  # whether symbols inside of records are quoted

    def show(self, value: Any, type_name: str) -> str:
        """A value of the named type as text."""
        if isinstance(value, str):
            return value
        if not isinstance(value, tuple) and value is not None:
            return self.numbers.show_float(value) if isinstance(value, float) else str(value)
        parts: list[str] = []
        work: list[tuple[Any, str]] = [(value, type_name)]  # a text to add has no type
        while work:
            item, name = work.pop()
            if not name:
                parts.append(item)
            elif isinstance(item, str):
                parts.append('"' + item.replace("\\", "\\\\").replace('"', '\\"') + '"' if self.quoted else item)
            elif item is None:
                parts.append("nil")
            elif isinstance(item, tuple):
                self._open(item, name, parts, work)
            else:
                parts.append(self.numbers.show_float(item) if isinstance(item, float) else str(item))
        return "".join(parts)

    def _open(self, value: tuple[Any, ...], name: str, parts: list[str], work: list[tuple[Any, str]]) -> None:
        """Write how a record or branch begins, and put the rest of it on the stack."""
        found = self.types.root(name)
        types, args, end = found.fields, value, "]"
        if found.kind == "+":
            types, args, end = dict(found.branches)[value[0]], value[1:], ")" if len(value) > 1 else ""
            parts.append(f"${value[0]}{'(' if args else ''}")
        else:
            parts.append("[")
        work.append((end, ""))
        for index in range(len(args) - 1, -1, -1):
            work.append((args[index], types[index]))
            if index:
                work.append((", ", ""))


@dataclass(slots=True)
class _Open:
    """A record or branch of which the first values have been read."""

    fields: tuple[str, ...]
    end: str
    values: list[Any] = field(default_factory=list)


class ValueReader:
    """Reads values by their declared types."""

    def __init__(self, types: Types) -> None:
        self.types = types
        self.numbers = domain(types.bits)

    def read(self, text: str, type_name: str) -> Any:
        """The value of the named type that a text shows."""
        value, position = self._value(text, type_name)
        position = _skip(text, position)
        if position != len(text):
            raise ValueError_(f"unexpected `{excerpt(text[position:])}` after a value")
        return value

    def _value(self, text: str, wanted: str) -> tuple[Any, int]:
        open_values: list[_Open] = []
        position = 0
        while True:
            position = _skip(text, position)
            found = self.types.root(wanted)
            value: Any = None
            if found.kind == "r" and not text.startswith("nil", position):
                position = _expect(text, position, "[")
                if found.fields:
                    open_values.append(_Open(found.fields, "]"))
                    wanted = found.fields[0]
                    continue
                value, position = (), _expect(text, position, "]")
            elif found.kind == "r":
                position += 3
            elif found.kind == "+":
                name, fields, position = self._branch(text, position, wanted)
                if fields:
                    open_values.append(_Open(fields, ")", [name]))
                    wanted = fields[0]
                    continue
                value = (name,)
            else:
                value, position = self._plain(text, position, found.kind, open_values[-1].end if open_values else "")
            while open_values:
                current = open_values[-1]
                current.values.append(value)
                given = len(current.values) - (current.end == ")")
                if given < len(current.fields):
                    position = _expect(text, position, ",")
                    wanted = current.fields[given]
                    break
                position = _expect(text, position, current.end)
                value = tuple(open_values.pop().values)
            else:
                return value, position

    def _branch(self, text: str, position: int, wanted: str) -> tuple[str, tuple[str, ...], int]:
        """The name of a branch, the types of its fields, and the position after its bracket."""
        found = self.types.root(wanted)
        match = re.compile(r"\$\s*([\w?.]+)").match(text, position)
        branches = dict(found.branches)
        if match is None or match[1] not in branches:
            raise ValueError_(f"expected a branch of `{found.name}` at `{excerpt(text[position:])}`")
        fields, position = branches[match[1]], match.end()
        if fields:
            return match[1], fields, _expect(text, position, "(")
        return match[1], fields, position + 2 if text.startswith("()", position) else position

    def _plain(self, text: str, position: int, kind: str, end: str) -> tuple[Any, int]:
        """A number, or a symbol up to the next delimiter; a quoted symbol up to its closing quote."""
        if kind == "s" and text.startswith('"', position):
            quoted = re.compile(r'"((?:\\.|[^"\\])*)"', re.DOTALL).match(text, position)
            if quoted is None:
                raise ValueError_(f"missing quote after `{excerpt(text[position:])}`")
            return re.sub(r"\\(.)", r"\1", quoted[1], flags=re.DOTALL), quoted.end()
        stop = re.compile(f"[,{re.escape(end)}]").search(text, position) if end else None
        at = stop.start() if stop else len(text)
        cell = text[position:at]
        if kind == "s":
            return cell, at
        try:
            value = self.numbers.single(float(cell)) if kind == "f" else int(cell)
        except ValueError:
            raise ValueError_(f"`{excerpt(cell)}` is not a number") from None
        low, high = (0, self.numbers.mask) if kind == "u" else (-self.numbers.half, self.numbers.half - 1)
        if kind != "f" and not low <= value <= high:
            raise ValueError_(f"`{excerpt(cell)}` is out of range")
        return value, at


def _skip(text: str, position: int) -> int:
    while position < len(text) and text[position].isspace():
        position += 1
    return position


def _expect(text: str, position: int, token: str) -> int:
    position = _skip(text, position)
    if not text.startswith(token, position):
        raise ValueError_(f"expected `{token}` at `{excerpt(text[position:])}`")
    return position + len(token)
