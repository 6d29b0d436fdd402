"""Statements: the shape of the control-flow graph, and the expressions in it."""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence

from rosarch.extractor.python import definitions
from rosarch.extractor.python.body import Body
from rosarch.extractor.python.model import Variable
from rosarch.extractor.python.shapes import field_of
from rosarch.extractor.python.trying import leave, lower_try

_AUGMENTED: dict[type[ast.operator], str] = {
    ast.Add: "+=", ast.Sub: "-=", ast.Mult: "*=", ast.Div: "/=", ast.FloorDiv: "/=", ast.Mod: "%=", ast.Pow: "*=",
    ast.LShift: "<<=", ast.RShift: ">>=", ast.BitOr: "|=", ast.BitAnd: "&=", ast.BitXor: "^=", ast.MatMult: "*=",
}  # fmt: skip


def lower_statements(body: Body, nodes: Sequence[ast.stmt]) -> None:
    """Record statements in a row."""
    for node in nodes:
        _STATEMENTS.get(type(node), _expressions_of)(body, node)


def assign(body: Body, target: ast.expr, value: str, node: ast.AST, whole: ast.expr | None = None) -> None:
    """`target` is given `value`; its parts get parts of it, which are written as elements of the `whole`."""
    from rosarch.extractor.python.expressions import call_setters, literal, lower

    if isinstance(target, (ast.Tuple, ast.List)):
        for index, part in enumerate(target.elts):
            element = body.operator(part, "[]", value, literal(body, part, index))
            if whole is not None:
                body.facts.add("expr_text", element, f"{_operand_text(body, whole)}[{index}]")
            assign(body, part.value if isinstance(part, ast.Starred) else part, element, part)
        return
    if call_setters(body, target, value):
        return
    place = lower(body, target, text=True)
    body.flow.evaluate(body.operator(node, "=", place, value))


def _operand_text(body: Body, node: ast.expr) -> str:
    """The text of an expression as an operand, in brackets where it needs them."""
    text = body.text(node)
    alone = isinstance(node, (ast.Name, ast.Attribute, ast.Call, ast.Subscript, ast.Constant)) or text.startswith(("(", "["))
    return text if alone else f"({text})"


def _assign(body: Body, node: ast.Assign) -> None:
    from rosarch.extractor.python.expressions import lower

    target = node.targets[0]
    if len(node.targets) == 1 and isinstance(target, (ast.Tuple, ast.List)) and isinstance(node.value, (ast.Tuple, ast.List)):
        parts = node.value.elts
        starred = any(isinstance(part, ast.Starred) for part in (*parts, *target.elts))
        if len(parts) == len(target.elts) and not starred and not _exchanges(target.elts, parts):
            values = [lower(body, part, text=True) for part in parts]
            for part, value in zip(target.elts, values, strict=True):
                assign(body, part, value, part)
            return
    value = lower(body, node.value, text=True)
    if len(node.targets) == 1 and _declares(body, target, value, node):
        return
    for target in node.targets:
        assign(body, target, value, node, node.value)


def _exchanges(targets: Sequence[ast.expr], values: Sequence[ast.expr]) -> bool:
    """Whether a value reads what a target before it is given: `a, b = b, a` is no assignment after the other."""
    written: set[str] = set()
    for target, value in zip(targets, values, strict=True):
        if written and any(isinstance(part, ast.expr) and ast.unparse(part) in written for part in ast.walk(value)):
            return True
        written.add(ast.unparse(target))
    return False


def _declares(body: Body, target: ast.expr, value: str, node: ast.stmt) -> bool:
    """Record `value` as that of the variable that `node` declares; whether it is the first assignment, and declares one."""
    variable = _variable(body, target)
    if variable is None or variable.first is not node:
        return False
    if variable.owner is not None:
        variable = field_of(variable.owner, variable)
    body.facts.add("variable_initializer", body.facts.variable(variable), value)
    body.flow.evaluate(value)
    return True


def _variable(body: Body, target: ast.expr) -> Variable | None:
    """The variable that an assignment to a name is to."""
    symbol = body.scope.holder(target.id).names.get(target.id) if isinstance(target, ast.Name) else None
    return symbol if isinstance(symbol, Variable) else None


def _annotated(body: Body, node: ast.AnnAssign) -> None:
    from rosarch.extractor.python.expressions import lower

    if node.value is not None:
        value = lower(body, node.value, text=True)
        if not _declares(body, node.target, value, node):
            assign(body, node.target, value, node)


