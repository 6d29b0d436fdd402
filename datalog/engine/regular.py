"""Regular expressions of `match`: ECMAScript's, as souffle has them, matched in bounded time.

Python's matcher backtracks. It is used for expressions with which that cannot take long; all others run as a finite automaton,
whose time is linear in the text. Backward references and the like, of which no automaton is made, are refused in such expressions.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from importlib import import_module
from typing import Any

from rosarch.datalog.language.domain import EvaluationError

_NEW_NAMES = sys.version_info >= (3, 11)
_constants: Any = import_module("re._constants" if _NEW_NAMES else "sre_constants")
_parser: Any = import_module("re._parser" if _NEW_NAMES else "sre_parse")

Matcher = Callable[[str], Any]
MAX_REPEATS = 2  # unbounded repetitions side by side that backtracking may try: cubic in the text
MAX_STATES = 20_000
MAX_KNOWN = 50_000  # transitions that are kept
_FLAGS = re.DOTALL | re.ASCII
_REPEATS = tuple(getattr(_constants, n) for n in ("MAX_REPEAT", "MIN_REPEAT", "POSSESSIVE_REPEAT") if hasattr(_constants, n))
_POSIX_CLASSES = {
    "alnum": "a-zA-Z0-9", "alpha": "a-zA-Z", "blank": r" \t", "digit": "0-9", "lower": "a-z", "space": r"\s",
    "upper": "A-Z", "xdigit": "0-9a-fA-F", "punct": r"!-/:-@\[-`{-~", "w": r"\w", "d": r"\d", "s": r"\s",
}  # fmt: skip
_BARE_BRACE = re.compile(r"(?<!\\)(?:\\\\)*\{(?!\d+(?:,\d*)?\})")


@lru_cache(maxsize=4096)
def full_match(pattern: str) -> Matcher | None:
    """What gives None for a text that the expression does not match as a whole; None when the expression is not valid.

    Raises EvaluationError for an expression whose matching cannot be bounded.
    """
    translated = re.sub(r"\[:(\w+):\]", lambda m: _POSIX_CLASSES.get(m[1], m[0]), pattern)
    if _BARE_BRACE.search(translated):
        return None
    try:
        compiled = re.compile(translated, _FLAGS)
        tree = _parser.parse(translated, _FLAGS)
    except (re.error, OverflowError, RecursionError):
        return None
    if _unbounded(tree) <= MAX_REPEATS:
        return compiled.fullmatch
    try:
        return Automaton(tree).matches
    except RecursionError:
        raise EvaluationError(f"regular expression nested too deeply: `{pattern[:60]}`") from None
    except _NoAutomaton as error:
        raise EvaluationError(f"regular expression that may take for ever, {error}: `{pattern[:60]}`") from None


class _NoAutomaton(Exception):
    """An expression of which no automaton is made; the message says why."""


def _unbounded(items: Iterable[Any]) -> int:
    """How many repetitions a backtracking matcher may have to try against each other; many when one is inside of another."""
    total = 0
    for op, value in items:
        if op in _REPEATS:
            low, high, body = value
            inner = _unbounded(body)
            if low != high and (high is _constants.MAXREPEAT or high > 8):
                total += 100 if inner or _varies(body) else 1
            elif high > 1:
                total += inner * min(int(high), 100) + (1 if _varies(body) and high > 8 else 0)
            else:
                total += inner
        else:
            total += sum(_unbounded(part) for part in _parts(op, value))
    return total


def _varies(items: Iterable[Any]) -> bool:
    """Whether a part may match in several ways: it has an alternative or an optional piece."""
    for op, value in items:
        if op is _constants.BRANCH or (op in _REPEATS and value[0] != value[1]):
            return True
        if any(_varies(part) for part in _parts(op, value)):
            return True
    return False


def _parts(op: Any, value: Any) -> Iterator[Any]:
    """The sub-expressions of an item."""
    if op in _REPEATS:
        yield value[2]
    elif op is _constants.BRANCH:
        yield from value[1]
    elif op is _constants.SUBPATTERN:
        yield value[3]
    elif op in (_constants.ASSERT, _constants.ASSERT_NOT):
        yield value[1]


class Automaton:
    """A nondeterministic automaton, of which the sets of states that occur are remembered.

    State 0 is the end. A state has a test of one character and a successor, or successors that take no character, or waits for the
    start or the end of the text.
    """

    def __init__(self, tree: Iterable[Any]) -> None:
        self.tests: list[tuple[Any, Any] | None] = [None]
        self.next: list[tuple[int, ...]] = [()]
        self.known: dict[tuple[frozenset[int], str], frozenset[int]] = {}
        self.first = self._sequence(list(tree), 0)

    def matches(self, text: str) -> bool | None:
        """True when the whole text matches, else None."""
        states = self._closure({self.first}, start=True, end=not text)
        known = self.known
        for character in text:
            after = known.get((states, character))
            if after is None:
                moved = {self.next[s][0] for s in states if (test := self.tests[s]) is not None and _accepts(test, character)}
                after = self._closure(moved)
                if len(known) >= MAX_KNOWN:
                    known.clear()
                known[states, character] = after
            if not after:
                return None
            states = after
        return True if 0 in self._closure(states, end=True) or 0 in states else None

    def _closure(self, states: Iterable[int], *, start: bool = False, end: bool = False) -> frozenset[int]:
        """The states that can be reached without a character."""
        found: set[int] = set()
        work = list(states)
        while work:
            state = work.pop()
            if state in found:
                continue
            found.add(state)
            test = self.tests[state]
            if test is None or (test[0] is _constants.AT and (start if test[1] else end)):
                work.extend(self.next[state])
        return frozenset(found)

    def _add(self, test: tuple[Any, Any] | None, successors: tuple[int, ...]) -> int:
        if len(self.tests) >= MAX_STATES:
            raise _NoAutomaton("with too many repetitions")
        self.tests.append(test)
        self.next.append(successors)
        return len(self.tests) - 1

    def _sequence(self, items: list[Any], after: int) -> int:
        for op, value in reversed(items):
            after = self._item(op, value, after)
        return after

    def _item(self, op: Any, value: Any, after: int) -> int:
        if op in (_constants.LITERAL, _constants.NOT_LITERAL, _constants.ANY, _constants.IN):
            return self._add((op, value), (after,))
        if op is _constants.BRANCH:
            return self._add(None, tuple(self._sequence(list(part), after) for part in value[1]))
        if op is _constants.SUBPATTERN:
            return self._sequence(list(value[3]), after)
        if op in _REPEATS and op is not getattr(_constants, "POSSESSIVE_REPEAT", None):
            return self._repeat(value[0], value[1], value[2], after)
        if op is _constants.AT and value in (_constants.AT_BEGINNING, _constants.AT_BEGINNING_STRING):
            return self._add((op, True), (after,))
        if op is _constants.AT and value in (_constants.AT_END, _constants.AT_END_STRING):
            return self._add((op, False), (after,))
        raise _NoAutomaton("with a backward reference, a look-ahead or a word boundary")

    def _repeat(self, low: int, high: Any, body: Any, after: int) -> int:
        items = list(body)
        if high is _constants.MAXREPEAT:
            loop = self._add(None, ())
            self.next[loop] = (self._sequence(items, loop), after)
            after = loop
        else:
            end = after
            for _ in range(int(high) - int(low)):
                after = self._add(None, (self._sequence(items, after), end))
        for _ in range(int(low)):
            after = self._sequence(items, after)
        return after


_CATEGORIES = {
    _constants.CATEGORY_DIGIT: "0123456789", _constants.CATEGORY_SPACE: " \t\n\r\f\v",
    _constants.CATEGORY_WORD: "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_",
}  # fmt: skip
_NEGATED = {
    _constants.CATEGORY_NOT_DIGIT: _constants.CATEGORY_DIGIT, _constants.CATEGORY_NOT_SPACE: _constants.CATEGORY_SPACE,
    _constants.CATEGORY_NOT_WORD: _constants.CATEGORY_WORD,
}  # fmt: skip


def _accepts(test: tuple[Any, Any], character: str) -> bool:
    op, value = test
    if op is _constants.ANY:
        return True
    if op is _constants.LITERAL:
        return bool(ord(character) == value)
    if op is _constants.NOT_LITERAL:
        return bool(ord(character) != value)
    return op is _constants.IN and _in_set(value, character)


def _in_set(items: list[Any], character: str) -> bool:
    negated = bool(items) and items[0][0] is _constants.NEGATE
    for op, value in items[negated:]:
        if op is _constants.LITERAL:
            found = ord(character) == value
        elif op is _constants.RANGE:
            found = value[0] <= ord(character) <= value[1]
        elif value in _CATEGORIES:
            found = character in _CATEGORIES[value]
        else:
            found = character not in _CATEGORIES[_NEGATED[value]]
        if found:
            return not negated
    return negated
