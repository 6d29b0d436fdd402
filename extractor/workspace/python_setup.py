"""What the `setup.py` and `setup.cfg` of a package install: commands, scripts, the folders that modules are imported from.

A `setup.py` is never run. Keyword arguments of its calls are read, of `setup` as well as of catkin's `generate_distutils_setup`, and what
is put into a dictionary of them (`d['package_dir'] = ...`), as far as they can be evaluated from the module's own assignments. Sources:
setuptools on entry points, `package_dir` and declarative configuration.
"""

from __future__ import annotations

import ast
import configparser
import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rosarch.base.diagnostics import Diagnostic, unreadable
from rosarch.base.files import read_file
from rosarch.extractor.python_syntax import parse_python
from rosarch.extractor.workspace.installs import Install, Obstacle, Unsure
from rosarch.extractor.workspace.model import EntryPoint, Program
from rosarch.extractor.workspace.python_installs import DataFiles, changed_later, declared_elsewhere, installed_packages, programs_installed
from rosarch.extractor.workspace.setup_values import SetupValues

_PROGRAMS = re.compile(r"lib/[^/]+/?")


@dataclass(frozen=True)
class Setup:
    """What a package's `setup.py` and `setup.cfg` say."""

    entry_points: tuple[EntryPoint, ...] = ()
    programs: tuple[Program, ...] = ()
    roots: tuple[Path, ...] = ()
    installs: tuple[Install, ...] = ()
    unsure: tuple[Unsure, ...] = ()
    packages: tuple[str, ...] | None = None
    obstacles: tuple[Obstacle, ...] = ()


def read_setup(folder: Path, package: str) -> tuple[Setup, list[Diagnostic]]:
    """What the package in `folder` installs with setuptools."""
    problems: list[Diagnostic] = []
    points: list[EntryPoint] = []
    programs: list[Program] = []
    roots: list[Path] = []
    packages: list[tuple[str, ...] | None] = []
    script, declared = folder / "setup.py", folder / "setup.cfg"
    data = DataFiles(script)
    for keyword, value, values in _keywords(script, problems):
        if keyword == "entry_points":
            points.extend(_entry_points(value, values, script))
            if not _is_constant(value, values):
                data.give_up("entry points that are not known", value)
        elif keyword == "scripts":
            programs.extend(_program(folder, text) for text, _ in values.texts(value))
            if not _is_constant(value, values):
                data.give_up("scripts that are not known", value)
        elif keyword == "data_files":
            programs.extend(_program(folder, text) for text in _installed(value, values))
            data.read(value, values)
        elif keyword == "packages":
            packages.append(installed_packages(value, values, folder))
        elif keyword == "py_modules":
            packages.append(None)
        elif keyword == "package_dir":
            found = values.value(value)
            roots.extend(_roots(folder, found) if isinstance(found, dict) else ())
    points.extend(_declared(declared, problems))
    if os.path.isfile(script) and not roots:
        roots.append(folder)
    data.installs.extend(programs_installed(package, points, programs))
    unsure = (*data.unsure, *_not_read(script, problems), *declared_elsewhere(folder))
    there = tuple(program for program in programs if os.path.isfile(program.path))
    once = (tuple(dict.fromkeys(points)), there, tuple(dict.fromkeys(roots)))
    only_package = packages[0] if len(packages) == 1 and roots == [folder] else None
    return Setup(*once, tuple(dict.fromkeys(data.installs)), tuple(dict.fromkeys(unsure)), only_package, tuple(data.obstacles)), problems


def _is_constant(node: ast.expr, values: SetupValues) -> bool:
    """Whether all of a value is known."""
    node = values.written(node)
    if isinstance(node, ast.Dict):
        return all(key is not None and values.value(value) is not None for key, value in zip(node.keys, node.values, strict=True))
    return values.value(node) is not None


def _not_read(script: Path, problems: Iterable[Diagnostic]) -> Iterator[Unsure]:
    """Why a `setup.py` may install more than its keywords say."""
    for problem in problems:
        yield Unsure(problem.message, problem.path, problem.line)
    try:
        tree = parse_python(read_file(script))
    except (OSError, SyntaxError):
        yield Unsure("no setup.py that can be read", script, 1)
        return
    for node in changed_later(tree):
        yield Unsure("what is given to setup() in another way", script, getattr(node, "lineno", 1))
    lines = [node.lineno for node in ast.walk(tree) if isinstance(node, ast.Call) and ast.unparse(node.func).endswith("setup")]
    if len(lines) != 1:
        yield Unsure("not one call of setup()", script, 1)


