"""By what components and systems are analysed."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.base.cache import hash_of
from rosarch.extractor.settings import DEFAULT, Progress, Settings
from rosarch.library.reading import library_files
from rosarch.rule_programs.choice import SHIPPED, RuleSet

if TYPE_CHECKING:
    from rosarch.findings.configuration import RateGiven


@dataclass(frozen=True)
class Method:
    """The rules, the engine that evaluates them, and how `sources` are read.

    Of systems, too, users' folders of library files that come before rosarch's own, and the rates that users give.
    """

    rules: RuleSet = SHIPPED
    engine: str = "embedded"
    sources: Settings = DEFAULT
    library: Sequence[Path] = ()
    rates: Sequence[RateGiven] = ()

    def reporting_to(self, progress: Progress | None) -> Method:
        """The same, which reports its progress to `progress`."""
        return replace(self, sources=replace(self.sources, progress=progress))

    def key(self) -> list[str]:
        """All that the result depends on, but for the input and what ships."""
        return [rules_hash(self.rules), self.engine, *self.sources.key(), library_hash(self.library)]


PLAIN = Method()
"""What ships, by sources that are read as by default."""


def rules_hash(rules: RuleSet) -> str:
    """A hash of rules, contents of files included; empty for those that ship."""
    if rules == SHIPPED:
        return ""
    from rosarch.rule_programs.sets import component_program, system_rules

    return hash_of([component_program(rules).hash, system_rules(rules).program.hash])


def library_hash(folders: Sequence[Path]) -> str:
    """A hash of the files of libraries."""
    files = [path for folder in folders for path in library_files(folder) if os.path.isfile(path)]
    return hash_of([part for path in files for part in (str(path), path.read_bytes())])
