"""The files that the launch files of a composition mean, as its arguments have it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from .model import Composition, Place
from .packages import PackagePath

_NAMED = re.compile(r"(?<![\w./~-])/[^\s'\",;:=\[\]{}()$]+\.\w+(?![\w$(])")


def meant(composition: Composition, packages: PackagePath) -> Iterator[tuple[str, str, Place]]:
    """Role, path and place of each file in a package that is included, or that a node gets the name of: in its arguments or parameters."""
    for include in composition.includes:
        if os.path.isabs(include.text) and "$(" not in include.text:
            yield "include", os.path.normpath(include.text), include.lines[-1]
    for node in composition.nodes:
        yield from (("value", path, node.lines[-1]) for path in _paths(node.args))
    for setting in composition.params:
        if setting.source is None and isinstance(setting.value, str) and len(setting.value) < 1000:
            yield from (("value", path, setting.place) for path in _paths(setting.value))


def _paths(text: str) -> Iterator[str]:
    """The absolute paths of files in a text, those with a part that is not known left out."""
    if "/" in text:
        yield from (os.path.normpath(path) for path in _NAMED.findall(text))
