"""CMake commands that ask what is installed. Everything is: the whole source is to be seen, not what this machine could build.

A package of the workspace gives its own include folders and libraries. Any other is found, without include folders, with a library
name that matches nothing (`<name>::<name>`) and the version of the assumed distribution (`options`); a condition that asks for more of
what it may set gets a yes (`cmake_questions`). `defines` override.
"""

from __future__ import annotations

import os
import re

from rosarch.extractor.workspace.cmake_expand import join_list
from rosarch.extractor.workspace.cmake_state import Call, PackageDraft
from rosarch.extractor.workspace.evaluator import Evaluator, command

_SECTIONS = {
    "REQUIRED", "QUIET", "EXACT", "MODULE", "CONFIG", "NO_MODULE", "NO_POLICY_SCOPE", "GLOBAL", "NAMES", "CONFIGS", "HINTS", "PATHS",
    "PATH_SUFFIXES", "NO_DEFAULT_PATH", "OPTIONAL_COMPONENTS", "COMPONENTS",
}  # fmt: skip


@command("find_package")
def _find_package(run: Evaluator, call: Call) -> None:
    if not call.args:
        return
    name = call.args[0]
    components = _components(call.args[1:])
    if name in ("catkin", "catkin_simple"):
        for component in components:
            find_one(run, component)
        set_catkin(run, components)
        return
    find_one(run, name, call.args[1:])
    for component in components:
        run.assume(f"{name}_{component}_FOUND", "1")
        run.assume(f"{name}_{component.upper()}_FOUND", "1")


def _components(words: list[str]) -> list[str]:
    result: list[str] = []
    taking = False
    for word in words:
        if word in _SECTIONS:
            taking = word in ("COMPONENTS", "OPTIONAL_COMPONENTS", "REQUIRED")
        elif taking:
            result.append(word)
    return result


def find_one(run: Evaluator, name: str, words: list[str] | None = None) -> None:
    """Set what a found package sets."""
    run.draft.finds.append(name)
    if run.options.defines.get(f"{name}_FOUND", "1") in ("0", "OFF", "FALSE", "NO"):
        run.assume(f"{name}_FOUND", "0")
        return
    found = run.world.find(name)
    if found is not None:
        run.draft.found_packages.append(name)
        folders, libraries = exported(run, [name])
        _set_found(run, name, folders, libraries)
        run.assume(f"{name}_DIR", f"{run.world.path(name)}/cmake")
        _evaluate_extras(run, name, found)
        return
    if _local_module(run, name):
        return
    _set_absent(run, name)
    version = run.versions.get(name)
    if version is None and words and words[0][:1].isdigit():
        version = words[0]
    if version:
        _set_version(run, name, version)


def _local_module(run: Evaluator, name: str) -> bool:
    """A `Find<name>.cmake` of the workspace, evaluated for the variables it sets; it is found whatever it concludes."""
    for folder in run.elements("CMAKE_MODULE_PATH"):
        path = os.path.join(run.source_path(folder), f"Find{name}.cmake")
        if not run.is_outside(path) and os.path.isfile(path):
            _set_absent(run, name)
            run.run_file(path)
            run.assume(f"{name}_FOUND", "1")
            run.assume(f"{name.upper()}_FOUND", "1")
            return True
    return False


def _set_found(run: Evaluator, name: str, folders: list[str], libraries: list[str]) -> None:
    for prefix in dict.fromkeys((name, name.upper())):
        run.assume(f"{prefix}_FOUND", "1")
        for suffix in ("INCLUDE_DIRS", "INCLUDE_DIR", "INCLUDES"):
            run.assume(f"{prefix}_{suffix}", join_list(folders))
        for suffix in ("LIBRARIES", "LIBRARY", "LIBS"):
            run.assume(f"{prefix}_{suffix}", join_list(libraries))


def _set_absent(run: Evaluator, name: str) -> None:
    """What a package sets that is installed on some machine, not on this one."""
    run.found_packages.update((name, name.upper()))
    _set_found(run, name, [], [f"{name}::{name}"])
    run.assume(f"{name}_DIR", f"/usr/lib/cmake/{name}")


def _set_version(run: Evaluator, name: str, version: str) -> None:
    numbers = [*version.split("."), "0", "0"][:3]
    for prefix in dict.fromkeys((name, name.upper())):
        run.assume(f"{prefix}_VERSION", version)
        run.assume(f"{prefix}_VERSION_STRING", version)
        for suffix, number in zip(("MAJOR", "MINOR", "PATCH"), numbers, strict=True):
            run.assume(f"{prefix}_VERSION_{suffix}", number)


def _evaluate_extras(run: Evaluator, name: str, found: PackageDraft) -> None:
    """`CFG_EXTRAS` of `catkin_package` and `CONFIG_EXTRAS` of ament run in every package that finds this one."""
    folder = run.world.path(name)
    for extra in found.cfg_extras:
        for path in (f"{folder}/cmake/{extra}", f"{folder}/{extra}", f"{folder}/cmake/{extra}.in"):
            if os.path.isfile(path) and name != run.package and path not in run.included:
                run.included.add(path)
                run.run_file(path)


