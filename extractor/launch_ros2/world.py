"""What all parts of a composition share: files, packages, unknowns, the interpreter, files that launch files write."""

from __future__ import annotations

import os
from collections.abc import Mapping
from contextlib import suppress
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.base.files import read_file
from rosarch.extractor.launch.eval_functions import TooLarge, size_of
from rosarch.extractor.launch.formulas import FALSE, TRUE, Formula, bounded, choice, tests_of, truth
from rosarch.extractor.launch.model import LaunchError, PackageNamed, Place, Reference
from rosarch.extractor.launch.state import State
from rosarch.extractor.launch.unknowns import cleaned, is_known, may_be
from rosarch.extractor.launch_ros2.agenda import Agenda
from rosarch.extractor.launch_ros2.context import Context
from rosarch.extractor.launch_ros2.interpreter import Interpreter
from rosarch.extractor.launch_ros2.registry import HELPER_PACKAGES
from rosarch.extractor.launch_ros2.values import NOTHING, Class, Either, Function, PathText, Unknown, installed
from rosarch.extractor.urdf.robots import Robot

if TYPE_CHECKING:
    from rosarch.extractor.launch.yaml_values import KeyLines
    from rosarch.extractor.launch_ros2.controllers import Asked
    from rosarch.extractor.launch_ros2.params_files import ParamsFile

MAX_HANDED = 1000
_NO_MODULE = {"ImportError", "ModuleNotFoundError"}
_WITH_LAUNCH = frozenset({"ament_index_python", "osrf_pycommon", "rclpy", "composition_interfaces", "lifecycle_msgs", "xacro"})
"""Packages whose modules are there wherever launch is, as it needs them itself; and xacro, which is evaluated here."""
_NO_PACKAGE = {"PackageNotFoundError", "KeyError", "LookupError"}
_KNOWN = Path(__file__).parent / "known"
_KNOWN_NAMES = frozenset(path.stem for path in _KNOWN.glob("*.txt"))


