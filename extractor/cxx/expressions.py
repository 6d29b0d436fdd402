"""Expressions: from cursors to rows of `rules/schema/expressions.dl`."""

from __future__ import annotations

import re
from collections.abc import Callable

from rosarch.extractor.cxx import kinds, libclang, literals
from rosarch.extractor.cxx.body import Body, expressions, strip
from rosarch.extractor.cxx.calls import lower_call, lower_dependent_construction
from rosarch.extractor.cxx.declarations import declare_function, declare_template_member, declare_type, declare_variable, qualified_name
from rosarch.extractor.cxx.libclang import Tree
from rosarch.extractor.cxx.unit import DEEPEST, StructuredBinding

_ASSIGNMENTS = frozenset({"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="})
_TESTS = frozenset({"!", "==", "!=", "<", "<=", ">", ">="})
_ARITHMETIC = frozenset({"+", "-", "*", "/", "%", "<<", ">>"})
_NUMBERS = re.compile(
    r"(?:[\s()+*/%<>-]|(?:0[xX][0-9a-fA-F]+|(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?[uUlLfF]*|M_[A-Z0-9_]+)(?![\w.]))+"
)
_VARIABLES = frozenset({kinds.VARIABLE, kinds.PARAMETER, kinds.FIELD})


def lower_expression(body: Body, tree: Tree, *, text: bool = False) -> str:
    """Record the expression at `tree` and return its identifier; with `text`, its source text too."""
    tree, unit = strip(tree), body.unit
    if unit.depth == DEEPEST:
        return _left_out(body, tree)
    unit.depth += 1
    lower = _FORMS.get(tree.kind, _lower_unknown)
    expr = lower(body, tree)
    unit.depth -= 1
    if text:
        unit.add("expr_text", expr, unit.text(unit.span_of(tree)))
    return expr


def _left_out(body: Body, tree: Tree) -> str:
    """An expression that is nested too deeply to be read."""
    expr, span = body.node(tree, "unknown")
    body.unit.deep.append(span)
    body.unit.add("expr_unknown", expr, "form")
    return expr


def operator_expression(body: Body, tree: Tree, form: str, name: str, operands: list[Tree]) -> str:
    """Record an operator with its operands, evaluated from left to right."""
    return operator_with_operands(body, tree, form, name, operands)[0]


def operator_with_operands(body: Body, tree: Tree, form: str, name: str, operands: list[Tree]) -> tuple[str, list[str]]:
    """The same, with the identifiers of the operands."""
    expr, _ = body.node(tree, form)
    body.unit.add("operator", expr, name)
    assigns = name in _ASSIGNMENTS
    lowered = []
    for index, operand in enumerate(operands):
        lowered.append(lower_expression(body, operand, text=assigns or (name in _TESTS and _is_call(operand))))
        body.unit.add("operand", expr, index, lowered[index])
    if name in ("++", "--"):
        body.unit.add("expr_text", expr, body.unit.text(body.unit.span_of(tree)))
    if name in _ARITHMETIC:
        _record_constant(body, tree, expr)
    if assigns or name in ("++", "--", "<<", ">>", "delete"):  # of streams, the last ones write
        body.flow.evaluate(expr)
    return expr, lowered


def _is_call(tree: Tree) -> bool:
    return strip(tree).kind == kinds.CALL


def _record_constant(body: Body, tree: Tree, expr: str) -> None:
    """What arithmetic on literals comes to; names are left out, as healing may have made up their values."""
    if _NUMBERS.fullmatch(body.unit.text(body.unit.span_of(tree))):
        value = libclang.evaluate(tree.cursor)
        if value is not None:
            body.unit.add("expr_constant", expr, repr(value) if isinstance(value, float) else str(int(value)))


def _lower_reference(body: Body, tree: Tree) -> str:
    target = libclang.target(tree)
    if target.kind in _VARIABLES:
        return _use(body, tree, declare_variable(body.unit, target))
    binding = body.unit.bindings.get(target.d0 or 0) if target.kind == kinds.UNEXPOSED_DECLARATION else None
    if binding is not None:
        return _lower_binding(body, tree, binding)
    if target.kind == kinds.ENUM_CONSTANT:
        expr, _ = body.node(tree, "enum")
        body.unit.add("literal", expr, "enum", qualified_name(body.unit, target))
        body.unit.add("expr_constant", expr, str(libclang.enum_value(target)))
        return expr
    if target.kind in kinds.FUNCTIONS:
        expr, _ = body.node(tree, "fn")
        body.unit.add("function_use", expr, declare_function(body.unit, target))
        return expr
    return _lower_overloaded(body, tree, [tree, *tree.children])


