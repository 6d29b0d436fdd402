"""Fact files: one tab-separated `.facts` file per relation, as souffle reads and writes them.

A symbol cannot hold a tab or a line break in this format; the writer replaces each by a space.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, Protocol

from .errors import DatalogError, Diagnostic
from .runtime import single
from .types import Types
from .values import ValueError_, ValueReader, ValueWriter, show_float, show_value

MAX_ERRORS = 20


class Columned(Protocol):
    """A declared relation, as far as facts are concerned."""

    @property
    def name(self) -> str:
        """The name of the relation."""

    @property
    def attributes(self) -> tuple[Any, ...]:
        """Its columns, with `name`, `type` and `base`."""


def read_facts(
    folder: Path, relations: Mapping[str, Columned] | Iterable[Columned], *, reader: ValueReader | None = None,
    extension: str = ".facts", params: Mapping[str, Mapping[str, str]] | None = None,
) -> dict[str, list[tuple[Any, ...]]]:  # fmt: skip
    """The rows of each relation that has a file in `folder`; a relation without one has no rows.

    `params` are those of `.input` directives, by relation: `filename` and `delimiter`.
    Raises DatalogError with `path:line: message` for rows that do not fit their declaration.
    """
    declared = relations.values() if isinstance(relations, Mapping) else relations
    result: dict[str, list[tuple[Any, ...]]] = {}
    errors: list[Diagnostic] = []
    pool: dict[str, str] = {}
    for relation in declared:
        given = (params or {}).get(relation.name, {})
        path = folder / given.get("filename", f"{relation.name}{extension}")
        if path.is_file():
            delimiter = given.get("delimiter", "\t")
            result[relation.name] = read_fact_file(path, relation, errors, reader, delimiter, pool)
    if errors:
        raise DatalogError(errors)
    return result


def read_fact_file(
    path: Path, relation: Columned, errors: list[Diagnostic], reader: ValueReader | None = None,
    delimiter: str = "\t", pool: dict[str, str] | None = None,
) -> list[tuple[Any, ...]]:  # fmt: skip
    """The rows of one file; rows that do not fit are added to `errors`.

    Equal symbols become one object, by way of `pool`: joins then compare them by identity and hash each once.
    """
    share = ({} if pool is None else pool).setdefault
    kinds = [a.base for a in relation.attributes]
    try:
        with path.open(encoding="utf-8", errors="surrogateescape", newline="") as stream:
            text = stream.read()
    except OSError as error:
        errors.append(Diagnostic(f"{path}: cannot read: {error.strerror}"))
        return []
    if not kinds:
        return [()] if text.strip() else []
    lines = text.split("\n")
    if lines and not lines[-1]:
        lines.pop()
    if "\r" in text:
        lines = [line.removesuffix("\r") for line in lines]
    if all(kind == "symbol" for kind in kinds):
        rows = [tuple([share(cell, cell) for cell in line.split(delimiter)]) for line in lines]
        if all(len(row) == len(kinds) for row in rows):
            return rows
    converters = [_converter(a, reader, share) for a in relation.attributes]
    result: list[tuple[Any, ...]] = []
    for number, line in enumerate(lines, 1):
        cells = line.split(delimiter)
        if len(cells) != len(kinds):
            _complain(errors, f"{path}:{number}: expected {len(kinds)} column{'s' * (len(kinds) != 1)}, found {len(cells)}")
            continue
        try:
            result.append(tuple([convert(cell) for convert, cell in zip(converters, cells, strict=True)]))
        except ValueError as error:
            column = _failing(converters, cells)
            _complain(errors, f"{path}:{number}: column {column + 1} (`{relation.attributes[column].name}`): {error}")
    return result


def _complain(errors: list[Diagnostic], message: str) -> None:
    if len(errors) < MAX_ERRORS:
        errors.append(Diagnostic(message))


def _failing(converters: list[Callable[[str], Any]], cells: list[str]) -> int:
    for index, (convert, cell) in enumerate(zip(converters, cells, strict=True)):
        try:
            convert(cell)
        except ValueError:
            return index
    return 0


def _converter(attribute: Any, reader: ValueReader | None, share: Callable[[str, str], str]) -> Callable[[str], Any]:
    simple = {
        "symbol": lambda cell: share(cell, cell),
        "number": read_number,
        "unsigned": read_unsigned,
        "float": read_float,
    }
    if attribute.base in simple:
        return simple[attribute.base]

    def read_value(cell: str) -> Any:
        if reader is None:
            raise ValueError_(f"values of type `{attribute.type}` need the types of a program")
        return reader.read(cell, attribute.type)

    return read_value


_NUMBER = re.compile(r"[+-]?[0-9]+|0x[0-9a-fA-F]+|0b[01]+")


def _integer(cell: str, what: str) -> int:
    text = cell.strip()
    if not _NUMBER.fullmatch(text):
        raise ValueError_(f"`{cell}` is not a {what}")
    return int(text, 0) if text[:2] in ("0x", "0b") else int(text)


def read_number(cell: str) -> int:
    """A cell of type number."""
    value = _integer(cell, "number")
    if not -0x80000000 <= value <= 0x7FFFFFFF:
        raise ValueError_(f"`{cell}` is out of range for a number")
    return value


def read_unsigned(cell: str) -> int:
    """A cell of type unsigned."""
    value = _integer(cell.removesuffix("u"), "unsigned")
    if not 0 <= value <= 0xFFFFFFFF:
        raise ValueError_(f"`{cell}` is out of range for an unsigned")
    return value


def read_float(cell: str) -> float:
    """A cell of type float."""
    try:
        return single(float(cell))
    except ValueError:
        raise ValueError_(f"`{cell}` is not a float") from None


_UNSAFE = re.compile(r"[\t\n\r]")


def show_cell(value: Any) -> str:
    """One value as it is written to a file."""
    if isinstance(value, str):
        return _UNSAFE.sub(" ", value) if "\t" in value or "\n" in value or "\r" in value else value
    if isinstance(value, float):
        return show_float(value)
    return str(value) if isinstance(value, int) else _UNSAFE.sub(" ", show_value(value))


def _show_row(row: tuple[Any, ...], attributes: tuple[Any, ...], types: Types | None) -> list[str]:
    """The cells of a row with records or algebraic data types."""
    writer = ValueWriter(types or Types())
    return [_UNSAFE.sub(" ", writer.show(value, a.type)) for value, a in zip(row, attributes, strict=True)]


def write_facts(
    folder: Path, rows: Mapping[str, Iterable[tuple[Any, ...]]], relations: Mapping[str, Columned] | Iterable[Columned],
    *, extension: str = ".facts", types: Types | None = None,
) -> None:  # fmt: skip
    """Write one file per relation that `rows` holds; checks the number of columns against the declaration.

    `types` are needed to write algebraic data types.
    """
    declared = relations if isinstance(relations, Mapping) else {r.name: r for r in relations}
    folder.mkdir(parents=True, exist_ok=True)
    for name, relation_rows in rows.items():
        if name not in declared:
            raise DatalogError(f"cannot write facts of the undeclared relation `{name}`")
        attributes = declared[name].attributes
        arity = len(attributes)
        nested = types is not None and any(a.base in ("record", "adt") for a in attributes)
        lines = []
        for row in relation_rows:
            if len(row) != arity:
                raise DatalogError(f"`{name}` has {arity} attribute{'s' * (arity != 1)}, given {len(row)}: {row!r}")
            lines.append("\t".join(_show_row(row, attributes, types) if nested else map(show_cell, row)) if arity else "()")
        text = "\n".join(lines) + "\n" if lines else ""
        (folder / f"{name}{extension}").write_text(text, encoding="utf-8", errors="surrogateescape", newline="")
