"""Templates of launch files: what a generator has to fill in first is no launch file yet."""

from __future__ import annotations

import os
import re
from pathlib import Path

from rosarch.base import tracing
from rosarch.base.files import read_file
from rosarch.base.xml_reader import XmlError
from rosarch.extractor.launch.xml_reader import read_launch
from rosarch.extractor.package_names import TEMPLATES
from rosarch.extractor.python_syntax import parse_python

_PLACEHOLDER = r"\[[A-Z][A-Z0-9]*_[A-Z0-9_]*\]|\{\{.*?\}\}|\{%.*?%\}|<%.*?%>|@[A-Z][A-Z0-9_]+@|@\(\w+\)|\$\{\w+\}|%\([A-Za-z_]\w*\)s"
_ANY = re.compile(_PLACEHOLDER.encode())
_IN_NAME = re.compile(rf"{_PLACEHOLDER}|\[[A-Z][A-Z0-9]+\]")
_NAMES = ("pkg", "type", "exec", "file")  # of packages, programs and files, where no placeholder can be meant as it stands


def is_template(path: str, workspace: Path | str) -> bool:
    """Whether a launch file lies among a package's templates, or has placeholders that keep it from being one."""
    if not TEMPLATES.isdisjoint(map(str.lower, folders_in_package(os.path.dirname(path), workspace))):
        return True
    folders = os.path.relpath(os.path.dirname(path), workspace).split(os.sep)
    if _IN_NAME.search("/".join(folders)):
        return True
    try:
        text = read_file(path)
    except OSError:
        return False
    return _IN_NAME.search(text.decode(errors="replace")) is not None and _is_unfilled(text, path)


def folders_in_package(folder: str, workspace: Path | str) -> list[str]:
    """The names of the folders that lead from the package, the outermost one, to a folder; from the workspace when there is no package."""
    folders = os.path.relpath(folder, workspace).split(os.sep)
    for depth in range(len(folders) + 1):
        manifest = os.path.join(workspace, *folders[:depth], "package.xml")
        tracing.probe(manifest)
        if os.path.isfile(manifest):
            return folders[depth:]
    return folders


def _is_unfilled(text: bytes, path: str) -> bool:
    """Whether a text with placeholders is no XML or Python as it stands, or has one for a name."""
    if path.endswith(".py"):
        try:
            parse_python(text.decode(errors="replace"))
        except (SyntaxError, ValueError, RecursionError):
            return _ANY.search(text) is not None
        return False
    if path.endswith((".yaml", ".yml")):
        return False
    try:
        launch = read_launch(text, path)
    except XmlError:
        return _ANY.search(text) is not None
    return any(_IN_NAME.search(element.attributes.get(name, "")) for element in launch.walk() for name in _NAMES)