def _use(body: Body, tree: Tree, variable: str) -> str:
    expr, _ = body.node(tree, "use")
    body.unit.add("variable_use", expr, variable)
    body.flow.read(expr)
    return expr


def _lower_binding(body: Body, tree: Tree, binding: StructuredBinding) -> str:
    """A name in `auto [a, b] = value` stands for a part of the value: `value.first`, or `value[1]` where the parts have no names."""
    unit = body.unit
    whole = _use(body, tree, binding.variable)
    if binding.field is None:
        index, _ = body.node(tree, "num")
        unit.add("literal", index, "integer", str(binding.index))
        expr, _ = body.node(tree, "op")
        unit.add("operator", expr, "[]")
        unit.add("operand", expr, 0, whole)
        unit.add("operand", expr, 1, index)
        return expr
    expr = _use(body, tree, declare_variable(unit, binding.field))
    unit.add("field_object", expr, whole)
    return expr


def _lower_overloaded(body: Body, tree: Tree, references: list[Tree]) -> str:
    """The name of an overload set: one row per candidate."""
    candidates = libclang.overloaded_functions(references)
    if not candidates:
        return _lower_unknown(body, tree)
    expr, _ = body.node(tree, "fn")
    for candidate in candidates:
        body.unit.add("function_use", expr, declare_function(body.unit, candidate))
    return expr


def _lower_member(body: Body, tree: Tree) -> str:
    target = libclang.target(tree)
    bases = expressions(tree)
    if target.kind in kinds.FUNCTIONS:
        span = body.unit.span_of(tree)
        expr = _lower_reference(body, tree)
        body.unit.remnants.append((expr, span.file, span.end))
        return expr
    if target.kind not in _VARIABLES:
        return _lower_reference(body, tree) if target.kind == kinds.ENUM_CONSTANT else _lower_unknown(body, tree)
    base = lower_expression(body, bases[0]) if bases else body.this()
    expr = _use(body, tree, declare_variable(body.unit, target))
    body.unit.add("field_object", expr, base)
    return expr


def _lower_this(body: Body, tree: Tree) -> str:
    expr, _ = body.node(tree, "this")
    body.unit.add("this_use", expr, body.owner)
    return expr


def _lower_unary(body: Body, tree: Tree) -> str:
    name = libclang.operator_spelling(tree.cursor, unary=True)
    inner = strip(expressions(tree)[0]) if expressions(tree) else tree
    if name == "&" and inner is not tree:
        references = [inner, *inner.children]
        if inner.kind == kinds.DECLARATION_REFERENCE and libclang.target(inner).kind in kinds.FUNCTIONS:
            return _lower_reference(body, inner)
        if any(libclang.overload_count(reference.cursor) for reference in references):
            return _lower_overloaded(body, tree, references)
    return operator_expression(body, tree, "op", name or "?", expressions(tree))


def _lower_binary(body: Body, tree: Tree) -> str:
    name = libclang.operator_spelling(tree.cursor, unary=False)
    operands = expressions(tree)
    if name in ("&&", "||") and len(operands) == 2:
        return _lower_logical(body, tree, name, operands)
    return operator_expression(body, tree, "op", name or "?", operands)


def _lower_logical(body: Body, tree: Tree, name: str, operands: list[Tree]) -> str:
    """The right operand of `&&` and `||` is a branch of its own when it evaluates anything."""
    left = lower_expression(body, operands[0], text=True)
    right = body.flow.maybe(left, lambda: lower_expression(body, operands[1], text=_is_call(operands[1])), taken=name == "&&")
    expr, _ = body.node(tree, "op")
    body.unit.add("operator", expr, name)
    body.unit.add("operand", expr, 0, left)
    body.unit.add("operand", expr, 1, right)
    return expr


def _lower_conditional(body: Body, tree: Tree) -> str:
    operands = expressions(tree)
    if len(operands) != 3:
        return _lower_unknown(body, tree)
    condition = lower_expression(body, operands[0], text=True)
    either = body.flow.either(condition, lambda: lower_expression(body, operands[1]), lambda: lower_expression(body, operands[2]))
    values = [condition, *either]
    expr, _ = body.node(tree, "op")
    body.unit.add("operator", expr, "?:")
    for index, value in enumerate(values):
        body.unit.add("operand", expr, index, value)
    return expr


