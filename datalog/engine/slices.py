"""A part of a program as a program of its own: some relations are derived, the others that they read are its input."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from rosarch.datalog.language.errors import Location
from rosarch.datalog.language.strata import dependencies
from rosarch.datalog.language.syntax import Clause, Directive, Unit


def slice_unit(unit: Unit, names: Collection[str], clauses: Sequence[Clause]) -> tuple[Unit, frozenset[str]]:
    """The program of the relations `names`, which have these clauses, and the relations that it needs the rows of."""
    own = frozenset(names)
    needed = frozenset(name for read in dependencies(own, clauses).reads.values() for name in read) - own
    given = [replace(r, qualifiers=frozenset(), choices=()) for r in unit.relations if r.name in needed]
    at = Location("", 1, 1)
    part = replace(
        unit,
        relations=[*given, *(r for r in unit.relations if r.name in own)],
        clauses=list(clauses),
        directives=[
            *(d for d in unit.directives if d.relation in own and d.kind == "limitsize"),
            *(Directive("input", name, (), at) for name in sorted(needed)),
        ],
    )
    return part, needed
