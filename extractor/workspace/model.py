"""What a ROS workspace consists of, as plain data: packages, CMake targets, plug-in classes, components, diagnostics."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic
from rosarch.extractor.underlay import NOTHING_INSTALLED, Underlay
from rosarch.extractor.workspace.installs import Install, Obstacle, Unsure

ROS1 = "ros1"
ROS2 = "ros2"
EXECUTABLE = "executable"
SHARED = "shared_library"
STATIC = "static"
MODULE = "module"
OBJECT = "object"
INTERFACE = "interface"
IMPORTED = "imported"
TEST = "test"
PYTHON_NODE = "python_node"
LIBRARY = "library"
UNUSED = "unused"
LIBRARY_KINDS = frozenset({SHARED, STATIC, MODULE, OBJECT, INTERFACE})
_ROS2_TOOLS = frozenset({"rclcpp", "rclpy", "ament_cmake", "ament_cmake_auto"})


@dataclass(frozen=True)
class Target:
    """One CMake target. `sources` exist on disk; `links` are library names after expansion of variables.

    It is given packages and libraries at `given_line`, or made there when it is given none.
    """

    name: str
    output_name: str
    kind: str
    package: str
    cmake_file: Path
    line: int
    sources: tuple[Path, ...] = ()
    headers: tuple[Path, ...] = ()
    include_dirs: tuple[Path, ...] = ()
    interface_include_dirs: tuple[Path, ...] = ()
    definitions: tuple[str, ...] = ()
    interface_definitions: tuple[str, ...] = ()
    links: tuple[str, ...] = ()
    objects: tuple[str, ...] = ()
    uses_packages: tuple[str, ...] = ()
    given_line: int = 0


@dataclass(frozen=True)
class Exports:
    """What `catkin_package` or `ament_export_*` hands to dependent packages."""

    include_dirs: tuple[Path, ...] = ()
    libraries: tuple[str, ...] = ()
    depends: tuple[str, ...] = ()


@dataclass(frozen=True)
class PluginClass:
    """A class registered with pluginlib, nodelet or rclcpp_components; `executable` is the program that CMake makes of it alone."""

    name: str
    cxx_class: str
    base: str
    library: str
    declared_at: Path
    line: int
    executable: str = ""

    @property
    def in_python(self) -> bool:
        """Whether it is a class of Python, whose name has its module in front."""
        return "." in self.cxx_class and "::" not in self.cxx_class


@dataclass(frozen=True)
class Configured:
    """One `configure_file` call: `template` becomes `output` (below the imaginary build folder or the source tree)."""

    template: Path
    output: Path


@dataclass(frozen=True)
class Program:
    """A file that is installed as it is, to be run under `name`."""

    name: str
    path: Path


@dataclass(frozen=True)
class EntryPoint:
    """What a Python package calls `name` in a group of entry points: a function or class of `module`. `path` and `line` declare it."""

    name: str
    module: str
    function: str
    path: Path
    line: int
    group: str = "console_scripts"

    @property
    def is_command(self) -> bool:
        """Whether it is installed as a program, which calls the function."""
        return self.group in ("console_scripts", "gui_scripts")


SCOPES = frozenset({"PUBLIC", "PRIVATE", "INTERFACE", "SYSTEM"})
"""Words among the packages that a target is given."""


@dataclass(frozen=True)
class BuildCall:
    """A command that CMake runs at a line of a file, with its words.

    It is not known where it is in a branch that is not taken here, without words, or where nothing has set a variable in its words.
    """

    name: str
    words: tuple[str, ...]
    path: Path
    line: int
    is_known: bool = True


@dataclass(frozen=True)
class Package:
    """One package with all that its manifest and CMake files say; of one that is `installed`, all that was found where it lies.

    CMake `finds` packages, and makes and registers something by `calls`.
    """

    name: str
    path: Path
    manifest: Path
    version: str = ""
    build_type: str = "catkin"
    depends: tuple[str, ...] = ()
    build_depends: tuple[str, ...] = ()
    is_metapackage: bool = False
    targets: tuple[Target, ...] = ()
    aliases: tuple[tuple[str, str], ...] = ()
    exports: Exports = Exports()
    message_files: tuple[Path, ...] = ()
    service_files: tuple[Path, ...] = ()
    action_files: tuple[Path, ...] = ()
    cfg_files: tuple[Path, ...] = ()
    parameter_files: tuple[tuple[str, Path], ...] = ()
    plugin_exports: tuple[tuple[str, Path], ...] = ()
    plugins: tuple[PluginClass, ...] = ()
    configured: tuple[Configured, ...] = ()
    programs: tuple[Program, ...] = ()
    entry_points: tuple[EntryPoint, ...] = ()
    python_roots: tuple[Path, ...] = ()
    installs: tuple[Install, ...] = ()
    unsure: tuple[Unsure, ...] = ()
    obstacles: tuple[Obstacle, ...] = ()
    python_packages: tuple[str, ...] | None = None
    finds: frozenset[str] = frozenset()
    calls: tuple[BuildCall, ...] = ()
    installed: bool = False

    @property
    def middleware(self) -> str:
        """Which ROS the package is written for."""
        return ROS2 if self.build_type.startswith("ament") or not _ROS2_TOOLS.isdisjoint(self.depends) else ROS1

    def target(self, name: str) -> Target | None:
        """The target called `name`, aliases followed."""
        name = dict(self.aliases).get(name, name)
        return next((target for target in self.targets if target.name == name), None)


@dataclass(frozen=True, eq=False)
class Workspace:
    """Packages below `root`. `selected` are the packages asked for; the others are there because those need them.

    Those that are installed lie in the `underlay`, which has none of those below the root. Headers that no include path leads to are
    `searched` in all folders below the root, and scripts in those of their package.
    """

    root: Path
    packages: tuple[Package, ...]
    diagnostics: tuple[Diagnostic, ...] = ()
    selected: frozenset[str] = field(default_factory=frozenset)
    searched: bool = True
    underlay: Underlay = NOTHING_INSTALLED

    @property
    def is_whole(self) -> bool:
        """Whether all packages below the root are selected."""
        return self.selected.issuperset(package.name for package in self.packages if not package.installed)

    def package(self, name: str) -> Package | None:
        """The package called `name`."""
        return next((package for package in self.packages if package.name == name), None)


@dataclass(frozen=True)
class PythonEntry:
    """How a Python component begins: `file` is run, or, with a `function`, imported and this function called; of a plug-in, this class.

    `module` is the name that the file has then. Modules are looked for below `roots`, the first that has one counts. `modules` are name and
    file of all modules of the workspace that are imported on the way, that of the file itself first.
    """

    file: Path
    module: str
    function: str | None
    roots: tuple[Path, ...]
    modules: tuple[tuple[str, Path], ...] = ()

    @property
    def source(self) -> Path:
        """The file that the others are read for."""
        return self.file

    @property
    def own_sources(self) -> tuple[Path, ...]:
        """The files that are read for no other reason."""
        return tuple(dict.fromkeys(path for _, path in self.modules))


@dataclass(frozen=True)
class Component:
    """A unit of the running system: a node executable, a nodelet class, another plug-in class.

    `kind` is `node`, `nodelet`, `component` (rclcpp_components), `gazebo_plugin`, `plugin`, `python_node`, `library` (which nothing in
    the workspace runs) or `unused` (a source that nothing builds, imports or starts). `sources` are the component's own sources,
    `library_sources` those of the workspace libraries it is linked with, or of the modules of other packages that it imports.
    `executables` are the names that a Python node is started by, where `python` says how it begins.
    """

    name: str
    package: str
    kind: str
    target: Target | None
    libraries: tuple[Target, ...]
    sources: tuple[Path, ...]
    library_sources: tuple[Path, ...]
    entry_class: str | None = None
    base_class: str | None = None
    plugin_name: str | None = None
    definitions: tuple[str, ...] = ()
    include_dirs: tuple[Path, ...] = ()
    executables: tuple[str, ...] = ()
    python: PythonEntry | None = None
