"""Builds syntax tree nodes while lark parses a file.

The methods of `TreeBuilder` are named after the rules of grammar.lark, which documents them.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

from lark import Token, Transformer, v_args

from rosarch.datalog.language.errors import Location, Report
from rosarch.datalog.language.preprocess import Origins
from rosarch.datalog.language.syntax import (
    AdtDecl,
    Aggregate,
    Argument,
    Atom,
    AttributeDecl,
    Branch,
    BranchDecl,
    Cast,
    Clause,
    Component,
    ComponentType,
    Constraint,
    Counter,
    Directive,
    Functor,
    FunctorDecl,
    Init,
    IterationCounter,
    Literal,
    Negation,
    Nil,
    Number,
    Pragma,
    Record,
    RecordDecl,
    Relation,
    String,
    SubsetDecl,
    Truth,
    TypeDecl,
    UnionDecl,
    Unnamed,
    UserFunctor,
    Variable,
)


@dataclass(frozen=True, slots=True)
class Include:
    """`.include "path"`, replaced by the items of the file when the program is assembled."""

    path: str
    location: Location


@dataclass(frozen=True, slots=True)
class Override:
    """`.override name` in a component."""

    name: str


@dataclass(frozen=True, slots=True, eq=False)
class ComponentBody:
    """A `.comp` whose body may still hold includes."""

    type: ComponentType
    bases: tuple[ComponentType, ...]
    items: tuple[Item, ...]


Item: TypeAlias = TypeDecl | Relation | Clause | Directive | FunctorDecl | Init | Include | Override | Pragma | ComponentBody | Component
Dnf: TypeAlias = list[tuple[Literal, ...]]  # a body in disjunctive normal form: disjuncts of conjunctions
Name: TypeAlias = tuple[str, Location]

NEGATED = {"=": "!=", "!=": "=", "<": ">=", ">=": "<", ">": "<=", "<=": ">", "match": "!match", "!match": "match",
           "contains": "!contains", "!contains": "contains"}  # fmt: skip
# Binding power of the infix operators, weakest first; `^` alone is right-associative (souffle's parser.yy).
PRECEDENCE = {"lor": 1, "lxor": 2, "land": 3, "bor": 4, "bxor": 5, "band": 6, "bshl": 7, "bshr": 7, "bshru": 7,
              "+": 8, "-": 8, "*": 9, "/": 9, "%": 9, "^": 11}  # fmt: skip
PREFIX_PRECEDENCE = 10
ESCAPES = {'"': '"', "'": "'", "\\": "\\", "a": "\a", "b": "\b", "f": "\f", "n": "\n", "r": "\r", "t": "\t", "v": "\v"}


def conjoin(left: Dnf, right: Dnf) -> Dnf:
    """The conjunction of two bodies, distributed over their disjunctions."""
    return [a + b for a in left for b in right]


def negate(body: Dnf) -> Dnf:
    """The negation of a body by De Morgan's laws."""
    result: Dnf = [()]
    for disjunct in body:
        result = conjoin(result, [(negate_literal(literal),) for literal in disjunct])
    return result


def negate_literal(literal: Literal) -> Literal:
    """`!literal` as a single literal."""
    match literal:
        case Atom():
            return Negation(literal, literal.location)
        case Negation():
            return literal.atom
        case Constraint():
            return Constraint(NEGATED[literal.op], literal.left, literal.right, literal.location)
        case Truth():
            return Truth(not literal.value, literal.location)


