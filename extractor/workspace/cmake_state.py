"""What changes while CMake files run: scopes, directories, targets under construction."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.extractor.workspace.cmake_syntax import Command, Statement
from rosarch.extractor.workspace.installs import Install, Unsure
from rosarch.extractor.workspace.model import BuildCall

if TYPE_CHECKING:
    from collections.abc import Iterable


class StopLoop(Exception):
    """`break()` or `continue()`."""

    def __init__(self, leave: bool) -> None:
        self.leave = leave


class StopFile(Exception):
    """`return()`: leaves the function, or the file when outside a function."""


class StopAll(Exception):
    """The evaluation was given up."""


class Scope:
    """Variables of a directory or function. A new scope starts with a copy of its parent's variables."""

    __slots__ = ("parent", "variables")

    def __init__(self, parent: Scope | None = None) -> None:
        self.parent = parent
        self.variables: dict[str, str] = dict(parent.variables) if parent else {}


@dataclass
class Directory:
    """Directory properties, inherited by sub-directories as they are when those are added.

    `real_paths` are those of this directory and all above it, links resolved.
    """

    source: str
    binary: str
    real_paths: frozenset[str] = frozenset()
    include_dirs: list[str] = field(default_factory=list)
    definitions: list[str] = field(default_factory=list)
    links: list[str] = field(default_factory=list)
    properties: dict[str, str] = field(default_factory=dict)

    def child(self, source: str, binary: str, real_path: str) -> Directory:
        """A sub-directory."""
        return Directory(source, binary, self.real_paths | {real_path}, list(self.include_dirs), list(self.definitions), list(self.links))


@dataclass
class TargetDraft:
    """A target while commands still add to it. Properties hold lists, as written after expansion."""

    name: str
    kind: str
    directory: Directory
    cmake_file: str
    line: int
    column: int = 1
    properties: dict[str, list[str]] = field(default_factory=dict)
    uses_packages: list[str] = field(default_factory=list)
    given_line: int = 0

    def extend(self, name: str, values: Iterable[str]) -> None:
        """Append to a list property."""
        self.properties.setdefault(name, []).extend(values)


@dataclass(frozen=True, slots=True)
class Procedure:
    """A `function` or `macro` of the CMake files."""

    name: str
    is_macro: bool
    parameters: tuple[str, ...]
    body: tuple[Statement, ...]
    file: str


@dataclass(frozen=True, slots=True)
class Call:
    """A command about to run, its arguments expanded and split."""

    command: Command
    args: list[str]
    file: str

    @property
    def name(self) -> str:
        """The command's name, lower case."""
        return self.command.name


@dataclass
class PackageDraft:
    """What the ROS macros of a package's CMake files declare."""

    include_dirs: list[str] = field(default_factory=list)
    libraries: list[str] = field(default_factory=list)
    export_sets: dict[str, list[str]] = field(default_factory=dict)
    exported_sets: list[str] = field(default_factory=list)
    depends: list[str] = field(default_factory=list)
    cfg_extras: list[str] = field(default_factory=list)
    message_files: list[str] = field(default_factory=list)
    service_files: list[str] = field(default_factory=list)
    action_files: list[str] = field(default_factory=list)
    cfg_files: list[str] = field(default_factory=list)
    parameter_files: list[tuple[str, str]] = field(default_factory=list)
    configured: list[tuple[str, str]] = field(default_factory=list)
    component_nodes: list[tuple[str, str, str, int]] = field(default_factory=list)
    plugin_exports: list[tuple[str, str]] = field(default_factory=list)
    found_packages: list[str] = field(default_factory=list)
    finds: list[str] = field(default_factory=list)
    programs: list[tuple[str, str]] = field(default_factory=list)
    python_folders: list[str] = field(default_factory=list)
    installs: list[Install] = field(default_factory=list)
    auto_targets: list[str] = field(default_factory=list)
    installed_targets: list[tuple[str, str, tuple[Path, int] | None]] = field(default_factory=list)
    installed_files: list[tuple[str, Path, int]] = field(default_factory=list)
    unsure: list[Unsure] = field(default_factory=list)
    calls: list[BuildCall] = field(default_factory=list)
