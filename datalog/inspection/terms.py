"""The terms and conditions of one clause, computed outside of an evaluation."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rosarch.datalog.engine.expressions import Expressions
from rosarch.datalog.engine.runtime import State, full_match, names
from rosarch.datalog.language.inference import ClauseTypes
from rosarch.datalog.language.syntax import (
    Argument,
    Branch,
    Constraint,
    Counter,
    Functor,
    IterationCounter,
    Literal,
    Record,
    Unnamed,
    UserFunctor,
    Variable,
    walk,
)  # fmt: skip
from rosarch.datalog.language.types import Types

Bound = dict[str, Any]


class _Python(dict[str, str]):
    """Every variable as an entry of the binding `b`."""

    def __missing__(self, name: str) -> str:
        return f"b[{name!r}]"


def opaque(term: Argument | Literal) -> bool:
    """Whether a value depends on the course of an evaluation or on functions from outside, and so cannot be computed again."""
    return any(isinstance(n, (Counter, IterationCounter, UserFunctor)) or (isinstance(n, Functor) and n.op == "ord") for n in walk(term))


class Terms:
    """Computes terms and conditions of one clause; each is compiled once."""

    def __init__(self, types: Types, clause_types: ClauseTypes) -> None:
        self.matchers: dict[str, str] = {}
        self.expressions = Expressions(types, clause_types, self.matchers)
        self.names: dict[str, Any] = {**names(types.bits), "S": State()}
        self.compiled: dict[int, tuple[Any, Callable[[Bound], Any]]] = {}

    def _compiled(self, node: Any, text: Callable[[], str]) -> Callable[[Bound], Any]:
        found = self.compiled.get(id(node))
        if found is None:
            source = text()
            for pattern, name in self.matchers.items():
                self.names.setdefault(name, full_match(pattern))
            found = self.compiled[id(node)] = (node, eval(f"lambda b: {source}", self.names))
        return found[1]

    def value(self, term: Argument, bound: Bound) -> Any:
        """The value of a term whose variables are bound."""
        if isinstance(term, Variable):
            return bound[term.name]
        return self._compiled(term, lambda: self.expressions.write(term, _Python()))(bound)

    def holds(self, constraint: Constraint, bound: Bound) -> bool:
        """Whether a constraint holds."""
        return bool(self._compiled(constraint, lambda: self.expressions.condition(constraint, _Python()))(bound))

    def unify(self, pattern: Argument, value: Any, bound: Bound) -> bool:
        """Bind the free variables of a pattern so that it has a value; false when it cannot."""
        match pattern:
            case Unnamed():
                return True
            case Variable():
                if pattern.name in bound:
                    return bool(bound[pattern.name] == value)
                bound[pattern.name] = value
                return True
            case Record():
                return value is not None and all(self.unify(a, v, bound) for a, v in zip(pattern.args, value, strict=True))
            case Branch():
                return bool(value[0] == pattern.name) and all(self.unify(a, v, bound) for a, v in zip(pattern.args, value[1:], strict=True))
            case _:
                return bool(self.value(pattern, bound) == value)
