"""The text of a Python source and its syntax tree."""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.files import LARGEST_PARSED, read_file
from rosarch.extractor.python.python2 import as_python3, in_its_lines
from rosarch.extractor.python_fstrings import with_older_fstrings
from rosarch.extractor.python_syntax import parse_as_it_stands

_ENCODING = re.compile(rb"^[ \t\f]*#.*?coding[:=][ \t]*([-\w.]+)")


@dataclass(frozen=True)
class Problem:
    """What was not understood of a source, and where."""

    line: int
    column: int
    message: str


@dataclass(frozen=True)
class Parsed:
    """A source as Python 3 has it: its bytes (UTF-8), its tree, and what there is to say about it.

    What stands from the line `left_out` on is not read (0: all is).
    """

    data: bytes
    tree: ast.Module
    problems: tuple[Problem, ...] = ()
    left_out: int = 0


def read_source(path: Path) -> Parsed | Problem:
    """Parse a source of Python 3 or, converted, of Python 2."""
    data = read_file(path, LARGEST_PARSED)
    if b"\0" in data:
        return Problem(data.count(b"\n", 0, data.index(b"\0")) + 1, 1, "not a text file")
    text, problems = _decoded(data)
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    tree = _parse(text)
    if isinstance(tree, ast.Module):
        return Parsed(text.encode(), tree, problems)
    rewritten = with_older_fstrings(text)
    if rewritten is not None and isinstance(newer := _parse(rewritten), ast.Module):
        return Parsed(rewritten.encode(), newer, problems)
    older = as_python3(text) if "nested" not in tree.message else None
    if older is not None:
        converted = _parse(older)
        if isinstance(converted, ast.Module):
            told = Problem(tree.line, tree.column, "Python 2: read as what 2to3 makes of it")
            return Parsed(in_its_lines(older, converted).encode(), converted, (*problems, told))
    return _partial(text, tree, problems)


def _partial(text: str, error: Problem, problems: tuple[Problem, ...]) -> Parsed | Problem:
    """What stands before a syntax error, as far as it is complete: up to the last statement of the module that begins before it."""
    lines = text.split("\n")
    starts = [index for index, line in enumerate(lines[: error.line]) if line[:1].strip() and line[0] not in "#)]}"]
    for index in reversed(starts[-20:]):
        tree = _parse("\n".join(lines[:index]))
        if isinstance(tree, ast.Module):
            kept = Problem(error.line, error.column, f"{error.message}; what stands from line {index + 1} on is left out")
            return Parsed("\n".join(lines[:index]).encode(), tree, (*problems, kept), index + 1)
    return error


def _decoded(data: bytes) -> tuple[str, tuple[Problem, ...]]:
    data = data.removeprefix(b"\xef\xbb\xbf")
    told = next((match.group(1).decode() for line in data.split(b"\n")[:2] if (match := _ENCODING.match(line))), "utf-8")
    try:
        return data.decode(told), ()
    except (UnicodeDecodeError, LookupError):
        try:
            return data.decode("utf-8"), ()
        except UnicodeDecodeError as error:
            line = data.count(b"\n", 0, error.start) + 1
            column = error.start - data.rfind(b"\n", 0, error.start)
            return data.decode("latin-1"), (Problem(line, column, f"not UTF-8 (byte 0x{data[error.start]:02x}); read as Latin-1"),)


def _parse(text: str) -> ast.Module | Problem:
    try:
        return parse_as_it_stands(text)
    except SyntaxError as error:
        return Problem(error.lineno or 1, max(error.offset or 1, 1), f"syntax error: {error.msg}")
