"""Records whose type nothing determines, because they only meet each other: equations between them, and names for them.

`r = [x, y], s = r, s = [v, w]` is `x = v, y = w` (souffle's ResolveAnonymousRecordAliases.cpp and FoldAnonymousRecords.cpp).
"""

from __future__ import annotations

from collections import Counter

from rosarch.datalog.language.rewrite import Substitution
from rosarch.datalog.language.syntax import (
    Argument,
    Clause,
    Constraint,
    Literal,
    Record,
    Unnamed,
    Variable,
    clause_literals,
    variables,
    walk,
)

_ROUNDS = 100


def resolve_records(clause: Clause) -> list[Clause]:
    """The clause without such records; several clauses where two of them must differ, the clause itself in most cases."""
    if not any(isinstance(side, Record) for c in clause.body if isinstance(c, Constraint) for side in (c.left, c.right)):
        return [clause]
    for _ in range(_ROUNDS):
        clause = _flat(clause)
        named = _named_record(clause)
        if named is None:
            break
        number, name, record = named
        body = (*clause.body[:number], *clause.body[number + 1 :])
        clause = Substitution({name: record}).clause(Clause(clause.head, body, clause.location, clause.dominating, clause.plan))
    bodies: list[tuple[Literal, ...]] = [()]
    for literal in clause.body:
        bodies = [body + part for body in bodies for part in _folded(literal)]
    if len(bodies) == 1 and len(bodies[0]) == len(clause.body) and all(a is b for a, b in zip(bodies[0], clause.body, strict=True)):
        return [clause]
    return [Clause(clause.head, body, clause.location, clause.dominating, clause.plan) for body in bodies]


def _flat(clause: Clause) -> Clause:
    """The clause with equations of records field by field, and without those that say nothing."""
    parts = [_folded(c) if isinstance(c, Constraint) and c.op == "=" else [(c,)] for c in clause.body]
    body = tuple(x for part in parts for x in part[0])
    if len(body) == len(clause.body) and all(a is b for a, b in zip(body, clause.body, strict=True)):
        return clause
    return Clause(clause.head, body, clause.location, clause.dominating, clause.plan)


def _named_record(clause: Clause) -> tuple[int, str, Record] | None:
    """An equation `v = [...]` of which the variable occurs in nothing but equations: its place, the variable, the record."""
    uses: Counter[str] = Counter()
    for literal in clause_literals(clause):
        uses.update(n.name for n in walk(literal) if isinstance(n, Variable))
    sides = [s for c in clause.body if isinstance(c, Constraint) and c.op in ("=", "!=") for s in (c.left, c.right)]
    equated = Counter(s.name for s in sides if isinstance(s, Variable))
    for number, literal in enumerate(clause.body):
        if isinstance(literal, Constraint) and literal.op == "=":
            for one, other in ((literal.left, literal.right), (literal.right, literal.left)):
                if not isinstance(one, Variable) or not isinstance(other, Record) or one.name in variables(other):
                    continue
                if uses[one.name] == equated[one.name] > 1:
                    return number, one.name, other
    return None


def _folded(literal: Literal) -> list[tuple[Literal, ...]]:
    """An (in)equation of two records as (in)equations of their fields: alternatives of conjunctions."""
    if not isinstance(literal, Constraint) or literal.op not in ("=", "!="):
        return [(literal,)]
    left, right = literal.left, literal.right
    if literal.op == "=" and (isinstance(left, Unnamed) or isinstance(right, Unnamed)):
        return [()]
    if not isinstance(left, Record) or not isinstance(right, Record) or len(left.args) != len(right.args):
        return [(literal,)]
    pairs: list[tuple[Argument, Argument]] = list(zip(left.args, right.args, strict=True))
    parts = [_folded(Constraint(literal.op, a, b, literal.location)) for a, b in pairs]
    if literal.op == "!=":
        return [alternative for part in parts for alternative in part]
    return [tuple(x for part in parts for x in part[0])]
