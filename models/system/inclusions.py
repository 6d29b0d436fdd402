"""Which launch file includes which, and what each of them starts."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from rosarch.base.places import Place
from rosarch.models.system.model import Inclusion, SystemModel, SystemNode

_ARGUMENTS = re.compile(r"\s+[^\s/]+:=.*", re.DOTALL)
MOST_FILES = 20_000  # a file that includes another one twice, which does so again, is a large tree


@dataclass(frozen=True)
class LaunchFile:
    """A launch file where it is included, `at` being None for one that is given, with what it starts and includes there.

    `text` is the file's name as written; `path` is None when it is not there. What is in a file that is `cut` is not given: it includes
    itself, or there is too much.
    """

    path: str | None
    text: str
    at: Place | None
    starts: tuple[SystemNode, ...] = ()
    includes: tuple[LaunchFile, ...] = ()
    cut: bool = False


def include_tree(system: SystemModel) -> tuple[LaunchFile, ...]:
    """The launch files that are given, each with those that it includes.

    A file that is included in two places is there twice, with the nodes that it starts in either.
    """
    return _Tree(system).roots()


class _Tree:
    """The tree while it grows."""

    def __init__(self, system: SystemModel) -> None:
        self.includes: Mapping[str, list[Inclusion]] = _by_file(system.inclusions)
        self.starts: dict[tuple[Place, ...], list[SystemNode]] = defaultdict(list)
        for node in sorted(system.nodes, key=lambda node: (node.lines, node.name)):
            self.starts[node.lines[:-1]].append(node)
        self.given = {_ARGUMENTS.sub("", entry): entry for entry in system.launch}
        first = (node.lines[0].path for node in system.nodes if node.lines)
        included = {inclusion.file for inclusion in system.inclusions}
        alone = (path for path in self.includes if path not in included)
        self.files = list(dict.fromkeys((*self.given, *sorted({*first, *alone}))))
        self.left = MOST_FILES

    def roots(self) -> tuple[LaunchFile, ...]:
        return tuple(self.grown(path, self.given.get(path, path), (), frozenset()) for path in self.files)

    def grown(self, path: str, text: str, chain: tuple[Place, ...], above: frozenset[str]) -> LaunchFile:
        """The file at `path`, that the lines of `chain` lead to from a file that is given."""
        at = chain[-1] if chain else None
        self.left -= 1
        if path in above or self.left < 0:
            return LaunchFile(path, text, at, cut=True)
        starts = tuple(node for node in self.starts[chain] if node.lines and node.lines[-1].path == path)
        inner = []
        for inclusion in self.includes.get(path, ()):
            if inclusion.file is None:
                inner.append(LaunchFile(None, inclusion.text, inclusion.at))
            elif self.left >= 0:
                inner.append(self.grown(inclusion.file, inclusion.text, (*chain, inclusion.at), above | {path}))
        return LaunchFile(path, text, at, starts, tuple(inner))


def _by_file(inclusions: Iterable[Inclusion]) -> dict[str, list[Inclusion]]:
    found: dict[str, list[Inclusion]] = defaultdict(list)
    for inclusion in sorted(set(inclusions), key=lambda i: (i.at, i.file or "", i.text)):
        found[inclusion.at.path].append(inclusion)
    return found
