"""Copies of clauses with parts replaced."""

from __future__ import annotations

from collections.abc import Mapping

from rosarch.datalog.language.syntax import (
    Aggregate,
    Argument,
    Atom,
    Branch,
    Cast,
    Clause,
    Constraint,
    Functor,
    Literal,
    Negation,
    Record,
    Truth,
    UserFunctor,
    Variable,
)  # fmt: skip


class Rewriter:
    """Rebuilds clauses, literals and terms; subclasses replace names, variables or aggregates."""

    def name(self, name: str) -> str:
        """The relation that stands for `name`."""
        return name

    def type_name(self, name: str) -> str:
        """The type or branch that stands for `name`."""
        return name

    def variable(self, term: Variable) -> Argument:
        """What stands for a variable."""
        return term

    def aggregate(self, term: Aggregate) -> Argument:
        """What stands for an aggregate."""
        target = None if term.target is None else self.term(term.target)
        return Aggregate(term.op, target, tuple(self.literal(x) for x in term.body), term.location)

    def clause(self, clause: Clause) -> Clause:
        """A copy of a clause."""
        dominating = None if clause.dominating is None else self.atom(clause.dominating)
        body = tuple(self.literal(x) for x in clause.body)
        return Clause(self.atom(clause.head), body, clause.location, dominating, clause.plan)

    def atom(self, atom: Atom) -> Atom:
        """A copy of an atom."""
        return Atom(self.name(atom.name), self.terms(atom.args), atom.location)

    def literal(self, literal: Literal) -> Literal:
        """A copy of a literal."""
        match literal:
            case Atom():
                return self.atom(literal)
            case Negation():
                return Negation(self.atom(literal.atom), literal.location)
            case Constraint():
                return Constraint(literal.op, self.term(literal.left), self.term(literal.right), literal.location)
            case Truth():
                return literal

    def terms(self, terms: tuple[Argument, ...]) -> tuple[Argument, ...]:
        """Copies of terms."""
        return tuple(self.term(t) for t in terms)

    def term(self, term: Argument) -> Argument:
        """A copy of a term."""
        match term:
            case Variable():
                return self.variable(term)
            case Record():
                return Record(self.terms(term.args), term.location)
            case Branch():
                return Branch(self.type_name(term.name), self.terms(term.args), term.location)
            case Functor():
                return Functor(term.op, self.terms(term.args), term.location)
            case UserFunctor():
                return UserFunctor(term.name, self.terms(term.args), term.location)
            case Cast():
                return Cast(self.term(term.arg), self.type_name(term.type), term.location)
            case Aggregate():
                return self.aggregate(term)
            case _:
                return term


class Substitution(Rewriter):
    """Replaces variables by terms, and one aggregate by another term."""

    def __init__(self, terms: Mapping[str, Argument], aggregate: Aggregate | None = None, by: Argument | None = None) -> None:
        self.replacement = terms
        self.replaced = aggregate
        self.by = by

    def variable(self, term: Variable) -> Argument:
        """The term for a variable."""
        return self.replacement.get(term.name, term)

    def aggregate(self, term: Aggregate) -> Argument:
        """The term for the aggregate."""
        return self.by if term is self.replaced and self.by is not None else super().aggregate(term)
