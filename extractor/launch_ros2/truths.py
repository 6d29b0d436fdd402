"""Where a Python launch file takes what stands for a launch configuration, or another substitution, for its value.

A `LaunchConfiguration` has no value while a launch file is read: it counts as true, and equals no text. What its `perform` gives is a text,
which counts as true unless it is empty.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator

from rosarch.extractor.launch.model import Place, SubstitutionUsed, TextTested
from rosarch.extractor.launch_ros2.left_out import ACTIONS
from rosarch.extractor.python_syntax import FUNCTIONS, nodes_within

_Occurrence = TextTested | SubstitutionUsed
_Function = ast.FunctionDef | ast.AsyncFunctionDef


def truths(tree: ast.Module, path: str) -> Iterator[_Occurrence]:
    """All such places of a file."""
    outer = _Names({}, tree.body)
    for found in _within(tree.body):
        yield from _of_node(found, outer, path)
    yield from _functions(tree.body, outer, path)


def _functions(body: list[ast.stmt], outer: _Names, path: str) -> Iterator[_Occurrence]:
    for function in _within(body):
        if isinstance(function, _Function):
            names = _Names(outer.values, function.body, function.args)
            for node in _within(function.body):
                yield from _of_node(node, names, path)
            yield from _functions(function.body, names, path)


def _within(body: list[ast.stmt]) -> Iterator[ast.AST]:
    """The nodes of a body, functions in it, and what is only shown, not entered."""
    return nodes_within(body, lambda node: isinstance(node, FUNCTIONS) or _is_print(node))


def _is_print(node: ast.AST) -> bool:
    """Whether it only shows something."""
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "print"


_OTHERS = frozenset({"FindPackageShare", "PathJoinSubstitution", "ThisLaunchFileDir", "EnvironmentVariable", "FindExecutable", "Command"})
"""Further substitutions, which are called by the names of their classes."""


_BY_NAME = {"LaunchConfigurationEquals": "never", "LaunchConfigurationNotEquals": "always"}
"""Conditions on a configuration that they want by its name, and how often they hold for another object (https://github.com/ros2/launch/issues/509)."""


class _Names:
    """The variables that stand for a configuration (`text` when for its text), of those that are assigned once, and are no arguments."""

    def __init__(self, outer: dict[str, tuple[str, bool]], body: list[ast.stmt], arguments: ast.arguments | None = None) -> None:
        nodes = list(_within(body))
        made = Counter(node.id for node in nodes if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load))
        given = [one.arg for one in ast.walk(arguments) if isinstance(one, ast.arg)] if arguments else []
        self.values = {name: value for name, value in outer.items() if name not in made and name not in given}
        for node in nodes:
            if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(target := node.targets[0], ast.Name):
                found = self.of(node.value) if made[target.id] == 1 and target.id not in given else None
                if found is not None:
                    self.values[target.id] = found

    def of(self, node: ast.expr) -> tuple[str, bool] | None:
        """The configuration that an expression stands for, and whether it is its text."""
        match node:
            case ast.Name(id=name):
                return self.values.get(name)
            case ast.Call(
                func=ast.Name(id="LaunchConfiguration") | ast.Attribute(attr="LaunchConfiguration"),
                args=[ast.Constant(value=str(name)), *_],
            ):
                return name, False
            case ast.Call(func=ast.Name(id=kind) | ast.Attribute(attr=kind)) if kind in _OTHERS:
                return kind, False
            case ast.Call(func=ast.Attribute(value=inner, attr="perform"), args=[_]):
                found = self.of(inner)
                return None if found is None or found[1] else (found[0], True)
        return None


def _of_node(node: ast.AST, names: _Names, path: str) -> Iterator[_Occurrence]:
    match node:
        case (
            ast.If(test=test)
            | ast.While(test=test)
            | ast.IfExp(test=test)
            | ast.Assert(test=test)
            | ast.UnaryOp(op=ast.Not(), operand=test)
        ):
            yield from _tested(test, names, path)
        case ast.comprehension(ifs=tests):
            for test in tests:
                yield from _tested(test, names, path)
        case ast.Call(func=ast.Name(id="bool"), args=[test]):
            yield from _tested(test, names, path)
        case ast.FormattedValue(value=written) | ast.Call(func=ast.Name(id="str"), args=[written]):
            yield from _written(written, names, path, "is written as the object that it is, not as its value")
        case ast.BinOp(left=left, op=ast.Add(), right=right) if _is_text(left) or _is_text(right):
            for one in (left, right):
                yield from _written(one, names, path, "cannot be joined with a text: TypeError")
        case ast.Call(func=ast.Attribute(value=ast.Attribute(attr="path"), attr="join"), args=parts):
            for one in parts:
                yield from _written(one, names, path, "is no path: TypeError")
        case ast.Call(func=ast.Name(id=kind) | ast.Attribute(attr=kind), args=[one, *_]) if kind in _BY_NAME:
            yield from _written(one, names, path, f"is not the name of a configuration: {kind} {_BY_NAME[kind]} holds")
        case ast.Call(func=ast.Name(id=kind) | ast.Attribute(attr=kind), keywords=keywords) if kind in ACTIONS:
            for keyword in keywords:
                if keyword.arg == "condition":
                    yield from _written(keyword.value, names, path, "is no condition: IfCondition makes one of it")
        case ast.Compare(left=left, ops=[ast.Eq() | ast.NotEq() | ast.Is() | ast.IsNot()], comparators=[right]):
            yield from _compared(node, left, right, names, path)


def _tested(test: ast.expr, names: _Names, path: str) -> Iterator[_Occurrence]:
    if isinstance(test, ast.BoolOp):
        for one in test.values:
            yield from _tested(one, names, path)
        return
    found = names.of(test)
    if found is not None:
        place = Place(path, test.lineno, test.col_offset + 1)
        yield TextTested(found[0], place) if found[1] else SubstitutionUsed(found[0], "counts as true", place)


def _is_text(node: ast.expr) -> bool:
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


def _written(node: ast.expr, names: _Names, path: str, effect: str) -> Iterator[_Occurrence]:
    found = names.of(node)
    if found is not None and not found[1]:
        yield SubstitutionUsed(found[0], effect, Place(path, node.lineno, node.col_offset + 1))


def _compared(node: ast.Compare, left: ast.expr, right: ast.expr, names: _Names, path: str) -> Iterator[_Occurrence]:
    """A comparison with something that is written, None left out."""
    for one, other in ((left, right), (right, left)):
        found = names.of(one)
        if found is not None and isinstance(other, ast.Constant) and other.value is not None:
            place = Place(path, node.lineno, node.col_offset + 1)
            if not found[1]:
                yield SubstitutionUsed(found[0], "equals no value", place)
            elif not isinstance(other.value, str):
                yield SubstitutionUsed(found[0], "is a text and equals no other value", place)
