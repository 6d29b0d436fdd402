"""`compile_commands.json`: how a build, complete or not, compiled the sources. Several files are merged.

Source: https://clang.llvm.org/docs/JSONCompilationDatabase.html. A command says more than CMake files can be read to say: the folders of
installed headers and the definitions that `find_package` made. Sources that no command compiles are read as without a build.
"""

from __future__ import annotations

import json
import os
import shlex
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rosarch.base import tracing
from rosarch.base.diagnostics import Diagnostic
from rosarch.base.files import read_file

NAME = "compile_commands.json"
DEPTH = 4  # build/compile_commands.json, build/<package>/..., build_isolated/<package>/..., .private/<package>/build
_GENERATED = frozenset({"build", "build_isolated", "devel", "devel_isolated", "install", "install_isolated"})
_FOLDERS = ("-isystem", "-iquote", "-idirafter", "-I")


@dataclass(frozen=True)
class CompileCommand:
    """One compilation: `include_dirs` belong to the sources of the workspace, `installed` are all other existing folders of headers."""

    source: Path
    output: str
    include_dirs: tuple[Path, ...]
    installed: tuple[Path, ...]
    definitions: tuple[str, ...]


@dataclass(frozen=True)
class CompileCommands:
    """The commands of all files that were found, by source."""

    by_source: dict[Path, tuple[CompileCommand, ...]] = field(default_factory=dict)
    files: tuple[Path, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()

    def find(self, source: Path, target: str) -> CompileCommand | None:
        """How `source` is compiled for `target`; for another target when only that was built."""
        commands = self.by_source.get(Path(os.path.realpath(source)), ()) if self.by_source else ()
        return next((command for command in commands if f"/{target}.dir/" in f"/{command.output}"), commands[0] if commands else None)


def read_compile_commands(root: Path) -> CompileCommands:
    """The commands in all `compile_commands.json` files at most `DEPTH` folders below `root`. A broken file costs that file."""
    found: dict[Path, list[CompileCommand]] = {}
    problems: list[Diagnostic] = []
    files = _files(root)
    for path in files:
        try:
            entries = json.loads(read_file(path).decode("utf-8"))
            if not isinstance(entries, list):
                raise ValueError("not a list of commands")
        except (OSError, ValueError, RecursionError) as error:
            line = getattr(error, "lineno", 1)
            problems.append(
                Diagnostic("compile-commands", path, line, getattr(error, "colno", 1), f"not read: {getattr(error, 'msg', error)}")
            )
            continue
        for number, entry in enumerate(entries, 1):
            command = _command(entry, root)
            if command is None:
                problems.append(Diagnostic("compile-commands", path, 1, 1, f"entry {number} names no file and command"))
            elif command not in found.setdefault(command.source, []):
                found[command.source].append(command)
    return CompileCommands({source: tuple(commands) for source, commands in found.items()}, tuple(files), tuple(problems))


def _files(root: Path) -> list[Path]:
    """The files below `root`, links to folders not followed."""
    found: list[Path] = []
    for folder, folders, names in os.walk(root):
        depth = len(Path(folder).relative_to(root).parts)
        folders[:] = sorted(name for name in folders if not (name.startswith(".") and name != ".private")) if depth < DEPTH else []
        if NAME in names:
            found.append(Path(folder) / NAME)
    unique = {os.path.realpath(path): path for path in reversed(found)}  # a link at the top to the one of the build
    return sorted(unique.values())


def _command(entry: Any, root: Path) -> CompileCommand | None:
    if not isinstance(entry, dict) or not isinstance(entry.get("file"), str):
        return None
    words = entry.get("arguments")
    if words is None and isinstance(entry.get("command"), str):
        try:
            words = shlex.split(entry["command"])
        except ValueError:
            return None
    if not isinstance(words, list) or not all(isinstance(word, str) for word in words):
        return None
    base = Path(str(entry.get("directory", ".")))
    tracing.probe(base / entry["file"])
    folders, definitions, output = _arguments(words, base)
    own = [folder for folder in folders if _is_source_folder(folder, root)]
    return CompileCommand(
        source=Path(os.path.realpath(base / entry["file"])),
        output=str(entry.get("output", output)),
        include_dirs=tuple(own),
        installed=tuple(folder for folder in folders if folder not in own),
        definitions=tuple(definitions),
    )


def _arguments(words: Iterable[str], base: Path) -> tuple[list[Path], list[str], str]:
    """Folders of headers that exist, definitions, the output."""
    folders: dict[Path, None] = {}
    definitions: dict[str, None] = {}
    output = ""
    rest = iter(words)
    for word in rest:
        flag = next((flag for flag in (*_FOLDERS, "-D", "-U", "-o") if word.startswith(flag)), "")
        if not flag:
            continue
        value = word[len(flag) :] or next(rest, "")
        if flag == "-o":
            output = value
        elif flag == "-D":
            definitions[value] = None
        elif flag == "-U":
            definitions = {name: None for name in definitions if name.partition("=")[0] != value}
        else:
            folder = Path(os.path.normpath(base / value))
            tracing.probe(folder)
            if os.path.isdir(folder):
                folders[folder] = None
    return list(folders), list(definitions), output


def _is_source_folder(folder: Path, root: Path) -> bool:
    """Whether a folder of headers is part of the sources rather than installed or generated."""
    return folder.is_relative_to(root) and not _GENERATED & set(folder.relative_to(root).parts)
