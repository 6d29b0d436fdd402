"""CMake commands that install programs and Python packages.

Sources: cmake-commands(7) on `install`, catkin's `catkin_install_python`, ament_cmake_python's user documentation.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

from rosarch.base.files import read_file
from rosarch.extractor.workspace.cmake_state import Call
from rosarch.extractor.workspace.commands_values import parse_keywords
from rosarch.extractor.workspace.evaluator import Evaluator, command
from rosarch.extractor.workspace.installs import copied, installing

_KINDS = ["TARGETS", "IMPORTED_RUNTIME_ARTIFACTS", "FILES", "PROGRAMS", "DIRECTORY", "SCRIPT", "CODE", "EXPORT", "RUNTIME_DEPENDENCY_SET"]
_SINGLES = ["DESTINATION", "RENAME", "COMPONENT", "TYPE"]
_PROGRAMS = re.compile(r"(?:[^/]+/)*lib/[^/]+/*")  # where `rosrun` and `ros2 run` look, with all below
_LISTS = ["PERMISSIONS", "CONFIGURATIONS"]


@command("catkin_install_python", "install")
def _install(run: Evaluator, call: Call) -> None:
    """Programs are files that are copied; in a test-only branch they are no part of the system."""
    words, _rest = parse_keywords(call.args, ["OPTIONAL", "EXCLUDE_FROM_ALL"], _SINGLES, [*_KINDS, *_LISTS])
    if words.get("EXPORT"):
        run.draft.export_sets.setdefault(words["EXPORT"][0], []).extend(words.get("TARGETS", []))
    _record(run, call)
    renamed = (words.get("RENAME") or [""])[0]
    if not run.testing:
        for name in words.get("PROGRAMS", []):
            run.draft.programs.append((renamed or os.path.basename(name), run.source_path(name)))
        if _PROGRAMS.fullmatch((words.get("DESTINATION") or [""])[0]):
            for folder in words.get("DIRECTORY", []):
                run.draft.programs.extend((os.path.basename(path), path) for path in _scripts_below(run.source_path(folder)))


def _record(run: Evaluator, call: Call) -> None:
    """Note what is copied where, and the programs among the targets."""
    words = installing(call.args)
    files = not {"FILES", "PROGRAMS", "DIRECTORY"}.isdisjoint(words.lists)
    if not words.is_clear or (files and words.destination is None) or run.has_unset(call.command):
        run.unsure(f"{call.command.written}() with something that is not known", call.command.line)
    if run.excluded:
        return
    place = (Path(call.file), call.command.line)
    run.draft.installs.extend(copied(words, run.lookup("", "CMAKE_INSTALL_PREFIX"), run.directory.source, place))
    if words.is_clear and not (run.testing or words.flags & {"OPTIONAL", "EXCLUDE_FROM_ALL"} or run.has_unset(call.command)):
        names = [name for kind in ("FILES", "PROGRAMS", "DIRECTORY") for name in words.lists.get(kind, ()) if name]
        run.draft.installed_files.extend((run.source_path(name), *place) for name in names)
    for name in words.lists.get("TARGETS", ()):
        run.draft.installed_targets.append((name, words.runtime or run.lookup("", "CMAKE_INSTALL_BINDIR") or "bin", place))


def _scripts_below(folder: str) -> Iterator[str]:
    """The files in a folder that are copied to where programs are looked for, and say what runs them."""
    for here, folders, names in os.walk(folder):
        folders.sort()
        for path in (f"{here}/{name}" for name in sorted(names)):
            if _is_script(path):
                yield path


def _is_script(path: str) -> bool:
    try:
        return read_file(Path(path)).startswith(b"#!")
    except OSError:
        return False


@command("cs_install_scripts")
def _cs_install_scripts(run: Evaluator, call: Call) -> None:
    """What catkin_simple calls the installation of programs."""
    _install(run, Call(call.command, ["PROGRAMS", *call.args], call.file))


@command("ament_python_install_package")
def _ament_python_install_package(run: Evaluator, call: Call) -> None:
    """The folder that holds the package's is one that modules are imported from."""
    words, _rest = parse_keywords(
        call.args[1:], ["SKIP_COMPILE"], ["PACKAGE_DIR", "VERSION", "SETUP_CFG", "DESTINATION", "SCRIPTS_DESTINATION"], []
    )
    if "SCRIPTS_DESTINATION" in words:
        run.unsure("scripts of a Python package", call.command.line)
    if call.args:
        folder = run.source_path((words.get("PACKAGE_DIR") or [call.args[0]])[0])
        run.draft.python_folders.append(os.path.dirname(os.path.normpath(folder)))
