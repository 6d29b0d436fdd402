"""CMake commands that make targets and their properties (cmake-buildsystem(7))."""

from __future__ import annotations

import os
from collections.abc import Iterator

from rosarch.extractor.workspace.cmake_expand import split_list
from rosarch.extractor.workspace.cmake_state import Call, Directory, TargetDraft
from rosarch.extractor.workspace.commands_values import truthy
from rosarch.extractor.workspace.evaluator import Evaluator, command
from rosarch.extractor.workspace.model import EXECUTABLE, IMPORTED, INTERFACE, MODULE, OBJECT, SHARED, STATIC, TEST


@command("project")
def _project(run: Evaluator, call: Call) -> None:
    if not call.args:
        return
    name = call.args[0]
    run.set("PROJECT_NAME", name)
    if run.get("CMAKE_PROJECT_NAME") is None:
        run.cache["CMAKE_PROJECT_NAME"] = name
    for prefix in ("PROJECT", name):
        run.set(f"{prefix}_SOURCE_DIR", run.directory.source)
        run.set(f"{prefix}_BINARY_DIR", run.directory.binary)
    if "VERSION" in call.args[:-1]:
        version = call.args[call.args.index("VERSION") + 1]
        run.set("PROJECT_VERSION", version)
        run.set(f"{name}_VERSION", version)


def add_target(run: Evaluator, call: Call, name: str, kind: str, sources: list[str]) -> TargetDraft:
    """Make a target; tests are those made in a test-only branch."""
    if kind == EXECUTABLE and run.testing:
        kind = TEST
    target = TargetDraft(name, kind, run.directory, run.file, call.command.line, call.command.column)
    if name in run.targets:
        run.complain(call.command, "duplicate-target", f"target {name} is defined twice, the later definition counts")
    run.targets[name] = target
    if run.excluded:
        target.properties["EXCLUDE_FROM_ALL"] = ["1"]
    add_sources(run, target, sources)
    return target


def add_sources(run: Evaluator, target: TargetDraft, sources: list[str]) -> None:
    """Sources are relative to the folder of the command that names them; a list in quotes is one all the same."""
    names = split_list(";".join(sources))
    target.extend("SOURCES", [name if name.startswith("$<") else os.path.join(run.directory.source, name) for name in names])
    target.extend("SOURCE_BINARY_DIRS", [run.directory.binary])


@command("add_executable", "cuda_add_executable", "rosbuild_add_executable", "ocl_add_executable")
def add_executable(run: Evaluator, call: Call) -> None:
    """A program, or another name for one."""
    args = call.args
    if not args:
        return
    if len(args) > 2 and args[1] == "ALIAS":
        run.aliases[args[0]] = args[2]
        return
    if "IMPORTED" in args[1:3]:
        add_target(run, call, args[0], IMPORTED, [])
        return
    words = [word for word in args[1:] if word not in ("WIN32", "MACOSX_BUNDLE", "EXCLUDE_FROM_ALL")]
    target = add_target(run, call, args[0], EXECUTABLE, words)
    if "EXCLUDE_FROM_ALL" in args:
        target.properties["EXCLUDE_FROM_ALL"] = ["1"]


_KINDS = {"SHARED": SHARED, "STATIC": STATIC, "MODULE": MODULE, "OBJECT": OBJECT, "INTERFACE": INTERFACE, "UNKNOWN": IMPORTED}


@command("add_library", "cuda_add_library", "rosbuild_add_library", "pybind11_add_module", "pybind_add_module", "python_add_module")
def add_library(run: Evaluator, call: Call) -> None:
    """A library, or another name for one."""
    args = call.args
    if not args:
        return
    if len(args) > 2 and args[1] == "ALIAS":
        run.aliases[args[0]] = args[2]
        return
    words = args[1:]
    kind = SHARED if truthy(run.get("BUILD_SHARED_LIBS")) else STATIC
    if "module" in call.name:
        kind = MODULE
    while words and (words[0] in _KINDS or words[0] in ("EXCLUDE_FROM_ALL", "GLOBAL", "IMPORTED", "NO_EXTRAS", "THIN_LTO")):
        kind = IMPORTED if words[0] == "IMPORTED" or kind == IMPORTED else _KINDS.get(words[0], kind)
        words = words[1:]
    add_target(run, call, args[0], kind, [word for word in words if word not in ("EXCLUDE_FROM_ALL", "GLOBAL")])


@command("cuda_compile", "cuda_compile_ptx")
def _cuda_compile(run: Evaluator, call: Call) -> None:
    """The objects stand for their sources."""
    if call.args:
        run.set_list(call.args[0], [run.source_path(name) for name in call.args[1:] if name.endswith((".cu", ".c", ".cpp", ".cc"))])


