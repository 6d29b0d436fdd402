"""Regular expressions that the input brings, or that are made from its wildcards: matched by RE2, in time linear in the text.

Python's matcher tries alternatives one after another, and some expressions keep it busy forever. Expressions and texts are bytes to
RE2, as they are to CMake and to file systems.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from functools import lru_cache
from typing import Any

from rosarch.base import tracing

MAX_WORK = 1 << 28
"""Bytes of a text times instructions of an expression: seconds, for what is worst."""
MAX_SECONDS = 2.0
"""Of processor time, for all matches of an expression in a text."""
_MAX_GROUPS = 31


class PatternError(ValueError):
    """An expression that is not valid, or that would take too long; the message names it and says why."""


class Pattern:
    """An expression in RE2's POSIX syntax, where `.` is any byte and `^` and `$` are the ends of the text; the first alternative wins."""

    def __init__(self, expression: bytes, written: str, groups: bool) -> None:
        import re2  # what has no such expressions need not load it

        self._written = written
        options = re2.Options()
        options.encoding = re2.Options.Encoding.LATIN1
        options.posix_syntax = options.one_line = options.dot_nl = True
        options.log_errors = False
        options.never_capture = not groups
        try:
            self._compiled: Any = re2.compile(expression, options)
        except re2.error as error:
            raise self._error(_reason(error)) from None
        if groups and self._compiled.groups > _MAX_GROUPS:
            raise self._error(f"more than {_MAX_GROUPS} groups")
        self._size: int = self._compiled.programsize

    def fullmatch(self, text: str) -> bool:
        """Whether a text matches as a whole."""
        return self._compiled.fullmatch(self._checked(encoded(text))) is not None

    def search(self, text: str) -> tuple[str, ...] | None:
        """What matches first, and its groups."""
        match = self._compiled.search(self._checked(encoded(text)))
        return None if match is None else tuple(decoded(group or b"") for group in (match.group(), *match.groups()))

    def matches(self, data: bytes) -> Iterator[tuple[tuple[int, int], tuple[bytes, ...]]]:
        """Where the expression matches, one after another: the place, and the match with its groups.

        Raises:
            PatternError: this takes too long.
        """
        begin = time.thread_time()
        for number, match in enumerate(self._compiled.finditer(self._checked(data))):
            if number % 32 == 31 and time.thread_time() - begin > MAX_SECONDS:
                tracing.uncertain()
                raise self._error(f"takes more than {MAX_SECONDS:g} s")
            yield match.span(), tuple(group or b"" for group in (match.group(), *match.groups()))

    def _checked(self, data: bytes) -> bytes:
        if len(data) * self._size > MAX_WORK:
            raise self._error(f"too large for a text of {len(data)} bytes")
        return data

    def _error(self, reason: str) -> PatternError:
        return PatternError(f"bad regular expression `{self._written[:200]}`: {reason}")


@lru_cache(maxsize=512)
def compiled(expression: bytes, written: str, *, groups: bool = False) -> Pattern:
    """The pattern of an expression, which messages show as the input has it; without `groups` it has none.

    Raises:
        PatternError: it is not valid, or too large.
    """
    return Pattern(expression, written, groups)


def _reason(error: Exception) -> str:
    text = error.args[0]
    return (text.decode(errors="replace") if isinstance(text, bytes) else str(text)).partition(": ")[0]  # behind it, the expression again


def encoded(text: str) -> bytes:
    """The bytes of a text; those that were not UTF-8 as they were."""
    try:
        return text.encode(errors="surrogateescape")
    except UnicodeEncodeError:  # half a character, by an escape in a source
        return text.encode(errors="surrogatepass")


def decoded(data: bytes) -> str:
    """The text of bytes, and back again by `encoded`."""
    return data.decode(errors="surrogateescape")
