"""Libraries that use ROS and that nothing in the workspace runs: C++ targets and Python modules. Others may call whatever they have."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator
from pathlib import Path

from rosarch.extractor.workspace.model import LIBRARY_KINDS, Package, PythonEntry, Target
from rosarch.extractor.workspace.plugins import Scans
from rosarch.extractor.workspace.python_modules import Modules
from rosarch.extractor.workspace.unused import uses_ros

_NO_MODULES = frozenset({"test", "tests", "launch", "__pycache__"})


def library_targets(package: Package, used: Collection[Path], scans: Scans) -> Iterator[Target]:
    """The libraries of a package that use ROS, of whose sources none is `used`."""
    for target in package.targets:
        if target.kind in LIBRARY_KINDS and target.sources and not any(source in used for source in target.sources):
            folders = (*target.include_dirs, package.path / "include")
            files = (file for source in target.sources for file in (source, *scans.own_headers(source, folders, package.path)))
            if any(map(uses_ros, files)):
                yield target


def library_modules(package: Package, used: Collection[Path], modules: Modules) -> Iterator[PythonEntry]:
    """The modules of a package that use ROS and are not `used`, but for those that others of them import."""
    entries = [
        PythonEntry(path, ".".join(path.relative_to(root).with_suffix("").parts), None, package.python_roots)
        for root in package.python_roots
        for path in _modules_below(root)
        if path not in used and uses_ros(path)
    ]
    imports = {entry.file: {path for _, path in modules.closure(entry.file, entry.module, entry.roots)[0][1:]} for entry in entries}
    for entry in entries:
        if not any(entry.file in found for file, found in imports.items() if file not in imports[entry.file]):
            yield entry


def _modules_below(root: Path) -> Iterator[Path]:
    """The modules of the packages of Python in a folder."""
    for here, folders, names in os.walk(root):
        kept = (name for name in folders if name not in _NO_MODULES and os.path.isfile(os.path.join(here, name, "__init__.py")))
        folders[:] = sorted(kept)
        if here != str(root):
            yield from (Path(here, name) for name in sorted(names) if name.endswith(".py") and name != "__init__.py")