@v_args(inline=True)
class TreeBuilder(Transformer[Token, list[Item]]):
    """Builds nodes while lark reduces; `path`, `docs` and `report` belong to the file being parsed."""

    path = ""
    report: Report
    docs: dict[int, str]
    origins: Origins | None = None

    def at(self, line: int, column: int) -> Location:
        """The place that a line and column of the text stand for."""
        return Location(self.path, line, column) if self.origins is None else self.origins.locate(line, column)

    def _at(self, token: Token) -> Location:
        return self.at(token.line or 1, token.column or 1)

    def _name(self, token: Token) -> Name:
        return token.value, self._at(token)

    # -- terminals that carry text ------------------------------------------------------------

    def _text(self, token: Token) -> str:
        def unescape(match: re.Match[str]) -> str:
            if match[1] not in ESCAPES:
                self.report.error(f"unknown escape sequence `\\{match[1]}`", self._at(token))
            return ESCAPES.get(match[1], match[1])

        return re.sub(r"\\(.)", unescape, token.value[1:-1], flags=re.DOTALL)

    # -- program --------------------------------------------------------------------------------

    def start(self, *items: Item | Sequence[Item]) -> list[Item]:
        flat: list[Item] = []
        for item in items:
            if isinstance(item, (list, tuple)):
                flat.extend(item)
            elif item is not None:
                flat.append(item)  # type: ignore[arg-type]
        return flat

    component_body = start

    def qname(self, first: Name | Token, token: Token | None = None) -> Name:
        if token is None:
            return self._name(first)  # type: ignore[arg-type]
        return f"{first[0]}.{token.value}", first[1]  # type: ignore[return-value]

    # -- types ------------------------------------------------------------------------------------

    def field(self, token: Token, name: Name) -> AttributeDecl:
        return AttributeDecl(token.value, name[0], name[1])

    def fields(self, *fields: AttributeDecl) -> tuple[AttributeDecl, ...]:
        return fields

    def union_members(self, *names: Name) -> tuple[str, ...]:
        return tuple(n[0] for n in names)

    def branch(self, token: Token, fields: tuple[AttributeDecl, ...] | None) -> BranchDecl:
        return BranchDecl(token.value, fields or (), self._at(token))

    def branches(self, *branches: BranchDecl) -> tuple[BranchDecl, ...]:
        return branches

    def subset_type(self, _: Token, token: Token, base: Name) -> SubsetDecl:
        return SubsetDecl(token.value, base[0], self._at(token))

    def union_type(self, _: Token, token: Token, members: tuple[str, ...]) -> UnionDecl:
        return UnionDecl(token.value, members, self._at(token))

    def record_type(self, _: Token, token: Token, __: Token, fields: tuple[AttributeDecl, ...] | None) -> RecordDecl:
        return RecordDecl(token.value, fields or (), self._at(token))

    def adt_type(self, _: Token, token: Token, branches: tuple[BranchDecl, ...]) -> AdtDecl:
        return AdtDecl(token.value, branches, self._at(token))

    def old_symbol_type(self, _: Token, token: Token) -> SubsetDecl:
        return SubsetDecl(token.value, "symbol", self._at(token))

    def old_number_type(self, _: Token, token: Token) -> SubsetDecl:
        return SubsetDecl(token.value, "number", self._at(token))

    # -- relations --------------------------------------------------------------------------------

    def names(self, *tokens: Token) -> tuple[Token, ...]:
        return tokens

    def qualifiers(self, *tokens: Token) -> tuple[str, ...]:
        return tuple(t.value for t in tokens)

    def choice(self, key: Token | tuple[Token, ...]) -> tuple[str, ...]:
        return (key.value,) if isinstance(key, Token) else tuple(t.value for t in key)

    def choices(self, *choices: tuple[str, ...]) -> tuple[tuple[str, ...], ...]:
        return choices

    def decl(
        self, start: Token, names: tuple[Token, ...], fields: tuple[AttributeDecl, ...] | None,
        qualifiers: tuple[str, ...], choices: tuple[tuple[str, ...], ...] | None,
    ) -> list[Item]:  # fmt: skip
        doc = self.docs.get((start.line or 1) - 1, "")
        items: list[Item] = []
        for q in sorted({q for q in qualifiers if qualifiers.count(q) > 1}):
            self.report.error(f"qualifier `{q}` is given twice", self._at(start))
        for token in names:
            at = self._at(token)
            tags = frozenset(qualifiers) - {"input", "output", "printsize"}
            items.append(Relation(token.value, fields or (), tags, choices or (), at, doc))
            items.extend(Directive(q, token.value, (), at) for q in qualifiers if q in ("input", "output", "printsize"))
        return items

    def relation_names(self, *names: Name) -> tuple[Name, ...]:
        return names

    def param(self, key: Token, value: Token) -> tuple[str, str]:
        return key.value, self._text(value) if value.type == "STRING" else value.value

    def params(self, *params: tuple[str, str]) -> tuple[tuple[str, str], ...]:
        return params

    def directive(self, start: Token, names: tuple[Name, ...], params: tuple[tuple[str, str], ...] | None) -> list[Item]:
        return [Directive(start.value[1:], name, params or (), at) for name, at in names]

    def named_param(self, _: Token, type_name: Name) -> Name:
        return type_name

    def functor_params(self, *params: Name) -> tuple[str, ...]:
        return tuple(p[0] for p in params)

    def functor_decl(self, _: Token, token: Token, params: tuple[str, ...] | None, result: Name) -> FunctorDecl:
        return FunctorDecl(token.value, params or (), result[0], self._at(token))

    def pragma(self, _: Token, key: Token, value: Token | None) -> Pragma:
        return Pragma(self._text(key), self._text(value) if value is not None else "", self._at(key))

    def include(self, _: Token, path: Token) -> Include:
        return Include(self._text(path), self._at(path))

    def once(self, _: Token) -> tuple[Item, ...]:
        return ()  # every file is included once anyway

    # -- components -------------------------------------------------------------------------------

    def component_type(self, token: Token, params: tuple[Token, ...] | None) -> ComponentType:
        return ComponentType(token.value, tuple(t.value for t in params or ()), self._at(token))

    def component_types(self, *types: ComponentType) -> tuple[ComponentType, ...]:
        return types

    def component(self, _: Token, head: ComponentType, bases: tuple[ComponentType, ...] | None, items: list[Item]) -> ComponentBody:
        return ComponentBody(head, bases or (), tuple(items))

    def init(self, _: Token, token: Token, component: ComponentType) -> Init:
        return Init(token.value, component, self._at(token))

    def override(self, _: Token, token: Token) -> Override:
        return Override(token.value)

    # -- clauses ----------------------------------------------------------------------------------

    def fact(self, atom: Atom) -> Clause:
        return Clause(atom, (), atom.location)

    def heads(self, *atoms: Atom) -> tuple[Atom, ...]:
        return atoms

    def plan_order(self, version: Token, *order: Token | None) -> tuple[int, tuple[int, ...]]:
        return int(version), tuple(int(n) for n in order if n is not None)

    def plan(self, _: Token, *orders: tuple[int, tuple[int, ...]]) -> tuple[tuple[int, tuple[int, ...]], ...]:
        return orders

    def rule(self, heads: tuple[Atom, ...], body: Dnf, plan: tuple[tuple[int, tuple[int, ...]], ...] | None) -> list[Item]:
        return [Clause(head, disjunct, head.location, None, plan or ()) for head in heads for disjunct in body]

    def subsumption(self, less: Atom, greater: Atom, body: Dnf, plan: tuple[tuple[int, tuple[int, ...]], ...] | None) -> list[Item]:
        less, greater = self._all_named(less, "<"), self._all_named(greater, ">")
        if less.name != greater.name:
            self.report.error(f"`{less.name}` is compared with `{greater.name}`, subsumption compares rows of one relation", less.location)
        if not less.args:
            self.report.error(f"subsumption needs attributes, `{less.name}` has none", less.location)
        return [Clause(less, disjunct, less.location, greater, plan or ()) for disjunct in body]

    @staticmethod
    def _all_named(atom: Atom, mark: str) -> Atom:
        """The atom with a variable for every `_`: both rows of a subsumption are needed whole."""
        args = tuple(Variable(f"_{i}+{mark}", a.location) if isinstance(a, Unnamed) else a for i, a in enumerate(atom.args))
        return Atom(atom.name, args, atom.location)

    def atom(self, name: Name, *args: Argument) -> Atom:
        return Atom(name[0], args, name[1])

    def positive(self, atom: Atom) -> Dnf:
        return [(atom,)]

    def negated(self, body: Dnf) -> Dnf:
        return negate(body)

    def conjunction(self, left: Dnf, right: Dnf) -> Dnf:
        return conjoin(left, right)

    def disjunction(self, left: Dnf, right: Dnf) -> Dnf:
        return left + right

    def comparison(self, left: Argument, op: Token, right: Argument) -> Dnf:
        return [(Constraint(op.value, left, right, left.location),)]

    def predicate(self, op: Token, left: Argument, right: Argument) -> Dnf:
        return [(Constraint(op.value, left, right, self._at(op)),)]

    def truth(self, token: Token) -> Dnf:
        return [(Truth(token.value == "true", self._at(token)),)]

    # -- arguments --------------------------------------------------------------------------------

    def arg(self, *parts: Token | Argument) -> Argument:
        """Operator precedence over the flat list of prefix operators, operands and infix operators."""
        position = 0

        def operand() -> Argument:
            nonlocal position
            part = parts[position]
            position += 1
            if not isinstance(part, Token):
                return part
            value = expression(operand(), PREFIX_PRECEDENCE)
            if part.value == "-" and isinstance(value, Number) and not value.text.startswith("-"):
                return Number("-" + value.text, value.kind, self._at(part))
            return Functor("neg" if part.value == "-" else part.value, (value,), self._at(part))

        def expression(left: Argument, weakest: int) -> Argument:
            nonlocal position
            while position < len(parts):
                op = parts[position].value  # type: ignore[union-attr]
                power = PRECEDENCE[op]
                if power < weakest:
                    break
                position += 1
                right = expression(operand(), power if op == "^" else power + 1)
                left = Functor(op, (left, right), left.location)
            return left

        return expression(operand(), 0)

    def variable(self, token: Token) -> Variable:
        return Variable(token.value, self._at(token))

    def unnamed(self, token: Token) -> Unnamed:
        return Unnamed(self._at(token))

    def string(self, token: Token) -> String:
        return String(self._text(token), self._at(token))

    def number(self, token: Token) -> Number:
        text, kind = token.value, ""
        if token.type == "FLOAT":
            kind = "f"
        elif token.type == "UNSIGNED":
            text, kind = text[:-1], "u"
        elif token.type == "IP_ADDRESS":
            parts = [int(p) for p in text.split(".")]
            if max(parts) > 255:
                self.report.error("IP address out of range", self._at(token))
            value = int.from_bytes(bytes(min(p, 255) for p in parts), "big", signed=True)
            text = str(value)
        return Number(text, kind, self._at(token))

    def nil(self, token: Token) -> Nil:
        return Nil(self._at(token))

    def counter(self, token: Token) -> Counter:
        return Counter(self._at(token))

    def iteration(self, token: Token) -> IterationCounter:
        return IterationCounter(self._at(token))

    def record(self, bracket: Token, *args: Argument) -> Record:
        return Record(args, self._at(bracket))

    def branch_value(self, dollar: Token, name: Name, *args: Argument) -> Branch:
        return Branch(name[0], args, self._at(dollar))

    def parenthesised(self, arg: Argument) -> Argument:
        return arg

    def cast(self, token: Token, arg: Argument, type_name: Name) -> Cast:
        return Cast(arg, type_name[0], self._at(token))

    def user_functor(self, at: Token, name: Token, *args: Argument) -> UserFunctor:
        return UserFunctor(name.value, args, self._at(at))

    def functor(self, token: Token, *args: Argument) -> Argument:
        if token.type == "AGGREGATE" and token.value not in ("min", "max"):
            self.report.error(f"aggregate `{token.value}` has no functor equivalent", self._at(token))
        return Functor(token.value, args, self._at(token))

    def aggregate(self, token: Token, body: Dnf) -> Aggregate:
        if token.value != "count":
            self.report.error(f"aggregate `{token.value}` needs an expression before `:`", self._at(token))
        return self._aggregate(token, None, body)

    def aggregate_of(self, token: Token, target: Argument, body: Dnf) -> Aggregate:
        if token.value == "count":
            self.report.error("aggregate `count` takes no expression", self._at(token))
        return self._aggregate(token, target, body)

    def _aggregate(self, token: Token, target: Argument | None, body: Dnf) -> Aggregate:
        if len(body) != 1:
            self.report.error("disjunctions in aggregate bodies are not supported", self._at(token))
        return Aggregate(token.value, target, body[0], self._at(token))
