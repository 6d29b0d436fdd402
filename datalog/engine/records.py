"""Records and branches while a program is evaluated: equal ones are one object, compared and hashed by identity.

So a list of a million cells costs no more in a join than a number, and no depth is too much. Outside of an evaluation they are plain
tuples.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Any


class Interned(tuple[Any, ...]):
    """A record, or a branch with its name in front."""

    __slots__ = ()
    # Those of `object` itself, so that they stay as fast; without all of them Python would go through slower ones.
    __hash__ = object.__hash__
    __eq__ = object.__eq__
    __ne__ = object.__ne__
    __lt__ = object.__lt__  # type: ignore[operator]
    __le__ = object.__le__  # type: ignore[operator]
    __gt__ = object.__gt__  # type: ignore[operator]
    __ge__ = object.__ge__  # type: ignore[operator]


class Records:
    """The records of one evaluation."""

    def __init__(self) -> None:
        self._interned: dict[Any, Interned] = {}
        self._with_floats: dict[str, dict[Any, Interned]] = {}  # 1 and 1.0 are equal to Python

    def pack(self, fields: tuple[Any, ...]) -> Interned:
        """The record with these fields, none of which is a float."""
        found = self._interned.get(fields)
        if found is None:
            found = self._interned[fields] = Interned(fields)
        return found

    def pack_floats(self, fields: tuple[Any, ...], places: str) -> Interned:
        """The record with these fields; `places` has an `f` for every float among them."""
        known = self._with_floats.setdefault(places, {})
        found = known.get(fields)
        if found is None:
            found = known[fields] = Interned(fields)
        return found

    def pack_value(self, value: Any) -> Any:
        """A value from outside, with everything in it."""
        if not isinstance(value, tuple):
            return value
        done: list[Any] = []
        work: list[tuple[Any, bool]] = [(value, False)]  # whether the fields have been done
        while work:
            item, ready = work.pop()
            if not isinstance(item, tuple):
                done.append(item)
            elif not ready:
                work.append((item, True))
                work.extend((part, False) for part in reversed(item))
            else:
                first = len(done) - len(item)
                fields = tuple(done[first:])
                del done[first:]
                places = "".join("f" if isinstance(v, float) else "." for v in fields)
                done.append(self.pack_floats(fields, places) if "f" in places else self.pack(fields))
        return done[0]

    def pack_rows(self, rows: Iterable[Any], columns: Collection[int], arity: int) -> list[Any]:
        """Rows as relations store them, with the values of these columns packed."""
        if arity == 1:
            return [self.pack_value(row) for row in rows]
        return [tuple([self.pack_value(v) if c in columns else v for c, v in enumerate(row)]) for row in rows]


def unpack_rows(rows: Iterable[Any], columns: Collection[int], arity: int) -> list[Any]:
    """Rows with plain tuples in these columns; a list, because hashing a deep tuple overflows the stack."""
    known: dict[int, tuple[Any, ...]] = {}
    if arity == 1:
        return [_plain(row, known) for row in rows]
    return [tuple([_plain(v, known) if c in columns else v for c, v in enumerate(row)]) for row in rows]


def _plain(value: Any, known: dict[int, tuple[Any, ...]]) -> Any:
    if not isinstance(value, Interned):
        return value
    work: list[Any] = [value]
    while work:
        item = work[-1]
        if id(item) in known:
            work.pop()
            continue
        missing = [part for part in item if isinstance(part, Interned) and id(part) not in known]
        if missing:
            work.extend(missing)
            continue
        work.pop()
        known[id(item)] = tuple([known[id(part)] if isinstance(part, Interned) else part for part in item])
    return known[id(value)]