def find_target(run: Evaluator, call: Call) -> TargetDraft | None:
    """The target a command is about; one that is missing is reported."""
    if not call.args:
        return None
    name = run.aliases.get(call.args[0], call.args[0])
    target = run.targets.get(name)
    if target is None and "::" not in name:
        run.complain(call.command, "unknown-target", f"{call.command.written}: no target {name}")
    return target


_SCOPES = {
    "PUBLIC": (True, True), "PRIVATE": (True, False), "INTERFACE": (False, True), "LINK_PUBLIC": (True, True),
    "LINK_PRIVATE": (True, False), "LINK_INTERFACE_LIBRARIES": (False, True),
}  # fmt: skip


def _scoped(words: list[str], default: tuple[bool, bool]) -> Iterator[tuple[str, bool, bool]]:
    """Words with whether they count for the target and for its users."""
    own, users = default
    for word in words:
        if word in _SCOPES:
            own, users = _SCOPES[word]
        else:
            yield word, own, users


@command("target_link_libraries")
def _target_link_libraries(run: Evaluator, call: Call) -> None:
    target = find_target(run, call)
    if target is None:
        return
    skip = False
    for word, _own, _users in _scoped(call.args[1:], (True, True)):
        if skip or word in ("debug", "optimized", "general"):
            skip = word == "debug" and not skip
            continue
        target.extend("LINK_LIBRARIES", [word])
        target.given_line = target.given_line or call.command.line


@command("link_libraries")
def _link_libraries(run: Evaluator, call: Call) -> None:
    run.directory.links.extend(word for word in call.args if word not in ("debug", "optimized", "general"))


@command("target_sources")
def _target_sources(run: Evaluator, call: Call) -> None:
    target = find_target(run, call)
    if target is not None:
        words = call.args[1:]
        if "FILE_SET" in words:
            words = words[: words.index("FILE_SET")]
        add_sources(run, target, [word for word, own, _users in _scoped(words, (True, False)) if own])


def _absolute(run: Evaluator, folder: str) -> str:
    return folder if folder.startswith("$<") or not folder else run.source_path(folder)


@command("include_directories")
def _include_directories(run: Evaluator, call: Call) -> None:
    words = [_absolute(run, word) for word in call.args if word not in ("SYSTEM", "BEFORE", "AFTER")]
    if "BEFORE" in call.args[:2] or (truthy(run.get("CMAKE_INCLUDE_DIRECTORIES_BEFORE")) and "AFTER" not in call.args[:2]):
        run.directory.include_dirs[:0] = words
    else:
        run.directory.include_dirs.extend(words)


@command("target_include_directories")
def _target_include_directories(run: Evaluator, call: Call) -> None:
    target = find_target(run, call)
    if target is None:
        return
    words = [word for word in call.args[1:] if word not in ("SYSTEM", "BEFORE", "AFTER")]
    for word, own, users in _scoped(words, (True, False)):
        if own:
            target.extend("INCLUDE_DIRECTORIES", [_absolute(run, word)])
        if users:
            target.extend("INTERFACE_INCLUDE_DIRECTORIES", [_absolute(run, word)])


@command("target_compile_definitions", "target_compile_options")
def _target_compile_definitions(run: Evaluator, call: Call) -> None:
    target = find_target(run, call)
    if target is None:
        return
    options = call.name == "target_compile_options"
    for word, own, users in _scoped(call.args[1:], (True, False)):
        if options and not word.startswith("-D"):
            continue
        if own:
            target.extend("COMPILE_DEFINITIONS", [word])
        if users:
            target.extend("INTERFACE_COMPILE_DEFINITIONS", [word])


@command("add_definitions", "add_compile_definitions", "add_compile_options")
def _add_definitions(run: Evaluator, call: Call) -> None:
    for word in call.args:
        if word.startswith("-D") or (call.name == "add_compile_definitions" and word):
            run.directory.definitions.append(word)


@command("remove_definitions")
def _remove_definitions(run: Evaluator, call: Call) -> None:
    run.directory.definitions = [word for word in run.directory.definitions if word not in call.args]


@command("set_target_properties")
def _set_target_properties(run: Evaluator, call: Call) -> None:
    if "PROPERTIES" not in call.args:
        return
    place = call.args.index("PROPERTIES")
    pairs = _property_pairs(call)
    for name in call.args[:place]:
        target = run.targets.get(run.aliases.get(name, name))
        if target is None:
            run.complain(call.command, "unknown-target", f"{call.command.written}: no target {name}")
            continue
        for key, value in pairs:
            _set_property(run, target, key, [value])


def _property_pairs(call: Call) -> list[tuple[str, str]]:
    """Names and values after `PROPERTIES`; an empty quoted value keeps its place."""
    words = call.args[call.args.index("PROPERTIES") + 1 :]
    return list(zip(words[::2], words[1::2], strict=False))