class World:
    """One composition in progress."""

    def __init__(self, state: State) -> None:
        self.state = state
        self.interpreter = Interpreter(self)
        self.agenda = Agenda(self)
        self.written = state.written
        self.described: dict[str, Robot | None] = {}
        self.maps_read: dict[int, tuple[dict[Any, Any], dict[Any, tuple[Any, Place]]]] = {}
        self.parameter_texts: dict[tuple[str, bool], ParamsFile] = {}
        self.performed: dict[tuple[int, frozenset[tuple[str, str]]], tuple[Any, str]] = {}
        self.references: list[Reference] = []
        self.read: dict[tuple[str, Place], None] = {}
        self.looked_for: set[str] = set()
        self.controllers: list[Asked] = []
        self.asked: list[str] = []
        self.handed: list[str] = []
        self.programs: dict[str, str] = {}
        self.temporary = 0
        self.argv: list[str] = []
        """The command line of launch, which is also that of each file in Python."""
        self.context = Context("", outside=self.environment)

    @property
    def environment(self) -> Mapping[str, str]:
        """The environment variables that launch is started with."""
        return self.state.resolver.environment

    def as_text(self, value: Any) -> str:
        """A value as a text, or a part of one; an unknown as what the source writes for it."""
        if isinstance(value, str):
            return value
        if isinstance(value, PathText):
            return value.text
        if isinstance(value, Either):
            first, second = self.as_text(value.first), self.as_text(value.second)
            if first == second:
                return first
            shown = [self.state.unknowns.render(text) for text in (first, second)]
            condition = value.condition.formula
            mark = self.state.unknowns.mark(f"$({value.condition.text} ? {shown[0]} : {shown[1]})", condition)
            self.state.unknowns.truths.setdefault(mark, bounded(choice(condition, *map(self.truth, (first, second))), mark))
            return mark
        if isinstance(value, Unknown):
            return self.state.unknowns.mark(f"$({value.text})", value.place.path)
        if value is NOTHING:
            return ""
        try:
            self.state.spend(size_of(value))
        except TooLarge as error:
            return self.state.unknowns.mark(f"$({error})")
        return str(value)

    def truth(self, text: str) -> Formula:
        """When a text counts as true."""
        if self.state.unknowns.is_open(text):
            return truth(self.state.unknowns, text)
        return TRUE if text.lower().strip() in ("true", "1") else FALSE

    def share(self, package: str) -> str:
        """The folder of a package, where its `share` is from; a mark when it is not on the package path."""
        state = self.state
        if state.unknowns.is_open(package):
            without = package
            for mark in self.interpreter.of_unset:
                without = without.replace(mark, "None")
            if without != package and state.files.packages.find(without) is None:
                shown = state.unknowns.render(package)
                state.report(LaunchError("env", shown, f"the package `{shown}` is named by an environment variable that is not set"))
            return state.unknowns.mark(f"$(find-pkg-share {state.unknowns.render(package)})", package)
        folder = state.files.packages.find(package)
        needed = not self.is_guarded(package) and not self.interpreter.optional(_NO_PACKAGE, installed(package))
        if folder is not None:
            if needed:
                self.references.append(PackageNamed(package, folder, state.here))
            if needed and state.files.packages.is_left_out(folder):
                state.report(LaunchError("left-out", package, f"package `{package}` is not built: COLCON_IGNORE leaves it out"))
            return folder
        if needed:
            state.report(LaunchError("package", package, f"package `{package}` is not on the package path"))
        return state.unknowns.mark(f"$(find-pkg-share {package})")

    def import_from(self, package: str, place: Place) -> None:
        """Note that a module is of a package that is not on the package path: one that a manifest names, or one of a distribution.

        Any other may be a module of Python that is not of ROS.
        """
        packages = self.state.files.packages
        if package in _WITH_LAUNCH or packages.find(package) is not None:
            return
        if package not in HELPER_PACKAGES and not packages.is_named(package):
            return
        self.here(place)
        if not self.interpreter.optional(_NO_MODULE, installed(package)):
            self.state.report(LaunchError("package", package, f"package `{package}` is not on the package path"))

    def prefix(self, package: str) -> str:
        """The prefix that a package is installed below; of one that is there as sources, its folder."""
        installed_as = None if self.state.unknowns.is_open(package) else self.state.files.packages.underlay.packages.get(package)
        return self.share(package) if installed_as is None else installed_as.prefix

    def is_guarded(self, package: str) -> bool:
        """Whether what is carried out happens under a condition that asks whether the package, or the metapackage of its name, is there."""
        conditions = (*self.interpreter.path, *self.state.scope.conditions)
        words = package.split("_")
        asked = {installed("_".join(words[:count])) for count in range(1, len(words) + 1)}
        return any(test.subject in asked for one in conditions for test in tests_of(one.value))

    def new_file(self) -> str:
        """The name of a temporary file."""
        self.temporary += 1
        return self.state.unknowns.mark(f"$(temporary file {self.temporary})", self.temporary)

    def source_of(self, path: str) -> str:
        """The text of a file, one that was written meanwhile included.

        Raises:
            LaunchError: it cannot be read.
        """
        if path in self.written:
            return self.written[path]
        self.read.setdefault((path, self.state.here))
        if self.is_handed(path):
            return self.content_of(path)
        return self.state.files.read_text(self.located(path))

    def note_read(self, value: Any, path: str, lines: KeyLines, keys: tuple[str, ...] = ()) -> None:
        """Remember where the keys of maps stand that were read from a file."""
        if isinstance(value, dict) and id(value) not in self.maps_read:
            at = {key: lines.get((*keys, str(key))) for key in value}
            self.maps_read[id(value)] = value, {key: (value[key], Place(path, line)) for key, line in at.items() if line}
            for key, item in value.items():
                self.note_read(item, path, lines, (*keys, str(key)))

    def read_at(self, owner: Any, key: Any) -> Place | None:
        """Where a key of a map is in the file that it was read from, unless its value was changed meanwhile."""
        _, places = self.maps_read.get(id(owner), (owner, {}))
        value, place = places.get(key, (None, None))
        return place if value is owner[key] else None

    def content_of(self, path: str) -> str:
        """What is in a file, when that is not known."""
        return self.state.unknowns.mark(f"$(file-content {self.state.unknowns.render(path)})", path)

    def by_names(self, command: str) -> str:
        """A command with the names of programs for where they were found."""
        for found, name in self.programs.items():
            command = command.replace(found, name)
        return command

    def hand(self, *values: Any) -> None:
        """Note what programs and functions get that are not seen here: they may write the files that it names."""
        stack = list(values)
        while stack and len(self.handed) < MAX_HANDED:
            value = stack.pop()
            if isinstance(value, PathText):
                value = value.text
            if isinstance(value, str) and "/" in value:
                self.handed.append(value)
            elif isinstance(value, (list, tuple)):
                stack += value[:MAX_HANDED]

    def is_made(self, path: str) -> bool:
        """Whether a file is written meanwhile, or may be."""
        return path in self.written or ("/" in path.rstrip("/") and self.is_handed(path))

    def is_handed(self, path: str) -> bool:
        """Whether a file that is not there may be written meanwhile: under a path that is not known, or with other arguments than now."""
        if self.state.files.is_file(self.located(path)):
            return False
        name = os.path.basename(path)
        written = any(may_be(text, path) or os.path.basename(text) == name for text in self.written if is_known(text[-1:]))
        return written or any(path in text for text in self.handed)

    def located(self, path: str) -> str:
        """Where a file is in the sources that is installed at `path`, as far as that is known."""
        return path if self.state.unknowns.is_open(path) else self.state.files.located(path)

    def module_source(self, name: str, beside: str) -> tuple[str, str] | None:
        """File and text of a module: one that rosarch knows, of the launch file's folder, of the workspace, of an installed package."""
        if name in _KNOWN_NAMES:
            return name, (_KNOWN / f"{name}.txt").read_text(encoding="utf-8")
        words = name.split(".")
        packages = self.state.files.packages
        folder = packages.find(words[0])
        beside_it = [os.path.dirname(beside), *([folder, os.path.join(folder, "src")] if folder else [])]
        for root in chain(beside_it, packages.installing_module(words[0])):
            base = os.path.join(root, *words)
            for path in (f"{base}.py", os.path.join(base, "__init__.py")):
                if self.state.files.is_file(path):
                    try:
                        return path, self.state.files.read_text(path)
                    except LaunchError:
                        continue
        module = self.state.files.packages.underlay.module(name)
        if module is not None:
            with suppress(OSError):
                return str(module), cleaned(read_file(module).decode(errors="replace"))
        return None

    def here(self, place: Place) -> None:
        """Make `place` the one that reports are about."""
        self.state.here = place


def known_class(found: Class) -> str | None:
    """The helper package that a class is of whose source rosarch has."""
    modules = {member.frame.module.name for member in found.members.values() if isinstance(member, Function)}
    return next(iter(modules & _KNOWN_NAMES), None)


def has_known_modules(package: str) -> bool:
    """Whether rosarch has the source of a helper package's modules."""
    return any(name.partition(".")[0] == package for name in _KNOWN_NAMES)
