"""Literals, terms and rows as text, in the language's own notation."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from rosarch.datalog.language.inference import ClauseTypes
from rosarch.datalog.language.syntax import (
    Aggregate,
    Argument,
    Atom,
    Branch,
    Cast,
    Constraint,
    Counter,
    Functor,
    IterationCounter,
    Literal,
    Negation,
    Number,
    Record,
    String,
    Truth,
    Unnamed,
    UserFunctor,
    Variable,
)  # fmt: skip
from rosarch.datalog.language.tree import PRECEDENCE, PREFIX_PRECEDENCE
from rosarch.datalog.language.types import Types
from rosarch.datalog.language.values import show_float

_ESCAPED = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t"}
_SPECIAL = re.compile(r'["\\\n\r\t]')
_COPY = re.compile(r"\+[wc][0-9]+$|^\+(?=result)")


def quote(text: str) -> str:
    """A symbol as a string constant."""
    return '"' + _SPECIAL.sub(lambda m: _ESCAPED[m[0]], text) + '"'


def show_term(value: Any, type_name: str, types: Types) -> str:
    """A value as the term that denotes it: symbols quoted."""
    if isinstance(value, str):
        return quote(value)
    if value is None:
        return "nil"
    if isinstance(value, float):
        return show_float(value)
    if not isinstance(value, tuple):
        return str(value)
    found = types.root(type_name) if types.exists(type_name) else None
    if found is not None and found.kind == "+":
        fields = dict(found.branches)[value[0]]
        return f"${value[0]}({_terms(value[1:], fields, types)})"
    fields = found.fields if found is not None and found.kind == "r" else ("",) * len(value)
    return f"[{_terms(value, fields, types)}]"


def _terms(values: Sequence[Any], type_names: Sequence[str], types: Types) -> str:
    return ", ".join(show_term(v, t, types) for v, t in zip(values, type_names, strict=True))


def show_row(name: str, values: Sequence[Any], type_names: Sequence[str], types: Types) -> str:
    """A row as an atom: `edge("a", "b")`."""
    return f"{name}({_terms(values, type_names, types)})"


def show_name(variable: str) -> str:
    """The name of a variable; copies that the engine makes of one are primed."""
    return _COPY.sub(lambda m: "'" if m[0] != "+" else "", variable)


@dataclass(frozen=True)
class Writer:
    """Writes the literals of one clause, variables with a value replaced by it."""

    types: Types
    clause_types: ClauseTypes
    values: Mapping[str, Any] = field(default_factory=dict)
    aggregates: Mapping[int, str] = field(default_factory=dict)  # the values of some, by identity

    def value(self, variable: str) -> str:
        """The value of a variable."""
        found = self.clause_types.sets.get(variable)
        return show_term(self.values[variable], next(iter(sorted(found)), "") if found else "", self.types)

    def literal(self, literal: Literal) -> str:
        """A literal."""
        match literal:
            case Atom():
                return f"{literal.name}({self._list(literal.args)})"
            case Negation():
                return f"!{self.literal(literal.atom)}"
            case Truth():
                return "true" if literal.value else "false"
            case Constraint() if literal.op.endswith(("match", "contains")):
                return f"{literal.op}({self.term(literal.left)}, {self.term(literal.right)})"
            case Constraint():
                return f"{self.term(literal.left)} {literal.op} {self.term(literal.right)}"

    def term(self, term: Argument, outside: int = 0) -> str:
        """A term; in parentheses when an operator around it binds more strongly than its own."""
        match term:
            case Variable():
                return self.value(term.name) if term.name in self.values else show_name(term.name)
            case Unnamed():
                return "_"
            case String():
                return quote(term.value)
            case Number():
                return term.text + ("u" if term.kind == "u" else "")
            case Counter():
                return "autoinc()"
            case IterationCounter():
                return "recursive_iteration_cnt()"
            case Record():
                return f"[{self._list(term.args)}]"
            case Branch():
                return f"${term.name}({self._list(term.args)})"
            case UserFunctor():
                return f"@{term.name}({self._list(term.args)})"
            case Cast():
                return f"as({self.term(term.arg)}, {term.type})"
            case Functor():
                return self._functor(term, outside)
            case Aggregate():
                return self.aggregates.get(id(term)) or self.aggregate(term)
            case _:
                return "nil"

    def aggregate(self, term: Aggregate) -> str:
        """An aggregate."""
        target = f" {self.term(term.target)}" if term.target is not None else ""
        return f"{term.op}{target} : {{ {self.body(term.body)} }}"

    def body(self, body: Sequence[Literal]) -> str:
        """A conjunction."""
        return ", ".join(self.literal(literal) for literal in body)

    def _list(self, terms: Sequence[Argument]) -> str:
        return ", ".join(self.term(t) for t in terms)

    def _functor(self, term: Functor, outside: int) -> str:
        if term.op in PRECEDENCE and len(term.args) == 2:
            power = PRECEDENCE[term.op]
            left, right = (self.term(a, power + (i if term.op != "^" else 1 - i)) for i, a in enumerate(term.args))
            text = f"{left} {term.op} {right}"
            return f"({text})" if power < outside else text
        if term.op in ("neg", "bnot", "lnot"):
            sign = "-" if term.op == "neg" else f"{term.op} "
            return f"{sign}{self.term(term.args[0], PREFIX_PRECEDENCE)}"
        return f"{term.op}({self._list(term.args)})"
