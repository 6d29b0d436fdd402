"""Expressions of Python launch files, interpreted over their syntax trees.

What is not known gives an `Unknown`, never an exception; what Python would reject raises `Raised`. Steps and sizes are bounded.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from typing import Any

from rosarch.extractor.launch.eval_functions import BUILTINS, METHODS, TooLarge, format_text, size_of
from rosarch.extractor.launch.evaluation import BINARY, CONVERSIONS, PYTHON_ERRORS, UNARY, check_size
from rosarch.extractor.launch.formulas import Every, Not, Some
from rosarch.extractor.launch.model import Condition, Place
from rosarch.extractor.launch.unknowns import cleaned, is_known
from rosarch.extractor.launch_ros2.decisions import Decisions, holds_several, is_certain, is_object, source_of
from rosarch.extractor.launch_ros2.values import (
    NOTHING,
    Either,
    Frame,
    Function,
    Installed,
    Instance,
    Made,
    PathText,
    Several,
    TextFile,
    Unknown,
    Written,
)
from rosarch.extractor.urdf.document import Element

MAX_STEPS = 5_000_000
_SIZE_COST = 64
_MAKING = (ast.BinOp, ast.JoinedStr, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)  # what may make something large
_OPEN = (Unknown, Either)
_TEXTS = (str, *_OPEN)


class Stopped(Exception):
    """The interpretation takes too long, or nests too deeply."""


class Undecided(Exception):
    """Too much depends on what is not known."""


class Raised(Exception):
    """What the launch file does raises an exception in Python; not `certain` where only what stands for a function here does."""

    def __init__(self, kind: str, message: str, place: Place | None = None, *, certain: bool = True) -> None:
        super().__init__(message)
        self.kind, self.message, self.place, self.certain = kind, message, place, certain


class Expressions(Decisions):
    """The values of expressions. `file` and `path` say where interpretation is, and under which unknown conditions."""

    def __init__(self) -> None:
        self.steps = 0
        self.path: list[Condition] = []
        self._method: dict[type[ast.AST], Callable[[Any, Frame], Any] | None] = {}

    def method_for(self, node: ast.expr | ast.stmt) -> Callable[[Any, Frame], Any] | None:
        """What interprets nodes of this kind, if anything does."""
        kind = type(node)
        if kind not in self._method:
            self._method[kind] = getattr(self, f"{'_do_' if issubclass(kind, ast.stmt) else '_'}{kind.__name__.lower()}", None)
        return self._method[kind]

    def step(self, count: int = 1) -> None:
        """Count work that was done."""
        self.steps += count
        if self.steps > MAX_STEPS:
            raise Stopped("too many steps")

    def value(self, node: ast.expr, frame: Frame) -> Any:
        """The value of any expression."""
        self.step()
        method = self.method_for(node)
        if method is None:
            return self.unknown(node, frame, f"{type(node).__name__} is not interpreted")
        try:
            found = method(node, frame)
            return self.weighed(found) if isinstance(node, _MAKING) else found
        except TooLarge as error:
            return self.unknown(node, frame, str(error))
        except PYTHON_ERRORS as error:
            certain = not isinstance(node, ast.Call)
            raise Raised(type(error).__name__, str(error), self.place(node, frame), certain=certain) from None

    def weighed(self, value: Any) -> Any:
        """A value that was made, its size counted as work."""
        if isinstance(value, (str, list, dict, tuple, set, int)):
            self.step(size_of(value) // _SIZE_COST)
        return value

    # -- atoms ----------------------------------------------------------------------------------------------------------------

    def _constant(self, node: ast.Constant, _frame: Frame) -> Any:
        return cleaned(node.value) if isinstance(node.value, str) else node.value

    def _name(self, node: ast.Name, frame: Frame) -> Any:
        here: Frame | None = frame
        while here is not None:
            if node.id in here.variables:
                found = here.variables[node.id]
                return self.unknown(node, frame) if found is NOTHING else found
            here = here.above
        if node.id in frame.module.variables:
            return frame.module.variables[node.id]
        return self.builtin(node, frame)

    def builtin(self, node: ast.Name, frame: Frame) -> Any:
        """A name that no frame has."""
        if node.id in BUILTINS:
            return BUILTINS[node.id]
        return self.unknown(node, frame)

    def _joinedstr(self, node: ast.JoinedStr, frame: Frame) -> Any:
        parts = [self.value(part, frame) for part in node.values]
        return "".join(parts) if all(isinstance(part, str) for part in parts) else self.unknown(node, frame)

    def _formattedvalue(self, node: ast.FormattedValue, frame: Frame) -> Any:
        value = self.value(node.value, frame)
        value = value.text if isinstance(value, PathText) else value
        if node.conversion == -1 and node.format_spec is None and isinstance(value, str):
            return value
        if value is None:
            return self.text_of_none(node.value, frame)
        if not is_certain(value):
            return self.text(value) if isinstance(value, (Unknown, Either)) else self.text(self.unknown(node.value, frame))
        spec = "" if node.format_spec is None else self.value(node.format_spec, frame)
        return METHODS[str]["format"]("{:" + spec + "}", CONVERSIONS[node.conversion](value)) if isinstance(spec, str) else spec

    def _list(self, node: ast.List, frame: Frame) -> Any:
        return list(self._items(node.elts, frame))

    def _tuple(self, node: ast.Tuple, frame: Frame) -> Any:
        written = Written(self._items(node.elts, frame))
        written.place = self.place(node, frame)
        return written

    def _set(self, node: ast.Set, frame: Frame) -> Any:
        return set(self._items(node.elts, frame))

    def _items(self, nodes: list[ast.expr], frame: Frame) -> Iterator[Any]:
        for node in nodes:
            if isinstance(node, ast.Starred):
                yield from self.added(self.value(node.value, frame), node.value, frame)
            else:
                yield self.value(node, frame)

    def _dict(self, node: ast.Dict, frame: Frame) -> Any:
        found: dict[Any, Any] = {}
        for key, value in zip(node.keys, node.values, strict=True):
            if key is not None:
                found[self.value(key, frame)] = self.value(value, frame)
            else:
                found.update(self.entries(self.value(value, frame), found))
        return found

    def entries(self, value: Any, owner: dict[Any, Any]) -> Iterator[tuple[Any, Any]]:
        """What a value adds to a map, key by key; what is not known may also replace anything that is there."""
        if isinstance(value, dict):
            for key in value:
                yield from _replaced(key, owner) if isinstance(key, Unknown) else ()
            yield from value.items()
        elif isinstance(value, Either):
            first, second = ({**owner, **dict(self.entries(one, owner))} for one in (value.first, value.second))
            for key in {**first, **second}:
                yield key, either(value.condition, first.get(key, NOTHING), second.get(key, NOTHING))
        elif isinstance(value, (list, tuple)) and all(isinstance(pair, (list, tuple)) and len(pair) == 2 for pair in value):
            yield from value
        elif value is not NOTHING:
            more = value if isinstance(value, Unknown) else Unknown("?", Place("", 1))
            yield from (*_replaced(more, owner), (more, more))

    def iterated(self, value: Any, node: ast.expr, frame: Frame) -> list[Any]:
        """The items of a value; a single unknown one where these cannot be determined."""
        if isinstance(value, (list, tuple, set, dict, range, str)) and (not isinstance(value, str) or is_known(value)):
            return list(value)
        if isinstance(value, TextFile) and value.text is not None and is_known(value.text):
            return value.text.splitlines(keepends=True)
        if isinstance(value, Element):
            return list(value.elements())
        if isinstance(value, (Unknown, Either, TextFile, Made, Instance, Installed, str)):
            return [Several(f"each of {source_of(node)}", self.place(node, frame))]
        raise Raised("TypeError", f"'{type(value).__name__}' object is not iterable", self.place(node, frame))

    def added(self, value: Any, node: ast.expr, frame: Frame) -> list[Any]:
        """The items that a list gets by `*value` or `+= value`."""
        return self.spread(value) if isinstance(value, Either) else self.iterated(value, node, frame)

    def spread(self, value: Any) -> list[Any]:
        """What a value adds to a list: of one of two lists, each item where it is this list; what is not known, as one."""
        if isinstance(value, Either):
            return [either(condition, item, NOTHING) for condition, one in value.alternatives() for item in self.spread(one)]
        if value is NOTHING:
            return []
        return list(value) if isinstance(value, (list, tuple, set, dict)) else [value]

    # -- operators ------------------------------------------------------------------------------------------------------------

    def _binop(self, node: ast.BinOp, frame: Frame) -> Any:
        left, right = self.value(node.left, frame), self.value(node.right, frame)
        return self.operation(node.op, left, right, node, frame)

    def operation(self, op: ast.operator, left: Any, right: Any, node: ast.expr, frame: Frame) -> Any:
        """The value of a binary operation."""
        if isinstance(op, ast.Div) and isinstance(left, PathText) and isinstance(right, (str, PathText)):
            return left.joined(right.text if isinstance(right, PathText) else right)
        if isinstance(op, ast.Div) and isinstance(left, Made):
            return Made("PathJoinSubstitution", {"substitutions": [left, right]}, self.place(node, frame))
        if isinstance(op, ast.Add):
            if isinstance(left, str) and isinstance(right, str):
                return left + right
            if (isinstance(left, list) and isinstance(right, list)) or (isinstance(left, tuple) and isinstance(right, tuple)):
                return [*left, *right] if isinstance(left, list) else (*left, *right)
            if left is None and isinstance(right, str):
                return self.text(self.unknown(node.left if isinstance(node, ast.BinOp) else node, frame)) + right
            if right is None and isinstance(left, str):
                return left + self.text(self.unknown(node.right if isinstance(node, ast.BinOp) else node, frame))
            if isinstance(left, str) != isinstance(right, str) and isinstance(left, _TEXTS) and isinstance(right, _TEXTS):
                return self.text(left) + self.text(right)
            if (isinstance(left, list) and isinstance(right, _OPEN)) or (isinstance(left, _OPEN) and isinstance(right, list)):
                return [*self.spread(left), *self.spread(right)]
        if isinstance(op, ast.Mod) and isinstance(left, str) and is_known(left) and is_certain(right):
            return format_text(left, right)
        function = BINARY.get(type(op))
        if function is None or not (is_certain(left) and is_certain(right)) or is_object(left) or is_object(right):
            return self.unknown(node, frame)
        check_size(op, left, right)
        return function(left, right)

    def _unaryop(self, node: ast.UnaryOp, frame: Frame) -> Any:
        value = self.value(node.operand, frame)
        if isinstance(node.op, ast.Not):
            truth = self.truth(value)
            return self.undecided(node, frame, Not(self.formula(value))) if truth is None else not truth
        return UNARY[type(node.op)](value) if is_certain(value) else self.unknown(node, frame)

    def _boolop(self, node: ast.BoolOp, frame: Frame) -> Any:
        depth = len(self.path)
        try:
            return self._joined_truth(node, frame)
        finally:
            del self.path[depth:]

    def _joined_truth(self, node: ast.BoolOp, frame: Frame) -> Any:
        wanted, parts = isinstance(node.op, ast.Or), []
        found: Any = None
        for operand in node.values:
            found = self.value(operand, frame)
            truth = self.truth(found)
            if truth is None:
                condition = self.condition(operand, found, frame)
                parts.append(condition.value)
                self.path.append(condition.contrary() if wanted else condition)  # otherwise the next ones are not asked
            if truth is wanted:
                break
        if not parts or (truth is wanted and isinstance(found, bool)):
            return found
        return self.unknown(node, frame) if truth is wanted else self.undecided(node, frame, (Some if wanted else Every)(tuple(parts)))

    def _compare(self, node: ast.Compare, frame: Frame) -> Any:
        left = self.value(node.left, frame)
        for operation, operand in zip(node.ops, node.comparators, strict=True):
            right = self.value(operand, frame)
            result = self.compared(operation, left, right)
            if result is None:
                means = self.meaning(operation, left, right) if len(node.ops) == 1 else None
                return self.unknown(node, frame) if means is None else self.undecided(node, frame, means)
            if not result:
                return False
            left = right
        return True

    def _ifexp(self, node: ast.IfExp, frame: Frame) -> Any:
        test = self.value(node.test, frame)
        truth = self.truth(test)
        if truth is not None:
            return self.value(node.body if truth else node.orelse, frame)
        condition = self.condition(node.test, test, frame)
        return either(condition, self._under(condition, node.body, frame), self._under(condition.contrary(), node.orelse, frame))

    def _under(self, condition: Condition, node: ast.expr, frame: Frame) -> Any:
        self.path.append(condition)
        try:
            return self.value(node, frame)
        finally:
            self.path.remove(condition)

    def _namedexpr(self, node: ast.NamedExpr, frame: Frame) -> Any:
        frame.variables[node.target.id] = found = self.value(node.value, frame)
        return found

    def _await(self, node: ast.Await, frame: Frame) -> Any:
        return self.value(node.value, frame)

    # -- parts ----------------------------------------------------------------------------------------------------------------

    def _subscript(self, node: ast.Subscript, frame: Frame) -> Any:
        value = self.value(node.value, frame)
        if isinstance(value, (Unknown, Either)) or not isinstance(value, (str, list, tuple, dict, range)):
            return self.item(value, node, frame)
        key = self.value(node.slice, frame)
        if not is_certain(key) or (isinstance(value, str) and not is_known(value)) or holds_several(value):
            return self.unknown(node, frame)
        try:
            found = value[key]
        except (LookupError, TypeError) as error:
            if self.is_widened(value):
                return self.unknown(node, frame)
            raise Raised(type(error).__name__, str(error), self.place(node, frame)) from None
        return self.unknown(node, frame) if found is NOTHING else found

    def item(self, _value: Any, node: ast.Subscript, frame: Frame) -> Any:
        """`value[key]` of what is no list, map or text."""
        return self.unknown(node, frame)

    def _slice(self, node: ast.Slice, frame: Frame) -> Any:
        return slice(*(None if part is None else self.value(part, frame) for part in (node.lower, node.upper, node.step)))

    def _lambda(self, node: ast.Lambda, frame: Frame) -> Any:
        return self.function(node, frame)

    def function(self, node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda, frame: Frame) -> Function:
        """A function, its defaults evaluated."""
        defaults = tuple(self.value(default, frame) for default in node.args.defaults)
        pairs = zip(node.args.kwonlyargs, node.args.kw_defaults, strict=True)
        return Function(node, frame, defaults, {arg.arg: self.value(default, frame) for arg, default in pairs if default is not None})

    # -- comprehensions -------------------------------------------------------------------------------------------------------

    def _listcomp(self, node: ast.ListComp, frame: Frame) -> Any:
        return list(self._generated(node.generators, frame, lambda inner: self.value(node.elt, inner)))

    def _generatorexp(self, node: ast.GeneratorExp, frame: Frame) -> Any:
        return list(self._generated(node.generators, frame, lambda inner: self.value(node.elt, inner)))

    def _setcomp(self, node: ast.SetComp, frame: Frame) -> Any:
        return set(self._generated(node.generators, frame, lambda inner: self.value(node.elt, inner)))

    def _dictcomp(self, node: ast.DictComp, frame: Frame) -> Any:
        return dict(self._generated(node.generators, frame, lambda inner: (self.value(node.key, inner), self.value(node.value, inner))))

    def _generated(self, generators: list[ast.comprehension], frame: Frame, made: Callable[[Frame], Any]) -> Iterator[Any]:
        if not generators:
            yield made(frame)
            return
        first, *rest = generators
        for item in self.iterated(self.value(first.iter, frame), first.iter, frame):
            self.step()
            inner = Frame({}, frame.module, frame)
            self.assign(first.target, item, inner)
            tests = [(test, self.value(test, inner)) for test in first.ifs]
            if any(self.truth(value) is False for _, value in tests):
                continue
            unsure = [self.condition(test, value, frame) for test, value in tests if self.truth(value) is None]
            for found in self._generated(rest, inner, made):
                for condition in unsure:
                    found = either(condition, found, NOTHING)
                yield found

    def text_of_none(self, node: ast.expr, frame: Frame) -> str:
        """`None` as a part of a text."""
        raise NotImplementedError

    def assign(self, target: ast.expr, value: Any, frame: Frame) -> None:
        """Bind names, items or attributes to a value."""
        raise NotImplementedError


def _replaced(more: Unknown, owner: dict[Any, Any]) -> list[tuple[Any, Any]]:
    """What is in a map, when `more` is added to it, which may replace each."""
    return [(key, Unknown(f"{key} of {more.text}", more.place)) for key in owner if isinstance(key, str)]


def either(condition: Condition, first: Any, second: Any) -> Any:
    """One of two values; the value itself when they are the same."""
    if first is second or (
        type(first) is type(second) and isinstance(first, (str, int, float, list, dict, tuple)) and _equal(first, second)
    ):
        return first
    return Either(condition, first, second)


def _equal(first: Any, second: Any) -> bool:
    return is_certain(first) and is_certain(second) and not is_object(first) and bool(first == second)