def _augmented(body: Body, node: ast.AugAssign) -> None:
    from rosarch.extractor.python.expressions import lower

    target, value = lower(body, node.target, text=True), lower(body, node.value, text=True)
    body.flow.evaluate(body.operator(node, _AUGMENTED[type(node.op)], target, value))


def _expression(body: Body, node: ast.Expr) -> None:
    from rosarch.extractor.python.expressions import lower

    if not isinstance(node.value, ast.Constant):
        lower(body, node.value, text=True)


def _expressions_of(body: Body, node: ast.stmt) -> None:
    """A statement without facts of its own."""
    from rosarch.extractor.python.expressions import lower

    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.expr):
            lower(body, child)


def _delete(body: Body, node: ast.Delete) -> None:
    from rosarch.extractor.python.expressions import lower

    for target in node.targets:
        body.flow.evaluate(body.operator(target, "delete", lower(body, target)))


def _if(body: Body, node: ast.If) -> None:
    from rosarch.extractor.python.expressions import lower

    flow = body.flow
    yes, no = flow.branch(lower(body, node.test, text=True))
    after = flow.block()
    flow.start(yes)
    lower_statements(body, node.body)
    flow.to(after)
    flow.start(no)
    lower_statements(body, node.orelse)
    flow.to(after)
    flow.start(after)


def _loop(body: Body, kind: str, test: Callable[[], str], inner: Callable[[], None], orelse: Sequence[ast.stmt] = ()) -> None:
    """A loop; what is in its `else` follows when it is not left by `break`."""
    flow = body.flow
    loop = flow.loop()
    with flow.within(loop.test):
        head = flow.block()
        flow.to(head)
        flow.start(head)
        condition = test()
    loop.head = flow.current
    flow.current.loop = kind
    after = flow.block()
    ended = flow.block() if orelse else after
    with flow.within(loop.body):
        start = flow.block()
        flow.current.condition = condition
        flow.to(start, "true")
        flow.to(ended, "false")
        flow.start(start)
        with flow.breaking(after, head):
            inner()
        flow.to(head)
    if orelse:
        flow.start(ended)
        lower_statements(body, orelse)
        flow.to(after)
    flow.start(after)


def _while(body: Body, node: ast.While) -> None:
    from rosarch.extractor.python.expressions import lower

    _loop(body, "while", lambda: lower(body, node.test, text=True), lambda: lower_statements(body, node.body), node.orelse)


def _for(body: Body, node: ast.For | ast.AsyncFor) -> None:
    container = _begin_range(body, node.target, node.iter)

    def inner() -> None:
        _take_apart(body, node.target, container)
        lower_statements(body, node.body)

    _loop(body, "range_for", lambda: container, inner, node.orelse)


def _begin_range(body: Body, target: ast.expr, container: ast.expr) -> str:
    """The loop variable runs over `container`."""
    from rosarch.extractor.python.expressions import lower

    expr = lower(body, container, text=True)
    variable = _variable(body, target)
    if variable is not None:
        body.facts.add("range_variable", body.facts.variable(variable), expr)
        body.flow.evaluate(expr)
    return expr


def _take_apart(body: Body, target: ast.expr, container: str) -> None:
    """`for a, b in container`: each gets its part of an element."""
    from rosarch.extractor.python.expressions import literal

    if not isinstance(target, ast.Name):
        element = body.operator(target, "[]", container, literal(body, target, None))
        assign(body, target, element, target)


def lower_comprehension(body: Body, node: ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp) -> str:
    """A loop that makes a container of what it gives."""
    from rosarch.extractor.python.expressions import lower

    made: list[str] = []

    def generate(rest: Sequence[ast.comprehension]) -> None:
        if not rest:
            if isinstance(node, ast.DictComp):
                made.append(body.operator(node.key, ":", lower(body, node.key), lower(body, node.value)))
            else:
                made.append(lower(body, node.elt))
            return
        first = rest[0]
        container = _begin_range(body, first.target, first.iter)

        def inner() -> None:
            _take_apart(body, first.target, container)
            after = body.flow.block()
            for test in first.ifs:
                yes, no = body.flow.branch(lower(body, test, text=True))
                body.flow.start(no)
                body.flow.to(after)
                body.flow.start(yes)
            generate(rest[1:])
            body.flow.to(after)
            body.flow.start(after)

        _loop(body, "range_for", lambda: container, inner)

    generate(node.generators)
    return body.operator(node, "{}", *made, form="list")


