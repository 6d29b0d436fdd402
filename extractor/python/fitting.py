"""Calls whose arguments do not fit the function that they are of."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from rosarch.extractor.python.model import Function
from rosarch.extractor.python.shapes import arguments_of, defaults_of


def misfits(call: ast.Call, function: Function, skipped: int) -> Iterator[tuple[str, str]]:
    """What Python rejects `call` for, as (how, name): a parameter that is missing, a keyword that is unknown, too many arguments."""
    node = function.node
    if node is None or any(isinstance(argument, ast.Starred) for argument in call.args) or any(word.arg is None for word in call.keywords):
        return
    shape = node.args
    if shape.vararg is None and len(call.args) - skipped > sum(parameter.positional for parameter in function.parameters):
        yield "many", function.name.rpartition("::")[2]
    for keyword in call.keywords:
        if shape.kwarg is None and keyword.arg and function.index_of(keyword.arg) is None:
            yield "unknown", keyword.arg
    given, defaults = arguments_of(call, function, skip=skipped), defaults_of(shape)
    for parameter in function.parameters:
        if parameter not in given and parameter.name not in defaults and parameter.name not in _rest(shape):
            yield "missing", parameter.name


def positional_arguments(function: Function) -> tuple[int, int]:
    """The least and the most arguments without a name that a function with a body can be called with; -1 for any number."""
    shape = function.node.args if function.node is not None else ast.arguments([], [], None, [], [], None, [])
    positional = [parameter for parameter in function.parameters if parameter.positional]
    defaults = defaults_of(shape)
    return sum(parameter.name not in defaults for parameter in positional), -1 if shape.vararg is not None else len(positional)


def _rest(shape: ast.arguments) -> set[str]:
    return {argument.arg for argument in (shape.vararg, shape.kwarg) if argument is not None}
