"""Calls and constructions."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Sequence

from rosarch.extractor.python import definitions, strings
from rosarch.extractor.python.body import Body
from rosarch.extractor.python.fitting import misfits
from rosarch.extractor.python.members import note_member
from rosarch.extractor.python.model import Class, ClassValue, ExternalValue, Function, FunctionValue, InstanceValue, Variable
from rosarch.extractor.python.program import external_name, names_class
from rosarch.extractor.python.shapes import arguments_of, by_name, last_name, super_of
from rosarch.extractor.python_syntax import import_call


def lower_call(body: Body, node: ast.Call) -> str:
    """Record a call or a construction; arguments of known functions are at the index of their parameter."""
    formatted = strings.format_call(body, node)
    if formatted is not None:
        return formatted
    imported = import_call(node, body.module.package)
    if imported is not None:
        definitions.run_modules(body, node, [imported[0]])
    if isinstance(node.func, ast.Attribute):
        note_member(body, node.func)
    values = by_name(body.inference.callee_values(node, body.scope))
    functions, classes = _callees(body, node, values)
    receiver, skipped = _receiver(body, node, values)
    through = receiver if _is_called(values) else _callee_value(body, node, functions, classes)
    arguments, named = _arguments(body, node, functions, skipped)
    call = body.node(node, "call")
    facts = body.facts
    facts.add("call", call, last_name(node.func) or "()")
    for function in functions:
        facts.add("call_function", call, facts.function(function))
    for cls in classes:
        facts.add("call_constructs", call, facts.cls(cls))
    types = facts.inference.values(node, body.scope)
    if any(isinstance(value, InstanceValue) for value in types):
        facts.add("expr_type", call, facts.type(types))
    if receiver is not None:
        facts.add("call_receiver", call, receiver)
    if through is not None:
        facts.add("call_through", call, through)
    elif not functions and not classes:
        facts.add("call_unresolved", call, "dynamic")
    for index, argument in arguments:
        facts.add("call_argument", call, index, argument)
    for argument in named:
        facts.add("call_keyword", call, argument)
    if any(isinstance(argument, ast.Starred) for argument in node.args) or any(keyword.arg is None for keyword in node.keywords):
        facts.add("call_unpacks", call)
    if len(functions) == 1 and not functions[0].of_class:
        for how, name in misfits(node, functions[0], skipped):
            facts.add("call_misfits", call, how, name)
    body.flow.evaluate(call)
    return call


def _receiver(body: Body, node: ast.Call, values: Sequence[object]) -> tuple[str | None, int]:
    """The object that a method is called on, or that is called; and how many arguments stand for it: one in `Class.method(object)`."""
    from rosarch.extractor.python.expressions import lower

    if _is_called(values):
        return lower(body, node.func), 0
    if super_of(node.func, body.scope) is not None and body.scope.owner is not None:
        expr = body.node(node.func, "this")
        body.facts.add("this_use", expr, body.facts.cls(body.scope.owner))
        return expr, 0
    if not isinstance(node.func, ast.Attribute):
        return None, 0
    owners = body.inference.values(node.func.value, body.scope)
    methods = [
        value.function for value in values if isinstance(value, FunctionValue) and not value.bound and value.function.owner is not None
    ]
    methods = [method for method in methods if method.kind != "static_method" and not method.of_class]
    if any(isinstance(owner, ClassValue) for owner in owners) and methods and node.args:
        return lower(body, node.args[0]), 1
    if not owners or any(isinstance(owner, InstanceValue) for owner in owners):
        return lower(body, node.func.value), 0
    if isinstance(node.func.value, ast.Call):
        lower(body, node.func.value)  # it is no object, yet made by a call
    return None, 0


def _is_called(values: Sequence[object]) -> bool:
    """Whether it is an object that is called: its method `__call__` is entered."""
    return any(isinstance(value, InstanceValue) for value in values)


def _callees(body: Body, node: ast.Call, values: Sequence[object]) -> tuple[list[Function], list[Class]]:
    """The functions that may be entered, and the classes that objects are made of."""
    functions: list[Function] = []
    classes: list[Class] = []
    program = body.facts.program
    for value in values:
        match value:
            case FunctionValue(function, _):
                functions.append(function)
            case ClassValue(cls) if cls.factory:
                functions.append(cls.factory)
            case ClassValue(cls):
                classes.append(cls)
                functions += [function for function in cls.entered() if function.of_class]
            case ExternalValue(path) if names_class(path):
                classes.append(program.external_class(path))
            case ExternalValue(path):
                functions.append(program.external_function(external_name(path)))
            case InstanceValue(cls):
                functions += _methods(body, [cls], "__call__")
    functions += _methods(body, classes, "__init__")
    if not functions and not classes and isinstance(node.func, ast.Attribute) and not _names_field(body, node.func):
        own = super_of(node.func, body.scope)
        if own is not None:
            functions += _inherited(body, own, node.func.attr)
        else:
            objects = by_name(body.inference.values(node.func.value, body.scope))
            functions += _methods(body, [value.cls for value in objects if isinstance(value, InstanceValue)], node.func.attr)
    return list(dict.fromkeys(functions)), classes


def _names_field(body: Body, node: ast.Attribute) -> bool:
    return bool(body.inference.fields(node, body.scope))


def _methods(body: Body, classes: Iterable[Class], name: str) -> list[Function]:
    """The methods `name` of `classes`; of those that may inherit it from a class that is not declared, that class' one."""
    found = []
    for cls in classes:
        symbol = cls.find(name)
        if isinstance(symbol, Function):
            found.append(symbol)
        elif symbol is None:
            found += _undeclared(body, cls, name)
    return found


