"""Parts of values: what the elements of lists, tuples and dictionaries are, as far as expressions are written out."""

from __future__ import annotations

import ast
from collections.abc import Iterator

Path = tuple[int | None, ...]
"""Which part of a value: the index of an element, or None for any element; of this, the next one. () is the value itself."""
DEEPEST = 4
"""No part is asked for that is in more containers: `x = x[0]` in a loop asks for deeper and deeper ones."""

_SAME_ELEMENTS = frozenset({"list", "tuple", "sorted", "reversed", "set", "iter", "deque", "dict", "OrderedDict"})
_GIVE_ELEMENT = frozenset({"get", "pop", "popleft", "setdefault"})


def written_parts(node: ast.expr, path: Path) -> Iterator[tuple[ast.expr, Path]]:
    """What the part of `node` at `path`, which is not (), may be: parts of other expressions. Keys of dictionaries are not among them."""
    step, rest = path[0], path[1:]
    match node:
        case ast.List(elts=elements) | ast.Tuple(elts=elements) | ast.Set(elts=elements):
            yield from _elements(elements, step, rest)
        case ast.ListComp(elt=element) | ast.SetComp(elt=element) | ast.GeneratorExp(elt=element) | ast.DictComp(value=element):
            yield element, rest
        case ast.Dict(values=values):
            yield from ((value, rest) for value in values)
        case ast.IfExp(body=yes, orelse=no):
            yield from ((yes, path), (no, path))
        case ast.BoolOp(values=values):
            yield from ((value, path) for value in values)
        case ast.BinOp(left=left, right=right):
            yield from ((left, (None, *rest)), (right, (None, *rest)))
        case ast.NamedExpr(value=inner) | ast.Await(value=inner):
            yield inner, path
        case ast.Subscript(value=inner, slice=ast.Slice()):
            yield inner, (None, *rest)
        case ast.Subscript(value=inner, slice=index):
            yield inner, (index_of(index), *path)
        case ast.Call(func=ast.Attribute(value=inner, attr="values" | "copy"), args=[]):
            yield inner, path
        case ast.Call(func=ast.Attribute(value=inner, attr="items"), args=[]) | ast.Call(func=ast.Name(id="enumerate"), args=[inner, *_]):
            if rest and rest[0] != 0:
                yield inner, (None, *rest[1:])
        case ast.Call(func=ast.Name(id="zip"), args=arguments):
            if rest:
                yield from ((argument, (None, *rest[1:])) for argument, _ in _elements(arguments, rest[0], ()))
        case ast.Call(func=ast.Name(id="filter"), args=[_, inner]):
            yield inner, (None, *rest)
        case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name), args=[inner, *_]) if name in _SAME_ELEMENTS:
            yield inner, (None, *rest)
        case ast.Call() if (container := taken_from(node)) is not None:
            yield container, (None, *path)


def _elements(elements: list[ast.expr], index: int | None, rest: Path) -> Iterator[tuple[ast.expr, Path]]:
    """The element at `index`, or each."""
    starred = any(isinstance(element, ast.Starred) for element in elements)
    chosen = elements if index is None or starred else elements[index : index + 1]
    yield from ((element.value, (None, *rest)) if isinstance(element, ast.Starred) else (element, rest) for element in chosen)


def index_of(node: ast.expr) -> int | None:
    """The constant index that `node` is, from the beginning of a tuple or list."""
    match node:
        case ast.Constant(value=int() as index) if not isinstance(index, bool) and index >= 0:
            return index
    return None


def taken_from(node: ast.Call) -> ast.expr | None:
    """The container of which a call gives an element."""
    match node:
        case ast.Call(func=ast.Attribute(value=container, attr=name)) if name in _GIVE_ELEMENT:
            return container
        case ast.Call(func=ast.Name(id="next"), args=[container, *_]):
            return container
        case ast.Call(func=ast.Name(id="max" | "min") | ast.Attribute(value=ast.Name(id="random"), attr="choice"), args=[container]):
            return container
    return None
