"""Behavior trees of BehaviorTree.CPP, versions 3 and 4: XML files whose elements name nodes of libraries.

Source: https://www.behaviortree.dev/docs/learn-the-basics/xml_format.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree.ElementTree import Element

from rosarch.base.files import LARGEST_PARSED, read_file
from rosarch.base.xml_reader import XmlError, read_tree

_EXPLICIT = frozenset({"Action", "Condition", "Control", "Decorator"})
"""Elements whose attribute ID names the node; elsewhere the element does."""
_SUBTREE = frozenset({"SubTree", "SubTreePlus"})
_NO_INPUTS = frozenset({"ID", "name"})
_DEEPEST = 50
"""Trees within trees are followed so far."""
_PortValues = tuple[tuple[str, str], ...]
"""What a tree gives a node, or another tree in it: names and texts."""


@dataclass(frozen=True, order=True)
class TreeNode:
    """A node in a tree: the name that its class is registered by, and what the tree gives its ports, by their names.

    An entry of the blackboard is given in braces.
    """

    id: str
    inputs: _PortValues


@dataclass
class Forest:
    """The trees of some files by their names; `main` are the names of those that are carried out when no other is asked for.

    It is not `whole` when a file could not be read.
    """

    trees: dict[str, Element] = field(default_factory=dict)
    main: list[str] = field(default_factory=list)
    whole: bool = True

    def add(self, path: Path) -> None:
        """Add the trees of a file, and of those that it includes by paths relative to it."""
        self._add(path, set())

    def _add(self, path: Path, seen: set[Path]) -> None:
        if path in seen:
            return
        seen.add(path)
        try:
            root = read_tree(read_file(path, LARGEST_PARSED))
        except (OSError, XmlError):
            self.whole = False
            return
        for include in root.iter("include"):
            target = include.get("path") or ""
            if include.get("ros_pkg") or not target:
                self.whole = False
            else:
                self._add((path.parent / target).resolve(), seen)
        names = []
        for tree in root.iter("BehaviorTree"):
            names.append(tree.get("ID") or "")
            self.trees.setdefault(names[-1], tree)
        main = root.get("main_tree_to_execute")
        self.main += [main] if main is not None else names if len(names) == 1 else []

    def nodes(self) -> tuple[TreeNode, ...]:
        """The nodes of the main trees and of all that these contain, each once; of all trees where no tree is the main one."""
        found: set[TreeNode] = set()
        visited: set[tuple[str, _PortValues]] = set()
        for name in self.main or self.trees:
            self._collect(name, (), (), found, visited)
        return tuple(sorted(found))

    def _collect(
        self, name: str, given: _PortValues, within: tuple[str, ...], found: set[TreeNode], visited: set[tuple[str, _PortValues]]
    ) -> None:
        """Add the nodes of a tree, which is `within` others, to `found`: once for all values that the trees that contain it pass to it."""
        tree = self.trees.get(name)
        if tree is None or name in within or len(within) > _DEEPEST:
            self.whole = False
            return
        if (name, given) in visited:
            return
        visited.add((name, given))
        references = {f"{{{key}}}": text for key, text in given}
        for element in tree.iter():
            inputs = tuple(sorted(_inputs(element, references)))
            if element.tag in _SUBTREE:
                self._collect(element.get("ID") or "", inputs, (*within, name), found, visited)
            elif element is not tree and (id_ := element.get("ID") if element.tag in _EXPLICIT else element.tag):
                found.add(TreeNode(id_, inputs))


def _inputs(element: Element, given: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """What an element says of ports; `given` is what the tree gets from the one that contains it, by references to it."""
    for key, text in element.items():
        if key not in _NO_INPUTS and not key.startswith("_"):
            yield key, given.get(text, text)


def nodes_of(paths: Iterable[Path]) -> tuple[tuple[TreeNode, ...], bool]:
    """The nodes of the trees that are read from files, and whether these are all."""
    forest = Forest()
    for path in paths:
        forest.add(path)
    nodes = forest.nodes()
    return nodes, forest.whole
