"""Text of the input as it may be shown: it never moves the cursor, breaks a row or turns what is beside it around."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar

Value = TypeVar("Value")


def printable(text: str) -> str:
    r"""The text with control, format and other invisible characters as escapes: `\n`, `\x1b`, `\u202e`."""
    return text if text.isprintable() else "".join(c if c.isprintable() else _escape(c) for c in text)


def code_span(text: str) -> str:
    """Any text as code in Markdown."""
    text = printable(text)
    fence = "`" * (1 + max((len(run) for run in re.findall("`+", text)), default=0))
    return f"{fence} {text} {fence}" if "`" in text else f"`{text}`"


def printable_lines(text: str) -> str:
    """A text of lines, tabs within them, each line printable."""
    return re.sub(r"[^\t\n]+", lambda part: printable(part[0]), text)


def json_text(data: object, indent: int = 2) -> str:
    r"""A document of JSON with the same characters as escapes, which mean themselves to a reader: `\u001b`, `\u202e`."""
    text = json.dumps(data, indent=indent, ensure_ascii=False)
    return re.sub(r"[^ -~\n]+", lambda part: part[0] if part[0].isprintable() else _json_escapes(part[0]), text) + "\n"


def _json_escapes(text: str) -> str:
    return "".join(c if c.isprintable() else json.dumps(c)[1:-1] if c != "\x7f" else "\\u007f" for c in text)


def _escape(character: str) -> str:
    code = ord(character)
    if 0xDC80 <= code <= 0xDCFF:  # a byte of a file's name that is not UTF-8
        return f"\\x{code - 0xDC00:02x}"
    return character.encode("unicode_escape").decode()


def all_printable(value: Value) -> Value:
    """A model or document with every text in it printable."""
    return _all_printable(value)  # type: ignore[no-any-return]


def _all_printable(value: Any) -> Any:
    if isinstance(value, str):
        return printable(value)
    if isinstance(value, tuple):
        return tuple(map(_all_printable, value))
    if isinstance(value, list):
        return list(map(_all_printable, value))
    if isinstance(value, Mapping):
        return {printable(key): _all_printable(inner) for key, inner in value.items()}
    if is_dataclass(value) and not isinstance(value, type):
        return replace(value, **{each.name: _all_printable(getattr(value, each.name)) for each in fields(value)})
    return value
