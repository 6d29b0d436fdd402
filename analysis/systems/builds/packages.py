"""Packages that cannot be built, and libraries and packages that nobody finds once they are."""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import lru_cache

from rosarch.analysis.systems.builds.defect import Defect
from rosarch.extractor.workspace.built import INSTALLED_FIRST, Built
from rosarch.extractor.workspace.installs import line_with
from rosarch.extractor.workspace.model import IMPORTED


@lru_cache(maxsize=256)
def of_build(package: Built) -> tuple[Defect, ...]:
    """What keeps a package of ROS 2 from being built, and its libraries, or any plug-ins, from being loaded."""
    result = [Defect(one.path, one.line, one.kind, one.about) for one in package.obstacles if one.kind.startswith("description")]
    if package.build_type not in INSTALLED_FIRST:
        return tuple(result)
    build = package.folder / ("setup.py" if package.build_type == "ament_python" else "CMakeLists.txt")
    if not os.path.exists(build):
        manifest = package.folder / "package.xml"
        return (*result, Defect(manifest, line_with(manifest, "<build_type"), "build file", build.name))
    if not package.unsure:
        result += [Defect(one.path, one.line, one.kind, one.about) for one in package.obstacles if one.kind.endswith("source")]
        left_out = {(*one.library_at, one.library) for one in package.promised if not one.installed and package.build_type == "ament_cmake"}
        result += [Defect(path, line, "library left out", library) for path, line, library in sorted(left_out)]
    if build.suffix == ".txt" and not package.unsure and not package.called("ament_package", "ament_auto_package"):
        result.append(Defect(build, 1, "not registered", ""))
    projects = [call for call in package.called("project") if call.path == build and call.is_known and call.words]
    if projects and projects[0].words[0] != package.name:
        result.append(Defect(build, projects[0].line, "project name", projects[0].words[0]))
    return (*result, *_made_twice(package))


def _made_twice(package: Built) -> Iterator[Defect]:
    """Programs and libraries that are called as the target which makes the interfaces."""
    interfaces = {call.words[0] for call in package.called("rosidl_generate_interfaces") if call.is_known and call.words}
    for target in package.targets:
        if target.name in interfaces and target.kind != IMPORTED:
            yield Defect(target.cmake_file, target.line, "target twice", target.name)
