"""Attributes that are named by a text, as attributes: `getattr(x, "name")` is `x.name`, `setattr(x, "name", value)` gives it a value."""

from __future__ import annotations

import ast


def name_attributes(tree: ast.Module) -> None:
    """Change the tree in place."""
    for node in ast.walk(tree):
        for name, value in ast.iter_fields(node):
            if isinstance(value, list):
                value[:] = [_named(part) for part in value]
            elif isinstance(value, ast.Call):
                setattr(node, name, _named(value))


def _named(node: ast.AST) -> ast.AST:
    match node:
        case ast.Call(func=ast.Name(id="getattr"), args=[owner, ast.Constant(value=str(name))], keywords=[]) if name.isidentifier():
            return ast.copy_location(ast.Attribute(owner, name, ast.Load()), node)
        case ast.Expr(value=ast.Call(func=ast.Name(id="setattr"), args=[owner, ast.Constant(value=str(name)), value])) if (
            name.isidentifier()
        ):
            target = ast.copy_location(ast.Attribute(owner, name, ast.Store()), node)
            return ast.copy_location(ast.Assign([target], value), node)
    return node
