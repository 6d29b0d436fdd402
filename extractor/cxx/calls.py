"""Calls, constructions and overloaded operators."""

from __future__ import annotations

import re
from collections.abc import Iterator
from operator import itemgetter

from rosarch.extractor.cxx import kinds, libclang
from rosarch.extractor.cxx.body import Body, expressions, operands, strip, template_argument_texts
from rosarch.extractor.cxx.declarations import (
    declare_class,
    declare_function,
    declare_member_type,
    declare_template_member,
    declare_type,
    declare_unknown_type,
    is_template_parameter,
    is_unknown_type,
)
from rosarch.extractor.cxx.libclang import Tree
from rosarch.extractor.cxx.libclang_library import Cursor, Type
from rosarch.extractor.cxx.recover import hide, split
from rosarch.extractor.cxx.unit import Span

_OPERATOR = re.compile(r"operator\s*([^\w\s].*|new|delete)$")
_MAPS = frozenset({"map", "unordered_map"})
_VALUES = frozenset({kinds.STRING, kinds.INTEGER, kinds.FLOATING, kinds.BOOLEAN, kinds.CHARACTER, kinds.NULLPTR, kinds.INIT_LIST})
_MEMBER_NAME = re.compile(r"(?:\.|->|::)\s*(?:template\s+)?(~?\w+)\s*$")
_BUILTIN = re.compile(r"(unsigned |signed |long |short )*(int|bool|float|double|char|long|short|unsigned)")
_MEMBER_TYPE = re.compile(r"(?:typename\s+)?\w+\s*::\s*(\w+)")
_CONSTRUCTED = re.compile(rb"(?:\w+\s*::\s*)*\w+")
_OPENING = re.compile(rb"[({]")
_LAST_NAME = re.compile(r"(~?\w+)\s*(?:<.*>)?\s*$", re.DOTALL)


def lower_call(body: Body, tree: Tree) -> str:
    """Record a call, a construction or an overloaded operator."""
    target = libclang.target(tree)
    kind = libclang.template_kind(target) if target.kind == kinds.FUNCTION_TEMPLATE else target.kind
    if kind == kinds.CONSTRUCTOR:
        return _lower_construction(body, tree, target)
    name = libclang.spelling(tree.cursor)
    operator = _OPERATOR.match(name)
    if operator and _operator_reference(tree, name) is not None:
        return _lower_operator(body, tree, target, name, operator.group(1))
    if kind == kinds.CONVERSION and expressions(tree):
        callee = strip(expressions(tree)[0])
        if expressions(callee):  # an implicit conversion: the object that is converted
            return _lower(body, expressions(callee)[0])
    return _lower_named_call(body, tree, target, name)


def _lower(body: Body, tree: Tree, *, text: bool = False) -> str:
    from rosarch.extractor.cxx.expressions import lower_expression  # calls hold expressions, these calls

    return lower_expression(body, tree, text=text)


def _arguments(body: Body, trees: list[Tree]) -> list[Tree]:
    """Leave out default arguments: they are nowhere in the source."""
    return [tree for tree in trees if not _implicit(body, tree)]


def _implicit(body: Body, tree: Tree) -> bool:
    span = body.unit.span_of(tree)
    return span.begin == span.end and span.begin == 0


def _lower_construction(body: Body, tree: Tree, constructor: Cursor) -> str:
    unit = body.unit
    arguments = _arguments(body, expressions(tree))
    written = tree.children and tree.children[0].kind == kinds.TYPE_REFERENCE
    if len(arguments) == 1 and not written and _same_place(body, tree, arguments[0]):
        return _lower(body, arguments[0])  # an implicit conversion or copy
    lowered = [_lower(body, argument, text=True) for argument in arguments]
    call, span = body.node(tree, "call")
    name = _CONSTRUCTED.match(span.file.data, span.begin)
    if name:
        unit.call_sites[id(span.file)].add(name.end())
    unit.add("call", call, libclang.spelling(constructor))
    unit.add("call_function", call, declare_function(unit, constructor))
    unit.add("call_constructs", call, declare_class(unit, libclang.semantic_parent(constructor)))
    unit.add("expr_type", call, declare_type(unit, libclang.cursor_type(tree.cursor)))
    for index, argument in enumerate(lowered):
        unit.add("call_argument", call, index, argument)
    body.flow.evaluate(call)
    return call


