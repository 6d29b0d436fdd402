"""Records and algebraic data types as text, in souffle's notation: `[1, nil]`, `$Circle(2)`."""

from __future__ import annotations

import re
from typing import Any

from .runtime import single
from .types import Types


class ValueError_(ValueError):
    """A cell that does not hold a value of its type; the message says why."""


def show_value(value: Any) -> str:
    """A value as a record; branches of algebraic data types need their type (`ValueWriter`)."""
    if value is None:
        return "nil"
    if isinstance(value, tuple):
        return f"[{', '.join(show_value(v) for v in value)}]"
    return show_float(value) if isinstance(value, float) else str(value)


def show_float(value: float) -> str:
    """A float with the nine significant digits that identify a single-precision value."""
    return f"{value:.9g}"


class ValueWriter:
    """Writes values by their declared types."""

    def __init__(self, types: Types) -> None:
        self.types = types

    def show(self, value: Any, type_name: str) -> str:
        """A value of the named type as text."""
        if isinstance(value, str):
            return value
        found = self.types.root(type_name)
        if found.kind == "r":
            if value is None:
                return "nil"
            return f"[{', '.join(self.show(v, t) for v, t in zip(value, found.fields, strict=True))}]"
        if found.kind == "+":
            fields = dict(found.branches)[value[0]]
            args = ", ".join(self.show(v, t) for v, t in zip(value[1:], fields, strict=True))
            return f"${value[0]}({args})" if fields else f"${value[0]}"
        return show_float(value) if isinstance(value, float) else str(value)


class ValueReader:
    """Reads values by their declared types."""

    def __init__(self, types: Types) -> None:
        self.types = types

    def read(self, text: str, type_name: str) -> Any:
        """The value of the named type that a text shows."""
        value, position = self._value(text, self._skip(text, 0), type_name)
        position = self._skip(text, position)
        if position != len(text):
            raise ValueError_(f"unexpected `{text[position:]}` after a value")
        return value

    @staticmethod
    def _skip(text: str, position: int) -> int:
        while position < len(text) and text[position] == " ":
            position += 1
        return position

    def _expect(self, text: str, position: int, token: str) -> int:
        position = self._skip(text, position)
        if not text.startswith(token, position):
            raise ValueError_(f"expected `{token}` at `{text[position:]}`")
        return position + len(token)

    def _value(self, text: str, position: int, type_name: str) -> tuple[Any, int]:
        found = self.types.root(type_name)
        position = self._skip(text, position)
        if found.kind == "r":
            if text.startswith("nil", position):
                return None, position + 3
            return self._list(text, self._expect(text, position, "["), found.fields, "]")
        if found.kind == "+":
            match = re.compile(r"\$([\w?.]+)").match(text, position)
            branches = dict(found.branches)
            if match is None or match[1] not in branches:
                raise ValueError_(f"expected a branch of `{found.name}` at `{text[position:]}`")
            fields, position = branches[match[1]], match.end()
            if not fields:
                if text.startswith("()", position):
                    position += 2
                return (match[1],), position
            args, position = self._list(text, self._expect(text, position, "("), fields, ")")
            return (match[1], *args), position
        return self._plain(text, position, found.kind)

    def _list(self, text: str, position: int, fields: tuple[str, ...], end: str) -> tuple[tuple[Any, ...], int]:
        values = []
        for index, field_type in enumerate(fields):
            if index:
                position = self._expect(text, position, ",")
            value, position = self._value(text, position, field_type)
            values.append(value)
        return tuple(values), self._expect(text, position, end)

    @staticmethod
    def _plain(text: str, position: int, kind: str) -> tuple[Any, int]:
        """A number, or a symbol up to the next delimiter; a quoted symbol up to its closing quote."""
        if kind == "s" and text.startswith('"', position):
            end = text.find('"', position + 1)
            end = len(text) if end < 0 else end
            return text[position + 1 : end], end + 1
        end = position
        while end < len(text) and text[end] not in ",])":
            end += 1
        cell = text[position:end]
        try:
            return cell if kind == "s" else single(float(cell)) if kind == "f" else int(cell), end
        except ValueError:
            raise ValueError_(f"`{cell}` is not a number") from None
