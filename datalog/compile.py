"""A checked program to its executable form: one Python module and the order in which to call its functions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from .codegen import Emitter, IndexKey, RuleFunction, Storage, index_local, local, row_of
from .expressions import Expressions, number_value
from .ground import grounded_variables, is_bound
from .inference import ClauseTypes, kind_of
from .normalise import Normaliser, Scan, Step
from .syntax import (
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
from .types import Types

REJECTED = "rejected"


@dataclass(frozen=True, slots=True)
class Rule:
    """A generated function and where it comes from."""

    function: str
    target: str
    location: str  # path:line:col of the clause
    delta: str = ""  # the relation whose delta it scans


@dataclass(frozen=True, slots=True)
class Member:
    """A relation of a stratum: its slots, and the indexes to maintain while the stratum grows."""

    name: str
    full: int
    new: int
    delta: int
    indexes: tuple[tuple[int, str], ...]  # slot, name of the function that adds rows
    choices: tuple[tuple[int, ...], ...] = ()
    subsumption: tuple[Rule, ...] = ()


@dataclass(frozen=True, slots=True)
class Stratum:
    """Relations that depend on each other: rules to run once, and rules to run until nothing is new."""

    members: tuple[Member, ...]
    base: tuple[Rule, ...]
    loop: tuple[Rule, ...]
    drops: tuple[tuple[str, tuple[int, ...]], ...] = ()  # relations not read later, with all their slots

    @property
    def staged(self) -> bool:
        """Whether base rules write to the new rows instead of the relation."""
        return any(m.choices for m in self.members)


@dataclass(slots=True)
class Code:
    """What is cached: everything needed to evaluate, independent of the syntax tree."""

    source: str = ""
    strata: list[Stratum] = field(default_factory=list)
    facts: dict[str, list[Any]] = field(default_factory=dict)
    relation_slot: dict[str, int] = field(default_factory=dict)
    arity: dict[str, int] = field(default_factory=dict)
    slots: int = 0
    uses_ordinals: bool = False


class _Compiler:
    def __init__(self, relations: Mapping[str, Relation], types: Types) -> None:
        self.relations = relations
        self.types = types
        slots = {name: i for i, name in enumerate(relations)}
        self.storage = Storage(slots, {name: len(r.attributes) for name, r in relations.items()})
        self.functions: list[RuleFunction] = []
        self.matchers: dict[str, str] = {}
        self.code = Code(relation_slot=slots, arity=self.storage.arity)

    # -- clauses ------------------------------------------------------------------------------------

    def constant(self, term: Argument, types: ClauseTypes) -> Any:
        """The value of a constant term; LookupError when it takes evaluation."""
        match term:
            case String():
                return term.value
            case Number():
                return number_value(term.text, kind_of(types.of(term), self.types) or "i")
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

    def rule(self, clause: Clause, types: ClauseTypes, number: int, stratum: set[str], staged: bool) -> tuple[list[Rule], list[Rule]]:
        """Generate the functions of a clause: those to run once and those to run in the loop."""
        normaliser = Normaliser(types)
        given: set[str] = set()
        outside = {v.name for a in clause.head.args for v in walk(a) if isinstance(v, Variable)}
        body = clause.body if clause.dominating is None else (clause.head, clause.dominating, *clause.body)
        steps = normaliser.body(body, outside, given, top=True)
        head = normaliser.head(clause.head, steps, grounded_variables(body))
        atoms = [s for s in steps if isinstance(s, Scan) and s.index >= 0 and s.atom.name in stratum]
        recursive = [s.index for s in atoms]
        if clause.dominating is not None:
            recursive = [0, 1]
        name = f"rule_{number}"
        if not recursive:
            return [self.function(name, clause, head, steps, types, None, staged)], []
        versions = [self.function(f"{name}_{i}", clause, head, steps, types, i, True) for i in recursive]
        return [], versions

    def function(
        self, name: str, clause: Clause, head: Atom, steps: Sequence[Step], types: ClauseTypes, delta: int | None, staged: bool
    ) -> Rule:  # fmt: skip
        counts = any(isinstance(n, (Counter, IterationCounter)) for lit in clause_literals(clause) for n in walk(lit))
        ordinal = any(isinstance(n, Functor) and n.op == "ord" for lit in clause_literals(clause) for n in walk(lit))
        self.code.uses_ordinals |= ordinal
        expressions = Expressions(self.types, types, self.matchers)
        emitter = Emitter(self.storage, expressions, ordered=counts or ordinal, delta=delta)
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
            elif staged:
                emitter.line(f"row = {row(bound)}")
                emitter.line("if row not in full: add(row)")
            else:
                emitter.line(f"add({row(bound)})")
            if guard and emitter.loops > guard[0] and not emitter.functions:
                emitter.line("break")

        if subsumes:
            wanted |= {v.name for s in steps if isinstance(s, Scan) and s.index == 1 for v in s.atom.args if isinstance(v, Variable)}
        emitter.body(list(steps), {}, wanted, finish, bag=counts, checkpoint=checkpoint)
        required = [s.atom.name for s in steps if isinstance(s, Scan) and s.index != delta]
        delta_name = next((s.atom.name for s in steps if isinstance(s, Scan) and s.index == delta), "")
        target = clause.head.name
        function = RuleFunction(
            name, emitter.lines, sorted(set(required)), emitter.relations | set(required), emitter.indexes,
            expressions.uses_state, delta_name, REJECTED if subsumes else "new" if staged else "full",
        )  # fmt: skip
        function.lines.insert(0, f"    #target {target}")
        self.functions.append(function)
        return Rule(name, target, str(clause.location), delta_name)

    # -- assembly -----------------------------------------------------------------------------------

    def new_slot(self, name: str) -> int:
        return len(self.relations) + 3 * self.storage.relation_slot[name]

    def assemble(self) -> None:
        """Fix the slots and write the module."""
        first = 4 * len(self.relations)
        for key in sorted(self.storage.lists | self.storage.sets):
            self.storage.index_slot[key] = first + len(self.storage.index_slot)
        self.code.slots = first + len(self.storage.index_slot)
        parts = [f"{name} = full_match({pattern!r})" for pattern, name in self.matchers.items()]
        for key in sorted(self.storage.index_slot):
            parts.append("\n".join(self.index_function(key)))
        parts.extend("\n".join(self.function_text(f)) for f in self.functions)
        self.code.source = "\n\n".join(parts) + "\n"

    def index_function(self, key: IndexKey) -> list[str]:
        """The function that adds rows to an index, and the one that builds it."""
        name, columns = key
        arity = self.storage.arity[name]
        cells = [f"c{i}" for i in range(arity)]
        value = row_of([f"row[{i}]" for i in columns])
        grow = f"add_{index_local(key)}"
        if key not in self.storage.lists:
            wide = [f"c{i}" if i in columns else "_" for i in range(arity)]
            each = f"{{{row_of([f'c{i}' for i in columns])} for {', '.join(wide)} in rows}}"
            return [
                f"def {grow}(index, rows):",
                f"    index |= {each}",
                f"def build_{index_local(key)}(rows):",
                f"    return {each}",
            ]
        if arity == 2:
            loop = f"    for {', '.join(cells)} in rows: index[c{columns[0]}].append(c{1 - columns[0]})"
        else:
            loop = f"    for row in rows: index[{value}].append(row)"
        return [
            f"def {grow}(index, rows):", loop, f"def build_{index_local(key)}(rows):", "    index = defaultdict(list)",
            f"    {grow}(index, rows)", "    return index",
        ]  # fmt: skip

    def function_text(self, function: RuleFunction) -> list[str]:
        """A rule function with its prologue: relations, early return, indexes."""
        target = function.lines.pop(0).split(" ", 5)[-1]
        slot = self.storage.relation_slot
        lines = [f"def {function.name}(D, S):"]
        if function.delta:
            lines.append(f"    delta = D[{self.new_slot(function.delta) + 1}]")
            lines.append("    if not delta: return")
        for name in sorted(function.relations | {k[0] for k in function.indexes}):
            lines.append(f"    {local(name)} = D[{slot[name]}]")
        if function.required:
            lines.append(f"    if not ({' and '.join(local(n) for n in function.required)}): return")
        for key in sorted(function.indexes):
            at = self.storage.index_slot[key]
            lines.append(f"    {index_local(key)} = D[{at}]")
            lines.append(f"    if {index_local(key)} is None: {index_local(key)} = D[{at}] = build_{index_local(key)}({local(key[0])})")
        lines.append(f"    full = D[{slot[target]}]")
        at = {"full": slot[target], "new": self.new_slot(target), REJECTED: self.new_slot(target) + 2}[function.target]
        lines.append(f"    add = D[{at}].add")
        return lines + function.lines

    def slots_of(self, name: str) -> tuple[int, ...]:
        """The slots of a relation and of its indexes."""
        indexes = (slot for key, slot in self.storage.index_slot.items() if key[0] == name)
        return (self.storage.relation_slot[name], *indexes)

    def member(self, name: str, subsumption: Sequence[Rule]) -> Member:
        indexes = tuple((slot, f"add_{index_local(key)}") for key, slot in self.storage.index_slot.items() if key[0] == name)
        relation = self.relations[name]
        columns = {a.name: i for i, a in enumerate(relation.attributes)}
        choices = tuple(tuple(columns[c] for c in choice) for choice in relation.choices)
        new = self.new_slot(name)
        return Member(name, self.storage.relation_slot[name], new, new + 1, indexes, choices, tuple(subsumption))


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


def compile_program(
    relations: Mapping[str, Relation], strata: Sequence[Sequence[str]], clauses: Mapping[str, Sequence[tuple[Clause, ClauseTypes]]],
    types: Types,
) -> Code:  # fmt: skip
    """Generate the code of a program whose clauses are grouped by head relation."""
    compiler = _Compiler(relations, types)
    number = 0
    planned: list[tuple[Sequence[str], list[Rule], list[Rule], dict[str, list[Rule]]]] = []
    for names in strata:
        base: list[Rule] = []
        loop: list[Rule] = []
        subsumption: dict[str, list[Rule]] = {}
        staged = any(relations[n].choices for n in names)
        for name in names:
            for clause, clause_types in clauses.get(name, ()):
                if compiler.fact(clause, clause_types):
                    continue
                number += 1
                once, again = compiler.rule(clause, clause_types, number, set(names), staged)
                base.extend(once)
                if clause.dominating is not None:
                    subsumption.setdefault(name, []).extend(again)
                else:
                    loop.extend(again)
        planned.append((names, base, loop, subsumption))
    compiler.assemble()
    reads = {f.name: f.relations | {key[0] for key in f.indexes} for f in compiler.functions}
    last_reader: dict[str, int] = {}
    for position, (names, base, loop, subsumption) in enumerate(planned):
        for rule in [*base, *loop, *(r for rules in subsumption.values() for r in rules)]:
            last_reader.update(dict.fromkeys(reads[rule.function], position))
        last_reader.update(dict.fromkeys(names, position))
    for position, (names, base, loop, subsumption) in enumerate(planned):
        members = tuple(compiler.member(n, subsumption.get(n, ())) for n in names)
        drops = tuple((name, compiler.slots_of(name)) for name, last in last_reader.items() if last == position)
        compiler.code.strata.append(Stratum(members, tuple(base), tuple(loop), drops))
    return compiler.code
