"""Launch descriptions as data: what a launch file of Python makes, without the code that makes it.

A document has `launch_description`: actions and substitutions by the names of their classes (`is`) with the line and the arguments that
they were made with, lists, texts, numbers and Booleans; a dictionary is a list of pairs (`pairs`), an object of a helper package is `new`,
what is known only where it is launched is `?`.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.formulas import Every, Formula, Not, Some, Test
from rosarch.extractor.launch.model import LaunchError, Place
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.launch.state import Exhausted, State
from rosarch.extractor.launch.unknowns import Unknowns, cleaned
from rosarch.extractor.launch_ros2.actions import called
from rosarch.extractor.launch_ros2.context import Context
from rosarch.extractor.launch_ros2.expressions import Raised, Stopped, Undecided
from rosarch.extractor.launch_ros2.values import (
    CLASSES,
    MODULES,
    NOTHING,
    Class,
    Either,
    Frame,
    Function,
    Instance,
    Made,
    Module,
    ModuleFrame,
    PathText,
    Unknown,
    in_order,
)
from rosarch.extractor.launch_ros2.world import World, has_known_modules, known_class

_PROSE = frozenset({"description", "msg"})
"""Arguments for readers."""
_ACTIONS = frozenset(name for module, names in MODULES.items() if module.endswith("actions") for name in names)
_VARIABLE = re.compile(r"\$\(env (\w+)\)")
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
            if not isinstance(found, Made):
                raise NotDescribedError("generate_launch_description returns no description")
            document = _Writer(world, path, self._shared, self._names).document(found)
        except (LaunchError, Raised, Stopped, Undecided, Exhausted, SyntaxError, RecursionError) as error:
            raise NotDescribedError(str(error) or type(error).__name__) from None
        lost = [problem.message for problem in state.problems if problem.kind == "python"]
        if lost:
            raise NotDescribedError(lost[0])
        return json.dumps({"launch_description": document}, ensure_ascii=False) + "\n"


class _Configurations(dict[str, str]):
    """The configurations that functions of a launch file ask for: each has a value, of which only the name is known."""

    def __init__(self, unknowns: Unknowns) -> None:
        super().__init__()
        self._unknowns = unknowns
        self.names: dict[str, str] = {}

    def __contains__(self, _name: object) -> bool:
        return True

    def __missing__(self, name: str) -> str:
        self[name] = mark = self._unknowns.mark(f"$(var {name})", "described", name)
        self.names[mark] = name
        return mark


class _Writer:
    """Writes the parts of one description."""

    def __init__(self, world: World, path: str, shared: re.Pattern[str], names: Mapping[str, str]) -> None:
        self.world, self.unknowns = world, world.state.unknowns
        self.shared, self.names = shared, names
        self.configurations = _Configurations(self.unknowns)
        self.context = Context(path, self.configurations)

    def document(self, value: Any) -> Any:
        """The document of a value."""
        match value:
            case Made("OpaqueFunction"):
                return self._opaque(value)
            case Made():
                given = {name: self.document(one) for name, one in value.arguments.items() if one is not None and name not in _PROSE}
                rest = {"rest": [self.document(one) for one in value.rest]} if value.rest else {}
                return {"is": value.kind, "line": value.place.line, **({"with": given} if given else {}), **rest}
            case Instance() if value.made is not None and not _does_more(value.of):
                return self.document(value.made)
            case Instance() if (known := known_class(value.of)) is not None:
                return {"new": value.of.name, "of": known, "with": {name: self.document(one) for name, one in value.attributes.items()}}
            case Either():
                return self._either(value)
            case PathText():
                return self.document(value.text)
            case str():
                parts = list(self._parts(value))
                return parts[0] if len(parts) == 1 else parts
            case list() | tuple():
                return [self.document(one) for one in value]
            case set() | frozenset():
                return [self.document(one) for one in in_order(value)]
            case dict():
                return {"pairs": [[self.document(name), self.document(one)] for name, one in value.items()]}
            case None | bool() | int() | float():
                return value
            case Unknown():
                return {"?": self.unknowns.render(value.text)}
        return {"?": type(value).__name__.lower()}

    def _opaque(self, made: Made) -> Any:
        """What a function that gets the context returns, by the names of the configurations that it asks for."""
        given, named = made.arguments.get("args") or (), made.arguments.get("kwargs") or {}
        found = called(self.world, made.get("function"), [self.context, *given], dict(named))
        condition = made.arguments.get("condition")
        if condition is None:
            return self.document(found)
        actions = {"actions": self.document(found), "scoped": False, "condition": self.document(condition)}
        return {"is": "GroupAction", "line": made.place.line, "with": actions}

    def _either(self, value: Either) -> Any:
        """One of two values: actions as groups under a condition, others as a substitution."""
        test = self._test(value.condition.formula)
        if test is None:
            return {"?": self.unknowns.render(value.condition.text)}
        expression = {"is": "PythonExpression", "line": 1, "with": {"expression": test}}
        both = (("IfCondition", value.first), ("UnlessCondition", value.second))
        if not any(_has_actions(one) for _, one in both):
            parts = {"if_value": self.document(value.first), "else_value": self.document(value.second)}
            return {"is": "IfElseSubstitution", "line": 1, "with": {"condition": expression, **parts}}
        groups = []
        for kind, one in both:
            condition = {"is": kind, "line": 1, "with": {"predicate_expression": expression}}
            actions = [] if one is None or one is NOTHING else self.document(one)
            groups.append({"is": "GroupAction", "line": 1, "with": {"actions": actions, "scoped": False, "condition": condition}})
        return groups

    def _test(self, formula: Formula) -> list[Any] | None:
        """A formula as an expression of Python; None when it is about more than texts."""
        match formula:
            case Test(subject, value, False) if isinstance(value, str | None) and not {"'", "\\", "\n"} & {*subject, *(value or "")}:
                text = ["'", *self._parts(subject), "'"] if subject else ["''"]
                return [one for each in (("true", "True", "1") if value is None else (value,)) for one in (*text, f" == '{each}'", " or ")][
                    :-1
                ]
            case Not(of):
                inner = self._test(of)
                return None if inner is None else ["(not (", *inner, "))"]
            case Every(parts) | Some(parts):
                tests = [self._test(part) for part in parts]
                word = " and " if isinstance(formula, Every) else " or "
                known = [[word, "(", *test, ")"] for test in tests if test is not None]
                if len(known) < len(tests):
                    return None
                return [one for test in known for one in test][1:] or [str(isinstance(formula, Every))]
        return None

    def _parts(self, text: str) -> Iterator[Any]:
        """A text, with the folders of packages and what is not known as substitutions."""
        end = 0
        for match in self.shared.finditer(text):
            if match.start() > end:
                yield text[end : match.start()]
            end = match.end()
            name = self.configurations.names.get(match[3]) if match[3] else None
            if name is not None:
                yield {"is": "LaunchConfiguration", "line": 1, "with": {"variable_name": name}}
            elif match[3]:
                text_of = self.unknowns.render(match[3])
                variable = _VARIABLE.fullmatch(text_of)
                yield {"is": "EnvironmentVariable", "line": 1, "with": {"name": variable[1]}} if variable else {"?": text_of}
            else:
                yield {"is": "FindPackageShare", "line": 1, "with": {"package": self.names.get(match[1], match[2])}}
        if end < len(text) or not text:
            yield text[end:]


def _does_more(of: Class) -> bool:
    """Whether objects of a class of a launch file do what those of the class of launch that it is derived from do not."""
    return any(name in one.members for one in (of, *of.bases) if isinstance(one, Class) for name in ("execute", "visit", "perform"))


def _has_actions(value: Any) -> bool:
    """Whether a value is carried out, as a whole or in parts."""
    if isinstance(value, (list, tuple)):
        return any(map(_has_actions, value))
    if isinstance(value, Either):
        return _has_actions(value.first) or _has_actions(value.second)
    return isinstance(value, Made) and value.kind in _ACTIONS


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
        given.update((name, list(_flat(given[name]))) for name in _WITH_ACTIONS & given.keys())
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


_WITH_ACTIONS = frozenset({"initial_entities", "actions", "on_exit", "on_start", "on_completion", "entities"})


def _flat(actions: Any) -> Iterator[Any]:
    """Actions without the lists that stand for those that a function returns."""
    for one in actions if isinstance(actions, list) else [actions]:
        if isinstance(one, list):
            yield from _flat(one)
        elif one is not None:
            yield one


def _key(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value
