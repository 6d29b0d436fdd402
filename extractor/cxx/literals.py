"""Literals: their kind and value."""

from __future__ import annotations

import ast
import re

from rosarch.extractor.cxx import libclang
from rosarch.extractor.cxx.body import Body
from rosarch.extractor.cxx.libclang import Tree

_SUFFIX = re.compile(r"[uUlLzZ]+$")
_FLOAT_SUFFIX = re.compile(r"[lLfF]+$")


def integer(body: Body, tree: Tree) -> str:
    """An integer literal; one from a macro is evaluated by clang."""
    expr, span = body.node(tree, "num")
    text = _SUFFIX.sub("", body.unit.text(span).replace("'", ""))
    try:
        value = str(int(text, 8) if re.fullmatch(r"0[0-7]+", text) else int(text, 0))
    except ValueError:
        number = libclang.evaluate(tree.cursor)
        value = str(number) if number is not None else "0"
    body.unit.add("literal", expr, "integer", value)
    return expr


def floating(body: Body, tree: Tree) -> str:
    """A floating-point literal, normalised to its shortest decimal form."""
    expr, span = body.node(tree, "num")
    try:
        value = repr(float(_FLOAT_SUFFIX.sub("", body.unit.text(span))))
    except ValueError:
        number = libclang.evaluate(tree.cursor)
        value = repr(float(number)) if number is not None else "0.0"
    body.unit.add("literal", expr, "float", value)
    return expr


def decode_string(spelling: str) -> str:
    """Return the characters of a C++ string literal as clang spells it."""
    inner = spelling[spelling.find('"') + 1 : spelling.rfind('"')]
    if "\\" not in inner:
        return inner
    try:
        decoded = str(ast.literal_eval('"' + inner + '"'))
        return decoded.encode("latin-1").decode("utf-8", "replace")  # clang spells bytes, one escape each
    except (SyntaxError, ValueError):
        return inner


def string(body: Body, tree: Tree) -> str:
    """A string literal; adjacent ones count as one.

    Definitions of CMake files may put paths into it: one below the workspace is given relative to it, the same wherever the workspace lies.
    """
    expr, _ = body.node(tree, "str")
    body.unit.add("literal", expr, "string", decode_string(libclang.spelling(tree.cursor)).replace(f"{body.unit.root}/", ""))
    return expr


def character(body: Body, tree: Tree) -> str:
    """A character literal."""
    expr, span = body.node(tree, "char")
    text = body.unit.text(span)
    body.unit.add("literal", expr, "character", text[1:-1] if len(text) > 2 and text[0] == "'" else text)
    return expr


def boolean(body: Body, tree: Tree) -> str:
    """`true` or `false`."""
    expr, span = body.node(tree, "bool")
    text = body.unit.text(span)
    if text not in ("true", "false"):
        text = "true" if libclang.evaluate(tree.cursor) else "false"
    body.unit.add("literal", expr, "boolean", text)
    return expr


def null(body: Body, tree: Tree) -> str:
    """`nullptr` or `NULL`."""
    expr, _ = body.node(tree, "null")
    body.unit.add("literal", expr, "null", "nullptr")
    return expr