def lower_dependent_construction(body: Body, tree: Tree, type_: Type, values: Tree | None) -> str | None:
    """Record that `tree`, in a template, makes an object of `type_` from the bracketed `values`; None where clang gives the constructor."""
    unit = body.unit
    name = declare_type(unit, type_)
    class_ = libclang.type_declaration(libclang.canonical_type(type_)) if values and _is_list(body, values) else None
    if class_ is not None and class_.kind not in kinds.CLASSES:
        class_ = None
    if class_ is None and not is_template_parameter(name):
        return None
    lowered = [_lower(body, argument, text=True) for argument in (expressions(values) if values else ())]
    call, _ = body.node(tree, "call")
    unit.add("call", call, libclang.type_spelling(type_))
    unit.add("call_unresolved", call, "dependent")
    if class_ is not None:
        unit.add("call_constructs", call, declare_class(unit, class_))
    unit.add("expr_type", call, name)
    for index, argument in enumerate(lowered):
        unit.add("call_argument", call, index, argument)
    body.flow.evaluate(call)
    return call


def lower_base_construction(body: Body, base: Tree, values: list[Tree]) -> str:
    """Record that a constructor of a template makes its `base`, one of its fields, or leaves all to another constructor, with `values`.

    Clang does not say which of the values is within which: the commas between them do.
    """
    unit, type_ = body.unit, libclang.target(base)
    field = libclang.cursor_type(type_) if type_.kind == kinds.FIELD else None
    if field is not None:
        type_ = libclang.type_declaration(libclang.canonical_type(field))
    span = unit.span_of(base)
    found = [(unit.span_of(tree), tree) for value in values for tree in _all(value) if kinds.is_expression(tree.kind)]
    lowered = []
    for begin, end in _pieces(span.file.data, span.end, max(place.end for place, _ in found)):
        within = [(place.end - place.begin, tree) for place, tree in found if begin <= place.begin < place.end <= end]
        if within:
            lowered.append(_lower(body, max(within, key=itemgetter(0))[1], text=True))
    call, _ = body.node(base, "call")
    unit.add("call", call, libclang.spelling(type_))
    unit.add("call_unresolved", call, "dependent")
    if type_.kind in kinds.CLASSES:
        unit.add("call_constructs", call, declare_class(unit, type_))
    if base.kind == kinds.TEMPLATE_REFERENCE and type_.kind in kinds.CLASSES:
        unit.add("expr_type", call, _base_instance(body, base, declare_class(unit, type_)))
    if field is not None:
        unit.add("expr_type", call, declare_type(unit, field))
    for index, argument in enumerate(lowered):
        unit.add("call_argument", call, index, argument)
    body.flow.evaluate(call)
    return call


def _base_instance(body: Body, base: Tree, class_: str) -> str:
    """The instance of the class template `class_` that is the base: its arguments are the children of `base`."""
    span = body.unit.span_of(base)
    opening = _OPENING.search(span.file.data, span.end)
    text = span.file.data[span.begin : opening.start() if opening else span.end].decode("utf-8", "replace")
    return _written_instance(body, base, text.rstrip(), span.begin, class_)


def is_argument_list(body: Body, value: Tree) -> bool:
    """Whether `value` is several values in brackets: in a template, clang gives them without the construction that they are for."""
    span = body.unit.span_of(value)
    return _is_bracketed(value, span) and len(list(_pieces(span.file.data, span.begin, span.end - 1))) > 1


def _is_list(body: Body, value: Tree) -> bool:
    """Whether `value` is values in brackets, not one expression that begins with a bracket."""
    span = body.unit.span_of(value)
    return _is_bracketed(value, span) and all(body.unit.span_of(part).begin > span.begin for part in expressions(value))


def _is_bracketed(value: Tree, span: Span) -> bool:
    return value.kind == kinds.UNEXPOSED_EXPR and span.file.data[span.begin : span.begin + 1] == b"("


def _all(tree: Tree) -> Iterator[Tree]:
    yield tree
    for child in tree.children:
        yield from _all(child)


def _pieces(data: bytes, begin: int, end: int) -> Iterator[tuple[int, int]]:
    """Where the parts between commas lie of the bracket that follows `begin`; the last is read up to `end`."""
    text = hide(data[begin:end])
    if opening := _OPENING.search(text):
        inside = opening.end()
        for start, stop in split(text[inside:], b","):
            yield begin + inside + start, begin + inside + stop


