"""Semantic checks: names, arities, types, groundedness, stratification (souffle's SemanticChecker, TypeChecker)."""

from __future__ import annotations

from collections import Counter as Tally
from collections.abc import Mapping
from dataclasses import dataclass

from rosarch.datalog.engine.expressions import number_value
from rosarch.datalog.files.inputs import check_directive
from rosarch.datalog.language.errors import Location, Report, did_you_mean
from rosarch.datalog.language.functors import FUNCTORS
from rosarch.datalog.language.ground import unbound_in_clause
from rosarch.datalog.language.inference import ClauseTypes, Inference, kind_of
from rosarch.datalog.language.strata import atoms_of, check_stratified, components, dependencies
from rosarch.datalog.language.syntax import (
    Argument,
    Atom,
    Branch,
    Cast,
    Clause,
    Constraint,
    Counter,
    Functor,
    Literal,
    Nil,
    Number,
    Record,
    Relation,
    String,
    Unit,
    Unnamed,
    UserFunctor,
    Variable,
    clause_literals,
    walk,
)  # fmt: skip
from rosarch.datalog.language.types import Types, build_types

CHOICE = "choice-domain"


@dataclass(slots=True)
class CheckResult:
    """A program that passed every check."""

    unit: Unit
    types: Types
    relations: dict[str, Relation]
    strata: list[list[str]]
    clauses: dict[str, list[tuple[Clause, ClauseTypes]]]


def check(unit: Unit, report: Report, bits: int = 32) -> CheckResult:
    """Run every check; raises DatalogError with all errors found. `bits` is the width of numbers."""
    types = build_types(unit.types, report, bits)
    relations = _check_relations(unit, types, report)
    _check_directives(unit, relations, report)
    before = len(report.errors)
    _check_functors(unit, types, report)
    if len(report.errors) > before:
        report.raise_errors()
    usable = [c for c in unit.clauses if _check_names(c, relations, types, unit, report)]
    functors = {f.name: (f.params, f.result) for f in unit.functors}
    grouped: dict[str, list[tuple[Clause, ClauseTypes]]] = {}
    inference = Inference(types, relations, functors)
    for clause in usable:
        _check_ground(clause, relations, report)
        _check_singletons(clause, report)
        found = inference.run(clause)
        ClauseChecker(clause, found, types, relations, report).run()
        grouped.setdefault(clause.head.name, []).append((clause, found))
    graph = dependencies(relations, usable)
    strata = components(graph.reads)
    check_stratified(graph, strata, report)
    _check_counters(usable, strata, report)
    _check_plans(usable, strata, report)
    report.raise_errors()
    return CheckResult(unit, types, relations, strata, grouped)


def _check_relations(unit: Unit, types: Types, report: Report) -> dict[str, Relation]:
    relations: dict[str, Relation] = {}
    for relation in unit.relations:
        if relation.name in relations:
            first = relations[relation.name].location
            report.error(f"relation `{relation.name}` is already declared at {first}", relation.location)
            continue
        relations[relation.name] = relation
        seen: set[str] = set()
        for attribute in relation.attributes:
            if not types.exists(attribute.type) and not any(t.name == attribute.type for t in unit.types):
                hint = did_you_mean(attribute.type, [n for n in (*types.table, *types.aliases) if n[0] != "@"])
                report.error(f"unknown type `{attribute.type}`", attribute.location, hint)
            if attribute.name in seen:
                report.error(f"attribute `{attribute.name}` is declared twice", attribute.location)
            seen.add(attribute.name)
        for key in (k for choice in relation.choices for k in choice):
            if key not in seen:
                report.error(f"unknown attribute `{key}` in {CHOICE}", relation.location, did_you_mean(key, seen))
        if "eqrel" in relation.qualifiers and len(relation.attributes) != 2:
            report.error(f"equivalence relation `{relation.name}` is not binary", relation.location)
    return relations


def _check_functors(unit: Unit, types: Types, report: Report) -> None:
    seen: dict[str, Location] = {}
    for functor in unit.functors:
        if seen.setdefault(functor.name, functor.location) is not functor.location:
            report.error(f"functor `{functor.name}` is already declared at {seen[functor.name]}", functor.location)
        for name in (*functor.params, functor.result):
            if not types.exists(name):
                hint = did_you_mean(name, [n for n in (*types.table, *types.aliases) if n[0] != "@"])
                report.error(f"unknown type `{name}`", functor.location, hint)


