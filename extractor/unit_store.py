"""The files of translation units and headers: those of this run, and those of earlier ones in the cache.

A file holds a head and, apart from it, the rows, those about the body of a function apart for each: the head of a unit are the errors that
lost code and the keys of the headers that it shares, the head of a header the names that it declares.
"""

from __future__ import annotations

import marshal
from collections import defaultdict
from collections.abc import Iterable, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Any

from rosarch.base.cache import Cache
from rosarch.base.seal import below_seal, sealed
from rosarch.base.whole import write_whole
from rosarch.extractor.live_code import Mentions, by_function, entry_classes, live_functions, mentions_of

Row = tuple[str | int, ...]


@dataclass(frozen=True)
class UnitStore:
    """Keeps files by their keys below `scratch`, and in the cache."""

    scratch: Path
    cache: Cache | None

    def path(self, key: str) -> Path:
        """Where the file is."""
        return self.scratch / f"{key}.rows"

    def head(self, key: str) -> Any:
        """The head of a file of this run or of an earlier one; None when there is none."""
        path = self.path(key)
        if path.is_file():
            return _parts(path)[0]
        data = self.cache.load_to(path, key) if self.cache else None
        return None if data is None else marshal.loads(data)[0]

    def has(self, key: str) -> bool:
        """Whether there is such a file, of this run or of an earlier one, which then is below `scratch`."""
        path = self.path(key)
        return path.is_file() or (self.cache is not None and self.cache.load_to(path, key) is not None)

    def keep(self, key: str, head: Any, rows: Mapping[str, Iterable[Row]], *, lasting: bool = True) -> None:
        """Write a file, also for later runs if it is `lasting`."""
        parts = by_function(rows)  # lists: sets would be sorted first
        mentions = {function: tuple(mentions_of(part)) for function, part in parts.items()}
        outside = parts.pop("")
        bodies = {function: marshal.dumps(part) for function, part in parts.items()}
        data = marshal.dumps((head, marshal.dumps((outside, mentions)), bodies))
        if self.cache and lasting:
            self.cache.store(key, data)
        write_whole(self.path(key), sealed(data))


def read_rows(paths: Iterable[Path], own: Mapping[str, Iterable[Row]]) -> dict[str, AbstractSet[Row]]:
    """The rows in files of units and headers of a component and its own, but for those of functions that are not live (see `live_code`).

    They come in the order of the files, so that who goes through them finds neighbours in memory side by side.
    """
    pieces: dict[str, list[Iterable[Row]]] = defaultdict(list)
    mentions: dict[str, list[Mentions]] = defaultdict(list)
    bodies: dict[str, list[bytes]] = defaultdict(list)
    _add(pieces, own)
    for path in paths:
        _, rest, own_bodies = _parts(path)
        outside, mentioned = marshal.loads(rest)
        _add(pieces, outside)
        for function, found in mentioned.items():
            mentions[function].append(Mentions(*found))
        for function, body in own_bodies.items():
            bodies[function].append(body)
    declared = {relation: list(chain.from_iterable(found)) for relation, found in pieces.items()}
    if "component_class" in declared:
        declared["component_class"] = entry_classes(declared)
        pieces["component_class"] = [declared["component_class"]]
    live = live_functions(declared, mentions)
    for function, compiled in bodies.items():
        if function in live:
            for body in compiled:
                _add(pieces, marshal.loads(body))
    # equal identifiers mean equal entities
    return defaultdict(set, {relation: dict.fromkeys(chain.from_iterable(found)).keys() for relation, found in pieces.items()})


def _add(pieces: dict[str, list[Iterable[Row]]], more: Mapping[str, Iterable[Row]]) -> None:
    for relation, found in more.items():
        pieces[relation].append(found)


def _parts(path: Path) -> Any:
    """Head and rows, these still packed; that the file is whole was seen when it came from the cache, or this run has written it."""
    return marshal.loads(below_seal(path.read_bytes()))
