"""Rule coverage: the clauses that fire on some rows, found from the rows alone, of either engine.

A clause fires when its body has a match among the rows that are there in the end.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rosarch.datalog.inspection.clauses import Rule, rules_of
from rosarch.datalog.inspection.match import Body
from rosarch.datalog.inspection.rows import Given, RowStore, row_store
from rosarch.datalog.language.errors import Location
from rosarch.datalog.language.show import Writer
from rosarch.datalog.language.syntax import Atom

if TYPE_CHECKING:
    from rosarch.datalog.program import Program


@dataclass(frozen=True, slots=True)
class Clause:
    """A rule, or one alternative of a rule with `;`: `text` is what is left of it then."""

    location: Location
    relation: str
    text: str


@dataclass(frozen=True, slots=True)
class Coverage:
    """The clauses with a body, of all files, and those of them that never fired."""

    clauses: int
    unfired: tuple[Clause, ...]

    @property
    def fired(self) -> int:
        """How many clauses fired."""
        return self.clauses - len(self.unfired)


class Collector:
    """Adds up the coverage of one program over several evaluations."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.rules = rules_of(program)
        # of a subsumptive clause the rows show nothing: what it removed is gone
        self.all = [r for r in self.rules.all if r.clause.body and not r.generated and r.clause.dominating is None]
        self.left = {r.number: r for r in self.all}

    def add(self, rows: Given) -> None:
        """Count the clauses that fire on these rows."""
        store = row_store(self.program, rows)
        for rule in list(self.left.values()):
            if self._fires(rule, store):
                del self.left[rule.number]

    def _fires(self, rule: Rule, store: RowStore) -> bool:
        if any(isinstance(literal, Atom) and not store.count(literal.name) for literal in rule.clause.body):
            return False
        body = Body.of(rule, self.rules, store)
        return next(body.solve({}), None) is not None

    def coverage(self) -> Coverage:
        """What was found so far."""
        shared: dict[Location, int] = {}
        for rule in self.all:
            shared[rule.location] = shared.get(rule.location, 0) + 1
        unfired = sorted(self.left.values(), key=lambda r: (r.location, r.number))
        found = tuple(Clause(r.location, r.clause.head.name, self._text(r, shared[r.location] > 1)) for r in unfired)
        return Coverage(len(self.all), found)

    def _text(self, rule: Rule, alternative: bool) -> str:
        if not alternative:
            return rule.text
        writer = Writer(self.rules.types, rule.types)
        return f"{writer.literal(rule.clause.head)} :- {writer.body(rule.clause.body)}."


def coverage(program: Program, rows: Iterable[Given]) -> Coverage:
    """The clauses of a program that fire on none of several results, or sets of facts."""
    collector = Collector(program)
    for each in rows:
        collector.add(each)
    return collector.coverage()
