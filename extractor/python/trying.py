"""What may fail: `try`, and what `finally` has done on every way out."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, nullcontext

from rosarch.extractor.python.body import Body

MOST_REPEATED = 2_000
"""Statements; where a `finally` would come to more, where it goes on after an exception is not distinguished."""
_EVERYTHING = ("Exception", "BaseException")


def lower_try(body: Body, node: ast.Try) -> None:
    """What is in `finally` follows in any case: after an exception too, which goes on then."""
    from rosarch.extractor.python.statements import lower_statements

    flow = body.flow
    after = flow.block()
    unhandled = flow.block() if _can_be_repeated(node) else None
    with flow.catching([unhandled], False) if unhandled is not None else nullcontext():
        handlers = [flow.block() for _ in node.handlers]  # what they raise is passed on
    catches_all = any(_catches_all(handler) for handler in node.handlers)
    caught = [*handlers, *([unhandled] if unhandled is not None and not catches_all else [])] or [after]
    with _finally(body, node.finalbody if unhandled is not None else []):
        with flow.catching(caught, catches_all or (bool(node.finalbody) and unhandled is None)):
            start = flow.block()
            flow.to(start)
            flow.start(start)
            lower_statements(body, node.body)
        with flow.catching([unhandled], False) if unhandled is not None else nullcontext():
            lower_statements(body, node.orelse)
            flow.to(after)
            for block, handler in zip(handlers, node.handlers, strict=True):
                flow.start(block)
                if handler.type is not None:
                    lower_statements(body, [ast.copy_location(ast.Expr(handler.type), handler)])
                lower_statements(body, handler.body)
                flow.to(after)
    if unhandled is not None:
        flow.start(unhandled)
        lower_statements(body, node.finalbody)
        flow.throw()
    flow.start(after)
    lower_statements(body, node.finalbody)


def _can_be_repeated(node: ast.Try) -> bool:
    """Whether `finally` can be read once for each way that leads to it: it defines nothing, and that is not too much in all."""
    if not node.finalbody or _ways(node) * _read(node.finalbody) > MOST_REPEATED:
        return False
    defining = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)
    return not any(isinstance(part, defining) for statement in node.finalbody for part in ast.walk(statement))


def _ways(node: ast.Try) -> int:
    """How many ways lead to `finally`, at most."""
    leaving = (ast.Return, ast.Break, ast.Continue)
    return 2 + sum(isinstance(part, leaving) for part in ast.walk(node))


def _read(nodes: Iterable[ast.AST]) -> int:
    """How many statements are read for these, with those in them that are repeated."""
    total = 0
    for node in nodes:
        once = set(ast.iter_child_nodes(node))
        if isinstance(node, ast.Try) and node.finalbody:
            once -= set(node.finalbody)
            total += _ways(node) * _read(node.finalbody)
        total += 1 + _read(part for part in once if isinstance(part, (ast.stmt, ast.excepthandler, ast.match_case)))
    return total


@contextmanager
def _finally(body: Body, statements: Sequence[ast.stmt]) -> Iterator[None]:
    """Within, what leaves the function or a loop around does `statements` first."""
    if statements:
        body.finally_.append((statements, body.flow.loops))
    try:
        yield
    finally:
        if statements:
            body.finally_.pop()


def leave(body: Body, loops: int, go: Callable[[], None]) -> None:
    """Do what is in the `finally` of each `try` that is left, the innermost first; of those within `loops` loops or more."""
    from rosarch.extractor.python.statements import lower_statements

    around = body.finally_
    for index in reversed(range(len(around))):
        statements, depth = around[index]
        if depth < loops:
            break
        body.finally_ = around[:index]
        lower_statements(body, statements)
    body.finally_ = around
    go()


def _catches_all(handler: ast.ExceptHandler) -> bool:
    return handler.type is None or (isinstance(handler.type, ast.Name) and handler.type.id in _EVERYTHING)
