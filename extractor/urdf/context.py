"""One evaluation in progress: where it is, what was read and reported, and how much work it may still do."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.model import LaunchError, Place, Problem
from rosarch.extractor.launch.scope import Scope
from rosarch.extractor.launch.substitution import Resolver
from rosarch.extractor.launch.unknowns import Unknowns
from rosarch.extractor.urdf.model import XacroError

MAX_WORK = 32 * 1024 * 1024  # characters of evaluated texts; elements and steps of expressions count as some
MAX_DEPTH = 120  # elements, macros and files within each other


class Context:
    """What all parts of an evaluation share.

    `incomplete` says that a file is missing, so that what it defines is unknown, not absent. `meant` are files that are looked for where
    their packages are installed, each with the place that names it.
    """

    def __init__(
        self, files: Files, environment: Mapping[str, str], unknowns: Unknowns, arguments: Mapping[str, str], installed: bool = False
    ) -> None:
        self.files, self.unknowns, self.installed = files, unknowns, installed
        self.resolver = Resolver(files.packages, environment, unknowns, self)
        self.scope = Scope("/", "", args=dict(arguments))
        self.open_files: list[str] = []
        self.here = Place("", 1)
        self.problems: dict[Problem, None] = {}
        self.read: dict[str, None] = {}
        self.meant: dict[tuple[str, Place], None] = {}
        self.incomplete = False
        self.work = 0
        self.depth = 0

    def report(self, error: LaunchError, fatal: bool = True) -> None:
        """Note a problem at the present element, once."""
        render = self.unknowns.render
        self.problems.setdefault(Problem(error.kind, render(error.subject), render(error.message), self.here, fatal))

    def spend(self, characters: int) -> None:
        """Count work.

        Raises:
            XacroError: it is too much.
        """
        self.work += characters
        if self.work > MAX_WORK:
            raise XacroError("the document unfolds to too much")

    @contextmanager
    def deeper(self) -> Iterator[None]:
        """Go into an element, macro or file.

        Raises:
            XacroError: that is too deep.
        """
        if self.depth >= MAX_DEPTH:
            raise XacroError(f"elements, macros and includes nested more than {MAX_DEPTH} deep")
        self.depth += 1
        try:
            yield
        finally:
            self.depth -= 1

    @contextmanager
    def file(self, path: str) -> Iterator[None]:
        """Go into a file.

        Raises:
            XacroError: it includes itself.
        """
        if path in self.open_files:
            raise XacroError(f"{path} includes itself")
        self.read.setdefault(path)
        self.open_files.append(path)
        before, self.scope.filename = self.scope.filename, path
        try:
            yield
        finally:
            self.open_files.pop()
            self.scope.filename = before

    def beside(self, path: str) -> str:
        """`path`, relative to the file that is evaluated, in the sources."""
        path = os.path.join(os.path.dirname(self.open_files[-1]), path)
        return self.files.located(path) if self.installed else path

    def evaluate_extension(self, command: str) -> str:
        """The value of `$(command)`.

        Raises:
            XacroError: it is malformed.
        """
        if command == "cwd":
            return self.files.folder
        try:
            return self.resolver.resolve(f"$({command})", self.scope)
        except LaunchError as error:
            raise XacroError(error.message, error.subject) from None
