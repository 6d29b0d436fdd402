"""Run CMake files without CMake: scopes, control flow, procedures, sub-directories.

Source: cmake-language(7), cmake-commands(7). Nothing outside the evaluator's memory changes, no program is started, and what a
command would learn from the machine is assumed (`options`). Commands are functions in `commands_*`, found through `COMMANDS`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import NoReturn, Protocol

from rosarch.base import tracing
from rosarch.base.diagnostics import Diagnostic, unreadable, why
from rosarch.base.files import read_file
from rosarch.extractor.workspace import cmake_loops
from rosarch.extractor.workspace.cmake_conditions import ConditionError, Word
from rosarch.extractor.workspace.cmake_conditions import evaluate as condition_holds
from rosarch.extractor.workspace.cmake_expand import expand, join_list, split_list
from rosarch.extractor.workspace.cmake_limits import ELEMENT, MAX_DEPTH, MAX_TEXT, MAX_VALUE, MAX_WORDS, OutOfTime, time_limit
from rosarch.extractor.workspace.cmake_questions import cmake_environment
from rosarch.extractor.workspace.cmake_state import (
    Call,
    Directory,
    PackageDraft,
    Procedure,
    Scope,
    StopAll,
    StopFile,
    StopLoop,
    TargetDraft,
)
from rosarch.extractor.workspace.cmake_syntax import Argument, Block, Branch, Command, If, Statement, blocks, parse
from rosarch.extractor.workspace.installs import Unsure
from rosarch.extractor.workspace.model import BuildCall
from rosarch.extractor.workspace.options import Options, initial_cache, initial_environment, initial_variables, versions

Handler = Callable[["Evaluator", Call], None]
COMMANDS: dict[str, Handler] = {}
UNKNOWN_COMMAND = ""  # the handler of commands that nothing defines
INSTALLING = frozenset(
    {"install", "catkin_install_python", "ament_auto_package", "ament_python_install_package", "add_subdirectory", "subdirs", "include"}
)
"""The commands that copy something to where it is installed, or run files that may do so."""
_KEPT = frozenset(
    {"project", "rosidl_generate_interfaces", "add_message_files", "add_service_files", "add_action_files", "generate_messages"}
    | {"catkin_python_setup", "ament_package", "ament_auto_package", "ament_target_dependencies", "ament_auto_find_build_dependencies"}
    | {"rosidl_get_typesupport_target", "rosidl_target_interfaces", "catkin_package", "generate_dynamic_reconfigure_options"}
)
"""The commands by which a build makes and registers something: claims about that rest on them."""
_REFERENCE = re.compile(r"\$\{([\w.+-]+)\}")
_ENVIRONMENT = re.compile(r"\$ENV\{(\w+)\}|DEFINED ENV\{(\w+)\}")


class World(Protocol):
    """What the evaluator may ask about other packages of the workspace."""

    def find(self, name: str) -> PackageDraft | None:
        """What the workspace package `name` exports, its CMake files evaluated; None when it is not in the workspace."""

    def path(self, name: str) -> str | None:
        """The folder of the workspace package `name`."""


def command(*names: str) -> Callable[[Handler], Handler]:
    """Register a handler for CMake commands."""

    def register(handler: Handler) -> Handler:
        for name in names:
            COMMANDS[name] = handler
        return handler

    return register


class Evaluator:
    """One package's CMake files, from its top-level `CMakeLists.txt` on."""

    def __init__(self, package: str, folder: str, root: str, options: Options, world: World) -> None:
        distro = options.ros_distro or "kinetic"
        self.package = package
        self.root = root
        self.folder = folder
        self.build = f"{folder}/.rosarch-build"
        self.options = options
        self.world = world
        self.versions = versions(distro)
        self.scope = Scope()
        self.scope.variables.update(initial_variables(distro, self.build))
        self.cache: dict[str, str] = initial_cache(distro, options.defines)
        self.prefix = self.cache["CMAKE_INSTALL_PREFIX"]
        self.environment = initial_environment(distro) | dict(options.environment)
        self.directory = Directory(folder, self.build, frozenset({os.path.realpath(folder)}))
        self.targets: dict[str, TargetDraft] = {}
        self.aliases: dict[str, str] = {}
        self.procedures: dict[str, Procedure] = {}
        self.generated: set[str] = set()
        self.draft = PackageDraft()
        self.diagnostics: list[Diagnostic] = []
        self.file = f"{folder}/CMakeLists.txt"
        self.made_before = 0
        self.found_packages: set[str] = set()
        self.testing = 0
        self.excluded = 0
        self.manifest_depends: list[str] = []
        self.depth = 0
        self.words = 0
        self.characters = 0
        self.current: tuple[str, Command] | None = None
        self.global_properties: dict[str, str] = {}
        self.included: set[str] = set()
        self.around = cmake_environment(self)

    # -- values ---------------------------------------------------------------------------------------------------------------

    @property
    def project(self) -> str:
        """The name of the current project."""
        return self.get("PROJECT_NAME") or self.package

    def get(self, name: str) -> str | None:
        """A variable's value: normal, then cache."""
        value = self.scope.variables.get(name)
        return self.cache.get(name) if value is None else value

    def set(self, name: str, value: str) -> None:
        """Set a normal variable."""
        self.charge(len(value) - len(self.scope.variables.get(name, "")), len(value))
        self.scope.variables[name] = value

    def assume(self, name: str, value: str) -> None:
        """Set what the machine would have answered, unless the user's `defines` say otherwise."""
        self.scope.variables[name] = self.options.defines.get(name, value)

    def elements(self, name: str) -> list[str]:
        """A variable's elements."""
        return split_list(self.get(name) or "")

    def lookup(self, kind: str, name: str) -> str:
        """The value of a reference."""
        if kind == "ENV":
            value = self.environment.get(name)
        elif kind == "CACHE":
            value = self.cache.get(name)
        else:
            value = (self.location(name) if name.startswith("CMAKE_CURRENT_") else None) or self.get(name)
        self.charge(len(value or ""))
        return value or ""

    def location(self, name: str) -> str | None:
        """The variables that say where evaluation is."""
        if name == "CMAKE_CURRENT_SOURCE_DIR":
            return self.directory.source
        if name == "CMAKE_CURRENT_BINARY_DIR":
            return self.directory.binary
        if name == "CMAKE_CURRENT_LIST_FILE":
            return self.file
        if name == "CMAKE_CURRENT_LIST_DIR":
            return os.path.dirname(self.file)
        return None

    def expand_all(self, arguments: Sequence[Argument]) -> list[str]:
        """Arguments as a command sees them."""
        self.count(len(arguments))
        result: list[str] = []
        for argument in arguments:
            if argument.plain or argument.raw:
                result.append(argument.text)
            elif argument.quoted:
                result.append(self.expanded(argument))
            else:
                result.extend(self.expanded_list(argument))
        return result

    def expanded(self, argument: Argument) -> str:
        """An argument with its references replaced."""
        text = expand(argument.text, self.lookup)
        if text is not argument.text:
            self.count(1)  # references and escapes take as long as another word
        self.charge(0, len(text))
        return text

    def expanded_list(self, argument: Argument) -> list[str]:
        """The elements that an unquoted argument stands for."""
        elements = split_list(self.expanded(argument))
        self.charge(ELEMENT * len(elements))
        return elements

    def source_path(self, name: str) -> str:
        """`name` relative to the current source directory."""
        return os.path.normpath(os.path.join(self.directory.source, name))

    def binary_path(self, name: str) -> str:
        """`name` relative to the current binary directory."""
        return os.path.normpath(os.path.join(self.directory.binary, name))

    # -- reports --------------------------------------------------------------------------------------------------------------

    def complain(self, command: Command, kind: str, message: str) -> None:
        """Record a diagnostic at a command."""
        self.diagnostics.append(Diagnostic(kind, Path(self.file), command.line, command.column, message))

    def cannot_read(self, command: Command, path: str, error: OSError) -> None:
        """Record that a command could not read a file or folder that is there."""
        shown = os.path.relpath(path, self.directory.source)
        self.complain(command, "unreadable", f"{command.written}: {shown} cannot be read: {why(error)}")

    def unsure(self, reason: str, line: int) -> None:
        """Record that more may be installed than is known, because of what is at a line of the current file."""
        self.draft.unsure.append(Unsure(reason, Path(self.file), line))

    def has_unset(self, command: Command) -> bool:
        """Whether arguments of a command refer to variables that nothing has set."""
        texts = (argument.text for argument in command.arguments if not argument.raw)
        return any(not self.lookup("", name) for text in texts for name in _REFERENCE.findall(text))

    def charge(self, made: int, length: int = 0) -> None:
        """Count `made` characters that a command makes; give up when these are too many, or a value of `length` is too long."""
        self.characters += max(made, 0)
        if length > MAX_VALUE:
            self.give_up(f"a value of more than {MAX_VALUE} characters")
        if self.characters > MAX_TEXT:
            self.give_up(f"more than {MAX_TEXT} characters of values")

    def count(self, words: int) -> None:
        """Count commands, arguments and words of conditions that are evaluated; give up when these are too many."""
        self.words += words
        if self.words > MAX_WORDS:
            self.give_up(f"more than {MAX_WORDS} conditions, commands and arguments")

    def give_up(self, reason: str) -> NoReturn:
        """Record a limit that was reached at the current command, and stop the evaluation."""
        self.stopped(reason)
        raise StopAll

    def stopped(self, reason: str) -> None:
        """Record why the evaluation ends at the current command."""
        place = (Path(self.current[0]), self.current[1].line, self.current[1].column) if self.current else (Path(self.file), 1, 1)
        self.diagnostics.append(Diagnostic("cmake-limit", *place, f"{reason}, evaluation stopped"))

    # -- running --------------------------------------------------------------------------------------------------------------

    def run_top(self) -> None:
        """Evaluate the package from its top-level file."""
        self.set("CMAKE_SOURCE_DIR", self.folder)
        self.set("CMAKE_BINARY_DIR", self.build)
        self.set("CMAKE_HOME_DIRECTORY", self.folder)
        try:
            with time_limit(self.options.timeout):
                self.run_file(self.file)
        except StopAll:
            pass
        except RecursionError:
            self.stopped("CMake code nests too deeply")
        except OutOfTime:
            self.stopped(f"not done after {self.options.timeout:g} s")

    def run_file(self, file: str) -> None:
        """Evaluate a file in the current scope."""
        statements = self.load(file)
        if statements is None:
            return
        previous = self.file, self.made_before
        self.file, self.made_before = file, len(self.targets)
        self.enter()
        try:
            self.run(statements)
        except (StopFile, StopLoop):
            self.unsure("return() before the end", self.current[1].line if self.current else 1)
        finally:
            self.file, self.made_before = previous
            self.depth -= 1

    def load(self, file: str) -> tuple[Statement, ...] | None:
        """The statements of a file, None when it cannot be read; bytes that are not UTF-8, and zeros, are replaced. All is reported."""
        try:
            data = read_file(file)
        except OSError as error:
            self.diagnostics.append(unreadable(file, error))
            return None
        if (damage := _damage(data)) is not None:
            start, message = damage
            line = data.count(b"\n", 0, start) + 1
            column = start - (data.rfind(b"\n", 0, start) + 1) + 1
            self.diagnostics.append(Diagnostic("encoding", Path(file), line, column, message))
        text = decoded(data)
        commands, syntax = parse(text, Path(file))
        statements, structure = blocks(commands, Path(file))
        self.diagnostics.extend(syntax or structure)
        return statements

    def enter(self) -> None:
        """Go one level deeper into files and procedures."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            self.give_up("CMake code nests too deeply")

    def run(self, statements: Sequence[Statement]) -> None:
        """Evaluate statements in order."""
        for statement in statements:
            self.count(1)
            if isinstance(statement, Command):
                self.run_command(statement)
            elif isinstance(statement, If):
                self.run_if(statement)
            else:
                self.run_block(statement)

    def run_if(self, statement: If) -> None:
        """The first branch whose condition holds. A test-only branch makes its targets tests.

        Where none holds, that counts for which the user sets an environment variable. A branch that leaves a `CMakeLists.txt` before it
        makes any target does so because of what this machine lacks, or because it builds other packages first and itself after these: the
        rest counts, and so do the branches behind it.
        """
        self._run_branches(statement.branches)

    def _run_branches(self, branches: Sequence[Branch]) -> None:
        chosen = next((one for one in branches if one.condition is None or self.holds(one.condition)), None)
        chosen = chosen or next((one for one in branches if one.condition is not None and self._is_unset(one.condition)), None)
        self._leave_out(other for other in branches if other is not chosen)
        if chosen is None:
            return
        testing = chosen.condition is not None and _asks_for_tests(chosen.condition)
        self.testing += testing
        try:
            self.run(chosen.body)
        except StopFile:
            if not self._leaves_nothing():
                raise
            self._run_branches(branches[branches.index(chosen) + 1 :])
        finally:
            self.testing -= testing

    def _is_unset(self, condition: Command) -> bool:
        """Whether a condition asks only for an environment variable, of which nothing is known."""
        found = _ENVIRONMENT.fullmatch(" ".join(argument.text for argument in condition.arguments))
        return found is not None and (found.group(1) or found.group(2)) not in self.environment

    def _leave_out(self, branches: Iterable[Branch]) -> None:
        """Note what branches that do not count here may install elsewhere."""
        for branch in branches:
            if branch.condition is None or not _asks_for_tests(branch.condition):
                self.leave_out(branch.body)

    def leave_out(self, body: Sequence[Statement]) -> None:
        """Note that statements that are not run may install something."""
        for found in _commands(body):
            if found.name in INSTALLING or found.name in self.procedures or found.name not in COMMANDS:
                self.unsure(f"{found.written}() under a condition", found.line)
            if found.name in _KEPT:
                self._keep(found, (), is_known=False)

    def _keep(self, command: Command, words: Iterable[str], *, is_known: bool) -> None:
        """Keep a command of those that the build rests on."""
        self.draft.calls.append(BuildCall(command.name, tuple(words), Path(self.file), command.line, is_known))

    def _leaves_nothing(self) -> bool:
        """Whether the file that a `return()` leaves is one of the package's build, and no target of it is made so far."""
        in_function = self.get("CMAKE_CURRENT_FUNCTION") is not None
        return not in_function and os.path.basename(self.file) == "CMakeLists.txt" and len(self.targets) == self.made_before

    def holds(self, command: Command) -> bool:
        """Evaluate the condition of `if`, `elseif`, `while`. What cannot be understood is false."""
        self.current = self.file, command
        if self._is_unset(command):
            return False
        words: list[Word] = []
        for argument in command.arguments:
            if argument.quoted:
                words.append(Word(argument.text if argument.raw else self.expanded(argument), True))
            elif argument.plain:
                words.append(Word(argument.text, False))
            else:
                words.extend(Word(text, False) for text in self.expanded_list(argument))
        self.count(2 * len(words) + 1)  # to decide about a word of a condition costs more than to pass an argument
        try:
            return condition_holds(words, self.around)
        except ConditionError as error:
            self.complain(command, "cmake-condition", str(error))
            return False

    def run_block(self, block: Block) -> None:
        """A loop, or the definition of a procedure."""
        opener = block.opener
        self.current = self.file, opener
        if opener.name in ("function", "macro"):
            words = self.expand_all(opener.arguments)
            if words:
                procedure = Procedure(words[0], opener.name == "macro", tuple(words[1:]), block.body, self.file)
                self.procedures[words[0].lower()] = procedure
        elif opener.name == "foreach":
            if self.has_unset(opener):
                self.leave_out(block.body)
            cmake_loops.run_foreach(self, block)
        elif opener.name == "while":
            cmake_loops.run_while(self, block)
        else:
            self.run(block.body)

    def run_command(self, command: Command) -> None:
        """One command: a procedure of the files, else a known command, else a diagnostic."""
        self.current = self.file, command
        procedure = self.procedures.get(command.name)
        if procedure is not None:
            cmake_loops.call_procedure(self, procedure, self.expand_all(command.arguments))
            return
        handler = COMMANDS.get(command.name, COMMANDS[UNKNOWN_COMMAND])
        try:
            words = self.expand_all(command.arguments)
            if command.name in _KEPT:
                self._keep(command, words, is_known=not self.has_unset(command))
            handler(self, Call(command, words, self.file))
        except (IndexError, ValueError, ArithmeticError, OSError) as error:
            self.complain(command, "cmake-arguments", f"{command.written}: {error}")

    # -- conditions -----------------------------------------------------------------------------------------------------------

    def is_command(self, name: str) -> bool:
        """Whether there is a command or procedure of this name."""
        return name.lower() in self.procedures or name.lower() in COMMANDS

    def is_outside(self, path: str) -> bool:
        """Whether `path` is on the machine rather than in the workspace."""
        tracing.probe(path)  # with `..` in it, it may only look as if it lay in the workspace
        return os.path.isabs(path) and not path.startswith(self.root + "/") and path != self.root

    def exists(self, path: str) -> bool:
        """Files of the workspace exist or not; what lies elsewhere on the machine is assumed to be installed."""
        if not path or path.startswith(self.build):
            return path in self.generated
        if self.is_outside(path):
            return path != "/"
        return os.path.exists(path if os.path.isabs(path) else self.source_path(path))

    def set_matches(self, groups: Sequence[str]) -> None:
        """`CMAKE_MATCH_<n>` after a regular expression matched."""
        for index, group in enumerate(groups):
            self.set(f"CMAKE_MATCH_{index}", group)
        self.set("CMAKE_MATCH_COUNT", str(max((index for index, group in enumerate(groups) if group), default=0)))

    def set_list(self, name: str, elements: Sequence[str]) -> None:
        """Set a variable to a list."""
        self.set(name, join_list(elements))


def decoded(data: bytes) -> str:
    """The text of a file. What is not UTF-8 is replaced, and so are zeros: no name of a file may have one."""
    return data.decode(errors="replace").replace("\0", "\N{REPLACEMENT CHARACTER}")


def _damage(data: bytes) -> tuple[int, str] | None:
    """Where a file is first no text, and why."""
    zero = data.find(b"\0")
    try:
        data.decode()
    except UnicodeDecodeError as error:
        if zero < 0 or error.start < zero:
            return error.start, "not UTF-8"
    return None if zero < 0 else (zero, "a zero byte")


def _commands(body: Sequence[Statement]) -> Iterator[Command]:
    """The commands in statements, at any depth but in procedures."""
    for statement in body:
        if isinstance(statement, Command):
            yield statement
        elif isinstance(statement, If):
            for branch in statement.branches:
                yield from _commands(branch.body)
        elif statement.opener.name not in ("function", "macro"):
            yield from _commands(statement.body)


def _asks_for_tests(condition: Command) -> bool:
    words = [argument.text for argument in condition.arguments]
    return "NOT" not in words and any("ENABLE_TESTING" in word or "BUILD_TEST" in word for word in words)
