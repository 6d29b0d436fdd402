"""Rows as lines of text, many at a time and without a list of them all."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import islice
from typing import Any

from rosarch.datalog.engine.runtime import ordered
from rosarch.datalog.language.types import Types
from rosarch.datalog.language.values import ValueWriter

CHUNK = 1 << 14  # rows
Show = Callable[[Any], str]


def column_writer(type_name: str, types: Types) -> Show:
    """What writes the values of a column of the named type."""
    kind = types.kind(type_name) if types.exists(type_name) else ""
    if kind == "s":
        return _same
    if kind in ("i", "u"):
        return str
    writer = ValueWriter(types)
    if kind == "f":
        return writer.numbers.show_float
    return lambda value: writer.show(value, type_name)


def _same(value: str) -> str:
    return value


def line_chunks(rows: Collection[Any], writers: Sequence[Show], delimiter: str = "\t") -> Iterator[str]:
    """The lines of rows as relations store them, in the order of the rows, in pieces of many lines each.

    A row without columns is the line `()`.
    """
    if not writers:
        yield from ("()\n" for _ in rows)
    elif hasattr(rows, "sorted_groups"):
        show_first, show_second = writers
        for first, seconds in rows.sorted_groups():
            start = show_first(first) + delimiter
            yield f"{start}{(chr(10) + start).join(map(show_second, seconds))}\n"
    else:
        iterator = iter(ordered(rows))
        while chunk := list(islice(iterator, CHUNK)):
            cells = [map(writers[0], chunk)] if len(writers) == 1 else _columns(chunk, writers)
            yield "\n".join(map(delimiter.join, zip(*cells, strict=True))) + "\n"


def _columns(rows: Sequence[tuple[Any, ...]], writers: Sequence[Show]) -> list[Any]:
    return [column if show is _same else map(show, column) for show, column in zip(writers, zip(*rows, strict=True), strict=True)]
