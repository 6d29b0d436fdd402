"""Entry points that lead to no code: to modules, or functions of these, that the package does not have or does not install.

Of a module that is found elsewhere, or is made by the build, nothing is said.
"""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.files import read_file
from rosarch.extractor.python_syntax import parse_python
from rosarch.extractor.workspace.model import EntryPoint, Package
from rosarch.extractor.workspace.python_modules import Modules

_OTHER_MODULES = (".pyx", ".pyi", ".so", ".pyd", ".cpp", ".c", ".py.in")
_MAKING_NAMES = frozenset({"globals", "exec", "eval", "setattr", "vars", "locals"})


@dataclass(frozen=True)
class Lack:
    """What an entry point needs and the package lacks: a module, a function, or that the module is installed (left-out).

    Of a module that is not installed, `part` is the package of Python that is left out.
    """

    point: EntryPoint
    what: str
    part: str = ""


def lacks(package: Package) -> Iterator[Lack]:
    """The entry points of a package that is built with setuptools, as far as its `setup.py` is understood, that lead to no code."""
    if package.build_type != "ament_python" or package.unsure:
        return
    modules = Modules()
    for point in package.entry_points:
        if point.is_command:
            root = next((root for root in package.python_roots if _is_own(point.module, root)), None)
            if root is None:
                continue
            file = modules.find(point.module, package.python_roots)
            if file is None:
                if not _is_made(point.module, root):
                    yield Lack(point, "module")
            elif package.python_packages is not None and (part := _part(point.module, file)) not in package.python_packages:
                yield Lack(point, "left-out", part)
            elif not _has(file, point.function.partition(".")[0]):
                yield Lack(point, "function")


def _is_own(module: str, root: Path) -> bool:
    """Whether a module is to be one of the package of Python below a root: one that looks for its parts nowhere else."""
    top = root / module.partition(".")[0]
    if "." not in module or not os.path.isdir(top):
        return False
    try:
        return b"__path__" not in read_file(top / "__init__.py")
    except FileNotFoundError:
        return True
    except OSError:
        return False


def _is_made(module: str, root: Path) -> bool:
    base = root.joinpath(*module.split("."))
    try:
        names = os.listdir(base.parent)
    except OSError:
        return False
    return any(name.startswith(f"{base.name}.") and name.endswith(_OTHER_MODULES) for name in names)


def _part(module: str, file: Path) -> str:
    """The package of Python that a module in a file is, or is in."""
    return module if file.name == "__init__.py" else module.rpartition(".")[0]


def _has(file: Path, name: str) -> bool:
    """Whether a module may have something of this name."""
    try:
        tree = parse_python(read_file(file))
    except (OSError, SyntaxError):
        return True
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef(name=made) | ast.AsyncFunctionDef(name=made) | ast.ClassDef(name=made) | ast.Name(id=made):
                if made in (name, "__getattr__") or made in _MAKING_NAMES:
                    return True
            case ast.alias(name=imported, asname=made):
                if imported == "*" or (made or imported.partition(".")[0]) == name:
                    return True
    return False
