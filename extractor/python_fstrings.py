"""f-strings as Python 3.12 and newer write them (PEP 701), for parsers of older Pythons.

From 3.12 on, an expression in `f"..."` may have quotes of the same kind, line breaks and comments. Such a text is given three quotes,
within which older parsers take them too. Lines stay where they are.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

_STRING = re.compile(r"(?i:([rbuf]{0,2}))('''|\"\"\"|'|\")")
_WORD = re.compile(r"\w+")
_DEEPEST = 3


class _NoText(Exception):
    """The source is no Python of any version, or one that older parsers cannot be given."""


@dataclass
class _Scan:
    """The places of a source where something else is to stand: (from, to, what)."""

    text: str
    edits: list[tuple[int, int, str]] = field(default_factory=list)

    def code(self, at: int, *, inner: int = 0) -> int:
        """Where the code that begins at `at` ends: at the end of the text, or, `inner` to so many f-strings, behind the expression."""
        text, depth = self.text, 0
        while at < len(text):
            character = text[at]
            string = _STRING.match(text, at)
            if string:
                at = self.string(string, inner)
            elif character.isalnum() or character == "_":
                word = _WORD.match(text, at)
                assert word is not None
                at = word.end()
            elif character == "#":
                end = text.find("\n", at)
                end = len(text) if end < 0 else end
                if inner:
                    self.edits.append((at, end, ""))
                at = end
            elif inner and not depth and (character in "}:" or (character == "!" and text[at + 1 : at + 2] != "=")):
                return at
            else:
                depth += (character in "([{") - (character in ")]}")
                at += 1
        if inner:
            raise _NoText
        return at

    def string(self, start: re.Match[str], inner: int) -> int:
        """Where the text that begins with `start` ends."""
        prefix, quote = start.group(1).lower(), start.group(2)
        if "f" in prefix:
            return self.formatted(start, inner)
        text, at = self.text, start.end()
        while not text.startswith(quote, at):
            if at >= len(text) or (len(quote) == 1 and text[at] == "\n"):
                raise _NoText
            at += 2 if text[at] == "\\" else 1
        if inner and "\\" in text[start.end() : at]:  # older parsers take no backslash here: the text is an unknown one
            lines = text.count("\n", start.end(), at)
            unknown = f"{quote[0]}?{quote[0]}"
            self.edits.append((start.start(2), at + len(quote), "(" + "\n" * lines + f"{unknown})" if lines else unknown))
        return at + len(quote)

    def formatted(self, start: re.Match[str], inner: int) -> int:
        """Where the f-string that begins with `start` ends; it is given three quotes if its expressions need that."""
        text, quote, at, needed = self.text, start.group(2), start.end(), False
        if inner >= _DEEPEST:
            raise _NoText
        while not text.startswith(quote, at):
            if at >= len(text) or (len(quote) == 1 and text[at] == "\n"):
                raise _NoText
            if text[at] == "\\":
                named = text.startswith("\\N{", at) and "r" not in start.group(1).lower()
                at = text.find("}", at) + 1 if named else at + 2
                if not at:
                    raise _NoText
            elif text.startswith(("{{", "}}"), at):
                at += 2
            elif text[at] == "{":
                end = self.expression(at + 1, inner + 1)
                needed = needed or "\n" in text[at:end] or quote[0] in text[at:end]
                at = end
            else:
                at += 1
        if needed and len(quote) == 1:
            triple = 3 * (quote if not inner else "'" if inner == 1 else "")
            if not triple or triple in text[start.end() : at]:
                raise _NoText
            self.edits += [(start.start(2), start.end(2), triple), (at, at + 1, triple)]
        return at + len(quote)

    def expression(self, at: int, inner: int) -> int:
        """Where a replacement field ends, behind its brace."""
        text, at = self.text, self.code(at, inner=inner)
        if text[at] == "!":
            at = self.code(at + 1, inner=inner)
        if text[at] == ":":
            at += 1
            while text[at : at + 1] != "}":
                if at >= len(text):
                    raise _NoText
                at = self.expression(at + 1, inner) if text[at] == "{" else at + 1
        return at + 1


def with_older_fstrings(text: str) -> str | None:
    """The source as parsers of Python before 3.12 take it; None when there is nothing to change or that cannot be."""
    if "f'" not in text.lower() and 'f"' not in text.lower():
        return None
    scan = _Scan(text)
    try:
        scan.code(0)
    except (_NoText, RecursionError, IndexError):
        return None
    parts, last = [], 0
    for begin, end, put in sorted(scan.edits):
        parts += [text[last:begin], put]
        last = end
    return "".join([*parts, text[last:]]) if scan.edits else None
