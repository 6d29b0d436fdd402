"""Facts that were extracted before: a folder that `rosarch extract` wrote, or that of one of its packages or components, or one text."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from rosarch.base.diagnostics import Diagnostic
from rosarch.extractor.manifest import entries_below, facts_folder, read_manifest

FIRST = "rosarch facts"
"""The first line of a text of facts."""


@dataclass(frozen=True)
class Facts:
    """The facts of a component: how to read them, and a hash of them as their key."""

    name: str
    package: str
    kind: str
    sources: tuple[str, ...]
    key: str
    rows: Callable[[], Mapping[str, Iterable[tuple[Any, ...]]]]
    size: int = 0  # unknown before they are read
    units: tuple[Path, ...] = ()  # not known


@dataclass(frozen=True)
class StoredFacts:
    """The facts of some components; paths of sources start from `root`."""

    root: Path
    components: tuple[Facts, ...]
    diagnostics: tuple[Diagnostic, ...]


def has_facts(path: Path) -> bool:
    """Whether it is facts that lie at `path`, not sources."""
    return facts_folder(path) is not None if os.path.isdir(path) else is_facts_text(path)


def is_facts_text(path: Path) -> bool:
    """Whether a file is a text of facts."""
    try:
        if not os.path.isfile(path):
            return False
        with path.open("rb") as file:
            return file.readline(len(FIRST) + 2).rstrip() == FIRST.encode()
    except OSError:
        return False


def read_stored(path: Path) -> StoredFacts:
    """The facts that lie at `path`.

    Raises `ManifestError` when they are stale or damaged.
    """
    from rosarch.extractor.facts_text import read_facts_text

    return _folder(path) if os.path.isdir(path) else read_facts_text(path)


def _folder(path: Path) -> StoredFacts:
    from rosarch.datalog import read_facts
    from rosarch.extractor.facts import schema

    top = facts_folder(path) or path
    manifest = read_manifest(top)
    found = (
        Facts(e.component, e.package, e.kind, e.sources, e.digest, partial(read_facts, top / e.folder, schema()))
        for e in entries_below(manifest, top, path)
    )
    return StoredFacts(Path(manifest.root), tuple(found), manifest.diagnostics)
