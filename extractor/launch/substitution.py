"""Substitution arguments: `$(arg x)`, `$(find p)`, `$(env V)`, `$(optenv V default)`, `$(anon n)`, `$(dirname)`, `$(eval e)`.

Follows roslaunch.substitution_args step by step: all commands but `find` are replaced first, each wherever its text stands, then `find`
with the path behind it.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from typing import Any, Protocol

from rosarch.base.diagnostics import shortened
from rosarch.extractor.launch.decisions import decision
from rosarch.extractor.launch.evaluation import EvalFailed, Evaluator, UnknownInvolved, Unsupported, evaluate, is_known_value
from rosarch.extractor.launch.model import LaunchError
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.launch.scope import Scope
from rosarch.extractor.launch.unknowns import Unknowns, cleaned, is_known
from rosarch.extractor.launch.values import automatic

COMMANDS = ("find", "env", "optenv", "dirname", "anon", "arg")
MAX_TEXT = 8 * 1024 * 1024  # characters of one resolved text: arguments that double each other grow without bound


class Composing(Protocol):
    """Receives what was absent, and how much text was made."""

    def report(self, error: LaunchError, fatal: bool = True) -> None:
        """Note a problem."""

    def spend(self, characters: int) -> None:
        """Count characters of a text that was made."""


class Resolver:
    """Resolves texts of one composition. What is absent is reported and stays an unknown part of the text."""

    def __init__(self, packages: PackagePath, environment: Mapping[str, str], unknowns: Unknowns, composing: Composing) -> None:
        self.packages = packages
        self.environment = _Cleaned(environment)
        self.unknowns = unknowns
        self.composing = composing
        self.report = composing.report

    def resolve(self, text: str, scope: Scope) -> str:
        """`text` with its substitution arguments replaced.

        Raises:
            LaunchError: a substitution argument is malformed, or an `eval` fails.
        """
        if "$" not in text:
            return text
        if text.startswith("$(eval ") and text.endswith(")"):
            return self._eval(text[7:-1], scope)
        for command in collect(text):
            name, *words = _words(command)
            if name not in COMMANDS:
                raise _malformed(f"unknown substitution command $({command}), known are {', '.join(COMMANDS)}")
            if name != "find":
                text = self._bounded(text.replace(f"$({command})", self._command(command, name, words, scope)))
        for command in collect(text):
            name, *words = _words(command)
            if name == "find":
                text = self._bounded(self._find(text, command, words))
        return text

    def _bounded(self, text: str) -> str:
        self.composing.spend(len(text))
        if len(text) > MAX_TEXT:
            raise LaunchError("size", "text", f"a text of more than {MAX_TEXT // 2**20} Mi characters after substitution")
        return text

    def _command(self, command: str, name: str, words: list[str], scope: Scope) -> str:
        if name == "dirname":
            return _folder(scope.filename)
        if not words:
            raise _malformed(f"$({command}) must name something")
        if name == "optenv":
            return self.environment.get(words[0], " ".join(words[1:]))
        if len(words) > 1:
            raise _malformed(f"$({command}) must have one argument only")
        return {"env": self._env, "anon": self._anon, "arg": self._arg}[name](words[0], scope)

    def _env(self, name: str, _scope: Scope) -> str:
        if name not in self.environment:
            self.report(LaunchError("env", name, f"environment variable `{name}` is not set"), True)
            return self.unknowns.mark(f"$(env {name})")
        return self.environment[name]

    def _anon(self, name: str, scope: Scope) -> str:
        if name not in scope.anonymous:
            scope.anonymous[name] = self.unknowns.fresh(name)
        return scope.anonymous[name]

    def _arg(self, name: str, scope: Scope) -> str:
        if name not in scope.args:
            self.report(LaunchError("arg", name, _missing(name, scope)), True)
            scope.args[name] = self.unknowns.mark(f"$(arg {name})", scope.filename)
        return scope.args[name]

    def _package(self, name: str) -> str:
        folder = self.packages.find(name)
        if folder is not None:
            return folder
        if is_known(name):
            self.report(LaunchError("package", name, f"package `{name}` is not on the package path"), True)
        return self.unknowns.mark(f"$(find {name})")

    def _find(self, text: str, command: str, words: list[str]) -> str:
        """Replace the first `$(find p)` and the path behind it, up to a space."""
        if len(words) != 1:
            raise _malformed(f"$({command}) must name one package")
        before, _, after = text.partition(f"$({command})")
        path, space, rest = after.partition(" ")
        path = path.replace("\\", "/").removeprefix("/")
        folder = self._package(words[0])
        return before + (os.path.join(folder, path) if path else folder) + space + rest

    def _eval(self, expression: str, scope: Scope) -> str:
        if "__" in expression:
            raise LaunchError("eval", expression, "$(eval) must not contain a double underscore")
        functions: dict[str, Callable[..., Any]] = {
            "arg": lambda name: automatic(self._arg(_name(name), scope)),
            "anon": lambda name: self._anon(_name(name), scope),
            "dirname": lambda: _folder(scope.filename),
            "env": lambda name: self._env(_name(name), scope),
            "find": lambda name: self._package(_name(name)),
            "optenv": lambda name, default="": self.environment.get(_name(name), default),
        }
        try:
            value = evaluate(expression, lambda name: self._eval_name(name, scope), functions)
        except EvalFailed as error:
            raise LaunchError("eval", expression, f"$(eval {shortened(expression)}): {error}") from None
        except Unsupported as error:
            self.report(LaunchError("eval-unsupported", expression, f"$(eval {shortened(expression)}) stays unknown: {error}"), False)
        except UnknownInvolved:
            pass
        else:
            if isinstance(value, str) or (is_known_value(value) and not isinstance(value, set)):  # the text of a set has no order
                return str(value)
        known = tuple(sorted(scope.args.items()))
        mark = self.unknowns.mark(f"$(eval {self.unknowns.render(expression)})", scope.filename, known)
        if mark not in self.unknowns.truths:
            self.unknowns.truths[mark] = decision(expression, Evaluator(lambda name: self._eval_name(name, scope), functions))
        return mark

    def _eval_name(self, name: str, scope: Scope) -> Any:
        """The value of an argument that an expression names like a variable."""
        if name not in scope.args and name in scope.declared:
            return self._arg(name, scope)
        return automatic(scope.args[name])


class _Cleaned(Mapping[str, str]):
    """Environment variables as texts may have them."""

    def __init__(self, variables: Mapping[str, str]) -> None:
        self._variables = variables

    def __getitem__(self, name: str) -> str:
        return cleaned(self._variables[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._variables)

    def __len__(self) -> int:
        return len(self._variables)


def collect(text: str) -> list[str]:
    """The commands in a text, without `$(` and `)`.

    Raises:
        LaunchError: a parenthesis or dollar sign stands where none may.
    """
    commands: list[str] = []
    state, start = "out", 0
    for index, character in enumerate(text):
        if character == "$":
            if state in ("open", "in"):
                raise _malformed(f"`$` within a substitution argument: {shortened(text)}")
            state = "dollar"
        elif character == "(":
            if state in ("open", "in"):
                raise _malformed(f"`(` within a substitution argument: {shortened(text)}")
            state = "open" if state == "dollar" else state
        elif character == ")":
            if state == "in":
                commands.append(text[start:index])
            state = "out"
        elif state == "dollar":
            state = "out"
        elif state == "open":
            state, start = "in", index
    return commands


def _words(command: str) -> list[str]:
    return [word for word in command.split(" ") if word] or [""]


def _missing(name: str, scope: Scope) -> str:
    if name in scope.declared:
        return f"argument `{name}` must be passed, it has no value"
    return f"argument `{name}` is not defined"


def _name(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"a name must be a text, not {type(value).__name__}")
    return value


def _folder(filename: str) -> str:
    return os.path.abspath(os.path.dirname(filename))


def _malformed(message: str) -> LaunchError:
    return LaunchError("substitution", message, message)
