"""What is named by a text, as what it is: `getattr(x, "name")` is `x.name`, `setattr(x, "name", value)` gives it a value.

`type(self).name` is read as `self.name`, which finds it too.

`locals()[name](...)` calls one of the functions that the function around it declares: it looks `name` up in a dictionary of these.
"""

from __future__ import annotations

import ast


def name_what_texts_name(tree: ast.Module) -> None:
    """Change the tree in place."""
    functions = [node for node in ast.walk(tree) if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))]
    for function in reversed(functions):  # inner ones first: they have names of their own
        _name_functions(function)
    for node in ast.walk(tree):
        _name_of_object(node)
        for name, value in ast.iter_fields(node):
            if isinstance(value, list):
                value[:] = [_named(part) for part in value]
            elif isinstance(value, ast.Call):
                setattr(node, name, _named(value))


def _name_functions(function: ast.FunctionDef | ast.AsyncFunctionDef) -> None:
    for node in ast.walk(function):
        match node:
            case ast.Call(func=ast.Subscript(value=ast.Call(func=ast.Name(id="locals"), args=[], keywords=[]) as all_names) as chosen):
                names = [part.name for part in function.body if isinstance(part, (ast.FunctionDef, ast.AsyncFunctionDef))]
                keys = [ast.copy_location(ast.Constant(name), all_names) for name in names]
                values = [ast.copy_location(ast.Name(name, ast.Load()), all_names) for name in names]
                chosen.value = ast.copy_location(ast.Dict([*keys], [*values]), all_names)


def _name_of_object(node: ast.AST) -> None:
    match node:
        case ast.Attribute(value=ast.Call(func=ast.Name(id="type"), args=[owner], keywords=[])) if not node.attr.startswith("__"):
            node.value = owner
        case ast.Attribute(value=ast.Attribute(value=owner, attr="__class__")) if not node.attr.startswith("__"):
            node.value = owner


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
