"""What the `setup.py` and `setup.cfg` of a package install: commands, scripts, the folders that modules are imported from.

A `setup.py` is never run. Keyword arguments of its calls are read, of `setup` as well as of catkin's `generate_distutils_setup`, and what
is put into a dictionary of them (`d['package_dir'] = ...`), as far as they can be evaluated from the module's own assignments. Sources:
setuptools on entry points, `package_dir` and declarative configuration.
"""

from __future__ import annotations

import ast
import configparser
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rosarch.extractor.diagnostics import Diagnostic, unreadable
from rosarch.extractor.files import read_file
from rosarch.extractor.python_syntax import parse_python

from .model import EntryPoint, Program

_GROUP = "console_scripts"


@dataclass(frozen=True)
class Setup:
    """What a package's `setup.py` and `setup.cfg` say."""

    entry_points: tuple[EntryPoint, ...] = ()
    programs: tuple[Program, ...] = ()
    roots: tuple[Path, ...] = ()


def read_setup(folder: Path) -> tuple[Setup, list[Diagnostic]]:
    """What the package in `folder` installs with setuptools."""
    problems: list[Diagnostic] = []
    points: list[EntryPoint] = []
    programs: list[Program] = []
    roots: list[Path] = []
    script, declared = folder / "setup.py", folder / "setup.cfg"
    for keyword, value, names in _keywords(script, problems):
        if keyword == "entry_points":
            points.extend(_entry_points(value, names, script))
        elif keyword == "scripts":
            programs.extend(Program(text.rpartition("/")[2], folder / text) for text, _ in _texts(value, names))
        elif keyword == "package_dir":
            found = _value(value, names)
            roots.extend(_roots(folder, found) if isinstance(found, dict) else ())
    points.extend(_declared(declared, problems))
    if os.path.isfile(script) and not roots:
        roots.append(folder)
    setup = Setup(tuple(dict.fromkeys(points)), tuple(p for p in programs if os.path.isfile(p.path)), tuple(dict.fromkeys(roots)))
    return setup, problems


def _keywords(path: Path, problems: list[Diagnostic]) -> Iterator[tuple[str | None, ast.expr, Mapping[str, ast.expr]]]:
    """The keyword arguments of all calls in a `setup.py` and the entries given to its dictionaries, each with the module's assignments."""
    try:
        tree = parse_python(read_file(path))
    except FileNotFoundError:
        return
    except OSError as error:
        problems.append(unreadable(path, error))
        return
    except SyntaxError as error:
        problems.append(Diagnostic("setup", path, error.lineno or 1, error.offset or 1, f"not read: {error.msg}"))
        return
    names: dict[str, ast.expr] = {}
    for node in tree.body:
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            names[node.targets[0].id] = node.value
    for part in ast.walk(tree):
        match part:
            case ast.Call(keywords=keywords):
                yield from ((keyword.arg, keyword.value, names) for keyword in keywords)
            case ast.Assign(targets=[ast.Subscript(slice=ast.Constant(value=str(key)))], value=value):
                yield key, value, names


def _value(node: ast.expr, names: Mapping[str, ast.expr], depth: int = 0) -> Any:
    """The value of an expression, None when it cannot be told."""
    from rosarch.extractor.launch.evaluation import EvalFailed, UnknownInvolved, Unsupported, evaluate

    def lookup(name: str) -> Any:
        found = _value(names[name], names, depth + 1) if depth < 10 else None
        if found is None:
            raise KeyError(name)
        return found

    try:
        return evaluate(ast.unparse(node), lookup, {})
    except (EvalFailed, Unsupported, UnknownInvolved, RecursionError):
        return None


def _texts(node: ast.expr, names: Mapping[str, ast.expr]) -> Iterator[tuple[str, ast.expr]]:
    """The texts of a list, each with where it is written; one that cannot be told costs itself only."""
    if isinstance(node, ast.Name) and node.id in names:
        node = names[node.id]
    if isinstance(node, (ast.List, ast.Tuple)):
        for item in node.elts:
            yield from ((text, item) for text in [_value(item, names)] if isinstance(text, str))
    elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        yield from _texts(node.left, names)
        yield from _texts(node.right, names)
    else:
        found = _value(node, names)
        if isinstance(found, (list, tuple)):
            yield from ((text, node) for text in found if isinstance(text, str))


def _entry_points(node: ast.expr, names: Mapping[str, ast.expr], path: Path) -> Iterator[EntryPoint]:
    if isinstance(node, ast.Name) and node.id in names:
        node = names[node.id]
    if isinstance(node, ast.Dict):
        for key, value in zip(node.keys, node.values, strict=True):
            if key is not None and _value(key, names) == _GROUP:
                for text, place in _texts(value, names):
                    yield from _entry_point(text, path, place.lineno)
        return
    text = _value(node, names)
    if isinstance(text, str):
        for line in _lines_of_group(text):
            yield from _entry_point(line, path, node.lineno)


def _lines_of_group(text: str) -> Iterator[str]:
    """The lines below `[console_scripts]` in the text form of entry points."""
    group = ""
    for line in map(str.strip, text.splitlines()):
        if line.startswith("["):
            group = line.strip("[] ")
        elif group == _GROUP and line and not line.startswith(("#", ";")):
            yield line


def _declared(path: Path, problems: list[Diagnostic]) -> Iterator[EntryPoint]:
    """The entry points of a `setup.cfg`."""
    try:
        text = read_file(path).decode(errors="replace")
    except FileNotFoundError:
        return
    except OSError as error:
        problems.append(unreadable(path, error))
        return
    parser = configparser.RawConfigParser(strict=False)
    try:
        parser.read_string(text)
    except configparser.Error as error:
        line = getattr(error, "lineno", None) or (getattr(error, "errors", None) or [(1, "")])[0][0]
        problems.append(Diagnostic("setup", path, line, 1, "not read: no section or key and value"))
        return
    lines = text.splitlines()
    for line in (parser.get("options.entry_points", _GROUP, fallback=None) or "").splitlines():
        number = next((index for index, other in enumerate(lines, 1) if other.strip() == line.strip()), 1)
        yield from _entry_point(line, path, number)


def _entry_point(text: str, path: Path, line: int) -> Iterator[EntryPoint]:
    """`name = module:function [extra]`."""
    name, equals, target = text.partition("=")
    module, colon, function = target.partition("[")[0].partition(":")
    if equals and colon and name.strip() and module.strip() and function.strip():
        yield EntryPoint(name.strip(), module.strip(), function.strip(), path, line)


def _roots(folder: Path, package_dir: Mapping[Any, Any]) -> Iterator[Path]:
    """Where `package_dir` says that packages lie: that of all, and those above a package's own folder."""
    for package, below in package_dir.items():
        if isinstance(package, str) and isinstance(below, str) and ".." not in Path(below).parts:
            path, above = folder / below, package.count(".")
            named = path.name == package.rpartition(".")[2] and above < len(path.parents)
            yield path if not package else path.parents[above] if named else path.parent
