"""Texts that are put together: f-strings, `%` and `format` as chains of `+` and `%`."""

from __future__ import annotations

import ast
import string
from collections.abc import Callable, Sequence

from rosarch.extractor.python.body import Body


def percent(body: Body, node: ast.BinOp, values: Sequence[str]) -> str:
    """`format % (a, b)` fills one place after the other."""
    from rosarch.extractor.python.expressions import lower

    expr = lower(body, node.left)
    for value in values:
        expr = body.operator(node, "%", expr, value)
    return expr


def joined(body: Body, node: ast.JoinedStr) -> str:
    """An f-string is the sum of its parts."""
    from rosarch.extractor.python.expressions import literal, lower

    parts: list[Callable[[], str]] = []
    for part in node.values:
        if isinstance(part, ast.FormattedValue):
            parts.append(lambda part=part: lower(body, part.value))  # type: ignore[misc]
        elif isinstance(part, ast.Constant):
            parts.append(lambda part=part: literal(body, node, part.value))  # type: ignore[misc]
    return _sum(body, node, parts)


def format_call(body: Body, node: ast.Call) -> str | None:
    """`"...{}...".format(a, b)`; None when the format is not written out."""
    from rosarch.extractor.python.expressions import literal, lower

    match node.func:
        case ast.Attribute(value=ast.Constant(value=str(text)), attr="format"):
            pass
        case _:
            return None
    named = {keyword.arg: keyword.value for keyword in node.keywords if keyword.arg}
    parts: list[Callable[[], str]] = []
    count = 0
    try:
        pieces = list(string.Formatter().parse(text))
    except ValueError:
        return None
    for before, name, _spec, _conversion in pieces:
        if before:
            parts.append(lambda before=before: literal(body, node, before))  # type: ignore[misc]
        if name is None:
            continue
        first = name.partition(".")[0].partition("[")[0]
        if first == "":
            first, count = str(count), count + 1
        value = node.args[int(first)] if first.isdigit() and int(first) < len(node.args) else named.get(first)
        if value is None or isinstance(value, ast.Starred) or first != (name or first):
            return None
        parts.append(lambda value=value: lower(body, value))  # type: ignore[misc]
    return _sum(body, node, parts)


def _sum(body: Body, node: ast.expr, parts: Sequence[Callable[[], str]]) -> str:
    """It begins with a text, so that no number is added to another."""
    from rosarch.extractor.python.expressions import literal

    expr = literal(body, node, "")
    for part in parts:
        expr = body.operator(node, "+", expr, part())
    return expr