def _assigned(tree: ast.Module) -> dict[str, ast.expr]:
    """What the names of the module are given last; of those in branches, which ROS may decide, such as are given one value only."""
    below = list(_assignments(_statements(tree.body)))
    times = Counter(name for name, _ in below)
    return {name: value for name, value in below if times[name] == 1} | dict(_assignments(tree.body))


def _assignments(statements: Iterable[ast.AST]) -> Iterator[tuple[str, ast.expr]]:
    for statement in statements:
        match statement:
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                yield name, value


def _statements(body: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """The statements and those in their branches, but not those of functions, whose names are their own."""
    for statement in body:
        yield statement
        if not isinstance(statement, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            yield from _statements(node for node in ast.iter_child_nodes(statement) if isinstance(node, (ast.stmt, ast.excepthandler)))


def _program(folder: Path, path: str) -> Program:
    return Program(path.rpartition("/")[2], folder / path)


def _keywords(path: Path, problems: list[Diagnostic]) -> Iterator[tuple[str | None, ast.expr, SetupValues]]:
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
    values = SetupValues(path.parent, _assigned(tree))
    for part in ast.walk(tree):
        match part:
            case ast.Call(keywords=keywords):
                yield from ((keyword.arg, keyword.value, values) for keyword in keywords)
            case ast.Assign(targets=[ast.Subscript(slice=ast.Constant(value=str(key)))], value=value):
                yield key, value, values


def _installed(node: ast.expr, values: SetupValues) -> Iterator[str]:
    """The files that `data_files` puts where a package's programs are found, `lib/<package>`."""
    node = values.written(node)
    for item in node.elts if isinstance(node, (ast.List, ast.Tuple)) else ():
        if isinstance(item, ast.Tuple) and len(item.elts) == 2:
            folder = values.value(item.elts[0])
            if isinstance(folder, str) and _PROGRAMS.fullmatch(folder):
                yield from (text for text, _ in values.texts(item.elts[1]))


def _entry_points(node: ast.expr, values: SetupValues, path: Path) -> Iterator[EntryPoint]:
    node = values.written(node)
    if isinstance(node, ast.Dict):
        for key, value in zip(node.keys, node.values, strict=True):
            group: Any = values.value(key) if key is not None else None
            for text, place in values.texts(value) if isinstance(group, str) else ():
                for line in text.splitlines():
                    yield from _entry_point(line, group, path, place.lineno)
        return
    text = values.value(node)
    if isinstance(text, str):
        for group, line in _grouped(text):
            yield from _entry_point(line, group, path, node.lineno)


def _grouped(text: str) -> Iterator[tuple[str, str]]:
    """The lines below `[group]` in the text form of entry points, each with its group."""
    group = ""
    for line in map(str.strip, text.splitlines()):
        if line.startswith("["):
            group = line.strip("[] ")
        elif group and line and not line.startswith(("#", ";")):
            yield group, line


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
    for group, points in parser.items("options.entry_points") if parser.has_section("options.entry_points") else ():
        for line in (points or "").splitlines():
            number = next((index for index, other in enumerate(lines, 1) if other.strip() == line.strip()), 1)
            yield from _entry_point(line, group, path, number)


def _entry_point(text: str, group: str, path: Path, line: int) -> Iterator[EntryPoint]:
    """`name = module:function [extra]`."""
    name, equals, target = text.partition("=")
    module, colon, function = target.partition("[")[0].partition(":")
    if equals and colon and name.strip() and module.strip() and function.strip():
        yield EntryPoint(name.strip(), module.strip(), function.strip(), path, line, group)


def _roots(folder: Path, package_dir: Mapping[Any, Any]) -> Iterator[Path]:
    """Where `package_dir` says that packages lie: that of all, and those above a package's own folder."""
    for package, below in package_dir.items():
        if isinstance(package, str) and isinstance(below, str) and ".." not in Path(below).parts:
            path, above = folder / below, package.count(".")
            named = path.name == package.rpartition(".")[2] and above < len(path.parents)
            yield path if not package else path.parents[above] if named else path.parent