def _lower_cast(body: Body, tree: Tree) -> str:
    inner = expressions(tree)
    stripped = strip(inner[-1]) if inner else tree
    if tree.kind == kinds.FUNCTIONAL_CAST and stripped.kind == kinds.CALL:
        return lower_expression(body, stripped)
    expr = operator_expression(body, tree, "cast", "cast", inner[-1:])
    body.unit.add("expr_type", expr, declare_type(body.unit, libclang.cursor_type(tree.cursor)))
    body.unit.add("expr_text", expr, body.unit.text(body.unit.span_of(tree)))
    return expr


def _lower_new(body: Body, tree: Tree) -> str:
    values = expressions(tree)[-1:]
    made = lower_dependent_construction(body, tree, libclang.pointee(libclang.cursor_type(tree.cursor)), values[0] if values else None)
    expr = operator_expression(body, tree, "new", "new", [] if made else values)
    if made:
        body.unit.add("operand", expr, 0, made)
    body.unit.add("expr_type", expr, declare_type(body.unit, libclang.cursor_type(tree.cursor)))
    return expr


def _lower_throw(body: Body, tree: Tree) -> str:
    expr = operator_expression(body, tree, "throw", "throw", expressions(tree))
    body.flow.evaluate(expr)
    body.flow.throw()
    return expr


def _lower_lambda(body: Body, tree: Tree) -> str:
    from rosarch.extractor.cxx.statements import lower_lambda  # a lambda's body holds statements, these expressions

    return lower_lambda(body, tree)


def _lower_statements(body: Body, tree: Tree) -> str:
    from rosarch.extractor.cxx.statements import lower_statement

    for child in tree.children:
        lower_statement(body, child)
    return _lower_unknown(body, Tree(tree.cursor))


def _lower_list(body: Body, tree: Tree) -> str:
    expr = operator_expression(body, tree, "list", "{}", expressions(tree))
    type_ = libclang.canonical_type(libclang.cursor_type(tree.cursor))
    if type_.kind == kinds.TYPE_RECORD:
        body.unit.add("expr_type", expr, declare_type(body.unit, type_))
    return expr


def _lower_unknown(body: Body, tree: Tree) -> str:
    """A form without facts of its own: its parts are read, so that no call is lost."""
    expr, span = body.node(tree, "unknown")
    for index, child in enumerate(expressions(tree)):
        body.unit.add("operand", expr, index, lower_expression(body, child))
    body.unit.add("expr_unknown", expr, "form")
    text = body.unit.text(span)
    body.unit.add("expr_text", expr, text)
    if "::" in text:
        declare_template_member(body.unit, expr, tree, text.rpartition("::")[2].strip())
    return expr


def _operator(form: str, name: str) -> Callable[[Body, Tree], str]:
    return lambda body, tree: operator_expression(body, tree, form, name, expressions(tree))


_FORMS: dict[int, Callable[[Body, Tree], str]] = {
    kinds.DECLARATION_REFERENCE: _lower_reference,
    kinds.MEMBER_ACCESS: _lower_member,
    kinds.CALL: lower_call,
    kinds.INTEGER: literals.integer,
    kinds.FLOATING: literals.floating,
    kinds.STRING: literals.string,
    kinds.CHARACTER: literals.character,
    kinds.BOOLEAN: literals.boolean,
    kinds.NULLPTR: literals.null,
    kinds.GNU_NULL: literals.null,
    kinds.THIS: _lower_this,
    kinds.UNARY: _lower_unary,
    kinds.BINARY: _lower_binary,
    kinds.COMPOUND_ASSIGNMENT: _lower_binary,
    kinds.CONDITIONAL: _lower_conditional,
    kinds.SUBSCRIPT: _operator("op", "[]"),
    kinds.INIT_LIST: _lower_list,
    kinds.SIZEOF: _operator("op", "sizeof"),
    kinds.DELETE: _operator("op", "delete"),
    kinds.THROW: _lower_throw,
    kinds.NEW: _lower_new,
    kinds.LAMBDA: _lower_lambda,
    kinds.STATEMENT_EXPR: _lower_statements,
    **dict.fromkeys(kinds.CASTS, _lower_cast),
}
