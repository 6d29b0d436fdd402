"""Patterns of paths, as in `.gitignore` (gitignore(5))."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase


def path_matches(pattern: str, path: str) -> bool:
    """Whether a pattern means a file, by its relative path: a folder means all below it, and a bare name any folder's."""
    anchored = "/" in pattern.rstrip("/")
    steps = [step for step in pattern.split("/") if step not in ("", ".")]
    names = [name for name in path.split("/") if name not in ("", ".")]
    return bool(steps) and _steps_match(steps if anchored else ["**", *steps], names)


def _steps_match(steps: Sequence[str], names: Sequence[str]) -> bool:
    """Whether the steps of a pattern match the first of `names`, or all: `ends` are the numbers of names that the steps so far match."""
    ends = {0}
    for step in steps:
        if step == "**":
            ends = set(range(min(ends), len(names) + 1))
        else:
            ends = {end + 1 for end in ends if end < len(names) and fnmatchcase(names[end], step)}
        if not ends:
            return False
    return True
