"""Conditions as boolean formulas: built from the conditions that the source spells, simplified, and written as its language has it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import TypeAlias

from rosarch.base import logic
from rosarch.base.logic import FALSE, TRUE, alternatives, from_alternatives
from rosarch.base.places import Place, precise

MOST_ALTERNATIVES = 24


@dataclass(frozen=True)
class Condition:
    """A condition as the source spells it, at `place`, which `holds` or does not. Conditions with the same text and meaning are equal.

    A `stable` condition has one value as long as an activity runs: it cannot hold here and not there. `meaning` is the text with local
    variables replaced by what they stand for. Its language has `words` (and, or, not), or signs. `through` are the calls by which an
    activity comes to it, where what it asks may differ from one to the other.
    """

    text: str
    holds: bool
    place: Place | None = field(default=None, compare=False)
    stable: bool = field(default=False, compare=False)
    meaning: str | None = None
    words: bool = field(default=False, compare=False)
    through: tuple[Place, ...] = ()

    @property
    def key(self) -> Key:
        """What makes two conditions the same."""
        return self.text, self.meaning or self.text, self.holds, self.through

    @property
    def opposite(self) -> Key:
        """The key of the negated condition."""
        return self.text, self.meaning or self.text, not self.holds, self.through

    def called_by(self, calls: tuple[Place, ...]) -> Condition:
        """The same, where these calls come before those that lead to it."""
        return Condition(self.text, self.holds, self.place, self.stable, self.meaning, self.words, (*calls, *self.through))


Key: TypeAlias = tuple[str, str, bool, tuple[Place, ...]]


Formula: TypeAlias = logic.Formula[Condition]
"""A disjunction of conjunctions in the order of evaluation."""


def condition(
    text: str, holds: bool, place: Place | None = None, *, stable: bool = False, meaning: str | None = None, words: bool = False,
    through: tuple[Place, ...] = (),
) -> Formula:  # fmt: skip
    """The formula of one condition; of `not x`, it is x that does not hold."""
    while words and text.startswith("not ") and loosest(text[4:]) == "":
        text, holds, meaning = text[4:], not holds, meaning and meaning.removeprefix("not ")
    return Condition(text, holds, place, stable, meaning, words, through)


def both(first: Formula, second: Formula) -> Formula:
    """The conjunction; the conditions of `first` come first."""
    if first == TRUE or second == TRUE:
        return second if first == TRUE else first
    return _simplify(joined(one + other) for one in alternatives(first) for other in alternatives(second))


def either(formulas: Iterable[Formula]) -> Formula:
    """The disjunction."""
    return _simplify(conjunction for formula in formulas for conjunction in alternatives(formula))


def joined(items: Iterable[Condition]) -> tuple[Condition, ...] | None:
    """The conditions, each once; None when they contradict each other, with nothing that may change between."""
    found: dict[Key, Condition] = {}
    stable = set()
    for item in items:
        if item.stable:
            if item.opposite in stable:
                return None
            stable.add(item.key)
        found.setdefault(item.key, item)
    return tuple(found.values())


def _simplify(conjunctions: Iterable[tuple[Condition, ...] | None]) -> Formula:
    """Merge alternatives that differ in one condition, leave out those that others imply, and bound their number."""
    kept = list(dict.fromkeys(c for c in conjunctions if c is not None))
    if len(kept) > 1:
        kept = _merged(kept)
    if len(kept) > MOST_ALTERNATIVES:  # weaker, but still true: what all alternatives share
        kept = [_common(kept)]
    return from_alternatives(kept)


def _merged(kept: list[tuple[Condition, ...]]) -> list[tuple[Condition, ...]]:
    """Alternatives without the conditions that others make superfluous, and without those that say more than another one.

    In `(a && b) || (a && !b && c)` the `!b` is superfluous. Conditions are compared by numbers, which is many times as fast.
    """
    numbers: dict[Key, int] = {}
    sets = [{numbers.setdefault(item.key, len(numbers)) for item in each} for each in kept]
    opposites = {numbers[item.key]: numbers.get(item.opposite) for each in kept for item in each}
    changed = True
    while changed and len(kept) > 1:
        changed = False
        for first in sets:
            for other, second in enumerate(sets):
                different = first - second
                if len(different) == 1 and (superfluous := opposites[different.pop()]) in second:
                    kept[other] = tuple(item for item in kept[other] if numbers[item.key] != superfluous)
                    second.remove(superfluous)
                    changed = True
        least = [
            index
            for index, own in enumerate(sets)
            if not any(one < own or (one == own and other < index) for other, one in enumerate(sets))
        ]
        kept, sets = [kept[index] for index in least], [sets[index] for index in least]
    return kept


def _common(conjunctions: Sequence[tuple[Condition, ...]]) -> tuple[Condition, ...]:
    shared = set.intersection(*({item.key for item in conjunction} for conjunction in conjunctions))
    return tuple(item for item in conjunctions[0] if item.key in shared)


def text(formula: Formula) -> str | None:
    """The formula in its language; None when it is true, `false` when it never holds. What all alternatives share comes first."""
    if formula in (TRUE, FALSE):
        return None if formula == TRUE else "false"
    ways = alternatives(formula)
    words = any(item.words for conjunction in ways for item in conjunction)
    and_, or_ = (" and ", " or ") if words else (" && ", " || ")
    common = _common(ways)
    shared = {item.key for item in common}
    rest = [tuple(item for item in conjunction if item.key not in shared) for conjunction in ways]
    parts = [_item(item, alone=len(common) == 1 and not rest[0]) for item in common]
    if rest[0] and all(len(conjunction) == 1 and _negative(conjunction[0]) for conjunction in rest):
        parts.append(f"{'not ' if words else '!'}({and_.join(_opposite(conjunction[0]) for conjunction in rest)})")
    elif rest[0]:
        choice = or_.join(_conjunction(conjunction, alone=False) for conjunction in rest)
        parts.append(f"({choice})" if parts else choice)
    return and_.join(parts)


def _negative(item: Condition) -> bool:
    return not item.holds or (item.text.startswith("!") and loosest(item.text[1:]) == "")


def _opposite(item: Condition) -> str:
    """The negation of a negative condition, without a double one."""
    return item.text[1:] if item.holds else _item(replace(item, holds=True), alone=False)


def _conjunction(items: tuple[Condition, ...], *, alone: bool) -> str:
    joined = (" and " if items[0].words else " && ").join(_item(item, alone=len(items) == 1) for item in items)
    return f"({joined})" if len(items) > 1 and not alone else joined


def _item(item: Condition, *, alone: bool) -> str:
    if not item.holds:
        return negation(item.text, words=item.words)
    return f"({item.text})" if not alone and loosest(item.text) in ("||", "?", ",", "=") else item.text


def negation(source: str, *, words: bool = False) -> str:
    """The negated condition."""
    sign = "not " if words else "!"
    return f"{sign}{source}" if loosest(source) == "" else f"{sign}({source})"


_ORDER = (",", "=", "?", "||", "&&", "op")
_WORDS = {"or": "||", "and": "&&", "not": "op", "in": "op", "is": "op", "if": "?", "else": "?", "lambda": ","}
_WORD = re.compile(r"[^\W\d]\w*")


@lru_cache(maxsize=4096)
def loosest(source: str) -> str:
    """The operator outside of all brackets that binds least: `,`, `=`, `?`, `||`, `&&`, `op` for any other, or none."""
    depth, found, index = 0, set(), 0
    quote = ""
    while index < len(source):
        char, pair = source[index], source[index : index + 2]
        if quote:
            index += 1 if char == "\\" else 0
            quote = "" if char == quote else quote
        elif char in "\"'":
            quote = char
        elif char in "([{":
            depth += 1
        elif char in ")]}":
            depth -= 1
        elif depth == 0:
            if pair in ("||", "&&"):
                found.add(pair)
                index += 1
            elif pair == "->" or pair == "::":
                index += 1
            elif pair in ("==", "!=", "<=", ">="):
                found.add("op")
                index += 1
            elif char in ",?":
                found.add(char)
            elif char == "=":
                found.add("=")
            elif word := _WORD.match(source, index):
                if word.group() in _WORDS:
                    found.add(_WORDS[word.group()])
                index = word.end() - 1
            elif not (char.isalnum() or char in "_. :"):
                found.add("op")
        index += 1
    return next((operator for operator in _ORDER if operator in found), "")


def tree(formula: Formula) -> dict[str, object] | None:
    """The formula as nested objects: `all` and `any` of conditions with their text, place and whether they hold, and the calls to them."""
    if formula == TRUE:
        return None
    ways: list[dict[str, object]] = [{"all": [_leaf(item) for item in conjunction]} for conjunction in alternatives(formula)]
    return ways[0] if len(ways) == 1 else {"any": ways}


def _leaf(item: Condition) -> dict[str, object]:
    through = {"through": list(map(precise, item.through))} if item.through else {}
    return {"condition": item.text, "holds": item.holds, "at": str(item.place) if item.place else None, **through}
