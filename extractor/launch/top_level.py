"""The launch files that are started by themselves: those that no other includes."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from rosarch.extractor import observation
from rosarch.extractor.xml_reader import XmlError

from .compose import compose
from .files import Files
from .model import Composition, LaunchError
from .xml_reader import read_launch

_SUFFIXES = (".launch", ".launch.xml")
_UNKNOWN = re.compile(r"\$\([^()]*\)")
_FIND = re.compile(r"\$\(find ([^()$]+)\)")


def launch_files(folder: Path | str) -> list[str]:
    """The launch files below a folder, sorted; hidden folders and those that CATKIN_IGNORE hides are left out."""
    found: list[str] = []
    for here, folders, names in os.walk(folder):
        if "CATKIN_IGNORE" in names:
            folders.clear()
            continue
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        found += [os.path.join(here, name) for name in sorted(names) if name.endswith(_SUFFIXES)]
    return found


def top_level(paths: Iterable[str], files: Files, environment: Mapping[str, str] | None = None) -> dict[str, Composition]:
    """Those of `paths` that none of them includes, composed: not with its default arguments, and not in a branch these leave out either.

    An unknown part of an included name (`$(arg base)/base.launch`) stands for any one name of a folder or file.
    """
    paths = list(paths)
    real = {path: os.path.realpath(path) for path in paths}
    included: dict[str, set[str]] = {}
    matches: dict[str, set[str]] = {}
    compositions: dict[str, Composition] = {}
    for path in paths:
        composition = compositions[path] = compose([path], files=files, environment=environment)
        written = {*(include.file or include.text for include in composition.includes), *_written(path, files)}
        included[real[path]] = {os.path.realpath(name) for name in written if "$(" not in name} - {real[path]}
        for name in written:
            observation.probe(name)
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
    return {path: compositions[path] for path in paths if real[path] in found}


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


def _pattern(name: str) -> re.Pattern[str] | None:
    """What a file name with unknown parts can stand for; None when it begins with one, and so could be any file."""
    if not name.startswith("/"):
        return None
    known, *others = _UNKNOWN.split(os.path.normpath(name))
    return re.compile("[^/]*".join([re.escape(os.path.realpath(known) + known[len(known.rstrip("/")) :]), *map(re.escape, others)]))


def _written(path: str, files: Files) -> Iterator[str]:
    """The files that the text of a launch file includes under any condition, as far as they can be told without arguments."""
    try:
        launch = files.parsed(path, read_launch)
    except (LaunchError, XmlError):
        return
    for element in launch.walk():
        text = element.attributes.get("file")
        if element.tag == "include" and text:
            text = _FIND.sub(lambda match: files.packages.find(match[1].strip()) or match[0], text)
            yield text.replace("$(dirname)", os.path.dirname(os.path.abspath(path)))
