"""The regular expressions of CMake (https://cmake.org/cmake/help/latest/command/string.html#regex-specification).

They know `^ $ . [ ] * + ? | ( )` and no more: a backslash makes what follows it an ordinary character, but for brackets, where it is one.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from rosarch.base.patterns import Pattern, compiled, decoded, encoded

_TOKEN = re.compile(rb"\[(\^?)(\]?[^\]]*)\]|\\(.)|[{}]", re.DOTALL)
_REFERENCE = re.compile(rb"\\([0-9])|\\(.)", re.DOTALL)


def compile_regex(expression: str) -> Pattern:
    """The pattern of an expression of CMake.

    Raises:
        PatternError: it is not valid, or would take too long.
    """
    return compiled(_TOKEN.sub(_translated, encoded(expression)), expression, groups=True)


def find_all(expression: str, text: str) -> list[str]:
    """What matches, one after another."""
    return [decoded(groups[0]) for _, groups in compile_regex(expression).matches(encoded(text))]


def replace(expression: str, replacement: str, text: str, charge: Callable[[int], None]) -> str:
    r"""The text with every match replaced; `\1` is a group. `charge` is called with how many bytes are made."""
    template, data, pieces, end = _template(encoded(replacement)), encoded(text), [], 0
    for (begin, after), groups in compile_regex(expression).matches(data):
        made = b"".join(_group(groups, piece) if isinstance(piece, int) else piece for piece in template)
        charge(len(made))
        pieces += [data[end:begin], made]
        end = after
    return decoded(b"".join([*pieces, data[end:]]))


def _translated(token: re.Match[bytes]) -> bytes:
    negated, members, escaped = token.groups()
    if members is not None:
        return b"[" + negated + members.replace(b"\\", b"\\\\").replace(b"[", b"\\[") + b"]"
    return re.escape(escaped or token.group())


def _template(replacement: bytes) -> list[bytes | int]:
    """What a replacement consists of: bytes, and the numbers of groups."""
    pieces: list[bytes | int] = []
    end = 0
    for match in _REFERENCE.finditer(replacement):
        group, escaped = match.groups()
        pieces += [replacement[end : match.start()], int(group) if group else b"\n" if escaped == b"n" else escaped]
        end = match.end()
    return [*pieces, replacement[end:]]


def _group(groups: tuple[bytes, ...], number: int) -> bytes:
    return groups[number] if number < len(groups) else b""