def _inherited(body: Body, cls: Class, name: str) -> list[Function]:
    """The methods that `super().name` may be in a method of `cls`."""
    symbols = cls.above(name)
    return [symbol for symbol in symbols if isinstance(symbol, Function)] if symbols else _undeclared(body, cls, name)


def _undeclared(body: Body, cls: Class, name: str) -> list[Function]:
    """The method `name` of the first class that `cls` derives from and that is not declared, if there is one."""
    elsewhere = next((ancestor for ancestor in cls.ancestors() if not ancestor.own and ancestor.name != "object"), None)
    return [body.facts.program.external_function(f"{elsewhere.name}::{name}", elsewhere)] if elsewhere is not None else []


def _callee_value(body: Body, node: ast.Call, functions: Sequence[Function], classes: Sequence[Class]) -> str | None:
    """The value that is called: of a variable, or what an expression gives."""
    from rosarch.extractor.python.expressions import lower

    if isinstance(node.func, ast.Name):
        symbol = body.facts.program.lookup(node.func.id, body.scope)
        return lower(body, node.func) if isinstance(symbol, Variable) else None
    if isinstance(node.func, ast.Attribute):
        return lower(body, node.func) if _names_field(body, node.func) else None
    if len(functions) > 1 and isinstance(node.func, ast.Subscript):  # one of several: the index is a condition
        table, index = lower(body, node.func.value), lower(body, node.func.slice, text=True)
        return body.operator(node.func, "[]", table, index)
    return lower(body, node.func) if (len(functions) > 1 and isinstance(node.func, ast.Call)) or (not functions and not classes) else None


def _arguments(body: Body, node: ast.Call, functions: Sequence[Function], skipped: int) -> tuple[list[tuple[int, str]], list[str]]:
    """The arguments with their index, and those whose name is known and index is not."""
    from rosarch.extractor.python.expressions import lower

    known = next((function for function in functions if function.node is not None), None)
    indices: dict[ast.expr, int] = {}
    if known is not None:
        places = {parameter: index for index, parameter in enumerate(known.parameters)}
        indices = {argument: places[parameter] for parameter, argument in arguments_of(node, known, skip=skipped).items()}
    found, named = [], []
    for index, argument in enumerate(node.args[skipped:]):
        if isinstance(argument, ast.Starred):
            lower(body, argument.value)
            continue
        found.append((indices.get(argument, index), lower(body, argument, text=True)))
    for keyword in node.keywords:
        value = lower(body, keyword.value, text=True)
        if keyword.arg is not None and keyword.value in indices:
            found.append((indices[keyword.value], value))
        elif keyword.arg is not None:
            body.facts.add("keyword_argument", value, keyword.arg)
            named.append(value)
    return found, named
