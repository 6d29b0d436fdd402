"""A defect of a package: what shows in its build files, scripts and interfaces alone."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Defect:
    """What is wrong at `line` of `path`: `kind` names it, `about` what it concerns."""

    path: Path
    line: int
    kind: str
    about: str
