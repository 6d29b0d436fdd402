"""What objects of unknown classes are, by the methods called on them that only one declared class has: `@distinctive` in `stubs/`."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from functools import cache
from typing import TYPE_CHECKING

from rosarch.extractor.python.model import NOTHING, Class, Function, InstanceValue, Module, Scope
from rosarch.extractor.python.program import STUBS, Program
from rosarch.extractor.python.shapes import annotation_of, arguments_of

if TYPE_CHECKING:
    from rosarch.extractor.python.inference import Inference


def assume_classes(inference: Inference, modules: Iterable[Module]) -> bool:
    """Infer from such methods the class of objects, or a base of it that is not there; returns whether any is new."""
    new = False
    for module in modules:
        for call, scope in module.calls:
            if isinstance(call.func, ast.Attribute) and call.func.attr in _distinctive():
                new |= _assume(inference, call, call.func, scope)
    return new


def _assume(inference: Inference, call: ast.Call, method: ast.Attribute, scope: Scope) -> bool:
    known = inference.values(method.value, scope)
    for owner in _owners(inference.program, method.attr):
        function = owner.member(method.attr)
        if not isinstance(function, Function) or not _fits(inference, call, function, scope):
            continue
        if not known:
            return inference.take_for(method.value, scope, owner)
        bases = [base for value in known if isinstance(value, InstanceValue) and (base := _absent_base(value.cls, method.attr))]
        for base in bases:
            base.bases.append(owner)
            owner.derived.append(base)
            base.assumed = True
        return bool(bases)
    return False


def _absent_base(cls: Class, method: str) -> Class | None:
    """The class, or its base, that is not declared and may have `method`."""
    if cls.find(method) is not None:
        return None
    return next((ancestor for ancestor in cls.ancestors() if ancestor.node is None and not ancestor.bases), None)


def _fits(inference: Inference, call: ast.Call, function: Function, scope: Scope) -> bool:
    """Whether no argument contradicts the declaration: where a class is to be given, there is no object."""
    if any(isinstance(argument, ast.Starred) for argument in call.args):
        return True
    given = arguments_of(call, function)
    if any(parameter.positional and not _has_default(parameter.sources) and parameter not in given for parameter in function.parameters):
        return any(keyword.arg is None for keyword in call.keywords)
    for parameter, argument in given.items():
        match annotation_of(parameter):
            case ast.Name(id="type") | ast.Subscript(value=ast.Name(id="type")):
                values = inference.values(argument, scope)
                if values != NOTHING and all(isinstance(value, InstanceValue) for value in values):
                    return False
    return True


def _has_default(sources: Iterable[object]) -> bool:
    return any(getattr(source, "part", "") == "value" for source in sources)


def _owners(program: Program, method: str) -> list[Class]:
    found = []
    for module, name in _distinctive().get(method, ()):
        declared = program.module(module)
        symbol = declared.scope.names.get(name) if declared else None
        if isinstance(symbol, Class):
            found.append(symbol)
    return found


@cache
def _distinctive() -> dict[str, list[tuple[str, str]]]:
    """Method to module and class, of those that are marked."""
    found: dict[str, list[tuple[str, str]]] = {}
    for path in sorted(STUBS.rglob("*.pyi")):
        text = path.read_text(encoding="utf-8")
        if "@distinctive" not in text:
            continue
        module = ".".join(path.relative_to(STUBS).with_suffix("").parts).removesuffix(".__init__")
        for node in ast.parse(text).body:
            if isinstance(node, ast.ClassDef):
                marked = (inner for inner in node.body if isinstance(inner, ast.FunctionDef) and any(map(_marks, inner.decorator_list)))
                for inner in marked:
                    found.setdefault(inner.name, []).append((module, node.name))
    return found


def _marks(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id == "distinctive"
