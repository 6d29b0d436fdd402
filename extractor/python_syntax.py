"""Python sources as syntax trees. They are parsed, never run."""

from __future__ import annotations

import ast
import warnings
from collections.abc import Callable, Iterable, Iterator

from rosarch.base.files import LARGEST_PARSED
from rosarch.extractor.python_fstrings import with_older_fstrings


def parse_python(text: str | bytes) -> ast.Module:
    """The tree of a source, without Python's warnings about it; columns are off in lines with f-strings that this Python does not take.

    Raises:
        SyntaxError: it is not Python 3, nested too deeply for the parser, or too large.
    """
    try:
        return parse_as_it_stands(text)
    except SyntaxError:
        if len(text) > LARGEST_PARSED:
            raise
        older = with_older_fstrings(text if isinstance(text, str) else text.decode(errors="replace"))
        if older is None:
            raise
    return parse_as_it_stands(older)


def parse_as_it_stands(text: str | bytes) -> ast.Module:
    """The tree of a source that this Python takes.

    Raises:
        SyntaxError: it does not take it.
    """
    if len(text) > LARGEST_PARSED:
        raise SyntaxError(f"larger than {LARGEST_PARSED >> 20} MiB", ("", 1, 1, ""))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return ast.parse(text)
        except (RecursionError, MemoryError):
            raise SyntaxError("nested too deeply", ("", 1, 1, "")) from None
        except ValueError as error:  # a null byte
            raise SyntaxError(str(error), ("", 1, 1, "")) from None


def absolute_name(name: str, level: int, package: str) -> str:
    """The module that `name` with `level` dots in front means in a module of `package`; `name` itself, with too many dots."""
    if not level:
        return name
    above = package.split(".")[: max(package.count(".") + 2 - level, 0)] if package else []
    return ".".join([*above, *([name] if name else [])])


def import_call(node: ast.Call, package: str) -> tuple[str, str] | None:
    """The module that a call imports by a name that is written out, and the one that it gives; None for other calls."""
    match node:
        case ast.Call(func=ast.Name(id="__import__"), args=[ast.Constant(value=str(name)), *rest]):
            listed = len(rest) > 2 or any(keyword.arg == "fromlist" for keyword in node.keywords)
            return name, name if listed else name.partition(".")[0]
        case ast.Call(func=ast.Name(id="import_module") | ast.Attribute(attr="import_module"), args=[ast.Constant(value=str(name)), *_]):
            inner = name.lstrip(".")
            whole = absolute_name(inner, len(name) - len(inner), package)
            return whole, whole
    return None


FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)


def nodes_within(body: Iterable[ast.AST], is_closed: Callable[[ast.AST], bool]) -> Iterator[ast.AST]:
    """The nodes of a body in the order of the source, without those inside of what is closed."""
    stack: list[ast.AST] = list(reversed(list(body)))
    while stack:
        node = stack.pop()
        yield node
        if not is_closed(node):
            stack.extend(reversed(list(ast.iter_child_nodes(node))))


_REACHES_NAMES = frozenset({"globals", "locals", "vars", "exec", "eval", "setattr", "__import__", "__builtins__", "modules"})
"""Names of what may give a module names that it does not write."""


def bound_names(tree: ast.Module) -> frozenset[str] | None:
    """The names that a module binds anywhere, in any of its functions as well; None when it may have more than it writes."""
    found: set[str] = set()
    for node in ast.walk(tree):
        match node:
            case ast.Name(id=name, ctx=ast.Load()) | ast.Attribute(attr=name):
                if name in _REACHES_NAMES:
                    return None
            case ast.Name(id=name) | ast.arg(arg=name) | ast.MatchStar(name=str(name)) | ast.MatchMapping(rest=str(name)):
                found.add(name)
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                found.add(name)
            case ast.ExceptHandler(name=str(name)) | ast.MatchAs(name=str(name)):
                found.add(name)
            case ast.alias(name=name, asname=other):
                if name == "*":
                    return None
                found.add(other or name.partition(".")[0])
    return frozenset(found)
