"""The files that the launch files of a composition mean, as its arguments have it."""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import Collection, Iterator

from rosarch.base import tracing
from rosarch.extractor.launch.model import Composition, FileMeant, FileNamed, Place
from rosarch.extractor.launch.packages import PackagePath

_NAMED = re.compile(r"(?<![\w./~-])/[^\s'\",;:=\[\]{}()$]+\.\w+(?![\w$(])")
_WRITTEN = frozenset({".yaml", ".yml", ".xml", ".urdf", ".xacro", ".sdf", ".world", ".rviz", ".json", ".srdf", ".launch"})


def meant(composition: Composition) -> Iterator[tuple[str, str, Place]]:
    """Role, path and place of each file in a package that is included, or that a node gets the name of: in its arguments or parameters."""
    for include in composition.includes:
        if os.path.isabs(include.text) and "$(" not in include.text:
            yield "include", os.path.normpath(include.text), include.lines[-1]
    for node in composition.nodes:
        yield from (("value", path, node.lines[-1]) for path in _paths(node.args))
    for setting in composition.params:
        if setting.source is None and isinstance(setting.value, str) and len(setting.value) < 1000:
            yield from (("value", path, setting.place) for path in _paths(setting.value))


def files_meant(composition: Composition, packages: PackagePath) -> Iterator[FileMeant]:
    """The files that are meant, as they lie in the sources."""
    for role, path, place in meant(composition):
        if packages.of_file(path) is not None:
            tracing.probe(path)
            yield file_meant(role, path, place, packages, there=os.path.exists(path))


def file_meant(role: str, path: str, place: Place, packages: PackagePath, *, there: bool) -> FileMeant:
    """A file that is meant, which is among the sources (`there`), is made, or is absent."""
    made = not there and packages.makes(path)
    absent = not there and not made
    return FileMeant(role, path, absent, place, beside(path) if absent else None, made)


def parts_meant(parts: Collection[tuple[str, Place]], packages: PackagePath) -> Iterator[FileMeant]:
    """The files of packages that robot descriptions are made of."""
    for path, place in parts:
        if packages.of_file(path) is not None:
            tracing.probe(path)
            yield file_meant("part", path, place, packages, there=os.path.exists(path))


def meshes_meant(meshes: Collection[tuple[str, Place]], packages: PackagePath) -> Iterator[FileMeant | FileNamed]:
    """The files that robot descriptions name: those to be installed, and those that are not there where one is called nearly so.

    Sources are often without their meshes, which are large.
    """
    named = {path for path, _ in meshes}
    others: dict[str, list[str]] = {}
    for path, place in meshes:
        tracing.probe(path)
        meant = file_meant("mesh", path, place, packages, there=os.path.exists(path))
        if not meant.absent:
            yield meant
            continue
        folder, name = os.path.split(path)
        if folder not in others:
            others[folder] = [other.lower() for other in _listed(folder) if f"{folder}/{other}" not in named]
        if difflib.get_close_matches(name.lower(), others[folder], 1, 0.85):
            yield FileNamed("mesh", path, True, place)


def _listed(folder: str) -> list[str]:
    """The names in a folder, none where there is no such folder."""
    tracing.names(folder)
    try:
        return sorted(os.listdir(folder))
    except OSError:
        return []


def beside(path: str) -> str | None:
    """A file of the same kind in the folder of one that is not there: of those kinds that are written by hand."""
    folder, kind = os.path.dirname(path), os.path.splitext(path)[1]
    if kind not in _WRITTEN:
        return None
    names = [name for name in _listed(folder) if name.endswith(kind)]
    return os.path.join(folder, names[0]) if names else None


def _paths(text: str) -> Iterator[str]:
    """The absolute paths of files in a text, those with a part that is not known left out."""
    if "/" in text:
        yield from (os.path.normpath(path) for path in _NAMED.findall(text))
