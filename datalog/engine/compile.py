"""A checked program to its executable form: one Python module and the order in which to call its functions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from rosarch.datalog.engine.bulk_rules import pair_clause, write_bulk
from rosarch.datalog.engine.codegen import Emitter
from rosarch.datalog.engine.expressions import Expressions, number_value
from rosarch.datalog.engine.indexes import Index
from rosarch.datalog.engine.plan import BulkRule, Code, Member, Rule, Stratum
from rosarch.datalog.engine.storage import Storage, row_of
from rosarch.datalog.language.ground import grounded_variables, is_bound
from rosarch.datalog.language.inference import ClauseTypes, kind_of
from rosarch.datalog.language.normalise import Normaliser, Scan, Step
from rosarch.datalog.language.syntax import (
    Argument,
    Atom,
    Branch,
    Clause,
    Counter,
    Functor,
    IterationCounter,
    Nil,
    Number,
    Record,
    Relation,
    String,
    Unnamed,
    Variable,
    clause_literals,
    walk,
)  # fmt: skip
from rosarch.datalog.language.types import Types


class Compiler:
    """Generates the functions of clauses."""

    def __init__(self, relations: Mapping[str, Relation], types: Types) -> None:
        self.relations = relations
        self.types = types
        slots = {name: i for i, name in enumerate(relations)}
        self.storage = Storage({name: len(r.attributes) for name, r in relations.items()})
        self.functions: dict[str, str] = {}
        self.matchers: dict[str, str] = {}
        self.code = Code(relation_slot=slots, arity=self.storage.arity)

    # -- clauses ------------------------------------------------------------------------------------

    def constant(self, term: Argument, types: ClauseTypes) -> Any:
        """The value of a constant term; LookupError when it takes evaluation."""
        match term:
            case String():
                return term.value
            case Number():
                return number_value(term.text, kind_of(types.of(term), self.types) or "i", self.types.bits)
            case Nil():
                return None
            case Record():
                return tuple(self.constant(a, types) for a in term.args)
            case Branch():
                return (term.name, *(self.constant(a, types) for a in term.args))
        raise LookupError

    def fact(self, clause: Clause, types: ClauseTypes) -> bool:
        """Store a clause without body as a row, if its arguments are constants."""
        if clause.body or clause.dominating is not None:
            return False
        try:
            row = tuple(self.constant(a, types) for a in clause.head.args)
        except LookupError:
            return False
        self.code.facts.setdefault(clause.head.name, []).append(row[0] if len(row) == 1 else row)
        return True

    def rule(self, clause: Clause, types: ClauseTypes, number: int, stratum: Plan) -> tuple[list[Rule], list[Rule]]:
        """Generate the functions of a clause: those to run once and those to run in the loop."""
        form = normalised(clause, types)
        head, steps = form.head, form.steps
        atoms = [s for s in steps if isinstance(s, Scan) and s.index >= 0 and s.atom.name in stratum.names]
        recursive = [s.index for s in atoms]
        if clause.dominating is not None:
            recursive = [0, 1]
        name = f"rule_{number}"
        if not recursive:
            return [self.function(name, clause, head, steps, types, None, stratum)], []
        if stratum.bulk is not None:
            self._bulk(clause, head, steps, recursive, name, stratum)
        return [], [self.function(f"{name}_{i}", clause, head, steps, types, i, stratum) for i in recursive]

    def _bulk(
        self, clause: Clause, head: Atom, steps: Sequence[Step], recursive: Sequence[int], name: str, stratum: Plan
    ) -> None:  # fmt: skip
        """Generate the functions that join whole sets; a stratum has them for all of its rules or for none."""
        pairs = pair_clause(head, steps)
        if pairs is None or stratum.bulk is None or not all(self.plain(relation) for relation, _ in pairs.atoms):
            stratum.bulk = None
            return
        slot = self.code.relation_slot
        positions = {s.index: i for i, s in enumerate(s for s in steps if isinstance(s, Scan))}
        for index in recursive:
            delta = positions[index]
            lines, turned, groupings = write_bulk(pairs, delta, f"{name}_{index}", slot)
            stratum.bulk_lines.extend(lines)
            rule = BulkRule(f"{name}_{index}", head.name, str(clause.location), pairs.atoms[delta][0], turned, groupings)
            stratum.bulk.append(rule)

    def plain(self, relation: str) -> bool:
        """Whether a relation holds pairs of numbers and symbols."""
        attributes = self.relations[relation].attributes
        return len(attributes) == 2 and all(self.types.kind(a.type) in "ius" for a in attributes)

    def function(
        self, name: str, clause: Clause, head: Atom, steps: Sequence[Step], types: ClauseTypes, delta: int | None, stratum: Plan
    ) -> Rule:  # fmt: skip
        counts, ordinals = effects(clause)
        self.code.uses_ordinals |= ordinals
        self.code.counts |= counts
        expressions = Expressions(self.types, types, self.matchers, interned=True)
        growing = () if delta is None else stratum.names
        emitter = Emitter(self.storage, expressions, ordered=counts or ordinals, delta=delta, growing=growing)
        wanted = {v for a in head.args for v in (n.name for n in walk(a) if isinstance(n, Variable))}
        subsumes = clause.dominating is not None
        guard: list[int] = []

        def row(bound: Mapping[str, str]) -> str:
            return row_of([expressions.write(a, bound) for a in head.args])

        def checkpoint(bound: dict[str, str]) -> bool:
            """Skip the remaining loops when the row is already there; true once emitted."""
            if counts or subsumes or not all(is_bound(a, set(bound)) for a in head.args):
                return False
            emitter.fail_if(f"{row(bound)} in full")
            guard.append(emitter.loops)
            return True

        def finish(bound: dict[str, str]) -> None:
            if subsumes:
                dominating = next(s.atom for s in steps if isinstance(s, Scan) and s.index == 1)
                emitter.line(f"if {row(bound)} != {row_of([expressions.write(a, bound) for a in dominating.args])}: add({row(bound)})")
            elif delta is not None and not stratum.staged:
                emitter.line(f"row = {row(bound)}")
                emitter.line("if row not in full: add(row); append(row)")
            elif delta is not None or stratum.chooses:
                emitter.line(f"row = {row(bound)}")
                emitter.line("if row not in full: add(row)")
            else:
                emitter.line(f"add({row(bound)})")
            if guard and emitter.loops > guard[0] and not emitter.functions:
                emitter.line("break")

        if subsumes:
            wanted |= {v.name for s in steps if isinstance(s, Scan) and s.index == 1 for v in s.atom.args if isinstance(v, Variable)}
        emitter.body(list(steps), {}, wanted, finish, bag=counts, checkpoint=checkpoint)
        if subsumes or stratum.chooses or (delta is not None and stratum.staged):
            prologue = "add = new.add"
        else:
            prologue = "add = full.add" if delta is None else "add = full.add; append = new.append"
        arguments = ", ".join(["S", "full", *emitter.arguments(), "delta", "new"])
        self.functions[name] = "\n".join([f"def {name}({arguments}):", f"    {prologue}", *emitter.lines])
        delta_name = next((s.atom.name for s in steps if isinstance(s, Scan) and s.index == delta), "")
        return self.described(name, clause, steps, delta, delta_name, emitter)

    def described(
        self, name: str, clause: Clause, steps: Sequence[Step], delta: int | None, delta_name: str, emitter: Emitter
    ) -> Rule:  # fmt: skip
        """What an evaluation has to know of a function that was written."""
        slot = self.code.relation_slot
        for number in emitter.indexes:
            self.storage.readers[number] += 1
        required = {s.atom.name for s in steps if isinstance(s, Scan) and s.index != delta} - self.storage.demanded
        return Rule(
            name, clause.head.name, str(clause.location), delta_name, tuple(sorted(slot[r] for r in required)),
            tuple(slot[r] for r in sorted(emitter.relations)),
            tuple((len(slot) + n, emitter.indexes[n]) for n in sorted(emitter.indexes)), tuple(sorted(emitter.tables)),
        )  # fmt: skip

    def add(self, clause: Clause, types: ClauseTypes, number: int, stratum: Plan) -> None:
        """Generate the functions of a clause and add them to the plan of its stratum."""
        once, again = self.rule(clause, types, number, stratum)
        stratum.base.extend(once)
        if clause.dominating is not None:
            stratum.subsumption.setdefault(clause.head.name, []).extend(again)
        else:
            stratum.loop.extend(again)

    def stratum(self, plan: Plan, drops: tuple[int, ...] = ()) -> Stratum:
        """What is cached of a plan."""
        members = tuple(self.member(n, plan.subsumption.get(n, ())) for n in plan.names)
        return Stratum(members, tuple(plan.base), tuple(plan.loop), plan.staged, tuple(plan.bulk or ()), drops)

    # -- assembly -----------------------------------------------------------------------------------

    def assemble(self) -> None:
        """Write the module, and what its indexes hold."""
        slot, arity = self.code.relation_slot, self.storage.arity
        self.code.indexes = tuple(
            Index(slot[key[0]], arity[key[0]], key[1], key[2], key in self.storage.listed, self.storage.readers[number])
            for key, number in self.storage.indexes.items()
        )
        matchers = [f"{name} = full_match({pattern!r})" for pattern, name in self.matchers.items()]
        self.code.source = "\n\n".join([*matchers, *self.functions.values()]) + "\n"

    def index_slots(self, name: str) -> tuple[int, ...]:
        """The slots of the indexes of a relation."""
        return tuple(len(self.code.relation_slot) + n for key, n in self.storage.indexes.items() if key[0] == name)

    def member(self, name: str, subsumption: Sequence[Rule]) -> Member:
        relation = self.relations[name]
        columns = {a.name: i for i, a in enumerate(relation.attributes)}
        choices = tuple(tuple(columns[c] for c in choice) for choice in relation.choices)
        counts = len(columns) == 1 and self.types.kind(relation.attributes[0].type) in ("i", "u")
        return Member(name, self.code.relation_slot[name], self.index_slots(name), counts, choices, tuple(subsumption), relation.limit)


@dataclass(slots=True)
class Plan:
    """A stratum while its rules are compiled."""

    names: Sequence[str]
    chooses: bool
    staged: bool
    bulk: list[BulkRule] | None
    bulk_lines: list[str] = field(default_factory=list)
    base: list[Rule] = field(default_factory=list)
    loop: list[Rule] = field(default_factory=list)
    subsumption: dict[str, list[Rule]] = field(default_factory=dict)

    def rules(self) -> list[Rule]:
        """All rules of the stratum."""
        return [*self.base, *self.loop, *(r for rules in self.subsumption.values() for r in rules)]


@dataclass(frozen=True, slots=True)
class Normalised:
    """A clause in the form that code is generated from; `normaliser` keeps the terms whose types are found by identity."""

    head: Atom
    steps: list[Step]
    normaliser: Normaliser


def normalised(clause: Clause, types: ClauseTypes) -> Normalised:
    """The clause in this form."""
    normaliser = Normaliser(types)
    body = clause.body if clause.dominating is None else (clause.head, clause.dominating, *clause.body)
    steps = normaliser.body(body, set(), top=True)
    return Normalised(normaliser.head(clause.head, steps, grounded_variables(body)), steps, normaliser)


@lru_cache(maxsize=1024)
def effects(clause: Clause) -> tuple[bool, bool]:
    """Whether the values of a clause depend on how often it was evaluated, and whether it numbers symbols."""
    nodes = [n for literal in clause_literals(clause) for n in walk(literal)]
    return (
        any(isinstance(n, (Counter, IterationCounter)) for n in nodes),
        any(isinstance(n, Functor) and n.op == "ord" for n in nodes),
    )


def eqrel_clauses(relation: Relation) -> list[Clause]:
    """The rules that make a binary relation an equivalence relation."""
    at, name = relation.location, relation.name

    def atom(*names: str) -> Atom:
        return Atom(name, tuple(Variable(n, at) if n != "_" else Unnamed(at) for n in names), at)

    return [
        Clause(atom("x", "x"), (atom("x", "_"),), at),
        Clause(atom("y", "x"), (atom("x", "y"),), at),
        Clause(atom("x", "z"), (atom("x", "y"), atom("y", "z")), at),
    ]


Clauses = Mapping[str, Sequence[tuple[Clause, ClauseTypes]]]


def compile_program(relations: Mapping[str, Relation], strata: Sequence[Sequence[str]], clauses: Clauses, types: Types) -> Code:
    """Generate the code of a program whose clauses are grouped by head relation."""
    compiler = Compiler(relations, types)
    number = 0
    plans: list[Plan] = []
    for names in strata:
        own = [pair for name in names for pair in clauses.get(name, ())]
        plan = new_plan(compiler, names, [clause for clause, _ in own])
        for clause, clause_types in own:
            if compiler.fact(clause, clause_types):
                continue
            number += 1
            compiler.add(clause, clause_types, number, plan)
        plans.append(plan)
    return assembled(compiler, plans)


def new_plan(compiler: Compiler, names: Sequence[str], clauses: Iterable[Clause]) -> Plan:
    """The plan of a stratum with these clauses, still without rules."""
    relations = compiler.relations
    chooses = any(relations[n].choices for n in names)
    staged = chooses or any(relations[n].limit for n in names) or any(c.dominating is not None or any(effects(c)) for c in clauses)
    return Plan(names, chooses, staged, None if staged or not all(map(compiler.plain, names)) else [])


def assembled(compiler: Compiler, plans: Sequence[Plan]) -> Code:
    """The code of a program whose functions have been generated."""
    compiler.assemble()
    code, relations, types = compiler.code, compiler.relations, compiler.types
    kinds = {name: [types.kind(a.type) for a in relation.attributes] for name, relation in relations.items()}
    code.nested = {name: found for name, ks in kinds.items() if (found := tuple(i for i, k in enumerate(ks) if k in "r+"))}
    code.bulk_source = "\n".join(line for plan in plans if plan.bulk for line in plan.bulk_lines)
    derived = (rule.target for plan in plans for rule in plan.rules())
    code.derived = frozenset((*code.facts, *derived, *(table.relation for table in code.tables)))
    code.probed = frozenset(compiler.storage.probed)
    last_use: dict[int, int] = {}  # slot to stratum
    for position, plan in enumerate(plans):
        for rule in plan.rules():
            last_use.update(dict.fromkeys(_used(rule, code), position))
        last_use.update(dict.fromkeys((code.relation_slot[name] for name in plan.names), position))
    for table in code.tables:  # who asks a table, and when, is not followed
        for rule in table.all_rules():
            last_use.update(dict.fromkeys(_used(rule, code), len(plans)))
    for position, plan in enumerate(plans):
        code.strata.append(compiler.stratum(plan, tuple(slot for slot, last in last_use.items() if last == position)))
    return code


def _used(rule: Rule, code: Code) -> set[int]:
    """The slots that a rule reads, its indexes' relations among them."""
    return code.relations_of(rule).union(slot for slot, _ in rule.indexes)
