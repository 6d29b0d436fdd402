"""What a workspace can run: node executables, nodelets, rclcpp components, other plug-in classes, Python nodes."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from itertools import count
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic
from rosarch.base.files import file_name
from rosarch.extractor.workspace.graph import closure, definitions, find_library, include_path
from rosarch.extractor.workspace.libraries import library_modules, library_targets
from rosarch.extractor.workspace.model import EXECUTABLE, LIBRARY, LIBRARY_KINDS, TEST, Component, Package, PluginClass, Target, Workspace
from rosarch.extractor.workspace.plugins import Registration, Scans
from rosarch.extractor.workspace.python_modules import Modules
from rosarch.extractor.workspace.python_nodes import component_of, python_nodes
from rosarch.extractor.workspace.unused import unused_components

NODELET_BASE = "nodelet::Nodelet"
COMPONENT_BASE = "rclcpp_components"
SIMULATOR_PLUGIN = "gazebo_plugin"


def without_library(workspace: Workspace, scans: Scans | None = None) -> tuple[Diagnostic, ...]:
    """Plug-in descriptions of the selected packages whose library no target builds: such components have no sources."""
    return tuple(
        Diagnostic(
            "plugin", plugin.declared_at, plugin.line, 1, f"no target builds {plugin.library or 'the library'} of {plugin.cxx_class}"
        )
        for package in workspace.packages
        if package.name in workspace.selected and not package.installed
        for registered in [_registrations(package, scans or Scans())]
        for plugin in package.plugins
        if not plugin.in_python and plugin.cxx_class not in registered and _library(workspace, plugin, package) is None
    )


def programs(workspace: Workspace) -> frozenset[tuple[str, str]]:
    """Package and name of each program that is built or installed, tests too."""
    return frozenset(
        (package.name, name)
        for package in workspace.packages
        for name in (
            *(target.output_name for target in package.targets if target.kind in (EXECUTABLE, TEST)),
            *(program.name for program in package.programs),
            *(point.name for point in package.entry_points if point.is_command),
        )
    )


def registered(workspace: Workspace) -> frozenset[tuple[str, str]]:
    """Package and name of each class that a library registers as a component."""
    found = ((package, plugin) for package in workspace.packages for plugin in package.plugins)
    return frozenset((package.name, plugin.name) for package, plugin in found if plugin.base == COMPONENT_BASE)


def components(
    workspace: Workspace, problems: list[Diagnostic] | None = None, *, unused: bool = False, scans: Scans | None = None
) -> tuple[Component, ...]:
    """The components of the selected packages, by package, kind and name; of installed ones those in Python. Tests are none.

    With `unused`, sources that belong to none of them are components, too.

    No two components of a package have one name: of equal ones, all but the first get a number. `problems` lists these.
    """
    result: list[Component] = []
    scans = scans or Scans()
    for package in workspace.packages:
        if package.name in workspace.selected and not package.installed:
            result.extend(_nodes(workspace, package))
            result.extend(_plugins(workspace, package, scans))
    problems = [] if problems is None else problems
    result.extend(python_nodes(workspace, problems))
    if workspace.is_whole:  # else something else may run them
        result.extend(_libraries(workspace, result, scans))
    if unused:
        result.extend(unused_components(workspace, result))
    result.sort(key=lambda c: (c.package, c.kind, c.name, c.plugin_name or ""))
    return tuple(_distinct(workspace, result, problems))


def _distinct(workspace: Workspace, found: list[Component], problems: list[Diagnostic]) -> Iterable[Component]:
    """The components, each under a name of its own."""
    taken = {(component.package, component.name) for component in found}
    seen: set[tuple[str, str]] = set()
    for component in found:
        key = (component.package, component.name)
        if key in seen:
            name = next(name for number in count(2) if (component.package, name := f"{component.name}_{number}") not in taken)
            taken.add((component.package, name))
            target, package = component.target, workspace.package(component.package)
            path, line = (target.cmake_file, target.line) if target else (package.manifest if package else workspace.root, 1)
            what = component.entry_class or (f"target {target.name}" if target else component.kind)
            message = f"{component.package} has another component {component.name}; that of {what} is called {name}"
            problems.append(Diagnostic("duplicate-component", path, line, 1, message))
            component = replace(component, name=name)
        seen.add(key)
        yield component


def _nodes(workspace: Workspace, package: Package) -> Iterable[Component]:
    of_class = {plugin.executable for plugin in package.plugins}
    for target in package.targets:
        if target.kind == EXECUTABLE and target.name not in of_class:
            yield _component(workspace, package, target.output_name, "node", target)


def _libraries(workspace: Workspace, found: Iterable[Component], scans: Scans) -> list[Component]:
    """The libraries that are in none of the components that were `found`."""
    used = {source for component in found for source in (*component.sources, *component.library_sources)}
    modules = Modules()
    made: list[Component] = []
    for package in workspace.packages:
        targets = library_targets(package, used, scans)
        made.extend(_component(workspace, package, target.output_name, LIBRARY, target) for target in targets)
        entries = library_modules(package, used, modules)
        made.extend(replace(component_of(package, entry.module, (), entry, modules), kind=LIBRARY) for entry in entries)
    return made


def _component(workspace: Workspace, package: Package, name: str, kind: str, target: Target | None) -> Component:
    libraries = closure(workspace, target) if target else ()
    own = set(target.sources) if target else set()
    return Component(
        name=file_name(name),
        package=package.name,
        kind=kind,
        target=target,
        libraries=libraries,
        sources=target.sources if target else (),
        library_sources=_sources(libraries, own),
        definitions=definitions(workspace, target) if target else (),
        include_dirs=include_path(workspace, target) if target else (),
    )


def _sources(libraries: Iterable[Target], own: set[Path]) -> tuple[Path, ...]:
    found = dict.fromkeys(source for library in libraries for source in library.sources)
    return tuple(source for source in found if source not in own)


def _plugins(workspace: Workspace, package: Package, scans: Scans) -> Iterable[Component]:
    """Classes of the description files, completed by the registration macros; then registered classes no file describes."""
    registered = _registrations(package, scans)
    described: set[str] = set()
    for plugin in package.plugins:
        if plugin.in_python or plugin.cxx_class in described:
            continue
        described.add(plugin.cxx_class)
        target, found = registered.get(plugin.cxx_class, (None, None))
        if target is None:
            target = _library(workspace, plugin, package)
        base = plugin.base or (found.base if found else "")
        yield _plugin(workspace, package, plugin.cxx_class, base, plugin.name, target, plugin.executable)
    for name, (target, found) in registered.items():
        if name not in described:
            loaded_as = f"lib{target.output_name}.so" if found.simulated else found.name
            made = _plugin(workspace, package, name, found.base, loaded_as, target)
            yield replace(made, kind=SIMULATOR_PLUGIN) if found.simulated else made


def _plugin(
    workspace: Workspace, package: Package, cxx: str, base: str, name: str | None, target: Target | None, executable: str = ""
) -> Component:
    plain_base = base.removeprefix("::")
    kind = {NODELET_BASE: "nodelet", "Nodelet": "nodelet", COMPONENT_BASE: "component"}.get(plain_base, "plugin")
    short = re.sub(r"^(?:\w*::)+", "", cxx)  # its template arguments keep their namespaces
    component = _component(workspace, package, executable or short, kind, target)
    return replace(component, entry_class=cxx, base_class=plain_base or None, plugin_name=name)


def _registrations(package: Package, scans: Scans) -> dict[str, tuple[Target, Registration]]:
    """Registered class to the library that registers it."""
    result: dict[str, tuple[Target, Registration]] = {}
    for target in package.targets:
        if target.kind in LIBRARY_KINDS:
            for source in target.sources:
                headers = scans.own_headers(source, (*target.include_dirs, package.path / "include"), package.path)
                for found in (found for file in (source, *headers) for found in scans.of(file).registrations):
                    result.setdefault(found.cxx_class, (target, found))
    return result


def _library(workspace: Workspace, plugin: PluginClass, package: Package) -> Target | None:
    """The library at a description's path: `lib/libfoo` is the target or output name `foo` or `libfoo`."""
    base = plugin.library.rpartition("/")[2]
    for name in (base.removeprefix("lib"), base):
        for candidate in (name, f"{name}.so"):
            found = find_library(workspace, candidate, package.name) if name else None
            if found is not None:
                return found
    return None
