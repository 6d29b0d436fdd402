"""Launch descriptions as data: what a launch file of Python makes, without the code that makes it.

A document has `launch_description`: actions and substitutions by the names of their classes (`is`) with the line and the arguments that
they were made with, lists, texts, numbers and Booleans; a dictionary is a list of pairs (`pairs`), an object of a helper package is `new`,
what is known only where it is launched is `?`.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.model import LaunchError, Place
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.launch.state import Exhausted, State
from rosarch.extractor.launch.unknowns import Unknowns, cleaned
from rosarch.extractor.launch_ros2.expressions import Raised, Stopped, Undecided
from rosarch.extractor.launch_ros2.values import CLASSES, Class, Frame, Function, Instance, Made, Module, ModuleFrame, PathText, Unknown
from rosarch.extractor.launch_ros2.world import World, has_known_modules, known_class

_PROSE = frozenset({"description", "msg"})
"""Arguments for readers."""
_SHARE = "/share-of/"
"""Where each package is while a launch file is described."""


class NotDescribedError(ValueError):
    """A launch file that makes no description here; the text says why."""


class _SomewhereElse(PackagePath):
    """Finds all packages: those below a folder there, of others each in a folder of its name."""

    def find(self, name: str) -> str | None:
        folder = None if has_known_modules(name) else super().find(name)
        return folder or f"{_SHARE}{name}"


class Describer:
    """Describes launch files of packages below a folder."""

    def __init__(self, root: Path) -> None:
        self._packages = _SomewhereElse([root])
        places = {folder: name for name, folder in self._packages.own.items()}
        self._names = places
        folders = "|".join(re.escape(folder) for folder in sorted(places, key=len, reverse=True))
        self._shared = re.compile(rf"({folders or '(?!)'})(?=/|$)|{_SHARE}([\w.-]+)|([\U00100000-\U0010ffff])")

    def described(self, path: str, text: str) -> str:
        """The document of the launch file at a path, which has this text. What is known only where it is launched is `?` in it.

        Raises:
            NotDescribedError: it makes no description, or one that is not understood.
        """
        files = Files(self._packages, os.path.dirname(path))
        state = State(files, {})
        world = World(state)
        state.here = Place(path, 1)
        files.allow_beside(path)
        try:
            module = world.interpreter.run_module("__launch__", path, text, is_launch_file=True)
            function = module.variables.get("generate_launch_description")
            found = world.interpreter.apply(function, [], {}) if isinstance(function, Function) else None
        except (LaunchError, Raised, Stopped, Undecided, Exhausted, SyntaxError, RecursionError) as error:
            raise NotDescribedError(str(error) or type(error).__name__) from None
        if not isinstance(found, Made):
            raise NotDescribedError("generate_launch_description returns no description")
        lost = [problem.message for problem in state.problems if problem.kind == "python"]
        if lost:
            raise NotDescribedError(lost[0])
        return json.dumps({"launch_description": self._document(found, state.unknowns)}, ensure_ascii=False) + "\n"

    def _document(self, value: Any, unknowns: Unknowns) -> Any:
        def inner(one: Any) -> Any:
            return self._document(one, unknowns)

        match value:
            case Made():
                given = {name: inner(one) for name, one in value.arguments.items() if one is not None and name not in _PROSE}
                rest = {"rest": [inner(one) for one in value.rest]} if value.rest else {}
                return {"is": value.kind, "line": value.place.line, **({"with": given} if given else {}), **rest}
            case Instance() if (known := known_class(value.of)) is not None:
                return {"new": value.of.name, "of": known, "with": {name: inner(one) for name, one in value.attributes.items()}}
            case PathText():
                return inner(value.text)
            case str():
                parts = list(self._parts(value, unknowns))
                return parts[0] if len(parts) == 1 else parts
            case list() | tuple():
                return [inner(one) for one in value]
            case dict():
                return {"pairs": [[inner(name), inner(one)] for name, one in value.items()]}
            case None | bool() | int() | float():
                return value
            case Unknown():
                return {"?": unknowns.render(value.text)}
        return {"?": type(value).__name__.lower()}

    def _parts(self, text: str, unknowns: Unknowns) -> Iterator[Any]:
        """A text, with the folders of packages and what is not known as substitutions."""
        end = 0
        for match in self._shared.finditer(text):
            if match.start() > end:
                yield text[end : match.start()]
            end = match.end()
            if match[3]:
                yield {"?": unknowns.render(match[3])}
            else:
                yield {"is": "FindPackageShare", "line": 1, "with": {"package": self._names.get(match[1], match[2])}}
        if end < len(text) or not text:
            yield text[end:]


def description(world: World, file: str) -> Any:
    """The launch description of the document in a file.

    Raises:
        LaunchError: it is not as it should be.
    """
    try:
        return _Reader(world, file).made(json.loads(world.state.files.read_text(file))["launch_description"])
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise LaunchError("python", file, f"{os.path.basename(file)} is no description of a launch") from None


class _Reader:
    """Makes what a document describes."""

    def __init__(self, world: World, file: str) -> None:
        self.run, self.file = world.interpreter, file
        self.frame = Frame({}, ModuleFrame("__launch__", file))

    def made(self, value: Any, line: int = 1) -> Any:
        """The value of a part of the document."""
        if isinstance(value, list):
            return [self.made(one, line) for one in value]
        if not isinstance(value, dict):
            return cleaned(value) if isinstance(value, str) else value
        if "?" in value:
            return Unknown(cleaned(value["?"]), Place(self.file, line))
        if "pairs" in value:
            return {_key(self.made(name, line)): self.made(one, line) for name, one in value["pairs"]}
        line = int(value.get("line", line))
        given = {str(name): self.made(one, line) for name, one in value.get("with", {}).items()}
        if "new" in value:
            return self._instance(value["of"], value["new"], given)
        rest = tuple(self.made(one, line) for one in value.get("rest", ()))
        if value["is"] not in CLASSES:
            raise ValueError("no class of launch")
        return Made(value["is"], given, Place(self.file, line), rest)

    def _instance(self, module: str, name: str, attributes: dict[str, Any]) -> Any:
        found = self.run.module(module, self.frame)
        made_of = found.frame.variables[name] if isinstance(found, Module) and found.frame else None
        if not isinstance(made_of, Class):
            raise ValueError("no class of a helper package")
        of_launch = made_of.constructors()[:1]
        return Instance(made_of, attributes, *(Made(one.kind, {}, Place(self.file, 1)) for one in of_launch))


def _key(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value
