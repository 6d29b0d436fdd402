"""What is recorded of calls, functions and classes without knowing values."""

from __future__ import annotations

import ast
from collections.abc import Iterable

from rosarch.extractor.python.model import (
    Class,
    ClassValue,
    ExternalValue,
    Function,
    FunctionValue,
    InstanceValue,
    ModuleValue,
    Scope,
    Value,
    Values,
    Variable,
)


def place(node: ast.AST) -> tuple[int, int]:
    """Line and column, both from 1, at which `node` begins."""
    return getattr(node, "lineno", 1), getattr(node, "col_offset", 0) + 1


def defaults_of(arguments: ast.arguments) -> dict[str, ast.expr]:
    """The defaults of parameters, by their names."""
    named = [*arguments.posonlyargs, *arguments.args]
    found = {argument.arg: default for argument, default in zip(reversed(named), reversed(arguments.defaults), strict=False)}
    keywords = zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)
    return found | {argument.arg: default for argument, default in keywords if default is not None}


def arguments_of(call: ast.Call, function: Function, *, skip: int = 0) -> dict[Variable, ast.expr]:
    """The parameters of `function` with the arguments that `call` gives them, as far as it writes them out, without the first `skip`."""
    found: dict[Variable, ast.expr] = {}
    positional = [parameter for parameter in function.parameters if parameter.positional]
    for parameter, argument in zip(positional, call.args[skip:], strict=False):
        if isinstance(argument, ast.Starred):
            break
        found[parameter] = argument
    for keyword in call.keywords:
        index = function.index_of(keyword.arg) if keyword.arg else None
        if index is not None:
            found[function.parameters[index]] = keyword.value
    return found


def super_of(node: ast.expr, scope: Scope) -> Class | None:
    """The class whose bases `super().name` looks in."""
    match node:
        case ast.Attribute(value=ast.Call(func=ast.Name(id="super"))):
            return scope.owner
    return None


def returned(function: Function) -> Iterable[ast.expr]:
    """The values that a function returns, or hands to the block of a `with`; not those of functions in it."""
    return _given(function.node, ast.Yield if function.is_context else ast.Return) if function.node is not None else ()


def _given(node: ast.AST, kind: type[ast.Return | ast.Yield]) -> Iterable[ast.expr]:
    passed = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef, *([ast.expr] if kind is ast.Return else []))
    for child in ast.iter_child_nodes(node):
        if isinstance(child, kind):
            yield from [child.value] if child.value is not None else ()
        elif not isinstance(child, passed):
            yield from _given(child, kind)


def field_of(cls: Class, variable: Variable) -> Variable:
    """The data member of all classes from which `cls` has it: that of the most general one that the workspace defines."""
    found = variable
    for ancestor in cls.ancestors():
        known = ancestor.fields.get(variable.name)
        if known is not None and ancestor.own == (variable.module is not None and not variable.module.stub):
            found = known
    return found


def last_name(node: ast.expr) -> str:
    """The last of the names that `node` is written with."""
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def name_of_value(value: Value) -> str:
    """The name of what a value is."""
    match value:
        case InstanceValue(cls) | ClassValue(cls):
            return cls.name
        case FunctionValue(function, _):
            return function.identifier
        case ModuleValue(path, _) | ExternalValue(path):
            return path


def by_name(values: Values) -> list[Value]:
    """Values in a fixed order."""
    return sorted(values, key=lambda value: (type(value).__name__, name_of_value(value)))


def annotation_of(parameter: Variable) -> ast.expr | None:
    """What a parameter is declared to be."""
    return next((source.expr for source in parameter.sources if source.part == "annotation"), None)


def unpacked(annotation: ast.expr | None) -> str:
    """`Ts` of `tuple[Unpack[Ts]]` and `Callable[[Unpack[Ts]], ...]`."""
    match annotation:
        case ast.Subscript(value=ast.Name(id="tuple" | "Callable"), slice=inner) | ast.Tuple(elts=[ast.List(elts=[inner]), _]):
            return unpacked(inner)
        case ast.Subscript(value=ast.Name(id="Unpack"), slice=ast.Name(id=name)):
            return name
    return ""


def parts_of(node: ast.expr) -> list[ast.expr]:
    """What a list or tuple is written with."""
    return node.elts if isinstance(node, (ast.Tuple, ast.List)) else []
