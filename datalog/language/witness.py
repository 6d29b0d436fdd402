"""Witnesses of aggregates: variables of an aggregate body that the rest of the clause uses without binding them.

`tallest(S, H) :- H = max X : { height(S, X) }` asks for the `S` that attain the maximum. As souffle's
GroundWitnesses.cpp, the body of the aggregate is repeated in the clause with the result in place of its target:
`H = max X : { height(S', X) }, height(S, H)`.
"""

from __future__ import annotations

from collections.abc import Iterable

from rosarch.datalog.language.ground import aggregates, grounded_variables, outer_variables
from rosarch.datalog.language.rewrite import Substitution
from rosarch.datalog.language.syntax import Aggregate, Argument, Clause, Constraint, Literal, Variable, children, clause_literals, variables


def ground_witnesses(clause: Clause) -> Clause:
    """The clause with every witness bound; the same clause when there is none."""
    for number in range(100):
        found = _first_witnessed(clause)
        if found is None:
            return clause
        clause = _ground(clause, *found, number)
    return clause


def _first_witnessed(clause: Clause) -> tuple[Aggregate, set[str]] | None:
    literals = clause_literals(clause)
    if not any(True for literal in literals for _ in aggregates(literal)):
        return None
    outside = {v.name for literal in literals for v in outer_variables(literal) if isinstance(v, Variable)}
    missing = outside - grounded_variables(clause.body)
    if not missing:
        return None
    for aggregate in _all_aggregates(literals):
        if aggregate.target is not None:
            witnesses = missing & grounded_variables(aggregate.body)
            if witnesses:
                return aggregate, witnesses
    return None


def _all_aggregates(nodes: Iterable[Argument | Literal]) -> Iterable[Aggregate]:
    """All aggregates, inner ones before those they are in."""
    for node in nodes:
        for aggregate in aggregates(node):
            yield from _all_aggregates(children(aggregate))
            yield aggregate


def _ground(clause: Clause, aggregate: Aggregate, witnesses: set[str], number: int) -> Clause:
    at, target = aggregate.location, aggregate.target
    assert target is not None
    result = Variable(f"+result{number}", at)
    outer = grounded_variables(clause.body)
    inside = {v for part in children(aggregate) for v in variables(part)}
    local = (inside - outer) | variables(target)
    inner = {w: Variable(f"{w}+w{number}", at) for w in witnesses}
    renamed = Substitution(inner).aggregate(aggregate)
    copies: dict[str, Argument] = {v: Variable(f"{v}+c{number}", at) for v in local - witnesses}
    extra: list[Literal] = []
    if isinstance(target, Variable):
        copies[target.name] = result
    else:
        extra.append(Constraint("=", result, Substitution(copies).term(target), at))
    extra.extend(Substitution(copies).literal(literal) for literal in aggregate.body)
    outermost = any(a is aggregate for literal in clause_literals(clause) for a in aggregates(literal))
    rest = Substitution({}, aggregate, result if outermost else renamed).clause(clause)
    body = (*rest.body, Constraint("=", result, renamed, at), *extra)
    return Clause(rest.head, body, clause.location, rest.dominating, clause.plan)
