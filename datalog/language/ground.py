"""Groundedness: which variables of a clause are bound by its body (souffle's Ground.cpp)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

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
    Unnamed,
    UserFunctor,
    Variable,
    children,
)  # fmt: skip


def grounded_variables(body: Iterable[Literal], given: Iterable[str] = ()) -> set[str]:
    """The variables bound by positive atoms, and by equalities with terms that are bound.

    Aggregates count as bound: their own variables are a matter of their own body.
    """
    bound = set(given)
    equalities: list[Constraint] = []
    for literal in body:
        if isinstance(literal, Atom):
            for arg in literal.args:
                _bind(arg, bound)
        elif isinstance(literal, Constraint) and literal.op == "=":
            equalities.append(literal)
    changed = True
    while changed:
        before = len(bound)
        for equality in equalities:
            _equate(equality.left, equality.right, bound)
            _equate(equality.right, equality.left, bound)
        changed = len(bound) != before
    return bound


def _equate(source: Argument, target: Argument, bound: set[str]) -> None:
    if is_bound(source, bound):
        _bind(target, bound)
    elif isinstance(source, (Record, Branch)) and isinstance(target, (Record, Branch)):
        for a, b in zip(source.args, target.args, strict=False):
            _equate(a, b, bound)


def _bind(term: Argument, bound: set[str]) -> None:
    """A term known to have a value binds the variables that can be read off it."""
    if isinstance(term, Variable):
        bound.add(term.name)
    elif isinstance(term, (Record, Branch)):
        for arg in term.args:
            _bind(arg, bound)


def is_bound(term: Argument, bound: set[str]) -> bool:
    """Whether the value of a term follows from the bound variables."""
    match term:
        case Variable():
            return term.name in bound
        case Unnamed():
            return False
        case Record() | Branch() | Functor() | UserFunctor():
            return all(is_bound(a, bound) for a in term.args)
        case Cast():
            return is_bound(term.arg, bound)
        case _:
            return True


def outer_variables(node: Argument | Literal) -> Iterator[Variable | Unnamed]:
    """The variables below a node outside of aggregates."""
    if isinstance(node, (Variable, Unnamed)):
        yield node
    elif not isinstance(node, Aggregate):
        for child in children(node):
            yield from outer_variables(child)


def aggregates(node: Argument | Literal) -> Iterator[Aggregate]:
    """The outermost aggregates below a node."""
    if isinstance(node, Aggregate):
        yield node
    else:
        for child in children(node):
            yield from aggregates(child)


def unbound_in_clause(clause: Clause, inline: bool) -> Iterator[tuple[Variable | Unnamed, str]]:
    """Variables without a binding, with the reason; `inline` heads bind their own variables."""
    given: set[str] = set()
    if clause.dominating is not None:
        for atom in (clause.head, clause.dominating):
            for arg in atom.args:
                _bind(arg, given)
    elif inline:
        for arg in clause.head.args:
            _bind(arg, given)
    bound = grounded_variables(clause.body, given)
    yield from _unbound(clause.head, bound)
    for literal in clause.body:
        yield from _unbound(literal, bound)
    for literal in (clause.head, *clause.body):
        for aggregate in aggregates(literal):
            yield from _unbound_in_aggregate(aggregate, bound)


def _unbound_in_aggregate(aggregate: Aggregate, outer: set[str]) -> Iterator[tuple[Variable | Unnamed, str]]:
    bound = grounded_variables(aggregate.body, outer)
    literals: list[Argument | Literal] = [*aggregate.body]
    if aggregate.target is not None:
        literals.insert(0, aggregate.target)
    for node in literals:
        yield from _unbound(node, bound)
        for inner in aggregates(node):
            yield from _unbound_in_aggregate(inner, bound)


def _unbound(node: Argument | Literal, bound: set[str]) -> Iterator[tuple[Variable | Unnamed, str]]:
    negated = isinstance(node, Negation)
    yield from _loose(node, bound)
    for variable in outer_variables(node):
        if isinstance(variable, Variable) and variable.name not in bound:
            yield variable, "in a negation" if negated else ""


def _loose(node: Argument | Literal, bound: set[str]) -> Iterator[tuple[Unnamed, str]]:
    """Every `_` that is part of a value to compute: it stands for nothing there, as it does in a pattern."""
    match node:
        case Negation():
            for arg in node.atom.args:
                yield from ((u, "in a term of a negated atom") for u in _unnamed(arg) if u is not arg)
        case Atom():
            for arg in node.args:
                yield from ((u, "in a functor") for u in _unnamed_below_functors(arg))
        case Constraint() if node.op == "=":
            for side, other in ((node.left, node.right), (node.right, node.left)):
                if not is_bound(other, bound) and not isinstance(side, Unnamed) and not isinstance(other, Unnamed):
                    yield from ((u, "in an equation") for u in _unnamed(side))
        case Constraint():
            yield from ((u, "in a comparison") for side in (node.left, node.right) for u in _unnamed(side))
        case Aggregate():
            return


def _unnamed(term: Argument) -> Iterator[Unnamed]:
    return (v for v in outer_variables(term) if isinstance(v, Unnamed))


def _unnamed_below_functors(term: Argument) -> Iterator[Unnamed]:
    if isinstance(term, (Functor, UserFunctor, Cast)):
        yield from _unnamed(term)
    elif isinstance(term, (Record, Branch)):
        for arg in term.args:
            yield from _unnamed_below_functors(arg)