def exported(run: Evaluator, names: list[str]) -> tuple[list[str], list[str]]:
    """Include folders and libraries of workspace packages and of those they depend on (their generated config files do so)."""
    folders: dict[str, None] = {}
    libraries: dict[str, None] = {}
    seen: set[str] = set()
    queue = list(names)
    while queue:
        name = queue.pop(0)
        if name in seen:
            continue
        seen.add(name)
        found = run.world.find(name)
        if found is not None:
            folders.update(dict.fromkeys(found.include_dirs))
            libraries.update(dict.fromkeys(found.libraries))
            queue.extend(found.depends)
    return list(folders), list(libraries)


def set_catkin(run: Evaluator, components: list[str]) -> None:
    """The `catkin_*` variables of `find_package(catkin COMPONENTS ...)`."""
    folders, libraries = exported(run, components)
    missing = [name for name in components if run.world.find(name) is None]
    run.assume("catkin_FOUND", "1")
    run.set("catkin_INCLUDE_DIRS", join_list(folders))
    run.set("catkin_LIBRARIES", join_list([*libraries, *(f"{name}::{name}" for name in missing)]))
    run.set("catkin_EXPORTED_TARGETS", "catkin_EXPORTED_TARGETS")
    run.set("CATKIN_PACKAGE_BIN_DESTINATION", f"lib/{run.project}")
    run.set("CATKIN_PACKAGE_LIB_DESTINATION", "lib")
    run.set("CATKIN_PACKAGE_SHARE_DESTINATION", f"share/{run.project}")
    run.set("CATKIN_PACKAGE_INCLUDE_DESTINATION", f"include/{run.project}")
    run.set("CATKIN_GLOBAL_INCLUDE_DESTINATION", "include")
    if run.get("BUILD_SHARED_LIBS") is None:
        run.set("BUILD_SHARED_LIBS", "ON")


@command("find_library", "find_file", "find_path", "find_program")
def _find_file(run: Evaluator, call: Call) -> None:
    """A file of the workspace when the hints lead to one, else the place where a system package would put it."""
    args = call.args
    if not args or (run.get(args[0]) not in (None, "") and not (run.get(args[0]) or "").endswith("NOTFOUND")):
        return
    words = [word for word in args[1:] if word != "NAMES"]
    name = words[0] if words else ""
    for word in words[1:]:
        path = os.path.join(run.source_path(word), name)
        if not run.is_outside(path) and os.path.exists(path) and word not in _SECTIONS:
            run.assume(args[0], path if call.name != "find_path" else run.source_path(word))
            return
    places = {"find_library": f"/usr/lib/lib{name}.so", "find_path": "/usr/include", "find_program": f"/usr/bin/{name}"}
    run.assume(args[0], places.get(call.name, f"/usr/include/{name}"))


@command("pkg_check_modules", "pkg_search_module", "ament_find_gtest", "ament_find_gmock")
def _pkg_check_modules(run: Evaluator, call: Call) -> None:
    if not call.args:
        return
    prefix = call.args[0]
    _set_absent(run, prefix)
    run.assume(f"{prefix}_LDFLAGS", "")
    modules = [re.split("[<>=]", word)[0] for word in call.args[1:] if word not in _SECTIONS]
    version = next((run.versions[module] for module in modules if module in run.versions), None)
    if version:
        _set_version(run, prefix, version)


@command(
    "check_include_file", "check_include_file_cxx", "check_include_files", "check_symbol_exists", "check_cxx_symbol_exists",
    "check_function_exists", "check_library_exists", "check_cxx_compiler_flag", "check_c_compiler_flag", "check_cxx_source_compiles",
    "check_c_source_compiles", "check_cxx_source_runs", "check_type_size", "check_struct_has_member", "try_compile", "try_run",
)  # fmt: skip
def _check(run: Evaluator, call: Call) -> None:
    """Compiler and header checks succeed; the variable is the last argument but for a few commands."""
    if not call.args:
        return
    variable = {"try_compile": 0, "try_run": 0, "check_include_file": 1, "check_include_file_cxx": 1, "check_type_size": 1}
    place = variable.get(call.name, len(call.args) - 1 if "source" not in call.name else 1)
    if place < len(call.args) and run.get(call.args[place]) is None:
        run.assume(call.args[place], "1")


@command("check_language", "enable_language")
def _check_language(run: Evaluator, call: Call) -> None:
    """There is a compiler for each language."""
    if call.args:
        run.assume(f"CMAKE_{call.args[0]}_COMPILER", f"/usr/bin/{call.args[0].lower()}")


@command("find_package_handle_standard_args")
def _handle_standard_args(run: Evaluator, call: Call) -> None:
    if call.args:
        run.assume(f"{call.args[0]}_FOUND", "1")
        run.assume(f"{call.args[0].upper()}_FOUND", "1")
