"""Identifiers and facts of declared functions, variables, classes and types, made when first met."""

from __future__ import annotations

import os
import re

from rosarch.extractor.cxx import kinds, libclang
from rosarch.extractor.cxx.includes import SHIPPED
from rosarch.extractor.cxx.libclang import Tree
from rosarch.extractor.cxx.libclang_library import Cursor, Type
from rosarch.extractor.cxx.literals import decode_string
from rosarch.extractor.cxx.unit import UnitFacts

_FUNCTION_KINDS = {
    kinds.FUNCTION: "function",
    kinds.METHOD: "method",
    kinds.CONSTRUCTOR: "constructor",
    kinds.DESTRUCTOR: "destructor",
    kinds.CONVERSION: "conversion",
}
_CLASS_KINDS = {kinds.STRUCT: "struct", kinds.UNION: "union", kinds.CLASS: "class", kinds.ENUM: "enum"}
_INT_WORD = re.compile(r"\bint\b")
_INT_WORDS = re.compile(r"\b(int|auto|signed|unsigned|short|long|decltype)\b")
_INT = re.compile(r"(signed|int|auto|decltype\s*\(.*\)|\s)*")
_QUALIFIERS = re.compile(r"\bconst\b|\bvolatile\b|\[\d*\]|[&*\s]")
_SPECIFIERS = re.compile(r"\b(const|constexpr|static|mutable|extern|inline|volatile|register|typename|struct|class)\b")
_TEMPLATE_PARAMETER = re.compile(r"type-parameter-\d+-(\d+)")
_TEMPLATE_MEMBER = re.compile(r"typename (type-parameter-\d+-(\d+))::(\w+)")
_PLACE = re.compile(r" at (.*?):(\d+:\d+)\)")
_ANONYMOUS = re.compile(r"\(.*? at .*\)")


def qualified_name(unit: UnitFacts, cursor: Cursor) -> str:
    """Return the qualified name of a declaration, without template arguments; what has no name gets its place."""
    name = _ANONYMOUS.sub("", libclang.spelling(cursor)).strip()
    if not name or (cursor.kind in kinds.CLASSES and libclang.is_anonymous(cursor)):
        file, line, column = unit.place(cursor)
        name = f"(anonymous {file.label}:{line}:{column})"
        if cursor.kind == kinds.NAMESPACE:
            name = "(anonymous)"
    if cursor.kind in kinds.FUNCTIONS and not name.startswith("operator"):
        name = name.partition("<")[0]  # constructors of class templates carry the parameters
    parent = _scope(cursor)
    while parent.kind in (kinds.LINKAGE_SPEC, kinds.UNEXPOSED_DECLARATION):
        parent = libclang.semantic_parent(parent)
    if parent.kind == kinds.NAMESPACE or parent.kind in kinds.CLASSES or parent.kind in kinds.FUNCTIONS:
        return f"{_scope_name(unit, parent)}::{name}"
    if parent.kind == kinds.ENUM:
        return f"{declare_class(unit, parent)}::{name}"
    return name


def _scope(cursor: Cursor) -> Cursor:
    """What a declaration is in; members of an anonymous union are in the scope around it."""
    parent: Cursor = libclang.semantic_parent(cursor)
    while parent.kind in kinds.CLASSES and libclang.is_anonymous_record(parent):
        parent = libclang.semantic_parent(parent)
    return parent


def _scope_name(unit: UnitFacts, cursor: Cursor) -> str:
    pointer = libclang.canonical(cursor).d0 or 0
    if pointer not in unit.scopes:
        unit.scopes[pointer] = qualified_name(unit, cursor)
    return unit.scopes[pointer]


def _pattern(cursor: Cursor) -> Cursor:
    """The template member that `cursor` was instantiated from, else its canonical declaration."""
    template = libclang.template_of(cursor)
    return libclang.canonical(template if template.d0 else cursor)  # type: ignore[no-any-return]


