"""Components that have most of their facts in common, as programs that are linked with the same libraries: these facts are read once."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rosarch.extractor.facts import Row

MANY = 1 << 20
"""Bytes of facts from which on it is worth it."""
_SHARE = 0.5
"""How much of the facts of each component the common ones must be."""
_CANDIDATES = 16
"""Groups that a component is compared with."""


@dataclass
class _Group:
    """Components by their numbers, the files that all of them have, and how large the first of them is, which is the largest."""

    largest: int
    common: frozenset[Path]
    members: list[int] = field(default_factory=list)


@dataclass(frozen=True)
class CommonUnits:
    """The rows of files that several components have."""

    files: frozenset[Path]
    rows: Mapping[str, set[Row]]

    def facts(self) -> Mapping[str, set[Row]]:
        """The rows that are facts of each of these components; which message classes are, the others decide as well."""
        return {relation: rows for relation, rows in self.rows.items() if relation != "message_class"}


def read_common(files: frozenset[Path]) -> CommonUnits:
    """Read the rows of files."""
    from rosarch.extractor.cxx.unit import merge  # these load libclang
    from rosarch.extractor.unit_store import unit_rows

    return CommonUnits(files, merge(list(map(unit_rows, sorted(files)))))


def in_groups(components: Sequence[Iterable[Path]]) -> list[tuple[int, frozenset[Path]]]:
    """In which order to take components, each given by the files of its facts, and which of the files those taken next have, too.

    Large ones come first, so that many processes end evenly.
    """
    files = [frozenset(each) for each in components]
    sizes = {path: _size(path) for each in files for path in each}

    def size(paths: Iterable[Path]) -> int:
        return sum(map(sizes.__getitem__, paths))

    groups: list[_Group] = []
    for number, total in sorted(enumerate(map(size, files)), key=lambda found: (-found[1], found[0])):
        group = max(groups[-_CANDIDATES:], key=lambda each: size(each.common & files[number]), default=None)
        if total < MANY or group is None or size(group.common & files[number]) < _SHARE * group.largest:
            group = _Group(total, files[number])
            groups.append(group)
        group.common &= files[number]
        group.members.append(number)
    return [(number, group.common if len(group.members) > 1 else frozenset()) for group in groups for number in group.members]


def _size(path: Path) -> int:
    try:
        return os.path.getsize(path)
    except OSError:
        return 0
