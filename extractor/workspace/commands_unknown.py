"""CMake commands that absent files define: the macros by which another package, or its build tool, makes targets."""

from __future__ import annotations

import os
import re

from rosarch.extractor.workspace.cmake_state import Call
from rosarch.extractor.workspace.commands_ros import register_components
from rosarch.extractor.workspace.commands_targets import add_target
from rosarch.extractor.workspace.evaluator import UNKNOWN_COMMAND, Evaluator, command
from rosarch.extractor.workspace.model import EXECUTABLE, SHARED, STATIC

_PROGRAM = re.compile(r"binary|executable|program|(?:^|_)(?:exe|node|app)(?:_|$)")
_LIBRARY = re.compile(r"library|(?:^|_)lib(?:_|$)")
_SOURCES = (".cpp", ".cc", ".cxx", ".c", ".cu")


@command(UNKNOWN_COMMAND)
def _unknown(run: Evaluator, call: Call) -> None:
    """A command that is named for what it makes, and is given a name and sources that are there, makes a target.

    What else it does is not known; a program may use the libraries that its package has made so far.
    """
    if call.args and call.args[0] in run.targets and {"PLUGIN", "EXECUTABLE"} <= set(call.args):
        register_components(run, call)
        return
    kind = None if "test" in call.name else EXECUTABLE if _PROGRAM.search(call.name) else STATIC if _LIBRARY.search(call.name) else None
    sources = [word for word in call.args[1:] if word.endswith(_SOURCES) and os.path.isfile(run.source_path(word))]
    text = f"unknown command {call.command.written}"
    if kind is None or not sources or call.args[0] in run.targets:
        run.complain(call.command, "unknown-command", text)
        return
    libraries = [target.name for target in run.targets.values() if target.kind in (SHARED, STATIC)]
    target = add_target(run, call, call.args[0], kind, sources)
    if kind == EXECUTABLE:
        target.extend("LINK_LIBRARIES", libraries)
    run.complain(call.command, "unknown-command", f"{text}, taken for {'add_executable' if kind == EXECUTABLE else 'add_library'}")
