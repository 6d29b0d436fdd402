"""Python expressions that depend on what is not known, as formulas over that."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable
from typing import Any

from rosarch.extractor.launch.eval_functions import TooLarge
from rosarch.extractor.launch.evaluation import MAX_LENGTH, EvalFailed, Evaluator, UnknownInvolved, Unsupported, is_known_value, parsed_once
from rosarch.extractor.launch.formulas import FALSE, TRUE, Every, Formula, Not, Some, Test, bounded, equals
from rosarch.extractor.launch.unknowns import marks_in

_BARE = re.compile(r"'(?:[^'\\]|\\.)*'|\"(?:[^\"\\]|\\.)*\"|[\U00100000-\U0010ffff]")
_NAME = re.compile(r"_unknown_([0-9a-f]+)")


def decision(expression: str, evaluator: Evaluator) -> Formula:
    """When an expression is true."""
    try:
        found = _Decision(evaluator).of(parsed_once(expression[:MAX_LENGTH].strip(" \t")).body)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return Test(expression, opaque=True)
    return bounded(found, expression)


def text_decision(expression: str, evaluator: Callable[[Callable[[str], Any]], Evaluator]) -> Formula:
    """The same for one whose text has unknown parts; one outside of quotes stands for a Boolean or number."""
    named = _BARE.sub(lambda found: found[0] if len(found[0]) > 1 else f"_unknown_{ord(found[0]):x}", expression)
    return decision(named, evaluator(_mark_of))


def _mark_of(name: str) -> str:
    found = _NAME.fullmatch(name)
    if found is None:
        raise KeyError(name)
    return chr(int(found[1], 16))


class _Decision:
    """Walks an expression."""

    def __init__(self, evaluator: Evaluator) -> None:
        self.evaluator = evaluator

    def of(self, node: ast.expr) -> Formula:
        """When a part of the expression is true."""
        if isinstance(node, ast.BoolOp):
            parts = tuple(map(self.of, node.values))
            return Every(parts) if isinstance(node.op, ast.And) else Some(parts)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            return Not(self.of(node.operand))
        if isinstance(node, ast.Compare) and len(node.ops) == 1:
            found = compared(node.ops[0], self.value(node.left), self.value(node.comparators[0]))
            return self.opaque(node) if found is None else found
        value = self.value(node)
        if is_certain(value):
            return TRUE if value else FALSE
        return Test(value) if isinstance(node, ast.Name | ast.Call) and isinstance(value, str) else self.opaque(node)

    def opaque(self, node: ast.expr) -> Formula:
        """A part that is not understood, by its text and what it is about."""
        names = sorted({one.id for one in ast.walk(node) if isinstance(one, ast.Name)})
        known = [str(self.value(ast.Name(name, ast.Load()))) for name in names]
        return Test(f"{ast.unparse(node)} {' '.join(known)}", opaque=True)

    def value(self, node: ast.expr) -> Any:
        """The value of a part, with its unknown parts; `...` when there is none."""
        try:
            return self.evaluator.value(node)
        except (EvalFailed, Unsupported, UnknownInvolved, TooLarge):
            return ...


def is_certain(value: Any) -> bool:
    """Whether a value is a known number, text or Boolean."""
    return isinstance(value, bool | int | float | str) and is_known_value(value)


def compared(operation: ast.cmpop, left: Any, right: Any) -> Formula | None:
    """When a comparison holds; None when it is none of a text with unknown parts and known values."""
    if isinstance(operation, ast.NotEq | ast.NotIn):
        found = compared(ast.Eq() if isinstance(operation, ast.NotEq) else ast.In(), left, right)
        return None if found is None else Not(found)
    if isinstance(operation, ast.In) and isinstance(left, str) and isinstance(right, list | tuple | set | dict):
        return Some(tuple(equals(left, value) for value in right)) if all(map(is_certain, right)) else None
    if isinstance(operation, ast.Eq):
        subject, value = (left, right) if is_certain(right) else (right, left)
        if isinstance(subject, str) and marks_in(subject) and is_certain(value):
            return equals(subject, value)
    return None
