"""`.pragma "override" "relation, ..."`: the clauses of these relations are those of the file it is in, and no others.

Soufflé knows `.override` in components only. It reads this pragma and does nothing about it; given to its binary from here, the program is
without the clauses that are dropped.
"""

from __future__ import annotations

from dataclasses import dataclass

from rosarch.datalog.language.clause_text import blanked, clause_end, offset
from rosarch.datalog.language.errors import Location, Report, did_you_mean
from rosarch.datalog.language.syntax import Clause, Pragma, Unit

OVERRIDE = "override"


@dataclass(frozen=True, slots=True)
class Overridden:
    """A relation that the file of `location`, where the pragma stands, overrides; `dropped` are the places of the clauses it had."""

    relation: str
    location: Location
    dropped: tuple[Location, ...]


def drop_overridden(unit: Unit, texts: dict[str, str], report: Report) -> tuple[Overridden, ...]:
    """Drop what is overridden from a program and from the texts of its files."""
    declared = {relation.name for relation in unit.relations}
    chosen: dict[str, Pragma] = {}
    for pragma in unit.pragmas:
        if pragma.key != OVERRIDE:
            continue
        for name in (part.strip() for part in pragma.value.split(",")):
            if name not in declared:
                report.error(f"`{name}` is overridden, but there is no such relation", pragma.location, did_you_mean(name, declared))
            elif chosen.setdefault(name, pragma).location.path != pragma.location.path:
                report.error(f"`{name}` is overridden in `{chosen[name].location.path}` already", pragma.location)
    if not chosen:
        return ()
    dropped: dict[str, list[Clause]] = {name: [] for name in chosen}
    for clause in unit.clauses:
        name = clause.head.name
        if name in chosen and clause.location.path != chosen[name].location.path:
            dropped[name].append(clause)
    gone = {id(clause) for clauses in dropped.values() for clause in clauses}
    for pragma_name, clauses in dropped.items():
        if not clauses:
            report.error(f"`{pragma_name}` is overridden, but no other file has clauses of it", chosen[pragma_name].location)
    unit.clauses = [clause for clause in unit.clauses if id(clause) not in gone]
    _blank([clause.location for clauses in dropped.values() for clause in clauses], texts)
    return tuple(
        Overridden(name, chosen[name].location, tuple(sorted({clause.location for clause in clauses}))) for name, clauses in dropped.items()
    )


def _blank(places: list[Location], texts: dict[str, str]) -> None:
    for place in sorted(set(places)):
        text = texts[place.path]
        start = offset(text, place.line, place.column)
        texts[place.path] = blanked(text, start, clause_end(text, start))
