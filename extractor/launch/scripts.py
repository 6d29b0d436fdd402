"""Scripts that launch files start: which of the names in the launch files are in their texts.

A script is not analysed here. But a name of which a part does not occur in its text, nor in that of the modules of its package, is hardly a
name that it uses.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from typing import Any

from rosarch.base.files import read_file
from rosarch.extractor.launch.model import Composition
from rosarch.extractor.launch.packages import PackagePath

Rows = dict[str, set[tuple[Any, ...]]]
_WORD = re.compile(r"\w+")
_INTERPRETED = re.compile(rb"#!.*\b(python|bash|sh|ruby|perl)")
_PART_OF_SCRIPT = (".py", ".cfg")  # modules, and descriptions of parameters, which are Python as well
MAX_FILES = 500
MAX_BYTES = 1 << 20


def script_rows(composition: Composition, packages: PackagePath) -> Rows:
    """The rows about the scripts among the nodes of a composition."""
    names = {remap.source for remap in composition.remaps} | {setting.name for setting in composition.params}
    rows: Rows = {"word_of_name": {(name, word) for name in names for word in _WORD.findall(name)}}
    wanted = {word for _, word in rows["word_of_name"]}
    for package, type_ in sorted({(node.package, node.type) for node in composition.nodes}):
        folder = packages.find(package)
        words = None if folder is None else _words(packages.paths_in(folder), type_, wanted)
        if words is not None:
            rows.setdefault("script", set()).add((package, type_))
            rows.setdefault("script_word", set()).update((package, type_, word) for word in words)
    return rows


def _words(paths: Mapping[str, Sequence[str]], name: str, wanted: Collection[str]) -> set[str] | None:
    """The words among `wanted` in the script called `name` and in the modules of its package; None when there is no such script."""
    own = paths.get(name, ())
    texts = sorted({*own, *(path for file in paths if file.endswith(_PART_OF_SCRIPT) for path in paths[file])} if own else ())[:MAX_FILES]
    if not any(_is_script(path) for path in texts if path in own):
        return None
    return {word for path in texts for word in _WORD.findall(_read(path).decode(errors="replace")) if word in wanted}


def _is_script(path: str) -> bool:
    return path.endswith(".py") or _INTERPRETED.match(_read(path)) is not None


def _read(path: str) -> bytes:
    try:
        return read_file(path)[:MAX_BYTES]
    except OSError:
        return b""
