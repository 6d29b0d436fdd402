"""Python nodes of a workspace: those that are installed, that rosrun finds in a package, or that are started by hand; plug-ins.

A file is a node's when it, or a module of the workspace that it imports, imports a client library of ROS.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic
from rosarch.base.files import file_name, read_file, text_or_nothing
from rosarch.extractor.workspace.model import PYTHON_NODE, Component, Package, PluginClass, PythonEntry, Workspace
from rosarch.extractor.workspace.python_modules import Modules
from rosarch.extractor.workspace.python_plugins import declared_classes, described_classes, pointed_at
from rosarch.extractor.workspace.unused import unused_sources

CLIENT_LIBRARIES = frozenset({"rospy", "rclpy"})
_SHEBANG = re.compile(rb"#![^\n]*\bpython")
_BEGINS = re.compile(r"\b(?:rospy\.init_node|rclpy\.init)\s*\(")
_Roots = Mapping[str, tuple[Path, ...]]
"""The folders that modules of a package are imported from: its own, then those of others."""
_NO_SCRIPTS = frozenset({"test", "tests", "launch", "cfg", "build", "devel", "install", "site-packages", "__pycache__"})


def python_nodes(workspace: Workspace, problems: list[Diagnostic]) -> Iterator[Component]:
    """The Python nodes of the selected packages. `problems` lists entry points without a module."""
    modules = Modules(workspace.underlay)
    shared = [root for package in workspace.packages for root in _roots(package)]
    roots = {
        one.name: tuple(dict.fromkeys((*_roots(one), *shared, *_above(one, workspace.root))))
        for one in workspace.packages
        if one.name in workspace.selected
    }
    found = list(_installed_or_found(workspace, roots, modules, problems))
    yield from found
    if workspace.searched:
        yield from _started_by_hand(workspace, roots, modules, {path for one in found for path in (*one.sources, *one.library_sources)})


def _installed_or_found(workspace: Workspace, found_in: _Roots, modules: Modules, problems: list[Diagnostic]) -> Iterator[Component]:
    named = [plugin for package in workspace.packages for plugin in (*declared_classes(package), *described_classes(package))]
    for package in workspace.packages:
        if package.name in workspace.selected:
            roots = found_in[package.name]
            yield from _of_entry_points(package, roots, modules, problems)
            yield from _of_scripts(package, roots, modules, searched=workspace.searched)
            yield from _of_plugins(package, roots, named, modules)
            yield from _of_plugins(package, roots, pointed_at(package), modules, only_ros=True)


def _roots(package: Package) -> tuple[Path, ...]:
    """The folders that modules of a package are imported from: a description of plug-ins says where theirs are."""
    if package.installed:
        return ()  # its modules lie elsewhere
    below = (package.path / plugin.library for plugin in package.plugins if plugin.in_python)
    told = tuple(dict.fromkeys((*package.python_roots, *(path for path in below if os.path.isdir(path)))))
    return told if told or not package.build_type.startswith("ament") else (package.path,)


def _above(package: Package, workspace: Path) -> Iterator[Path]:
    """The folders of the workspace around a package: what is imported and is in no package, PYTHONPATH finds there."""
    return (folder for folder in package.path.parents if folder.is_relative_to(workspace))


def _of_entry_points(package: Package, roots: tuple[Path, ...], modules: Modules, problems: list[Diagnostic]) -> Iterator[Component]:
    for point in filter(lambda point: point.is_command, package.entry_points):
        file = modules.find(point.module, roots)
        if file is None:
            message = f"entry point {point.name}: no module {point.module} in the package"
            problems.append(Diagnostic("missing-source", point.path, point.line, 1, message))
            continue
        start = PythonEntry(file, point.module, point.function, roots)
        yield from _node(package, point.name, [point.name], start, modules)


def _of_scripts(package: Package, roots: tuple[Path, ...], modules: Modules, *, searched: bool) -> Iterator[Component]:
    """Installed scripts, and where nothing need be installed to be run, those that lie in the package."""
    scripts = {program.path: program.name for program in package.programs if program.path.suffix == ".py" or _has_shebang(program.path)}
    if searched and package.build_type == "catkin" and not package.installed:
        scripts = {path: path.name for path in _scripts_below(package.path)} | scripts
    names: dict[Path, list[str]] = {}
    for path in sorted(scripts, key=lambda path: (path.is_symlink(), path)):
        names.setdefault(path.resolve(), []).append(scripts[path])
    for path, executables in names.items():
        if modules.does_something(path):
            start = PythonEntry(path, "__main__", None, (path.parent, *roots))
            yield from _node(package, executables[0].removesuffix(".py"), executables, start, modules)


def _started_by_hand(workspace: Workspace, roots: _Roots, modules: Modules, used: set[Path]) -> Iterator[Component]:
    """Files that begin a node and are in no other component: `python file.py` runs them, and nothing else does."""
    packages = [package for package in workspace.packages if package.name in workspace.selected and not package.installed]
    for package in sorted(packages, key=lambda package: package.path, reverse=True):  # inner ones first
        for path in filter(_begins_node, unused_sources([package.path], used, (".py",))):
            used.add(path.resolve())
            start = PythonEntry(path, "__main__", None, (path.parent, *roots[package.name]))
            yield from _node(package, path.stem, (), start, modules)


def _begins_node(path: Path) -> bool:
    return _BEGINS.search(text_or_nothing(path)) is not None


def _of_plugins(
    package: Package, roots: tuple[Path, ...], named: Iterable[PluginClass], modules: Modules, *, only_ros: bool = False
) -> Iterator[Component]:
    """The classes of the package that others make by their name; each once, wherever it is named."""
    seen: set[tuple[str, str]] = set()
    for plugin in named:
        module, _, name = plugin.cxx_class.rpartition(".")
        file = modules.find(module, roots)
        if file is None or not file.is_relative_to(package.path) or (module, name) in seen:
            continue
        seen.add((module, name))
        start = PythonEntry(file, module, name, roots)
        if only_ros and not _uses_ros(start, modules):
            continue
        component = component_of(package, name, (), start, modules)
        yield replace(component, kind="plugin", entry_class=f"{module}::{name}", base_class=plugin.base or None, plugin_name=plugin.name)


def _scripts_below(folder: Path) -> Iterator[Path]:
    """Files with Python's first line, folders of tests and the like left out."""
    for here, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name not in _NO_SCRIPTS)
        for name in sorted(names):
            path = Path(here, name)
            if (name.endswith(".py") or "." not in name) and _has_shebang(path) and name != "setup.py":
                yield path


