"""Top-level declarations: which functions, classes and globals of the workspace a unit defines."""

from __future__ import annotations

import re

from rosarch.extractor.cxx import kinds, libclang
from rosarch.extractor.cxx.body import Body
from rosarch.extractor.cxx.calls import is_argument_list, lower_base_construction
from rosarch.extractor.cxx.declarations import (
    declare_base_instance,
    declare_class,
    declare_function,
    declare_parameter,
    declare_type,
    declare_variable,
    qualified_name,
)
from rosarch.extractor.cxx.expressions import lower_expression
from rosarch.extractor.cxx.libclang import Tree
from rosarch.extractor.cxx.libclang_library import Cursor
from rosarch.extractor.cxx.statements import lower_body, lower_variable
from rosarch.extractor.cxx.unit import FunctionSpan, UnitFacts
from rosarch.extractor.flow import Flow

_INSTANCE = re.compile(rb"\s*<(?:[^<>(){};]|<(?:[^<>(){};]|<[^<>(){};]*>)*>)*>\s*[({]")  # up to the values of an instance of a template
_TRANSPARENT = frozenset({kinds.NAMESPACE, kinds.LINKAGE_SPEC, kinds.UNEXPOSED_DECLARATION})


def walk_declaration(unit: UnitFacts, cursor: Cursor) -> None:
    """Record a declaration, with all in it, when it is in a file of the workspace."""
    file, offset = unit.locate(libclang.location(cursor))
    if file.key is None:
        return
    kind = cursor.kind
    if kind in kinds.PREPROCESSING:
        return
    seen = (file.key, offset, kind, libclang.spelling(cursor))
    if kind not in _TRANSPARENT and seen in unit.walked:
        return  # a file that is read several times says the same each time
    unit.walked.add(seen)
    if kind in _TRANSPARENT:
        for child in libclang.children(cursor):
            walk_declaration(unit, child)
    elif kind in kinds.FUNCTIONS:
        if not libclang.is_definition(cursor):
            declare_function(unit, cursor)  # so that a call that clang drops finds it
        elif not _is_instance(cursor):
            walk_function(unit, cursor)
    elif kind in kinds.CLASSES:
        if libclang.is_definition(cursor):
            walk_class(unit, cursor)
    elif kind == kinds.VARIABLE:
        lower_variable(Body(unit, Flow()), libclang.tree(cursor))
    elif kind in (kinds.TYPEDEF, kinds.TYPE_ALIAS):
        unit.add("type_alias", qualified_name(unit, cursor), declare_type(unit, libclang.underlying_typedef(cursor)))


def _is_instance(cursor: Cursor) -> bool:
    """Whether clang made this function from a template: it stands where the template, or its definition outside of the class, stands."""
    template = libclang.template_of(cursor)
    if not template.d0:
        return False
    defined = libclang.definition(template)
    place = libclang.location(cursor).raw
    return any(libclang.location(source).raw == place for source in (template, defined) if source.d0)


def walk_class(unit: UnitFacts, cursor: Cursor) -> None:
    """Record a class definition: its fields, nested classes and inline functions."""
    owner = declare_class(unit, cursor)
    file, line, column = unit.place(cursor)
    if file.key:
        unit.add("location", owner, file.key, line, column)
    if libclang.template_of(cursor).d0:
        for specifier in libclang.bases(cursor):
            declare_base_instance(unit, owner, specifier)
    for child in libclang.children(cursor):
        if child.kind == kinds.FIELD or child.kind == kinds.VARIABLE:
            declare_variable(unit, child)
            lower_variable(Body(unit, Flow(), "", owner), libclang.tree(child))
        elif child.kind in kinds.CLASSES or child.kind in kinds.FUNCTIONS or child.kind in (kinds.TYPEDEF, kinds.TYPE_ALIAS):
            walk_declaration(unit, child)


def walk_function(unit: UnitFacts, cursor: Cursor) -> None:
    """Record a function definition: parameters, initialisers, body."""
    function = declare_function(unit, cursor)
    parent = libclang.semantic_parent(cursor)
    owner = declare_class(unit, parent) if parent.kind in kinds.CLASSES else ""
    body = Body(unit, Flow(), function, owner)
    tree = libclang.tree(cursor)
    index = 0
    for child in tree.children:
        if child.kind == kinds.PARAMETER:
            parameter = declare_parameter(unit, function, index, child.cursor)
            index += 1
            defaults = [part for part in child.children if kinds.is_expression(part.kind)]
            if defaults:
                value = lower_expression(Body(unit, Flow(), "", owner), defaults[-1], text=True)
                unit.add("parameter_default", parameter, value)
    _walk_initialisers(body, tree)
    for child in tree.children:
        if child.kind in (kinds.COMPOUND, kinds.TRY):
            span = unit.span_of(child)
            unit.functions.append(FunctionSpan(function, owner, span.file, span.begin, span.end))
            lower_body(body, child)


def _walk_initialisers(body: Body, tree: Tree) -> None:
    """A constructor's initialiser list: a reference to field, base or the class itself, then its value."""
    initialisers: list[tuple[list[Tree], list[Tree]]] = [([], [])]
    for child in tree.children:
        if kinds.is_expression(child.kind):
            initialisers[-1][1].append(child)
        elif initialisers[-1][1]:
            initialisers.append(([child], []))
        else:
            initialisers[-1][0].append(child)
    for references, values in initialisers:
        target = _initialised(body, references) if values else None
        if target is not None and _is_unnamed_construction(body, target, values[0]):
            body.unit.add("call_receiver", lower_base_construction(body, target, values), body.this())
        elif target is not None and _is_object(target) and is_argument_list(body, values[0]):
            field = declare_variable(body.unit, libclang.target(target))
            body.unit.add("field_initializer", body.function, field, lower_base_construction(body, target, values))
        else:
            _walk_values(body, target, values)


def _initialised(body: Body, references: list[Tree]) -> Tree | None:
    """Which of the `references` before the values gets them: a template, with those within its brackets as children, or else the last."""
    for index, reference in enumerate(references):
        if reference.kind == kinds.TEMPLATE_REFERENCE:
            span = body.unit.span_of(reference)
            instance = _INSTANCE.match(span.file.data, span.end)
            if instance and all(body.unit.span_of(inner).end < instance.end() for inner in references[index + 1 :]):
                reference.children = references[index + 1 :]
                return reference
    return references[-1] if references else None


def _is_unnamed_construction(body: Body, target: Tree, value: Tree) -> bool:
    """In a template, clang gives the arguments of a base's constructor without a call of this."""
    return (
        bool(body.owner)
        and target.kind in (kinds.TYPE_REFERENCE, kinds.TEMPLATE_REFERENCE)
        and body.unit.span_of(target).begin < body.unit.span_of(value).begin
    )


def _is_object(target: Tree) -> bool:
    """A field of a class."""
    if target.kind != kinds.MEMBER_REFERENCE:
        return False
    return libclang.type_declaration(libclang.canonical_type(libclang.cursor_type(libclang.target(target)))).kind in kinds.CLASSES


def _walk_values(body: Body, target: Tree | None, values: list[Tree]) -> None:
    for index, child in enumerate(values):
        value = lower_expression(body, child, text=True)
        if index == 0 and target is not None and target.kind == kinds.MEMBER_REFERENCE:
            field = declare_variable(body.unit, libclang.target(target))
            body.unit.add("field_initializer", body.function, field, value)
            body.flow.evaluate(value)
        elif body.owner:
            body.unit.add("call_receiver", value, body.this())
