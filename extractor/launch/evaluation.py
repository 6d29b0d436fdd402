"""`$(eval ...)`: a Python expression, evaluated without Python's `eval`.

The expression is parsed and walked; only what is listed here happens. roslaunch hands the expression to Python, so a launch file may use
more; what is not listed here is `Unsupported` and the text stays unknown. Time and memory are bounded: steps, sizes of texts and numbers.
"""

from __future__ import annotations

import ast
import builtins
import operator
import warnings
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from typing import Any

from rosarch.extractor.launch.eval_functions import BUILTINS, MATH, METHODS, TooLarge, format_text, size_of
from rosarch.extractor.launch.unknowns import cleaned, is_known

MAX_LENGTH = 10_000
MAX_STEPS = 100_000

Function = Callable[..., Any]


class EvalFailed(Exception):
    """Python would reject this expression as well."""


class Unsupported(Exception):
    """An expression that only Python itself could evaluate."""


class UnknownInvolved(Exception):
    """The value depends on something unknown."""


BINARY: dict[type[ast.operator], Function] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    ast.LShift: operator.lshift,
    ast.RShift: operator.rshift,
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
}
UNARY: dict[type[ast.unaryop], Function] = {
    ast.Not: operator.not_,
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
    ast.Invert: operator.invert,
}
COMPARE: dict[type[ast.cmpop], Function] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
    ast.In: lambda item, container: item in container,
    ast.NotIn: lambda item, container: item not in container,
}
PYTHON_ERRORS = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)


def evaluate(expression: str, lookup: Callable[[str], Any], functions: Mapping[str, Function]) -> Any:
    """The value of `expression`.

    Args:
        expression: Python text.
        lookup: the value of a name that is no function or constant; raises `KeyError` for one that does not exist.
        functions: what may be called in addition to Python's own, which it hides.

    Raises:
        EvalFailed: it is no expression, or it fails.
        Unsupported: it uses what is not evaluated here, or it is too large.
        UnknownInvolved: it depends on a text with unknown parts.
    """
    return Evaluator(lookup, functions).evaluate(expression)


@lru_cache(maxsize=4096)
def parsed_once(expression: str) -> ast.Expression:
    """The tree of an expression that is only read: the same one is often evaluated many times."""
    return _parsed(expression)


