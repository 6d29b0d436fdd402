"""Which classes the libraries of a package register, and which of them CMake and descriptions promise.

A library registers what the macros in its sources, and in those that it is linked with, name. Where a source may register something in
another way, nothing is said of its library.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path

from rosarch.base.files import LARGEST_PARSED, read_file
from rosarch.extractor.workspace.graph import closure
from rosarch.extractor.workspace.installs import library_path, line_with
from rosarch.extractor.workspace.model import LIBRARY_KINDS, Package, PluginClass, Target, Workspace
from rosarch.extractor.workspace.plugins import Registration, Scans, parse_plugins

COMPONENT_BASE = "rclcpp_components"


@dataclass(frozen=True)
class Promised:
    """At `line` of `path`, CMake or a description says that `library` registers `name`, of `base`; it does register `registered`.

    `bases` are those under which it registers the class. A description that calls the library otherwise than its file has `written` so.
    The library is made at `library_at`; whether it is `installed` is known in packages of which all is known.
    """

    name: str
    library: str
    path: Path
    line: int
    registered: tuple[str, ...]
    open: bool
    base: str = ""
    bases: tuple[str, ...] = ()
    written: str = ""
    library_at: tuple[Path, int] = (Path(), 0)
    installed: bool = True


def promised(workspace: Workspace, package: Package, scans: Scans) -> Iterator[Promised]:
    """The classes that CMake and exported descriptions name for libraries of the package whose sources are known."""
    registered = cache(partial(_registered, workspace, package, scans))
    exported = {path for _, path in package.plugin_exports}
    for plugin in package.plugins:
        name, target, written = plugin.name, None, ""
        if plugin.base == COMPONENT_BASE:
            target = package.target(plugin.library)
        elif plugin.declared_at in exported and not plugin.in_python:
            name, target = plugin.cxx_class.removeprefix("::"), _library_at(package, plugin.library)
            if target is None and plugin.library and not _files_at(package, plugin.library):
                target, written = _registering(package, name, registered), plugin.library
        if target is not None and target.kind in LIBRARY_KINDS:
            found, is_open = registered(target)
            names = sorted({one.cxx_class for one in found})
            bases = sorted({one.base for one in found if one.cxx_class == name})
            base = plugin.base.removeprefix("::")
            there = any(install.path == library_path(target.output_name) for install in package.installs)
            yield Promised(
                name,
                target.name,
                plugin.declared_at,
                line_with(plugin.declared_at, f'"{written}"') if written else plugin.line,
                tuple(names),
                is_open,
                base,
                tuple(bases),
                written,
                (target.cmake_file, target.line),
                there,
            )


def _registering(package: Package, name: str, registered: Callable[[Target], tuple[frozenset[Registration], bool]]) -> Target | None:
    """The one library of the package that registers a class; `registered` says what each does."""
    libraries = [target for target in package.targets if target.kind in LIBRARY_KINDS]
    found = [target for target in libraries if name in {one.cxx_class for one in registered(target)[0]}]
    return found[0] if len(found) == 1 else None


def _files_at(package: Package, path: str) -> list[Target]:
    """The targets that may be what a description calls `path`."""
    name = _file_name(path)
    return [target for target in package.targets if target.output_name.removeprefix("lib") == name.removeprefix("lib")]


def _library_at(package: Package, path: str) -> Target | None:
    """The target whose file a description calls `path`: with or without a folder, `lib` and an ending."""
    name = _file_name(path)
    names = (name, name.removeprefix("lib"))
    found = [target for target in package.targets if target.kind in LIBRARY_KINDS and target.output_name in names]
    return found[0] if len(found) == 1 else None


def _file_name(path: str) -> str:
    return re.sub(r"\.so$", "", path.rpartition("/")[2])


def _registered(workspace: Workspace, package: Package, scans: Scans, target: Target) -> tuple[frozenset[Registration], bool]:
    """What a library registers, and whether it may be more."""
    targets = (target, *closure(workspace, target))
    sources = [source for one in targets for source in one.sources]
    folders = (*target.include_dirs, package.path / "include")
    files = dict.fromkeys((*sources, *(file for source in sources for file in scans.own_headers(source, folders, package.path))))
    found = [scans.of(file) for file in files]
    names = frozenset(one for scan in found for one in scan.registrations)
    return names, not target.sources or any(scan.may_be_more for scan in found) or any(_is_unknown(workspace, one) for one in targets)


def _is_unknown(workspace: Workspace, target: Target) -> bool:
    """Whether a target has sources that are not there."""
    return any(d.kind == "missing-source" and d.message.startswith(f"source of {target.name} ") for d in workspace.diagnostics)


@dataclass(frozen=True)
class Described:
    """A plug-in that a description calls `names`; at `manifest_line` of `manifest` its package exports the description, or would.

    It exports it for the packages `hosts`.
    """

    names: tuple[str, ...]
    path: Path
    line: int
    exported: bool
    manifest: Path
    manifest_line: int
    hosts: tuple[str, ...] = ()


def described(package: Package) -> Iterator[Described]:
    """The plug-ins that the descriptions in a package name: those that it exports, and others that lie in it."""
    exported = {path for _, path in package.plugin_exports}
    found = [one for one in package.plugins if one.declared_at in exported]
    others = [one for path in _others(package.path) if path not in exported for one in _classes(path)]
    if found or others:
        at = package.manifest if package.build_type == "catkin" else package.path / "CMakeLists.txt"
        line = line_with(at, "<export" if package.build_type == "catkin" else "ament_package")
        for one in (*found, *others):
            hosts = tuple(dict.fromkeys(host for host, path in package.plugin_exports if path == one.declared_at))
            where = line_with(at, one.declared_at.name) if hosts else line
            yield Described((one.name, one.cxx_class), one.declared_at, one.line, one.declared_at in exported, at, where, hosts)


def exports_more(package: Package) -> bool:
    """Whether a description that a package exports is not there, or holds no plug-in that was understood."""
    return bool({path for _, path in package.plugin_exports} - {one.declared_at for one in package.plugins})


def _classes(path: Path) -> list[PluginClass]:
    try:
        text = read_file(path, LARGEST_PARSED).decode(errors="replace")
    except OSError:
        return []
    classes, problems = parse_plugins(text, path) if "<library" in text and "base_class" in text else ([], [])
    return [] if problems else classes


def _others(folder: Path) -> Iterator[Path]:
    """The XML files in a package's folder, and in those in it."""
    for here in (folder, *sorted(path for path in folder.iterdir() if os.path.isdir(path) and not path.name.startswith("."))):
        try:
            yield from sorted(
                path for path in here.iterdir() if path.suffix == ".xml" and path.name != "package.xml" and os.path.isfile(path)
            )
        except OSError:
            continue
