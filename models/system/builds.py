"""What the builds of packages come to, as rows of `rules/schema/build.dl`: of the files and programs that launch files name."""

from __future__ import annotations

import os
import re
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rosarch.extractor.files import path_text, read_file
from rosarch.extractor.launch.facts import path_below
from rosarch.extractor.launch.model import Composition, FileMeant, ProgramNamed
from rosarch.extractor.workspace.built import INSTALLED_FIRST, Built, package_of

_Rows = dict[str, set[tuple[Any, ...]]]
_BESIDE = re.compile(r"__file__|\$\(dirname\)|ThisLaunchFile")


def build_rows(composition: Composition, builds: Sequence[Built], root: Path) -> _Rows:
    """The rows about one composition."""
    rows: _Rows = defaultdict(set)
    if composition.ros == 2:
        top = os.path.abspath(root)
        told = [one for one in builds if one.build_type in INSTALLED_FIRST]
        for named in composition.references:
            if isinstance(named, FileMeant) and (package := package_of(named.file, told)) is not None:
                if not _is_beside(named, package):
                    _file(rows, top, named.file, package)
            elif isinstance(named, ProgramNamed):
                for package in (one for one in told if one.name == named.package):
                    _program(rows, top, named.type, package)
    return rows


def _file(rows: _Rows, root: str, file: str, package: Built) -> None:
    path = os.path.relpath(file, package.folder)
    rows["file_in_package"].add((path_below(root, file), package.name, path_text(Path(path))))
    if package.brings(f"share/{package.name}/{path}") or package.brings(path):
        rows["path_installed"].add((package.name, path))
    _tool(rows, root, package)


def _program(rows: _Rows, root: str, name: str, package: Built) -> None:
    if os.path.basename(name) in package.programs:
        rows["program_installed"].add((package.name, name))
    _tool(rows, root, package)


def _tool(rows: _Rows, root: str, package: Built) -> None:
    rows["package_built_with"].add((package.name, package.build_type))
    for unsure in package.unsure:
        path = path_below(root, str(unsure.path))
        place = f"{path}:{unsure.line}:1"
        rows["place"].add((place, path, unsure.line, 1))
        rows["installs_open"].add((package.name, unsure.reason, place))


def _is_beside(named: FileMeant, package: Built) -> bool:
    """Whether a file may be found from where the launch file lies, which need not be where its package has it once it is installed."""
    try:
        text = read_file(named.place.path).decode(errors="replace")
    except OSError:
        return True
    if not _BESIDE.search(text):
        return False
    path = os.path.relpath(named.place.path, package.folder)
    return "realpath" in text or ".resolve(" in text or not package.brings(f"share/{package.name}/{path}")
