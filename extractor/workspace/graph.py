"""Questions across targets: what a target is linked from, where it finds headers."""

from __future__ import annotations

import re
from pathlib import Path
from weakref import WeakKeyDictionary

from rosarch.extractor.declared import IN_CXX
from rosarch.extractor.workspace.model import LIBRARY_KINDS, Package, Target, Workspace


def is_brought(package: Package) -> bool:
    """Whether rosarch brings the declarations of a package, and knows what it does: as it is for the ROS that this one is for."""
    return (package.name, package.middleware) in IN_CXX


class _Index:
    """Look-up tables of one workspace."""

    def __init__(self, workspace: Workspace) -> None:
        self.packages = {package.name: package for package in workspace.packages}
        self.targets: dict[tuple[str, str], Target] = {}
        self.libraries: dict[str, list[Target]] = {}
        for package in workspace.packages:
            for target in package.targets:
                self.targets[package.name, target.name] = target
                if target.kind in LIBRARY_KINDS:
                    for name in dict.fromkeys((target.name, target.output_name)):
                        self.libraries.setdefault(name, []).append(target)
            for alias, name in package.aliases:
                if (package.name, name) in self.targets:
                    self.targets[package.name, alias] = self.targets[package.name, name]
                    self.libraries.setdefault(alias, []).append(self.targets[package.name, name])
        self.brought = frozenset(package.name for package in workspace.packages if is_brought(package))
        self.reach: dict[str, tuple[str, ...]] = {}

    def reachable(self, package: str) -> tuple[str, ...]:
        """A package and all it depends on, nearest first."""
        if package not in self.reach:
            order, queue = dict.fromkeys([package]), [package]
            while queue:
                here = self.packages.get(queue.pop(0))
                for name in (*here.depends, *here.exports.depends) if here else ():
                    if name in self.packages and name not in order:
                        order[name] = None
                        queue.append(name)
            self.reach[package] = tuple(order)
        return self.reach[package]

    def library(self, link: str, package: str) -> Target | None:
        """The workspace library a link item means, seen from a package: its own first, then its dependencies', then any."""
        own = self.targets.get((package, link))
        if own is not None and own.kind in LIBRARY_KINDS:
            return own
        prefix, colons, _name = link.rpartition("::")
        if colons and prefix not in self.packages and link not in self.libraries:
            return None
        for name in _library_names(link):
            candidates = self.libraries.get(name)
            if candidates:
                order = self.reachable(package)
                return min(candidates, key=lambda t: order.index(t.package) if t.package in order else len(order))
        return None


_FILE = re.compile(r"(?:.*/)?(?:lib)?([^/]+?)(?:\.so(?:\.[\d.]+)?|\.a)$")


def _library_names(link: str) -> list[str]:
    """The target or output names that `link` may stand for: a name, `-lname`, `libname.so`, `pkg::name`."""
    names = [link]
    if link.startswith("-l"):
        names.append(link[2:])
    if match := _FILE.match(link):
        names += [match.group(1), "lib" + match.group(1)]
    if "::" in link:
        names.append(link.rpartition("::")[2])
    return names


_INDEXES: WeakKeyDictionary[Workspace, _Index] = WeakKeyDictionary()


def index(workspace: Workspace) -> _Index:
    """The look-up tables of a workspace, made once."""
    found = _INDEXES.get(workspace)
    if found is None:
        found = _INDEXES[workspace] = _Index(workspace)
    return found


def find_library(workspace: Workspace, link: str, package: str) -> Target | None:
    """The workspace library that a link item or a plug-in's library path means, seen from `package`."""
    return index(workspace).library(link, package)


def closure(workspace: Workspace, target: Target) -> tuple[Target, ...]:
    """The workspace libraries a target is made of, transitively, in the order they are linked; without the target itself.

    Libraries of packages whose declarations rosarch brings count as installed.
    """
    tables = index(workspace)
    result: dict[tuple[str, str], Target] = {}
    stack = [target]
    while stack:
        here = stack.pop()
        nexts: list[Target] = []
        for link in (*here.objects, *here.links):
            library = tables.library(link, here.package)
            if library is None or library is target or library.package in tables.brought or (library.package, library.name) in result:
                continue
            result[library.package, library.name] = library
            nexts.append(library)
        stack.extend(reversed(nexts))
    return tuple(result.values())


def include_path(workspace: Workspace, target: Target) -> tuple[Path, ...]:
    """Include folders in the order of the compiler's command line.

    First the target's own (with `catkin_INCLUDE_DIRS` and the like expanded), then those its libraries pass on, last the exported
    folders of all packages the manifest depends on: a package that forgets them in CMake compiles in a merged devel space. Those of
    packages whose declarations rosarch brings are left out.
    """
    tables = index(workspace)
    brought = [tables.packages[name].path / "include" for name in sorted(tables.brought)]
    result = dict.fromkeys(folder for folder in target.include_dirs if not any(folder.is_relative_to(path) for path in brought))
    for library in closure(workspace, target):
        result.update(dict.fromkeys(library.interface_include_dirs))
    for name in tables.reachable(target.package):
        package: Package | None = tables.packages.get(name)
        if package is not None and name not in tables.brought:
            result.update(dict.fromkeys(package.exports.include_dirs))
    return tuple(result)


def definitions(workspace: Workspace, target: Target) -> tuple[str, ...]:
    """Preprocessor definitions of a target and those its libraries pass on."""
    result = dict.fromkeys(target.definitions)
    for library in closure(workspace, target):
        result.update(dict.fromkeys(library.interface_definitions))
    return tuple(result)