def _has_shebang(path: Path) -> bool:
    try:
        return _SHEBANG.match(read_file(path)) is not None
    except OSError:
        return False  # no script that could be read


def _node(package: Package, name: str, executables: Iterable[str], start: PythonEntry, modules: Modules) -> Iterator[Component]:
    """The node that a file is; none when neither it nor what it imports uses ROS."""
    if _uses_ros(start, modules):
        yield component_of(package, name, executables, start, modules)


def _uses_ros(start: PythonEntry, modules: Modules) -> bool:
    _, packages = modules.closure(start.file, start.module, start.roots)
    return not packages.isdisjoint(CLIENT_LIBRARIES)


def component_of(package: Package, name: str, executables: Iterable[str], start: PythonEntry, modules: Modules) -> Component:
    """The component of a package that a file begins, with all that it imports."""
    imported, _ = modules.closure(start.file, start.module, start.roots)
    sources = tuple(dict.fromkeys(path for _, path in imported))
    own = tuple(path for path in sources if path == start.file or path.is_relative_to(package.path))
    return Component(
        name=file_name(name),
        package=package.name,
        kind=PYTHON_NODE,
        target=None,
        libraries=(),
        sources=own,
        library_sources=tuple(path for path in sources if path not in own),
        executables=tuple(executables),
        python=replace(start, modules=imported),
    )
