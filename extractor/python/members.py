"""Members of modules that no source defines."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from rosarch.extractor.python.body import Body
from rosarch.extractor.python.model import Module, ModuleValue
from rosarch.extractor.python.shapes import last_name

_OPEN_NAMES = frozenset({"globals", "vars", "locals", "exec", "eval", "setattr", "__getattr__"})
_HANDLING = frozenset({"Exception", "BaseException", "AttributeError"})
_OPEN_MEMBERS = frozenset({"modules", "__dict__"})


def note_member(body: Body, node: ast.Attribute) -> None:
    """Record that a module of the workspace, all of which is known, has no member of the name that `node` asks it for."""
    values = body.inference.values(node.value, body.scope)
    value = next(iter(values)) if len(values) == 1 else None
    if not isinstance(value, ModuleValue) or not isinstance(node.ctx, ast.Load) or node.attr.startswith("__"):
        return
    module, known = value.module, body.facts.members
    if module is None or module.stub or module.is_package or module.left_out or module is body.module:
        return
    if not known:
        for each in body.facts.program.modules.values():
            if each is not None and not each.stub:
                known.named |= set(_names_mentioned(each))
                known.guarded |= set(_guarded(each))
                known.bound[each.name] = set(_bound(each))
    if node in known.guarded or node.attr in known.named or not {node.attr, "*"}.isdisjoint(known.bound.get(module.name, {"*"})):
        return
    body.facts.add("module_member_absent", body.node(node, "member"), module.name, node.attr)


def _bound(module: Module) -> Iterator[str]:
    """All names that something in a module is bound to, in any scope; `*` when there may be others."""
    for node in ast.walk(module.tree):
        match node:
            case ast.Name(id=name):
                if name in _OPEN_NAMES:
                    yield "*"
                if not isinstance(node.ctx, ast.Load):
                    yield name
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                yield "*" if name in _OPEN_NAMES else name
            case ast.alias(name=name, asname=other):
                yield other or name.partition(".")[0]  # or `*`
            case ast.ExceptHandler(name=str(name)) | ast.MatchAs(name=str(name)) | ast.MatchStar(name=str(name)):
                yield name
            case ast.MatchMapping(rest=str(name)):
                yield name
            case ast.Attribute(attr=name) if name in _OPEN_MEMBERS:
                yield "*"


def _guarded(module: Module) -> Iterator[ast.AST]:
    """What is evaluated where the error of a member that is absent is handled."""
    for node in ast.walk(module.tree):
        if isinstance(node, ast.Try) and any(_handles(handler) for handler in node.handlers):
            for statement in node.body:
                yield from ast.walk(statement)


def _handles(handler: ast.ExceptHandler) -> bool:
    kinds = handler.type.elts if isinstance(handler.type, ast.Tuple) else [handler.type]
    return any(kind is None or last_name(kind) in _HANDLING for kind in kinds)


def _names_mentioned(module: Module) -> Iterator[str]:
    """What a module gives to members of others, or names as a text: it may ask for them, or set them, by it."""
    for node in ast.walk(module.tree):
        match node:
            case ast.Attribute(attr=name) if not isinstance(node.ctx, ast.Load):
                yield name
            case ast.Constant(value=str(text)):
                yield text