def declare_function(unit: UnitFacts, cursor: Cursor) -> str:
    """Return the identifier of the function at `cursor`, recording its facts on first sight."""
    known = unit.declared.get(cursor.d0 or 0)
    if known is not None:
        return known
    pattern = _pattern(cursor)
    name = qualified_name(unit, pattern)
    file, line, column = unit.place(pattern)
    identifier = f"{name}@{file.key}:{line}:{column}" if file.key else name
    unit.declared[cursor.d0 or 0] = unit.declared[pattern.d0 or 0] = identifier
    kind = libclang.template_kind(pattern) if pattern.kind == kinds.FUNCTION_TEMPLATE else pattern.kind
    unit.add("function", identifier, _kind_of_function(pattern, kind))
    unit.add("function_name", identifier, name)
    if file.key:
        unit.add("location", identifier, file.key, line, column)
    elif file.stands_in:
        unit.add("function_undeclared", identifier)
    parent = libclang.semantic_parent(pattern)
    if parent.kind in kinds.CLASSES:
        unit.add("function_class", identifier, declare_class(unit, parent))
    if kind == kinds.METHOD:
        for base in libclang.overridden(pattern):
            unit.add("function_overrides", identifier, declare_function(unit, base))
    if file.key and libclang.has_attributes(pattern):
        for child in libclang.children(pattern):
            if child.kind == kinds.ANNOTATION:
                unit.add("function_annotation", identifier, libclang.spelling(child))
    if kind in (kinds.FUNCTION, kinds.METHOD, kinds.CONVERSION):
        unit.add("function_return_type", identifier, declare_type(unit, libclang.result_type(pattern)))
    if file.key and pattern.kind != kinds.FUNCTION_TEMPLATE:
        for index in range(libclang.argument_count(pattern)):
            declare_parameter(unit, identifier, index, libclang.argument(pattern, index))
    return identifier


def _kind_of_function(pattern: Cursor, kind: int) -> str:
    if kind in (kinds.CONSTRUCTOR, kinds.METHOD) and libclang.is_deleted_method(pattern):
        return "deleted"  # nobody can call it
    if kind == kinds.METHOD and libclang.is_static_method(pattern):
        return "static_method"
    return _FUNCTION_KINDS.get(kind, "function")


def declare_parameter(unit: UnitFacts, function: str, index: int, cursor: Cursor) -> str:
    """Record the parameter of `function` at `index`; declaration and definition share one identifier."""
    identifier = f"{function}#{index}"
    unit.declared[cursor.d0 or 0] = identifier
    unit.add("function_parameter", function, index, identifier)
    unit.add("variable", identifier, "parameter")
    unit.add("variable_function", identifier, function)
    name = libclang.spelling(cursor)
    if name:
        unit.add("variable_name", identifier, name)
    unit.add("variable_type", identifier, declared_type(unit, cursor))
    return identifier


def declare_variable(unit: UnitFacts, cursor: Cursor, function: str = "") -> str:
    """Return the identifier of the variable or field at `cursor`; `function` is the one whose body declares it."""
    known = unit.declared.get(cursor.d0 or 0)
    if known is not None:
        return known
    pattern = libclang.canonical(cursor)
    if pattern.d0 in unit.declared:
        identifier = unit.declared[cursor.d0 or 0] = unit.declared[pattern.d0]
        return identifier
    parent = _scope(pattern)
    file, line, column = unit.place(pattern)
    name = libclang.spelling(pattern)
    if name.endswith(")"):  # an anonymous union is a variable too: its name is where it is
        name = ""
    where = f"@{file.label}:{line}:{column}"
    if parent.kind in kinds.CLASSES:
        owner = declare_class(unit, parent)
        identifier = f"{owner}::{name or where}"
        unit.add("variable", identifier, "field" if pattern.kind == kinds.FIELD else "static_field")
        unit.add("field_class", identifier, owner)
    elif (parent.kind in kinds.FUNCTIONS or function) and libclang.storage_class(pattern) != kinds.STORAGE_EXTERN:
        identifier = name + where
        static = libclang.storage_class(pattern) == kinds.STORAGE_STATIC
        kind = "parameter" if pattern.kind == kinds.PARAMETER else "static_local" if static else "local"
        unit.add("variable", identifier, kind)
        if function:
            unit.add("variable_function", identifier, function)
    else:
        identifier = name if parent.kind in kinds.FUNCTIONS else qualified_name(unit, pattern)
        if libclang.linkage(pattern) != kinds.LINKAGE_EXTERNAL:
            identifier += f"@{file.label}"
        unit.add("variable", identifier, "global")
    unit.declared[cursor.d0 or 0] = unit.declared[pattern.d0 or 0] = identifier
    unit.add("variable_name", identifier, name)
    type_ = declared_type(unit, pattern)
    unit.add("variable_type", identifier, type_)
    if file.key:
        unit.add("location", identifier, file.key, line, column)
    elif pattern.kind == kinds.VARIABLE and type_ == _CONSTANT_TEXT and (literal := _literal(pattern)):
        expr = f"{identifier}:value"
        unit.add("literal", expr, "string", decode_string(libclang.spelling(literal)))
        unit.add("variable_initializer", identifier, expr)
    return identifier