def _same_place(body: Body, outer: Tree, inner: Tree) -> bool:
    """Whether `outer` is written with no character more than `inner`: an implicit step around it."""
    own = body.unit.span_of(outer)
    spans = (body.unit.span_of(inner), body.unit.span_of(strip(inner)))
    return any((own.begin, own.end) == (span.begin, span.end) for span in spans)


def _operator_reference(tree: Tree, name: str) -> Tree | None:
    """The child that names the operator function in `a + b`; a call `a.operator+(b)` has none of its own."""
    for child in expressions(tree):
        inner = strip(child)
        if inner.kind == kinds.DECLARATION_REFERENCE and libclang.spelling(inner.cursor) == name:
            return child
    return None


def _lower_operator(body: Body, tree: Tree, target: Cursor, name: str, operator: str) -> str:
    from rosarch.extractor.cxx.expressions import operator_with_operands

    reference = _operator_reference(tree, name)
    parts = [child for child in operands(tree) if child is not reference]
    if operator in ("++", "--"):
        parts = parts[:1]  # the postfix forms have an int argument that nobody wrote
    if operator in ("->", "*") and len(parts) == 1:
        operator = "*"
    expr, lowered = operator_with_operands(body, tree, "op", operator, _arguments(body, parts))
    if operator == "[]" and len(parts) == 2 and libclang.spelling(libclang.semantic_parent(target)) in _MAPS:
        body.unit.add("expr_text", lowered[1], body.unit.text(body.unit.span_of(parts[1])))  # a key may choose what is called
    if target.kind in kinds.FUNCTIONS:
        function = declare_function(body.unit, target)
        if "@" in function or operator == "()":  # the workspace's own operators, and called function objects
            body.unit.add("call", expr, name)
            body.unit.add("call_function", expr, function)
            if operator == "()":
                called = body.unit.span_of(parts[0])
                body.unit.call_sites[id(called.file)].add(called.end)
            member = libclang.template_kind(target) if target.kind == kinds.FUNCTION_TEMPLATE else target.kind
            _operator_arguments(body, expr, lowered, member=member == kinds.METHOD)
            body.flow.evaluate(expr)
    return expr


def _operator_arguments(body: Body, expr: str, operands: list[str], *, member: bool) -> None:
    """The operands of an overloaded operator are the arguments of its function, a member's first its object."""
    for index, operand in enumerate(operands):
        if member and index == 0:
            body.unit.add("call_receiver", expr, operand)
        else:
            body.unit.add("call_argument", expr, index - member, operand)


def _lower_named_call(body: Body, tree: Tree, target: Cursor, name: str) -> str:
    unit = body.unit
    parts = expressions(tree)
    if not parts:
        return _dropped(body, tree)
    callee = strip(parts[0])
    called = name and libclang.spelling(callee.cursor) == name  # all parts of a macro lie in one place
    if len(parts) == 1 and not called and (callee.kind in _VALUES or _constructs(callee) or _same_place(body, tree, parts[0])):
        return _lower(body, parts[0])  # the move of a temporary into its variable
    if len(parts) == 1 and not name and unit.span_of(parts[0]).begin > unit.span_of(tree).begin and tree.children[0] is not parts[0]:
        return _converted(body, tree, parts)
    receiver = _receiver(body, callee, target)
    arguments = [_lower(body, argument, text=True) for argument in _arguments(body, parts[1:])]
    through = None
    candidates = libclang.overloaded_functions([callee, *callee.children])
    if target.kind not in kinds.FUNCTIONS and not candidates and callee.kind not in (kinds.UNEXPOSED_EXPR, kinds.MEMBER_ACCESS):
        through = _lower(body, callee)
    call, _ = body.node(tree, "call")
    callee_span = unit.span_of(parts[0])
    callee_text = callee_span.file.data[callee_span.begin : callee_span.end].decode("utf-8", "replace")
    if not name:
        match = _MEMBER_NAME.search(callee_text) or _LAST_NAME.search(callee_text)
        name = match.group(1) if match else "?"
    unit.call_sites[id(callee_span.file)].add(callee_span.begin + _name_end(callee_text, name))
    unit.add("call", call, name)
    if target.kind in kinds.FUNCTIONS:
        unit.add("call_function", call, declare_function(unit, target))
        unit.add("expr_type", call, declare_type(unit, libclang.cursor_type(tree.cursor)))
    elif through is not None:
        unit.add("call_through", call, through)
    else:
        for candidate in candidates:
            unit.add("call_function", call, declare_function(unit, candidate))
        unit.add("call_unresolved", call, "overloaded" if candidates else "dependent")
        if receiver is None and "::" in callee_text and not candidates:
            declare_template_member(unit, call, callee, name)
    if receiver is not None:
        unit.add("call_receiver", call, receiver)
    for index, argument in enumerate(arguments):
        unit.add("call_argument", call, index, argument)
    for index, type_ in enumerate(_template_arguments(body, callee, callee_text, callee_span.begin)):
        unit.add("call_template_argument", call, index, type_)
    body.flow.evaluate(call)
    return call


