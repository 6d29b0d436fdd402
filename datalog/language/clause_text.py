"""Where a clause ends in the text of its file."""

from __future__ import annotations

import re

# a dot within a name or a number ends nothing
TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|//[^\n]*|/\*.*?\*/|[\w?]+(?:\.[\w?]+)+|\.|\s+', re.DOTALL)


def clause_end(text: str, start: int) -> int:
    """The position behind the dot that ends the clause at `start`."""
    return next((token.end() for token in TOKEN.finditer(text, start) if token[0] == "."), len(text))


def offset(text: str, line: int, column: int) -> int:
    """The position of a line and column, both from 1."""
    return sum(len(each) for each in text.splitlines(keepends=True)[: line - 1]) + column - 1


def blanked(text: str, start: int, end: int) -> str:
    """The text with spaces for what is between two positions, so that all else stays in its place."""
    return text[:start] + re.sub(r"[^\n]", " ", text[start:end]) + text[end:]
