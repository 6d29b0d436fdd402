"""Type inference: the set of possible types of every term of a clause.

The constraint system of souffle's TypeConstrainsAnalysis.cpp: every term starts unconstrained (`None`) and each
constraint narrows the sets of the terms it touches until nothing changes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from rosarch.datalog.language.functors import FUNCTORS, INFIX, Overload
from rosarch.datalog.language.syntax import (
    Aggregate,
    Argument,
    Atom,
    Branch,
    Cast,
    Clause,
    Constraint,
    Counter,
    Functor,
    IterationCounter,
    Literal,
    Negation,
    Number,
    Record,
    Relation,
    String,
    Unnamed,
    UserFunctor,
    Variable,
    clause_literals,
    walk,
)  # fmt: skip
from rosarch.datalog.language.types import CONSTANT_TYPES, PRIMITIVES, Types

TypeSet: TypeAlias = frozenset[str] | None  # None: not constrained yet
Key: TypeAlias = str | int  # a variable's name, or the identity of any other term
NUMERIC = frozenset((CONSTANT_TYPES["i"], CONSTANT_TYPES["u"], CONSTANT_TYPES["f"]))


def key_of(term: Argument) -> Key:
    """The key of a term: occurrences of one variable share theirs."""
    return term.name if isinstance(term, Variable) else id(term)


@dataclass(slots=True)
class ClauseTypes:
    """The outcome for one clause: possible types per term, and the overload chosen per functor."""

    sets: dict[Key, TypeSet] = field(default_factory=dict)
    overloads: dict[int, list[Overload]] = field(default_factory=dict)

    def of(self, term: Argument) -> TypeSet:
        """The possible types of a term."""
        return self.sets.get(key_of(term))

    def in_order(self, clause: Clause) -> Ordered:
        """What is known, without identities of terms: they are other ones in another process."""
        terms = [(self.sets.get(id(term)), self.overloads.get(id(term))) for term in _terms(clause)]
        return {key: found for key, found in self.sets.items() if isinstance(key, str)}, terms

    @classmethod
    def of_ordered(cls, known: Ordered, clause: Clause) -> ClauseTypes:
        """What `in_order` returned, of the same clause."""
        variables, terms = known
        found = cls(dict(variables))
        for term, (types, overloads) in zip(_terms(clause), terms, strict=True):
            if types is not None:
                found.sets[id(term)] = types
            if overloads is not None:
                found.overloads[id(term)] = overloads
        return found


Ordered: TypeAlias = tuple[dict[Key, TypeSet], list[tuple[TypeSet, list[Overload] | None]]]
"""Types by variable, and types and overloads of all terms in source order."""


def _terms(clause: Clause) -> Iterator[Any]:
    return (term for literal in clause_literals(clause) for term in walk(literal))


class Inference:
    """Infers the types of one clause at a time."""

    def __init__(self, types: Types, relations: Mapping[str, Relation], functors: Mapping[str, tuple[tuple[str, ...], str]]) -> None:
        self.types = types
        self.relations = relations
        self.functors = functors
        self.result = ClauseTypes()
        self.constraints: list[Callable[[], bool]] = []

    def run(self, clause: Clause) -> ClauseTypes:
        """Infer the types of a clause."""
        self.result = ClauseTypes()
        self.constraints = []
        sinks = {id(clause.head)}
        for literal in clause_literals(clause):
            self._literal(literal, sinks)
        if clause.dominating is not None:
            self._atom(clause.head, sink=False)
        changed = True
        while changed:
            changed = False
            for constraint in self.constraints:
                changed |= constraint()
        return self.result

    # -- collecting constraints -----------------------------------------------------------------

    def _literal(self, literal: Literal, sinks: set[int]) -> None:
        match literal:
            case Atom():
                self._atom(literal, sink=id(literal) in sinks)
            case Negation():
                self._atom(literal.atom, sink=True)
            case Constraint():
                if literal.op.lstrip("!") in ("match", "contains"):
                    symbol = CONSTANT_TYPES["s"]
                    self.subtype(literal.left, symbol)
                    self.subtype(literal.right, symbol)
                else:
                    self.below(literal.left, literal.right)
                    self.below(literal.right, literal.left)
                self._term(literal.left)
                self._term(literal.right)

    def _atom(self, atom: Atom, sink: bool) -> None:
        relation = self.relations.get(atom.name)
        if relation is not None and len(relation.attributes) == len(atom.args):
            for attribute, arg in zip(relation.attributes, atom.args, strict=True):
                if not self.types.exists(attribute.type):
                    continue
                if not sink:
                    self.subtype(arg, attribute.type)
                elif self.types.kind(attribute.type) in "r+":
                    self.subtype(arg, self.types.root(attribute.type).name)
                else:
                    self.subtype(arg, CONSTANT_TYPES[self.types.kind(attribute.type)])
        for arg in atom.args:
            self._term(arg)

    def _term(self, term: Argument) -> None:
        match term:
            case String():
                self.subtype(term, CONSTANT_TYPES["s"])
            case Number():
                allowed = frozenset((CONSTANT_TYPES[term.kind],)) if term.kind else NUMERIC
                self.within(term, allowed)
            case Counter():
                self.subtype(term, CONSTANT_TYPES["i"])
            case IterationCounter():
                self.subtype(term, CONSTANT_TYPES["u"])
            case Cast():
                if self.types.exists(term.type):
                    self.subtype(term, term.type)
                    if isinstance(term.arg, (Number, String)):
                        self.subtype(term.arg, term.type)
                self._term(term.arg)
            case Record():
                for index, arg in enumerate(term.args):
                    self._component(arg, term, index)
                    self._term(arg)
            case Branch():
                self._branch(term)
            case Functor():
                self._functor(term)
            case UserFunctor():
                self._user_functor(term)
            case Aggregate():
                self._aggregate(term)

    def _branch(self, term: Branch) -> None:
        owner = self.types.branch_owner.get(term.name)
        if owner is not None:
            self.subtype(term, owner)
            expected = dict(self.types.get(owner).branches)[term.name]
            if len(expected) == len(term.args):
                for arg, type_name in zip(term.args, expected, strict=True):
                    if self.types.exists(type_name):
                        self.subtype(arg, type_name)
        for arg in term.args:
            self._term(arg)

    def _user_functor(self, term: UserFunctor) -> None:
        declared = self.functors.get(term.name)
        if declared is not None and len(declared[0]) == len(term.args):
            self.subtype(term, declared[1])
            for arg, type_name in zip(term.args, declared[0], strict=True):
                self.subtype(arg, type_name)
        for arg in term.args:
            self._term(arg)

    def _aggregate(self, term: Aggregate) -> None:
        if term.op == "count":
            self.subtype(term, CONSTANT_TYPES["i"])
        elif term.op == "mean":
            self.subtype(term, CONSTANT_TYPES["f"])
        else:
            self.within(term, NUMERIC)
        if term.target is not None:
            self.below(term.target, term)
            self.below(term, term.target)
            self._term(term.target)
        for literal in term.body:
            self._literal(literal, set())

    def _functor(self, term: Functor) -> None:
        overloads = [o for o in FUNCTORS.get(term.op, ()) if o.accepts(len(term.args))]
        self.result.overloads[id(term)] = overloads
        if overloads:
            self._overload(term)
            if term.op in INFIX:
                for arg in term.args:
                    self._same_base(arg, term)
        for arg in term.args:
            self._term(arg)

    # -- constraints: closures that narrow sets and say whether they changed one ------------------

    def subtype(self, term: Argument, type_name: str) -> None:
        """The term is of the given type or a subtype."""
        if isinstance(term, Unnamed):
            return
        sets, key, types = self.result.sets, key_of(term), self.types
        only = frozenset((types.resolve(type_name),))

        def update() -> bool:
            current = sets.get(key)
            new = only if current is None else types.common_sets(current, only)
            sets[key] = new
            return new != current

        self.constraints.append(update)

    def within(self, term: Argument, allowed: frozenset[str]) -> None:
        """The term is of a subtype of one of the allowed types."""
        sets, key, types = self.result.sets, key_of(term), self.types

        def update() -> bool:
            current = sets.get(key)
            if current is None:
                sets[key] = allowed
                return True
            new = frozenset(t for t in current if any(types.is_subtype(t, a) for a in allowed))
            sets[key] = new
            return new != current

        self.constraints.append(update)

    def below(self, a: Argument, b: Argument) -> None:
        """Every type of `a` is a subtype of one of `b`."""
        sets, ka, kb, types = self.result.sets, key_of(a), key_of(b), self.types

        def update() -> bool:
            left, right = sets.get(ka), sets.get(kb)
            if right is None:
                return False
            new = right if left is None else types.common_sets(left, right)
            sets[ka] = new
            return new != left

        self.constraints.append(update)

    def _component(self, arg: Argument, record: Record, index: int) -> None:
        sets, ka, kr, types = self.result.sets, key_of(arg), key_of(record), self.types

        def update() -> bool:
            records = sets.get(kr)
            if records is None:
                return False
            fitting = frozenset(r for r in records if len(types.root(r).fields) > index)
            fields = frozenset(types.resolve(types.root(r).fields[index]) for r in fitting)
            fields = frozenset(f for f in fields if types.exists(f))
            current = sets.get(ka)
            new = fields if current is None else types.common_sets(current, fields)
            changed = fitting != records or new != current
            sets[kr], sets[ka] = fitting, new
            return changed

        self.constraints.append(update)

    def _bases(self, found: TypeSet) -> frozenset[str]:
        return frozenset(CONSTANT_TYPES[k] for t in found or () if (k := self.types.kind(t)) in CONSTANT_TYPES)

    def _same_base(self, a: Argument, b: Argument) -> None:
        sets, ka, kb, types = self.result.sets, key_of(a), key_of(b), self.types

        def update() -> bool:
            left, right = sets.get(ka), sets.get(kb)
            if left is None and right is None:
                return False
            if left is None or right is None:
                bases = self._bases(left if right is None else right)
                sets[ka if left is None else kb] = bases
                return True
            shared = self._bases(left) & self._bases(right)
            new_left = frozenset(t for t in left if any(types.is_subtype(t, s) for s in shared))
            new_right = frozenset(t for t in right if any(types.is_subtype(t, s) for s in shared))
            sets[ka], sets[kb] = new_left, new_right
            return new_left != left or new_right != right

        self.constraints.append(update)

    def _overload(self, term: Functor) -> None:
        """Drop overloads that no longer fit; apply the last one that is left."""
        sets, key, types = self.result.sets, key_of(term), self.types
        args = [key_of(a) for a in term.args]
        overloads = self.result.overloads[id(term)]
        infix = term.op in INFIX
        decided = False

        def possible(kind: str, k: Key) -> bool:
            current = sets.get(k)
            return current is None or any(types.kind(t) == kind for t in current)

        def narrow(k: Key, kind: str) -> bool:
            current = sets.get(k)
            top = CONSTANT_TYPES[kind]
            new = frozenset((top,)) if current is None else frozenset(t for t in current if types.is_subtype(t, top))
            sets[k] = new
            return new != current

        def update() -> bool:
            nonlocal decided
            overloads[:] = [
                o for o in overloads
                if all(possible(k, a) for k, a in zip(o.kinds(len(args)), args, strict=True)) and possible(o.result, key)
            ]  # fmt: skip
            if len(overloads) > 1 or (term.op == "ord" and overloads):
                if not decided and len({o.result for o in overloads}) == 1:  # whatever the arguments are
                    decided = True
                    sets[key] = frozenset((CONSTANT_TYPES[overloads[0].result],))
                    return True
                return False
            if not overloads:
                changed = sets.get(key) != frozenset()
                sets[key] = frozenset()
                return changed
            chosen = overloads[0]
            changed = False
            for k, a in zip(chosen.kinds(len(args)), args, strict=True):
                changed |= narrow(a, k)
            if decided or infix:
                return narrow(key, chosen.result) or changed
            decided = True
            new = frozenset((CONSTANT_TYPES[chosen.result],))
            changed |= sets.get(key) != new
            sets[key] = new
            return changed

        self.constraints.append(update)


def default_numeric(result: ClauseTypes, clause: Clause) -> None:
    """Settle terms that could still be several numeric types: number first (souffle's order of overloads)."""
    for literal in clause_literals(clause):
        for term in walk(literal):
            if isinstance(term, Functor):
                overloads = result.overloads.get(id(term), [])
                overloads.sort(key=lambda o: "iufs".index(o.result))


def kind_of(found: TypeSet, types: Types) -> str:
    """The base kind of a set of types; `i` wins when a constant could be several numbers."""
    kinds = {types.kind(t) for t in found or ()}
    for kind in ("i", "u", "f", "s", "r", "+"):
        if kind in kinds:
            return kind
    return ""


__all__ = ["PRIMITIVES", "ClauseTypes", "Inference", "default_numeric", "key_of", "kind_of"]