def _check_directives(unit: Unit, relations: Mapping[str, Relation], report: Report) -> None:
    seen: dict[tuple[str, str], Location] = {}
    for directive in unit.directives:
        first = seen.setdefault((directive.kind, directive.relation), directive.location)
        if first is not directive.location and directive.kind in ("printsize", "limitsize"):
            report.error(f"`.{directive.kind}` of `{directive.relation}` is already given at {first}", directive.location)
        if directive.relation in relations and "inline" in relations[directive.relation].qualifiers and directive.kind != "limitsize":
            report.error(f"`{directive.relation}` is inline and has no rows to read or write", directive.location)
        if directive.relation not in relations:
            _unknown_relation(directive.relation, directive.location, relations, report)
        check_directive(directive, directive.location, report)
        if directive.kind == "limitsize" and not dict(directive.params).get("n", "").isdigit():
            report.error("`.limitsize` needs a number of rows, as in `(n=100)`", directive.location)


def _unknown_relation(name: str, location: Location, relations: Mapping[str, Relation], report: Report) -> None:
    report.error(f"unknown relation `{name}`", location, did_you_mean(name, relations))


def _check_names(clause: Clause, relations: Mapping[str, Relation], types: Types, unit: Unit, report: Report) -> bool:
    """Relations exist and have the given number of attributes; false when the clause cannot be checked further."""
    before = report.refused
    functors = {f.name: f for f in unit.functors}
    for literal in clause_literals(clause):
        for node in walk(literal):
            match node:
                case Atom():
                    _check_atom(node, relations, report)
                case Branch() if node.name not in types.branch_owner:
                    report.error(f"unknown branch `{node.name}`", node.location, did_you_mean(node.name, types.branch_owner))
                case Cast() if not types.exists(node.type):
                    known = [n for n in (*types.table, *types.aliases) if n[0] != "@"]
                    report.error(f"unknown type `{node.type}`", node.location, did_you_mean(node.type, known))
                case UserFunctor() if node.name not in functors:
                    report.error(f"unknown functor `@{node.name}`", node.location, did_you_mean(node.name, functors))
    for node in clause.head.args:
        if isinstance(node, Unnamed):
            report.error("`_` in the head of a clause", node.location)
    return report.refused == before


def _check_atom(atom: Atom, relations: Mapping[str, Relation], report: Report) -> None:
    relation = relations.get(atom.name)
    if relation is None:
        _unknown_relation(atom.name, atom.location, relations, report)
    elif len(relation.attributes) != len(atom.args):
        expected, given = len(relation.attributes), len(atom.args)
        names = ", ".join(a.name for a in relation.attributes)
        message = f"`{atom.name}` has {expected} attribute{'s' * (expected != 1)}, given {given}"
        report.error(message, atom.location, f"declared `{atom.name}({names})`")


def _check_ground(clause: Clause, relations: Mapping[str, Relation], report: Report) -> None:
    inline = "inline" in relations[clause.head.name].qualifiers
    seen: set[str] = set()
    for variable, where in unbound_in_clause(clause, inline):
        name = variable.name if isinstance(variable, Variable) else "_"
        if name not in seen:
            seen.add(name)
            place = f" {where}" if where else ""
            report.error(f"ungrounded variable `{name}`{place}", variable.location)


def _check_singletons(clause: Clause, report: Report) -> None:
    tally: Tally[str] = Tally()
    first: dict[str, Variable] = {}
    for literal in clause_literals(clause):
        for node in walk(literal):
            if isinstance(node, Variable):
                tally[node.name] += 1
                first.setdefault(node.name, node)
    for name, count in tally.items():
        if count == 1 and not name.startswith("_"):
            report.warning(f"variable `{name}` occurs only once", first[name].location, f"write `_` or `_{name}`")


def _check_counters(clauses: list[Clause], strata: list[list[str]], report: Report) -> None:
    """A counter in a recursive rule would make new rows forever."""
    stratum_of = {name: i for i, names in enumerate(strata) for name in names}
    for clause in clauses:
        counters = [n for literal in clause_literals(clause) for n in walk(literal) if isinstance(n, Counter)]
        reads = {stratum_of[a.name] for literal in clause.body for a, _ in atoms_of(literal)}
        if counters and stratum_of[clause.head.name] in reads:
            report.error("`autoinc()` in a recursive rule", counters[0].location)


