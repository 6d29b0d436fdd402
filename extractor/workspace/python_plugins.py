"""Classes of Python that others make by name: those of plug-in descriptions and entry points, and those that robot descriptions name."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

from rosarch.base.files import LARGEST_PARSED, read_file
from rosarch.extractor.workspace.model import Package, PluginClass

_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_PLUGIN = re.compile(r"<plugin\b[^<>]*?\btype\s*=\s*[\"'](\w+(?:\.\w+)+)[\"']")
_DESCRIPTIONS = (".urdf", ".xacro")


def declared_classes(package: Package) -> Iterator[PluginClass]:
    """The classes that a package's plug-in descriptions name."""
    return (plugin for plugin in package.plugins if plugin.in_python)


def pointed_at(package: Package) -> Iterator[PluginClass]:
    """The classes that a package's entry points name; commands are none of these."""
    for point in package.entry_points:
        if not point.is_command:
            yield PluginClass(point.name, f"{point.module}.{point.function}", point.group, "", point.path, point.line)


def described_classes(package: Package) -> Iterator[PluginClass]:
    """The classes that robot descriptions in a package name for a simulator: `<plugin type="package.module.Class"/>`."""
    for path in _descriptions(package.path):
        try:
            text = read_file(path, LARGEST_PARSED).decode(errors="replace")
        except OSError:
            continue  # reported where a launch file needs it
        text = _COMMENT.sub(lambda match: "\n" * match.group().count("\n"), text)
        for match in _PLUGIN.finditer(text):
            yield PluginClass(match.group(1), match.group(1), "", "", path, text.count("\n", 0, match.start()) + 1)


def _descriptions(folder: Path) -> Iterator[Path]:
    for here, folders, names in os.walk(folder):
        folders[:] = sorted(
            name for name in folders if not name.startswith(".") and not os.path.isfile(os.path.join(here, name, "package.xml"))
        )
        yield from (Path(here, name) for name in sorted(names) if name.endswith(_DESCRIPTIONS))
