"""What of a workspace is started together: the launch files that were named, or those that no other includes."""

from __future__ import annotations

import itertools
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from rosarch.extractor import tracing
from rosarch.extractor.launch import compose, launch_files, top_level
from rosarch.models.system.requests import LaunchWordError, Request, Surroundings
from rosarch.models.system.surrounding import Launch

MAX_MATRIX = 256  # systems of one launch with several values for its arguments


def given(requests: Iterable[Request], where: Surroundings) -> list[Launch]:
    """The launches of requests. Files are absolute, or below the current folder or the workspace.

    Raises:
        LaunchWordError: a file is not there, or there are too many launches.
    """
    found = []
    for request in requests:
        paths = [_path(word, where.root) for word in request.files]
        names = [name for name, _ in request.arguments]
        combinations = list(itertools.islice(itertools.product(*(values for _, values in request.arguments)), MAX_MATRIX + 1))
        if len(combinations) > MAX_MATRIX:
            raise LaunchWordError(f"more than {MAX_MATRIX} combinations of arguments")
        found += [_launch(paths, dict(zip(names, values, strict=True)), where) for values in combinations]
    return found


def unincluded(where: Surroundings, jobs: int | None = None) -> list[Launch]:
    """A launch for each launch file of the workspace that no other includes; see `top_level`."""
    files = where.files()
    found = top_level(launch_files(os.path.abspath(where.root)), files, where.variables(), jobs)
    return [Launch(_shown(path, where.root), (_shown(path, where.root),), composed, files.packages) for path, composed in found.items()]


def has_launch_files(root: Path) -> bool:
    """Whether a workspace has launch files at all, be they templates only."""
    return bool(launch_files(os.path.abspath(root), templates=True))


def _path(word: str, root: Path) -> str:
    for path in (Path(word), root / word):
        tracing.probe(path)
        if os.path.isfile(path):
            return os.path.abspath(path)
    raise LaunchWordError(f"{word}: no such launch file, neither here nor below {root}")


def _launch(paths: Sequence[str], arguments: Mapping[str, str], where: Surroundings) -> Launch:
    files = where.files()
    composition = compose(paths, arguments, files=files, environment=where.variables())
    words = (*(_shown(path, where.root) for path in paths), *(f"{name}:={value}" for name, value in arguments.items()))
    return Launch(" ".join(words), words, composition, files.packages)


def _shown(path: str, root: Path) -> str:
    inside = os.path.relpath(path, os.path.abspath(root))
    return path if inside.startswith("..") else inside
