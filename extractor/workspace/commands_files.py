"""CMake commands on files and folders: file, include, add_subdirectory, get_filename_component, configure_file, ..."""

from __future__ import annotations

import os
from functools import partial
from pathlib import Path

from rosarch.base.files import read_file
from rosarch.base.patterns import PatternError
from rosarch.extractor.workspace.cmake_glob import glob
from rosarch.extractor.workspace.cmake_state import Call, Scope
from rosarch.extractor.workspace.commands_values import truthy
from rosarch.extractor.workspace.evaluator import Evaluator, command, decoded

_GENERATING = {"WRITE", "APPEND", "GENERATE", "CONFIGURE", "TOUCH", "DOWNLOAD"}


@command("file")
def _file(run: Evaluator, call: Call) -> None:
    args = call.args
    if len(args) < 2:
        return
    action = args[0]
    if action in ("GLOB", "GLOB_RECURSE"):
        run.set_list(args[1], _globbed(run, call, args[2:], action == "GLOB_RECURSE"))
    elif action in ("READ", "STRINGS") and len(args) > 2:
        run.set(args[2], _read(run, call, args[1], action == "STRINGS"))
    elif action == "RELATIVE_PATH" and len(args) > 3:
        run.set(args[1], os.path.relpath(args[3] or "/", args[2] or "/"))
    elif action in ("TO_CMAKE_PATH", "TO_NATIVE_PATH") and len(args) > 2:
        run.set(args[2], args[1])
    elif action in ("REAL_PATH", "SIZE", "TIMESTAMP") and len(args) > 2:
        run.set(args[2], run.source_path(args[1]) if action == "REAL_PATH" else "0")
    elif action in _GENERATING:
        name = args[args.index("OUTPUT") + 1] if "OUTPUT" in args[:-1] else args[1]
        run.generated.add(run.binary_path(name))


def _globbed(run: Evaluator, call: Call, words: list[str], recurse: bool) -> list[str]:
    relative: str | None = None
    directories = not recurse
    patterns: list[str] = []
    position = 0
    while position < len(words):
        word = words[position]
        if word in ("RELATIVE", "LIST_DIRECTORIES") and position + 1 < len(words):
            position += 1
            if word == "RELATIVE":
                relative = words[position]
            else:
                directories = truthy(words[position])
        elif word not in ("FOLLOW_SYMLINKS", "CONFIGURE_DEPENDS"):
            patterns.append(word)
        position += 1
    found: list[str] = []
    for pattern in patterns:
        path = run.source_path(pattern)
        if not run.is_outside(path):
            try:
                found.extend(glob(path, recurse, directories, partial(run.cannot_read, call.command)))
            except PatternError as error:
                run.complain(call.command, "cmake-arguments", f"{call.command.written}: {error}")
    found = sorted(dict.fromkeys(found))
    return [os.path.relpath(path, relative) for path in found] if relative else found


def _read(run: Evaluator, call: Call, name: str, lines: bool) -> str:
    path = run.source_path(name)
    if run.is_outside(path):
        return ""
    try:
        run.charge(0, os.path.getsize(path))
        text = decoded(read_file(path))
    except OSError as error:
        if os.path.lexists(path):
            run.cannot_read(call.command, path, error)
        return ""
    return ";".join(line.replace(";", "\\;") for line in text.splitlines() if line) if lines else text


@command("aux_source_directory")
def _aux_source_directory(run: Evaluator, call: Call) -> None:
    if len(call.args) < 2:
        return
    folder = run.source_path(call.args[0])
    try:
        names = sorted(os.listdir(folder))
    except OSError as error:
        run.cannot_read(call.command, folder, error)
        names = []
    sources = [f"{call.args[0]}/{name}" for name in names if os.path.splitext(name)[1] in (".c", ".C", ".cc", ".cpp", ".cxx", ".c++")]
    run.set_list(call.args[1], sources)


@command("get_filename_component")
def _get_filename_component(run: Evaluator, call: Call) -> None:
    if len(call.args) < 3:
        return
    variable, path, mode = call.args[:3]
    base = path.rpartition("/")[2]
    dot = base.find(".", 1)
    stem, extension = (base[:dot], base[dot:]) if dot >= 0 else (base, "")
    last, last_extension = os.path.splitext(base)
    results = {
        "DIRECTORY": os.path.dirname(path),
        "PATH": os.path.dirname(path),
        "NAME": base,
        "NAME_WE": stem,
        "NAME_WLE": last,
        "EXT": extension,
        "LAST_EXT": last_extension,
        "PROGRAM": path,
    }
    if mode in ("ABSOLUTE", "REALPATH"):
        folder = call.args[call.args.index("BASE_DIR") + 1] if "BASE_DIR" in call.args[:-1] else run.directory.source
        results[mode] = os.path.normpath(os.path.join(folder, path))
    run.set(variable, results.get(mode, path))


