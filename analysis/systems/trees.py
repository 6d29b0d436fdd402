"""The behavior trees that nodes carry out: their files lie in packages of the workspace or in installed ones."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from rosarch.extractor.behavior_trees import TreeNode, nodes_of
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.underlay import Underlay

PACKAGE = "package://"
"""What the folder of a package is called where code asks for it (http://wiki.ros.org/resource_retriever)."""


class Trees:
    """Finds the files that texts name, and reads each set of them once."""

    def __init__(self, root: Path, underlay: Underlay) -> None:
        self.packages = PackagePath([root], underlay)
        self._read: dict[tuple[str, ...], tuple[tuple[TreeNode, ...], frozenset[str]]] = {}

    def nodes(self, files: Iterable[str]) -> tuple[tuple[TreeNode, ...], frozenset[str]]:
        """The nodes of the trees in some files, and the files that could not all be read."""
        key = tuple(files)
        if key not in self._read:
            paths = {file: path for file in key if (path := self._path(file)) is not None}
            nodes, whole = nodes_of(paths.values())
            unread = set(key) - paths.keys() if whole else set(key)
            self._read[key] = nodes, frozenset(unread)
        return self._read[key]

    def _path(self, text: str) -> Path | None:
        if not text.startswith(PACKAGE):
            return Path(text) if text.startswith("/") else None
        package, _, rest = text.removeprefix(PACKAGE).partition("/")
        folder = self.packages.find(package)
        return Path(folder, rest) if folder else None
