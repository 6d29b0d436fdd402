"""Launch files that are not installed."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import PurePath

from rosarch.analysis.systems.builds.defect import Defect
from rosarch.extractor.launch import launch_files
from rosarch.extractor.launch.model import Composition
from rosarch.extractor.workspace.built import INSTALLED_FIRST, Built, package_of


def of_launch_files(composition: Composition, builds: Sequence[Built]) -> Iterator[tuple[str, Defect]]:
    """Launch files in a folder of a package from which its build, of which all is known, installs nothing.

    Where it installs those of another folder, one that is not below it is a sample for those who have the sources: no defect.
    """
    told = [one for one in builds if one.build_type in INSTALLED_FIRST and not one.unsure]
    for file in sorted({node.lines[0].path for node in composition.nodes if node.lines}):
        package = package_of(file, told)
        if package is not None and os.path.dirname(file) != str(package.folder):
            path = os.path.relpath(file, package.folder)
            folder = os.path.dirname(path)
            beside = (f"{folder}/{name}" for name in os.listdir(os.path.dirname(file)))
            if not any(_installed(package, one) for one in beside) and not _is_sample(package, folder):
                build = "setup.py" if package.build_type == "ament_python" else "CMakeLists.txt"
                yield package.name, Defect(package.folder / build, 1, "launch file left out", path)


def _is_sample(package: Built, folder: str) -> bool:
    others = (os.path.relpath(path, package.folder) for path in launch_files(package.folder))
    installed = {os.path.dirname(path) for path in others if _installed(package, path)}
    return bool(installed) and not any(PurePath(folder).is_relative_to(one) for one in installed)


def _installed(package: Built, path: str) -> bool:
    share = f"share/{package.name}"
    return package.brings(f"{share}/{path}") or package.brings(f"{share}/{os.path.basename(path)}")
