"""Classes of records get the constructor that they are given when they are made: `dataclass`, `NamedTuple`, attrs.

`class Camera(NamedTuple): topic: str = "image"` is made by `Camera("left")` or `Camera(topic="left")`; the text behind the field is what is
taken where there is no argument. Of a class that derives from one of another module no field is known to keep that.
"""

from __future__ import annotations

import ast
from copy import deepcopy
from dataclasses import dataclass

_DECORATORS = frozenset({"dataclass", "define", "frozen", "mutable"})
_BASES = frozenset({"NamedTuple"})
_PLAIN = frozenset({"object", "ABC", "Generic", "Protocol"})
_FIELDS = frozenset({"field", "ib", "attrib"})


@dataclass(frozen=True)
class _Field:
    """A field and where it is written; `default` is what it has without an argument, `given` says that the constructor takes one."""

    written: ast.AnnAssign
    name: str
    default: ast.expr | None
    given: bool


def give_constructors(tree: ast.Module) -> None:
    """Change the tree in place."""
    known: dict[str, tuple[_Field, ...]] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ClassDef) and (options := _options(node)) is not None:
            own, bases = _fields(node), {_last_name(base) for base in node.bases} - _BASES - _PLAIN
            if bases <= known.keys():
                inherited = {field.name: field for base in node.bases for field in known.get(_last_name(base), ())}
                known[node.name] = tuple((inherited | {field.name: field for field in own}).values())
            if "init" in options or _has(node, "__init__"):
                continue
            if node.name in known:
                _give_constructor(node, known[node.name], "kw_only" in options)
            for field in own:
                field.written.value = None


def _options(node: ast.ClassDef) -> frozenset[str] | None:
    """What the decorator of a class of records is given; None when it is no such class."""
    decorators = [one for one in node.decorator_list if _last_name(one) in _DECORATORS]
    if not decorators and not any(_last_name(base) in _BASES for base in node.bases):
        return None
    return frozenset(keyword.arg or "" for one in decorators if isinstance(one, ast.Call) for keyword in one.keywords)


def _fields(node: ast.ClassDef) -> list[_Field]:
    found = []
    for part in node.body:
        match part:
            case ast.AnnAssign(target=ast.Name(id=name), annotation=annotation) if _last_name(annotation) not in ("ClassVar", "KW_ONLY"):
                found.append(_Field(part, name, *_default(part.value)))
    return found


def _default(value: ast.expr | None) -> tuple[ast.expr | None, bool]:
    """What a field has without an argument, and whether the constructor takes one."""
    if not isinstance(value, ast.Call) or _last_name(value.func) not in _FIELDS:
        return value, True
    said = {keyword.arg: keyword.value for keyword in value.keywords}
    default = said.get("default")
    if factory := said.get("default_factory") or said.get("factory"):
        default = ast.copy_location(ast.Call(factory, [], []), value)
    match said.get("init"):
        case ast.Constant(value=False):
            return default, False
    return default, True


def _give_constructor(node: ast.ClassDef, fields: tuple[_Field, ...], named: bool) -> None:
    """`named` says that arguments are given by their names alone."""
    given = [field for field in fields if field.given]
    first = next((index for index, field in enumerate(given) if field.default is not None), len(given))
    if not named and any(field.default is None for field in given[first:]):
        return  # Python does not take it either
    parameters = [ast.arg(field.name, deepcopy(field.written.annotation)) for field in given]
    defaults = [deepcopy(field.default) for field in given]
    body: list[ast.stmt] = []
    for field in fields:
        here = field.written.target
        value = ast.copy_location(ast.Name(field.name, ast.Load()), here) if field.given else deepcopy(field.default)
        if value is not None:
            target = ast.copy_location(ast.Attribute(ast.Name("self", ast.Load()), field.name, ast.Store()), here)
            body.append(_placed(ast.Assign([target], value), field.written))
    if _has(node, "__post_init__"):
        call = ast.Call(ast.Attribute(ast.Name("self", ast.Load()), "__post_init__", ast.Load()), [], [])
        body.append(_placed(ast.Expr(call), node))
    self = ast.arg("self")
    if named:
        arguments = ast.arguments([], [self], None, parameters, defaults, None, [])
    else:
        arguments = ast.arguments([], [self, *parameters], None, [], [], None, [one for one in defaults if one is not None])
    constructor = ast.FunctionDef("__init__", arguments, body or [ast.Pass()], [], None)
    node.body.append(_placed(constructor, node))


def _has(node: ast.ClassDef, method: str) -> bool:
    return any(isinstance(part, ast.FunctionDef) and part.name == method for part in node.body)


def _placed(node: ast.stmt, place: ast.stmt) -> ast.stmt:
    return ast.fix_missing_locations(ast.copy_location(node, place))


def _last_name(node: ast.expr) -> str:
    """`NamedTuple` of `typing.NamedTuple`, `Generic` of `Generic[T]`, `dataclass` of `dataclass(frozen=True)`."""
    match node:
        case ast.Call(func=inner) | ast.Subscript(value=inner):
            return _last_name(inner)
        case ast.Attribute(attr=name) | ast.Name(id=name):
            return name
    return ""
