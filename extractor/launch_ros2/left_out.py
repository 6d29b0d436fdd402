"""Actions that a Python launch file makes and gives to nobody.

A variable holds them that is not read again, or only as the one that event handlers wait for. What a comment of the file mentions was taken
out on purpose.
"""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator

from rosarch.extractor.launch.model import ActionLeftOut, Place
from rosarch.extractor.python_syntax import FUNCTIONS, nodes_within

_STARTING = "Node LifecycleNode ComposableNodeContainer LoadComposableNodes IncludeLaunchDescription ExecuteProcess GroupAction TimerAction"
_OTHER = "DeclareLaunchArgument OpaqueFunction RegisterEventHandler EmitEvent SetEnvironmentVariable SetParameter PushRosNamespace"
ACTIONS = frozenset(f"{_STARTING} {_OTHER}".split())
_HANDLERS = frozenset({"OnProcessStart", "OnProcessExit", "OnProcessIO", "OnExecutionComplete", "OnStateTransition"})
_Function = ast.FunctionDef | ast.AsyncFunctionDef


def left_out(tree: ast.Module, text: str, path: str) -> Iterator[ActionLeftOut]:
    """All such actions of a file, those of functions in functions too."""
    described = any(isinstance(node, ast.Name) and node.id == "LaunchDescription" for node in ast.walk(tree))
    comments = " ".join(re.findall(r"#[^\n]*", text))
    for function in ast.walk(tree) if described else ():
        if isinstance(function, _Function) and not _lets_others_look(function):
            yield from _of_function(function, comments, path)


def _lets_others_look(function: _Function) -> bool:
    """Whether what a function has in its variables may be read by name."""
    return any(isinstance(node, ast.Name) and node.id in ("locals", "vars", "eval", "exec") for node in ast.walk(function))


def _of_function(function: _Function, comments: str, path: str) -> Iterator[ActionLeftOut]:
    names = [node for node in ast.walk(function) if isinstance(node, ast.Name)]
    watched = {id(node) for node in _watched(function)}
    read = Counter(node.id for node in names if isinstance(node.ctx, ast.Load) and id(node) not in watched)
    declared = {name for node in ast.walk(function) if isinstance(node, (ast.Global, ast.Nonlocal)) for name in node.names}
    for statement in nodes_within(function.body, lambda node: isinstance(node, (*FUNCTIONS, ast.ClassDef))):
        match statement:
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.Call(func=ast.Name(id=action) | ast.Attribute(attr=action)) as made):
                if action in ACTIONS and not read[name] and name not in declared and not re.search(rf"\b{re.escape(name)}\b", comments):
                    yield ActionLeftOut(action, name, Place(path, made.lineno, made.col_offset + 1))
            case ast.Expr(value=ast.Call(func=ast.Name(id=action)) as made) if action in ACTIONS:
                yield ActionLeftOut(action, "", Place(path, made.lineno, made.col_offset + 1))


def _watched(function: _Function) -> Iterator[ast.AST]:
    """What event handlers wait for: they do not start it."""
    for node in ast.walk(function):
        match node:
            case ast.Call(func=ast.Name(id=handler) | ast.Attribute(attr=handler)) if handler in _HANDLERS:
                yield from node.args[:1]
                yield from (keyword.value for keyword in node.keywords if keyword.arg == "target_action")
