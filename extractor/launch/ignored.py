"""Files that `.gitignore` keeps out of a repository: they are made, or put there, on each machine, so that none of them is missing.

Source: gitignore(5). Patterns with a slash are for paths below the folder of the `.gitignore`, others for names at any depth; a folder
stands for all below it. What a later line brings back (`!`) counts as kept out, too.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from rosarch.base import tracing
from rosarch.base.files import read_file
from rosarch.base.path_patterns import path_matches


def kept_out(path: str, top: str) -> bool:
    """Whether a `.gitignore` of a folder of `path`, up to the folder `top`, keeps the file out."""
    folder = os.path.dirname(path)
    while folder.startswith(top):
        below = os.path.relpath(path, folder)
        if any(path_matches(pattern, below) for pattern in _patterns(os.path.join(folder, ".gitignore"))):
            return True
        if folder == os.path.dirname(folder):
            break
        folder = os.path.dirname(folder)
    return False


def _patterns(file: str) -> Iterator[str]:
    tracing.probe(file)
    if not os.path.isfile(file):
        return
    try:
        lines = read_file(file).decode("utf-8", "replace").splitlines()
    except OSError:
        return
    yield from (line.strip() for line in lines if line.strip() and line[0] not in "#!")