def _check_plans(clauses: list[Clause], strata: list[list[str]], report: Report) -> None:
    """A plan orders all atoms, for a version of a recursive rule. It is a hint, which the embedded engine does not need."""
    stratum_of = {name: i for i, names in enumerate(strata) for name in names}
    for clause in clauses:
        if not clause.plan:
            continue
        atoms = [a for a in clause.body if isinstance(a, Atom)]
        recursive = sum(stratum_of[a.name] == stratum_of[clause.head.name] for a in atoms)
        extra = 0 if clause.dominating is None else 2  # the rows that are compared
        if not recursive and not extra:
            report.error("a plan for a rule that is not recursive", clause.location)
        for version, order in clause.plan:
            if sorted(order) != list(range(1, len(atoms) + extra + 1)):
                report.error(f"plan {version} is not an order of the {len(atoms) + extra} atoms of this rule", clause.location)
            elif version >= max(recursive + extra, 1):
                report.error(f"plan {version} of a rule with {recursive + extra} versions, which count from 0", clause.location)


class ClauseChecker:
    """Compares the inferred types of one clause with what its relations and functors accept."""

    def __init__(self, clause: Clause, found: ClauseTypes, types: Types, relations: Mapping[str, Relation], report: Report) -> None:
        self.clause = clause
        self.inferred = found
        self.types = types
        self.relations = relations
        self.report = report
        self.failed: set[str] = set()

    def run(self) -> None:
        """Report every error of the clause."""
        before = self.report.refused
        literals = clause_literals(self.clause)
        for literal in literals:
            for node in walk(literal):
                self._node(node)
        if self.report.refused == before:  # else variables without a type are a consequence
            for literal in literals:
                for node in walk(literal):
                    if isinstance(node, Variable):
                        self._variable(node)
        for literal in literals:
            self._literal(literal)

    def _literal(self, literal: Literal) -> None:
        for atom, strict in atoms_of(literal):
            self._atom(atom, negated=strict == "negation")

    def _node(self, node: Argument | Literal) -> None:
        match node:
            case String():
                self._constant(node, "s", "symbol")
            case Number():
                self._number(node)
            case Nil():
                self._constant(node, "r", "nil")
            case Record():
                self._record(node)
            case Branch():
                self._branch(node)
            case Functor():
                self._functor(node)
            case Constraint():
                self._comparison(node)

    def _variable(self, node: Variable) -> None:
        if self.inferred.of(node) == frozenset() and node.name not in self.failed:
            self.failed.add(node.name)
            self.report.error(f"no type fits variable `{node.name}`", node.location, self._uses(node.name))

    def _uses(self, variable: str) -> str:
        """The declared types that clash on a variable."""
        uses: dict[str, None] = {}
        for literal in clause_literals(self.clause):
            for node in walk(literal):
                if isinstance(node, Atom):
                    relation = self.relations[node.name]
                    for attribute, arg in zip(relation.attributes, node.args, strict=True):
                        if isinstance(arg, Variable) and arg.name == variable and node is not self.clause.head:
                            uses[f"`{attribute.type}` in `{node.name}`"] = None
        return " but ".join(list(uses)[:3]) if len(uses) > 1 else ""

    def _show(self, found: frozenset[str] | None) -> str:
        return " | ".join(sorted(t.lstrip("@") for t in found or ()))

    def _atom(self, atom: Atom, negated: bool) -> None:
        relation = self.relations[atom.name]
        for attribute, arg in zip(relation.attributes, atom.args, strict=True):
            found = self.inferred.of(arg)
            if not found or not self.types.exists(attribute.type):
                continue
            declared = self.types.resolve(attribute.type)
            accept = self._accepts_negated if negated else self._accepts
            if not all(accept(t, declared) for t in found):
                what = f"variable `{arg.name}`" if isinstance(arg, Variable) else "argument"
                message = f"{what} is of type `{self._show(found)}`, but `{atom.name}.{attribute.name}` is of type `{attribute.type}`"
                self.report.error(message, arg.location)

    def _accepts(self, found: str, declared: str) -> bool:
        if self.types.is_subtype(found, declared):
            return True
        if not self.types.is_subtype(declared, found):
            return False
        return found.startswith("@") or self.types.get(found).kind == "r"

    def _accepts_negated(self, found: str, declared: str) -> bool:
        if found == declared:
            return True
        kind = self.types.kind(found)
        return kind == self.types.kind(declared) and (kind not in "r+" or self.types.is_subtype(found, declared))

    def _constant(self, node: String | Nil, kind: str, what: str) -> None:
        found = self.inferred.of(node)
        if not found or any(self.types.kind(t) != kind for t in found):
            context = self._show(found) if found else self._context(node)
            self.report.error(f"{what} constant where {context or 'another type'} is expected", node.location)

    def _number(self, node: Number) -> None:
        found = self.inferred.of(node)
        if not found:
            self.report.error(f"numeric constant where {self._context(node) or 'another type'} is expected", node.location)
            return
        kind = kind_of(found, self.types)
        try:
            number_value(node.text, kind, self.types.bits)
        except ValueError:
            what = {"i": "number", "u": "unsigned", "f": "float"}[kind]
            self.report.error(f"constant `{node.text}` is not a valid {what}", node.location)

    def _context(self, node: Argument) -> str:
        """The declared type of the place a constant is in."""
        for literal in clause_literals(self.clause):
            for parent in walk(literal):
                if isinstance(parent, Atom) and any(a is node for a in parent.args):
                    relation = self.relations[parent.name]
                    position = next(i for i, a in enumerate(parent.args) if a is node)
                    attribute = relation.attributes[position]
                    return f"`{attribute.type}` (`{parent.name}.{attribute.name}`)"
                if isinstance(parent, Constraint) and (parent.left is node or parent.right is node):
                    other = self.inferred.of(parent.right if parent.left is node else parent.left)
                    return f"`{self._show(other)}`" if other else ""
        return ""

    def _record(self, node: Record) -> None:
        found = self.inferred.of(node)
        if not found or len(found) != 1 or any(self.types.kind(t) != "r" for t in found):
            self.report.error(
                "the type of this record is ambiguous" if found is None or len(found) > 1 else "record where another type is expected",
                node.location,
            )
            return
        fields = self.types.root(next(iter(found))).fields
        if len(fields) != len(node.args):
            self.report.error(f"record has {len(fields)} field{'s' * (len(fields) != 1)}, given {len(node.args)}", node.location)

    def _branch(self, node: Branch) -> None:
        owner = self.types.branch_owner[node.name]
        fields = dict(self.types.get(owner).branches)[node.name]
        if len(fields) != len(node.args):
            self.report.error(
                f"branch `{node.name}` has {len(fields)} field{'s' * (len(fields) != 1)}, given {len(node.args)}",
                node.location,
            )
            return
        if self.inferred.of(node) == frozenset():
            self.report.error(f"branch of `{owner}` where another type is expected", node.location)
        for arg, declared in zip(node.args, fields, strict=True):
            found = self.inferred.of(arg)
            if found and self.types.exists(declared) and not all(self._accepts(t, self.types.resolve(declared)) for t in found):
                self.report.error(
                    f"argument is of type `{self._show(found)}`, but the field of `{node.name}` is of type `{declared}`",
                    arg.location,
                )

    def _functor(self, node: Functor) -> None:
        if self.inferred.overloads.get(id(node)):
            return
        known = FUNCTORS.get(node.op, ())
        if not any(o.accepts(len(node.args)) for o in known):
            self.report.error(f"`{node.op}` does not take {len(node.args)} argument{'s' * (len(node.args) != 1)}", node.location)
        else:
            given = ", ".join(self._show(self.inferred.of(a)) or self._literal_kind(a) for a in node.args)
            self.report.error(f"`{node.op}` is not defined for ({given})", node.location)

    def _literal_kind(self, node: Argument) -> str:
        """The type of an operand by its spelling or, for a variable, by the first atom that binds it."""
        if isinstance(node, Variable):
            for literal in self.clause.body:
                if isinstance(literal, Atom):
                    for attribute, arg in zip(self.relations[literal.name].attributes, literal.args, strict=True):
                        if isinstance(arg, Variable) and arg.name == node.name:
                            return attribute.type
        return "symbol" if isinstance(node, String) else "number" if isinstance(node, Number) else "?"

    def _comparison(self, node: Constraint) -> None:
        if node.op in ("<", "<=", ">", ">="):
            for side in (node.left, node.right):
                found = self.inferred.of(side)
                if found and any(self.types.kind(t) in "r+" for t in found):
                    self.report.error(f"`{node.op}` is not defined for `{self._show(found)}`", side.location)
                    return
