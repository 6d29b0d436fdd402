"""What the workspace has of what launch files name, as rows of `rules/schema/launch.dl`."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from pathlib import Path

from rosarch.extractor.files import read_file
from rosarch.extractor.launch.model import Composition, PackageNamed, ProgramNamed
from rosarch.library import Library

Rows = dict[str, set[tuple[str, ...]]]
_DEPENDENCY = re.compile(r"<\w*depend[^<>]*>\s*([^<\s]+)\s*</")


def programs_named(compositions: Iterable[Composition]) -> set[tuple[str, str]]:
    """Package and type of the nodes in all branches that no file of the package is called like."""
    named = (reference for composition in compositions for reference in composition.references)
    return {(named.package, named.type) for named in named if isinstance(named, ProgramNamed) and not named.mentioned}


def workspace_rows(root: Path, compositions: Sequence[Composition], programs: Collection[tuple[str, str]], library: Library) -> Rows:
    """Which of the programs and packages that launch files name there are, or are to be expected."""
    named = (reference for composition in compositions for reference in composition.references)
    absent = {reference.package for reference in named if isinstance(reference, PackageNamed) and reference.folder is None}
    absent |= {problem.subject for composition in compositions for problem in composition.problems}
    expected = {component.package for component in library.components}
    if absent - expected:
        expected |= _dependencies(root)
    return {
        "program_built": {program for program in programs_named(compositions) if program in programs},
        "package_expected": {(package,) for package in absent & expected},
    }


def _dependencies(root: Path) -> set[str]:
    """All that the manifests below `root` depend on."""
    from rosarch.extractor.workspace.manifests import find_manifests

    found: set[str] = set()
    for path in find_manifests(root, []):
        try:
            found.update(_DEPENDENCY.findall(read_file(path).decode(errors="replace")))
        except OSError:
            continue  # where the package is read, that is reported
    return found
