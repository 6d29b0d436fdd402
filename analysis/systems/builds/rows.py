"""What the builds of packages come to, as rows of `rules/schema/build.dl`: of the files and programs that launch files name."""

from __future__ import annotations

import os
import re
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rosarch.analysis.systems.builds.defects import defects
from rosarch.analysis.systems.builds.uses import uses
from rosarch.base.files import path_text, read_file
from rosarch.extractor.launch.facts import path_below
from rosarch.extractor.launch.model import ComponentNamed, Composition, FileMeant, ProgramNamed
from rosarch.extractor.workspace.built import INSTALLED_FIRST, Built, package_of

_Rows = dict[str, set[tuple[Any, ...]]]
_BESIDE = re.compile(r"__file__|\$\(dirname\)|ThisLaunchFile")


def build_rows(composition: Composition, builds: Sequence[Built], root: Path) -> _Rows:
    """The rows about one composition."""
    rows: _Rows = defaultdict(set)
    top = os.path.abspath(root)
    for package in builds:
        _plugins(rows, top, package)
        _uses(rows, top, package)
    for name, defect in defects(composition, builds):
        rows["build_defect"].add((_place(rows, top, defect.path, defect.line), name, defect.kind, defect.about))
    for named in composition.references:
        if isinstance(named, ProgramNamed):
            for package in (one for one in builds if one.name == named.package):
                _plain(rows, top, named.type, package)
    if composition.ros == 2:
        told = [one for one in builds if one.build_type in INSTALLED_FIRST]
        for named in composition.references:
            if isinstance(named, FileMeant) and (holder := package_of(named.file, told)) is not None:
                if not _is_beside(named, holder):
                    _file(rows, top, named.file, holder)
            elif isinstance(named, ProgramNamed):
                for package in (one for one in told if one.name == named.package):
                    _program(rows, top, named.type, package)
                    _entry_points(rows, top, package)
            elif isinstance(named, ComponentNamed):
                for package in (one for one in told if one.name == named.package):
                    _components(rows, top, package)
    return rows


def _plugins(rows: _Rows, root: str, package: Built) -> None:
    for one in package.described:
        for name in one.names:
            if one.exported:
                rows["plugin_exported"].add((_place(rows, root, one.path, one.line), package.name, name))
                where = _place(rows, root, one.manifest, one.manifest_line)
                rows["plugin_exported_for"].update((where, package.name, host, name) for host in one.hosts)
            else:
                place = _place(rows, root, one.manifest, one.manifest_line)
                rows["plugin_left_out"].add((place, package.name, path_text(one.path.relative_to(package.folder)), name))
    _components(rows, root, package)
    if package.exports_more:
        rows["descriptions_open"].add((package.name,))


def _uses(rows: _Rows, root: str, package: Built) -> None:
    """What the build uses and is not given by itself, with all that it is given there."""
    found = uses(package)
    lines = {target: (path, line) for target, path, line in found.given_at}
    lacks = [("header", one.target, one) for one in found.includes if (one.target, one.used) not in found.given]
    lacks += [("package", "", one) for one in found.asks if one.used not in found.finds]
    lacks += [("interface", "", one) for one in found.interfaces if one.used not in found.interfaces_given]
    for kind, target, one in lacks:
        use = _place(rows, root, one.path, one.line)
        place = _place(rows, root, *lines[target]) if target else use
        rows["build_lack"].add((place, package.name, kind, target, one.used, use))
        given = found.finds if kind == "package" else found.interfaces_given if kind == "interface" else ()
        rows["build_given"].update((package.name, kind, target, name) for name in given)
        rows["build_given"].update((package.name, kind, target, name) for owner, name in found.given if owner == target)


def _components(rows: _Rows, root: str, package: Built) -> None:
    for one in package.promised:
        place = _place(rows, root, one.path, one.line)
        if one.written:
            rows["library_misnamed"].add((place, package.name, one.written, one.library, one.name))
        else:
            rows["component_promised"].add((place, package.name, one.library, one.name))
        rows["plugin_base_described"].add((place, package.name, one.library, one.name, one.base))
        rows["plugin_base_registered"].update((package.name, one.library, one.name, base) for base in one.bases)
        rows["class_registered"].update((package.name, one.library, name) for name in one.registered)
        if one.open:
            rows["registering_open"].add((package.name, one.library))


def _file(rows: _Rows, root: str, file: str, package: Built) -> None:
    path = os.path.relpath(file, package.folder)
    rows["file_in_package"].add((path_below(root, file), package.name, path_text(Path(path))))
    if package.brings(f"share/{package.name}/{path}") or package.brings(path):
        rows["path_installed"].add((package.name, path))
    _tool(rows, root, package)


def _program(rows: _Rows, root: str, name: str, package: Built) -> None:
    if package.has_program(os.path.basename(name)):
        rows["program_installed"].add((package.name, name))
    for path, file, line in package.elsewhere(name):
        rows["program_installed_elsewhere"].add((_place(rows, root, file, line), package.name, name, path))
    _tool(rows, root, package)


def _plain(rows: _Rows, root: str, name: str, package: Built) -> None:
    for path, line in package.copied_plainly(name) if not package.unsure else ():
        rows["program_copied_plainly"].add((_place(rows, root, path, line), package.name, name))


def _entry_points(rows: _Rows, root: str, package: Built) -> None:
    for point in package.entry_points if package.build_type == "ament_python" else ():
        if point.is_command:
            rows["entry_point"].add((_place(rows, root, point.path, point.line), package.name, point.name, point.module, point.function))
    for lack in package.lacks:
        module, function = lack.point.module, lack.point.function
        if lack.what == "function":
            rows["entry_function_absent"].add((package.name, module, function))
        elif lack.what == "module":
            rows["entry_module_absent"].add((package.name, module))
        else:
            rows["entry_module_left_out"].add((package.name, module, lack.part))


def _place(rows: _Rows, root: str, path: Path, line: int) -> str:
    shown = path_below(root, str(path))
    place = f"{shown}:{line}:1"
    rows["place"].add((place, shown, line, 1))
    return place


def _tool(rows: _Rows, root: str, package: Built) -> None:
    rows["package_built_with"].add((package.name, package.build_type))
    for unsure in package.unsure:
        rows["installs_open"].add((package.name, unsure.reason, _place(rows, root, unsure.path, unsure.line)))


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
