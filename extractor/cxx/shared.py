"""Headers of the workspace that many units include: read once, their facts kept apart from those of the units.

A header says the same wherever its text, what it includes and the conditions in these are the same, as long as it names nothing that
comes from elsewhere and clang understands all of it. Then its facts are found by a hash of just that, and the unit leaves it out.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

from rosarch.base.cache import hash_of
from rosarch.extractor.cxx import kinds, libclang
from rosarch.extractor.cxx.heal import files_with_errors
from rosarch.extractor.cxx.includes import Folders, HeaderFinder, Includes, is_shipped
from rosarch.extractor.cxx.libclang_library import Cursor
from rosarch.extractor.cxx.recover import Names, declared_names, recover
from rosarch.extractor.cxx.unit import SourceFile, UnitFacts
from rosarch.extractor.cxx.walk import walk_declaration
from rosarch.extractor.version import extractor_version

_NAMING = kinds.REFERENCES | {kinds.DECLARATION_REFERENCE, kinds.MEMBER_ACCESS, kinds.CALL, kinds.BASE_SPECIFIER}
_REDECLARED = kinds.FUNCTIONS | {kinds.VARIABLE}

Rows = Mapping[str, set[tuple[str | int, ...]]]


class HeaderStore(Protocol):
    """Keeps the facts of headers by their keys."""

    def load(self, key: str) -> Names | None:
        """The names that a header declares; None when its facts are not there."""

    def store(self, key: str, names: Names, rows: Rows) -> None:
        """Keep the facts of a header."""


@dataclass
class SharedHeaders:
    """The headers that one unit leaves to the store; `keys` says which, once its first parse was seen."""

    source: Path
    folders: Folders
    compiled_as: tuple[str, ...]
    finder: HeaderFinder
    kept: HeaderStore
    keys: dict[Path, str] = field(default_factory=dict)
    names: list[Names] = field(default_factory=list)
    _decided: bool = False

    def leave_out(self, facts: UnitFacts, parsed: libclang.Unit, cursors: Sequence[Cursor]) -> list[Cursor]:
        """The declarations that the unit itself has to read; a further parse of the unit leaves out what the first one does."""
        by_file: dict[SourceFile, list[Cursor]] = {}
        for cursor in cursors:
            by_file.setdefault(_file(facts, cursor), []).append(cursor)
        own = {file: found for file, found in by_file.items() if file.key is not None}
        if not self._decided:
            self._decided = True
            wrong = files_with_errors(facts, parsed)
            for file, found in own.items():
                if file.path != self.source and any(cursor.kind not in kinds.PREPROCESSING for cursor in found):
                    self._share(facts, file, found, wrong)
        return [cursor for file, found in own.items() if file.path not in self.keys for cursor in found]

    def _share(self, facts: UnitFacts, file: SourceFile, cursors: Sequence[Cursor], wrong: set[str]) -> None:
        """Leave the header `file` to the store, if that is possible; read it for the store where it is not there yet."""
        includes, fingerprint = self.finder.described(file.path, self.folders)
        if not includes.predictable or not wrong.isdisjoint(includes.files) or _foreign_macros(facts, cursors, includes):
            return
        skipped = [f"{Path(path).name} {facts.skipped[path]}" for path in sorted(facts.skipped) if path in includes.files]
        key = hash_of([extractor_version(), str(file.relative), *self.compiled_as, "", fingerprint, *skipped])
        names = self.kept.load(key)
        if names is None:
            if _foreign_names(facts, cursors, includes):
                return
            part = facts.part(lambda target: not _is_foreign(facts, target, includes))
            for cursor in cursors:
                walk_declaration(part, cursor)
            names = declared_names(part.rows)
            recover(part, [names])
            self.kept.store(key, names, part.rows)
        self.keys[file.path] = key
        self.names.append(names)


def _file(facts: UnitFacts, cursor: Cursor) -> SourceFile:
    return facts.locate(libclang.location(cursor))[0]


def _is_foreign(facts: UnitFacts, target: Cursor, includes: Includes) -> bool:
    """Whether something is declared where a header that includes `includes` would not find it by itself."""
    path = str(_file(facts, target).path)
    return path not in includes.files and not is_shipped(path) and os.path.isfile(path)


def _foreign_macros(facts: UnitFacts, cursors: Sequence[Cursor], includes: Includes) -> bool:
    expansions = (libclang.referenced(cursor) for cursor in cursors if cursor.kind == kinds.MACRO_EXPANSION)
    return any(macro.kind == kinds.MACRO_DEFINITION and _is_foreign(facts, macro, includes) for macro in expansions)


def _foreign_names(facts: UnitFacts, cursors: Sequence[Cursor], includes: Includes) -> bool:
    """Whether declarations name what is declared elsewhere, or declare again what was declared elsewhere before."""
    seen: set[int | None] = set()
    for top in cursors:
        for cursor in (top, *libclang.descendants(top)):
            if cursor.kind in _NAMING:
                target = libclang.canonical(libclang.referenced(cursor))  # of a class that was only declared, the declaration
            elif cursor.kind in _REDECLARED:
                target = libclang.canonical(cursor)
            else:
                continue
            if target.d0 and target.d0 not in seen:
                seen.add(target.d0)
                if _is_foreign(facts, target, includes):
                    return True
    return False