_CONSTANT_TEXT = "const std::basic_string<char>"


def _literal(cursor: Cursor) -> Cursor | None:
    """The text that a constant of a message is made of, which is declared outside the workspace."""
    for child in libclang.children(cursor):
        found = child if child.kind == kinds.STRING else _literal(child)
        if found is not None:
            return found
    return None


def declared_type(unit: UnitFacts, cursor: Cursor) -> str:
    """Return the type of a declaration.

    Clang silently gives `int` to a variable whose type it does not know, so an `int` that the source does not
    spell is unknown: the result is `?` and the type as written.
    """
    type_ = libclang.cursor_type(cursor)
    if _INT_WORD.search(unit.type_name(type_)):
        span = unit.span(cursor)
        if span.file.key:
            file, offset = unit.locate(libclang.location(cursor))
            written = _specifiers(file.text(span.begin, offset if offset > span.begin else span.end))
            if _is_guessed(unit.type_name(type_), written):
                return declare_unknown_type(unit, written)
    return declare_type(unit, type_)


def _specifiers(written: str) -> str:
    """What stands before the first declarator of a declaration such as `int a = f(1, 2), *b`, given up to a later one."""
    depth = 0
    cut = len(written)
    for position, character in enumerate(written):
        if depth == 0 and character in "=({[":
            cut = min(cut, position)
        depth += (character in "<({[") - (character in ">)}]")
        if depth == 0 and character == ",":
            return re.sub(r"[&*\s]*\w+\s*$", "", written[: min(cut, position)])
    return written


def _is_guessed(spelling: str, written: str) -> bool:
    """Whether clang's `int` in a type stands for one that it does not know."""
    if _QUALIFIERS.sub("", spelling) == "int":
        return not _INT.fullmatch(_SPECIFIERS.sub("", written).replace("&", " ").replace("*", " ").strip())
    return not _INT_WORDS.search(written)


def unknown_type(written: str) -> str:
    """The type that stands for an absent declaration."""
    return "?" + _SPECIFIERS.sub("", written).replace(" ", "").rstrip("&*")


def is_unknown_type(type_: str) -> bool:
    """Whether it stands for an absent declaration."""
    return type_.startswith("?")


def declare_unknown_type(unit: UnitFacts, written: str) -> str:
    """Record the type that stands for an absent declaration: of the class with the written name."""
    name = unknown_type(written)
    unit.add("type_class", name, name[1:].partition("<")[0])
    return name


def declare_template_member(unit: UnitFacts, expr: str, tree: Tree, name: str) -> None:
    """Record that `expr`, written as `tree`, names or calls the member `name` of a template parameter, `T::name`.

    Or of an instance of a class template, `X<T>::name`.
    """
    references = [(child, libclang.referenced(child.cursor)) for child in tree.children if child.kind == kinds.TEMPLATE_REFERENCE]
    templates = [(child, target) for child, target in references if target.kind in kinds.CLASSES]  # others are parameters of the template
    if templates:
        reference, target = templates[-1]
        types = [child for child in tree.children[tree.children.index(reference) + 1 :] if child.kind == kinds.TYPE_REFERENCE]
        for index, child in enumerate(types):
            unit.add(
                "instance_member_use", expr, declare_class(unit, target), index, declare_type(unit, libclang.cursor_type(child.cursor))
            )
        return
    for child in tree.children:
        if child.kind == kinds.TYPE_REFERENCE:
            owner = declare_type(unit, libclang.cursor_type(child.cursor))
            if is_template_parameter(owner):
                unit.add("template_member_use", expr, owner, name)


def is_template_parameter(type_: str) -> bool:
    """Whether this is what clang calls a parameter of a template."""
    return bool(_TEMPLATE_PARAMETER.fullmatch(type_))


def declare_member_type(unit: UnitFacts, owner: Type, name: str) -> str | None:
    """Record the member type `name` of `owner`; None when that is no template parameter."""
    parameter = declare_type(unit, owner)
    if not is_template_parameter(parameter):
        return None
    member = f"typename {parameter}::{name}"
    unit.add("type_member", member, parameter, name)
    return member


