"""Facts that several evaluations of a program have in common, with the indexes over them that the evaluations have asked for."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from typing import Any

from .indexes import Index

Row = tuple[Any, ...]


class CommonFacts:
    """Rows of input relations; given to an evaluation beside the facts that are its own, which must be others."""

    def __init__(self, rows: Mapping[str, Iterable[Row]]) -> None:
        self.rows: dict[str, set[Row]] = {name: set(found) for name, found in rows.items()}
        self._indexes: dict[tuple[str, Index], Any] = {}

    def index(self, name: str, own: Collection[Row], index: Index) -> Any:
        """The index over these rows and an evaluation's own; what is made over these is kept for the next evaluation."""
        key = name, index
        if key not in self._indexes:
            self._indexes[key] = index.build(self.rows[name], False)
        return index.extended(self._indexes[key], own) if own else self._indexes[key]
