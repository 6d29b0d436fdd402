"""Relations qualified `inline`, replaced by their clauses where that matters (souffle's InlineRelations.cpp).

Most of them are evaluated like any relation: the rows are the same, and explanations can name them. Two kinds cannot be:
those whose clauses leave an attribute to the place of use (`plus(x, y, z) :- z = x + y.`), and those that multiply relations
(`pair(x, y) :- a(x), b(y).`), which may have too many rows.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from rosarch.datalog.language.errors import Report
from rosarch.datalog.language.ground import grounded_variables
from rosarch.datalog.language.rewrite import Rewriter, Substitution
from rosarch.datalog.language.syntax import (
    Aggregate,
    Argument,
    Atom,
    Clause,
    Constraint,
    Literal,
    Negation,
    Nil,
    Number,
    Relation,
    String,
    Truth,
    Unnamed,
    Variable,
    clause_literals,
    variables,
    walk,
)  # fmt: skip

MAX_CLAUSES = 10_000
_NEGATED = {"=": "!=", "!=": "=", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}


def inlined_relations(relations: Iterable[Relation], clauses: Sequence[Clause]) -> set[str]:
    """The relations that have to be inlined."""
    marked = {r.name for r in relations if "inline" in r.qualifiers}
    if not marked:
        return set()
    by_head = _definitions(marked, clauses)
    hidden = {a.name for c in clauses for a in _hidden_atoms(c)}
    found = {name for name, own in by_head.items() if any(_open(c) or (name not in hidden and _multiplies(c)) for c in own)}
    while True:
        readers = {n for n, own in by_head.items() if any(a.name in found for c in own for a in _atoms(c))} - found
        if not readers:
            return found
        found |= readers


def _atoms(clause: Clause) -> Iterator[Atom]:
    return (n for literal in clause.body for n in walk(literal) if isinstance(n, Atom))


def _hidden_atoms(clause: Clause) -> Iterator[Atom]:
    """The atoms of a clause below negations and aggregates."""
    for literal in clause_literals(clause):
        yield from (n for n in walk(literal) if isinstance(n, Atom) and n is not literal)


def _open(clause: Clause) -> bool:
    """Whether a clause does not bind all attributes of its head."""
    return bool({v for a in clause.head.args for v in variables(a)} - grounded_variables(clause.body))


def _multiplies(clause: Clause) -> bool:
    """Whether the body has atoms that share no variable, not even by way of other literals."""
    groups: list[set[str]] = []
    for literal in clause.body:
        names = variables(literal)
        joined = [g for g in groups if g & names]
        groups = [g for g in groups if not g & names] + [names.union(*joined)]
    atoms = [variables(literal) for literal in clause.body if isinstance(literal, Atom) and literal.args]
    return sum(any(a & g for a in atoms) for g in groups) > 1


def _definitions(names: Iterable[str], clauses: Sequence[Clause]) -> dict[str, list[Clause]]:
    found: dict[str, list[Clause]] = {name: [] for name in names}
    for clause in clauses:
        if clause.head.name in found:
            found[clause.head.name].append(clause)
    return found


def check_cycles(relations: Iterable[Relation], clauses: Sequence[Clause], report: Report) -> None:
    """Report relations marked `inline` that would be inlined into themselves."""
    definitions = _definitions([r.name for r in relations if "inline" in r.qualifiers], clauses)
    reads = {n: {a.name for c in own for a in _atoms(c) if a.name in definitions} for n, own in definitions.items()}
    for _ in definitions:
        reads = {n: found.union(*(reads[m] for m in found)) for n, found in reads.items()}
    for name in sorted(n for n, found in reads.items() if n in found):
        report.error(f"relation `{name}` cannot be inlined: it is recursive", definitions[name][0].location)


def inline_clauses(names: set[str], clauses: Sequence[Clause], report: Report) -> list[Clause]:
    """The clauses of all other relations, with atoms of the named ones replaced."""
    return _Inliner(names, clauses, report).run()


class _Inliner:
    def __init__(self, names: set[str], clauses: Sequence[Clause], report: Report) -> None:
        self.names = names
        self.clauses = clauses
        self.report = report
        self.copies = itertools.count()
        self.definitions = _definitions(names, clauses)

    def run(self) -> list[Clause]:
        result: list[Clause] = []
        for clause in self.clauses:
            if clause.head.name in self.names:
                continue
            if not any(isinstance(n, Atom) and n.name in self.names for literal in clause_literals(clause) for n in walk(literal)):
                result.append(clause)
                continue
            bodies = self._bodies(clause.body, clause)
            head = _AggregateRewriter(self).atom(clause.head)
            result.extend(replace(clause, head=head, body=body, plan=()) for body in bodies)
        return result

    def _bodies(self, body: Sequence[Literal], clause: Clause) -> list[tuple[Literal, ...]]:
        """The alternatives that a body stands for."""
        alternatives: list[tuple[Literal, ...]] = [()]
        for literal in body:
            parts = self._alternatives(literal, clause)
            if len(alternatives) * len(parts) > MAX_CLAUSES:
                self.report.error(f"inlining makes more than {MAX_CLAUSES} clauses of this one", clause.location)
                return []
            alternatives = [one + part for one in alternatives for part in parts]
        return alternatives

    def _alternatives(self, literal: Literal, clause: Clause) -> list[tuple[Literal, ...]]:
        match literal:
            case Atom() if literal.name in self.names:
                found: list[tuple[Literal, ...]] = []
                for definition in self.definitions[literal.name]:
                    found.extend(self._bodies(self._unfolded(literal, definition, negated=False), clause))
                return found
            case Negation() if literal.atom.name in self.names:
                conjunction: list[tuple[Literal, ...]] = [()]
                for definition in self.definitions[literal.atom.name]:
                    parts = [self._negated(part) for part in self._unfolded(literal.atom, definition, negated=True)]
                    conjunction = [(*one, part) for one in conjunction for part in parts]
                    if len(conjunction) > MAX_CLAUSES:
                        self.report.error(f"inlining makes more than {MAX_CLAUSES} clauses of this one", clause.location)
                        return []
                return [body for part in conjunction for body in self._bodies(part, clause)]
            case _:
                return [(_AggregateRewriter(self).literal(literal),)]

    def _unfolded(self, atom: Atom, definition: Clause, *, negated: bool) -> list[Literal]:
        """The body of a definition with the arguments of an atom in place of the attributes."""
        number = next(self.copies)
        own = {v for literal in clause_literals(definition) for v in variables(literal)}
        terms: dict[str, Argument] = {}
        extra: list[tuple[Argument, Argument]] = []
        for parameter, given in zip(definition.head.args, atom.args, strict=True):
            if isinstance(parameter, Variable) and parameter.name not in terms and isinstance(given, (Variable, Number, String, Nil)):
                terms[parameter.name] = given
            elif not isinstance(given, Unnamed):
                extra.append((parameter, given))
        local = {v: Variable(f"{v}+i{number}", atom.location) for v in own - terms.keys()}
        if negated:
            self._check_negated(atom, definition, [(p, g) for p, g in extra if not (isinstance(p, Variable) and p.name in terms)])
        rename = Substitution({**local, **terms})
        equations = [Constraint("=", rename.term(p), g, atom.location) for p, g in extra]
        return [*equations, *(rename.literal(x) for x in definition.body)]

    def _check_negated(self, atom: Atom, definition: Clause, extra: Sequence[tuple[Argument, Argument]]) -> None:
        """A negated relation may have no variables of its own: they would have to be bound by a negation."""
        bound = {v for a in definition.head.args for v in variables(a)}
        loose = {v for literal in definition.body for v in variables(literal)} - bound
        if loose or any(isinstance(p, Variable) for p, _ in extra) or any(isinstance(a, Unnamed) for a in atom.args):
            message = f"relation `{atom.name}` is inlined here, and its negation would leave variables without a value"
            self.report.error(message, atom.location)

    @staticmethod
    def _negated(literal: Literal) -> Literal:
        match literal:
            case Atom():
                return Negation(literal, literal.location)
            case Negation():
                return literal.atom
            case Constraint():
                op = _NEGATED.get(literal.op) or (literal.op[1:] if literal.op[0] == "!" else f"!{literal.op}")
                return replace(literal, op=op)
            case Truth():
                return Truth(not literal.value, literal.location)


class _AggregateRewriter(Rewriter):
    """Inlines relations in the bodies of aggregates."""

    def __init__(self, inliner: _Inliner) -> None:
        self.inliner = inliner

    def aggregate(self, term: Aggregate) -> Argument:
        """The aggregate over an unfolded body."""
        target = None if term.target is None else self.term(term.target)
        clause = Clause(Atom("", (), term.location), term.body, term.location)
        bodies = self.inliner._bodies(term.body, clause)
        if len(bodies) == 1:
            return Aggregate(term.op, target, bodies[0], term.location)
        self.inliner.report.error("a relation with several clauses cannot be inlined in an aggregate", term.location)
        return Aggregate(term.op, target, (), term.location)