@command("cmake_path")
def _cmake_path(run: Evaluator, call: Call) -> None:
    args = call.args
    if len(args) > 3 and args[0] == "GET" and args[2] in ("FILENAME", "STEM", "PARENT_PATH", "EXTENSION"):
        path = Path(run.get(args[1]) or "")
        parts = {"FILENAME": path.name, "STEM": path.stem, "PARENT_PATH": str(path.parent), "EXTENSION": path.suffix}
        run.set(args[-1], parts[args[2]])
    elif len(args) > 2 and args[0] == "SET":
        run.set(args[1], os.path.normpath(args[-1]))
    elif len(args) > 1 and args[0] in ("APPEND", "NORMAL_PATH"):
        run.set(args[1], os.path.normpath(os.path.join(run.get(args[1]) or "", *args[2:])))


_INSTALL_FOLDERS = {
    "BIN": "bin",
    "LIB": "lib",
    "LIBEXEC": "libexec",
    "INCLUDE": "include",
    "DATA": "share",
    "DATAROOT": "share",
    "SYSCONF": "etc",
}


@command("include")
def _include(run: Evaluator, call: Call) -> None:
    """Files of the workspace are evaluated; CMake's own modules are known through their commands."""
    if not call.args:
        return
    name = call.args[0]
    if name == "GNUInstallDirs":
        for variable, folder in _INSTALL_FOLDERS.items():
            run.set(f"CMAKE_INSTALL_{variable}DIR", folder)
    for path in _include_candidates(run, name):
        if not run.is_outside(path) and os.path.isfile(path):
            run.run_file(path)
            return
    if "OPTIONAL" in call.args or ("/" not in name and not name.endswith(".cmake")):
        return
    path = run.source_path(name)
    if not run.is_outside(path) and not path.startswith(run.build):
        run.complain(call.command, "missing-include", f"include file not found: {name}")


def _include_candidates(run: Evaluator, name: str) -> list[str]:
    modules = [os.path.join(run.source_path(folder), f"{name}.cmake") for folder in run.elements("CMAKE_MODULE_PATH")]
    return [run.source_path(name), *modules]


@command("add_subdirectory")
def _add_subdirectory(run: Evaluator, call: Call) -> None:
    if not call.args:
        return
    source = run.source_path(call.args[0])
    file = f"{source}/CMakeLists.txt"
    if run.is_outside(source) or not os.path.isfile(file):
        run.complain(call.command, "missing-subdirectory", f"no CMakeLists.txt in sub-directory {call.args[0]}")
        return
    real = os.path.realpath(source)
    if real in run.directory.real_paths:
        run.complain(call.command, "cyclic-subdirectory", f"sub-directory {call.args[0]} is or contains this one")
        return
    outer_scope, outer_directory = run.scope, run.directory
    binary = run.binary_path(call.args[1] if len(call.args) > 1 and call.args[1] != "EXCLUDE_FROM_ALL" else call.args[0])
    run.scope = Scope(outer_scope)
    run.directory = outer_directory.child(source, binary, real)
    excluded = "EXCLUDE_FROM_ALL" in call.args
    run.excluded += excluded
    try:
        run.run_file(file)
    finally:
        run.excluded -= excluded
        run.scope, run.directory = outer_scope, outer_directory


@command("subdirs")
def _subdirs(run: Evaluator, call: Call) -> None:
    for name in call.args:
        _add_subdirectory(run, Call(call.command, [name], call.file))


@command("configure_file")
def _configure_file(run: Evaluator, call: Call) -> None:
    if len(call.args) < 2:
        return
    template, output = run.source_path(call.args[0]), run.binary_path(call.args[1])
    run.generated.add(output)
    if os.path.isfile(template):
        run.draft.configured.append((template, output))


@command("add_custom_command")
def _add_custom_command(run: Evaluator, call: Call) -> None:
    collecting = False
    for word in call.args:
        if word in ("OUTPUT", "BYPRODUCTS"):
            collecting = True
        elif word in _CUSTOM_KEYWORDS:
            collecting = False
        elif collecting:
            run.generated.add(run.binary_path(word))


_CUSTOM_KEYWORDS = {
    "COMMAND", "MAIN_DEPENDENCY", "DEPENDS", "IMPLICIT_DEPENDS", "WORKING_DIRECTORY", "COMMENT", "VERBATIM", "APPEND", "TARGET",
    "PRE_BUILD", "PRE_LINK", "POST_BUILD", "ARGS", "DEPFILE", "USES_TERMINAL", "COMMAND_EXPAND_LISTS",
}  # fmt: skip


@command("execute_process", "exec_program")
def _execute_process(run: Evaluator, call: Call) -> None:
    """No program is run. `rosversion -d` has a known answer; others succeed and print nothing."""
    args = call.args
    answer = ""
    if "rosversion" in args and "-d" in args:
        answer = run.environment.get("ROS_DISTRO", "")
    for name, value in (("OUTPUT_VARIABLE", answer), ("RESULT_VARIABLE", "0"), ("RETURN_VALUE", "0"), ("ERROR_VARIABLE", "")):
        if name in args[:-1]:
            run.assume(args[args.index(name) + 1], value)
