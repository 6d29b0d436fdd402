"""Sources that use ROS and belong to no component: no target builds them, nothing installs or imports them."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from pathlib import Path

from rosarch.base.files import file_name, read_file
from rosarch.extractor.package_names import IGNORE_MARKERS
from rosarch.extractor.workspace.loose import loose_name
from rosarch.extractor.workspace.model import EXECUTABLE, UNUSED, Component, Package, PythonEntry, Target, Workspace
from rosarch.extractor.workspace.plugins import included_names
from rosarch.extractor.workspace.python_modules import Modules

_USES_ROS = re.compile(
    rb"^[ \t]*(?:#[ \t]*include[ \t]*[<\"](?:ros/ros\.h|rclcpp\w*/)|(?:import|from)[ \t]+(?:rospy|rclpy)\b)", re.MULTILINE
)
_SUFFIXES = (".cpp", ".cc", ".cxx", ".py")
_HEADERS = (".h", ".hh", ".hpp")
_APART = frozenset({"test", "tests", "launch", "doc", "docs", "build", "devel", "install", "site-packages", "__pycache__"})


def unused_sources(
    packages: Iterable[Path], used: Collection[Path], suffixes: tuple[str, ...] = _SUFFIXES, *, ignored: bool = False
) -> list[Path]:
    """The sources below the folders of `packages` that use ROS and are not `used`; tests and launch files left out.

    Folders that ignore markers hide from the build are left out, too, unless the `ignored` are asked for.
    """
    found = {path.resolve() for path in used}
    result: set[Path] = set()
    for package in packages:
        headers = {path.name: path for path in _sources(package, _HEADERS, ignored)}
        sources = _sources(package, suffixes, ignored)
        result.update(path for path in sources if path.resolve() not in found and _uses_ros_itself(path, headers))
    return sorted(result)


def _uses_ros_itself(path: Path, headers: Mapping[str, Path]) -> bool:
    """Whether a source names a client library of ROS, or one of the `headers` that it includes does."""
    if uses_ros(path) or path.suffix == ".py":
        return uses_ros(path)
    return any(name in headers and uses_ros(headers[name]) for name in included_names(path))


def unused_components(workspace: Workspace, found: Iterable[Component]) -> list[Component]:
    """Each source that is in none of the components that were `found`, modules together with what imports them; ignored packages, too."""
    used = {path for component in found for path in (*component.sources, *component.library_sources)}
    selected = [package for package in workspace.packages if package.name in workspace.selected and not package.installed]
    folders = [workspace.root] if workspace.is_whole else [package.path for package in selected]
    inner_first = sorted(selected, key=lambda package: package.path, reverse=True)
    modules = Modules()
    made = [_component(workspace.root, path, _owner(path, inner_first), modules) for path in unused_sources(folders, used, ignored=True)]
    kept: list[Component] = []
    told: set[Path] = set()
    for component in sorted(made, key=lambda component: -len(component.library_sources)):  # those that import each other have equally many
        if told.isdisjoint(component.sources):
            told.update(component.sources, component.library_sources)
            kept.append(component)
    return kept


def _owner(path: Path, packages: Iterable[Package]) -> Package | None:
    return next((package for package in packages if path.is_relative_to(package.path)), None)


def _component(root: Path, source: Path, package: Package | None, modules: Modules) -> Component:
    """A source as a component; one that is in no package is a package of its own."""
    name = loose_name(package.path if package else root, source)
    owner = package.name if package else name
    if source.suffix == ".py":
        roots = (source.parent, *(package.python_roots if package else ()))
        start = PythonEntry(source, _module(source, roots[1:]), None, roots)
        imported, _ = modules.closure(start.file, start.module, roots)
        others = tuple(path for _, path in imported if path != source)
        start = PythonEntry(source, start.module, None, roots, imported)
        return Component(file_name(name), owner, UNUSED, None, (), (source,), others, python=start)
    folders = {folder: None for target in (package.targets if package else ()) for folder in target.include_dirs}
    if package:
        folders[package.path / "include"] = None
    target = Target(source.stem, source.stem, EXECUTABLE, owner, source, 1, sources=(source,))
    return Component(file_name(name), owner, UNUSED, target, (), (source,), (), include_dirs=tuple(folders))


def _module(source: Path, roots: Iterable[Path]) -> str:
    """What a module below the roots of its package is called; else it is a file that is run."""
    root = next((root for root in roots if source.is_relative_to(root)), None)
    return ".".join(source.relative_to(root).with_suffix("").parts) if root else "__main__"


def _sources(package: Path, suffixes: tuple[str, ...], ignored: bool) -> Iterator[Path]:
    for here, folders, names in os.walk(package):
        if not (ignored or IGNORE_MARKERS.isdisjoint(names)):
            folders.clear()
            continue
        folders[:] = [name for name in folders if name not in _APART and not name.startswith(".")]
        yield from (
            Path(here, name) for name in names if name.endswith(suffixes) and name != "setup.py" and not name.endswith(".launch.py")
        )


def uses_ros(path: Path) -> bool:
    """Whether a source or header names a client library of ROS."""
    try:
        return _USES_ROS.search(read_file(path)) is not None
    except OSError:
        return False
