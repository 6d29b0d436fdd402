"""Rows as JSON, as souffle reads and writes them: a list of lists, or a list of objects with the names of the attributes.

Records are lists or objects too, nil is `null`. Branches of algebraic data types, which souffle has no JSON for, are rejected.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from rosarch.datalog.language.domain import domain
from rosarch.datalog.language.errors import DatalogError
from rosarch.datalog.language.types import Types
from rosarch.datalog.language.values import ValueError_

if TYPE_CHECKING:
    from rosarch.datalog.program import Program, RelationDecl

Row = tuple[Any, ...]


def parse_rows(text: str, shown: str, relation: RelationDecl, program: Program) -> list[Row]:
    """The rows of a JSON document. Raises DatalogError with the place of a syntax error, or the number of a row that does not fit."""
    try:
        document = json.loads(text)
    except json.JSONDecodeError as error:
        raise DatalogError(f"{shown}:{error.lineno}:{error.colno}: not JSON: {error.msg}") from None
    except RecursionError:
        raise DatalogError(f"{shown}: JSON that is nested too deeply") from None
    if not isinstance(document, list):
        raise DatalogError(f"{shown}:1: expected a list of rows")
    names = tuple(a.name for a in relation.attributes)
    types = tuple(a.type for a in relation.attributes)
    rows = []
    for number, item in enumerate(document, 1):
        try:
            rows.append(_fields(item, names, types, program.types))
        except ValueError as error:
            raise DatalogError(f"{shown}: row {number}: {error}") from None
        except RecursionError:
            raise DatalogError(f"{shown}: row {number}: nested too deeply") from None
    return rows


def _fields(item: Any, names: tuple[str, ...], types: tuple[str, ...], known: Types) -> Row:
    if isinstance(item, dict):
        unknown = [name for name in item if name not in names]
        missing = [name for name in names if name not in item]
        if unknown or missing:
            raise ValueError_(f"unknown attribute `{unknown[0]}`" if unknown else f"attribute `{missing[0]}` is missing")
        item = [item[name] for name in names]
    if not isinstance(item, list):
        raise ValueError_("neither a list nor an object")
    if len(item) != len(types):
        raise ValueError_(f"expected {len(types)} value{'s' * (len(types) != 1)}, found {len(item)}")
    return tuple(_value(part, name, known) for part, name in zip(item, types, strict=True))


def _value(item: Any, type_name: str, known: Types) -> Any:
    found, numbers = known.root(type_name), domain(known.bits)
    match found.kind:
        case "s" if isinstance(item, str):
            return item
        case "i" if type(item) is int and -numbers.half <= item < numbers.half:
            return item
        case "u" if type(item) is int and 0 <= item <= numbers.mask:
            return item
        case "f" if type(item) in (int, float):
            return numbers.single(float(item))
        case "r":
            return None if item is None else _fields(item, known.field_names(found.name), found.fields, known)
        case "+":
            raise ValueError_(f"a value of `{type_name}` cannot be read from JSON")
    raise ValueError_(f"`{json.dumps(item)[:40]}` is not a value of `{type_name}`")


def show_rows(rows: Iterable[Row], relation: RelationDecl, types: Types, objects: bool) -> Iterator[str]:
    """The document in pieces."""
    yield "["
    for number, row in enumerate(rows):
        yield ",\n" if number else ""
        yield from _show(row, relation, types, objects)
    yield "]\n"


def _show(row: Row, relation: RelationDecl, types: Types, objects: bool) -> Iterator[str]:
    if not row:
        yield "null\n"
        return
    numbers = domain(types.bits)
    work: list[tuple[Any, str]] = []

    def push(values: Row, names: tuple[str, ...], of: tuple[str, ...]) -> str:
        work.append(("}" if objects else "]", ""))
        for index in range(len(values) - 1, -1, -1):
            work.append((values[index], of[index]))
            if objects:
                work.append((f"{json.dumps(names[index], ensure_ascii=False)}: ", ""))
            if index:
                work.append((", ", ""))
        return "{" if objects else "["

    yield push(row, tuple(a.name for a in relation.attributes), tuple(a.type for a in relation.attributes))
    while work:
        value, type_name = work.pop()
        if not type_name:
            yield value
        elif isinstance(value, str):
            yield json.dumps(value, ensure_ascii=False)
        elif value is None:
            yield "null"
        elif isinstance(value, tuple):
            found = types.root(type_name)
            if found.kind == "+":
                raise DatalogError(f"`{relation.name}`: a value of `{type_name}` cannot be written as JSON")
            yield push(value, types.field_names(found.name), found.fields)
        else:
            yield numbers.show_float(value) if isinstance(value, float) else str(value)
