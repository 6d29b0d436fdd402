"""A lean binding of libclang: the few calls the extractor needs, through ctypes, without a Python object per cursor.

`clang.cindex` wraps every cursor, type and location in an object and costs five times as much per node
(see also https://clang.llvm.org/doxygen/group__CINDEX.html for the meaning of the functions used here).
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_longlong, c_uint, c_void_p
from functools import cached_property
from pathlib import Path
from typing import Any

from rosarch.extractor.cxx import kinds
from rosarch.extractor.cxx.libclang_library import Cursor, FieldVisitor, Location, Range, RangeList, String, Type, Visitor, bind

_BUFFERED = 2
"""The flag of a text that `data` is not the address of; the other flag than zero is that of one that has to be disposed of."""
MACRO_BIT = 1 << 31
KEEP_GOING = 0x200
INCOMPLETE = 0x02
FOR_SERIALIZATION = 0x10
DETAILED_PREPROCESSING = 0x01
FATAL = 4


_get_c_string = bind("getCString", c_char_p, String)
_dispose_string = bind("disposeString", None, String)
_create_index = bind("createIndex", c_void_p, c_int, c_int)
_dispose_index = bind("disposeIndex", None, c_void_p)
_parse = bind(
    "parseTranslationUnit2",
    c_int,
    c_void_p,
    c_char_p,
    POINTER(c_char_p),
    c_int,
    c_void_p,
    c_uint,
    c_uint,
    POINTER(c_void_p),
)
_dispose_unit = bind("disposeTranslationUnit", None, c_void_p)
_save_unit = bind("saveTranslationUnit", c_int, c_void_p, c_char_p, c_uint)
_visit = bind("visitChildren", c_uint, Cursor, Visitor, c_void_p)

unit_cursor = bind("getTranslationUnitCursor", Cursor, c_void_p)
extent = bind("getCursorExtent", Range, Cursor)
location = bind("getCursorLocation", Location, Cursor)
referenced = bind("getCursorReferenced", Cursor, Cursor)
canonical = bind("getCanonicalCursor", Cursor, Cursor)
definition = bind("getCursorDefinition", Cursor, Cursor)
semantic_parent = bind("getCursorSemanticParent", Cursor, Cursor)
template_of = bind("getSpecializedCursorTemplate", Cursor, Cursor)
is_definition = bind("isCursorDefinition", c_uint, Cursor)
linkage = bind("getCursorLinkage", c_int, Cursor)
storage_class = bind("Cursor_getStorageClass", c_int, Cursor)
is_static_method = bind("CXXMethod_isStatic", c_uint, Cursor)
is_deleted_method = bind("CXXMethod_isDeleted", c_uint, Cursor)
has_attributes = bind("Cursor_hasAttrs", c_uint, Cursor)
is_anonymous = bind("Cursor_isAnonymous", c_uint, Cursor)
is_anonymous_record = bind("Cursor_isAnonymousRecordDecl", c_uint, Cursor)
cursor_type = bind("getCursorType", Type, Cursor)
result_type = bind("getCursorResultType", Type, Cursor)
underlying_typedef = bind("getTypedefDeclUnderlyingType", Type, Cursor)
canonical_type = bind("getCanonicalType", Type, Type)
pointee = bind("getPointeeType", Type, Type)
array_element = bind("getArrayElementType", Type, Type)
type_declaration = bind("getTypeDeclaration", Cursor, Type)
unqualified_type = bind("getUnqualifiedType", Type, Type)
template_kind = bind("getTemplateCursorKind", c_int, Cursor)
is_const = bind("isConstQualifiedType", c_uint, Type)
_visit_fields = bind("Type_visitFields", c_uint, Type, FieldVisitor, c_void_p)
template_argument_count = bind("Type_getNumTemplateArguments", c_int, Type)
template_argument = bind("Type_getTemplateArgumentAsType", Type, Type, c_uint)
argument_count = bind("Cursor_getNumArguments", c_int, Cursor)
argument = bind("Cursor_getArgument", Cursor, Cursor, c_uint)
overload_count = bind("getNumOverloadedDecls", c_uint, Cursor)
_overload = bind("getOverloadedDecl", Cursor, Cursor, c_uint)
_unit_of = bind("Cursor_getTranslationUnit", c_void_p, Cursor)
_cursor_at = bind("getCursor", Cursor, c_void_p, Location)
enum_value = bind("getEnumConstantDeclValue", c_longlong, Cursor)
_evaluate = bind("Cursor_Evaluate", c_void_p, Cursor)
_result_kind = bind("EvalResult_getKind", c_int, c_void_p)
_result_integer = bind("EvalResult_getAsLongLong", c_longlong, c_void_p)
_result_double = bind("EvalResult_getAsDouble", c_double, c_void_p)
_dispose_result = bind("EvalResult_dispose", None, c_void_p)
binary_operator = bind("getCursorBinaryOperatorKind", c_int, Cursor)
unary_operator = bind("getCursorUnaryOperatorKind", c_int, Cursor)
_get_overridden = bind("getOverriddenCursors", None, Cursor, POINTER(POINTER(Cursor)), POINTER(c_uint))
_dispose_overridden = bind("disposeOverriddenCursors", None, POINTER(Cursor))
_cursor_spelling = bind("getCursorSpelling", String, Cursor)
_type_spelling = bind("getTypeSpelling", String, Type)
_file_location = bind("getFileLocation", None, Location, POINTER(c_void_p), POINTER(c_uint), POINTER(c_uint), POINTER(c_uint))
_spelling_location = bind("getSpellingLocation", None, Location, POINTER(c_void_p), POINTER(c_uint), POINTER(c_uint), POINTER(c_uint))
_file_name = bind("getFileName", String, c_void_p)
_included_file = bind("getIncludedFile", c_void_p, Cursor)
_all_skipped_ranges = bind("getAllSkippedRanges", POINTER(RangeList), c_void_p)
_dispose_ranges = bind("disposeSourceRangeList", None, POINTER(RangeList))
_diagnostic_count = bind("getNumDiagnostics", c_uint, c_void_p)
_diagnostic = bind("getDiagnostic", c_void_p, c_void_p, c_uint)
_dispose_diagnostic = bind("disposeDiagnostic", None, c_void_p)
_diagnostic_severity = bind("getDiagnosticSeverity", c_int, c_void_p)
_diagnostic_spelling = bind("getDiagnosticSpelling", String, c_void_p)
_diagnostic_location = bind("getDiagnosticLocation", Location, c_void_p)
_binary_spelling = bind("getBinaryOperatorKindSpelling", String, c_int)
_unary_spelling = bind("getUnaryOperatorKindSpelling", String, c_int)


class ParseError(Exception):
    """libclang gave no translation unit at all."""


def _text(string: String, errors: str = "replace") -> str:
    flags = string.flags
    data = _get_c_string(string) if flags == _BUFFERED else string.data
    result = data.decode("utf-8", errors) if data else ""
    if flags:  # else it belongs to the unit
        _dispose_string(string)
    return result


def spelling(cursor: Cursor) -> str:
    """The unqualified name of what `cursor` declares or refers to."""
    return _text(_cursor_spelling(cursor))


def type_spelling(type_: Type) -> str:
    """The C++ spelling of `type_`."""
    return _text(_type_spelling(type_))


_OPERATORS: dict[tuple[str, int], str] = {}


def operator_spelling(cursor: Cursor, unary: bool) -> str:
    """The operator of a unary, binary or compound-assignment cursor; empty when libclang does not know."""
    key = ("u", unary_operator(cursor)) if unary else ("b", binary_operator(cursor))
    if key not in _OPERATORS:
        _OPERATORS[key] = _text((_unary_spelling if unary else _binary_spelling)(key[1]))
    return _OPERATORS[key]


def evaluate(cursor: Cursor) -> int | float | None:
    """The compile-time value of an expression, if it is a number."""
    handle = _evaluate(cursor)
    if not handle:
        return None
    kind = _result_kind(handle)
    value = _result_integer(handle) if kind == 1 else _result_double(handle) if kind == 2 else None
    _dispose_result(handle)
    return value


def overridden(cursor: Cursor) -> list[Cursor]:
    """The methods of base classes that the method at `cursor` overrides directly."""
    array, count = POINTER(Cursor)(), c_uint()
    _get_overridden(cursor, byref(array), byref(count))
    result = [Cursor.from_buffer_copy(array[i]) for i in range(count.value)]
    if array:
        _dispose_overridden(array)
    return result


_visit_results: list[Cursor] = []


def _visited(cursor: Cursor, visitor: Any) -> list[Cursor]:
    """What a visit of `cursor` adds to `_visit_results`."""
    _visit(cursor, visitor, None)
    return _taken()


def _taken() -> list[Cursor]:
    """What is in `_visit_results`, which is empty then: what stayed in it would turn up in the next visit."""
    found = _visit_results[:]
    _visit_results.clear()
    return found


def _collect(child: Cursor, _parent: Cursor, _data: Any) -> int:
    _visit_results.append(child)
    return 1


_COLLECT = Visitor(_collect)


def children(cursor: Cursor) -> list[Cursor]:
    """The direct children of `cursor`, in source order."""
    return _visited(cursor, _COLLECT)


def _collect_bases(child: Cursor, _parent: Cursor, _data: Any) -> int:
    if child.kind in _MEMBERS:
        return 0
    _visit_results.append(child)
    return 1


_MEMBERS = frozenset({*kinds.FUNCTIONS, kinds.FIELD, kinds.ACCESS_SPECIFIER, kinds.TYPEDEF, kinds.TYPE_ALIAS})
_COLLECT_BASES = Visitor(_collect_bases)


def bases(cursor: Cursor) -> list[Cursor]:
    """The base specifiers of the class at `cursor`: clang visits them before its members, of which it may have many."""
    return [child for child in _visited(cursor, _COLLECT_BASES) if child.kind == kinds.BASE_SPECIFIER]


def _collect_fields(field: Cursor, _data: Any) -> int:
    _visit_results.append(field)
    return 1


_COLLECT_FIELDS = FieldVisitor(_collect_fields)


def fields(type_: Type) -> list[Cursor]:
    """The data members of objects of `type_`, in order; also of an instance of a template, whose declaration has no children."""
    _visit_fields(type_, _COLLECT_FIELDS, None)
    return _taken()


def _collect_declarations(child: Cursor, _parent: Cursor, _data: Any) -> int:
    if child.kind != kinds.MACRO_DEFINITION:
        _visit_results.append(child)
    return 1


_COLLECT_DECLARATIONS = Visitor(_collect_declarations)


class Tree:
    """A cursor with all its descendants, read in one visit; `span` and `target` are for what is asked of it, then kept."""

    __slots__ = ("children", "cursor", "kind", "span", "target")

    def __init__(self, cursor: Cursor) -> None:
        self.kind = cursor.kind
        self.cursor = cursor
        self.children: list[Tree] = []
        self.span: Any = None
        self.target: Cursor | None = None


_stack: list[tuple[tuple[int, int | None, int | None], Tree]] = []


def _grow(child: Cursor, parent: Cursor, _data: Any) -> int:
    key = (parent.kind, parent.d0, parent.d1)
    stack = _stack
    if stack[-1][0] != key:
        depth = len(stack) - 1
        while depth and stack[depth - 1][0] != key:
            depth -= 1
        if depth:  # some children, such as a lambda's captured values, name a parent that is not visited
            del stack[depth:]
    node = Tree(child)
    stack[-1][1].children.append(node)
    stack.append(((node.kind, child.d0, child.d1), node))
    return 2  # CXChildVisit_Recurse


_GROW = Visitor(_grow)


def tree(cursor: Cursor) -> Tree:
    """Return the whole subtree of `cursor` (preorder visit; parents are found on a stack)."""
    root = Tree(cursor)
    _stack[:] = [((cursor.kind, cursor.d0, cursor.d1), root)]
    _visit(cursor, _GROW, None)
    _stack.clear()
    return root


def _descend(child: Cursor, _parent: Cursor, _data: Any) -> int:
    _visit_results.append(child)
    return 2


_DESCEND = Visitor(_descend)


def descendants(cursor: Cursor) -> list[Cursor]:
    """All cursors below `cursor`, each before those below it."""
    return _visited(cursor, _DESCEND)


def _descend_to_calls(child: Cursor, _parent: Cursor, _data: Any) -> int:
    if child.kind == kinds.CALL:
        _visit_results.append(child)
    return 2


_DESCEND_TO_CALLS = Visitor(_descend_to_calls)


def calls_below(cursor: Cursor) -> list[Cursor]:
    """All calls below `cursor`."""
    return _visited(cursor, _DESCEND_TO_CALLS)


def target(tree: Tree) -> Cursor:
    """What the cursor of `tree` refers to."""
    if tree.target is None:
        tree.target = referenced(tree.cursor)
    return tree.target


def overloaded_functions(references: Iterable[Tree]) -> list[Cursor]:
    """The functions of overload sets; of a declaration that a using-declaration stands for, those that it names."""
    found: list[Cursor] = []
    for reference in references:
        for candidate in _overloads(reference.cursor):
            if candidate.kind == kinds.UNEXPOSED_DECLARATION:
                found += _overloads(_cursor_at(_unit_of(candidate), location(candidate)))
            else:
                found.append(candidate)
    return [candidate for candidate in found if candidate.kind in kinds.FUNCTIONS]


def _overloads(reference: Cursor) -> list[Cursor]:
    return [_overload(reference, index) for index in range(overload_count(reference))]


def spelling_location(place: Location) -> tuple[str, int]:
    """Return (file name, byte offset) of where the text of a location is written: for a macro's argument, the argument."""
    file, line, column, offset = c_void_p(), c_uint(), c_uint(), c_uint()
    _spelling_location(place, byref(file), byref(line), byref(column), byref(offset))
    return (_text(_file_name(file)) if file else "", offset.value)


