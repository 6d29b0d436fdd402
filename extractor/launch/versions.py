"""Launch files of ROS 1 and of ROS 2: which is which, and both composed alike."""

from __future__ import annotations

import itertools
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields, replace
from pathlib import Path

from rosarch.base import tracing
from rosarch.base.files import text_or_nothing
from rosarch.extractor.launch.compose import compose as compose_ros1
from rosarch.extractor.launch.files import DESCRIBED, Files
from rosarch.extractor.launch.model import Composition, Place, Problem
from rosarch.extractor.package_names import quick_text

_ROS2 = re.compile(
    r"\bexec\s*=|\$\((?:var|find-pkg-share|find-pkg-prefix) |<(?:let|push[-_]ros[-_]namespace|node_container|set_\w+|load_composable)\b"
)
_ROS1 = re.compile(r"\btype\s*=|\$\((?:arg|find|optenv) |<(?:rosparam|machine|test)\b")
_LEFT = frozenset(
    {("attribute", "type"), ("attribute", "exec"), ("unknown-element", "rosparam"), ("unknown-element", "param")}
    | {("substitution", word) for word in ("find", "arg", "optenv")}
)
"""Kinds and subjects of the problems that words of ROS 1 are; `exec` is what a node with a `type` lacks."""
_NAMED = 3
"""How many files of a kind a message names."""
_AMENT = re.compile(r"<build_type[^>]*>\s*ament|<buildtool_depend[^>]*>\s*ament")


def compose(
    launch_files: Sequence[Path | str],
    arguments: Mapping[str, str] | None = None,
    *,
    files: Files,
    environment: Mapping[str, str] | None = None,
    namespace: str | None = None,
    version: int | None = None,
) -> Composition:
    """What roslaunch or `ros2 launch` would make of launch files; see `compose.compose`.

    Without the `version` of ROS that starts them, each is started by the one that it is for.
    """
    compositions: list[Composition] = []
    for own, found in itertools.groupby(launch_files, key=lambda path: version or _version_or_none(path)):
        group = list(found)
        if own is None:
            composed = _left_behind(group)
        elif own == 1:
            composed = compose_ros1(group, arguments, files=files.of_ros(1, group[0]), environment=environment, namespace=namespace)
        else:
            from rosarch.extractor.launch_ros2.compose import compose_ros2

            composed = _partly_left(
                compose_ros2(group, arguments, files=files.of_ros(2, group[0]), environment=environment, namespace=namespace)
            )
        compositions.append(composed)
    return compositions[0] if len(compositions) == 1 else _joined(compositions)


def _joined(compositions: Sequence[Composition]) -> Composition:
    """All that several compositions start and set."""
    if not compositions:
        return Composition((), (), (), (), (), ())
    names = [field.name for field in fields(Composition) if field.name not in ("ros", "hardware_unseen")]
    parts = {name: tuple(dict.fromkeys(itertools.chain.from_iterable(getattr(one, name) for one in compositions))) for name in names}
    unseen = any(one.hardware_unseen for one in compositions)
    return replace(compositions[-1], **parts, hardware_unseen=unseen)  # type: ignore[arg-type]


def ros_version(path: Path | str) -> int:
    """The version of ROS that a launch file is for: by its suffix, by its elements and substitutions, else by its package's build tool."""
    path = Path(path)
    if path.suffix in (".py", ".yaml", ".yml", DESCRIBED):
        return 2
    text = text_or_nothing(path)
    new, old = _ROS2.search(text) is not None, _ROS1.search(text) is not None
    if new != old:
        return 2 if new else 1
    return 2 if _AMENT.search(manifest := _manifest_of(path)) or (new and "catkin" not in manifest) else 1


def _version_or_none(path: Path | str) -> int | None:
    """The version of ROS that a launch file is for; None when it is for ROS 1, and its package is for ROS 2 only: nothing starts it."""
    version = ros_version(path)
    manifest = _manifest_of(Path(path)) if version == 1 else ""
    return None if _AMENT.search(manifest) and "catkin" not in manifest else version


def _left_behind(launch_files: Iterable[Path | str]) -> Composition:
    """Nothing is started; where a package has several such files, they are one problem, of the first of them."""
    problems, paths = [], [Path(path) for path in launch_files]
    for path in paths:
        package = _package_of(path)
        together = _left_in(package) if package is not None else []
        first, *others = together if path in together else [path]
        text = text_or_nothing(first)
        found = _ROS1.search(text)
        line = 1 + text.count("\n", 0, found.start()) if found else 1
        names = ", ".join(other.name for other in others[:_NAMED]) + (", ..." if others[_NAMED:] else "")
        many = f", like {len(others)} other{'s' if others[1:] else ''} of the package ({names})" if others else ""
        word = f" (`{found[0].strip(' $(<=')}`)" if found else ""
        message = f"written for ROS 1{word}, in a package for ROS 2{many}: `ros2 launch` rejects it"
        problems.append(Problem("ros1", str(first), message, Place(str(first), line)))
    return Composition((), (), (), (), tuple(dict.fromkeys(problems)), tuple(map(str, paths)), ros=2)


def _partly_left(composition: Composition) -> Composition:
    """Where several lines of a file have words of ROS 1, these are one problem."""
    found: dict[str, list[Problem]] = {}
    for problem in composition.problems:
        if problem.fatal and (problem.kind, problem.subject) in _LEFT:
            found.setdefault(problem.place.path, []).append(problem)
    gone: set[Problem] = set()
    problems: list[Problem] = []
    for path, own in found.items():
        first, *others = dict.fromkeys(problem.place.line for problem in own)
        if others:
            gone.update(own)
            words = ", ".join(f"`{word}`" for word in dict.fromkeys(problem.subject for problem in own if problem.subject != "exec"))
            message = f"{words} of ROS 1 in a launch file for ROS 2, in {len(others) + 1} lines: `ros2 launch` rejects it"
            problems.append(Problem("ros1", path, message, Place(path, first)))
    kept = [problem for problem in composition.problems if problem not in gone]
    return replace(composition, problems=tuple(kept + problems)) if problems else composition


def _left_in(package: Path) -> list[Path]:
    """The launch files of a package for ROS 2 that are written for ROS 1, sorted."""
    found: list[Path] = []
    for here, folders, names in os.walk(package):
        tracing.names(here)
        if here != os.fspath(package) and "package.xml" in names:
            folders.clear()
            continue
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        found += [Path(here, name) for name in sorted(names) if name.endswith((".launch", ".launch.xml"))]
    return [path for path in found if _version_or_none(path) is None]


def _package_of(path: Path) -> Path | None:
    """The folder of the package that a file is in."""
    for folder in path.absolute().parents:
        manifest = folder / "package.xml"
        tracing.probe(manifest)
        if os.path.isfile(manifest):
            return folder
    return None


def _manifest_of(path: Path) -> str:
    """The manifest of the package that a file is in, without comments."""
    package = _package_of(path)
    return (quick_text(str(package / "package.xml")) or "") if package is not None else ""
