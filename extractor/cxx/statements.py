"""Statements: the shape of the control-flow graph, and the expressions in it."""

from __future__ import annotations

from collections.abc import Callable

from rosarch.extractor.cxx import kinds, libclang
from rosarch.extractor.cxx.body import Body, expressions, strip
from rosarch.extractor.cxx.calls import lower_dependent_construction
from rosarch.extractor.cxx.declarations import declare_parameter, declare_variable
from rosarch.extractor.cxx.expressions import lower_expression
from rosarch.extractor.cxx.libclang import Tree
from rosarch.extractor.cxx.libclang_library import Cursor
from rosarch.extractor.cxx.unit import DEEPEST, StructuredBinding
from rosarch.extractor.flow import Flow


def lower_statement(body: Body, tree: Tree) -> None:
    """Record the statement at `tree`."""
    if kinds.is_expression(tree.kind):
        lower_expression(body, tree, text=True)
        return
    unit = body.unit
    if unit.depth == DEEPEST:
        unit.deep.append(unit.span_of(tree))
        return
    unit.depth += 1
    lower = _STATEMENTS.get(tree.kind)
    if lower is not None:
        lower(body, tree)
    elif tree.kind >= kinds.UNEXPOSED_STATEMENT:
        for child in tree.children:
            lower_statement(body, child)
    unit.depth -= 1


def lower_lambda(body: Body, tree: Tree) -> str:
    """Record a lambda expression; its body is a function of its own."""
    expr, span = body.node(tree, "lambda")
    line, column = span.file.line_column(span.begin)
    function = f"lambda@{span.file.key}:{line}:{column}"
    unit = body.unit
    unit.add("function", function, "lambda")
    unit.add("function_name", function, "lambda")
    unit.add("location", function, span.file.key or "", line, column)
    unit.add("lambda", expr, function)
    inner = Body(unit, Flow(), function, body.owner)
    index = 0
    for child in tree.children:
        if child.kind == kinds.PARAMETER:
            declare_parameter(unit, function, index, child.cursor)
            index += 1
        elif child.kind == kinds.VARIABLE_REFERENCE:
            _capture(body, expr, libclang.target(child))
        elif child.kind == kinds.COMPOUND:
            lower_body(inner, child)
    return expr


def _capture(body: Body, expr: str, target: Cursor) -> None:
    if target.kind in (kinds.VARIABLE, kinds.PARAMETER):
        body.unit.add("lambda_captures", expr, declare_variable(body.unit, target))


def lower_body(body: Body, tree: Tree) -> None:
    """Record a function's body and its control-flow graph."""
    body.unit.add("function_defined", body.function)
    lower_statement(body, tree)
    body.unit.marks[body.function] = body.flow.write(body.unit, body.function)


def lower_variable(body: Body, tree: Tree) -> None:
    """Record a variable's declaration with its initial value."""
    variable = _declare(body, tree)
    values = expressions(tree)
    if libclang.cursor_type(tree.cursor).kind in kinds.TYPE_ARRAYS:
        values = [value for value in values if strip(value).kind in (kinds.INIT_LIST, kinds.STRING)]
    if values:
        bracketed = values[-1] if values[-1].kind == kinds.UNEXPOSED_EXPR else None
        made = lower_dependent_construction(body, tree, libclang.cursor_type(tree.cursor), bracketed) if bracketed else None
        value = made or lower_expression(body, values[-1], text=True)
        body.unit.add("variable_initializer", variable, value)
        body.flow.evaluate(value)


def _declare(body: Body, tree: Tree) -> str:
    """The variable at `tree`; of `auto [a, b] = value` the one without a name that holds the value."""
    variable = declare_variable(body.unit, tree.cursor, body.function)
    names = _bound(tree)
    if names:
        type_ = libclang.canonical_type(libclang.cursor_type(tree.cursor))
        fields = libclang.fields(libclang.pointee(type_) if type_.kind in _REFERENCES else type_)
        for index, name in enumerate(names):
            field = fields[index] if len(fields) == len(names) else None
            body.unit.bindings[name.cursor.d0 or 0] = StructuredBinding(variable, index, field)
    return variable


_REFERENCES = frozenset({kinds.TYPE_REFERENCE_LVALUE, kinds.TYPE_REFERENCE_RVALUE})


def _bound(tree: Tree) -> list[Tree]:
    """The names that a structured binding declares."""
    return [child for child in tree.children if child.kind == tree.kind == kinds.UNEXPOSED_DECLARATION]


def _is_variable(tree: Tree) -> bool:
    return tree.kind == kinds.VARIABLE or bool(_bound(tree))


def _lower_each(body: Body, tree: Tree) -> None:
    for child in tree.children:
        lower_statement(body, child)


def _lower_arm(body: Body, tree: Tree) -> None:
    """A statement that begins a block."""
    body.flow.mark(body.unit.span_of(tree).begin)
    lower_statement(body, tree)


