"""Texts of XML and YAML launch files, and of parameter files, with substitutions in them: `$(var name)`.

Source: launch.frontend's grammar: arguments are separated by spaces, may be quoted, and may hold substitutions.
"""

from __future__ import annotations

import re
from typing import Any

from rosarch.base.diagnostics import shortened
from rosarch.extractor.launch.model import LaunchError, Place
from rosarch.extractor.launch_ros2.values import Made

MAX_DEPTH = 40
_NAMED: dict[str, tuple[str, tuple[str, ...]]] = {
    "var": ("LaunchConfiguration", ("variable_name", "default")),
    "env": ("EnvironmentVariable", ("name", "default_value")),
    "optenv": ("EnvironmentVariable", ("name", "default_value")),
    "find-pkg-share": ("FindPackageShare", ("package",)),
    "find-pkg-prefix": ("FindPackagePrefix", ("package",)),
    "exec-in-pkg": ("ExecutableInPackage", ("executable", "package")),
    "exec-in-package": ("ExecutableInPackage", ("executable", "package")),
    "find-exec": ("FindExecutable", ("name",)),
    "dirname": ("ThisLaunchFileDir", ()),
    "filename": ("ThisLaunchFile", ()),
    "anon": ("AnonName", ("name",)),
    "eval": ("PythonExpression", ("expression",)),
    "command": ("Command", ("command", "on_stderr")),
    "file-content": ("FileContent", ("path",)),
    "not": ("NotSubstitution", ("value",)),
    "bool": ("BooleanSubstitution", ("value",)),
    "and": ("AndSubstitution", ("left", "right")),
    "or": ("OrSubstitution", ("left", "right")),
    "equals": ("EqualsSubstitution", ("left", "right")),
    "not-equals": ("NotEqualsSubstitution", ("left", "right")),
    "if": ("IfElseSubstitution", ("condition", "if_value", "else_value")),
    "param": ("Parameter", ("name", "default")),
    "for-var": ("ForEachVar", ("name", "default_value")),
    "index": ("ForLoopIndex", ("name",)),
    "ros_log_dir": ("LaunchLogDir", ()),
    "launch_log_dir": ("LaunchLogDir", ()),
    "log_dir": ("LaunchLogDir", ()),
}
_REFUSED = frozenset({"any", "all"})
"""What launch has under a name for front ends, but cannot make: it hands the arguments over by a keyword that the class does not take."""
_PLAIN = {ends: re.compile(rf"[^\\${re.escape(ends)}]+") for ends in ("", '"', "'", " \t\r\n)")}
"""What ends before a character that may mean something, in a text that some characters end."""
_PATHS = {"path-join": ("PathJoinSubstitution", "substitutions"), "string-join": ("StringJoinSubstitution", "substitutions")}


def parsed(text: str, place: Place) -> list[Any]:
    """The substitutions of a text and the texts between them.

    Raises:
        LaunchError: a substitution is not closed, or there is no such one.
    """
    return _Parser(text, place).parts(0, "")[0]


class _Parser:
    def __init__(self, text: str, place: Place) -> None:
        self.source, self.place, self.depth = text, place, 0

    def parts(self, index: int, ends: str) -> tuple[list[Any], int]:
        """Texts and substitutions up to one of the characters `ends`, or to the end of the text."""
        found: list[Any] = []
        plain: list[str] = []
        text, run = self.source, _PLAIN[ends]
        while index < len(text) and not (ends and text[index] in ends):
            if match := run.match(text, index):
                plain.append(match.group())
                index = match.end()
            elif text[index] == "\\" and index + 1 < len(text) and text[index + 1] in "$\"'\\)":
                plain.append(text[index + 1])
                index += 2
            elif text.startswith("$(", index):
                if plain:
                    found.append("".join(plain))
                    plain.clear()
                made, index = self.substitution(index + 2)
                found.append(made)
            else:
                plain.append(text[index])
                index += 1
        if plain:
            found.append("".join(plain))
        return found, index

    def substitution(self, index: int) -> tuple[Made, int]:
        """What follows `$(`, up to its `)`."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise LaunchError("substitution", "$(", "substitutions nested too deeply")
        arguments: list[list[Any]] = []
        text = self.source
        while True:
            while index < len(text) and text[index].isspace():
                index += 1
            if index >= len(text):
                raise LaunchError("substitution", text, f"`$(` is not closed: {shortened(text)}")
            if text[index] == ")":
                break
            if text[index] in "\"'":
                quote = text[index]
                part, index = self.parts(index + 1, quote)
                index += 1
            else:
                part, index = self.parts(index, " \t\r\n)")
            arguments.append(part)
        self.depth -= 1
        return self.made(arguments), index + 1

    def made(self, arguments: list[list[Any]]) -> Made:
        """A substitution by its name and arguments."""
        name = arguments[0][0] if arguments and len(arguments[0]) == 1 and isinstance(arguments[0][0], str) else ""
        values: list[Any] = arguments[1:]
        if name in _REFUSED:
            raise LaunchError("substitution", name, f"$({name} ...) fails in launch files in XML and YAML: use `and` and `or`")
        if name in _PATHS:
            kind, parameter = _PATHS[name]
            return Made(kind, {parameter: values}, self.place)
        if name not in _NAMED:
            raise LaunchError("substitution", name, f"unknown substitution $({name or '...'})")
        kind, names = _NAMED[name]
        given = dict(zip(names, values, strict=False))
        if name == "eval" and len(values) > 2:
            raise LaunchError("substitution", name, "the expression of $(eval) must be quoted when it has spaces")
        if name == "optenv":
            given.setdefault("default_value", "")
        return Made(kind, given, self.place)
