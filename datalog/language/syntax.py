"""The syntax tree of a program, as parsed: declarations, clauses, terms.

Nodes compare by identity, because type inference attaches a type to every occurrence of a term.
Clause bodies are conjunctions: the parser has already distributed `;` and pushed `!` inwards.
Language reference: https://souffle-lang.github.io/program
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TypeAlias

from rosarch.datalog.language.errors import Location


@dataclass(frozen=True, slots=True, eq=False)
class Variable:
    """A named variable."""

    name: str
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Unnamed:
    """The anonymous variable `_`."""

    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Number:
    """A numeric constant; `kind` is `i`, `u`, `f`, or empty when its context decides."""

    text: str
    kind: str
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class String:
    """A symbol constant."""

    value: str
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Nil:
    """`nil`, the record that is none."""

    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Counter:
    """`autoinc()` and its old spelling `$`."""

    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class IterationCounter:
    """`recursive_iteration_cnt()`."""

    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Record:
    """`[args]`."""

    args: tuple[Argument, ...]
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Branch:
    """`$Name(args)`: a value of an algebraic data type."""

    name: str
    args: tuple[Argument, ...]
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Functor:
    """An intrinsic functor; operators are functors with the name of their symbol."""

    op: str
    args: tuple[Argument, ...]
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class UserFunctor:
    """`@name(args)`."""

    name: str
    args: tuple[Argument, ...]
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Cast:
    """`as(arg, type)`: the same value under another type."""

    arg: Argument
    type: str
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Aggregate:
    """`op target : { body }`; `count` has no target."""

    op: str
    target: Argument | None
    body: tuple[Literal, ...]
    location: Location


Argument: TypeAlias = (
    Variable | Unnamed | Number | String | Nil | Counter | IterationCounter | Record | Branch | Functor | UserFunctor | Cast | Aggregate
)


@dataclass(frozen=True, slots=True, eq=False)
class Atom:
    """`name(args)`."""

    name: str
    args: tuple[Argument, ...]
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Negation:
    """`!atom`."""

    atom: Atom
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Constraint:
    """`left op right`; `op` is a comparison, `match`, `contains` or a negated one (`!match`)."""

    op: str
    left: Argument
    right: Argument
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """The constraints `true` and `false`."""

    value: bool
    location: Location


Literal: TypeAlias = Atom | Negation | Constraint | Truth


@dataclass(frozen=True, slots=True, eq=False)
class Clause:
    """A fact or a rule; `dominating` is the right side of a subsumptive clause `head <= dominating :- body`."""

    head: Atom
    body: tuple[Literal, ...]
    location: Location
    dominating: Atom | None = None
    plan: tuple[tuple[int, tuple[int, ...]], ...] = ()


@dataclass(frozen=True, slots=True)
class AttributeDecl:
    """`name: type` of a relation, record or branch."""

    name: str
    type: str
    location: Location


@dataclass(frozen=True, slots=True)
class Relation:
    """A `.decl`; `choices` are the keys of its choice-domain."""

    name: str
    attributes: tuple[AttributeDecl, ...]
    qualifiers: frozenset[str]
    choices: tuple[tuple[str, ...], ...]
    location: Location
    doc: str = ""
    limit: int = 0  # rows after which its recursion ends (`.limitsize`), if any


@dataclass(frozen=True, slots=True)
class SubsetDecl:
    """`.type name <: base`."""

    name: str
    base: str
    location: Location


@dataclass(frozen=True, slots=True)
class UnionDecl:
    """`.type name = a | b`; with one member it is an alias."""

    name: str
    members: tuple[str, ...]
    location: Location


@dataclass(frozen=True, slots=True)
class RecordDecl:
    """`.type name = [field: type, ...]`."""

    name: str
    fields: tuple[AttributeDecl, ...]
    location: Location


@dataclass(frozen=True, slots=True)
class BranchDecl:
    """`name {fields}` of an algebraic data type."""

    name: str
    fields: tuple[AttributeDecl, ...]
    location: Location


@dataclass(frozen=True, slots=True)
class AdtDecl:
    """`.type name = A {x: t} | B {}`."""

    name: str
    branches: tuple[BranchDecl, ...]
    location: Location


TypeDecl: TypeAlias = SubsetDecl | UnionDecl | RecordDecl | AdtDecl


@dataclass(frozen=True, slots=True)
class FunctorDecl:
    """`.functor name(params): result`."""

    name: str
    params: tuple[str, ...]
    result: str
    location: Location


@dataclass(frozen=True, slots=True)
class Directive:
    """`.input`, `.output`, `.printsize` or `.limitsize` of one relation."""

    kind: str
    relation: str
    params: tuple[tuple[str, str], ...]
    location: Location


@dataclass(frozen=True, slots=True)
class ComponentType:
    """`name<params>`."""

    name: str
    params: tuple[str, ...]
    location: Location


@dataclass(frozen=True, slots=True)
class Init:
    """`.init name = Component<params>`."""

    name: str
    component: ComponentType
    location: Location


@dataclass(frozen=True, slots=True)
class Pragma:
    """`.pragma "key" "value"`."""

    key: str
    value: str
    location: Location


@dataclass(slots=True)
class Unit:
    """The declarations of a program, or of a component body."""

    types: list[TypeDecl] = field(default_factory=list)
    relations: list[Relation] = field(default_factory=list)
    clauses: list[Clause] = field(default_factory=list)
    directives: list[Directive] = field(default_factory=list)
    functors: list[FunctorDecl] = field(default_factory=list)
    pragmas: list[Pragma] = field(default_factory=list)
    components: list[Component] = field(default_factory=list)
    inits: list[Init] = field(default_factory=list)
    overrides: list[str] = field(default_factory=list)


@dataclass(frozen=True, slots=True, eq=False)
class Component:
    """`.comp type : bases { unit }`."""

    type: ComponentType
    bases: tuple[ComponentType, ...]
    unit: Unit


def children(node: Argument | Literal) -> tuple[Argument | Literal, ...]:
    """The direct sub-terms and sub-literals of a node."""
    match node:
        case Variable() | Unnamed() | String() | Number():
            return ()
        case Record() | Branch() | Functor() | UserFunctor() | Atom():
            return node.args
        case Cast():
            return (node.arg,)
        case Aggregate():
            return node.body if node.target is None else (node.target, *node.body)
        case Negation():
            return (node.atom,)
        case Constraint():
            return (node.left, node.right)
        case _:
            return ()


def walk(node: Argument | Literal) -> Iterator[Argument | Literal]:
    """The node and everything below it, in source order."""
    stack = [node]
    while stack:
        found = stack.pop()
        yield found
        stack.extend(reversed(children(found)))


def clause_literals(clause: Clause) -> tuple[Literal, ...]:
    """Head and body of a clause, with both atoms of a subsumptive head."""
    heads = (clause.head,) if clause.dominating is None else (clause.head, clause.dominating)
    return (*heads, *clause.body)


def variables(node: Argument | Literal) -> set[str]:
    """The names of the variables below a node, inside aggregates too."""
    return {n.name for n in walk(node) if isinstance(n, Variable)}
