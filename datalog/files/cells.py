"""Cells of fact files to values and back."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from rosarch.datalog.language.domain import Domain, domain
from rosarch.datalog.language.types import Types
from rosarch.datalog.language.values import ValueError_, ValueReader, ValueWriter, excerpt, show_float, show_value

Converter = Callable[[str], Any]
_NUMBER = re.compile(r"[+-]?[0-9]+|[+-]?0x[0-9a-fA-F]+|[+-]?0b[01]+")
_UNSAFE = re.compile(r"[\t\n\r]")


def converter(attribute: Any, reader: ValueReader | None, share: Callable[[str, str], str]) -> Converter:
    """What turns a cell of a column into a value; raises ValueError. Equal symbols become one object by way of `share`."""
    numbers = domain(32) if reader is None else reader.numbers
    if attribute.base == "symbol":
        return lambda cell: share(cell, cell)
    if attribute.base in ("number", "unsigned", "float"):
        read = {"number": read_number, "unsigned": read_unsigned, "float": read_float}[attribute.base]
        return lambda cell: read(cell, numbers)

    def read_value(cell: str) -> Any:
        if reader is None:
            raise ValueError_(f"values of type `{attribute.type}` need the types of a program")
        return reader.read(cell, attribute.type)

    return read_value


def _integer(cell: str, what: str) -> int:
    text = cell.strip()
    if not _NUMBER.fullmatch(text):
        raise ValueError_(f"`{excerpt(cell)}` is not a {what}")
    if len(text) > 80:
        raise ValueError_(f"`{excerpt(cell)}` is out of range for a {what}")
    return int(text, 0) if text.lstrip("+-")[:2] in ("0x", "0b") else int(text)


def read_number(cell: str, numbers: Domain) -> int:
    """A cell of type number."""
    value = _integer(cell, "number")
    if not -numbers.half <= value < numbers.half:
        raise ValueError_(f"`{cell}` is out of range for a number")
    return value


def read_unsigned(cell: str, numbers: Domain) -> int:
    """A cell of type unsigned."""
    value = _integer(cell.removesuffix("u"), "unsigned")
    if not 0 <= value <= numbers.mask:
        raise ValueError_(f"`{cell}` is out of range for an unsigned")
    return value


def read_float(cell: str, numbers: Domain) -> float:
    """A cell of type float."""
    try:
        if "_" in cell:
            raise ValueError  # Python's own notation
        return numbers.single(float(cell))
    except ValueError:
        raise ValueError_(f"`{excerpt(cell)}` is not a float") from None


def show_cell(value: Any) -> str:
    """One value as it is written to a tab-separated file."""
    if isinstance(value, str):
        return _UNSAFE.sub(" ", value) if "\t" in value or "\n" in value or "\r" in value else value
    if isinstance(value, float):
        return show_float(value)
    return str(value) if isinstance(value, int) else _UNSAFE.sub(" ", show_value(value))


def show_cells(row: tuple[Any, ...], attributes: tuple[Any, ...], types: Types | None) -> list[str]:
    """The cells of a row with records or algebraic data types."""
    writer = ValueWriter(types or Types())
    return [_UNSAFE.sub(" ", writer.show(value, a.type)) for value, a in zip(row, attributes, strict=True)]