def _parsed(expression: str) -> ast.Expression:
    """The tree of an expression, without Python's warnings (of an escape that is none, which it takes as it is written)."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return ast.parse(expression, mode="eval")


class Evaluator:
    """Walks expressions; `steps` says how much work that was."""

    def __init__(self, lookup: Callable[[str], Any], functions: Mapping[str, Function]) -> None:
        self.lookup, self.functions = lookup, functions
        self.steps = 0
        self.local: dict[str, Any] = {}

    def evaluate(self, expression: str) -> Any:
        """The value of an expression; see the function `evaluate`."""
        if len(expression) > MAX_LENGTH:
            raise Unsupported(f"more than {MAX_LENGTH} characters")
        try:
            return self.value(parsed_once(expression.lstrip(" \t")).body)
        except (SyntaxError, ValueError) as error:
            raise EvalFailed(error.msg if isinstance(error, SyntaxError) else str(error)) from None
        except (RecursionError, MemoryError):
            raise Unsupported("nested too deeply") from None
        except TooLarge as error:
            raise Unsupported(str(error)) from None

    def value(self, node: ast.expr) -> Any:
        """The value of any expression."""
        self.steps += 1
        if self.steps > MAX_STEPS:
            raise Unsupported("too many steps")
        method = getattr(self, "_" + type(node).__name__.lower(), None)
        if method is None:
            raise Unsupported(f"{type(node).__name__} is not evaluated")
        try:
            value = method(node)
        except PYTHON_ERRORS as error:
            raise EvalFailed(f"{type(error).__name__}: {error}") from None
        self.steps += size_of(value) // 16
        return value

    def known_value(self, node: ast.expr) -> Any:
        """The value of an expression that must have no unknown part."""
        value = self.value(node)
        if not is_known_value(value):
            raise UnknownInvolved
        return value

    def _constant(self, node: ast.Constant) -> Any:
        return cleaned(node.value) if isinstance(node.value, str) else node.value

    def _name(self, node: ast.Name) -> Any:
        return self.local[node.id] if node.id in self.local else self.named(node.id)

    def named(self, name: str) -> Any:
        """The value of a name."""
        if name in self.functions:
            return self.functions[name]
        if name in MATH:
            return MATH[name]
        try:
            return self.lookup(name)
        except KeyError:
            pass
        if name in BUILTINS:
            return BUILTINS[name]
        if name in _PYTHON_BUILTINS:
            raise Unsupported(f"`{name}` is not evaluated")
        raise EvalFailed(f"name '{name}' is not defined")

    def _binop(self, node: ast.BinOp) -> Any:
        left, right = self.value(node.left), self.value(node.right)
        if isinstance(node.op, ast.Add) and isinstance(left, str) and isinstance(right, str):
            return left + right
        if not (is_known_value(left) and is_known_value(right)):
            raise UnknownInvolved
        if isinstance(node.op, ast.Mod) and isinstance(left, str):
            return format_text(left, right)
        function = BINARY.get(type(node.op))
        if function is None:
            raise Unsupported(f"{type(node.op).__name__} is not evaluated")
        check_size(node.op, left, right)
        return function(left, right)

    def _unaryop(self, node: ast.UnaryOp) -> Any:
        return UNARY[type(node.op)](self.known_value(node.operand))

    def _boolop(self, node: ast.BoolOp) -> Any:
        wanted = isinstance(node.op, ast.Or)
        result: Any = None
        for operand in node.values:
            result = self.known_value(operand)
            if bool(result) is wanted:
                break
        return result

    def _compare(self, node: ast.Compare) -> Any:
        left, result = self.known_value(node.left), True
        for operation, operand in zip(node.ops, node.comparators, strict=True):
            right = self.known_value(operand)
            result = COMPARE[type(operation)](left, right)
            if not result:
                break
            left = right
        return result

    def _ifexp(self, node: ast.IfExp) -> Any:
        return self.value(node.body if self.known_value(node.test) else node.orelse)

    def _list(self, node: ast.List) -> Any:
        return [self.value(item) for item in node.elts]

    def _tuple(self, node: ast.Tuple) -> Any:
        return tuple(self.value(item) for item in node.elts)

    def _set(self, node: ast.Set) -> Any:
        return {self.value(item) for item in node.elts}

    def _dict(self, node: ast.Dict) -> Any:
        if None in node.keys:
            raise Unsupported("** is not evaluated")
        return {self.value(key): self.value(value) for key, value in zip(node.keys, node.values, strict=True) if key is not None}

    def _subscript(self, node: ast.Subscript) -> Any:
        return self.known_value(node.value)[self.known_value(node.slice)]

    def _slice(self, node: ast.Slice) -> Any:
        parts = [None if part is None else self.known_value(part) for part in (node.lower, node.upper, node.step)]
        return slice(*parts)

    def _joinedstr(self, node: ast.JoinedStr) -> Any:
        return "".join(self.value(part) for part in node.values)

    def _formattedvalue(self, node: ast.FormattedValue) -> Any:
        value = self.value(node.value)
        if node.conversion == -1 and node.format_spec is None and isinstance(value, str):
            return value
        if not is_known_value(value):
            raise UnknownInvolved
        value = CONVERSIONS[node.conversion](value)
        spec = "" if node.format_spec is None else self.known_value(node.format_spec)
        return METHODS[str]["format"]("{:" + spec + "}", value)

    def _attribute(self, node: ast.Attribute) -> Any:
        return self.attribute(self.known_value(node.value), node.attr)

    def attribute(self, _value: Any, name: str) -> Any:
        """`value.name` where it is not called."""
        raise Unsupported(f"the attribute `{name}` is not evaluated")

    def _call(self, node: ast.Call) -> Any:
        if isinstance(node.func, ast.Attribute):
            function = self.method(self.known_value(node.func.value), node.func.attr)
        else:
            function = self.value(node.func)
        if not callable(function):
            raise EvalFailed(f"a value of type {type(function).__name__} is not callable")
        if any(keyword.arg is None for keyword in node.keywords) or any(isinstance(item, ast.Starred) for item in node.args):
            raise Unsupported("unpacked arguments are not evaluated")
        arguments = [self.value(item) for item in node.args]
        named = {str(keyword.arg): self.value(keyword.value) for keyword in node.keywords}
        if function is str and len(arguments) == 1 and isinstance(arguments[0], str):
            return arguments[0]
        if function not in self.functions.values() and not all(map(is_known_value, (*arguments, *named.values()))):
            raise UnknownInvolved
        return function(*arguments, **named)

    def method(self, value: Any, name: str) -> Function:
        """What `value.name(...)` calls."""
        methods = METHODS.get(type(value), {})
        if name in methods:
            method = methods[name]
            return lambda *arguments, **named: method(value, *arguments, **named)
        if hasattr(value, name):
            raise Unsupported(f"the method `{name}` is not evaluated")
        raise EvalFailed(f"'{type(value).__name__}' object has no attribute '{name}'")

    def _listcomp(self, node: ast.ListComp) -> Any:
        return list(self._generated(node.elt, node.generators))

    def _generatorexp(self, node: ast.GeneratorExp) -> Any:
        return list(self._generated(node.elt, node.generators))

    def _generated(self, element: ast.expr, generators: list[ast.comprehension]) -> Iterator[Any]:
        if not generators:
            yield self.value(element)
            return
        first, *rest = generators
        if not isinstance(first.target, ast.Name) or first.is_async:
            raise Unsupported("this comprehension is not evaluated")
        for item in self.known_value(first.iter):
            self.local[first.target.id] = item
            if all(self.known_value(condition) for condition in first.ifs):
                yield from self._generated(element, rest)
        self.local.pop(first.target.id, None)


def is_known_value(value: Any) -> bool:
    """Whether a value has no text with unknown parts in it."""
    if isinstance(value, str):
        return is_known(value)
    if isinstance(value, dict):
        return all(is_known_value(key) and is_known_value(item) for key, item in value.items())
    if isinstance(value, (list, tuple, set)):
        return all(map(is_known_value, value))
    return True


def check_size(operation: ast.operator, left: Any, right: Any) -> None:
    """Reject, before it is computed, what would be too large.

    Raises:
        TooLarge: the result could have more than some thousand digits or characters.
    """
    if isinstance(operation, ast.Pow) and isinstance(left, int) and isinstance(right, int):
        if left.bit_length() * max(right, 0) > 10_000:
            raise TooLarge("the number is too large")
    elif isinstance(operation, ast.LShift) and isinstance(right, int) and right > 10_000:
        raise TooLarge("the number is too large")
    elif isinstance(operation, ast.Mult):
        for count, item in ((left, right), (right, left)):
            if isinstance(count, int) and isinstance(item, (str, bytes, list, tuple)) and count * len(item) > 100_000:
                raise TooLarge("the text is too large")


def radians(expression: str) -> float:
    """The value of `rad(...)` in YAML: arithmetic on numbers, `pi` and `math.` functions.

    Raises:
        EvalFailed: it is no such expression.
        Unsupported: it is one that is not evaluated here.
    """
    try:
        tree = _parsed(expression.replace("pi", "math.pi").strip())
        names = _MathNames()
        plain = names.visit(tree)
        return float(evaluate(ast.unparse(plain), no_name, {name: MATH[name] for name in names.used}))
    except (SyntaxError, ValueError, TypeError, ArithmeticError, RecursionError, MemoryError) as error:
        raise EvalFailed(str(error)) from None


class _MathNames(ast.NodeTransformer):
    """Writes `math.x` as `x`; a bare `x` is no name there."""

    def __init__(self) -> None:
        self.used: set[str] = set()

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        if not (isinstance(node.value, ast.Name) and node.value.id == "math" and node.attr in MATH):
            raise EvalFailed(f"`{ast.unparse(node)}` is not known")
        self.used.add(node.attr)
        return ast.Name(node.attr, ast.Load())

    def visit_Name(self, node: ast.Name) -> ast.expr:
        if node.id not in BUILTINS:
            raise EvalFailed(f"name '{node.id}' is not defined")
        return node


def no_name(name: str) -> Any:
    """The lookup of an expression in which there are no names but those of functions."""
    raise KeyError(name)


_PYTHON_BUILTINS = frozenset(dir(builtins))
CONVERSIONS: dict[int, Function] = {-1: lambda value: value, ord("s"): str, ord("r"): repr, ord("a"): ascii}