def _with(body: Body, node: ast.With | ast.AsyncWith) -> None:
    from rosarch.extractor.python.expressions import lower

    for item in node.items:
        value = _entered(body, item.context_expr, lower(body, item.context_expr, text=True))
        if item.optional_vars is not None:
            assign(body, item.optional_vars, value, item.optional_vars)
    lower_statements(body, node.body)


def _entered(body: Body, node: ast.expr, value: str) -> str:
    """What `with` gives: what the method `__enter__` of the workspace returns, else the object itself.

    An object of elsewhere that is not made here is a lock: it is acquired (https://docs.python.org/3/library/threading.html#with-locks).
    """
    entering = body.inference.entering(node, body.scope)
    if not entering and isinstance(node, ast.Call):
        return value
    call = body.node(node, "call")
    body.facts.add("call", call, "__enter__" if entering else "acquire")
    body.facts.add("call_receiver", call, value)
    for function in entering:
        body.facts.add("call_function", call, body.facts.function(function))
    body.flow.evaluate(call)
    return call if entering else value


def _return(body: Body, node: ast.Return) -> None:
    from rosarch.extractor.python.expressions import lower

    if node.value is not None:
        expr = lower(body, node.value, text=True)
        body.facts.add("return_value", body.function, expr)
        body.flow.evaluate(expr)
    leave(body, 0, body.flow.leave)


def _raise(body: Body, node: ast.Raise) -> None:
    from rosarch.extractor.python.expressions import lower

    operands = [lower(body, part) for part in (node.exc, node.cause) if part is not None]
    expr = body.operator(node, "throw", *operands, form="throw")
    body.flow.evaluate(expr)
    body.flow.throw()


def _assert(body: Body, node: ast.Assert) -> None:
    """`if not test: raise AssertionError`."""
    from rosarch.extractor.python.expressions import lower

    holds, fails = body.flow.branch(lower(body, node.test, text=True))
    body.flow.start(fails)
    operands = [lower(body, node.msg)] if node.msg is not None else []
    body.flow.evaluate(body.operator(node, "throw", *operands, form="throw"))
    body.flow.throw()
    body.flow.start(holds)


def _match(body: Body, node: ast.Match) -> None:
    """One case after the other is asked for."""
    from rosarch.extractor.python.expressions import lower

    flow = body.flow
    subject = lower(body, node.subject, text=True)
    after = flow.block()
    for case in node.cases:
        if isinstance(case.pattern, ast.MatchAs) and case.pattern.pattern is None and case.guard is None:
            lower_statements(body, case.body)
            break
        if isinstance(case.pattern, ast.MatchValue):
            condition = body.operator(case.pattern, "==", subject, lower(body, case.pattern.value))
        else:
            condition = body.node(case.pattern, "unknown")
            body.facts.add("operand", condition, 0, subject)
            body.facts.add("expr_unknown", condition, "pattern")
        body.facts.add("expr_text", condition, f"{body.text(node.subject)} == {body.text(case.pattern)}")
        yes, no = flow.branch(condition)
        flow.start(yes)
        if case.guard is not None:
            inside, outside = flow.branch(lower(body, case.guard, text=True))
            flow.start(outside)
            flow.to(no)
            flow.start(inside)
        lower_statements(body, case.body)
        flow.to(after)
        flow.start(no)
    flow.to(after)
    flow.start(after)


def _nothing(_body: Body, _node: ast.stmt) -> None:
    """A statement that does nothing by itself."""


_STATEMENTS: dict[type[ast.stmt], Callable[..., None]] = {
    ast.Expr: _expression,
    ast.Assign: _assign,
    ast.AnnAssign: _annotated,
    ast.AugAssign: _augmented,
    ast.Delete: _delete,
    ast.If: _if,
    ast.While: _while,
    ast.For: _for,
    ast.AsyncFor: _for,
    ast.With: _with,
    ast.AsyncWith: _with,
    ast.Try: lower_try,
    ast.Return: _return,
    ast.Raise: _raise,
    ast.Assert: _assert,
    ast.Match: _match,
    ast.FunctionDef: definitions.lower_definition,
    ast.AsyncFunctionDef: definitions.lower_definition,
    ast.ClassDef: definitions.lower_class,
    ast.Import: definitions.lower_import,
    ast.ImportFrom: definitions.lower_import,
    ast.Break: lambda body, _node: leave(body, body.flow.loops, body.flow.break_),
    ast.Continue: lambda body, _node: leave(body, body.flow.loops, body.flow.continue_),
    ast.Global: _nothing,
    ast.Nonlocal: _nothing,
    ast.Pass: _nothing,
}
