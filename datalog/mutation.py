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
from .syntax import Atom, Clause, Literal, Truth, Unit
from .tree import negate_literal

_ALONE = "_derived by one clause"
PATIENCE = 5.0  # seconds for one mutant on one case: one that takes longer is noticed

_Part = tuple[Program, frozenset[str]]  # and the relations whose rows it is given
_Changed = Mapping[str, frozenset[Row]]


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
    follows: bool = False  # what the original clause derives, this one does
    negates: str = ""  # the relation that is negated

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
            yield Mutant(rule, replace(rule.clause, body=body[:at] + body[at + 1 :], plan=()), f"without {text}", follows=True)
        flipped = _opposite(literal)
        if flipped is not None:
            changed = replace(rule.clause, body=(*body[:at], flipped, *body[at + 1 :]), plan=())
            yield Mutant(rule, changed, f"{writer.literal(flipped)} for {text}", negates=literal.name if isinstance(literal, Atom) else "")


def _opposite(literal: Literal) -> Literal | None:
    return None if isinstance(literal, Truth) else negate_literal(literal)


class MutationTest:
    """Judges mutants of a program by cases."""

    def __init__(self, program: Program, cases: Sequence[Case]) -> None:
        self.rules = rules_of(program)
        self.cases = [replace(case, rows={name: frozenset(rows) for name, rows in case.rows.items()}) for case in cases]
        self._strata: dict[int, _Part] = {}
        self._fired: tuple[Rule | None, dict[int, bool]] = (None, {})
        self._leading: dict[frozenset[str], set[str]] = {}

    def judge(self, mutant: Mutant) -> Verdict | None:
        """Whether a case kills a mutant; None when the mutant is no legal program."""
        if mutant.negates in self._group(mutant.rule):
            return None  # negation in a cycle
        try:
            alone = self._alone(mutant.clause)
        except DatalogError:
            return None
        whole: list[_Part] = []
        for case in self._likely(mutant):
            changed = self._changed(mutant, alone, whole, case)
            if changed is None or (changed and self._noticed(changed, case)):
                return Verdict(mutant, case.name)
        return Verdict(mutant, "")

    def _likely(self, mutant: Mutant) -> list[Case]:
        """The cases in which the mutant can differ: rows for every atom that is left in its clause, or in the clause it comes from."""
        bodies = (mutant.clause.body, mutant.rule.clause.body)
        atoms = [{literal.name for literal in body if isinstance(literal, Atom)} for body in bodies]
        return [c for c in self.cases if any(all(c.rows.get(name) for name in names) for names in atoms)]

    def _changed(self, mutant: Mutant, alone: _Part, whole: list[_Part], case: Case) -> _Changed | None:
        """The relations that are recursive with the mutant's and have other rows in a case; None when these are not found in time.

        The rows of a program are the least that its clauses add nothing to. So those of the mutant are the same when its clause adds
        nothing, and derives what the original one did, or that derived nothing.
        """
        name = mutant.rule.clause.head.name
        derived = self._evaluate(alone, case.rows, (_ALONE,))
        if derived is None:
            return None
        group = self._group(mutant.rule)
        rows = frozenset(case.rows[name])
        more = derived[_ALONE] - rows
        if not any(rule.clause.dominating for n in group for rule in self.rules.by_head.get(n, ())):
            if not more and (mutant.follows or not self._fires(mutant.rule, case)):
                return {}
            if mutant.follows and name not in self.rules.recursive:
                return {name: rows | more}
        if not whole:
            whole.append(self._part(group, [mutant.clause if c is mutant.rule.clause else c for c in self._clauses(group)]))
        found = self._evaluate(whole[0], case.rows, group)
        return None if found is None else {n: rows for n, rows in found.items() if rows != case.rows[n]}

    def _fires(self, rule: Rule, case: Case) -> bool:
        """Whether a clause derives anything in a case. What was found out is kept while mutants are of the same clause."""
        if self._fired[0] is not rule:
            self._fired = (rule, {})
            alone = self._alone(rule.clause)
            for each in self._likely(Mutant(rule, rule.clause, "")):
                derived = self._evaluate(alone, each.rows, (_ALONE,))
                self._fired[1][id(each)] = derived is None or bool(derived[_ALONE])
        return self._fired[1].get(id(case), False)

    def _noticed(self, changed: _Changed, case: Case) -> bool:
        """Whether a case notices that some relations have other rows, and what reads them those that follow: stratum by stratum."""
        rows = {**case.rows, **changed}
        different = dict(changed)
        waiting = self._reading(changed, case)
        while waiting and (case.fails is not None or case.observed.isdisjoint(different)):
            number = min(waiting)
            waiting.remove(number)
            derived = self._evaluate(self._stratum(number), rows, self.rules.strata[number])
            if derived is None:
                return True
            found = {n: new for n, new in derived.items() if new != rows[n]}
            rows.update(found)
            different.update(found)
            waiting |= self._reading(found, case) - {number}
        return case.notices(different)

    def _reading(self, names: Collection[str], case: Case) -> set[int]:
        """The strata that read some relations and lead to what a case observes; not those of these relations themselves."""
        if case.observed not in self._leading:
            self._leading[case.observed] = reachable(case.observed, self.rules.reads)
        readers = {reader for name in names for reader in self._readers.get(name, ())} & self._leading[case.observed]
        return {self._number[name] for name in readers} - {self._number[name] for name in names}

    @cached_property
    def _readers(self) -> Mapping[str, Collection[str]]:
        return turned_around(self.rules.reads)

    @cached_property
    def _number(self) -> Mapping[str, int]:
        return {name: number for number, names in enumerate(self.rules.strata) for name in names}

    def _group(self, rule: Rule) -> frozenset[str]:
        name = rule.clause.head.name
        return self.rules.recursive.get(name, frozenset((name,)))

    def _clauses(self, names: Collection[str]) -> list[Clause]:
        return [rule.clause for name in names for rule in self.rules.by_head.get(name, ())]

    def _stratum(self, number: int) -> _Part:
        if number not in self._strata:
            names = self.rules.strata[number]
            self._strata[number] = self._part(names, self._clauses(names))
        return self._strata[number]

    def _alone(self, clause: Clause) -> _Part:
        """A program of one clause, which derives a relation of its own from what is given."""
        head = next(r for r in self.rules.unit.relations if r.name == clause.head.name)
        own = replace(head, name=_ALONE, qualifiers=frozenset(), choices=())
        unit = replace(self.rules.unit, relations=[*self.rules.unit.relations, own])
        return self._part((_ALONE,), [replace(clause, head=replace(clause.head, name=_ALONE))], unit)

    def _part(self, names: Collection[str], clauses: Sequence[Clause], unit: Unit | None = None) -> _Part:
        """A program of some relations; the others that they read are its input."""
        unit, needed = slice_unit(unit or self.rules.unit, names, clauses)
        return compile_unit(unit, Sources(), Report({}), self.rules.types.bits), needed

    @staticmethod
    def _evaluate(part: _Part, rows: Mapping[str, Collection[Row]], kept: Collection[str]) -> dict[str, frozenset[Row]] | None:
        """The rows of some relations; None when it takes too long."""
        program, needed = part
        try:
            result = program.evaluate({n: rows.get(n, ()) for n in needed}, keep=kept, time_limit=PATIENCE)
        except DatalogError:
            return None
        return {name: frozenset(result.rows(name)) for name in kept}


def summary(verdicts: Sequence[Verdict]) -> str:
    """How many mutants were killed, as text."""
    killed = sum(bool(v.killed_by) for v in verdicts)
    return f"{killed} of {len(verdicts)} mutants killed ({killed / max(len(verdicts), 1):.1%})"


def survivors_text(verdicts: Sequence[Verdict], *, shorten: Callable[[str], str] = str) -> str:
    """The mutants that no case killed, a line each, and how many there were."""
    lines = [f"{shorten(v.mutant.location.path)}:{v.mutant.location.line}: {v.mutant.change}" for v in verdicts if not v.killed_by]
    return "".join(f"{line}\n" for line in [*lines, summary(verdicts)])
