"""What the `data_files` of a `setup.py` install, as far as they can be evaluated; entry points and scripts are programs."""

from __future__ import annotations

import ast
import os
import posixpath
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from rosarch.extractor.workspace.installs import Install, Obstacle, Unsure, may_be_no_text
from rosarch.extractor.workspace.model import EntryPoint, Program
from rosarch.extractor.workspace.setup_values import SetupValues


@dataclass
class DataFiles:
    """What is collected: files that are copied, and why there may be more. `path` is that of the `setup.py`."""

    path: Path
    installs: list[Install] = field(default_factory=list)
    unsure: list[Unsure] = field(default_factory=list)
    obstacles: list[Obstacle] = field(default_factory=list)

    def give_up(self, reason: str, node: ast.AST) -> None:
        """More may be installed, because of what is at `node`."""
        self.unsure.append(Unsure(reason, self.path, getattr(node, "lineno", 1)))

    def read(self, node: ast.expr, values: SetupValues) -> None:
        """The value of `data_files`, or a part of that list."""
        written = values.written(node)
        if isinstance(written, (ast.List, ast.Tuple)):
            for item in written.elts:
                self._item(item, values)
        elif isinstance(written, ast.BinOp) and isinstance(written.op, ast.Add):
            self.read(written.left, values)
            self.read(written.right, values)
        else:
            self.give_up("data_files that are not known", node)

    def _item(self, item: ast.expr, values: SetupValues) -> None:
        if isinstance(item, ast.Starred):
            self.read(item.value, values)
            return
        if not isinstance(item, (ast.Tuple, ast.List)) or len(item.elts) != 2:
            self.give_up("data_files that are not known", item)
            return
        destination = values.value(item.elts[0])
        if not isinstance(destination, str):
            self.give_up("data_files of a folder that is not known", item)
            return
        folder = posixpath.normpath(destination)
        files = list(_files(item.elts[1], values))
        for file in files:
            if file is None:
                self.installs.append(Install(folder, self.path.parent / "data_files", folder=True))  # any file
            else:
                source = self.path.parent / file
                self.installs.append(Install(posixpath.normpath(f"{folder}/{posixpath.basename(file)}"), source))
                if not os.path.exists(source) and not may_be_no_text(source):
                    self.obstacles.append(Obstacle("install source", file, self.path, item.lineno))


def _files(node: ast.expr, values: SetupValues) -> Iterator[str | None]:
    """The files of one entry; None for those that cannot be determined."""
    written = values.written(node)
    if isinstance(written, (ast.List, ast.Tuple)):
        for item in written.elts:
            yield from _files(item.value if isinstance(item, ast.Starred) else item, values)
    elif isinstance(written, ast.BinOp) and isinstance(written.op, ast.Add) and not isinstance(values.value(written), str):
        yield from _files(written.left, values)
        yield from _files(written.right, values)
    else:
        value = values.value(written)
        if isinstance(value, str):
            yield value
        elif isinstance(value, (list, tuple)) and all(isinstance(part, str) for part in value):
            yield from value
        else:
            yield None


def installed_packages(node: ast.expr, values: SetupValues, folder: Path) -> tuple[str, ...] | None:
    """The packages of Python that are installed, by their names; None when they are not known."""
    written = values.written(node)
    if isinstance(written, ast.Call) and ast.unparse(written.func).rpartition(".")[2] == "find_packages":
        if written.args or any(keyword.arg != "exclude" for keyword in written.keywords):
            return None
        return tuple(_packages_below(folder))  # with those that are left out: they are the tests
    value = values.value(node)
    return tuple(value) if isinstance(value, (list, tuple)) and all(isinstance(name, str) for name in value) else None


def _packages_below(folder: Path) -> Iterator[str]:
    """What `find_packages` finds: the folders with an `__init__.py`, as long as those above have one."""
    for here, folders, _ in os.walk(folder):
        folders[:] = [name for name in folders if os.path.isfile(os.path.join(here, name, "__init__.py"))]
        yield from (os.path.relpath(os.path.join(here, name), folder).replace(os.sep, ".") for name in folders)


def changed_later(tree: ast.Module) -> Iterator[ast.AST]:
    """What `data_files` may get in addition to what is assigned to it once: names that are used where no value is read."""
    given = {keyword.value.id for keyword in _keywords(tree, "data_files") if isinstance(keyword.value, ast.Name)}
    uses = [node for node in ast.walk(tree) if isinstance(node, ast.Name) and node.id in given]
    if len(uses) > 2 * len(given):
        yield uses[-1]
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and any(keyword.arg is None for keyword in call.keywords):
            yield call
    yield from _keywords(tree, "cmdclass")


def _keywords(tree: ast.Module, name: str) -> Iterator[ast.keyword]:
    return (node for node in ast.walk(tree) if isinstance(node, ast.keyword) and node.arg == name)


def programs_installed(package: str, points: Iterable[EntryPoint], programs: Iterable[Program]) -> Iterator[Install]:
    """The programs of a package whose scripts are put where `ros2 run` looks."""
    for point in points:
        if point.is_command:
            yield Install(f"lib/{package}/{point.name}", point.path)
    for program in programs:
        yield Install(f"lib/{package}/{program.name}", program.path)


def declared_elsewhere(folder: Path) -> Iterator[Unsure]:
    """Files beside the `setup.py` that may say what is installed."""
    for name, word in (("setup.cfg", "options.data_files"), ("pyproject.toml", "data-files"), ("pyproject.toml", "scripts")):
        path = folder / name
        try:
            text = path.read_text(encoding="utf-8", errors="replace") if os.path.isfile(path) else ""
        except OSError:
            text = word
        if word in text:
            yield Unsure(f"{word} in {name}", path, 1)
