"""What declared functions pass on to the functions that they are given, by the type variables of their annotations."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from rosarch.extractor.python.model import NOTHING, ClassValue, ExternalValue, Function, FunctionValue, Scope, Value, Values, Variable
from rosarch.extractor.python.program import names_class
from rosarch.extractor.python.shapes import annotation_of, arguments_of, parts_of, unpacked

if TYPE_CHECKING:
    from rosarch.extractor.python.inference import Inference


def handed_on(inference: Inference, call: ast.Call, function: Function, scope: Scope) -> Iterator[tuple[Variable, Values]]:
    """What a declared function gives to those that it is given: `type[T]` to `Callable[[T], ...]`, and what goes with it."""
    given = [(annotation_of(parameter), argument) for parameter, argument in arguments_of(call, function).items()]
    arguments = [(annotation, inference.values(argument, scope)) for annotation, argument in given]
    packs = {unpacked(kind): [inference.values(part, scope) for part in parts] for kind, node in given if (parts := parts_of(node))}
    known: dict[str, Values] = {}
    for annotation, values in arguments:
        match annotation:
            case ast.Name(id=name):
                known[name] = values
            case ast.Subscript(value=ast.Name(id="type"), slice=ast.Name(id=name)):
                known[name] = frozenset(inference.object_of(value) for value in values if _is_class(value))
    rest = [inference.values(argument, scope) for argument in call.args[sum(parameter.positional for parameter in function.parameters) :]]
    for annotation, values in arguments:
        for taker in (value.function for value in values if isinstance(value, FunctionValue) and value.function.own):
            if pack := unpacked(annotation):
                yield from zip(taker.parameters, packs.get(pack, []), strict=False)
            match annotation:
                case ast.Subscript(value=ast.Name(id="Callable"), slice=ast.Tuple(elts=[ast.List(elts=types), _])):
                    taken = [known.get(part.id, NOTHING) if isinstance(part, ast.Name) else NOTHING for part in types]
                    yield from zip(taker.parameters, taken, strict=False)
                case ast.Subscript(value=ast.Name(id="Callable"), slice=ast.Tuple(elts=[ast.Name(), _])) if rest:
                    yield from zip(taker.parameters[-len(rest) :], rest, strict=False)


def _is_class(value: Value) -> bool:
    return isinstance(value, ClassValue) or (isinstance(value, ExternalValue) and names_class(value.path))
