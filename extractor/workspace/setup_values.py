"""Values of expressions in a `setup.py`, which is never run: of its own assignments, files that `glob` finds, texts of `package.xml`."""

from __future__ import annotations

import ast
import glob
import os
import posixpath
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element

from rosarch.base.files import read_file
from rosarch.base.xml_reader import XmlError, read_tree
from rosarch.extractor.launch.evaluation import EvalFailed, Evaluator, UnknownInvolved, Unsupported

_DEEPEST = 10  # names that stand for names


class SetupValues:
    """The assignments of the `setup.py` in `folder`."""

    def __init__(self, folder: Path, names: Mapping[str, ast.expr]) -> None:
        self.folder, self.names = folder, names
        self._depth = 0

    def written(self, node: ast.expr) -> ast.expr:
        """What an expression is: for a name, what it is assigned."""
        return self.names.get(node.id, node) if isinstance(node, ast.Name) else node

    def value(self, node: ast.expr) -> Any:
        """The value of an expression, None when it cannot be determined."""
        try:
            return _Evaluator(self._lookup, self.folder).evaluate(ast.unparse(node))
        except (EvalFailed, Unsupported, UnknownInvolved, RecursionError):
            return None

    def _lookup(self, name: str) -> Any:
        self._depth += 1
        found = self.value(self.names[name]) if name in self.names and self._depth < _DEEPEST else None
        self._depth -= 1
        if found is None:
            raise KeyError(name)
        return found

    def texts(self, node: ast.expr) -> Iterator[tuple[str, ast.expr]]:
        """The texts of a list, and of the lists and tuples in it, each with its place; one that cannot be determined costs itself only."""
        node = self.written(node)
        if isinstance(node, (ast.List, ast.Tuple)):
            for item in node.elts:
                yield from self.texts(item.value if isinstance(item, ast.Starred) else item)
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add) and not isinstance(self.value(node), str):
            yield from self.texts(node.left)
            yield from self.texts(node.right)
        else:
            yield from ((text, node) for text in _flat(self.value(node)))


def _flat(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, (list, tuple)):
        for part in value:
            yield from _flat(part)


class _Evaluator(Evaluator):
    """Expressions with functions of Python's library that read the package's folder."""

    def __init__(self, lookup: Callable[[str], Any], folder: Path) -> None:
        super().__init__(lookup, {})
        self.folder = folder
        join = posixpath.join
        self.called: dict[str, Callable[..., Any]] = {"os.path.join": join, "path.join": join, "join": join}
        self.called |= dict.fromkeys(("glob", "glob.glob"), self._glob)
        self.called |= dict.fromkeys(("ET.parse", "ElementTree.parse", "xml.etree.ElementTree.parse"), self._parse)

    def _call(self, node: ast.Call) -> Any:
        function = self.called.get(ast.unparse(node.func))
        return super()._call(node) if function is None else function(*map(self.known_value, node.args))

    def _glob(self, pattern: str) -> list[str]:
        inside = not os.path.isabs(pattern) and ".." not in pattern.split("/")
        return sorted(glob.glob(pattern, root_dir=self.folder, recursive=True)) if inside else []

    def _parse(self, path: str) -> Element:
        """The root of an XML file of the package."""
        if os.path.isabs(path) or ".." in path.split("/"):
            raise Unsupported("a file outside of the package")
        try:
            return read_tree(read_file(self.folder / path))
        except (OSError, XmlError) as error:
            raise EvalFailed(str(error)) from None

    def method(self, value: Any, name: str) -> Callable[..., Any]:
        """What `value.name(...)` calls: of an XML element, too."""
        if isinstance(value, Element):
            reading: dict[str, Callable[..., Any]] = {
                "getroot": lambda: value,
                "find": value.find,
                "findtext": value.findtext,
                "get": value.get,
            }
            if name in reading:
                return reading[name]
        return super().method(value, name)

    def attribute(self, value: Any, name: str) -> Any:
        """The text of an XML element."""
        if isinstance(value, Element) and name in ("text", "tag"):
            return getattr(value, name)
        return super().attribute(value, name)