def declare_class(unit: UnitFacts, cursor: Cursor) -> str:
    """Return the qualified name of the class at `cursor`, recording its bases on first sight."""
    pattern = _pattern(cursor)
    known = unit.declared.get(pattern.d0 or 0)
    if known is not None:
        return known
    identifier = unit.declared[pattern.d0 or 0] = _scope_name(unit, pattern)
    kind = "template" if pattern.kind in (kinds.CLASS_TEMPLATE, kinds.PARTIAL_SPECIALIZATION) else _CLASS_KINDS.get(pattern.kind, "class")
    unit.add("class", identifier, kind)
    if unit.place(pattern)[0].stands_in:
        unit.add("class_undeclared", identifier)
    body = libclang.definition(pattern)
    for specifier in libclang.bases(body if body.d0 and unit.sees(body) else pattern) if pattern.kind in kinds.CLASSES else ():
        declare_base_instance(unit, identifier, specifier)
        declaration = libclang.type_declaration(libclang.cursor_type(specifier))
        if declaration.kind in kinds.CLASSES:
            unit.add("class_base", identifier, declare_class(unit, declaration))
        else:
            unit.add("class_base", identifier, _template_base(unit, specifier))
    return identifier


def declare_base_instance(unit: UnitFacts, identifier: str, specifier: Cursor) -> None:
    """Record a base that is an instance of a class template."""
    base = libclang.cursor_type(specifier)
    if libclang.template_argument_count(base) > 0:
        unit.add("class_base_instance", identifier, declare_type(unit, base))


def _template_base(unit: UnitFacts, specifier: Cursor) -> str:
    """A base that depends on a template parameter: its template when that is known, else its text."""
    for reference in libclang.children(specifier):
        if reference.kind == kinds.TEMPLATE_REFERENCE:
            return declare_class(unit, libclang.referenced(reference))
    return unknown_type(unit.text(unit.span(specifier)))


def declare_type(unit: UnitFacts, type_: Type) -> str:
    """Return the canonical spelling of a type, recording its structure on first sight."""
    pointer = type_.d0 or 0
    known = unit.types.get(pointer)
    if known is not None:
        return known
    type_ = libclang.canonical_type(type_)
    name = unit.types[pointer] = unit.types[type_.d0 or 0] = _placed(unit, unit.type_name(type_))
    if name not in unit.type_names:
        unit.type_names.add(name)
        _record_type(unit, type_, name)
    return name


def _placed(unit: UnitFacts, name: str) -> str:
    """The name of a type; one without a name is called by its place, whatever way led there and wherever workspace and rosarch lie."""

    def place(match: re.Match[str]) -> str:
        path = os.path.normpath(match.group(1))
        return f" at {path.removeprefix(f'{unit.root}/').removeprefix(f'{SHIPPED}/')}:{match.group(2)})"

    return _PLACE.sub(place, name) if " at " in name else name


def _record_type(unit: UnitFacts, type_: Type, name: str) -> None:
    """Record the structure of a canonical type."""
    inner: Type | None = None
    kind = "const"
    if libclang.is_const(type_):
        inner = libclang.unqualified_type(type_)
    elif type_.kind in (kinds.TYPE_POINTER, kinds.TYPE_REFERENCE_LVALUE, kinds.TYPE_REFERENCE_RVALUE):
        kind = "pointer" if type_.kind == kinds.TYPE_POINTER else "reference"
        inner = libclang.pointee(type_)
    elif type_.kind in kinds.TYPE_ARRAYS:
        kind, inner = "array", libclang.array_element(type_)
    if inner is not None:
        inner_name = declare_type(unit, inner)
        if inner_name != name:
            unit.add("type_inner", name, kind, inner_name)
        return
    parameter = _TEMPLATE_PARAMETER.fullmatch(name)
    if parameter:
        unit.add("template_parameter", name, int(parameter.group(1)))
    member = _TEMPLATE_MEMBER.fullmatch(name)
    if member:
        owner = member.group(1)
        unit.add("template_parameter", owner, int(member.group(2)))
        unit.add("type_member", name, owner, member.group(3))
    declaration = libclang.type_declaration(type_)
    if declaration.kind in kinds.CLASSES or declaration.kind == kinds.ENUM:
        unit.add("type_class", name, declare_class(unit, declaration))
    for index in range(libclang.template_argument_count(type_)):
        argument = libclang.template_argument(type_, index)
        if argument.kind != kinds.TYPE_INVALID:
            unit.add("type_argument", name, index, declare_type(unit, argument))
