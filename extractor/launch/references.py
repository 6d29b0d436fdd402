"""What the texts of launch files name: files, packages, programs, arguments. All branches count, whatever their conditions.

Only `$(find)` and `$(dirname)` are resolved here; a name with other unknown parts is left out.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from rosarch.base import tracing
from rosarch.extractor.launch.model import ArgumentUsed, FileNamed, HomePath, PackageNamed, Place, ProgramNamed, Reference
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.launch.xml_reader import Element

_FIND = re.compile(r"\$\(find\s+([^()\s$]+)\s*\)")
_FILE = re.compile(r"(?:\$\(find\s+[^()\s$]+\s*\)|\$\(dirname\))/[^\s'\"]*[^\s'\"/]")
_ARGUMENT = re.compile(r"\$\(arg\s+([^()\s$]+)\s*\)|\barg\(\s*['\"]([^'\"]+)['\"]\s*\)")
_HOME = re.compile(  # `~/x` may be a private name
    r"(?<![^\s='\":,;\[(])(?:(?:/home|/Users)/[^/\s$'\"]+/|~/[^\s'\"]*\.)(?:\$\([^()]*\)|[^\s'\",;\])])*"
)
_PATHS = ("file", "textfile", "binfile")
"""Attributes whose whole text is one path."""
_ENVIRONMENT = re.compile(r"\$\((?:opt)?env\s[^()]*\)")  # the default of a variable that each machine sets


def references(launch: Element, path: str, packages: PackagePath) -> Iterator[Reference]:
    """What the launch file at `path` names."""
    for element in launch.walk():
        place = Place(path, element.line, element.column)
        texts = {**element.attributes, **({"text": element.text} if element.tag == "rosparam" else {})}
        for attribute, text in texts.items():
            if "(" not in text and "/" not in text:
                continue  # nothing of the following
            yield from (ArgumentUsed(one or other, place) for one, other in _ARGUMENT.findall(text))
            yield from (PackageNamed(name, packages.find(name), place) for name in _FIND.findall(text))
            yield from (HomePath(element.tag, attribute, found, place) for found in _homes(text) if attribute != "doc")
            yield from _files(element, attribute, text, place, packages)
        if element.tag in ("node", "test"):
            yield from _program(element, place, packages)


def _homes(text: str) -> list[str]:
    return _HOME.findall(_ENVIRONMENT.sub("$()", text))


def _files(element: Element, attribute: str, text: str, place: Place, packages: PackagePath) -> Iterator[FileNamed]:
    role = element.tag if attribute == "file" else attribute if attribute in ("textfile", "binfile", "command") else "value"
    if attribute == "doc" or (element.tag == "rosparam" and element.attributes.get("command", "load") != "load"):
        return
    for found in [text.strip()] if attribute in _PATHS and _FILE.match(text.strip()) else _FILE.findall(text):
        resolved = _FIND.sub(lambda match: packages.find(match[1]) or match[0], found)
        file = os.path.normpath(resolved.replace("$(dirname)", os.path.dirname(os.path.abspath(place.path))))
        if "$(" not in file:
            tracing.probe(file)
            yield FileNamed(role, file, not (os.path.exists(file) or packages.makes(file)), place)


def _program(element: Element, place: Place, packages: PackagePath) -> Iterator[Reference]:
    package, type_ = element.attributes.get("pkg", ""), element.attributes.get("type", "")
    if not package or "$" in package:
        return
    folder = packages.find(package)
    yield PackageNamed(package, folder, place)
    if type_ and "$" not in type_ and folder is not None:
        yield ProgramNamed(package, type_, os.path.basename(type_) in packages.names_in(folder), place)
