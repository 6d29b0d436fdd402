"""Expressions: from the syntax tree to rows of `rules/schema/expressions.dl`."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import Any

from rosarch.extractor.python import calls, strings
from rosarch.extractor.python.body import Body
from rosarch.extractor.python.definitions import lower_lambda
from rosarch.extractor.python.members import note_member
from rosarch.extractor.python.model import Class, ClassValue, ExternalValue, Function, FunctionValue, InstanceValue, ModuleValue, Variable
from rosarch.extractor.python.program import external_name, names_class
from rosarch.extractor.python.shapes import by_name, field_of
from rosarch.extractor.python.statements import lower_comprehension

_BINARY: dict[type[ast.operator], str] = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.FloorDiv: "//", ast.Mod: "%", ast.Pow: "**",
    ast.LShift: "shift", ast.RShift: "shift", ast.BitOr: "|", ast.BitAnd: "&", ast.BitXor: "^", ast.MatMult: "@",
}  # fmt: skip
_UNARY: dict[type[ast.unaryop], str] = {ast.Not: "!", ast.USub: "-", ast.UAdd: "+", ast.Invert: "~"}
_COMPARED: dict[type[ast.cmpop], str] = {
    ast.Eq: "==", ast.NotEq: "!=", ast.Is: "==", ast.IsNot: "!=", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=",
    ast.In: "in", ast.NotIn: "not in",
}  # fmt: skip
_CALCULATED: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv, ast.FloorDiv: operator.floordiv,
}  # fmt: skip
_LARGEST = 1e15
"""Numbers as large as this are not calculated with: a float of that size is hardly exact, and products of integers grow without end."""


def lower(body: Body, node: ast.expr, *, text: bool = False) -> str:
    """Record an expression and return its identifier; with `text`, its source text too."""
    form = _FORMS.get(type(node), unknown)
    expr = form(body, node)
    return body.written(expr, node) if text else expr


def unknown(body: Body, node: ast.expr) -> str:
    """A form without facts of its own: its parts are read, so that no call is lost."""
    inner = [lower(body, child) for child in ast.iter_child_nodes(node) if isinstance(child, ast.expr)]
    expr = body.node(node, "unknown")
    for index, operand in enumerate(inner):
        body.facts.add("operand", expr, index, operand)
    body.facts.add("expr_unknown", expr, "form")
    return body.written(expr, node)


def literal(body: Body, node: ast.AST, value: object) -> str:
    """A constant."""
    kind, text, form = _literal(value)
    expr = body.node(node, form)
    body.facts.add("literal", expr, kind, text)
    return expr


def _literal(value: object) -> tuple[str, str, str]:
    match value:
        case bool():
            return "boolean", str(value).lower(), "bool"
        case int():
            return "integer", str(value) if value.bit_length() < 1000 else hex(value), "num"
        case float():
            return "float", repr(value), "num"
        case str():
            return "string", value.encode("utf-8", "replace").decode(), "str"
        case bytes():
            return "string", value.decode("latin-1"), "str"
        case None:
            return "null", "None", "null"
    return "string", str(value), "str"


def use(body: Body, node: ast.AST, variable: str, owner: str | None = None) -> str:
    """The use of a variable, of a member with its object."""
    expr = body.node(node, "use")
    body.facts.add("variable_use", expr, variable)
    if owner is not None:
        body.facts.add("field_object", expr, owner)
    body.flow.read(expr)
    return expr


def function_use(body: Body, node: ast.AST, functions: Sequence[Function], owner: str | None = None) -> str:
    """The name of a function, or of a method of an object, that is not called."""
    expr = body.node(node, "fn")
    for function in functions:
        body.facts.add("function_use", expr, body.facts.function(function))
    if owner is not None:
        body.facts.add("function_object", expr, owner)
    return body.written(expr, node)


def class_use(body: Body, node: ast.AST, classes: Sequence[Class]) -> str:
    """The name of a class."""
    expr = body.node(node, "class")
    for cls in classes:
        body.facts.add("class_use", expr, body.facts.cls(cls))
    return expr


def _constant(body: Body, node: ast.expr) -> str:
    assert isinstance(node, ast.Constant)
    return literal(body, node, node.value)


def _name(body: Body, node: ast.expr) -> str:
    assert isinstance(node, ast.Name)
    receiver = _receiver(body, node.id)
    if receiver is not None:
        expr = body.node(node, "this")
        body.facts.add("this_use", expr, body.facts.cls(receiver))
        return expr
    symbol = body.facts.program.lookup(node.id, body.scope)
    if isinstance(symbol, Variable):
        return use(body, node, body.facts.variable(symbol))
    values = by_name(body.facts.program.values_of(symbol)) if symbol is not None else []
    return _named(body, node, values)


def _receiver(body: Body, name: str) -> Class | None:
    """The class whose object `name`, the first parameter of a method, is."""
    scope = body.scope
    while scope.kind == "function":
        if name in scope.names:
            return None
        if scope.function is not None and scope.function.receiver == name and not scope.function.of_class:
            return scope.function.owner
        if scope.parent is None:
            return None
        scope = scope.parent
    return None


def _named(body: Body, node: ast.expr, values: Sequence[object]) -> str:
    """A name that stands for something that is no variable."""
    functions = [value.function for value in values if isinstance(value, FunctionValue)]
    if functions:
        return function_use(body, node, functions)
    program = body.facts.program
    classes = [value.cls for value in values if isinstance(value, ClassValue)]
    classes += [program.external_class(value.path) for value in values if isinstance(value, ExternalValue) and names_class(value.path)]
    if classes:
        return class_use(body, node, classes)
    for value in values:
        if isinstance(value, ExternalValue):
            name = external_name(value.path)
            body.facts.add("variable", name, "global")
            body.facts.add("variable_name", name, name.rpartition("::")[2])
            return use(body, node, name)
    expr = body.node(node, "unknown")
    body.facts.add("expr_unknown", expr, "module" if any(isinstance(value, ModuleValue) for value in values) else "name")
    return body.written(expr, node)


def _attribute(body: Body, node: ast.expr) -> str:
    assert isinstance(node, ast.Attribute)
    note_member(body, node)
    values = by_name(body.inference.values(node.value, body.scope))
    objects = [value for value in values if isinstance(value, InstanceValue)]
    if objects or not values:
        return _member(body, node, [value.cls for value in objects])
    for value in values:
        if isinstance(value, ClassValue):
            symbol = value.cls.find(node.attr)
            if isinstance(symbol, Variable):
                if value.cls.enumeration:
                    expr = body.node(node, "enum")
                    body.facts.add("literal", expr, "enum", f"{value.cls.name}::{node.attr}")
                    return expr
                return use(body, node, body.facts.variable(field_of(value.cls, symbol)))
        if isinstance(value, ModuleValue):
            symbol = body.facts.program.symbol_of(value.path, node.attr)
            if isinstance(symbol, Variable):
                return use(body, node, body.facts.variable(symbol))
    found = frozenset().union(*(body.facts.program.member(value, node.attr) for value in values))
    if not found:
        lower(body, node.value)
    return _named(body, node, by_name(found))


def _member(body: Body, node: ast.Attribute, classes: Sequence[Class]) -> str:
    """A member of an object of one of `classes`; of an object that is not known when there are none."""
    symbols = [(cls, cls.find(node.attr)) for cls in classes]
    owner = lower(body, node.value)
    getters = [symbol for _, symbol in symbols if isinstance(symbol, Function) and symbol.is_property]
    if getters and isinstance(node.ctx, ast.Load) and any(getter.own for getter in getters):
        expr = body.node(node, "call")
        body.facts.add("call", expr, node.attr)
        body.facts.add("call_receiver", expr, owner)
        for getter in getters:
            body.facts.add("call_function", expr, body.facts.function(getter))
        body.flow.evaluate(expr)
        return expr
    methods = [symbol for _, symbol in symbols if isinstance(symbol, Function) and not symbol.is_property]
    if methods:
        return function_use(body, node, methods, owner)
    fields = [field_of(cls, symbol) for cls, symbol in symbols if isinstance(symbol, Variable)]
    if fields:
        return use(body, node, body.facts.variable(fields[0]), owner)
    elsewhere = next((ancestor for cls in classes for ancestor in cls.ancestors() if not ancestor.own), None)
    if elsewhere is not None and elsewhere.name not in ("object",):
        variable = Variable(f"{elsewhere.name}::{node.attr}", node.attr, "field", owner=elsewhere)
        return use(body, node, body.facts.variable(variable), owner)
    return use(body, node, body.facts.unknown_member(node.attr), owner)


def call_setters(body: Body, target: ast.expr, value: str) -> bool:
    """Record that an assignment of `value` to a property calls the setter; whether `target` is one that has a setter."""
    if not isinstance(target, ast.Attribute):
        return False
    objects = [value for value in by_name(body.inference.values(target.value, body.scope)) if isinstance(value, InstanceValue)]
    members = [each.cls.find(target.attr) for each in objects]
    setters = [member.setter for member in members if isinstance(member, Function) and member.setter is not None]
    if not setters:
        return False
    expr = body.node(target, "call")
    body.facts.add("call", expr, target.attr)
    body.facts.add("call_receiver", expr, lower(body, target.value))
    body.facts.add("call_argument", expr, 0, value)
    for setter in setters:
        body.facts.add("call_function", expr, body.facts.function(setter))
    body.flow.evaluate(expr)
    return True


def _subscript(body: Body, node: ast.expr) -> str:
    assert isinstance(node, ast.Subscript)
    value, index = lower(body, node.value), lower(body, node.slice)
    expr = body.operator(node, "[]", value, index)
    if isinstance(node.ctx, ast.Load):
        body.flow.evaluate(expr)  # there may be no such element
    return expr


def _slice(body: Body, node: ast.Slice) -> str:
    """`first:end`, where `first` is 0 when it is left out; one with a step is not described."""
    if node.step is not None:
        return unknown(body, node)
    first = lower(body, node.lower) if node.lower is not None else literal(body, node, 0)
    return body.operator(node, "[:]", first, *([lower(body, node.upper)] if node.upper is not None else []))


def _unary(body: Body, node: ast.expr) -> str:
    assert isinstance(node, ast.UnaryOp)
    return body.operator(node, _UNARY[type(node.op)], _tested(body, node.operand))


def _tested(body: Body, node: ast.expr) -> str:
    """An operand of a test; calls, which may be tests themselves, with their text."""
    return lower(body, node, text=isinstance(node, ast.Call))


def _binary(body: Body, node: ast.expr) -> str:
    assert isinstance(node, ast.BinOp)
    if isinstance(node.op, ast.Mod) and isinstance(node.right, ast.Tuple):
        return strings.percent(body, node, [lower(body, part) for part in node.right.elts])
    expr = body.operator(node, _BINARY[type(node.op)], lower(body, node.left), lower(body, node.right))
    value = body.facts.numbers[node] = _calculated(node, body.facts.numbers)
    if value is not None:
        body.facts.add("expr_constant", expr, repr(value))
    return expr


def _calculated(node: ast.expr, known: Mapping[ast.expr, int | float | None]) -> int | float | None:
    """What arithmetic on literals comes to, within `_LARGEST`; `known` is what that of its operands does, which were lowered before it."""
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            return _bounded(value)
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            negated = _calculated(inner, known)
            return -negated if negated is not None else None
        case ast.BinOp() if node in known:
            return known[node]
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _CALCULATED:
            first, second = _calculated(left, known), _calculated(right, known)
            if first is not None and second is not None:
                with suppress(ArithmeticError, ValueError):
                    return _bounded(_CALCULATED[type(op)](first, second))
    return None


def _bounded(value: int | float) -> int | float | None:
    return value if abs(value) < _LARGEST else None


def _logical(body: Body, node: ast.expr) -> str:
    """`a and b and c` is `(a and b) and c`; what is not on the left may not be evaluated."""
    assert isinstance(node, ast.BoolOp)
    name = "&&" if isinstance(node.op, ast.And) else "||"
    left = lower(body, node.values[0], text=True)
    for part in node.values[1:]:
        right = body.flow.maybe(left, lambda part=part: _tested(body, part), taken=name == "&&")  # type: ignore[misc]
        left = body.operator(node, name, left, right)
        if part is not node.values[-1]:
            whole = ast.copy_location(ast.Pass(), node)
            whole.end_lineno, whole.end_col_offset = part.end_lineno, part.end_col_offset
            body.written(left, whole)
    return left


def _compare(body: Body, node: ast.expr) -> str:
    """`a < b < c` is `a < b and b < c`."""
    assert isinstance(node, ast.Compare)
    if _asks_for_main(node):
        expr = body.operator(node, "==", lower(body, node.left), lower(body, node.comparators[0]))
        body.facts.add("expr_constant", expr, "1" if body.module.main else "0")
        return expr
    left = _tested(body, node.left)
    result = ""
    for op, other in zip(node.ops, node.comparators, strict=True):
        right = _tested(body, other)
        expr = body.operator(node, _COMPARED[type(op)], left, right)
        result = body.operator(node, "&&", result, expr) if result else expr
        left = right
    return result


def _asks_for_main(node: ast.Compare) -> bool:
    match node:
        case ast.Compare(left=ast.Name(id="__name__"), ops=[ast.Eq()], comparators=[ast.Constant(value="__main__")]):
            return True
    return False


def _conditional(body: Body, node: ast.expr) -> str:
    assert isinstance(node, ast.IfExp)
    condition = lower(body, node.test, text=True)
    either = body.flow.either(condition, lambda: lower(body, node.body), lambda: lower(body, node.orelse))
    return body.operator(node, "?:", condition, *either)


def _list(body: Body, node: ast.expr) -> str:
    assert isinstance(node, (ast.List, ast.Tuple, ast.Set))
    return body.operator(node, "{}", *(lower(body, part) for part in node.elts), form="list")


def _dict(body: Body, node: ast.expr) -> str:
    """A list of entries, each of key and value."""
    assert isinstance(node, ast.Dict)
    pairs = []
    for key, value in zip(node.keys, node.values, strict=True):
        entry = lower(body, value)
        if key is not None:
            chosen = any(isinstance(found, FunctionValue) for found in body.inference.values(value, body.scope))
            pairs.append(body.operator(key, ":", lower(body, key, text=chosen), entry))
        else:
            pairs.append(entry)
    return body.operator(node, "{}", *pairs, form="list")


def _await(body: Body, node: ast.Await) -> str:
    expr = lower(body, node.value)
    body.facts.add("awaited", expr)
    return expr


def _starred(body: Body, node: ast.Starred) -> str:
    return lower(body, node.value)


def _yield(body: Body, node: ast.Yield) -> str:
    """Of a function that makes a context, what it hands to the block of a `with` is what a call of it gives."""
    expr = unknown(body, node)
    function = body.scope.function
    if function is not None and function.is_context and node.value is not None:
        body.facts.add("return_value", body.function, lower(body, node.value))
    return expr


def _walrus(body: Body, node: ast.expr) -> str:
    from rosarch.extractor.python.statements import assign

    assert isinstance(node, ast.NamedExpr)
    value = lower(body, node.value, text=True)
    assign(body, node.target, value, node)
    return value


_FORMS: dict[type[ast.AST], Callable[[Body, Any], str]] = {
    ast.Constant: _constant,
    ast.Name: _name,
    ast.Attribute: _attribute,
    ast.Subscript: _subscript,
    ast.Slice: _slice,
    ast.Call: calls.lower_call,
    ast.UnaryOp: _unary,
    ast.BinOp: _binary,
    ast.BoolOp: _logical,
    ast.Compare: _compare,
    ast.IfExp: _conditional,
    ast.List: _list,
    ast.Tuple: _list,
    ast.Set: _list,
    ast.Dict: _dict,
    ast.JoinedStr: strings.joined,
    ast.Lambda: lower_lambda,
    ast.ListComp: lower_comprehension,
    ast.SetComp: lower_comprehension,
    ast.GeneratorExp: lower_comprehension,
    ast.DictComp: lower_comprehension,
    ast.Yield: _yield,
    ast.NamedExpr: _walrus,
    ast.Await: _await,
    ast.Starred: _starred,
}
