"""Functions that decorators of the same source put others around: `@guarded` is read as what the function is then.

    def guarded(f):                          @guarded
        def inner(self, msg):                def on_scan(self, msg):
            if self.ready:                       ...
                f(self, msg)
        return inner

makes `on_scan` the function `inner`, with a function of its own to call. Of a decorator that does more than that it is not known whether it
calls what it is given.
"""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterator
from dataclasses import dataclass

FunctionNode = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True)
class _Wrapper:
    """What a decorator returns: `node`, which calls the function that it is given as `given`; `bound` are its own arguments."""

    node: FunctionNode
    given: str
    bound: dict[str, ast.expr]


class _NotUnderstood(Exception):
    """A decorator does more than to put a function around another."""


def read_decorated(tree: ast.Module) -> None:
    """Change the tree in place."""
    decorators = {node.name: node for node in tree.body if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))}
    for node in list(ast.walk(tree)):
        body = getattr(node, "body", None)
        if isinstance(body, list):
            body[:] = [part for statement in body for part in _as_decorated(statement, isinstance(node, ast.ClassDef), decorators)]


def _as_decorated(statement: ast.stmt, in_class: bool, decorators: dict[str, FunctionNode]) -> Iterator[ast.stmt]:
    if not isinstance(statement, (ast.FunctionDef, ast.AsyncFunctionDef)):
        yield statement
        return
    function: FunctionNode = statement
    inner_name = f"{function.name}_undecorated"
    while function.decorator_list and (maker := _maker(function.decorator_list[-1], decorators)) is not None:
        mark = function.decorator_list[-1]
        try:
            around = _around(function, inner_name, _wrapper(maker, mark), in_class)
        except _NotUnderstood:
            if not _gives_back(maker):
                _may_be_skipped(function, maker, mark)
            break
        function.name, inner_name = inner_name, f"{inner_name}_again"
        function.decorator_list = []
        yield function
        function = around
    yield function


def _maker(mark: ast.expr, decorators: dict[str, FunctionNode]) -> FunctionNode | None:
    """The function of the source that is called as a decorator."""
    callee = mark.func if isinstance(mark, ast.Call) else mark
    return decorators.get(callee.id) if isinstance(callee, ast.Name) else None


def _gives_back(maker: FunctionNode) -> bool:
    """Whether a decorator only takes note of what it is given: it returns no function of its own, perhaps but one that takes note."""
    inner = {part.name: part for part in maker.body if isinstance(part, (ast.FunctionDef, ast.AsyncFunctionDef))}
    names = {one.arg for one in maker.args.args}
    values = [_name(part.value) if part.value else "" for part in _own_parts(maker) if isinstance(part, ast.Return)]
    return bool(values) and all(name in names or (name in inner and _gives_back(inner[name])) for name in values)


def _own_parts(function: FunctionNode) -> Iterator[ast.AST]:
    """The nodes of a function without those of functions in it."""
    waiting: list[ast.AST] = list(function.body)
    while waiting:
        part = waiting.pop()
        yield part
        if not isinstance(part, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)):
            waiting += ast.iter_child_nodes(part)


def _may_be_skipped(function: FunctionNode, maker: FunctionNode, mark: ast.expr) -> None:
    """Whether the body of `function` runs is up to what its decorator makes of it: it runs if something is so that is not known."""
    if any(isinstance(part, (ast.Yield, ast.YieldFrom)) for part in _own_parts(function)):
        return
    asked = ast.copy_location(ast.Name(f"{maker.name}_runs_it", ast.Load()), mark)
    condition = ast.copy_location(ast.Call(asked, [], []), mark)
    function.body = [ast.copy_location(ast.If(condition, function.body, []), function.body[0])]


