"""Which modules of a workspace a Python file imports, found as Python's import system finds them, with nothing imported."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.files import text_or_nothing
from rosarch.extractor.python_syntax import absolute_name, import_call, parse_python
from rosarch.extractor.underlay import NOTHING_INSTALLED, Underlay

MAX_MODULES = 2000
_IMPORT = re.compile(r"^[ \t]*(?:from[ \t]+(\.*)([\w.]*)[ \t]+import[ \t]+\(?([\w, \t*]+)|import[ \t]+([\w., \t]+))", re.MULTILINE)
_MAIN = re.compile(r"^(?:if\b.*__name__|\w[\w.]*\()", re.MULTILINE)


@dataclass(frozen=True)
class Import:
    """`import name`, or `from name import members` at a `level` of leading dots."""

    level: int
    name: str
    members: tuple[str, ...]


@dataclass(frozen=True)
class Outline:
    """What a file imports, wherever in it, whether running it does more than define, and whether there is more in it than texts.

    Of a file with another syntax than Python 3's, those imports that begin a line.
    """

    imports: tuple[Import, ...]
    acts: bool
    says_anything: bool


class Modules:
    """Reads modules, each once: those of the workspace, then those of installed packages."""

    def __init__(self, underlay: Underlay = NOTHING_INSTALLED) -> None:
        self._underlay = underlay
        self._installed: dict[str, Path | None] = {}
        self._outlines: dict[Path, Outline] = {}
        self._files: dict[tuple[str, Path], Path | None] = {}
        self._inside: dict[Path, frozenset[str]] = {}
        self._found: dict[tuple[Path, ...], dict[str, Path | None]] = {}

    def find(self, name: str, roots: Sequence[Path]) -> Path | None:
        """The file of a module; what is no name of one leads nowhere."""
        return self._find(name, roots, self._found.setdefault(tuple(roots), {}))

    def _find(self, name: str, roots: Sequence[Path], known: dict[str, Path | None]) -> Path | None:
        """The same, where `known` is what was found below these roots before: there are many, and each is asked for by many imports."""
        if name not in known:
            known[name] = self._look_for(name, roots)
        return known[name]

    def _look_for(self, name: str, roots: Sequence[Path]) -> Path | None:
        if "/" in name or not all(name.split(".")):
            return None
        own = self._own(name, roots)
        return self._of_underlay(name) if own is None and self._own(name.partition(".")[0], roots) is None else own

    def _own(self, name: str, roots: Sequence[Path]) -> Path | None:
        top = name.partition(".")[0]
        there = (root for root in roots if top in self._names_in(root))
        return next((found for root in there if (found := self._below(name, root)) is not None), None)

    def _names_in(self, folder: Path) -> frozenset[str]:
        """What modules a folder may have: a name is looked for in many folders, and most lack it."""
        if folder not in self._inside:
            try:
                names = os.listdir(folder)
            except OSError:
                names = []
            self._inside[folder] = frozenset(name.removesuffix(".py") for name in names)
        return self._inside[folder]

    def closure(self, file: Path, module: str, roots: Sequence[Path]) -> tuple[tuple[tuple[str, Path], ...], frozenset[str]]:
        """The modules that running a file imports, itself first, and the names of the packages that are elsewhere."""
        found: dict[str, Path] = {module: file}
        elsewhere: set[str] = set()
        waiting = [(module, file)]
        known = self._found.setdefault(tuple(roots), {})
        while waiting and len(found) < MAX_MODULES:
            here, path = waiting.pop(0)
            for name in self._named(here, path):
                target = self._find(name, roots, known)
                if target is None:
                    elsewhere.add(name.partition(".")[0])
                elif name not in found:
                    found[name] = target
                    waiting.append((name, target))
        first = found.pop(module)
        kept = {name: path for name, path in found.items() if path != first and self._outline(path).says_anything}
        return ((module, first), *kept.items()), frozenset(elsewhere - {name.partition(".")[0] for name in found})

    def does_something(self, file: Path) -> bool:
        """Whether a file does more than define when it is run."""
        return self._outline(file).acts

    def _named(self, module: str, path: Path) -> Iterator[str]:
        """All modules that the imports of a file may mean: `from a import b` is `a`, and `a.b` where that is a module."""
        package = module if path.name == "__init__.py" else module.rpartition(".")[0]
        for found in self._outline(path).imports:
            name = absolute_name(found.name, found.level, package)
            words = name.split(".") if name else []
            yield from (".".join(words[:count]) for count in range(1, len(words) + 1))
            yield from (f"{name}.{member}" if name else member for member in found.members if member.isidentifier())

    def _outline(self, path: Path) -> Outline:
        if path not in self._outlines:
            self._outlines[path] = _outline(text_or_nothing(path))
        return self._outlines[path]

    def _of_underlay(self, name: str) -> Path | None:
        if name not in self._installed:
            self._installed[name] = self._underlay.module(name)
        return self._installed[name]

    def _below(self, name: str, root: Path) -> Path | None:
        key = (name, root)
        if key not in self._files:
            base = root.joinpath(*name.split("."))
            candidates = (base / "__init__.py", base.with_name(f"{base.name}.py"))
            self._files[key] = next((path for path in candidates if os.path.isfile(path)), None)
        return self._files[key]


def _outline(text: str) -> Outline:
    try:
        tree = parse_python(text)
    except SyntaxError:
        return Outline(tuple(_imports_of_text(text)), acts=_MAIN.search(text) is not None, says_anything=True)
    return Outline(tuple(_imports_of_tree(tree)), any(map(_acts, tree.body)), not all(map(_is_text, tree.body)))


def _imports_of_tree(tree: ast.Module) -> Iterator[Import]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (Import(0, alias.name, ()) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield Import(node.level, node.module or "", tuple(alias.name for alias in node.names))
        elif isinstance(node, ast.Call) and (named := import_call(node, "")) is not None:
            yield Import(_dots(node), named[0], ())


def _dots(node: ast.Call) -> int:
    """How many dots the name that a call imports begins with."""
    name = getattr(node.args[0], "value", "")
    return len(name) - len(name.lstrip("."))


def _imports_of_text(text: str) -> Iterator[Import]:
    for dots, name, members, plain in _IMPORT.findall(text):
        if plain:
            yield from (Import(0, word.split()[0], ()) for word in plain.split(",") if word.strip())
        else:
            yield Import(len(dots), name, tuple(word.split()[0] for word in members.split(",") if word.strip()))


def _acts(node: ast.stmt) -> bool:
    if isinstance(node, ast.Expr):
        return not isinstance(node.value, ast.Constant)
    return isinstance(node, (ast.If, ast.For, ast.While, ast.With)) or (isinstance(node, ast.Try) and any(map(_acts, node.body)))


def _is_text(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
