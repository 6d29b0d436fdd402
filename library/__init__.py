"""Interfaces of common nodes, nodelets and plug-ins whose source is not available."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.library.layers import merged
from rosarch.library.model import LibraryComponent, LibraryParameter, LibraryPort
from rosarch.library.reading import SHARE, library_files, read_folder

if TYPE_CHECKING:
    from rosarch.base.diagnostics import Diagnostic

__all__ = ["Library", "LibraryComponent", "LibraryParameter", "LibraryPort", "components", "find", "load"]

_SHIPPED = Path(__file__).parent
_SYSTEMS = _SHIPPED / "systems"
_LABEL = "rosarch library: "


@dataclass(frozen=True)
class Library:
    """All components, by package and name, and what is wrong with files that were left out."""

    components: tuple[LibraryComponent, ...]
    problems: tuple[Diagnostic, ...]

    @cached_property
    def _by_name(self) -> dict[tuple[int | None, str | None, str], LibraryComponent]:
        found: dict[tuple[int | None, str | None, str], LibraryComponent] = {}
        for package_counts in (False, True):
            for component in reversed(self.components):
                for version in (None, *(component.ros or (1, 2))):
                    found[version, component.package if package_counts else None, component.component] = component
        return found

    @property
    def packages(self) -> frozenset[str]:
        """The packages that have components here."""
        return frozenset(component.package for component in self.components)

    def find(self, package: str | None, component: str, ros: int | None = None) -> LibraryComponent | None:
        """The component called `component` in `package`, as a version of ROS has it; without one of these, the first of that name.

        Nodelets and plug-ins go by their lookup name (`image_proc/debayer`), plug-ins of gazebo by the name of their library; neither
        needs a package.
        """
        return self._by_name.get((ros, package, component))

    def with_loaded(self, component: LibraryComponent, ros: int | None = None) -> tuple[LibraryComponent, ...]:
        """`component`, with the plug-ins that it loads in a version of ROS and the components of the nodes that it makes.

        Those of these are among them, as far as they are known.
        """
        found = {component.title: component}
        waiting = [component]
        while waiting:
            one = waiting.pop()
            made = (name.partition("/") for name in one.makes.values())
            for part in (
                *(self.find(None, name, ros) for name in one.loads),
                *(self.find(package, name, ros) for package, _, name in made),
            ):
                if part is not None and part.title not in found:
                    found[part.title] = part
                    waiting.append(part)
        return tuple(found.values())


@lru_cache(maxsize=8)
def _load(folders: tuple[Path, ...], _stamp: tuple[tuple[str, int, int], ...]) -> Library:
    read = [read_folder(folder) for folder in (*folders, _SHIPPED)]
    files = [file for found, _ in read for file in found]
    return Library(tuple(merged(files)), tuple(problem for _, problems in read for problem in problems))


def prefixes(folders: Sequence[Path] = ()) -> tuple[tuple[str, int], ...]:
    """Where the library has files of packages, the users' own `folders` first: prefixes, each for a version of ROS."""
    found = ((os.path.abspath(folder / f"ros{version}"), version) for folder in (*folders, _SYSTEMS) for version in (1, 2))
    return tuple((prefix, version) for prefix, version in found if os.path.isdir(os.path.join(prefix, SHARE)))


def load(folders: Sequence[Path] = ()) -> Library:
    """The library that comes with rosarch, with the users' own `folders` before it; read once in a process, as long as no file changes."""
    files = [path.absolute() for folder in folders for path in library_files(folder)]
    return _load(tuple(folders), tuple((str(path), stat.st_mtime_ns, stat.st_size) for path in files for stat in (path.lstat(),)))


def find(package: str | None, component: str, folders: Sequence[Path] = ()) -> LibraryComponent | None:
    """The component called `component` in `package`, see `Library.find`."""
    return load(folders).find(package, component)


def components(folders: Sequence[Path] = ()) -> Iterable[LibraryComponent]:
    """All components, by package and name."""
    return load(folders).components


def shown_path(path: str) -> str:
    """A path as people read it: of a file that comes with rosarch, where it is in the library."""
    shipped = f"{_SHIPPED}{os.sep}"
    return f"{_LABEL}{path.removeprefix(shipped)}" if path.startswith(shipped) else path