def _set_property(run: Evaluator, target: TargetDraft, key: str, values: list[str], append: bool = False) -> None:
    values = [part for value in values for part in value.split(";") if part]
    if key in ("INCLUDE_DIRECTORIES", "INTERFACE_INCLUDE_DIRECTORIES"):
        values = [_absolute(run, value) for value in values]
    if key == "COMPILE_FLAGS":
        key, append = "COMPILE_DEFINITIONS", True
        values = [word for value in values for word in value.split() if word.startswith("-D")]
    if append:
        target.extend(key, values)
    else:
        target.properties[key] = values


@command("set_property")
def _set_property_command(run: Evaluator, call: Call) -> None:
    args = call.args
    if len(args) < 2 or "PROPERTY" not in args:
        return
    place = args.index("PROPERTY")
    if place + 1 >= len(args):
        return
    key, values = args[place + 1], args[place + 2 :]
    names = [word for word in args[1:place] if word not in ("APPEND", "APPEND_STRING")]
    append = "APPEND" in args[1:place] or "APPEND_STRING" in args[1:place]
    if args[0] == "TARGET":
        for name in names:
            target = run.targets.get(run.aliases.get(name, name))
            if target is not None:
                _set_property(run, target, key, values, append)
    elif args[0] == "DIRECTORY":
        _directory_property(run, run.directory, key, values, append)
    elif args[0] == "SOURCE" and key == "GENERATED":
        run.generated.update(run.binary_path(name) for name in names)
        run.generated.update(run.source_path(name) for name in names)
    elif args[0] == "GLOBAL":
        old = run.global_properties.get(key) if append else None
        value = ";".join([*([old] if old else []), *values])
        run.charge(0, len(value))
        run.global_properties[key] = value


def _directory_property(run: Evaluator, directory: Directory, key: str, values: list[str], append: bool) -> None:
    if key == "INCLUDE_DIRECTORIES":
        directory.include_dirs = [*(directory.include_dirs if append else []), *(_absolute(run, value) for value in values)]
    elif key == "COMPILE_DEFINITIONS":
        directory.definitions = [*(directory.definitions if append else []), *values]
    else:
        directory.properties[key] = ";".join(values)


@command("set_directory_properties")
def _set_directory_properties(run: Evaluator, call: Call) -> None:
    words = call.args[1:]
    for key, value in zip(words[::2], words[1::2], strict=False):
        _directory_property(run, run.directory, key, value.split(";"), False)


@command("set_source_files_properties")
def _set_source_files_properties(run: Evaluator, call: Call) -> None:
    if "PROPERTIES" not in call.args:
        return
    pairs = dict(_property_pairs(call))
    if truthy(pairs.get("GENERATED")):
        names = call.args[: call.args.index("PROPERTIES")]
        run.generated.update(run.binary_path(name) for name in names)
        run.generated.update(run.source_path(name) for name in names)


@command("get_target_property", "get_property", "get_directory_property", "get_source_file_property", "get_cmake_property")
def _get_property(run: Evaluator, call: Call) -> None:
    """What is known about targets, directories and global properties; anything else is `<variable>-NOTFOUND`."""
    args = call.args
    if len(args) < 2:
        return
    value: str | None = None
    key = args[-1]
    if call.name == "get_target_property":
        value = _target_property(run, args[1], key)
    elif call.name == "get_property" and args[1] == "TARGET" and len(args) > 3:
        value = _target_property(run, args[2], args[args.index("PROPERTY") + 1] if "PROPERTY" in args[:-1] else key)
    elif args[1] == "GLOBAL":
        value = run.global_properties.get(key)
    elif call.name == "get_directory_property" or args[1] == "DIRECTORY":
        known = {"INCLUDE_DIRECTORIES": run.directory.include_dirs, "COMPILE_DEFINITIONS": run.directory.definitions}
        value = ";".join(known[key]) if key in known else run.directory.properties.get(key)
    if value is None:
        value = "" if call.name in ("get_property", "get_directory_property") else f"{args[0]}-NOTFOUND"
    run.set(args[0], value)


def _target_property(run: Evaluator, name: str, key: str) -> str | None:
    target = run.targets.get(run.aliases.get(name, name))
    if target is None:
        return None
    if key == "TYPE":
        return {EXECUTABLE: "EXECUTABLE", TEST: "EXECUTABLE"}.get(target.kind, target.kind.upper())
    if key == "NAME":
        return target.name
    if key == "SOURCE_DIR":
        return target.directory.source
    if key == "LOCATION":
        return f"{target.directory.binary}/{target.name}"
    values = target.properties.get(key)
    return ";".join(values) if values else None


@command("add_dependencies")
def _add_dependencies(run: Evaluator, call: Call) -> None:
    """`add_dependencies(tests x)` marks a test executable."""
    if call.args[:1] in (["tests"], ["run_tests"]):
        for name in call.args[1:]:
            target = run.targets.get(name)
            if target is not None and target.kind == EXECUTABLE:
                target.kind = TEST
