"""Programs of which only what their outputs ask for is derived.

Of a relation that is only ever asked for rows with certain values in certain columns, no rule is run over all rows: for each such set of
columns there is a table (`on_demand.py`), whose functions find the rows of one key when it is asked for. What has to be complete (outputs,
what a rule goes through from end to end, recursion through several relations) is derived stratum by stratum, as in any program.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from rosarch.datalog.engine.codegen import Emitter
from rosarch.datalog.engine.compile import Clauses, Compiler, Plan, assembled, effects, new_plan, normalised
from rosarch.datalog.engine.constant_rows import constant_rows
from rosarch.datalog.engine.expressions import Expressions
from rosarch.datalog.engine.plan import Code, Rule, Stratum, TablePlan
from rosarch.datalog.engine.storage import RowsNeeded, TableKey, row_of
from rosarch.datalog.language.ground import is_bound
from rosarch.datalog.language.inference import ClauseTypes
from rosarch.datalog.language.normalise import Scan, Step
from rosarch.datalog.language.strata import atoms_of, turned_around
from rosarch.datalog.language.syntax import Argument, Atom, Clause, Constraint, Relation, Variable, walk
from rosarch.datalog.language.types import Types

Unit = tuple[str, tuple[int, ...] | None]  # a relation, and the key columns of a table of it


def compile_on_demand(
    relations: Mapping[str, Relation], strata: Sequence[Sequence[str]], clauses: Clauses, types: Types, goals: Collection[str],
    inputs: Collection[str],
) -> Code:  # fmt: skip
    """Generate the code of a program for the rows of `goals`; facts are given of the relations `inputs` only."""
    program = _Program(relations, strata, clauses, types, constant_rows(relations, strata, clauses, types, inputs))
    demanded = program.demanded(goals)
    return program.code(goals, demanded)


class _Program:
    """The clauses of a program by relation, but for those whose rows are `constants`."""

    def __init__(
        self, relations: Mapping[str, Relation], strata: Sequence[Sequence[str]], clauses: Clauses, types: Types,
        constants: Mapping[str, list[Any]],
    ) -> None:  # fmt: skip
        self.relations = relations
        self.strata = strata
        self.clauses = {name: own for name, own in clauses.items() if name not in constants}
        self.types = types
        self.constants = constants
        self.stratum = {name: names for names in strata for name in names}
        self.ranks = {name: 6.0 if name in constants or not any(clause.body for clause, _ in own) else 3.0 for name, own in clauses.items()}
        self.mentioned = {name: {atom for clause, _ in own for atom in _mentioned(clause)} for name, own in self.clauses.items()}
        self.readers = turned_around({name: self.mentioned.get(name, ()) for name in relations})

    def candidates(self, goals: Collection[str]) -> set[str]:
        """The relations that can be derived on demand, as far as their own clauses show."""
        return {
            name
            for name, own in self.clauses.items()
            if name not in goals and len(self.stratum[name]) == 1 and any(clause.body for clause, _ in own)
            and not self.relations[name].choices and not self.relations[name].limit
            and self.relations[name].qualifiers.isdisjoint(("eqrel", "no_magic"))
            and not any(clause.dominating is not None or any(effects(clause)) for clause, _ in own)
        }  # fmt: skip

    def demanded(self, goals: Collection[str]) -> set[str]:
        """The relations that are only asked for single keys.

        Begins with all that can be, and takes those away that a rule turns out to go through.
        """
        demanded = self.candidates(goals)
        compiler = _Compiler(self, demanded)
        waiting = self.complete(goals)
        done: set[Unit] = set()
        while waiting:
            unit = waiting.pop()
            if unit in done or (unit[1] is None) == (unit[0] in demanded):
                continue
            try:
                waiting.extend(compiler.write(unit))
                done.add(unit)
            except RowsNeeded as needed:
                demanded.discard(needed.relation)
                again = {u for u in done if u[1] is None and self.readers[needed.relation].intersection(self.stratum[u[0]])}
                again |= {u for u in done if u[1] is not None and u[0] in self.readers[needed.relation]}
                done -= again
                waiting.extend((unit, *again, *self.complete([needed.relation])))
        return demanded

    def complete(self, names: Iterable[str]) -> list[Unit]:
        """What is to be written for relations of which all rows are derived."""
        return [(self.stratum[name][0], None) for name in names if self.clauses.get(name)]

    def code(self, goals: Collection[str], demanded: set[str]) -> Code:
        """The code, with rules for what is complete and tables for the rest."""
        compiler = _Compiler(self, demanded)
        waiting = self.complete(goals)
        done: set[Unit] = set()
        while waiting:
            unit = waiting.pop()
            if unit not in done:
                done.add(unit)
                waiting.extend(compiler.write(unit))
        wholes = {name: compiler.whole(name) for name in sorted({name for name, _ in compiler.storage.tables})}
        tables = (compiler.table_plans[key] for key in compiler.storage.tables)
        compiler.code.tables = tuple(replace(table, whole=wholes.get(table.relation)) for table in tables)
        return assembled(compiler, [compiler.plans[names[0]] for names in self.strata if names[0] in compiler.plans])


class _Compiler(Compiler):
    """Generates the functions of rules that ask tables, and those of tables."""

    def __init__(self, program: _Program, demanded: set[str]) -> None:
        super().__init__(program.relations, program.types)
        self.program = program
        self.code.facts = {name: rows for name, rows in program.constants.items() if rows}
        self.storage.demanded = demanded
        self.storage.ranks = program.ranks
        self.plans: dict[str, Plan] = {}  # by the first relation of the stratum
        self.table_plans: dict[TableKey, TablePlan] = {}
        self.numbers = {id(clause): i for i, clause in enumerate((c for own in program.clauses.values() for c, _ in own), 1)}

    def write(self, unit: Unit) -> list[Unit]:
        """Generate the functions of a table, or of a stratum that is complete; what these ask for in turn."""
        name, keys = unit
        if keys is None:
            names = self.program.stratum[name]
            plan = self.plans[name] = self.stratum_plan(names)
            rules = plan.rules()
        else:
            names = (name,)
            table = self.table_plans[name, keys] = self.table_plan(name, keys)
            rules = [*table.keyed_rules()]
        return self.asked(rules, names)

    def asked(self, rules: Iterable[Rule], names: Iterable[str]) -> list[Unit]:
        """What the rules of relations ask for."""
        known = list(self.storage.tables)
        asked: list[Unit] = [known[number] for rule in rules for number in rule.tables]
        read = {other for relation in names for other in self.program.mentioned.get(relation, ())}
        return asked + self.program.complete(read - self.storage.demanded)

    def stratum_plan(self, names: Sequence[str]) -> Plan:
        """The rules of a stratum of which all rows are derived."""
        own = [pair for name in names for pair in self.program.clauses.get(name, ())]
        plan = new_plan(self, names, [clause for clause, _ in own])
        if any(self.storage.demanded & self.program.mentioned.get(name, set()) for name in names):
            plan.bulk = None
        for clause, types in own:
            if not self.fact(clause, types):
                self.add(clause, types, self.numbers[id(clause)], plan)
        return plan

    def whole(self, name: str) -> Stratum | None:
        """The rules that derive all rows of a relation of which there are tables; None when that takes all rows of others."""
        known, demanded = dict(self.storage.tables), self.storage.demanded
        self.storage.demanded = demanded - {name}
        try:
            plan = self.stratum_plan((name,))
            self.storage.demanded = demanded
            waiting = self.asked(plan.rules(), (name,))
            while waiting:
                unit = waiting.pop()
                if unit[1] is None and unit[0] not in self.plans and unit[0] != name:
                    raise RowsNeeded(unit[0])
                if unit[1] is not None and (unit[0], unit[1]) not in self.table_plans:
                    waiting.extend(self.write(unit))
        except RowsNeeded:
            self.storage.tables = known
            self.table_plans = {key: table for key, table in self.table_plans.items() if key in known}
            return None
        finally:
            self.storage.demanded = demanded
        return self.stratum(plan)

    # -- tables -------------------------------------------------------------------------------------

    def table_plan(self, name: str, keys: tuple[int, ...]) -> TablePlan:
        """The functions that find the rows of a key."""
        base: list[Rule] = []
        loop: list[Rule] = []
        own = self.program.clauses[name]
        recursive = any(name in _mentioned(clause) for clause, _ in own)
        loops = recursive and all(_keeps_key(clause, keys) for clause, _ in own)
        if recursive and not loops and not (keys == (0,) and all(_descends(clause) for clause, _ in own)):
            raise RowsNeeded(name)
        for clause, types in own:
            loops_here = loops and name in _mentioned(clause)
            (loop if loops_here else base).append(self.table_rule(clause, types, (name, keys), loop=loops_here))
        return TablePlan(name, self.storage.arity[name], keys, tuple(base), recursive and not loops, tuple(loop))

    def table_rule(self, clause: Clause, types: ClauseTypes, table: TableKey, *, loop: bool) -> Rule:
        """The function that finds, for a key, what one clause derives; in a loop, from rows of the same key that are new."""
        form = normalised(clause, types)
        steps: list[Step] = list(form.steps)
        delta = next(s.index for s in steps if isinstance(s, Scan) and s.atom.name == table[0]) if loop else None
        expressions = Expressions(self.types, types, self.matchers, interned=True)
        emitter = Emitter(self.storage, expressions, ordered=False, delta=delta, growing=(), own=table)
        bound: dict[str, str] = {}
        names: list[str] = []
        for column in table[1]:
            term = form.head.args[column]
            if not isinstance(term, Variable) or term.name in bound:
                fresh = form.normaliser.variable(term)
                steps.append(Constraint("=", fresh, term, term.location))
                term = fresh
            bound[term.name] = emitter.python_name(term.name, bound)
            names.append(bound[term.name])
        free = [arg for i, arg in enumerate(form.head.args) if i not in table[1]]
        value: Sequence[Argument] = form.head.args if len(free) > 1 else free
        guard: list[int] = []

        def row(now: Mapping[str, str]) -> str:
            return row_of([expressions.write(a, now) for a in value])

        def checkpoint(now: dict[str, str]) -> bool:
            """Skip the remaining loops when the row is already there; true once emitted."""
            if not all(is_bound(a, set(now)) for a in value):
                return False
            emitter.fail_if(f"{row(now)} in found")
            guard.append(emitter.loops)
            return True

        def finish(now: dict[str, str]) -> None:
            emitter.line(f"add({row(now)})")
            if not emitter.functions and (guard or not free):
                if not free:
                    emitter.line("return")
                elif emitter.loops > guard[0]:
                    emitter.line("break")

        wanted = {n.name for a in form.head.args for n in walk(a) if isinstance(n, Variable)}
        emitter.body(steps, bound, wanted, finish, bag=False, checkpoint=checkpoint)
        keyed = "_".join(map(str, table[1]))
        name = f"table_{self.numbers[id(clause)]}_{keyed}"
        arguments = ", ".join(["S", "own", *emitter.arguments(), "key", *(["delta"] if loop else []), "found"])
        unpacked = f"    {', '.join(names)} = key"
        self.functions[name] = "\n".join([f"def {name}({arguments}):", unpacked, "    add = found.add", *emitter.lines])
        return self.described(name, clause, form.steps, delta, "", emitter)


def _mentioned(clause: Clause) -> set[str]:
    """The relations that a clause reads."""
    nodes = (*clause.head.args, *clause.body)
    return {atom.name for node in nodes for atom, _ in atoms_of(node)}


def _keeps_key(clause: Clause, keys: tuple[int, ...]) -> bool:
    """Whether a clause, if it is recursive, asks once, for rows with the key of its own."""
    name = clause.head.name
    own = [literal for literal in clause.body if isinstance(literal, Atom) and literal.name == name]
    if not own:
        return name not in _mentioned(clause)
    same = _same([clause.head.args[k] for k in keys], [own[0].args[k] for k in keys])
    return same and len(own) == 1 and sum(atom.name == name for node in clause.body for atom, _ in atoms_of(node)) == 1


def _descends(clause: Clause) -> bool:
    """Whether a clause, if it is recursive, goes from what its head is about to an attribute of that, as one goes down a tree."""
    name, subject = clause.head.name, clause.head.args[0]
    if name not in _mentioned(clause):
        return True
    atoms = [literal for literal in clause.body if isinstance(literal, Atom)]
    own = [atom for atom in atoms if atom.name == name]
    attributes = [arg for atom in atoms if atom.name != name and _same(atom.args[:1], [subject]) for arg in atom.args[1:]]
    return bool(own) and all(any(_same([atom.args[0]], [arg]) for arg in attributes) for atom in own)


def _same(left: Sequence[Argument], right: Sequence[Argument]) -> bool:
    """Whether both are the same variables."""
    return len(left) == len(right) and all(
        isinstance(a, Variable) and isinstance(b, Variable) and a.name == b.name for a, b in zip(left, right, strict=True)
    )
