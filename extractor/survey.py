"""A workspace before its sources are parsed: its components, the units that these are made from, what its packages come to."""

from __future__ import annotations

import os
from collections.abc import Collection
from contextlib import nullcontext
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from rosarch.base import tracing
from rosarch.base.boundary import confined, ros_package_path
from rosarch.base.memo import Memo
from rosarch.extractor.cxx.translation_unit import CompileUnit
from rosarch.extractor.messages import Interfaces
from rosarch.extractor.settings import DEFAULT, Settings
from rosarch.extractor.sources import Unit
from rosarch.extractor.workspace import (
    Component,
    Diagnostic,
    Workspace,
    components,
    discover,
    include_path,
    programs,
    registered,
    without_library,
)
from rosarch.extractor.workspace.built import Built, builds
from rosarch.extractor.workspace.compile_commands import CompileCommands, read_compile_commands
from rosarch.extractor.workspace.loose import is_ros2
from rosarch.extractor.workspace.model import ROS1, ROS2
from rosarch.extractor.workspace.plugins import Scans


@dataclass(frozen=True)
class Survey:
    """A workspace without the syntax of its sources: what its packages declare and what may run.

    `components` are those of the selected packages, `built` the programs that targets build, `builds` what packages come to. `rests_on`
    has what packages and interfaces rest on, when that was recorded; surveys of one folder differ in what was `asked`.
    """

    workspace: Workspace
    interfaces: Interfaces
    components: tuple[Component, ...]
    built: frozenset[tuple[str, str]]
    builds: tuple[Built, ...]
    commands: CompileCommands
    diagnostics: tuple[Diagnostic, ...]
    rests_on: tracing.Recording | None = None
    asked: tuple[str, ...] = ()

    @classmethod
    def of(cls, workspace: Workspace, interfaces: Interfaces | None = None, *, unused: bool = False) -> Survey:
        """The survey of a workspace. With `unused`, sources that belong to nothing are components, too."""
        interfaces = interfaces or Interfaces.of(workspace.packages, workspace.root)
        told = (*workspace.diagnostics, *interfaces.diagnostics)
        noticed = [one for one in told if not workspace.underlay.is_of_library(str(one.path))]
        scans = Scans()
        found = components(workspace, noticed, unused=unused, scans=scans)
        commands = read_compile_commands(workspace.root)
        noticed += (*commands.diagnostics, *without_library(workspace, scans))
        return cls(workspace, interfaces, found, programs(workspace), builds(workspace, scans), commands, tuple(noticed))

    @property
    def programs(self) -> frozenset[tuple[str, str]]:
        """Package and name of all executables that targets build, and of the components that libraries register."""
        return self.built | registered(self.workspace)

    def units(self, component: Component) -> list[Unit]:
        """What is read for a component: the sources of its targets, or the file in Python that begins it."""
        return [component.python] if component.python else [*compile_units(self.workspace, component, self.commands)]


def survey(root: Path, packages: Collection[str] | None = None, settings: Settings = DEFAULT) -> Survey:
    """The survey of `packages` (all by default) below `root`; with a cache, packages are as they were if nothing has changed."""
    top, cache = os.path.abspath(root), settings.cache
    asked = (repr(packages and sorted(packages)), *settings.key())
    find = partial(discover, root, packages, defines=settings.defines, timeout=settings.timeout, underlay=settings.underlay)
    with confined([root, *ros_package_path(), *settings.underlay.folders]):
        with tracing.recording(tracing.Present({}).trees([top])) if cache else nullcontext() as rests_on:
            workspace = Memo(cache).recall(["workspace", top, *asked], (top,), find) if cache else find()
            interfaces = Interfaces.of(workspace.packages, workspace.root)
        return replace(Survey.of(workspace, interfaces, unused=settings.whole), rests_on=rests_on, asked=asked)


def compile_units(workspace: Workspace, component: Component, commands: CompileCommands) -> list[CompileUnit]:
    """The sources of a component, those of a library as the library's own target compiles them."""
    target = component.target.name if component.target else component.name
    middleware = {package.name: package.middleware for package in workspace.packages}
    used = middleware.get(component.package) or (ROS2 if any(map(is_ros2, component.sources)) else ROS1)  # one of no package
    own = [_unit(source, target, component.include_dirs, component.definitions, commands, used) for source in component.sources]
    wanted = set(component.library_sources)
    linked = [
        _unit(source, library.name, include_path(workspace, library), library.definitions, commands, middleware.get(library.package, ROS1))
        for library in component.libraries
        for source in library.sources
        if source in wanted
    ]
    return list(dict.fromkeys([*own, *linked]))


def _unit(
    source: Path, target: str, include_dirs: tuple[Path, ...], definitions: tuple[str, ...], commands: CompileCommands, middleware: str
) -> CompileUnit:
    """How a target compiles a source: as a build did it when there was one, else as its CMake files say."""
    command = commands.find(source, target)
    if command is None:
        return CompileUnit(source, include_dirs, definitions, middleware=middleware)
    folders = tuple(dict.fromkeys((*command.include_dirs, *include_dirs)))
    return CompileUnit(source, folders, command.definitions, command.installed, middleware)
