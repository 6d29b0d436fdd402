"""What the build of a package comes to, as far as claims about its files and programs need it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, TypeVar

from rosarch.extractor.workspace.entry_points import Lack, lacks
from rosarch.extractor.workspace.installs import Install, Obstacle, Unsure
from rosarch.extractor.workspace.model import BuildCall, EntryPoint, Target, Workspace
from rosarch.extractor.workspace.plugins import Scans
from rosarch.extractor.workspace.registering import Described, Promised, described, exports_more, promised

INSTALLED_FIRST = frozenset({"ament_cmake", "ament_python"})
"""The build types of packages that are used from where they are installed: nothing is found in their sources."""


@dataclass(frozen=True)
class Built:
    """A package in `folder`: what its build installs, why that may be more, the entry points that it declares, those without code.

    `promised` are the components that its CMake files name, `described` the plug-ins that descriptions in it name; there are others when
    it `exports_more`. `obstacles` keep it from being built or used. Its `targets` are built, headers made of its `interfaces`
    and `configurations`; CMake `finds` packages, and makes and registers something by `calls`.
    """

    name: str
    folder: Path
    build_type: str
    installs: tuple[Install, ...]
    unsure: tuple[Unsure, ...]
    entry_points: tuple[EntryPoint, ...] = ()
    lacks: tuple[Lack, ...] = ()
    promised: tuple[Promised, ...] = ()
    described: tuple[Described, ...] = ()
    exports_more: bool = False
    obstacles: tuple[Obstacle, ...] = ()
    targets: tuple[Target, ...] = ()
    interfaces: tuple[Path, ...] = ()
    configurations: tuple[Path, ...] = ()
    finds: frozenset[str] = frozenset()
    calls: tuple[BuildCall, ...] = ()

    def called(self, *names: str) -> tuple[BuildCall, ...]:
        """The calls of commands, in the order in which they are run."""
        return tuple(call for call in self.calls if call.name in names)

    def brings(self, path: str) -> bool:
        """Whether there is `path` below the prefix."""
        return any(install.brings(path) for install in self.installs)

    def copied_plainly(self, name: str) -> Iterator[tuple[Path, int]]:
        """Where the program `name` is copied without permission to execute it; nothing when a second copy has that."""
        found = [(install, path) for install in self.installs for path in install.files_called(name) if self._is_searched(path)]
        if all(install.plain for install, _ in found):
            yield from dict.fromkeys(install.plain for install, _ in found if install.plain)

    def elsewhere(self, name: str) -> Iterator[tuple[str, Path, int]]:
        """Where the program `name` is installed that nobody looks for there: as which path, and by which command."""
        for install in () if self.has_program(name) else self.installs:
            if install.at:
                yield from ((path, *install.at) for path in install.files_called(name))

    def _is_searched(self, path: str) -> bool:
        """Whether programs are looked for there: `rosrun` looks below the share folder, too."""
        return path.startswith(
            (f"lib/{self.name}/",) if self.build_type in INSTALLED_FIRST else (f"lib/{self.name}/", f"share/{self.name}/")
        )

    def has_program(self, name: str) -> bool:
        """Whether the program `name` may be installed where programs are looked for."""
        return name in self.programs or self.brings(f"lib/{self.name}/{name}")

    @property
    def programs(self) -> frozenset[str]:
        """The names of the programs that are found in it, those in folders left out."""
        return frozenset(install.path.rpartition("/")[2] for install in self.installs if install.path.startswith(f"lib/{self.name}/"))


def builds(workspace: Workspace, scans: Scans | None = None) -> tuple[Built, ...]:
    """The builds of all packages, of those that say what they install."""
    scans = scans or Scans()
    return tuple(
        Built(
            package.name,
            package.path,
            package.build_type,
            package.installs,
            package.unsure,
            package.entry_points,
            tuple(lacks(package)),
            tuple(promised(workspace, package, scans)),
            tuple(described(package)),
            exports_more(package),
            package.obstacles,
            package.targets,
            (*package.message_files, *package.service_files, *package.action_files),
            package.cfg_files,
            package.finds,
            package.calls,
        )
        for package in workspace.packages
        if not package.installed
    )


class _InFolder(Protocol):
    @property
    def folder(self) -> Path | str: ...


_Package = TypeVar("_Package", bound=_InFolder)


def package_of(path: str, packages: Iterable[_Package]) -> _Package | None:
    """The package that a file is in, the innermost."""
    above = [one for one in packages if path.startswith(f"{one.folder}/")]
    return max(above, key=lambda one: len(str(one.folder)), default=None)
