"""Delimited text to rows: tab-separated `.facts` files, other delimiters, RFC 4180."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any, Protocol

from rosarch.datalog.files.cells import Converter, converter
from rosarch.datalog.language.errors import DatalogError, Diagnostic
from rosarch.datalog.language.values import ValueError_, ValueReader

MAX_ERRORS = 20
MAX_LINE = 1 << 26  # bytes; a longer line is not a row but a mistake
_CHUNK = 1 << 24
_GZIP = b"\x1f\x8b"


class Columned(Protocol):
    """A declared relation, as far as facts are concerned."""

    @property
    def name(self) -> str:
        """The name of the relation."""

    @property
    def attributes(self) -> tuple[Any, ...]:
        """Its columns, with `name`, `type` and `base`."""


@dataclass(frozen=True, slots=True)
class Layout:
    """How rows are written in a text; `columns` are the positions of the attributes in a line, all in order when empty."""

    delimiter: str = "\t"
    headers: bool = False
    rfc4180: bool = False
    columns: tuple[int, ...] = ()
    wider: bool = False  # a line may have more columns than are declared, as souffle allows


PLAIN = Layout()


def complain(errors: list[Diagnostic], message: str) -> None:
    """Add an error, unless there are many already."""
    if len(errors) < MAX_ERRORS:
        errors.append(Diagnostic(message))


def read_text(path: Path, *, strict: bool = False) -> str:
    """The text of a file, which may be gzip-compressed.

    Bytes that are not UTF-8 are kept as surrogates, or are an error when `strict`. Raises DatalogError with `path:line: message`.
    """
    try:
        with path.open("rb") as stream:
            if stream.peek(2)[:2] != _GZIP:
                return decode(read_bytes(stream, str(path)), str(path), strict)
            return decode(_unpacked(stream, str(path)), str(path), strict)
    except (OSError, EOFError) as error:
        raise DatalogError(f"{path}: cannot read: {getattr(error, 'strerror', None) or error}") from None


def _unpacked(stream: IO[bytes], shown: str) -> bytes:
    import gzip
    import zlib

    try:
        with gzip.open(stream) as unpacked:
            return read_bytes(unpacked, shown)
    except zlib.error as error:
        raise DatalogError(f"{shown}: cannot read: {error}") from None


def read_bytes(stream: IO[bytes] | Any, shown: str) -> bytes:
    """All bytes of a stream, up to a line that is too long to be one."""
    chunks: list[bytes] = []
    line, length = 1, 0
    while chunk := stream.read(_CHUNK):
        first = chunk.find(b"\n")
        length += len(chunk) if first < 0 else first
        if length > MAX_LINE:
            raise DatalogError(f"{shown}:{line}: a line of more than {MAX_LINE >> 20} MiB")
        if first >= 0:
            line += chunk.count(b"\n")
            length = len(chunk) - chunk.rfind(b"\n") - 1
        chunks.append(chunk)
    return b"".join(chunks)


def decode(data: bytes, shown: str, strict: bool) -> str:
    """Bytes as text; DatalogError with the line of the first byte that is not UTF-8 when `strict`."""
    try:
        return data.decode("utf-8", "strict" if strict else "surrogateescape")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise DatalogError(f"{shown}:{line}: not UTF-8 text: byte 0x{data[error.start]:02x}") from None


def parse_table(
    text: str, shown: str, relation: Columned, errors: list[Diagnostic], reader: ValueReader | None = None,
    layout: Layout = PLAIN, pool: dict[str, str] | None = None,
) -> list[tuple[Any, ...]]:  # fmt: skip
    """The rows of a text; rows that do not fit are added to `errors`.

    Equal symbols become one object, by way of `pool`: joins then compare them by identity and hash each once.
    """
    share = ({} if pool is None else pool).setdefault
    kinds = [a.base for a in relation.attributes]
    if layout.rfc4180:
        return _convert(_quoted_lines(text, shown, layout, errors), shown, relation, errors, layout, _converters(relation, reader, share))
    lines = text.split("\n")
    if lines and not lines[-1]:
        lines.pop()
    if "\r" in text:
        lines = [line.removesuffix("\r") for line in lines]
    if layout.headers:
        lines = lines[1:]
    if not kinds:
        return [()] if lines else []
    delimiter = layout.delimiter
    if not layout.columns and all(kind == "symbol" for kind in kinds):
        rows = [tuple([share(cell, cell) for cell in line.split(delimiter)]) for line in lines]
        if all(len(row) == len(kinds) for row in rows):
            return rows
    nested = "," in delimiter and any(kind in ("record", "adt") for kind in kinds)
    split = (lambda line: _outer_split(line, delimiter)) if nested else (lambda line: line.split(delimiter))
    numbered = ((number, split(line)) for number, line in enumerate(lines, 1 + layout.headers))
    return _convert(numbered, shown, relation, errors, layout, _converters(relation, reader, share))


def _converters(relation: Columned, reader: ValueReader | None, share: Any) -> list[Converter]:
    return [converter(a, reader, share) for a in relation.attributes]


def _convert(
    lines: Iterator[tuple[int, list[str]]], shown: str, relation: Columned, errors: list[Diagnostic],
    layout: Layout, converters: Sequence[Converter],
) -> list[tuple[Any, ...]]:  # fmt: skip
    expected = max(layout.columns, default=-1) + 1 or len(converters)
    result: list[tuple[Any, ...]] = []
    for number, cells in lines:
        if len(cells) != expected and (len(cells) < expected or not (layout.columns or layout.wider)):
            complain(errors, f"{shown}:{number}: expected {expected} column{'s' * (expected != 1)}, found {len(cells)}")
            continue
        if layout.columns:
            cells = [cells[c] for c in layout.columns]
        elif len(cells) > expected:
            cells = cells[:expected]
        try:
            result.append(tuple([convert(cell) for convert, cell in zip(converters, cells, strict=True)]))
        except ValueError as error:
            column = _failing(converters, cells)
            complain(errors, f"{shown}:{number}: column {column + 1} (`{relation.attributes[column].name}`): {error}")
    return result


def _failing(converters: Sequence[Converter], cells: list[str]) -> int:
    for index, (convert, cell) in enumerate(zip(converters, cells, strict=True)):
        try:
            convert(cell)
        except ValueError:
            return index
    return 0


def _outer_split(line: str, delimiter: str) -> list[str]:
    """The cells of a line in which records may hold the delimiter."""
    cells, depth, start = [], 0, 0
    for token in re.finditer(rf'"(?:\\.|[^"\\])*"|[\[\](){{}}]|{re.escape(delimiter)}', line):
        if token[0] in ("[", "("):
            depth += 1
        elif token[0] in ("]", ")"):
            depth -= 1
        elif token[0] == delimiter and depth == 0:
            cells.append(line[start : token.start()])
            start = token.end()
    return [*cells, line[start:]]


_QUOTED = re.compile(r'"((?:[^"]|"")*)"')


def _quoted_lines(text: str, shown: str, layout: Layout, errors: list[Diagnostic]) -> Iterator[tuple[int, list[str]]]:
    """The lines of RFC 4180: cells may be quoted, quotes in them are doubled, and quoted cells may hold line breaks."""
    stop = re.compile(rf"{re.escape(layout.delimiter)}|\r?\n|\Z")
    position, line = 0, 1
    while position < len(text):
        cells: list[str] = []
        start = line
        while True:
            quoted = _QUOTED.match(text, position)
            if quoted is None and text.startswith('"', position):
                complain(errors, f"{shown}:{line}: a quote that is not closed")
                return
            end = stop.search(text, quoted.end() if quoted else position)
            if end is None or (quoted and end.start() != quoted.end()):
                complain(errors, f"{shown}:{line}: expected a delimiter after a quoted cell")
                return
            cells.append(quoted[1].replace('""', '"') if quoted else text[position : end.start()])
            line += quoted[1].count("\n") if quoted else 0
            position = end.end()
            if end[0] != layout.delimiter:
                break
        line += 1
        if not (layout.headers and start == 1):
            yield start, cells


__all__ = ["MAX_ERRORS", "PLAIN", "Columned", "Layout", "ValueError_", "complain", "decode", "parse_table", "read_bytes", "read_text"]
