"""Launch files that are not installed."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence

from rosarch.analysis.systems.builds.defect import Defect
from rosarch.extractor.launch.model import Composition
from rosarch.extractor.workspace.built import INSTALLED_FIRST, Built, package_of


def of_launch_files(composition: Composition, builds: Sequence[Built]) -> Iterator[tuple[str, Defect]]:
    """Launch files in a folder of a package from which its build, of which all is known, installs nothing."""
    told = [one for one in builds if one.build_type in INSTALLED_FIRST and not one.unsure]
    for file in sorted({node.lines[0].path for node in composition.nodes if node.lines}):
        package = package_of(file, told)
        if package is not None and os.path.dirname(file) != str(package.folder):
            path = os.path.relpath(file, package.folder)
            folder = os.path.dirname(path)
            beside = (f"{folder}/{name}" for name in os.listdir(os.path.dirname(file)))
            share = f"share/{package.name}"
            if not any(package.brings(f"{share}/{one}") or package.brings(f"{share}/{os.path.basename(one)}") for one in beside):
                build = "setup.py" if package.build_type == "ament_python" else "CMakeLists.txt"
                yield package.name, Defect(package.folder / build, 1, "launch file left out", path)
