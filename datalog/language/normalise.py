"""Clause bodies in the form that code is generated from.

Atoms hold only variables, `_` and constants; records, functors, aggregates and generators inside them are lifted
into equations with fresh variables. A step is one such literal.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from rosarch.datalog.language.functors import MULTI_RESULT
from rosarch.datalog.language.ground import aggregates, grounded_variables, outer_variables
from rosarch.datalog.language.inference import ClauseTypes
from rosarch.datalog.language.syntax import (
    Aggregate,
    Argument,
    Atom,
    Branch,
    Cast,
    Constraint,
    Functor,
    Literal,
    Negation,
    Nil,
    Number,
    Record,
    String,
    Truth,
    Unnamed,
    UserFunctor,
    Variable,
    children,
    variables,
    walk,
)  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Scan:
    """A positive atom; `index` is its position among the atoms of the clause body, -1 inside aggregates."""

    atom: Atom
    index: int


@dataclass(frozen=True, slots=True, eq=False)
class Absent:
    """A negated atom, its arguments lifted like those of a positive one."""

    atom: Atom


@dataclass(frozen=True, slots=True, eq=False)
class Generate:
    """`variable` takes every value of a functor with several results."""

    variable: str
    functor: Functor


@dataclass(frozen=True, slots=True, eq=False)
class Fold:
    """`variable` takes the value of an aggregate; `inputs` must be bound before."""

    variable: str
    aggregate: Aggregate
    steps: tuple[Step, ...]
    target: Argument | None
    inputs: frozenset[str]
    distinct: tuple[str, ...] = ()  # variables of which each combination counts once; empty: every row counts


MAX_DEPTH = 20
Step: TypeAlias = Scan | Absent | Generate | Fold | Constraint | Truth


def step_variables(step: Step) -> set[str]:
    """The variables a step reads or binds."""
    match step:
        case Scan() | Absent():
            return {a.name for a in step.atom.args if isinstance(a, Variable)} | {
                v for a in step.atom.args if not isinstance(a, (Variable, Unnamed, Nil, Number, String)) for v in variables(a)
            }
        case Constraint():
            return variables(step)
        case Generate():
            return {step.variable, *variables(step.functor)}
        case Fold():
            return {step.variable, *step.inputs}
        case _:
            return set()


class Normaliser:
    """Lifts the terms of one clause; what stands for a term inherits its types."""

    def __init__(self, types: ClauseTypes) -> None:
        self.fresh = 0
        self.types = types
        self.depths: dict[int, int] = {}  # of functors in functors
        self.rebuilt: list[Argument] = []  # keeps rebuilt terms alive: their types are stored by identity

    def variable(self, term: Argument) -> Variable:
        """A fresh variable for the value of a term."""
        self.fresh += 1
        name = f"+{self.fresh}"
        self.types.sets[name] = self.types.of(term)
        return Variable(name, term.location)

    def rebuild(self, term: Argument, args: tuple[Argument, ...]) -> Argument:
        """The term over other arguments."""
        new = _same(term, args)
        if new is not term:
            self.rebuilt.append(new)
            self.types.sets[id(new)] = self.types.sets.get(id(term))
            if id(term) in self.types.overloads:
                self.types.overloads[id(new)] = self.types.overloads[id(term)]
        return new

    def body(self, body: Sequence[Literal], given: set[str], top: bool) -> list[Step]:
        """The steps of a body. `given`: variables that are bound outside."""
        bound = grounded_variables(body, given)
        steps: list[Step] = []
        position = 0
        for literal in body:
            match literal:
                case Atom():
                    index = position if top else -1
                    position += 1
                    steps.append(Scan(self._atom(literal, steps, bound), index))
                case Negation():
                    atom = literal.atom
                    args = tuple(self._lift(a, steps, bound) for a in atom.args)
                    steps.append(Absent(Atom(atom.name, args, atom.location)))
                case Constraint():
                    steps.extend(self._constraint(literal, steps, bound))
                case Truth():
                    steps.append(literal)
        return steps

    def head(self, head: Atom, steps: list[Step], bound: set[str]) -> Atom:
        """The head with its aggregates and generators lifted."""
        return Atom(head.name, tuple(self._lift(a, steps, bound) for a in head.args), head.location)

    def _atom(self, atom: Atom, steps: list[Step], bound: set[str]) -> Atom:
        args: list[Argument] = []
        for arg in atom.args:
            if isinstance(arg, (Variable, Unnamed, String, Number, Nil)):
                args.append(arg)
            else:
                fresh = self.variable(arg)
                lifted = self._lift(arg, steps, bound)
                steps.append(Constraint("=", fresh, lifted, arg.location))
                args.append(fresh)
        return Atom(atom.name, tuple(args), atom.location)

    def _constraint(self, literal: Constraint, steps: list[Step], bound: set[str]) -> Iterator[Constraint]:
        left, right = literal.left, literal.right
        if literal.op == "=" and isinstance(left, (Record, Branch)) and _same_shape(left, right):
            for a, b in zip(left.args, children(right), strict=True):
                if not isinstance(a, Unnamed) and not isinstance(b, Unnamed):
                    yield from self._constraint(Constraint("=", a, b, a.location), steps, bound)  # type: ignore[arg-type]
            return
        yield Constraint(literal.op, self._lift(left, steps, bound), self._lift(right, steps, bound), literal.location)

    def _lift(self, term: Argument, steps: list[Step], bound: set[str]) -> Argument:
        """The term with its aggregates and generators replaced by variables that steps define."""
        match term:
            case Aggregate():
                return self._fold(term, steps, bound)
            case Functor():
                lifted = self.rebuild(term, tuple([self._shallow(self._lift(a, steps, bound), steps) for a in term.args]))
                if term.op in MULTI_RESULT:
                    fresh = self.variable(term)
                    steps.append(Generate(fresh.name, lifted))  # type: ignore[arg-type]
                    return fresh
                return lifted
            case Record() | Branch():
                return self.rebuild(term, tuple(self._field(a, steps, bound) for a in term.args))
            case UserFunctor():
                return self.rebuild(term, tuple(self._lift(a, steps, bound) for a in term.args))
            case Cast():
                return self.rebuild(term, (self._lift(term.arg, steps, bound),))
            case _:
                return term

    def _shallow(self, term: Argument, steps: list[Step]) -> Argument:
        """The term, or a variable for one so deep that the Python expression for it would have too many brackets."""
        if not isinstance(term, Functor):
            return term
        depth = 1 + max((self.depths.get(id(a), 0) for a in term.args), default=0)
        if depth < MAX_DEPTH:
            self.depths[id(term)] = depth
            return term
        fresh = self.variable(term)
        steps.append(Constraint("=", fresh, term, term.location))
        return fresh

    def _field(self, term: Argument, steps: list[Step], bound: set[str]) -> Argument:
        """A field of a record, which may serve as a pattern: a functor in it becomes an equation."""
        lifted = self._lift(term, steps, bound)
        if not isinstance(lifted, (Functor, UserFunctor, Cast)):
            return lifted
        fresh = self.variable(lifted)
        steps.append(Constraint("=", fresh, lifted, term.location))
        return fresh

    def _fold(self, term: Aggregate, steps: list[Step], bound: set[str]) -> Variable:
        fresh = self.variable(term)
        inside = {v for part in children(term) for v in variables(part)}
        local = variables(term.target) if term.target is not None else set()
        inputs = (inside & bound) - local
        inner = self.body(term.body, inputs, top=False)
        target = term.target
        if target is not None:
            target = self._lift(target, inner, grounded_variables(term.body, inputs))
        steps.append(Fold(fresh.name, term, tuple(inner), target, frozenset(inputs), _distinct(term, inputs)))
        return fresh


def _distinct(term: Aggregate, inputs: set[str]) -> tuple[str, ...]:
    """The variables whose combinations an aggregate ranges over, where that is less than all rows.

    Souffle turns a body with several atoms, or with an inner aggregate, into a relation over its named variables
    (MaterializeAggregationQueries.cpp), so that `_` does not multiply; with a single atom every row counts.
    """
    atoms = [literal for literal in term.body if isinstance(literal, Atom)]
    if term.op in ("min", "max") or not (len(atoms) > 1 or _materialised(term, atoms)):
        return ()
    if not any(isinstance(v, Unnamed) for atom in atoms for v in outer_variables(atom)):
        return ()
    named = {v.name for part in term.body for v in outer_variables(part) if isinstance(v, Variable)}
    return tuple(sorted(named - inputs)) or ("",)


def _materialised(term: Aggregate, atoms: list[Atom]) -> bool:
    """Whether souffle gives a body with one atom a relation of its own."""
    if any(True for part in term.body for _ in aggregates(part)):
        return True
    if any(isinstance(n, Functor) and n.op in MULTI_RESULT for part in term.body for n in walk(part)):
        return True
    names = [v.name for atom in atoms for v in outer_variables(atom) if isinstance(v, Variable)]
    return len(names) != len(set(names))


def _same_shape(left: Record | Branch, right: Argument) -> bool:
    """Whether two records, or two values of one branch, can be equated field by field."""
    if len(left.args) != len(children(right)):
        return False
    if isinstance(left, Branch):
        return isinstance(right, Branch) and left.name == right.name
    return isinstance(right, Record)


def _same(term: Argument, args: tuple[Argument, ...]) -> Argument:
    """The term, rebuilt only when an argument changed."""
    if all(a is b for a, b in zip(children(term), args, strict=True)):
        return term
    match term:
        case Cast():
            return Cast(args[0], term.type, term.location)
        case Record():
            return Record(args, term.location)
        case Branch():
            return Branch(term.name, args, term.location)
        case UserFunctor():
            return UserFunctor(term.name, args, term.location)
        case Functor():
            return Functor(term.op, args, term.location)
    return term