def _lower_compound(body: Body, tree: Tree) -> None:
    """Statements in a row; clang drops those that it does not understand, so where each ends is marked."""
    body.flow.mark(body.unit.span_of(tree).begin)
    for child in tree.children:
        lower_statement(body, child)
        body.flow.mark(body.unit.span_of(child).end)
        if child.kind == kinds.COMPOUND:
            _end_variables(body, child)


def _end_variables(body: Body, tree: Tree) -> None:
    """Record where the variables of a block end that stands by itself."""
    span = body.unit.span_of(tree)
    line, _ = span.file.line_column(span.end)
    for child in tree.children:
        for declared in child.children if child.kind == kinds.DECLARATION_STATEMENT else ():
            if declared.kind == kinds.VARIABLE:
                body.unit.add("variable_ends", declare_variable(body.unit, declared.cursor, body.function), line)


def _lower_declaration(body: Body, tree: Tree) -> None:
    from rosarch.extractor.cxx.walk import walk_class  # a class in a function has functions of its own

    for child in tree.children:
        if _is_variable(child):
            lower_variable(body, child)
        elif child.kind in kinds.CLASSES:
            walk_class(body.unit, child.cursor)


def _condition(body: Body, trees: list[Tree]) -> str | None:
    """Read what precedes a condition, then the condition, the last of `trees`."""
    for tree in trees[:-1]:
        lower_variable(body, tree) if tree.kind == kinds.VARIABLE else lower_statement(body, tree)
    if not trees:
        return None
    if trees[-1].kind == kinds.VARIABLE:
        lower_variable(body, trees[-1])
        return None
    return lower_expression(body, trees[-1], text=True) if kinds.is_expression(trees[-1].kind) else None


def _lower_if(body: Body, tree: Tree) -> None:
    parts = tree.children
    heads = 1
    while heads < len(parts) - 1 and parts[heads - 1].kind in (kinds.VARIABLE, kinds.DECLARATION_STATEMENT):
        heads += 1
    condition = _condition(body, parts[:heads])
    arms = parts[heads:]
    flow = body.flow
    if condition is None or not arms:
        _lower_each(body, Tree(tree.cursor) if not arms else arms[0])
        return
    yes, no = flow.branch(condition)
    after = flow.block()
    flow.start(yes)
    _lower_arm(body, arms[0])
    flow.to(after)
    flow.start(no)
    if len(arms) > 1:
        _lower_arm(body, arms[1])
    flow.to(after)
    flow.start(after)


def _loop(body: Body, kind: str, condition: Callable[[], str | None], again: Callable[[], None] | None, inner: Tree) -> None:
    """A loop that tests `condition` first; `again` reads the increment of a for loop."""
    flow = body.flow
    loop = flow.loop()
    with flow.within(loop.test):
        head = flow.block()
        flow.to(head)
        flow.start(head)
        test = condition()
    loop.head = flow.current
    flow.current.loop = kind
    after = flow.block()
    with flow.within(loop.body):
        start = flow.block()
        flow.current.condition = test
        flow.to(start, "true" if test else "next")
        if test:
            flow.to(after, "false")
        step = flow.block() if again is not None else head
        flow.start(start)
        with flow.breaking(after, step):
            _lower_arm(body, inner)
        flow.to(step)
        if again is not None:
            flow.start(step)
            again()
            flow.to(head)
    flow.start(after)


def _lower_while(body: Body, tree: Tree) -> None:
    *heads, inner = tree.children or [tree]
    _loop(body, "while", lambda: _condition(body, heads), None, inner)


def _lower_do(body: Body, tree: Tree) -> None:
    flow = body.flow
    loop = flow.loop()
    after = flow.block()
    with flow.within(loop.body):
        start = flow.block()
        with flow.within(loop.test):
            test = flow.block()
        flow.to(start)
        flow.start(start)
        with flow.breaking(after, test):
            _lower_arm(body, tree.children[0])
        flow.to(test)
        flow.start(test)
        condition = _condition(body, tree.children[1:])
    loop.head = flow.current
    flow.current.loop = "do"
    flow.current.condition = condition
    flow.to(start, "true")
    flow.to(after, "false")
    flow.start(after)


def _lower_for(body: Body, tree: Tree) -> None:
    init, condition, step = _for_parts(body, tree)
    for part in init:
        lower_statement(body, part)

    def again() -> None:
        for part in step:
            lower_statement(body, part)

    _loop(body, "for", lambda: _condition(body, condition), again, tree.children[-1])