def file_location(place: Location) -> tuple[str, int]:
    """Return (file name, byte offset) of a location; a macro body counts as the place of its use."""
    file, line, column, offset = c_void_p(), c_uint(), c_uint(), c_uint()
    _file_location(place, byref(file), byref(line), byref(column), byref(offset))
    return (_text(_file_name(file), "surrogateescape") if file else "", offset.value)


def included_file(inclusion: Cursor) -> str:
    """The name of the file that an inclusion directive found."""
    file = _included_file(inclusion)
    return _text(_file_name(file), "surrogateescape") if file else ""


class Unit:
    """A parsed translation unit; use as a context manager. Raises `OSError` for a source that cannot be read, `ParseError` otherwise."""

    def __init__(self, path: Path, arguments: Sequence[str], options: int = KEEP_GOING) -> None:
        # declarations from a precompiled header are not visited: what it declares is declared on first reference
        self._index = _create_index(1, 0)
        self._handle = c_void_p()
        array = (c_char_p * len(arguments))(*[os.fsencode(argument) for argument in arguments])
        code = _parse(self._index, os.fsencode(path), array, len(arguments), None, 0, options, byref(self._handle))
        if code or not self._handle:
            _dispose_index(self._index)
            path.open("rb").close()  # clang does not say that a file is gone
            raise ParseError(f"libclang error {code}")

    def __enter__(self) -> Unit:
        return self

    def __exit__(self, *_exception: object) -> None:
        _dispose_unit(self._handle)
        _dispose_index(self._index)

    @property
    def cursor(self) -> Cursor:
        """The cursor of the whole unit."""
        return unit_cursor(self._handle)  # type: ignore[no-any-return]

    def declarations(self) -> list[Cursor]:
        """All at its top level, but for the definitions of macros: most are clang's own."""
        return _visited(self.cursor, _COLLECT_DECLARATIONS)

    def save(self, path: Path) -> None:
        """Write the unit as a precompiled header."""
        code = _save_unit(self._handle, os.fsencode(path), 0)
        if code:
            raise ParseError(f"precompiled header not saved (libclang error {code})")

    def skipped_ranges(self) -> Iterator[Range]:
        """Yield what conditional compilation leaves out; needs `DETAILED_PREPROCESSING`."""
        ranges = _all_skipped_ranges(self._handle)
        for index in range(ranges.contents.count):
            yield Range.from_buffer_copy(ranges.contents.ranges[index])
        _dispose_ranges(ranges)

    @cached_property
    def diagnostics(self) -> list[tuple[int, str, Location]]:
        """Severity, message and location of each; severity 3 is an error, 4 fatal."""
        found = []
        for index in range(_diagnostic_count(self._handle)):
            handle = _diagnostic(self._handle, index)
            found.append((_diagnostic_severity(handle), _text(_diagnostic_spelling(handle)), _diagnostic_location(handle)))
            _dispose_diagnostic(handle)
        return found
