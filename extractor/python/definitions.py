"""Functions, classes, modules and imports: what definitions do, and the bodies of what they define."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from rosarch.extractor.flow import Flow
from rosarch.extractor.python.body import Body
from rosarch.extractor.python.model import Function, Module
from rosarch.extractor.python.shapes import defaults_of
from rosarch.extractor.python_syntax import absolute_name


def lower_function(body: Body, function: Function) -> None:
    """Record a function: its parameters' defaults, its body, its control-flow graph."""
    from rosarch.extractor.python.expressions import lower

    facts, node, scope = body.facts, function.node, function.scope
    if node is None or scope is None or function.module is None:
        return
    name = facts.function(function)
    facts.add("function_defined", name)
    outside = Body(facts, function.module, body.scope, Flow())
    defaults = defaults_of(node.args)
    for parameter in function.parameters:
        if parameter.name in defaults:
            facts.add("parameter_default", facts.variable(parameter), lower(outside, defaults[parameter.name], text=True))
    inner = Body(facts, function.module, scope, Flow(), name)
    if isinstance(node, ast.Lambda):
        value = lower(inner, node.body, text=True)
        facts.add("return_value", name, value)
        inner.flow.evaluate(value)
    else:
        _lower_statements(inner, node.body)
    inner.flow.write(facts, name)


def lower_module(facts_body: Body, module: Module) -> None:
    """Record the body of a module: a function that runs when the module is imported, or as a program."""
    facts = facts_body.facts
    name = facts.function(module.function)
    facts.add("function_defined", name)
    body = Body(facts, module, module.scope, Flow(), name)
    _lower_statements(body, module.tree.body)
    body.flow.write(facts, name)


def lower_lambda(body: Body, node: ast.Lambda) -> str:
    """A lambda expression; its body is a function of its own."""
    expr = body.node(node, "lambda")
    function = body.module.functions.get(node)
    if function is not None:
        lower_function(body, function)
        body.facts.add("lambda", expr, function.identifier)
    return expr


def lower_definition(body: Body, node: ast.FunctionDef | ast.AsyncFunctionDef) -> None:
    """A function is made: its decorators are called with it."""
    function = body.module.functions.get(node)
    if function is not None:
        if isinstance(node, ast.AsyncFunctionDef):
            body.facts.add("function_annotation", body.facts.function(function), "async")
        _decorators(body, node.decorator_list, function)
        lower_function(body, function)


def _decorators(body: Body, nodes: Sequence[ast.expr], function: Function) -> None:
    """A decorator is called with the function; those of the language are no more than marks."""
    from rosarch.extractor.python.expressions import function_use, lower

    for node in nodes:
        body.facts.add("function_annotation", body.facts.function(function), body.text(node))
        values = body.inference.values(node, body.scope)
        if isinstance(node, ast.Name) and not any(getattr(value, "function", None) for value in values):
            continue
        callee = lower(body, node)
        call = body.node(node, "call")
        body.facts.add("call", call, "decorator")
        body.facts.add("call_through", call, callee)
        body.facts.add("call_argument", call, 0, function_use(body, node, [function]))
        body.flow.evaluate(call)


def lower_class(body: Body, node: ast.ClassDef) -> None:
    """What is in a class is evaluated when the class is defined; the methods are functions of their own."""
    cls = body.module.classes.get(node)
    if cls is None or cls.scope is None:
        return
    body.facts.cls(cls)
    inner = Body(body.facts, body.module, cls.scope, Flow())
    _lower_statements(inner, node.body)


def lower_import(body: Body, node: ast.Import | ast.ImportFrom) -> None:
    """A module of the workspace runs when it is imported first."""
    if isinstance(node, ast.Import):
        run_modules(body, node, [alias.name for alias in node.names])
    else:
        path = absolute_name(node.module or "", node.level, body.module.package)
        run_modules(body, node, [path, *(f"{path}.{alias.name}" for alias in node.names)])
        package, _, part = path.partition(".")
        if part in ("msg", "srv", "action") and body.facts.program.modules.get(path) is None:
            for alias in node.names:
                expr = body.node(alias, "import")
                body.facts.add("interface_import", expr, package, part, alias.name)
                body.flow.evaluate(expr)


def run_modules(body: Body, node: ast.AST, paths: Sequence[str]) -> None:
    """The modules at `paths`, and the packages that they are in, are imported: those of the workspace run."""
    program = body.facts.program
    parts = [path.split(".") for path in paths]
    for path in dict.fromkeys(".".join(names[:count]) for names in parts for count in range(1, len(names) + 1)):
        module = program.modules.get(path)
        if module is not None and not module.stub and module is not body.module:
            call = body.node(node, "call")
            body.facts.add("call", call, "import")
            body.facts.add("call_function", call, body.facts.function(module.function))
            body.flow.evaluate(call)


def _lower_statements(body: Body, nodes: Sequence[ast.stmt]) -> None:
    from rosarch.extractor.python.statements import lower_statements  # these hold definitions

    lower_statements(body, nodes)
