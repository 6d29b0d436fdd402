"""Mutation of rules: would a test notice if a literal were missing, or said the opposite?

A mutant is a program with one clause changed: a literal of its body dropped, an atom negated or a negation taken away, a comparison turned
around (DeMillo, Lipton and Sayward, "Hints on test data selection", 1978, applied to conjunctions). A literal that alternatives (`;`) share
is one literal, changed in all of them. A mutant is killed by a case in which a relation that the case observes has other rows than before.
What no case kills is a clause that the tests do not pin.

Relations whose comment ends in `Demand.` say what is asked for and claim nothing: they keep others from working out what nobody reads. More
demand is more work for the same rows. So no literal is dropped that is an atom of such a relation, or is in one of its clauses.

Mutants are cheap because they are evaluated in parts: first the relation of the changed clause alone, from the rows that the others are
known to have; only where its rows differ, what reads it, up to the observed relations.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from rosarch.datalog.engine.slices import slice_unit
from rosarch.datalog.inspection.clauses import Rule, Rules, rules_of
from rosarch.datalog.inspection.conventions import certainty
from rosarch.datalog.inspection.rows import Row
from rosarch.datalog.language.errors import DatalogError, Location, Report
from rosarch.datalog.language.show import Writer
from rosarch.datalog.language.sources import Sources
from rosarch.datalog.language.strata import atoms_of, reachable, turned_around
from rosarch.datalog.language.syntax import Atom, Clause, Literal, Truth, Unit
from rosarch.datalog.language.tree import negate_literal
from rosarch.datalog.program import Program, compile_unit

_ALONE = "_derived by one clause"
_INSTANCE = re.compile(r"\b(?:\w+\.)+(?=\w+\()")
PATIENCE = 5.0  # seconds for one mutant on one case: one that takes longer is noticed

_Part = tuple[Program, frozenset[str]]  # and the relations whose rows it is given
_Changed = Mapping[str, frozenset[Row]]


@dataclass(frozen=True, slots=True)
class Case:
    """A test: the rows of all relations, and those relations whose rows the test looks at.

    `fails` says whether the test does with the rows that some observed relations have instead; without it, it does with any.
    """

    name: str
    rows: Mapping[str, Collection[Row]]
    observed: frozenset[str]
    fails: Callable[[Mapping[str, Collection[Row]]], bool] | None = None

    def notices(self, changed: Mapping[str, Collection[Row]]) -> bool:
        """Whether the test fails when these relations have these rows."""
        other = {name: rows for name, rows in changed.items() if name in self.observed and set(rows) != set(self.rows[name])}
        return bool(other) and (self.fails is None or self.fails(other))


@dataclass(frozen=True, slots=True)
class Mutant:
    """A clause with one literal changed: the alternatives that have it, before and after; `change` says how."""

    rules: tuple[Rule, ...]
    clauses: tuple[Clause, ...]
    change: str
    follows: bool = False  # what the original clause derives, this one does
    negates: str = ""  # the relation that is negated

    @property
    def location(self) -> Location:
        """Where the clause starts."""
        return self.rules[0].location

    @property
    def relation(self) -> str:
        """What the clause derives."""
        return self.rules[0].clause.head.name

    @property
    def written(self) -> tuple[Location, str]:
        """The place and the change as they are in the text, where instances of a component are one."""
        return self.location, _INSTANCE.sub("", self.change)


@dataclass(frozen=True, slots=True)
class Verdict:
    """What became of a mutant: the case that killed it; empty when none did."""

    mutant: Mutant
    killed_by: str


def demanded(program: Program, rules: Rules) -> frozenset[str]:
    """The relations that only say what is asked for: by their comment, and as no clause asks for their absence or number."""
    declared = {name for name, declaration in program.relations.items() if certainty(declaration).word == "Demand"}
    strictly = {atom.name for rule in rules.all for literal in rule.clause.body for atom, strict in atoms_of(literal) if strict}
    return frozenset(declared - strictly)


def mutants(rules: Rules, demand: frozenset[str] = frozenset()) -> Iterator[Mutant]:
    """The mutants of every clause with a body, in source order."""
    written: dict[tuple[Location, str], list[Rule]] = {}
    for rule in rules.all:
        if rule.clause.body and not rule.generated and rule.clause.dominating is None:
            written.setdefault((rule.location, rule.clause.head.name), []).append(rule)
    for alternatives in written.values():
        yield from _of_clause(alternatives, rules, demand)


def _of_clause(alternatives: Sequence[Rule], rules: Rules, demand: frozenset[str]) -> Iterator[Mutant]:
    found: dict[tuple[object, str], list[tuple[Rule, int]]] = {}
    for rule in alternatives:
        writer = Writer(rules.types, rule.types)
        for at, literal in enumerate(rule.clause.body):
            found.setdefault((getattr(literal, "location", None), writer.literal(literal)), []).append((rule, at))
    for (_, text), places in found.items():
        rule, at = places[0]
        literal = rule.clause.body[at]
        name = literal.name if isinstance(literal, Atom) else ""
        having = tuple(rule for rule, _ in places)
        if all(len(rule.clause.body) > 1 for rule in having) and demand.isdisjoint((name, rule.clause.head.name)):
            yield Mutant(having, tuple(_with(rule, at, ()) for rule, at in places), f"without {text}", follows=True)
        flipped = _opposite(literal)
        if flipped is not None:
            changed = tuple(_with(rule, at, tuple(filter(None, (_opposite(rule.clause.body[at]),)))) for rule, at in places)
            yield Mutant(having, changed, f"{Writer(rules.types, rule.types).literal(flipped)} for {text}", negates=name)


def _with(rule: Rule, at: int, literals: tuple[Literal, ...]) -> Clause:
    """A clause with others in the place of one literal."""
    body = rule.clause.body
    return replace(rule.clause, body=(*body[:at], *literals, *body[at + 1 :]), plan=())


def _opposite(literal: Literal) -> Literal | None:
    return None if isinstance(literal, Truth) else negate_literal(literal)


class MutationTest:
    """Judges mutants of a program by cases."""

    def __init__(self, program: Program, cases: Sequence[Case]) -> None:
        self.rules = rules_of(program)
        self.demand = demanded(program, self.rules)
        whole = [replace(case, rows={name: frozenset(rows) for name, rows in case.rows.items()}) for case in cases]
        self.cases = sorted(whole, key=lambda case: sum(map(len, case.rows.values())))
        self._latest: tuple[tuple[Rule, ...], Case | None] = ((), None)
        self._strata: dict[int, _Part] = {}
        self._fired: tuple[tuple[Rule, ...], dict[int, bool]] = ((), {})
        self._leading: dict[frozenset[str], set[str]] = {}

    def judge(self, mutant: Mutant) -> Verdict | None:
        """Whether a case kills a mutant; None when the mutant is no legal program."""
        if mutant.negates in self._group(mutant.relation):
            return None  # negation in a cycle
        try:
            alone = self._alone(mutant.clauses)
        except DatalogError:
            return None
        whole: list[_Part] = []
        for case in self._likely(mutant):
            changed = self._changed(mutant, alone, whole, case)
            if changed is None or (changed and self._noticed(changed, case)):
                self._latest = mutant.rules, case
                return Verdict(mutant, case.name)
        return Verdict(mutant, "")

    def _likely(self, mutant: Mutant) -> list[Case]:
        """The cases in which the mutant can differ: rows for every atom that is left in its clause, or in the clause it comes from.

        That which killed the mutant before, of the same clause, comes first, then those with fewest rows.
        """
        bodies = [clause.body for clause in (*mutant.clauses, *(rule.clause for rule in mutant.rules))]
        atoms = [{literal.name for literal in body if isinstance(literal, Atom)} for body in bodies]
        likely = [c for c in self.cases if any(all(c.rows.get(name) for name in names) for names in atoms)]
        rules, killer = self._latest
        return sorted(likely, key=lambda case: case is not killer) if rules == mutant.rules else likely

    def _changed(self, mutant: Mutant, alone: _Part, whole: list[_Part], case: Case) -> _Changed | None:
        """The relations that are recursive with the mutant's and have other rows in a case; None when these are not found in time.

        The rows of a program are the least that its clauses add nothing to. So those of the mutant are the same when its clause adds
        nothing, and derives what the original one did, or that derived nothing.
        """
        name = mutant.relation
        derived = self._evaluate(alone, case.rows, (_ALONE,))
        if derived is None:
            return None
        group = self._group(name)
        rows = frozenset(case.rows[name])
        more = derived[_ALONE] - rows
        if not any(rule.clause.dominating for n in group for rule in self.rules.by_head.get(n, ())):
            if not more and (mutant.follows or not self._fires(mutant.rules, case)):
                return {}
            if mutant.follows and name not in self.rules.recursive:
                return {name: rows | more}
        if not whole:
            changed = {id(rule.clause): clause for rule, clause in zip(mutant.rules, mutant.clauses, strict=True)}
            whole.append(self._part(group, [changed.get(id(clause), clause) for clause in self._clauses(group)]))
        found = self._evaluate(whole[0], case.rows, group)
        return None if found is None else {n: rows for n, rows in found.items() if rows != case.rows[n]}

    def _fires(self, rules: tuple[Rule, ...], case: Case) -> bool:
        """Whether clauses derive anything in a case. What was found out is kept while mutants are of the same clauses."""
        if self._fired[0] is not rules:
            self._fired = (rules, {})
            clauses = tuple(rule.clause for rule in rules)
            alone = self._alone(clauses)
            for each in self._likely(Mutant(rules, clauses, "")):
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

    def _group(self, name: str) -> frozenset[str]:
        return self.rules.recursive.get(name, frozenset((name,)))

    def _clauses(self, names: Collection[str]) -> list[Clause]:
        return [rule.clause for name in names for rule in self.rules.by_head.get(name, ())]

    def _stratum(self, number: int) -> _Part:
        if number not in self._strata:
            names = self.rules.strata[number]
            self._strata[number] = self._part(names, self._clauses(names))
        return self._strata[number]

    def _alone(self, clauses: Sequence[Clause]) -> _Part:
        """A program of some clauses of a relation, which derive one of their own from what is given."""
        head = next(r for r in self.rules.unit.relations if r.name == clauses[0].head.name)
        own = replace(head, name=_ALONE, qualifiers=frozenset(), choices=())
        unit = replace(self.rules.unit, relations=[*self.rules.unit.relations, own])
        return self._part((_ALONE,), [replace(clause, head=replace(clause.head, name=_ALONE)) for clause in clauses], unit)

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


def merged(verdicts: Iterable[Verdict]) -> list[Verdict]:
    """A verdict for each change of the text: one in a component is noticed when it is in an instance."""
    found: dict[tuple[Location, str], Verdict] = {}
    for verdict in verdicts:
        known = found.setdefault(verdict.mutant.written, verdict)
        if verdict.killed_by and not known.killed_by:
            found[verdict.mutant.written] = verdict
    return list(found.values())


def summary(verdicts: Sequence[Verdict]) -> str:
    """How many mutants were killed, as text."""
    killed = sum(bool(v.killed_by) for v in verdicts)
    return f"{killed} of {len(verdicts)} mutants killed ({killed / max(len(verdicts), 1):.1%})"


def survivors_text(verdicts: Sequence[Verdict], *, shorten: Callable[[str], str] = str) -> str:
    """The mutants that no case killed, a line each, and how many there were."""
    lines = [f"{shorten(v.mutant.location.path)}:{v.mutant.location.line}: {v.mutant.change}" for v in verdicts if not v.killed_by]
    return "".join(f"{line}\n" for line in [*lines, summary(verdicts)])
