"""What of a workspace is started together: the launch files that were named, or those that no other includes."""

from __future__ import annotations

import itertools
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from rosarch.analysis.systems.requests import LaunchEnvironment, LaunchWordError, Request
from rosarch.analysis.systems.shared import Launch
from rosarch.base import tracing
from rosarch.extractor.launch import PackagePath, compose, launch_files, top_level
from rosarch.extractor.launch.model import Composition, NodeStart, ParamSetting, Place, Problem, ProgramNamed
from rosarch.extractor.workspace import PYTHON_NODE, Package, components, discover
from rosarch.extractor.workspace.model import ROS2

NO_LAUNCH_FILE = "missing"
"""The kind of problem that a workspace without launch files is."""
MAX_MATRIX = 256  # systems of one launch with several values for its arguments


def given(requests: Iterable[Request], where: LaunchEnvironment) -> list[Launch]:
    """The launches of requests. Files are absolute, or below the current folder or the workspace.

    Raises:
        LaunchWordError: a file is not there, or there are too many launches.
    """
    found = []
    for request in requests:
        paths = [_path(word, where.root) for word in request.files]
        names = [name for name, _ in request.arguments]
        combinations = list(itertools.islice(itertools.product(*(values for _, values in request.arguments)), MAX_MATRIX + 1))
        if len(combinations) > MAX_MATRIX:
            raise LaunchWordError(f"more than {MAX_MATRIX} combinations of arguments")
        found += [_launch(paths, dict(zip(names, values, strict=True)), where) for values in combinations]
    return found


def unincluded(where: LaunchEnvironment, jobs: int | None = None) -> list[Launch]:
    """A launch for each launch file of the workspace that no other includes; see `top_level`."""
    files = where.files()
    found = top_level(launch_files(os.path.abspath(where.root)), files, where.variables(), jobs)
    return [
        Launch(_shown(path, where.root), (_shown(path, where.root),), composed.with_controllers(), files.packages)
        for path, composed in found.items()
    ]


def by_themselves(where: LaunchEnvironment, defines: Mapping[str, str]) -> list[Launch]:
    """For a workspace without launch files: each program that its packages build, as a node by itself.

    What runs beside it, and which parameters it is given, is not known. Of packages without programs there is what their files say.
    """
    packages = PackagePath([os.path.abspath(where.root)], where.underlay)
    workspace = discover(where.root, defines=defines, underlay=where.underlay)
    own = {package.name: package for package in workspace.packages if package.name in workspace.selected}
    programs = [
        (own[component.package], program)
        for component in components(workspace)
        if component.package in own and component.kind in ("node", PYTHON_NODE)
        for program in component.executables or (component.name,)
    ]
    if own and not programs:
        return [Launch("packages", (), _by_itself(next(iter(own.values())), None, where.root), packages)]
    named = [(f"{package.name}/{program}", _by_itself(package, program, where.root)) for package, program in programs]
    return [Launch(name, (name,), composition, packages) for name, composition in named]


def _by_itself(package: Package, program: str | None, root: Path) -> Composition:
    """What an absent launch file starts: one node, or nothing; others may, too, and all parameters may be set."""
    place = Place(os.path.abspath(package.manifest), 1)
    ros = 2 if package.middleware == ROS2 else 1
    started = () if program is None else (NodeStart(package.name, program, None, "/", (place,), ros=ros, called=program),)
    named = () if program is None else (ProgramNamed(package.name, program, False, place),)
    text = "no launch file below this folder: each program is checked by itself"
    nothing = Problem(NO_LAUNCH_FILE, "", text, Place(os.path.abspath(root), 1), fatal=False)
    anything = ParamSetting("/", None, (place,))
    return Composition(started, (), (), (), (nothing,), (), unread=(anything,), references=named, ros=ros)


def has_launch_files(root: Path) -> bool:
    """Whether a workspace has launch files at all, be they templates only."""
    return bool(launch_files(os.path.abspath(root), templates=True))


def _path(word: str, root: Path) -> str:
    for path in (Path(word), root / word):
        tracing.probe(path)
        if os.path.isfile(path):
            return os.path.abspath(path)
    raise LaunchWordError(f"{word}: no such launch file, neither here nor below {root}")


def _launch(paths: Sequence[str], arguments: Mapping[str, str], where: LaunchEnvironment) -> Launch:
    files = where.files()
    composition = compose(paths, arguments, files=files, environment=where.variables())
    words = (*(_shown(path, where.root) for path in paths), *(f"{name}:={value}" for name, value in arguments.items()))
    return Launch(" ".join(words), words, composition.with_controllers(), files.packages)


def _shown(path: str, root: Path) -> str:
    inside = os.path.relpath(path, os.path.abspath(root))
    return path if inside.startswith("..") else inside
