"""What is installed beneath a workspace: prefixes such as `/opt/ros/humble`, in which packages lie by kinds of files.

Of a package NAME there are `share/NAME` with its manifest, launch files and interfaces, its programs in `lib/NAME`, headers below `include`
and modules of Python below `lib/python3*`; the index `share/ament_index` says which plug-ins and components it has. Nothing of it is run.
Sources: REP 122, the articles on ament at design.ros2.org, colcon's documentation (a prefix for each package, unless they are merged).
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from rosarch.base import tracing
from rosarch.base.boundary import ros_package_path
from rosarch.base.files import LARGEST_PARSED, file_name, read_file
from rosarch.extractor.declared import DECLARED

VARIABLES = ("AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "CMAKE_PREFIX_PATH", "ROS_PACKAGE_PATH")
"""The variables that name prefixes, the first one's before the others'."""
DISTRIBUTIONS = "/opt/ros"
_PARTS = ("share", "lib", "local/lib", "include")
"""The folders of a prefix that anything is read of."""
_PYTHON = re.compile(r"python[23](\.\d+)?$")
_INTERFACES = frozenset({"msg", "srv", "action"})
COMPONENTS = "rclcpp_components"
"""The kind of resources that says which classes can be loaded into containers, each with its library after a semicolon."""
_SETUP = ("setup.sh", "local_setup.sh")
"""What is at the top of a prefix that holds nothing but packages of ROS."""


@dataclass(frozen=True)
class Installed:
    """A package of a prefix. Of one in a library there is the share folder alone, for the version `ros` of ROS."""

    name: str
    prefix: str
    ros: int | None = None

    @property
    def share(self) -> str:
        """The folder of its manifest."""
        return f"{self.prefix}/share/{self.name}"

    def programs(self) -> dict[str, str]:
        """The files that it is run by, by their names."""
        found = ((name, _in(self.prefix, "lib", self.name, name)) for name in names_in(f"{self.prefix}/lib/{self.name}"))
        return {name: path for name, path in found if os.path.isfile(path)}

    def runs(self, program: str) -> bool:
        """Whether it can be run by this name, as a program or as a component."""
        registered = {line.partition(";")[0].strip() for line in self.resource(COMPONENTS).splitlines()}
        return program in registered or program in self.programs() or program in self._shared_names()

    def _shared_names(self) -> set[str]:
        """The names of the files of its share folder, where `rosrun` looks, too."""
        found: set[str] = set()
        for here, _, names in os.walk(self.share):
            tracing.names(here)
            found.update(names)
        return found

    def resource(self, kind: str) -> str:
        """What the index says of it under a kind of resources."""
        try:
            return read_file(f"{self.prefix}/share/ament_index/resource_index/{kind}/{self.name}", LARGEST_PARSED).decode(errors="replace")
        except OSError:
            return ""

    def resources(self) -> Iterator[tuple[str, str]]:
        """What the index says of it, by the kinds of resources."""
        index = f"{self.prefix}/share/ament_index/resource_index"
        for kind in names_in(index):
            tracing.probe(f"{index}/{kind}/{self.name}")
            if os.path.isfile(f"{index}/{kind}/{self.name}"):
                yield kind, self.resource(kind)


@dataclass(frozen=True)
class Underlay:
    """Prefixes; of two packages of one name the first counts, and none of those that are `hidden`, which the workspace has.

    Last come those of libraries, for a version of ROS each, which hold files of packages that are not installed.
    """

    prefixes: tuple[str, ...] = ()
    hidden: frozenset[str] = frozenset()
    libraries: tuple[tuple[str, int], ...] = ()

    @classmethod
    def of(cls, folders: Iterable[str | Path]) -> Underlay:
        """The prefixes that folders are, or hold one for each package."""
        return cls(tuple(dict.fromkeys(prefix for folder in folders for prefix in prefixes_in(folder))))

    def without(self, names: Iterable[str]) -> Underlay:
        """The same, without the packages of a workspace."""
        return replace(self, hidden=self.hidden | frozenset(names))

    def of_ros(self, version: int) -> Underlay:
        """The same, without libraries for another version of ROS."""
        return replace(self, libraries=tuple(one for one in self.libraries if one[1] == version))

    @cached_property
    def packages(self) -> Mapping[str, Installed]:
        """The packages, by their names."""
        found: dict[str, Installed] = {}
        for prefix, ros in (*((prefix, None) for prefix in self.prefixes), *self.libraries):
            for name in _packages_in(prefix):
                if name not in self.hidden:
                    found.setdefault(name, Installed(name, prefix, ros))
        return found

    @property
    def count(self) -> int:
        """How many packages are installed."""
        return sum(package.ros is None for package in self.packages.values())

    def key(self) -> list[str]:
        """What distinguishes it from others, but for the contents of packages."""
        return [f"{one.prefix} {one.name}" for one in self.packages.values()]

    @cached_property
    def folders(self) -> tuple[str, ...]:
        """The folders that may be read."""
        below = [f"{prefix}/{part}" for prefix in self.prefixes for part in _PARTS]
        return tuple(folder for folder in (*below, *(f"{prefix}/share" for prefix, _ in self.libraries)) if os.path.isdir(folder))

    @property
    def share_folders(self) -> tuple[str, ...]:
        """The folders of `ROS_PACKAGE_PATH` that would lead to its packages."""
        return tuple(f"{prefix}/share" for prefix in self.prefixes)

    def holds(self, path: str) -> bool:
        """Whether a path is below one of the prefixes."""
        return path.startswith(tuple(f"{folder}/" for folder in self.folders))

    def is_of_library(self, path: str) -> bool:
        """Whether a file is one of a library, which nobody needs to hear about: less may be there than its package has."""
        return path.startswith(tuple(f"{prefix}/" for prefix, _ in self.libraries))

    def of_share(self, folder: str) -> Installed | None:
        """The package whose share folder this is."""
        package = self.packages.get(os.path.basename(folder))
        return package if package is not None and package.share == folder else None

    def lacks(self, package: str, program: str) -> bool:
        """Whether a package is installed, and this program of it is not."""
        found = self.packages.get(package)
        return found is not None and found.ros is None and program == file_name(program) and not found.runs(program)

    def module(self, name: str) -> Path | None:
        """The file of a module of Python of a package, but for what is made of interfaces, and what rosarch has declarations of."""
        top, *rest = name.split(".")
        package = self.packages.get(top)
        if package is None or top in DECLARED or (rest and rest[0] in _INTERFACES):
            return None
        for root in python_folders(package.prefix):
            base = "/".join([root, *name.split(".")])
            for path in (f"{base}/__init__.py", f"{base}.py"):
                tracing.probe(path)
                if os.path.isfile(path):
                    return Path(path)
        return None

    def headers(self, name: str) -> Iterator[str]:
        """Where a header may be installed, by the name that code includes it by: of packages whose names begin as it does."""
        first = name.partition("/")[0]
        if first in self.hidden or first in DECLARED:
            return
        for package in self.packages.values():
            if package.name.startswith(first) and package.name not in DECLARED:
                yield f"{package.prefix}/include/{package.name}/{name}"
        of_first = self.packages.get(first)
        yield from (f"{prefix}/include/{name}" for prefix in ([of_first.prefix] if of_first else self._prefixes_of_ros))

    @cached_property
    def _prefixes_of_ros(self) -> list[str]:
        """The prefixes that hold nothing but packages of ROS."""
        return [prefix for prefix in self.prefixes if any(os.path.isfile(f"{prefix}/{name}") for name in _SETUP)]

    @property
    def include_folders(self) -> tuple[str, ...]:
        """The folders that hold headers."""
        return tuple(folder for prefix in self.prefixes if os.path.isdir(folder := f"{prefix}/include"))


NOTHING_INSTALLED = Underlay()


def environment_underlay(variables: Mapping[str, str]) -> Underlay:
    """The underlay that the variables of a shell name, the distribution of ROS that it is for last."""
    named = [folder for name in VARIABLES for folder in variables.get(name, "").split(os.pathsep) if os.path.isabs(folder)]
    return Underlay.of([*named, *_distributions(variables.get("ROS_DISTRO", ""))])


def source_folders(variables: Mapping[str, str]) -> list[Path]:
    """The folders of `ROS_PACKAGE_PATH` in which nothing is installed: packages there are as they are in a workspace."""
    return [folder for folder in ros_package_path(variables) if not prefixes_in(folder)]


def _distributions(chosen: str) -> list[str]:
    """Where ROS is installed: the distribution that is chosen; without a choice, the only one."""
    names = [name for name in names_in(DISTRIBUTIONS) if name == chosen or not chosen]
    return [f"{DISTRIBUTIONS}/{name}" for name in names] if len(names) == 1 else []


def prefixes_in(folder: str | Path) -> tuple[str, ...]:
    """The prefix that a folder is, or whose share folder it is; or those that it holds, one for each package."""
    folder = os.path.abspath(folder)
    for prefix in (folder, *([os.path.dirname(folder)] if os.path.basename(folder) == "share" else [])):
        if next(_packages_in(prefix), None) is not None:
            return (prefix,)
    each = ((f"{folder}/{name}", name) for name in names_in(folder) if not name.startswith("."))
    return tuple(prefix for prefix, name in each if _is_package(prefix, name))


def _packages_in(prefix: str) -> Iterator[str]:
    return (name for name in names_in(f"{prefix}/share") if _is_package(prefix, name))


def _is_package(prefix: str, name: str) -> bool:
    return name == file_name(name) and os.path.isfile(_in(prefix, "share", name, "package.xml"))


def _in(prefix: str, *names: str) -> str:
    """A path below a prefix; one that leads out of it is none."""
    path = "/".join([prefix, *names])
    return path if os.path.realpath(path).startswith(os.path.realpath(prefix).rstrip("/") + "/") else ""


def names_in(folder: str) -> list[str]:
    """The names in a folder, sorted; none where there is no such folder."""
    tracing.names(folder)
    try:
        return sorted(os.listdir(folder))
    except OSError:
        return []


def python_folders(prefix: str) -> list[str]:
    """Where modules of Python are below a prefix."""
    return [
        path
        for library in (f"{prefix}/lib", f"{prefix}/local/lib")
        for name in names_in(library)
        if _PYTHON.match(name)
        for kind in ("site-packages", "dist-packages")
        if os.path.isdir(path := f"{library}/{name}/{kind}")
    ]