def _for_parts(body: Body, tree: Tree) -> tuple[list[Tree], list[Tree], list[Tree]]:
    """Separate the parts of a for loop by its semicolons: clang leaves absent parts out without trace."""
    span = body.unit.span_of(tree)
    data, depth, semicolons = span.file.data, 0, []
    for offset in range(span.begin, span.end):
        char = data[offset : offset + 1]
        if char in b"([{":
            depth += 1
        elif char in b")]}":
            depth -= 1
            if depth == 0:
                break
        elif char == b";" and depth == 1:
            semicolons.append(offset)
    parts: tuple[list[Tree], list[Tree], list[Tree]] = ([], [], [])
    for child in tree.children[:-1]:
        begin = body.unit.span_of(child).begin
        parts[sum(begin > semicolon for semicolon in semicolons[:2])].append(child)
    return parts


def _lower_range_for(body: Body, tree: Tree) -> None:
    variable = next((child for child in tree.children if _is_variable(child)), None)
    ranges = [child for child in tree.children[:-1] if kinds.is_expression(child.kind)]
    values = [lower_expression(body, child, text=True) for child in ranges]
    if variable is not None:
        name = _declare(body, variable)
        if values:
            body.unit.add("range_variable", name, values[-1])
            body.flow.evaluate(values[-1])
    _loop(body, "range_for", lambda: values[-1] if values else None, None, tree.children[-1])


def _lower_switch(body: Body, tree: Tree) -> None:
    flow = body.flow
    *heads, inner = tree.children or [tree]
    condition = _condition(body, heads)
    flow.current.condition = condition
    after = flow.block()
    with flow.switching(after) as switch:
        flow.start(flow.block())
        lower_statement(body, inner)
    flow.to(after)
    if not switch.default:
        switch.chooser.edges.append((after, "default"))
    flow.start(after)


def _lower_case(body: Body, tree: Tree) -> None:
    """A label: control comes from the switch, or falls through from the statement before."""
    flow, switch = body.flow, body.flow.switch
    block = flow.block()
    flow.to(block)
    rest = tree.children
    if switch is not None and tree.kind == kinds.DEFAULT:
        switch.default = True
        switch.chooser.edges.append((block, "default"))
    elif switch is not None and tree.children:
        flow.start(switch.chooser)
        value = lower_expression(body, tree.children[0], text=True)
        switch.chooser.cases.append((block, value))
    if tree.kind == kinds.CASE:
        rest = tree.children[-1:] if len(tree.children) > 1 else []
    flow.start(block)
    flow.mark(body.unit.span_of(tree).begin)
    for child in rest:
        lower_statement(body, child)


def _lower_try(body: Body, tree: Tree) -> None:
    flow = body.flow
    catches = [child for child in tree.children if child.kind == kinds.CATCH]
    handlers = [flow.block() for _ in catches]
    after = flow.block()
    everything = any(not any(child.kind == kinds.VARIABLE for child in catch.children) for catch in catches)
    with flow.catching(handlers, everything):
        start = flow.block()
        flow.to(start)
        flow.start(start)
        lower_statement(body, tree.children[0])
    flow.to(after)
    for handler, catch in zip(handlers, catches, strict=True):
        flow.start(handler)
        for child in catch.children:
            if child.kind == kinds.VARIABLE:
                declare_variable(body.unit, child.cursor, body.function)
            else:
                lower_statement(body, child)
        flow.to(after)
    flow.start(after)


def _lower_return(body: Body, tree: Tree) -> None:
    for value in expressions(tree)[:1]:
        expr = lower_expression(body, value, text=True)
        body.unit.add("return_value", body.function, expr)
        body.flow.evaluate(expr)
    body.flow.leave()


def _lower_goto(body: Body, tree: Tree) -> None:
    target = next((child for child in tree.children if child.kind == 48), None)  # CXCursor_LabelRef
    if target is not None:
        body.flow.to(body.flow.label(libclang.spelling(target.cursor)))
    body.flow.start(body.flow.block())


def _lower_label(body: Body, tree: Tree) -> None:
    block = body.flow.label(libclang.spelling(tree.cursor))
    body.flow.to(block)
    body.flow.start(block)
    _lower_each(body, tree)


_STATEMENTS: dict[int, Callable[[Body, Tree], None]] = {
    kinds.COMPOUND: _lower_compound,
    kinds.DECLARATION_STATEMENT: _lower_declaration,
    kinds.IF: _lower_if,
    kinds.WHILE: _lower_while,
    kinds.DO: _lower_do,
    kinds.FOR: _lower_for,
    kinds.RANGE_FOR: _lower_range_for,
    kinds.SWITCH: _lower_switch,
    kinds.CASE: _lower_case,
    kinds.DEFAULT: _lower_case,
    kinds.TRY: _lower_try,
    kinds.RETURN: _lower_return,
    kinds.BREAK: lambda body, _tree: body.flow.break_(),
    kinds.CONTINUE: lambda body, _tree: body.flow.continue_(),
    kinds.GOTO: _lower_goto,
    kinds.LABEL: _lower_label,
}
