"""What the texts of sources and build files say."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

from rosarch.base.files import text_or_nothing

_INCLUDE = re.compile(r'[ \t]*#[ \t]*(?:(?P<opens>if\w*)|(?P<closes>endif)|include[ \t]*[<"](?P<name>[\w./-]+)[>"])')
_COMMENT = re.compile(r"#[^\n]*")


def without_comments(build_file: Path) -> str:
    """The text of a file of CMake, without its comments; empty where it cannot be read."""
    return _COMMENT.sub("", text_or_nothing(build_file))


@lru_cache(maxsize=4096)
def included_in(path: str) -> tuple[tuple[str, int], ...]:
    """What a file includes under no condition but its guard."""
    found, depth, guard = [], 0, 0
    for number, line in enumerate(text_or_nothing(Path(path)).split("\n"), 1):
        match = _INCLUDE.match(line)
        if match is not None and match["opens"]:
            depth += 1
            guard = 1 if match["opens"] == "ifndef" and depth == 1 else guard
        elif match is not None and match["closes"]:
            depth -= 1
        elif match is not None and depth <= guard:
            found.append((match["name"], number))
    return tuple(found)
