"""Paths and commands that a Python launch file puts together wrongly.

`os.path.join` drops what is before an absolute path, a `Command` joins its parts without spaces, a process is given its words one by one,
and a relative path of a file of parameters begins where launch is started.
"""

from __future__ import annotations

import ast
import itertools
import os
import re
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path

from rosarch.extractor.launch.model import Misjoined, Place

_NODES = frozenset({"Node", "LifecycleNode", "ComposableNode", "ComposableNodeContainer"})
_PROGRAM = re.compile(r"(?:ros2 run [\w-]+ )?[\w.-]*\w")
_SEVERAL_WORDS = re.compile(r"\s*[\w.-]+\s+\S")
_FOLDERS_ABOVE = 3


def misjoined(tree: ast.Module, path: str) -> Iterator[Misjoined]:
    """All such places of a file."""
    called = {target.id for node in ast.walk(tree) for target in _assigned_call(node)}
    paths = {target.id for node in ast.walk(tree) for target in _assigned_path(node)}
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Attribute(value=ast.Attribute(attr="path"), attr="join"), args=[first, *rest]):
                for number, part in enumerate(rest if not isinstance(first, ast.Constant) else ()):
                    if isinstance(part, ast.Constant) and isinstance(part.value, str) and part.value.startswith("/"):
                        yield _at(part, f"os.path.join drops what is before the absolute path `{_joined(rest[number:])}`", path)
            case ast.Call(func=ast.Name(id="Command") | ast.Attribute(attr="Command"), args=[ast.List(elts=[first, second, *rest])]):
                program = _program(first)
                if program is not None and _begins_at_once(second, called):
                    yield _at(node, f"no space separates `{program}` from what follows in the command", path)
                for part, text in _run_together([first, second, *rest], paths):
                    yield _at(part, f"no space separates `{text}` from what is before it in the command", path)
            case ast.Call(func=ast.Name(id="ExecuteProcess") | ast.Attribute(attr="ExecuteProcess"), keywords=keywords):
                program = _words_in_one({keyword.arg: keyword.value for keyword in keywords})
                if program is not None:
                    yield _at(node, f"`{program}` is taken for the name of one program: the words of a command are items of its list", path)
            case ast.Call(func=ast.Name(id=kind) | ast.Attribute(attr=kind), keywords=keywords) if kind in _NODES:
                for keyword in keywords:
                    if keyword.arg == "parameters" and isinstance(keyword.value, (ast.List, ast.Tuple)):
                        yield from _relative(keyword.value.elts, path)


def _at(node: ast.expr, what: str, path: str) -> Misjoined:
    return Misjoined(what, Place(path, node.lineno, node.col_offset + 1))


def _program(node: ast.expr) -> str | None:
    """The program that the first part of a command ends with."""
    match node:
        case ast.Constant(value=str(text)) if _PROGRAM.fullmatch(text):
            return text
        case ast.Call(func=ast.Name(id="FindExecutable"), keywords=[ast.keyword(value=ast.Constant(value=str(text)))]):
            return text
        case ast.Call(func=ast.Name(id="PathJoinSubstitution"), args=[ast.List(elts=[only])]) if isinstance(only, ast.Call):
            return _program(only)
    return None


def _words_in_one(given: Mapping[str | None, ast.expr]) -> str | None:
    """The first word of a command that no shell takes apart, where it is several words."""
    if None in given or not isinstance(given.get("shell", ast.Constant(False)), ast.Constant):
        return None
    match given.get("shell"), given.get("cmd"):
        case ast.Constant(value=value), _ if value:
            return None
        case _, ast.List(elts=[ast.Constant(value=str(text)) | ast.List(elts=[ast.Constant(value=str(text)), *_]), *_]):
            return text.strip() if _SEVERAL_WORDS.match(text) else None
    return None


def _run_together(parts: list[ast.expr], paths: Collection[str]) -> Iterator[tuple[ast.expr, str]]:
    """The arguments of a command, `name:=`, that begin right behind a path or the value of another argument."""
    value = False
    for before, part in itertools.pairwise(parts):
        value = _is_text(before, r".*\S:=") or (value and not isinstance(before, ast.Constant))
        behind_value = value and not isinstance(before, ast.Constant)
        behind_path = (isinstance(before, ast.Name) and before.id in paths) or _is_path(before)
        if (behind_value or behind_path) and isinstance(part, ast.Constant) and _is_text(part, r"[A-Za-z_]\w*:=.*"):
            yield part, str(part.value).partition(":=")[0] + ":="


def _is_text(node: ast.expr, pattern: str) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str) and re.fullmatch(pattern, node.value) is not None


def _is_path(node: ast.expr) -> bool:
    match node:
        case ast.Call(func=ast.Name(id="PathJoinSubstitution") | ast.Attribute(attr="PathJoinSubstitution")):
            return True
        case ast.Call(func=ast.Attribute(value=ast.Attribute(attr="path"), attr="join")):
            return True
    return False


def _begins_at_once(node: ast.expr, called: Collection[str]) -> bool:
    """Whether a part of a command is a substitution or path, which begins with no space; a variable is one that is `called` to be so."""
    match node:
        case ast.Name(id=name):
            return name in called
        case ast.Call(func=ast.Name(id=made)):
            return made[:1].isupper()
        case ast.Call(func=ast.Attribute(value=ast.Attribute(attr="path"), attr="join")):
            return True
    return False


def _assigned_call(node: ast.AST) -> Iterator[ast.Name]:
    """The variable that is given a substitution or path."""
    match node:
        case ast.Assign(targets=[ast.Name() as target], value=ast.Call() as call) if _begins_at_once(call, ()):
            yield target


def _assigned_path(node: ast.AST) -> Iterator[ast.Name]:
    """The variable that is given a path."""
    match node:
        case ast.Assign(targets=[ast.Name() as target], value=value) if _is_path(value):
            yield target


def _joined(parts: list[ast.expr]) -> str:
    return os.path.join(*(str(part.value) if isinstance(part, ast.Constant) else "..." for part in parts))


def _relative(values: list[ast.expr], path: str) -> Iterator[Misjoined]:
    """Files of parameters by a path that begins in a folder above the launch file: it is looked for elsewhere."""
    above = list(Path(path).parents)[:_FOLDERS_ABOVE]
    for value in values:
        match value:
            case ast.Constant(value=str(name)) if name.endswith((".yaml", ".yml")) and not os.path.isabs(name):
                if any(os.path.isfile(folder / name) for folder in above):
                    yield _at(value, f"`{name}` is looked for in the folder that launch is started in", path)
