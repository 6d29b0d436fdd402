"""Whether what Python launch files ask is so; what is not known is a condition."""

from __future__ import annotations

import ast
from typing import Any

from rosarch.base.diagnostics import shortened
from rosarch.extractor.launch import decisions
from rosarch.extractor.launch.evaluation import COMPARE
from rosarch.extractor.launch.formulas import FALSE, TRUE, Formula, Not, Test, bounded, choice, equals
from rosarch.extractor.launch.model import Condition, Place
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch_ros2.values import NOTHING, Either, Frame, Installed, Native, PathText, Several, Unknown, installed

MAX_PARTS = 100_000
"""Of a value that is looked at as a whole: what lists share counts each time, as in the text that would be made of it."""


class Decisions:
    """Truth, comparisons and conditions of values that may be unknown. A map with an unknown key may have any other, too."""

    asked_at: Place | None = None
    """Where a launch file calls the helper that is interpreted."""

    def place(self, node: ast.AST, frame: Frame) -> Place:
        """Where a piece of source is; of a helper's, where the launch file calls that: nobody has the source that rosarch has of it."""
        if frame.module.is_helper and self.asked_at is not None:
            return self.asked_at
        return Place(frame.module.file, getattr(node, "lineno", 1), getattr(node, "col_offset", 0) + 1)

    def unknown(self, node: ast.expr, frame: Frame, reason: str = "") -> Unknown:
        """The value of an expression that cannot be determined."""
        return Unknown(source_of(node), self.place(node, frame), reason)

    def is_widened(self, owner: Any) -> bool:
        """Whether a map may have keys that are not known."""
        return isinstance(owner, dict) and any(isinstance(key, Unknown) for key in owner)

    def truth(self, value: Any) -> bool | None:
        """Whether a value counts as true; None when that is not known."""
        if isinstance(value, (Unknown, Either)) or (isinstance(value, str) and not is_known(value)):
            return None
        if isinstance(value, (list, tuple)) and value and all(isinstance(item, Several) for item in value):
            return None
        return True if is_object(value) else bool(value)

    def text(self, value: Any) -> str:
        """An unknown as a part of a text."""
        raise NotImplementedError

    def installs(self, package: str) -> bool:
        """Whether a package is certainly there where launch runs."""
        raise NotImplementedError

    def has_variable(self, name: str) -> bool:
        """Whether an environment variable is set where launch runs."""
        raise NotImplementedError

    def compared(self, operation: ast.cmpop, left: Any, right: Any) -> bool | None:
        """Whether one comparison holds; None when that is not known."""
        if isinstance(right, Installed):
            there = isinstance(left, str) and isinstance(operation, (ast.In, ast.NotIn)) and self.installs(left)
            return isinstance(operation, ast.In) if there else None
        if isinstance(right, Native) and isinstance(operation, (ast.In, ast.NotIn)):
            named = right.name == "os.environ" and isinstance(left, str) and is_known(left)
            return self.has_variable(left) is isinstance(operation, ast.In) if named else None
        if isinstance(left, (Unknown, Either)) or isinstance(right, (Unknown, Either)):
            return None
        if isinstance(operation, (ast.In, ast.NotIn)) and is_object(left) and isinstance(right, (list, tuple)) and is_certain(right):
            return any(left is one or left == one for one in right) is isinstance(operation, ast.In)
        if (
            isinstance(operation, (ast.Is, ast.IsNot))
            or is_object(left)
            or (is_object(right) and not isinstance(operation, (ast.In, ast.NotIn)))
        ):
            same = left is right or (isinstance(left, PathText) and left == right)
            return same if isinstance(operation, (ast.Is, ast.Eq)) else not same if isinstance(operation, (ast.IsNot, ast.NotEq)) else None
        if isinstance(operation, (ast.Eq, ast.NotEq)) and isinstance(left, str) and left == right:
            return isinstance(operation, ast.Eq)
        if isinstance(operation, (ast.In, ast.NotIn)) and isinstance(right, dict) and is_certain(left):
            return None if left not in right and self.is_widened(right) else (left in right) is isinstance(operation, ast.In)
        if not (is_certain(left) and is_certain(right)):
            return None
        return bool(COMPARE[type(operation)](left, right))

    def meaning(self, operation: ast.cmpop, left: Any, right: Any) -> Formula | None:
        """When a comparison holds, as far as it is understood."""
        if isinstance(left, Either):
            first, second = (self.meaning(operation, one, right) for one in (left.first, left.second))
            return None if first is None or second is None else choice(left.condition.formula, first, second)
        if isinstance(right, Installed) and isinstance(left, str) and is_known(left):
            return Test(installed(left)) if isinstance(operation, ast.In) else Not(Test(installed(left)))
        known = self.compared(operation, left, right)
        if known is not None:
            return TRUE if known else FALSE
        return decisions.compared(operation, self._subject(left), self._subject(right))

    def condition(self, test: ast.expr, value: Any, frame: Frame) -> Condition:
        """A condition of the launch file, whose value cannot be known."""
        return Condition(source_of(test), True, self.place(test, frame), self.formula(value))

    def undecided(self, node: ast.expr, frame: Frame, means: Formula) -> Unknown:
        """The value of a Boolean expression that cannot be determined."""
        text = source_of(node)
        return Unknown(text, self.place(node, frame), truth=bounded(means, text))

    def formula(self, value: Any) -> Formula:
        """When a value counts as true."""
        if isinstance(value, Either):
            means = choice(value.condition.formula, self.formula(value.first), self.formula(value.second))
            return bounded(means, self.text(value))
        if isinstance(value, Unknown):
            return value.truth or Test(self.text(value), opaque=True)
        if isinstance(value, str) and not is_known(value):
            return Not(equals(value, ""))
        return TRUE if self.truth(value) else FALSE

    def _subject(self, value: Any) -> Any:
        """What a comparison is about: an unknown as a text."""
        return self.text(value) if isinstance(value, Unknown) else value


def holds_several(value: Any) -> bool:
    """Whether it is not known how many items a list has: each of another that is not known, or one that may not be there."""
    return isinstance(value, (list, tuple)) and any(isinstance(item, Several) or _may_be_missing(item) for item in value)


def _may_be_missing(item: Any) -> bool:
    return item is NOTHING or (isinstance(item, Either) and (_may_be_missing(item.first) or _may_be_missing(item.second)))


def is_certain(value: Any) -> bool:
    """Whether a value has nothing unknown in it, and is not too large to look: lists may hold each other, and themselves."""
    stack, parts = [value], 0
    while stack:
        item = stack.pop()
        parts += 1
        if parts > MAX_PARTS:
            return False
        if isinstance(item, (Unknown, Either)) or item is NOTHING or (isinstance(item, str) and not is_known(item)):
            return False
        if isinstance(item, (list, tuple, set)):
            stack.extend(item)
        elif isinstance(item, dict):
            stack.extend((*item.keys(), *item.values()))
        elif isinstance(item, PathText):
            stack.append(item.text)
    return True


def is_object(value: Any) -> bool:
    """Whether a value is none of Python's plain ones."""
    return not (value is None or isinstance(value, (bool, int, float, str, bytes, list, tuple, set, dict, range, slice)))


def source_of(node: ast.expr) -> str:
    """The text of an expression, shortened."""
    return shortened(ast.unparse(node), 80)