def _wrapper(maker: FunctionNode, mark: ast.expr) -> _Wrapper:
    bound: dict[str, ast.expr] = {}
    if isinstance(mark, ast.Call):
        inner = _returned(maker)
        bound = _arguments(maker, mark)
        maker = inner
    arguments = maker.args
    more = arguments.posonlyargs or arguments.kwonlyargs or arguments.vararg or arguments.kwarg or arguments.defaults
    if more or len(arguments.args) != 1:
        raise _NotUnderstood
    return _Wrapper(_returned(maker), arguments.args[0].arg, bound)


def _returned(maker: FunctionNode) -> FunctionNode:
    """The function that `maker` defines and returns, and does nothing else."""
    body = [part for part in maker.body if not (isinstance(part, ast.Expr) and isinstance(part.value, ast.Constant))]
    match body:
        case [ast.FunctionDef() | ast.AsyncFunctionDef() as inner, ast.Return(value=ast.Name(id=name))] if name == inner.name:
            if all(_keeps_name(mark) for mark in inner.decorator_list):
                return inner
    raise _NotUnderstood


def _keeps_name(mark: ast.expr) -> bool:
    """`@functools.wraps(f)`."""
    match mark:
        case ast.Call(func=ast.Name(id="wraps") | ast.Attribute(attr="wraps")):
            return True
    return False


def _arguments(maker: FunctionNode, mark: ast.Call) -> dict[str, ast.expr]:
    """What the parameters of `maker` are given, as far as these are constants."""
    names = [one.arg for one in maker.args.args]
    if maker.args.vararg or maker.args.kwarg or maker.args.posonlyargs or maker.args.kwonlyargs or len(mark.args) > len(names):
        raise _NotUnderstood
    defaults = maker.args.defaults
    given = dict(zip(names[len(names) - len(defaults) :], defaults, strict=True))
    given |= dict(zip(names, mark.args, strict=False))
    given |= {keyword.arg: keyword.value for keyword in mark.keywords if keyword.arg}
    if set(given) != set(names) or not all(isinstance(value, ast.Constant) for value in given.values()):
        raise _NotUnderstood
    return given


def _around(function: FunctionNode, inner_name: str, wrapper: _Wrapper, in_class: bool) -> FunctionNode:
    """`function` as the wrapper makes it, which calls it by another name."""
    receiver = function.args.args[0].arg if in_class and function.args.args else ""
    if in_class and (not receiver or function.args.posonlyargs or any(_of_class(mark) for mark in function.decorator_list)):
        raise _NotUnderstood
    if isinstance(function, ast.AsyncFunctionDef) != isinstance(wrapper.node, ast.AsyncFunctionDef):
        raise _NotUnderstood
    node = copy.deepcopy(wrapper.node)
    node.name = function.name
    node.decorator_list = function.decorator_list[:-1]
    changed = _Inlined(function, inner_name, wrapper, receiver, node)
    node.body = [changed.visit(part) for part in node.body]
    node.args = changed.parameters
    return node


def _of_class(mark: ast.expr) -> bool:
    return isinstance(mark, ast.Name) and mark.id in ("staticmethod", "classmethod", "property")


