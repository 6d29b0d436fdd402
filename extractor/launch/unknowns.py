"""Texts with unknown parts.

While a launch file is composed, each part of a text that cannot be known is one character of Unicode's last private plane. Texts stay plain
strings: they can be joined, split and used as keys, equal unknowns are equal characters, and `render` puts the `$(...)` of the source
back. Text that is read is cleaned of this plane first, so that no input can pose as an unknown.
"""

from __future__ import annotations

import re
from collections.abc import Hashable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rosarch.extractor.launch.formulas import Formula

_FIRST = 0x100000
_CAPACITY = 0xFFF0
_MARK = re.compile("[\U00100000-\U0010ffff]")
_UNUSABLE = re.compile("[\ud800-\udfff\U00100000-\U0010ffff]")  # marks, and bytes that were no UTF-8
_REPLACEMENT = "\ufffd"


def is_known(text: str) -> bool:
    """Whether `text` has no unknown part."""
    return _MARK.search(text) is None


def with_unknowns_as(replacement: str, text: str) -> str:
    """`text` with each unknown part replaced."""
    return _MARK.sub(replacement, text)


def may_be(text: str, known: str) -> bool:
    """Whether `text`, which has unknown parts, may turn out to be `known`."""
    return re.fullmatch(".*".join(map(re.escape, _MARK.split(text))), known, re.DOTALL) is not None


def cleaned(text: str) -> str:
    """`text` as read from outside, without characters that mean an unknown here or cannot be written."""
    return text if text.isascii() else _UNUSABLE.sub(_REPLACEMENT, text)


def marks_in(text: str) -> frozenset[str]:
    """The unknown parts of `text`."""
    return frozenset() if text.isascii() else frozenset(_MARK.findall(text))


class Unknowns:
    """The unknowns of one composition. `truths` says when those that are Booleans are true."""

    def __init__(self) -> None:
        self.truths: dict[str, Formula] = {}
        self._texts: list[str] = []
        self._marks: dict[Hashable, str] = {}
        self._numbers: dict[str, int] = {}
        self._names: set[str] = set()

    def mark(self, text: str, *identity: Hashable) -> str:
        """The character for an unknown that the source writes as `text`; the same for the same text and `identity`."""
        key = (text, *identity)
        if key not in self._marks:
            self._marks[key] = self._new(text)
        return self._marks[key]

    def fresh(self, name: str) -> str:
        """The character for a new anonymous name; the second one of the same `name` is distinguished by its number."""
        self._numbers[name] = number = self._numbers.get(name, 0) + 1
        mark = self._new(f"$(anon {name})" if number == 1 else f"$(anon {name} {number})")
        self._names.add(mark)
        return mark

    def is_open(self, text: str) -> bool:
        """Whether `text` may turn out to be any text: it has an unknown part that is no anonymous name."""
        return not text.isascii() and any(mark not in self._names for mark in _MARK.findall(text))

    def _new(self, text: str) -> str:
        if len(self._texts) < _CAPACITY:
            self._texts.append(text)
        return chr(_FIRST + len(self._texts) - 1)

    def render(self, text: str) -> str:
        """`text` with its unknown parts as the source writes them."""
        if text.isascii():
            return text
        return _MARK.sub(lambda match: self._text(match[0]), text)

    def _text(self, mark: str) -> str:
        index = ord(mark) - _FIRST
        return self._texts[index] if index < len(self._texts) else _REPLACEMENT
