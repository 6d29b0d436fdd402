"""How the components of a workspace are read."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.base.cache import hash_of
from rosarch.base.limits import SOURCE_SECONDS
from rosarch.rule_programs.choice import SHIPPED, RuleSet

if TYPE_CHECKING:
    from rosarch.base.cache import Cache
    from rosarch.extractor.units import Progress
    from rosarch.findings.configuration import RateGiven


@dataclass(frozen=True)
class Reading:
    """The rules, users' folders of library files that come before rosarch's own, the rates that users give; for the rest see `analyze`."""

    rules: RuleSet = SHIPPED
    library: Sequence[Path] = ()
    engine: str = "embedded"
    jobs: int | None = None
    timeout: float = SOURCE_SECONDS
    defines: Mapping[str, str] = field(default_factory=dict)
    cache: Cache | None = None
    progress: Progress | None = None
    rates: Sequence[RateGiven] = ()

    def key(self) -> list[str]:
        """All that the result depends on, but for the input and what ships."""
        return [rules_hash(self.rules), self.engine, repr(self.timeout), repr(sorted(self.defines.items())), library_hash(self.library)]


def rules_hash(rules: RuleSet) -> str:
    """A hash of rules, contents of files included; empty for those that ship."""
    if rules == SHIPPED:
        return ""
    from rosarch.rule_programs.sets import component_program, system_rules

    return hash_of([component_program(rules).hash, system_rules(rules).program.hash])


def library_hash(folders: Sequence[Path]) -> str:
    """A hash of the files of libraries."""
    files = [path for folder in folders for path in sorted(folder.rglob("*.json")) if os.path.isfile(path)]
    return hash_of([part for path in files for part in (str(path), path.read_bytes())])
