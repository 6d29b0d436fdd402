"""Robot descriptions and worlds that launch files name: what they say, and the simulator plugins in them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from dataclasses import replace

from rosarch.extractor.launch.model import Condition, LaunchError, Place, Problem, World
from rosarch.extractor.launch.state import State
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.urdf.command import XacroCall, run
from rosarch.extractor.urdf.document import DocumentError, Element, parse
from rosarch.extractor.urdf.hardware import hardware
from rosarch.extractor.urdf.plugins import SimulatorPlugin
from rosarch.extractor.urdf.robots import Robot, robot
from rosarch.extractor.urdf.writer import write

_WORLDS = (".world", ".sdf")
_MODEL = re.compile(r"^(model|package)://")
_FOR_XACRO = re.compile(r"<xacro:|\$[({]")
"""What only xacro makes sense of."""


def evaluated(state: State, call: XacroCall, *, installed: bool = False) -> tuple[str | None, Robot | None]:
    """What xacro prints, and says of a robot; None when it rejects the file: its problems become those of the launch file.

    `installed`: packages are looked for where they are installed, as in ROS 2; a file there may come from elsewhere in their sources. As
    only its name says from where, the description is then known in part.
    """
    named = call.file
    if installed:
        call = replace(call, file=state.files.located(named))
    for path in (call.program, call.file):
        if is_known(path) and (path is call.file or "/" in path) and not state.files.is_file(path):
            kind, subject = ("file", path) if os.path.isabs(path) else ("command", call.program)
            state.report(LaunchError(kind, subject, f"command `{call.program}` would fail: no such file: {path}"))
            return None, None
    expansion = run(call, state.files, state.resolver.environment, state.unknowns, installed=installed)
    state.spend(expansion.work)
    state.parts.update(dict.fromkeys(expansion.meant))
    for problem in expansion.problems:
        # an absent package or file stays one; what an argument of xacro is, nobody says from outside of the launch file
        kind = "command" if problem.fatal and problem.kind in ("xacro", "arg") else problem.kind
        state.problems.setdefault(replace(problem, kind=kind, conditions=state.scope.conditions + state.own_conditions))
    is_whole = expansion.document is not None and not expansion.problems and not expansion.incomplete and call.file == named
    state.hardware_unseen |= not is_whole
    if expansion.document is None:
        return None, None
    return write(expansion.document, call.file, installed=installed), _described(state, expansion.document.root, is_whole=is_whole)


def robot_of_file(state: State, path: str, text: str) -> Robot | None:
    """What a file with the content `text` says of a robot or a world; None, with a report, when it is no document."""
    if not any(tag in text for tag in ("<robot", "<plugin", "<mesh", "<ros2_control")):
        return None
    state.spend(len(text))
    is_whole = not _FOR_XACRO.search(text)
    state.hardware_unseen |= not is_whole
    try:
        return _described(state, state.files.parsed(path, parse).root, is_whole=is_whole)
    except DocumentError as error:
        state.problems.setdefault(Problem("urdf", path, error.message, error.place, fatal=False, conditions=state.scope.conditions))
        return None


def _described(state: State, root: Element, *, is_whole: bool = True) -> Robot:
    _note_meshes(state, root)
    state.hardware.update(dict.fromkeys(hardware(root)))
    return robot(root, is_whole=is_whole)


def _note_meshes(state: State, root: Element) -> None:
    """Note the files that meshes of links name in packages: `package://robot/meshes/base.stl`."""
    for element in root.elements():
        name = element.attributes.get("filename", "") if element.tag == "mesh" else ""
        package, _, path = name.removeprefix("package://").partition("/")
        if name.startswith("package://") and path and is_known(name):
            folder = state.files.packages.find(package)
            if folder is not None:
                state.meshes[(os.path.normpath(f"{folder}/{path}"), element.place)] = None
        _note_meshes(state, element)


def note_worlds(state: State, texts: Iterable[str], lines: tuple[Place, ...], conditions: tuple[Condition, ...]) -> None:
    """Note the worlds whose files `texts` name, arguments of a node or of an included file, which stands below `lines`."""
    for path in texts:
        if not path.endswith(_WORLDS) or path in state.worlds or not is_known(path) or not state.files.is_file(path):
            continue
        try:
            found = robot_of_file(state, path, state.files.read_text(path))
        except LaunchError as error:
            state.report(error, fatal=False)
            continue
        plugins = (*(found.plugins if found else ()), *_of_models(state, path, {path}))
        state.worlds[path] = World(path, (*lines, state.here), conditions + state.own_conditions, plugins)


def _of_models(state: State, path: str, seen: set[str]) -> Iterator[SimulatorPlugin]:
    """The plug-ins of the models that a world or model includes, and of those that these include; none that was `seen`."""
    try:
        root = state.files.parsed(path, parse).root
    except DocumentError:
        return  # reported where the world is read
    for uri in _included(root):
        file = _model_file(state, uri, path)
        if file is None or file in seen:
            continue
        seen.add(file)
        try:
            found = robot_of_file(state, file, state.files.read_text(file))
        except LaunchError as error:
            state.report(error, fatal=False)
            continue
        yield from found.plugins if found else ()
        yield from _of_models(state, file, seen)


def _included(element: Element) -> Iterator[str]:
    """What the elements `<include><uri>` name."""
    for child in element.elements():
        if element.tag == "include" and child.tag == "uri":
            yield child.text().strip()
        yield from _included(child)


def _model_file(state: State, uri: str, near: str) -> str | None:
    """The file of the model that `uri` names, in the package of what includes it, else in the only other one that has it."""
    name = _MODEL.sub("", uri).strip("/")
    end = name if name.endswith(".sdf") else f"{name}/model.sdf"
    packages = state.files.packages
    own = packages.of_file(near)
    for folders in ([own] if own else [], packages.packages.values()):
        paths = (path for folder in folders for path in packages.paths_in(folder).get(os.path.basename(end), ()))
        found = {path for path in paths if path.endswith(f"/{end}")}
        if found:
            return found.pop() if len(found) == 1 else None
    return None
