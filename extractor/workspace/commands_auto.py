"""Macros that link a target with all that the manifest depends on: ament_cmake_auto and catkin_simple.

Sources: https://github.com/ament/ament_cmake/tree/rolling/ament_cmake_auto/cmake, https://github.com/catkin/catkin_simple
"""

from __future__ import annotations

import os
from functools import partial

from rosarch.extractor.workspace.cmake_glob import glob
from rosarch.extractor.workspace.cmake_state import Call
from rosarch.extractor.workspace.commands_find import exported, find_one, set_catkin
from rosarch.extractor.workspace.commands_ros import add_interface_files, export_package, use_packages
from rosarch.extractor.workspace.commands_targets import add_executable, add_library
from rosarch.extractor.workspace.commands_values import parse_keywords, truthy
from rosarch.extractor.workspace.evaluator import Evaluator, command
from rosarch.extractor.workspace.model import INTERFACE

_SOURCES = ("c", "cc", "cpp", "cxx")


def _find_manifest_depends(run: Evaluator) -> list[str]:
    """Find all packages that the manifest depends on; those that are found."""
    for name in run.manifest_depends:
        find_one(run, name)
    return [name for name in run.manifest_depends if truthy(run.get(f"{name}_FOUND"))]


def _link_own(run: Evaluator, name: str) -> None:
    """Link a target with the libraries that `<project>_LIBRARIES` lists so far."""
    run.targets[name].extend("LINK_LIBRARIES", run.elements(f"{run.project}_LIBRARIES"))


# -- ament_cmake_auto ---------------------------------------------------------------------------------------------------------


@command("ament_auto_find_build_dependencies")
def _ament_auto_find(run: Evaluator, _call: Call) -> None:
    found = _find_manifest_depends(run)
    folders, libraries = exported(run, found)
    for name, values in (("BUILD_DEPENDS", found), ("INCLUDE_DIRS", folders), ("LIBRARIES", libraries)):
        run.set_list(f"{run.project}_FOUND_{name}", values)


def _plain_call(run: Evaluator, call: Call) -> tuple[Call, bool]:
    """The call of the plain command that makes the target, and whether the target is linked with the libraries of its package."""
    words, rest = parse_keywords(call.args, ["NO_TARGET_LINK_LIBRARIES"], ["DIRECTORY"], [])
    unreadable = partial(run.cannot_read, call.command)
    patterns = [f"{run.source_path(folder)}/*.{extension}" for folder in words.get("DIRECTORY", []) for extension in _SOURCES]
    found = [path for pattern in patterns for path in glob(pattern, True, False, unreadable)]
    return Call(call.command, [*rest, *found], call.file), "NO_TARGET_LINK_LIBRARIES" not in words


def _complete(run: Evaluator, call: Call, links_own: bool) -> None:
    """What both kinds of targets get: the package's include folder, its earlier libraries, the found dependencies."""
    name = call.args[0]
    target, include = run.targets[name], run.source_path("include")
    if os.path.isdir(include):
        target.extend("INTERFACE_INCLUDE_DIRECTORIES", [include])
        if target.kind != INTERFACE:
            target.extend("INCLUDE_DIRECTORIES", [include])
    if links_own:
        _link_own(run, name)
    if run.get(f"{run.project}_FOUND_BUILD_DEPENDS") is None:  # a macro of another package has found them, whose file may be absent
        _ament_auto_find(run, call)
    packages = run.elements(f"{run.project}_FOUND_BUILD_DEPENDS")
    use_packages(run, call, packages)
    target.uses_packages.extend(packages)


@command("ament_auto_add_library")
def _ament_auto_add_library(run: Evaluator, call: Call) -> None:
    plain, links_own = _plain_call(run, call)
    if not plain.args:
        return
    add_library(run, plain)
    _complete(run, plain, links_own)
    run.set_list(f"{run.project}_LIBRARIES", [*run.elements(f"{run.project}_LIBRARIES"), plain.args[0]])
    include = run.source_path("include")
    if os.path.isdir(include) and include not in run.draft.include_dirs:
        run.draft.include_dirs.append(include)
    run.draft.libraries.append(plain.args[0])
    run.draft.auto_targets.append(plain.args[0])


@command("ament_auto_add_executable")
def _ament_auto_add_executable(run: Evaluator, call: Call) -> None:
    plain, links_own = _plain_call(run, call)
    if plain.args:
        add_executable(run, plain)
        run.draft.auto_targets.append(plain.args[0])
        _complete(run, plain, links_own)


# -- catkin_simple ------------------------------------------------------------------------------------------------------------


@command("catkin_simple")
def _catkin_simple(run: Evaluator, call: Call) -> None:
    """Find what the manifest depends on, and generate the messages and configurations in the usual folders."""
    found = _find_manifest_depends(run)
    set_catkin(run, found)
    run.set_list(f"{run.project}_LIBRARIES", [])
    run.directory.include_dirs.extend([*_include_folder(run), *run.elements("catkin_INCLUDE_DIRS")])
    if "message_generation" in found:
        for kind in ("action", "msg", "srv"):
            if os.path.isdir(run.source_path(kind)):
                add_interface_files(run, call, kind, run.source_path(kind), [])
    if "dynamic_reconfigure" in found:
        run.draft.cfg_files.extend(glob(f"{run.source_path('cfg')}/*.cfg", False, False, partial(run.cannot_read, call.command)))


def _include_folder(run: Evaluator) -> list[str]:
    include = run.source_path("include")
    return [include] if os.path.isdir(include) else []


@command("cs_add_library", "cs_add_executable")
def _cs_add_target(run: Evaluator, call: Call) -> None:
    words, rest = parse_keywords(call.args, ["NO_AUTO_LINK", "NO_AUTO_DEP", "NO_AUTO_EXPORT"], [], [])
    if not rest:
        return
    (add_library if call.name == "cs_add_library" else add_executable)(run, Call(call.command, rest, call.file))
    if "NO_AUTO_LINK" not in words:
        run.targets[rest[0]].extend("LINK_LIBRARIES", run.elements("catkin_LIBRARIES"))
    if call.name == "cs_add_library" and "NO_AUTO_EXPORT" not in words:
        run.set_list(f"{run.project}_LIBRARIES", [*run.elements(f"{run.project}_LIBRARIES"), rest[0]])


@command("cs_export")
def _cs_export(run: Evaluator, call: Call) -> None:
    """Pass on the include folder, the libraries and all packages of the manifest, and what the arguments add."""
    run.draft.include_dirs.extend(_include_folder(run))
    run.draft.libraries.extend(run.elements(f"{run.project}_LIBRARIES"))
    run.draft.depends.extend(run.manifest_depends)
    export_package(run, call)
