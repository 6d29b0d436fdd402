"""Places in the source."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, order=True)
class Place:
    """Where in the source something is written; `path` is relative to the workspace."""

    path: str
    line: int
    column: int

    def __str__(self) -> str:
        return f"{self.path}:{self.line}"


def precise(place: Place) -> str:
    """The place with its column, where several may be in one line."""
    return f"{place}:{place.column}"
