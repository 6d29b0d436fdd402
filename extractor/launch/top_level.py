"""The launch files that are started by themselves: those that no other includes."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from rosarch.base import tracing
from rosarch.base.files import read_file
from rosarch.base.limits import LIMITS
from rosarch.base.patterns import Pattern, PatternError, compiled, encoded
from rosarch.base.pool import Failure, default_jobs, run_tasks
from rosarch.base.xml_reader import XmlError
from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.model import Composition, LaunchError, Place, Problem
from rosarch.extractor.launch.templates import folders_in_package, is_template
from rosarch.extractor.launch.versions import compose, ros_version
from rosarch.extractor.launch.xml_reader import read_launch
from rosarch.extractor.package_names import IGNORE_MARKERS

_SUFFIXES = (".launch", ".launch.xml")
_ROS2_FILE = re.compile(r".+[._-]launch\.(py|xml|ya?ml)")
_ANY_NAME = (".py", ".xml")  # `ros2 launch` takes a file of any name with such a suffix
_TEST = re.compile(r"test_.*|.*[._-]test\.py")
_TESTS = frozenset({"test", "tests"})
_DESCRIBES = {".py": b"generate_launch_description", ".xml": b"<launch", ".yaml": b"launch:", ".yml": b"launch:"}
_BEFORE_ROOT = re.compile(rb"<!--.*?-->|<\?.*?\?>", re.DOTALL)
_UNKNOWN = re.compile(r"\$\([^()]*\)")
_FIND = re.compile(r"\$\((?:find|find-pkg-share) ([^()$]+)\)")
_NAME = re.compile(r"[\w.-]+")


def launch_files(folder: Path | str, *, templates: bool = False) -> list[str]:
    """The launch files below a folder, sorted, without hidden folders, those that ignore markers hide and (unless asked for) templates."""
    found: list[str] = []
    for here, folders, names in os.walk(folder):
        if IGNORE_MARKERS.intersection(names):
            folders.clear()
            continue
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        paths = [os.path.join(here, name) for name in sorted(names) if _is_ros1(folder, here, name) or _is_ros2(folder, here, name)]
        found += [path for path in paths if templates or not is_template(path, folder)]
    return found


def _is_ros1(top: Path | str, folder: str, name: str) -> bool:
    """Whether a file is called as those of ROS 1 are, and is no test of a package; Eclipse calls what it starts so, too."""
    if not name.endswith(_SUFFIXES) or not _TESTS.isdisjoint(folders_in_package(folder, top)):
        return False
    try:
        return not _BEFORE_ROOT.sub(b"", read_file(os.path.join(folder, name))).lstrip().startswith(b"<launchConfiguration")
    except OSError:
        return True  # reported where it is composed


def _is_ros2(top: Path | str, folder: str, name: str) -> bool:
    """Whether a file is called as those of ROS 2 are, or lies where they do, holds what they do, and is no test."""
    folders = set(os.path.relpath(folder, top).split(os.sep))
    is_called_so = _ROS2_FILE.fullmatch(name) is not None
    if not (is_called_so or ("launch" in folders and name.endswith(_ANY_NAME))) or _TEST.fullmatch(name) or _TESTS & folders:
        return False
    path = os.path.join(folder, name)
    try:
        return _DESCRIBES[os.path.splitext(name)[1]] in read_file(path) and (is_called_so or ros_version(path) == 2)
    except OSError:
        return False


def top_level(
    paths: Iterable[str], files: Files, environment: Mapping[str, str] | None = None, jobs: int | None = None
) -> dict[str, Composition]:
    """Those of `paths` that none of them includes, composed: not with its default arguments, and not in a branch these leave out either.

    An unknown part of an included name (`$(arg base)/base.launch`) stands for any one name of a folder or file. Python launch files are
    composed in `jobs` processes, one for each processor by default.
    """
    paths = list(paths)
    composed = _composed(paths, files, environment, jobs or default_jobs())
    real = {path: files.real(path) for path in paths}
    called: dict[str, list[str]] = {}
    for path in paths:
        called.setdefault(os.path.basename(path), []).append(path)
    included: dict[str, set[str]] = {}
    matches: dict[str, set[str]] = {}
    for path in paths:
        composition = composed[path]
        said = _said(path, called) if path.endswith((".py", ".yaml", ".yml")) else _written(path, files)
        written = {*(include.file or include.text for include in composition.includes), *said}
        included[real[path]] = {files.real(name) for name in written if "$(" not in name} - {real[path]}
        for name in written:
            tracing.probe(name)
            if "$(" in name and name not in matches:
                pattern = _pattern(name)
                matches[name] = {other for other in real.values() if pattern.fullmatch(other)} if pattern else set()
            included[real[path]] |= matches.get(name, set())
    above = {name for names in included.values() for name in names}
    found = {real[path] for path in paths} - above
    reached = _reached(found, included)
    for path in paths:  # those that include each other: the first stands for all
        if real[path] not in reached:
            found.add(real[path])
            reached |= _reached([real[path]], included)
    return {path: composed[path] for path in paths if real[path] in found}


def _composed(paths: Sequence[str], files: Files, environment: Mapping[str, str] | None, jobs: int) -> dict[str, Composition]:
    """What each of `paths` starts and sets by itself. Those in Python are programs, which may take their time."""
    for path in paths:
        files.allow_beside(path)  # all, so that it does not matter which are composed in one process
    programs = [path for path in paths if path.endswith(".py")]
    found: dict[str, Composition] = {}
    if jobs > 1 and len(programs) > 1:

        def work(path: str) -> Composition:
            return compose([path], files=files, environment=environment)

        for index, outcome in run_tasks(work, programs, jobs=jobs, timeout=LIMITS.evaluation):
            path = programs[index]
            found[path] = _left_out(path, outcome) if isinstance(outcome, Failure) else outcome
    return {path: found.get(path) or compose([path], files=files, environment=environment) for path in paths}


def _left_out(path: str, failure: Failure) -> Composition:
    problem = Problem("size", path, f"left out: {failure.detail}", Place(path, 1))
    return Composition((), (), (), (), (problem,), (path,), ros=2)


def _reached(names: Iterable[str], included: Mapping[str, set[str]]) -> set[str]:
    """The files called `names`, and all that these include, directly or through others."""
    reached: set[str] = set()
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name not in reached:
            reached.add(name)
            waiting += included.get(name, ())
    return reached


def _pattern(name: str) -> Pattern | None:
    """What a file name with unknown parts can stand for; None when it begins with one, and so could be any file."""
    if not name.startswith("/"):
        return None
    known, *others = _UNKNOWN.split(os.path.normpath(name))
    texts = [os.path.realpath(known) + known[len(known.rstrip("/")) :], *others]
    try:
        return compiled(b"[^/]*".join(re.escape(encoded(text)) for text in texts), name)
    except PatternError:  # it is longer than any name
        return None


def _said(path: str, called: Mapping[str, list[str]]) -> Iterator[str]:
    """The launch files whose names the text of one says: those beside it, else those in folders of packages that it names, too."""
    try:
        text = read_file(path).decode(errors="replace")
    except OSError:
        return
    for name in sorted({found.strip(".-") for found in _NAME.findall(text)} & called.keys()):
        others = [other for other in called[name] if other != path]
        beside = [other for other in others if os.path.dirname(other) == os.path.dirname(path)]
        yield from beside or [other for other in others if any(part in text for part in _package_folder(other))]


def _package_folder(path: str) -> list[str]:
    """The name of the folder of the package that a file is in."""
    folder = next((folder for folder in Path(path).parents if os.path.isfile(folder / "package.xml")), None)
    return [] if folder is None else [folder.name]


def _written(path: str, files: Files) -> Iterator[str]:
    """The files that the text of a launch file includes under any condition, as far as they can be determined without arguments."""
    try:
        launch = files.parsed(path, read_launch)
    except (LaunchError, XmlError):
        return
    for element in launch.walk():
        text = element.attributes.get("file")
        if element.tag == "include" and text:
            text = _FIND.sub(lambda match: files.packages.find(match[1].strip()) or match[0], text)
            yield text.replace("$(dirname)", os.path.dirname(os.path.abspath(path)))