def _converted(body: Body, tree: Tree, value: list[Tree]) -> str:
    """`Type(value)` in a template that `Type` depends on."""
    from rosarch.extractor.cxx.expressions import operator_expression

    return operator_expression(body, tree, "cast", "cast", value)


def _name_end(callee: str, name: str) -> int:
    """Where the name ends in a callee's text, explicit template arguments left out; in bytes."""
    before, found, _ = callee.rpartition(name)
    while found and "<" in before and before.count("<") > before.count(">") - before.count("->"):
        before, found, _ = before.rpartition(name)  # that was within the template arguments
    return len((before + name if found else callee).encode())


def _constructs(tree: Tree) -> bool:
    return tree.kind == kinds.CALL and libclang.target(tree).kind == kinds.CONSTRUCTOR


def _dropped(body: Body, tree: Tree) -> str:
    expr, span = body.node(tree, "unknown")
    body.unit.add("expr_unknown", expr, "dropped")
    body.unit.add("expr_text", expr, body.unit.text(span))
    return expr


def _receiver(body: Body, callee: Tree, target: Cursor) -> str | None:
    """The object of a member call."""
    if callee.kind == kinds.MEMBER_ACCESS or callee.kind == kinds.UNEXPOSED_EXPR:
        bases = expressions(callee)
        if bases:
            return _lower(body, bases[0])
    member = libclang.template_kind(target) if target.kind == kinds.FUNCTION_TEMPLATE else target.kind
    if member == kinds.METHOD and body.owner and not libclang.is_static_method(target):
        return body.this()
    return None


def _template_arguments(body: Body, callee: Tree, text: str, begin: int) -> list[str]:
    """The explicit template arguments of a call, each as a type."""
    result = []
    for argument in template_argument_texts(text.rstrip()):
        start = begin + len(text[: text.rindex(argument)].encode())
        result.append(_written_type(body, callee, argument, start, start + len(argument.encode())))
    return result


def _written_instance(body: Body, callee: Tree, text: str, begin: int, class_: str) -> str:
    """The instance of a class template that is written from `begin` on, with its arguments where these are types."""
    types = _template_arguments(body, callee, text, begin)
    known = {index: type_ for index, type_ in enumerate(types) if not is_unknown_type(type_)}
    name = f"{class_}<{', '.join(types)}>" if types and len(known) == len(types) else "".join(text.split())
    body.unit.add("type_class", name, class_)
    for index, type_ in known.items():
        body.unit.add("type_argument", name, index, type_)
    return name


def _written_type(body: Body, callee: Tree, text: str, begin: int, end: int) -> str:
    """The type written at [`begin`, `end`): by the references that clang saw in it, else as spelled."""
    found: Cursor | None = None
    for child in callee.children:
        if child.kind in (kinds.TYPE_REFERENCE, kinds.TEMPLATE_REFERENCE):
            span = body.unit.span_of(child)
            if begin <= span.begin and span.end <= end:
                target = libclang.target(child)
                if child.kind == kinds.TYPE_REFERENCE and span.end == end:
                    return declare_type(body.unit, libclang.cursor_type(target))
                if child.kind == kinds.TYPE_REFERENCE and (member := _MEMBER_TYPE.fullmatch(text)):
                    type_ = declare_member_type(body.unit, libclang.cursor_type(target), member.group(1))
                    if type_ is not None:
                        return type_
                if child.kind == kinds.TEMPLATE_REFERENCE and found is None:
                    found = target
    if found is not None:
        return _written_instance(body, callee, text, begin, declare_class(body.unit, found))
    return text if _BUILTIN.fullmatch(text) else declare_unknown_type(body.unit, text)
