"""The files of translation units and headers: those of this run, and those of earlier ones in the cache.

A file holds a head and, apart from it, the rows, those about the body of a function apart for each: the head of a unit are the errors that
lost code and the keys of the headers that it shares, the head of a header the names that it declares.
"""

from __future__ import annotations

import marshal
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from pathlib import Path
from typing import Any

from rosarch.base.cache import Cache
from rosarch.base.seal import below_seal, sealed
from rosarch.base.whole import write_whole
from rosarch.extractor.live_code import DECLARED, Declarations, Mentions, by_function, mentions_of

Row = tuple[str | int, ...]
Rows = Mapping[str, Iterable[Row]]


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


class UnitRows:
    """The rows in files of units and headers, each read once: for all components that consist of these.

    What many units have of a function in a header is mostly the same to the byte: then it is unpacked once.
    """

    def __init__(self, paths: Iterable[Path]) -> None:
        self._outside: list[Rows] = []
        self._mentions: dict[str, list[Mentions]] = defaultdict(list)
        self._packed: dict[str, dict[bytes, None]] = defaultdict(dict)
        self._bodies: dict[str, list[Rows]] = {}
        for path in paths:
            _, rest, bodies = _parts(path)
            outside, mentioned = marshal.loads(rest)
            self._outside.append(outside)
            self._mentions[""].append(Mentions(*mentioned[""]))
            for function, body in bodies.items():
                if body not in self._packed[function]:
                    self._packed[function][body] = None
                    self._mentions[function].append(Mentions(*mentioned[function]))

    def of(self, own: Rows) -> dict[str, AbstractSet[Row]]:
        """The rows of a component, with its `own`, but for those of functions that are not live (see `live_code`).

        They come in the order of the files, so that who goes through them finds neighbours in memory side by side.
        """
        live = self._declarations.live_functions(own, self._mentions)
        bodies = (body for function in self._packed if function in live for body in self._unpacked(function))
        pieces: dict[str, list[Iterable[Row]]] = defaultdict(list)
        for part in chain([own], self._outside, bodies):
            for relation, found in part.items():
                pieces[relation].append(found)
        if "component_class" in own:
            pieces["component_class"] = [self._declarations.entry_classes(own)]
        # equal identifiers mean equal entities
        return defaultdict(set, {relation: dict.fromkeys(chain.from_iterable(found)).keys() for relation, found in pieces.items()})

    def left_out(self, own: Rows, makers: Makers, *, unused: bool) -> Iterator[tuple[str, str, int, int]]:
        """Where functions that are not live call what makes a port: name of the function, then path, line and column.

        Of an `unused` source no function is live.
        """
        live = set() if unused else self._declarations.live_functions(own, self._mentions)
        declared = self._declared("function_name", "source_file", own=own)
        names, files = _first_to_second(declared, "function_name"), _first_to_second(declared, "source_file")
        for function, packed in self._packed.items():
            for body in map(marshal.loads, filter(makers.may_be_in, packed)) if function not in live else ():
                places = {row[0]: row[1:] for row in body.get("location", ()) if row[1] in files}
                for call in makers.calls(body, names):
                    if call in places:
                        file, line, column = places[call]
                        yield names.get(function, function), files[file], line, column

    @cached_property
    def _declarations(self) -> Declarations:
        return Declarations(self._declared(*DECLARED))

    def _declared(self, *relations: str, own: Rows | None = None) -> dict[str, list[Row]]:
        """What these relations hold outside of functions, each row once: many units include the same headers."""
        parts = [*([own] if own else []), *self._outside]
        return {relation: list(dict.fromkeys(chain.from_iterable(part.get(relation, ()) for part in parts))) for relation in relations}

    def _unpacked(self, function: str) -> list[Rows]:
        if function not in self._bodies:
            self._bodies[function] = list(map(marshal.loads, self._packed[function]))
        return self._bodies[function]


@dataclass(frozen=True)
class Makers:
    """What makes ports: `functions` by their qualified names, and calls of certain `names` where it is not known what they call."""

    functions: frozenset[str]
    names: frozenset[str]

    @cached_property
    def _words(self) -> tuple[bytes, ...]:
        return tuple(name.encode() for name in sorted(self.functions | self.names))

    def may_be_in(self, body: bytes) -> bool:
        """Whether a packed body may call one of them."""
        return any(word in body for word in self._words)

    def calls(self, body: Rows, names: Mapping[str, str]) -> Iterator[str]:
        """The calls of one of them, by the `names` of functions."""
        called = _first_to_second(body, "call_function")
        for call, name in _first_to_second(body, "call").items():
            if (names.get(called[call], called[call]) in self.functions) if call in called else (name in self.names):
                yield call


def _first_to_second(rows: Rows, relation: str) -> dict[str, str]:
    return {str(row[0]): str(row[1]) for row in rows.get(relation, ())}


def _parts(path: Path) -> Any:
    """Head and rows, these still packed; that the file is whole was seen when it came from the cache, or this run has written it."""
    return marshal.loads(below_seal(path.read_bytes()))
