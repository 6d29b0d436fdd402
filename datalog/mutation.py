"""Mutation of rules: would a test notice if a literal were missing, or said the opposite?

A mutant is a program with one clause changed: a literal of its body dropped, an atom negated or a negation taken away, a comparison turned
around (DeMillo, Lipton and Sayward, "Hints on test data selection", 1978, applied to conjunctions). It is killed by a case in which a
relation that the case observes has other rows than before. What no case kills is a clause that the tests do not pin.

Mutants are cheap because they are evaluated in parts: first the relation of the changed clause alone, from the rows that the others are
known to have; only where its rows differ, what reads it, up to the observed relations.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from .clauses import Rule, Rules, rules_of
from .errors import DatalogError, Location, Report
from .program import Program, compile_unit
from .rows import Row
from .show import Writer
from .slices import slice_unit
from .sources import Sources
from .strata import reachable, turned_around
from .syntax import Atom, Clause, Literal, Truth
from .tree import negate_literal

PATIENCE = 5.0  # seconds for one mutant on one case: one that takes longer is noticed


@dataclass(frozen=True, slots=True)
class Case:
    """A test: the rows of all relations, and those relations whose rows the test looks at.

    `fails` tells whether the test does with other rows; without it, it does when any observed relation has others.
    """

    name: str
    rows: Mapping[str, Collection[Row]]
    observed: frozenset[str]
    fails: Callable[[Mapping[str, Collection[Row]]], bool] | None = None

    def notices(self, changed: Mapping[str, Collection[Row]]) -> bool:
        """Whether the test fails when these relations have these rows."""
        if all(set(rows) == set(self.rows[name]) for name, rows in changed.items() if name in self.observed):
            return False
        return self.fails is None or self.fails({**self.rows, **changed})


@dataclass(frozen=True, slots=True)
class Mutant:
    """A clause with one literal changed; `change` says how."""

    rule: Rule
    clause: Clause
    change: str

    @property
    def location(self) -> Location:
        """Where the clause starts."""
        return self.rule.location


@dataclass(frozen=True, slots=True)
class Verdict:
    """What became of a mutant: the case that killed it; empty when none did."""

    mutant: Mutant
    killed_by: str


def mutants(rules: Rules) -> Iterator[Mutant]:
    """The mutants of every clause with a body, in source order."""
    for rule in rules.all:
        if rule.clause.body and not rule.generated and rule.clause.dominating is None:
            yield from _of_clause(rule, Writer(rules.types, rule.types))


def _of_clause(rule: Rule, writer: Writer) -> Iterator[Mutant]:
    body = rule.clause.body
    for at, literal in enumerate(body):
        text = writer.literal(literal)
        if len(body) > 1:
            yield Mutant(rule, replace(rule.clause, body=body[:at] + body[at + 1 :], plan=()), f"without {text}")
        flipped = _opposite(literal)
        if flipped is not None:
            changed = replace(rule.clause, body=(*body[:at], flipped, *body[at + 1 :]), plan=())
            yield Mutant(rule, changed, f"{writer.literal(flipped)} for {text}")


def _opposite(literal: Literal) -> Literal | None:
    return None if isinstance(literal, Truth) else negate_literal(literal)


class MutationTest:
    """Judges mutants of a program by cases."""

    def __init__(self, program: Program, cases: Sequence[Case]) -> None:
        self.rules = rules_of(program)
        self.cases = list(cases)
        self._downstream: dict[frozenset[str], tuple[Program, frozenset[str]] | None] = {}

    @cached_property
    def _readers(self) -> Mapping[str, Collection[str]]:
        return turned_around(self.rules.reads)

    def judge(self, mutant: Mutant) -> Verdict | None:
        """Whether a case kills a mutant; None when the mutant is no legal program."""
        name = mutant.rule.clause.head.name
        group = self.rules.recursive.get(name, frozenset((name,)))
        clauses = [mutant.clause if c is mutant.rule.clause else c for c in self._clauses(group)]
        try:
            changed, needed = self._part(group, clauses)
        except DatalogError:
            return None
        for case in self._likely(mutant):
            rows = self._evaluate(changed, case, needed, group)
            if rows is None or (any(rows[n] != set(case.rows[n]) for n in group) and self._noticed(group, rows, case)):
                return Verdict(mutant, case.name)
        return Verdict(mutant, "")

    def _likely(self, mutant: Mutant) -> list[Case]:
        """The cases in which the mutant can differ: rows for every atom that is left in its clause, or in the clause it comes from."""
        bodies = (mutant.clause.body, mutant.rule.clause.body)
        atoms = [{literal.name for literal in body if isinstance(literal, Atom)} for body in bodies]
        return [c for c in self.cases if any(all(c.rows.get(name) for name in names) for names in atoms)]

    def _noticed(self, group: frozenset[str], rows: Mapping[str, set[Row]], case: Case) -> bool:
        """Whether a case notices that the relations of the group have these rows, and what reads them those that follow."""
        if group not in self._downstream:
            self._downstream[group] = self._after(group)
        found = self._downstream[group]
        if found is None:
            return case.notices(rows)
        program, needed = found
        observed = case.observed & program.relations.keys() - needed
        derived = self._evaluate(program, replace(case, rows={**case.rows, **rows}), needed, observed)
        return derived is None or case.notices({**rows, **derived})

    def _after(self, group: frozenset[str]) -> tuple[Program, frozenset[str]] | None:
        """The program of what reads the group, up to observed relations, with the group as its input."""
        observed = frozenset(n for case in self.cases for n in case.observed)
        after = reachable(group, self._readers) - group
        before = reachable(observed & after, self.rules.reads)
        wanted = after & before
        return self._part(wanted, self._clauses(wanted)) if wanted else None

    def _clauses(self, names: Collection[str]) -> list[Clause]:
        return [rule.clause for name in names for rule in self.rules.by_head.get(name, ())]

    def _part(self, names: Collection[str], clauses: Sequence[Clause]) -> tuple[Program, frozenset[str]]:
        """A program of some relations; the others that they read are its input."""
        unit, needed = slice_unit(self.rules.unit, names, clauses)
        return compile_unit(unit, Sources(), Report({}), self.rules.types.bits), needed

    @staticmethod
    def _evaluate(program: Program, case: Case, needed: Collection[str], kept: Collection[str]) -> dict[str, set[Row]] | None:
        """The rows of some relations; None when it takes too long."""
        try:
            result = program.evaluate({n: case.rows.get(n, ()) for n in needed}, keep=kept, time_limit=PATIENCE)
        except DatalogError:
            return None
        return {name: set(result.rows(name)) for name in kept}


def summary(verdicts: Sequence[Verdict]) -> str:
    """How many mutants were killed, as text."""
    killed = sum(bool(v.killed_by) for v in verdicts)
    return f"{killed} of {len(verdicts)} mutants killed ({killed / max(len(verdicts), 1):.1%})"


def survivors_text(verdicts: Sequence[Verdict], *, shorten: Callable[[str], str] = str) -> str:
    """The mutants that no case killed, a line each, and how many there were."""
    lines = [f"{shorten(v.mutant.location.path)}:{v.mutant.location.line}: {v.mutant.change}" for v in verdicts if not v.killed_by]
    return "".join(f"{line}\n" for line in [*lines, summary(verdicts)])
