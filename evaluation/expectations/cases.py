"""What can be tested below a path: workspaces and single sources with expectations, and folders of facts with expected rows."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.files import folder_reader, path_text
from rosarch.datalog.inspection.rule_tests import find_tests
from rosarch.evaluation.expectations.comments import marked
from rosarch.evaluation.expectations.grammar import Expectation, ExpectationError, parse
from rosarch.extractor.suppressions import has_suppressions

SOURCES = frozenset({".c", ".cc", ".cpp", ".cxx", ".c++", ".py"})
_MANIFEST = "package.xml"


@dataclass(frozen=True)
class Case:
    """A workspace (`sources` is None), or single sources below `root`; with all that is expected, by file."""

    root: Path
    sources: tuple[Path, ...] | None
    expectations: tuple[Expectation, ...]


@dataclass(frozen=True)
class Cases:
    """What there is to test: `rules` are folders that hold tests of facts."""

    cases: tuple[Case, ...]
    rules: tuple[Path, ...]


def find_cases(paths: Sequence[Path]) -> Cases:
    """The tests at and below paths: files, or folders.

    Raises:
        ExpectationError: an expectation is not understood; all of these are reported.
    """
    problems: list[str] = []
    cases = [case for path in paths for case in (_below(path, problems) if os.path.isdir(path) else [_single(path, problems)])]
    if problems:
        raise ExpectationError("\n".join(problems))
    tested = tuple(path for path in paths if os.path.isdir(path) and find_tests(path))
    return Cases(tuple(case for case in cases if case.expectations), tested)


def _single(path: Path, problems: list[str]) -> Case:
    if path.suffix not in SOURCES:
        problems.append(f"{path}: not a C++ or Python source; other files are tested with the workspace that they are in")
    return Case(path.parent, (path,), tuple(_expectations(path.parent, [path.name], problems)))


def _below(folder: Path, problems: list[str]) -> Iterator[Case]:
    """The workspaces below a folder; what is in none of them are single sources."""
    loose: list[str] = []
    for path, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        here = Path(path)
        if _is_workspace(here, folders, names):
            files = (path_text(Path(above, name).relative_to(here)) for above, _, found in os.walk(here) for name in found)
            yield Case(here, None, tuple(_expectations(here, sorted(filter(has_suppressions, files)), problems)))
            folders.clear()
        else:
            loose += [path_text((here / name).relative_to(folder)) for name in sorted(names) if Path(name).suffix in SOURCES]
    expected = tuple(_expectations(folder, loose, problems))
    named = {expectation.marked.path for expectation in expected}
    yield Case(folder, tuple(folder / name for name in loose if name in named), expected)


def _is_workspace(folder: Path, folders: Sequence[str], names: Sequence[str]) -> bool:
    """Whether a folder is a package, or has packages in it or in `src`."""
    if _MANIFEST in names or any(os.path.isfile(folder / name / _MANIFEST) for name in folders):
        return True
    return "src" in folders and next((folder / "src").rglob(_MANIFEST), None) is not None


def _expectations(root: Path, files: Sequence[str], problems: list[str]) -> Iterator[Expectation]:
    read = folder_reader(root)
    for file in files:
        for found in marked(file, read(file) or ""):
            try:
                yield parse(found)
            except ExpectationError as error:
                problems.append(f"{root / file}{str(error).removeprefix(file)}")