class _Inlined(ast.NodeTransformer):
    """The body of a wrapper around `function`: names of its own, what the decorator is given, and calls of the function by its name."""

    def __init__(self, function: FunctionNode, inner_name: str, wrapper: _Wrapper, receiver: str, node: FunctionNode) -> None:
        self._function, self._inner_name, self._wrapper, self._receiver = function, inner_name, wrapper, receiver
        own = node.args
        if own.posonlyargs or own.kwonlyargs or own.defaults or (own.kwarg and not own.vararg):
            raise _NotUnderstood
        self._rest = [one.arg for one in (own.vararg, own.kwarg) if one is not None]
        self._named = [one.arg for one in own.args]
        self.parameters = self._signature(own)
        self._first = self.parameters.args[0].arg if receiver else ""
        stored = {part.id for part in ast.walk(node) if isinstance(part, ast.Name) and isinstance(part.ctx, ast.Store)}
        stored |= {part.name for part in ast.walk(node) if isinstance(part, ast.ExceptHandler) and part.name}
        if stored & {*self._named, *wrapper.bound, wrapper.given, *self._rest}:
            raise _NotUnderstood
        self._local = {name: f"{name}_{function.name}" for name in stored}

    def _signature(self, own: ast.arguments) -> ast.arguments:
        """What is called has the parameters of the wrapper; where that passes on all that it is given, those of the function."""
        theirs = self._function.args
        if not self._rest:
            signature = copy.deepcopy(own)
            for mine, other in zip(signature.args, theirs.args, strict=False):
                mine.annotation = mine.annotation or other.annotation
            return signature
        if theirs.vararg or theirs.kwarg or theirs.kwonlyargs or theirs.posonlyargs or len(self._named) > len(theirs.args):
            raise _NotUnderstood
        signature = copy.deepcopy(theirs)
        for mine, named in zip(signature.args, self._named, strict=False):
            mine.arg = named
        return signature

    def visit_Call(self, node: ast.Call) -> ast.AST:
        if not (isinstance(node.func, ast.Name) and node.func.id == self._wrapper.given):
            return self.generic_visit(node)
        arguments, keywords = list(node.args), list(node.keywords)
        if self._rest:
            passed = [_name(one.value) if isinstance(one, ast.Starred) else _name(one) for one in arguments]
            passed += [_name(keyword.value) for keyword in keywords if keyword.arg is None]
            if passed != [*self._named, *self._rest] or any(keyword.arg for keyword in keywords):
                raise _NotUnderstood
            names = [one.arg for one in self.parameters.args]
            arguments, keywords = [ast.copy_location(ast.Name(name, ast.Load()), node) for name in names], []
        callee: ast.expr = ast.copy_location(ast.Name(self._inner_name, ast.Load()), node.func)
        if self._receiver:
            if not arguments or _name(arguments[0]) != self._first:
                raise _NotUnderstood
            callee = ast.copy_location(ast.Attribute(arguments.pop(0), self._inner_name, ast.Load()), node.func)
        inner = [self.visit(one) for one in arguments]
        for keyword in keywords:
            keyword.value = self.visit(keyword.value)
        return ast.copy_location(ast.Call(callee, inner, keywords), node)

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        if _name(node.value) == self._wrapper.given and node.attr == "__name__":
            return ast.copy_location(ast.Constant(self._function.name), node)
        return self.generic_visit(node)

    def visit_Subscript(self, node: ast.Subscript) -> ast.AST:
        match node:
            case ast.Subscript(value=ast.Name(id=rest), slice=ast.Constant(value=int(index)), ctx=ast.Load()) if (
                self._rest and rest == self._rest[0] and 0 <= index + len(self._named) < len(self.parameters.args)
            ):
                return ast.copy_location(ast.Name(self.parameters.args[index + len(self._named)].arg, ast.Load()), node)
        return self.generic_visit(node)

    def visit_Name(self, node: ast.Name) -> ast.AST:
        if node.id == self._wrapper.given or node.id in self._rest:
            raise _NotUnderstood
        if node.id in self._wrapper.bound:
            return ast.copy_location(copy.deepcopy(self._wrapper.bound[node.id]), node)
        node.id = self._local.get(node.id, node.id)
        return node

    def visit_ExceptHandler(self, node: ast.ExceptHandler) -> ast.AST:
        node.name = self._local.get(node.name, node.name) if node.name else None
        return self.generic_visit(node)

    def _refuse(self, node: ast.AST) -> ast.AST:
        raise _NotUnderstood

    # names that belong to the decorator, or to functions that the places of the source identify
    visit_Lambda = visit_FunctionDef = visit_AsyncFunctionDef = visit_ClassDef = visit_Nonlocal = visit_Global = _refuse
    visit_Yield = visit_YieldFrom = _refuse


def _name(node: ast.expr) -> str:
    return node.id if isinstance(node, ast.Name) else ""
